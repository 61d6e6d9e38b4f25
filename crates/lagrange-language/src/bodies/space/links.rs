//! The moving parts of a scene in space: bodies and frames, and their placement by joints.

use super::frames::{FrameStep, Pose};
use super::vectors::{Tensor, Triple};
use crate::bodies::object::Energies;
use crate::bodies::plain::Outline;
use crate::syntax::ast::{AstId, Name};
use lagrange_expr::diagnostics::Origin;

/// A body or frame.
#[derive(Clone, Debug)]
pub(in crate::bodies) struct Link {
    pub(super) name: Name,
    /// Mass and its distribution; `None` for a frame.
    pub(super) inertia: Option<MassProperties>,
    /// Pose and the statement that defines it; unknown until a joint places the link.
    pub(super) placed: Option<(Pose, Origin)>,
    /// Path by which a joint places the link.
    pub(super) path: Option<Path>,
    /// The solid that `shape` states.
    pub(in crate::bodies) shape: Option<Outline>,
    /// Its shape for drawing.
    pub(super) outlines: Vec<Outline>,
    /// Its energies, by their names.
    pub(super) energies: Energies,
}

/// The path from the carrier of a joint to the link that it places.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// The link that carries the joint; `None` for the ground.
    pub(super) carrier: Option<usize>,
    /// Steps in order, each with the frame after it.
    pub(super) steps: Vec<(FrameStep, Pose)>,
}

/// Mass of a rigid body and its distribution in body-fixed axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct MassProperties {
    pub(super) mass: AstId,
    /// The centre of mass.
    pub(super) centroid: Triple,
    /// The tensor of inertia about the centre of mass; `None` for a body that never turns.
    pub(super) tensor: Option<Tensor>,
    /// True if mass and tensor may have rates.
    pub(super) changes: bool,
}

impl Path {
    /// True if the placed link is at rest in its carrier.
    pub(super) fn is_fixed(&self) -> bool {
        self.steps.iter().all(|(step, _)| step.is_fixed())
    }
}

impl Link {
    /// Returns a description for messages, with its article.
    pub(in crate::bodies) fn describe(&self) -> &'static str {
        if self.inertia.is_some() { "a body" } else { "a frame" }
    }
}
