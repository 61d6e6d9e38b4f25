//! Poses and motions of frames, one elementary step after another.
//!
//! Angular velocity ω and the velocity v of the origin are kept in the frame's *own* axes. There
//! the contribution of a joint has one component, and inertia does not change. The axes and the
//! origin of the frame are kept in the world. From a frame to one that is fixed in it at p, turned
//! by R: ω′ = Rᵀ ω, v′ = Rᵀ (v + ω × p). A turn by θ about its z-axis: x′ = c x + s y, y′ = c y − s
//! x. This holds for the components of ω and v and for the axes in the world alike. Then θ̇ is
//! added to the z-component of ω. A move by s along z adds s ω × e_z + ṡ e_z to v.
//!
//! Source: Featherstone, *Rigid Body Dynamics Algorithms*, §2.8 and 4.4; Khalil, Dombre, *Modeling,
//! Identification and Control of Robots*, §9.6.
//!
//! # In numbers
//!
//! A frame that turns with ω = (0, 0, 2) carries at p = (3, 0, 0) one that is turned by a quarter
//! about z. Its velocity is v + ω × p = (0, 6, 0), whose components along x′ = y and y′ = −x are
//! (6, 0, 0).

use super::frames::{FrameStep, JointAxis, Pose, TurningAxes};
use super::links::Link;
use super::vectors::{Matrix, Triple, combined, cross, inner, plus, scale, transposed, unit};
use crate::bodies::messages::mobilizers as joints;
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, Expression};
use lagrange_expr::diagnostics::Origin;

/// Returns the frame after a step, with names for its vectors.
pub(super) fn behind(translation: &mut Translation<'_>, name: &str, pose: Pose, step: FrameStep) -> Pose {
    let mut terms = translation.terms();
    let next = match step {
        FrameStep::Shift(by) => shifted(&mut terms, pose, by),
        FrameStep::Reorientation(by) => in_axes(&mut terms, pose, transposed(by)),
        FrameStep::Turn(about, angle) => turned(&mut terms, pose, about, angle),
        FrameStep::Slide(along, distance) => slid(&mut terms, pose, along, distance),
        FrameStep::Orientation(TurningAxes { matrix, spin }) => {
            let turned = in_axes(&mut terms, pose, transposed(matrix));
            // Kept apart, so that inertia moved only by the joint can be eliminated before anything
            // is turned.
            let carried = named_vector(translation, &format!("{name}_carried_w"), turned.spin);
            Pose { spin: plus(&mut translation.terms(), carried, spin), ..turned }
        }
    };
    named(translation, name, next)
}

fn shifted(terms: &mut TermWriter<'_>, pose: Pose, by: Triple) -> Pose {
    Pose { velocity: pose.velocity_of(terms, by), origin: pose.place_of(terms, by), ..pose }
}

/// Returns the point in a frame with these axes.
fn in_axes(terms: &mut TermWriter<'_>, pose: Pose, columns: [Triple; 3]) -> Pose {
    Pose {
        spin: columns.map(|axis| inner(terms, axis, pose.spin)),
        velocity: columns.map(|axis| inner(terms, axis, pose.velocity)),
        axes: columns.map(|axis| combined(terms, axis, pose.axes)),
        origin: pose.origin,
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

/// Returns c 1 + s n× + (1 − c) n nᵀ (Rodrigues).
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

/// Returns the components of a vector in a frame that is turned about an axis.
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

/// Returns the pose with a name for each computed vector.
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

/// Returns a vector under a name, unless all of its components are numbers or names. Numeric
/// components remain numbers.
pub(in crate::bodies) fn named_vector(
    translation: &mut Translation<'_>,
    wish: &str,
    vector: Triple,
) -> Triple {
    if vector.iter().all(|&component| is_atom(translation, component)) {
        return vector;
    }
    let value = translation.terms().vector(&vector);
    let name = under_name(translation, wish, value);
    let mut terms = translation.terms();
    let components = terms.triple(name);
    [0, 1, 2].map(|axis| match terms.is_number(vector[axis]) {
        true => vector[axis],
        false => components[axis],
    })
}

/// Returns an expression under a name, unless it needs none. The name is removed later if nothing
/// uses it.
pub(super) fn under_name(translation: &mut Translation<'_>, wish: &str, value: AstId) -> AstId {
    if is_atom(translation, value) {
        return value;
    }
    translation.bind_optionally(wish, value)
}

/// True for an expression that needs no name.
pub(super) fn is_atom(translation: &Translation<'_>, id: AstId) -> bool {
    matches!(
        translation.expressions.get(id),
        Expression::Number(_)
            | Expression::Quantity(..)
            | Expression::Name(_)
            | Expression::Component(..)
            | Expression::Invalid
    )
}

/// Returns the pose of a placed link; a link without a place is reported.
pub(super) fn has_place(translation: &mut Translation<'_>, link: usize, origin: Origin) -> Option<Pose> {
    let Link { name, placed, .. } = &translation.space.as_ref()?.links[link];
    let (name, placed) = (name.text.clone(), *placed);
    if placed.is_none() {
        let error = translation.report.error(origin, joints::unplaced_yet(&name));
        error.help(joints::PLACE_FIRST_HELP);
        // One report is enough.
        let pose = Pose::invalid(&mut translation.terms());
        translation.space.iter_mut().for_each(|space| space.links[link].placed = Some((pose, origin)));
    }
    placed.map(|(pose, _)| pose)
}

/// Returns the link with this index, as known so far.
pub(super) fn link_at(translation: &Translation<'_>, link: usize) -> Option<Link> {
    translation.space.as_ref().map(|space| space.links[link].clone())
}
