//! Scenes in space during translation, statement by statement.

use super::frames::{Acceleration, Pose, Relative};
use super::links::Link;
use super::vectors::{Matrix, Triple};
use crate::bodies::plain::LoadOrigin;
use crate::syntax::ast::{AstId, Name};
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::Origin;

/// A scene in space as known so far.
#[derive(Default)]
pub(in crate::bodies) struct Space {
    /// Bodies and frames in the order of their declaration; everything else refers to them by
    /// index.
    pub(in crate::bodies) links: Vec<Link>,
    /// Bodies that nothing places.
    pub(super) unplaced: Vec<Name>,
    /// Indices of placed links, carriers first.
    pub(super) order: Vec<usize>,
    /// Names of bodies that a `free` statement places.
    pub(super) freed: HashSet<String>,
    /// The acceleration of free fall in the world, and its statement.
    pub(super) gravity: Option<(Triple, Origin)>,
    /// Relative accelerations by angular velocity and angular acceleration of their frame.
    pub(super) relatives: HashMap<[Triple; 2], Relative>,
    /// Accelerations of the frames on the path to each link, if already written.
    pub(super) accelerations: HashMap<usize, Vec<(Pose, Acceleration)>>,
    /// Rates of the rotations of links whose points touch, in rows.
    pub(super) rotation_rates: HashMap<usize, Matrix>,
    /// Loads on coordinates, in their order.
    pub(super) loads_on_coordinates: Vec<LoadOnCoordinate>,
    /// Names of `let`s that are points of links, with the link and their own coordinates.
    pub(in crate::bodies) points: HashMap<String, (usize, Triple)>,
}

/// A load on a coordinate, kept until all joints are known.
pub(super) struct LoadOnCoordinate {
    /// Number of loads before it.
    pub(super) position: usize,
    /// Name for the case that its body is unknown.
    pub(super) name: String,
    pub(super) cause: LoadOrigin,
    pub(super) coordinate: AstId,
    pub(super) load: AstId,
}

impl Space {
    /// Returns the name of a body or frame.
    pub(in crate::bodies) fn name_of(&self, link: usize) -> &str {
        &self.links[link].name.text
    }

    /// Returns the link that bears the loads on a link. For a frame that is fixed in another link,
    /// it is that link; `None` for the ground.
    pub(in crate::bodies) fn loaded_link(&self, mut link: usize) -> Option<usize> {
        loop {
            match &self.links[link] {
                Link { inertia: None, path: Some(path), .. } if path.is_fixed() => link = path.carrier?,
                _ => return Some(link),
            }
        }
    }
}
