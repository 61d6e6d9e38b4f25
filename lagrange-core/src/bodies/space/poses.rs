//! Poses of frames and how they move, one elementary step after another.
//!
//! Angular velocity ω and the velocity v of the origin are kept in the frame's *own* axes, since there what a joint adds has one component
//! and inertia does not change; the axes and the origin of the frame are kept in the world. From a frame to one that is fixed in it at p,
//! turned by R: ω′ = Rᵀ ω, v′ = Rᵀ (v + ω × p). A turn by θ about its z-axis: x′ = c x + s y, y′ = c y − s x for the components of ω and
//! v and for the axes in the world alike, and θ̇ is added to the z-component of ω. A move by s along z adds s ω × e_z + ṡ e_z to v.
//!
//! Source: Featherstone, *Rigid Body Dynamics Algorithms*, §2.8 and 4.4; Khalil, Dombre, *Modeling, Identification and Control of Robots*, §9.6.
//!
//! # In numbers
//!
//! A frame that turns with ω = (0, 0, 2) carries at p = (3, 0, 0) one that is turned by a quarter about z: v + ω × p = (0, 6, 0), whose
//! components along x′ = y and y′ = −x are (6, 0, 0).

use super::vectors::{Matrix, Triple, combined, cross, inner, plus, scale, transposed, unit, zero_triple};
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, Expression};

/// Where a frame is and how it moves.
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
    /// That of the world.
    pub(super) fn at_rest(terms: &mut TermWriter<'_>) -> Pose {
        Pose {
            spin: zero_triple(terms),
            velocity: zero_triple(terms),
            axes: [0, 1, 2].map(|axis| unit(terms, axis)),
            origin: zero_triple(terms),
        }
    }

    /// Placeholder after a mistake.
    pub(super) fn invalid(terms: &mut TermWriter<'_>) -> Pose {
        let triple = [terms.invalid(); 3];
        Pose { spin: triple, velocity: triple, axes: [triple; 3], origin: triple }
    }

    /// True after a mistake.
    pub(super) fn is_invalid(&self, translation: &Translation<'_>) -> bool {
        matches!(translation.expressions.get(self.origin[0]), Expression::Invalid)
    }

    /// True if the frame does not move.
    pub(super) fn is_at_rest(&self, terms: &TermWriter<'_>) -> bool {
        self.spin.iter().chain(&self.velocity).all(|&component| terms.is_zero(component))
    }

    /// The place in the world of a point that is fixed in the frame.
    pub(super) fn place_of(&self, terms: &mut TermWriter<'_>, point: Triple) -> Triple {
        let arm = combined(terms, point, self.axes);
        plus(terms, self.origin, arm)
    }

    /// The velocity of a point that is fixed in the frame, in the frame's own axes.
    pub(super) fn velocity_of(&self, terms: &mut TermWriter<'_>, point: Triple) -> Triple {
        let turning = cross(terms, self.spin, point);
        plus(terms, self.velocity, turning)
    }

    /// A vector of own components in the world.
    pub(super) fn in_world(&self, terms: &mut TermWriter<'_>, own: Triple) -> Triple {
        combined(terms, own, self.axes)
    }

    /// The same under one expression.
    pub(in crate::bodies) fn world_vector(&self, terms: &mut TermWriter<'_>, own: Triple) -> AstId {
        let world = self.in_world(terms, own);
        terms.vector(&world)
    }

    /// A vector of the world in own components.
    pub(super) fn in_own_axes(&self, terms: &mut TermWriter<'_>, vector: Triple) -> Triple {
        self.axes.map(|axis| inner(terms, axis, vector))
    }
}

/// From one frame to the next.
#[derive(Clone, Copy, Debug)]
pub(super) enum FrameStep {
    /// To an origin that is fixed in the frame.
    Shift(Triple),
    /// To axes that are fixed in the frame, the columns of a matrix.
    Reorientation(Matrix),
    /// By a turn about an axis, which may change.
    Turn(JointAxis, AstId),
    /// By a move along an axis, which may change.
    Slide(JointAxis, AstId),
}

/// The frame behind a step, its vectors under names.
pub(super) fn behind(translation: &mut Translation<'_>, name: &str, pose: Pose, step: FrameStep) -> Pose {
    let mut terms = translation.terms();
    let next = match step {
        FrameStep::Shift(by) => shifted(&mut terms, pose, by),
        FrameStep::Reorientation(by) => in_axes(&mut terms, pose, transposed(by)),
        FrameStep::Turn(about, angle) => turned(&mut terms, pose, about, angle),
        FrameStep::Slide(along, distance) => slid(&mut terms, pose, along, distance),
    };
    named(translation, name, next)
}

fn shifted(terms: &mut TermWriter<'_>, pose: Pose, by: Triple) -> Pose {
    Pose { velocity: pose.velocity_of(terms, by), origin: pose.place_of(terms, by), ..pose }
}

/// The same point in a frame with these axes.
fn in_axes(terms: &mut TermWriter<'_>, pose: Pose, columns: [Triple; 3]) -> Pose {
    Pose {
        spin: columns.map(|axis| inner(terms, axis, pose.spin)),
        velocity: columns.map(|axis| inner(terms, axis, pose.velocity)),
        axes: columns.map(|axis| combined(terms, axis, pose.axes)),
        origin: pose.origin,
    }
}

