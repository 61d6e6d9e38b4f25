//! Frames in space, as data: their poses and motions, and the steps from one to the next.

use super::vectors::{Matrix, Triple, combined, cross, inner, plus, scale, unit, zero_triple};
use crate::bodies::terms::TermWriter;
use crate::syntax::ast::{AstId, Expression, Expressions};

/// The pose and motion of a frame.
#[derive(Clone, Copy, Debug)]
pub(in crate::bodies) struct Pose {
    /// Angular velocity in the frame's own axes.
    pub(super) spin: Triple,
    /// Velocity of its origin in its own axes.
    pub(super) velocity: Triple,
    /// Its axes in the world.
    pub(super) axes: [Triple; 3],
    /// Its origin in the world.
    pub(super) origin: Triple,
}

impl Pose {
    /// Returns the pose of the world.
    pub(super) fn at_rest(terms: &mut TermWriter<'_>) -> Pose {
        Pose {
            spin: zero_triple(terms),
            velocity: zero_triple(terms),
            axes: [0, 1, 2].map(|axis| unit(terms, axis)),
            origin: zero_triple(terms),
        }
    }

    /// Returns a placeholder after an error.
    pub(super) fn invalid(terms: &mut TermWriter<'_>) -> Pose {
        let triple = [terms.invalid(); 3];
        Pose { spin: triple, velocity: triple, axes: [triple; 3], origin: triple }
    }

    /// True after an error.
    pub(super) fn is_invalid(&self, expressions: &Expressions) -> bool {
        matches!(expressions.get(self.origin[0]), Expression::Invalid)
    }

    /// True if the frame does not move.
    pub(super) fn is_at_rest(&self, terms: &TermWriter<'_>) -> bool {
        self.spin.iter().chain(&self.velocity).all(|&component| terms.is_zero(component))
    }

    /// Returns the world position of a point that is fixed in the frame.
    pub(super) fn place_of(&self, terms: &mut TermWriter<'_>, point: Triple) -> Triple {
        let arm = combined(terms, point, self.axes);
        plus(terms, self.origin, arm)
    }

    /// Returns the velocity of a point that is fixed in the frame, in the frame's own axes.
    pub(super) fn velocity_of(&self, terms: &mut TermWriter<'_>, point: Triple) -> Triple {
        let turning = cross(terms, self.spin, point);
        plus(terms, self.velocity, turning)
    }

    /// Returns the world components of a vector given in the frame.
    pub(super) fn in_world(&self, terms: &mut TermWriter<'_>, own: Triple) -> Triple {
        combined(terms, own, self.axes)
    }

    /// Returns the world components of a vector under a single name.
    pub(in crate::bodies) fn world_vector(&self, terms: &mut TermWriter<'_>, own: Triple) -> AstId {
        let world = self.in_world(terms, own);
        terms.vector(&world)
    }

    /// Returns the direction in the world of an axis in the frame.
    pub(super) fn axis_in_world(&self, terms: &mut TermWriter<'_>, axis: JointAxis) -> Triple {
        let one = terms.number(1);
        let own = axis.times(terms, one);
        self.in_world(terms, own)
    }

    /// Returns the components of a world vector in the frame.
    pub(super) fn in_own_axes(&self, terms: &mut TermWriter<'_>, vector: Triple) -> Triple {
        self.axes.map(|axis| inner(terms, axis, vector))
    }
}

/// The change of a frame's motion, in its own axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Acceleration {
    /// Angular acceleration.
    pub(super) spin: Triple,
    /// Acceleration of the origin, less that of free fall.
    pub(super) origin: Triple,
}

/// Step from one frame to the next.
#[derive(Clone, Copy, Debug)]
pub(super) enum FrameStep {
    /// A shift to an origin that is fixed in the frame.
    Shift(Triple),
    /// A change to axes that are fixed in the frame, the columns of a matrix.
    Reorientation(Matrix),
    /// A turn about an axis that may change.
    Turn(JointAxis, AstId),
    /// A move along an axis that may change.
    Slide(JointAxis, AstId),
    /// A change to axes that turn in any direction.
    Orientation(TurningAxes),
}

impl FrameStep {
    /// True if the frame after the step is at rest in the frame before it.
    pub(super) fn is_fixed(&self) -> bool {
        matches!(self, FrameStep::Shift(_) | FrameStep::Reorientation(_))
    }
}

/// Axes that turn in any direction in the previous frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct TurningAxes {
    /// The matrix with the axes as columns.
    pub(super) matrix: Matrix,
    /// The angular velocity relative to the previous frame, in these axes.
    pub(super) spin: Triple,
}

/// An axis of a joint in its frame.
#[derive(Clone, Copy, Debug)]
pub(super) enum JointAxis {
    /// A coordinate axis, or the opposite direction.
    Coordinate { axis: usize, is_negative: bool },
    /// A direction of length one.
    Direction(Triple),
}

impl JointAxis {
    pub(super) fn positive(axis: usize) -> JointAxis {
        JointAxis::Coordinate { axis, is_negative: false }
    }

    /// Returns a length or a rate along the axis as a vector.
    pub(super) fn times(self, terms: &mut TermWriter<'_>, value: AstId) -> Triple {
        match self {
            JointAxis::Coordinate { axis, is_negative } => {
                let direction = unit(terms, axis);
                let value = if is_negative { terms.negative(value) } else { value };
                scale(terms, value, direction)
            }
            JointAxis::Direction(direction) => scale(terms, value, direction),
        }
    }
}

/// The terms of relative accelerations within a frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Relative {
    /// ω_x², ω_y², ω_z²
    pub(super) squares: Triple,
    /// ω_y ω_z, ω_z ω_x, ω_x ω_y
    pub(super) mixed: Triple,
    /// A in rows: −(ω_y² + ω_z²), … on its diagonal, ω_x ω_y ∓ α_z, … off it.
    pub(super) matrix: Matrix,
}
