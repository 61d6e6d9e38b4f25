//! Solids with known moments of inertia: one row each.
//!
//! The coordinates of a solid are those of `lagrange::scene::Outline`.

use crate::expr::{ExprId, Graph};

/// A solid that inertia functions and shapes may name.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    /// Its name: that of the function `name(m, …)` and of the shape `name(…)`.
    pub name: &'static str,
    /// The names of its dimensions.
    pub dimensions: &'static [&'static str],
    /// The moment of inertia about the centre of mass for a mass of one.
    pub inertia: fn(&mut Graph, &[ExprId]) -> ExprId,
    /// The centre of mass in the solid's coordinates; `None` for the origin.
    pub centroid: Option<fn(&mut Graph, &[ExprId]) -> [ExprId; 2]>,
    /// The variant of `lagrange::scene::Outline` that it is drawn as, which takes the same dimensions.
    pub outline: &'static str,
    /// The dimension that is the radius on which it rolls, if it is round.
    pub radius: Option<usize>,
}

/// The solid of a name.
pub fn by_name(_name: &str) -> Option<&'static Solid> {
    None
}
