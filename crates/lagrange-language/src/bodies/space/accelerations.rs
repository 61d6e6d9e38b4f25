//! Accelerations of frames in their own axes, joint by joint.
//!
//! Let A a = α × a + ω × (ω × a) be the relative acceleration of a point that is fixed in a frame
//! at a. With S(θ), the turn of a joint:
//!
//! | step | angular acceleration | acceleration of the origin |
//! |---|---|---|
//! | origin at p | α | a + A p |
//! | axes R | Rᵀ α | Rᵀ a |
//! | turn by θ about e | Sᵀ α + θ̈ e + θ̇ ω × e | Sᵀ a |
//! | move by s along e | α | a + s A e + 2 ṡ ω × e + s̈ e |
//! | axes R that turn with w in themselves | Rᵀ α + ẇ + ω × w | Rᵀ a |
//!
//! The ground accelerates by −g, which has the effect of weight on everything that it carries.
//!
//! Source: Luh, Walker, Paul, "On-line computational scheme for mechanical manipulators", ASME J.
//! Dyn. Syst. Meas. Control 102 (1980); Featherstone, *Rigid Body Dynamics Algorithms*, §5.3.

use super::frames::{Acceleration, FrameStep, JointAxis, Pose, Relative, TurningAxes};
use super::links::{Link, Path};
use super::poses::{link_at, named_vector, rotation_about, turned_components};
use super::vectors::{Matrix, Triple, apply, cross, inner, minus, plus, transposed, zero_triple};
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::AstId;

/// Returns the accelerations of the frames on the path to a link; the last is that of the link.
/// They are written only once.
pub(super) fn accelerations_on_path(
    translation: &mut Translation<'_>,
    link: usize,
) -> Option<Vec<(Pose, Acceleration)>> {
    let space = translation.space.as_ref()?;
    if let Some(known) = space.accelerations.get(&link) {
        return Some(known.clone());
    }
    let gravity = space.gravity.map(|(gravity, _)| gravity);
    let gravity = gravity.unwrap_or_else(|| zero_triple(&mut translation.terms()));
    let found = written_on_path(translation, link, gravity)?;
    translation.space.as_mut()?.accelerations.insert(link, found.clone());
    Some(found)
}

fn written_on_path(
    translation: &mut Translation<'_>,
    link: usize,
    gravity: Triple,
) -> Option<Vec<(Pose, Acceleration)>> {
    let Link { name, placed, path, .. } = link_at(translation, link)?;
    let (pose, _) = placed?;
    let Some(Path { carrier, steps }) = path else {
        return Some(vec![(pose, acceleration_by_hand(translation, &name.text, &pose, gravity))]);
    };
    let (mut before, mut acceleration) = match carrier {
        // Carriers come first in the order of links.
        Some(carrier) => *accelerations_on_path(translation, carrier)?.last()?,
        None => {
            let mut terms = translation.terms();
            (Pose::at_rest(&mut terms), acceleration_of_ground(&mut terms, gravity))
        }
    };
    let last = steps.len().saturating_sub(1);
    let mut found = Vec::with_capacity(steps.len());
    for (index, (step, pose)) in steps.into_iter().enumerate() {
        let wish = if index == last { name.text.clone() } else { format!("{}_joint", name.text) };
        acceleration = acceleration_behind(translation, &wish, (&before, acceleration), (step, &pose));
        before = pose;
        found.push((pose, acceleration));
    }
    if found.is_empty() {
        // A weld at the origin of its carrier.
        found.push((before, acceleration));
    }
    Some(found)
}

/// Returns the acceleration of a frame with a user-defined motion: ω̇, and Rᵀ (r̈ − g).
fn acceleration_by_hand(
    translation: &mut Translation<'_>,
    name: &str,
    pose: &Pose,
    gravity: Triple,
) -> Acceleration {
    let mut terms = translation.terms();
    let spin = pose.spin.map(|component| terms.rate(component));
    let acceleration = pose.origin.map(|component| terms.second_rate(component));
    let felt = minus(&mut terms, acceleration, gravity);
    let origin = pose.in_own_axes(&mut terms, felt);
    named(translation, name, Acceleration { spin, origin })
}

/// Returns the acceleration after a step, from the frame before it and the pose after it.
fn acceleration_behind(
    translation: &mut Translation<'_>,
    name: &str,
    (before, acceleration): (&Pose, Acceleration),
    (step, pose): (FrameStep, &Pose),
) -> Acceleration {
    let mut terms = translation.terms();
    let next = match step {
        FrameStep::Shift(by) => {
            let relative = relative(translation, name, [before.spin, acceleration.spin]);
            let mut terms = translation.terms();
            let carried = apply(&mut terms, relative.matrix, by);
            Acceleration { origin: plus(&mut terms, acceleration.origin, carried), ..acceleration }
        }
        FrameStep::Reorientation(by) => in_axes(&mut terms, acceleration, by),
        FrameStep::Orientation(TurningAxes { matrix, spin }) => {
            let seen = in_axes(&mut terms, acceleration, matrix);
            let carried = named_vector(translation, &format!("{name}_carried_alpha"), seen.spin);
            let mut terms = translation.terms();
            let rate = spin.map(|component| terms.rate(component));
            let convected = cross(&mut terms, pose.spin, spin);
            let own = plus(&mut terms, rate, convected);
            Acceleration { spin: plus(&mut terms, carried, own), ..seen }
        }
        FrameStep::Turn(about, angle) => turned(&mut terms, acceleration, pose.spin, about, angle),
        FrameStep::Slide(along, distance) => slid(translation, name, (before, acceleration), along, distance),
    };
    named(translation, name, next)
}