/// An axis of a joint in its frame.
#[derive(Clone, Copy, Debug)]
pub(super) enum JointAxis {
    /// A coordinate axis, or the direction against it.
    Coordinate { axis: usize, is_negative: bool },
    /// A direction of length one.
    Direction(Triple),
}

impl JointAxis {
    pub(super) fn positive(axis: usize) -> JointAxis {
        JointAxis::Coordinate { axis, is_negative: false }
    }

    /// A length or a rate along the axis as a vector.
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

fn turned(terms: &mut TermWriter<'_>, pose: Pose, about: JointAxis, angle: AstId) -> Pose {
    let direction = terms.direction(angle);
    let turned = match about {
        JointAxis::Coordinate { axis, is_negative } => {
            turned_about_coordinate(terms, pose, axis, is_negative, direction)
        }
        JointAxis::Direction(axis) => {
            let columns = transposed(rotation_about(terms, axis, direction));
            in_axes(terms, pose, columns)
        }
    };
    let rate = terms.rate(angle);
    let rate = about.times(terms, rate);
    Pose { spin: plus(terms, turned.spin, rate), ..turned }
}

fn turned_about_coordinate(
    terms: &mut TermWriter<'_>,
    pose: Pose,
    axis: usize,
    is_negative: bool,
    [cosine, sine]: [AstId; 2],
) -> Pose {
    let direction = [cosine, if is_negative { terms.negative(sine) } else { sine }];
    Pose {
        spin: turned_components(terms, pose.spin, axis, direction),
        velocity: turned_components(terms, pose.velocity, axis, direction),
        axes: turned_axes(terms, pose.axes, axis, direction),
        origin: pose.origin,
    }
}

/// c 1 + s n× + (1 − c) n nᵀ (Rodrigues).
pub(super) fn rotation_about(terms: &mut TermWriter<'_>, axis: Triple, [cosine, sine]: [AstId; 2]) -> Matrix {
    let one = terms.number(1);
    let rest = terms.minus(one, cosine);
    let units = [0, 1, 2].map(|column| unit(terms, column));
    let columns = units.map(|unit| {
        let (kept, crossed) = (scale(terms, cosine, unit), cross(terms, axis, unit));
        let (along, turned) = (inner(terms, axis, unit), scale(terms, sine, crossed));
        let share = terms.times(rest, along);
        let (sum, share) = (plus(terms, kept, turned), scale(terms, share, axis));
        plus(terms, sum, share)
    });
    transposed(columns)
}

fn slid(terms: &mut TermWriter<'_>, pose: Pose, along: JointAxis, distance: AstId) -> Pose {
    let by = along.times(terms, distance);
    let rate = terms.rate(distance);
    let rate = along.times(terms, rate);
    let carried = pose.velocity_of(terms, by);
    Pose { velocity: plus(terms, carried, rate), origin: pose.place_of(terms, by), ..pose }
}

/// Components of a vector in a frame that is turned about an axis.
pub(super) fn turned_components(
    terms: &mut TermWriter<'_>,
    vector: Triple,
    axis: usize,
    [cosine, sine]: [AstId; 2],
) -> Triple {
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut turned = vector;
    let (along, across) = (terms.times(cosine, vector[next]), terms.times(sine, vector[last]));
    turned[next] = terms.plus(along, across);
    let (along, across) = (terms.times(cosine, vector[last]), terms.times(sine, vector[next]));
    turned[last] = terms.minus(along, across);
    turned
}

fn turned_axes(
    terms: &mut TermWriter<'_>,
    axes: [Triple; 3],
    axis: usize,
    direction: [AstId; 2],
) -> [Triple; 3] {
    let rows = transposed(axes).map(|row| turned_components(terms, row, axis, direction));
    transposed(rows)
}

/// The pose with a name for each vector that is computed.
fn named(translation: &mut Translation<'_>, name: &str, pose: Pose) -> Pose {
    let [x, y, z] = pose.axes;
    Pose {
        spin: named_vector(translation, &format!("{name}_w"), pose.spin),
        velocity: named_vector(translation, &format!("{name}_v"), pose.velocity),
        axes: [("x", x), ("y", y), ("z", z)]
            .map(|(axis, vector)| named_vector(translation, &format!("{name}_{axis}"), vector)),
        origin: named_vector(translation, &format!("{name}_origin"), pose.origin),
    }
}

/// A vector under a name, unless all of its components are numbers or have names. Components that are numbers stay so.
pub(super) fn named_vector(translation: &mut Translation<'_>, wish: &str, vector: Triple) -> Triple {
    let is_atom = |id: AstId| {
        matches!(
            translation.expressions.get(id),
            Expression::Number(_) | Expression::Name(_) | Expression::Component(..) | Expression::Invalid
        )
    };
    if vector.iter().all(|&component| is_atom(component)) {
        return vector;
    }
    let value = translation.terms().vector(&vector);
    let name = translation.bind(wish, value);
    if let Expression::Name(name) = translation.expressions.get(name)
        && let Some(space) = &mut translation.space
    {
        space.kinematic.insert(name.clone(), ());
    }
    let mut terms = translation.terms();
    let components = terms.triple(name);
    [0, 1, 2].map(|axis| match terms.is_number(vector[axis]) {
        true => vector[axis],
        false => components[axis],
    })
}
