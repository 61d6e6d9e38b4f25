//! Surfaces that bodies touch, and the friction there.

use core::fmt::{Debug, Formatter, Result};
use core::ptr::addr_eq;

use super::space::{Plane, Space};
use crate::scalar::Scalar;

/// A surface that bodies touch: ground, a wall, a bowl, terrain.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Surface<'a, S: Scalar, D: Space = Plane> {
    /// Its name.
    pub name: &'a str,
    /// The body or frame that carries it; `None` without one.
    pub body: Option<&'a str>,
    /// Its shape, in its own axes.
    pub shape: SurfaceShape<'a, S>,
    /// A point of it, its centre, or the origin of the coordinates of terrain.
    pub at: D::Vector<S>,
    /// The rotation from its own axes to those of the world.
    pub rotation: D::Rotation<S>,
    /// True if bodies touch it from inside.
    pub is_inside: bool,
}

/// The shape of a surface.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SurfaceShape<'a, S> {
    /// A line along x, whose free side is y, or a plane normal to z, whose free side is z. Neither
    /// has an end.
    Flat,
    /// A circle or sphere of this radius.
    Round(S),
    /// A cylinder of this radius about z, without ends.
    Cylinder(S),
    /// Terrain of this height along y, or in space along z.
    Terrain(Height<'a, S>),
}

/// The height of terrain over a place: over x, or in space over x and y.
#[derive(Clone, Copy)]
pub struct Height<'a, S>(pub &'a dyn Fn([S; 2]) -> S);

impl<S> Height<'_, S> {
    /// Returns the height over a place; in the plane, only its first coordinate matters.
    pub fn over(&self, place: [S; 2]) -> S {
        (self.0)(place)
    }
}

/// Two heights are equal if they are one function.
impl<S> PartialEq for Height<'_, S> {
    fn eq(&self, other: &Self) -> bool {
        addr_eq(self.0, other.0)
    }
}

impl<S> Debug for Height<'_, S> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        formatter.write_str("Height(..)")
    }
}