/// Expresses an acceleration in axes that are the columns of a matrix.
fn in_axes(terms: &mut TermWriter<'_>, acceleration: Acceleration, axes: Matrix) -> Acceleration {
    let columns = transposed(axes);
    Acceleration {
        spin: columns.map(|axis| inner(terms, axis, acceleration.spin)),
        origin: columns.map(|axis| inner(terms, axis, acceleration.origin)),
    }
}

fn turned(
    terms: &mut TermWriter<'_>,
    acceleration: Acceleration,
    spin: Triple,
    about: JointAxis,
    angle: AstId,
) -> Acceleration {
    let [cosine, sine] = terms.direction(angle);
    let seen = |terms: &mut TermWriter<'_>, vector: Triple| match about {
        JointAxis::Coordinate { axis, is_negative } => {
            let sine = if is_negative { terms.negative(sine) } else { sine };
            turned_components(terms, vector, axis, [cosine, sine])
        }
        JointAxis::Direction(axis) => {
            let rotation = rotation_about(terms, axis, [cosine, sine]);
            apply(terms, transposed(rotation), vector)
        }
    };
    let (carried, origin) = (seen(terms, acceleration.spin), seen(terms, acceleration.origin));
    let (rate, second) = (terms.rate(angle), terms.second_rate(angle));
    let (rate, second) = (about.times(terms, rate), about.times(terms, second));
    // After the turn, ω contains θ̇ e, which does not contribute to ω × e.
    let convected = cross(terms, spin, rate);
    let own = plus(terms, second, convected);
    Acceleration { spin: plus(terms, carried, own), origin }
}

fn slid(
    translation: &mut Translation<'_>,
    name: &str,
    (before, acceleration): (&Pose, Acceleration),
    along: JointAxis,
    distance: AstId,
) -> Acceleration {
    let relative = relative(translation, name, [before.spin, acceleration.spin]);
    let mut terms = translation.terms();
    let by = along.times(&mut terms, distance);
    let carried = apply(&mut terms, relative.matrix, by);
    let (rate, second) = (terms.rate(distance), terms.second_rate(distance));
    let second = along.times(&mut terms, second);
    let two = terms.number(2);
    let doubled = terms.times(two, rate);
    let doubled = along.times(&mut terms, doubled);
    let coriolis = cross(&mut terms, before.spin, doubled);
    let own = plus(&mut terms, second, coriolis);
    let sum = plus(&mut terms, acceleration.origin, carried);
    Acceleration { origin: plus(&mut terms, sum, own), ..acceleration }
}

/// Returns relative accelerations in a frame, under names that are created once.
pub(super) fn relative(
    translation: &mut Translation<'_>,
    name: &str,
    [spin, change]: [Triple; 2],
) -> Relative {
    let known = translation.space.as_ref().and_then(|space| space.relatives.get(&[spin, change]).copied());
    if let Some(known) = known {
        return known;
    }
    let mut terms = translation.terms();
    let squares = spin.map(|component| match terms.is_zero(component) {
        true => component,
        false => terms.square(component),
    });
    let mixed = [0, 1, 2].map(|axis| terms.times(spin[(axis + 1) % 3], spin[(axis + 2) % 3]));
    let squares = named_vector(translation, &format!("{name}_w_squares"), squares);
    let mixed = named_vector(translation, &format!("{name}_w_products"), mixed);
    let mut terms = translation.terms();
    let rows = [0, 1, 2].map(|row| {
        let (next, last) = ((row + 1) % 3, (row + 2) % 3);
        let mut entries = [squares[0]; 3];
        let sum = terms.plus(squares[next], squares[last]);
        entries[row] = terms.negative(sum);
        entries[next] = terms.minus(mixed[last], change[last]);
        entries[last] = terms.plus(mixed[next], change[next]);
        entries
    });
    let matrix = [("x", rows[0]), ("y", rows[1]), ("z", rows[2])]
        .map(|(axis, row)| named_vector(translation, &format!("{name}_relative_{axis}"), row));
    let relative = Relative { squares, mixed, matrix };
    if let Some(space) = &mut translation.space {
        space.relatives.insert([spin, change], relative);
    }
    relative
}

/// Returns the acceleration of the ground: free fall upwards.
fn acceleration_of_ground(terms: &mut TermWriter<'_>, gravity: Triple) -> Acceleration {
    Acceleration { spin: zero_triple(terms), origin: gravity.map(|component| terms.negative(component)) }
}

fn named(translation: &mut Translation<'_>, name: &str, acceleration: Acceleration) -> Acceleration {
    Acceleration {
        spin: named_vector(translation, &format!("{name}_alpha"), acceleration.spin),
        origin: named_vector(translation, &format!("{name}_a"), acceleration.origin),
    }
}
