//! Bodies and frames in space: declared first, then placed by a joint or by hand; their energies
//! are written when they are placed.

use super::compound::{compound_properties, visual_outlines};
use super::frames::{FrameStep, JointAxis, Pose};
use super::inertia::{mass_properties, triple_of};
use super::links::{Link, MassProperties, Path};
use super::messages as words;
use super::poses::{behind, named_vector};
use super::vectors::{apply, half_square, inner, matrix_of, minus, plus, scale};
use crate::bodies::changing_mass::{push_influx, push_load};
use crate::bodies::drawing::{Load, draw_force};
use crate::bodies::expressions::plain_expression;
use crate::bodies::messages::{self, mobilizers as joints};
use crate::bodies::object::{Energies, Object};
use crate::bodies::plain::{LoadOrigin, Obligation, Outline};
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId, Expression, Name, StatementKind};

/// Translates `frame name;`.
pub(in crate::bodies) fn translate_frame(translation: &mut Translation<'_>, name: &Name) {
    declare(translation, name, None, (None, Vec::new()));
}

pub(in crate::bodies) fn translate_spatial_body(translation: &mut Translation<'_>, statement: &ast::Body) {
    let name = &statement.name;
    let is_wrong = statement.angle.is_some();
    if let Some(angle) = statement.angle {
        let origin = translation.expressions.origin(angle);
        translation.report.error(origin, words::one_angle(&name.text)).help(words::ANGLES_HELP);
    }
    let matter = match statement.parts.is_empty() {
        true => Some(mass_properties(translation, statement)),
        false => compound_properties(translation, statement),
    };
    let (inertia, outlines) = matter.unwrap_or_else(|| {
        let invalid = translation.terms().invalid();
        (
            MassProperties {
                mass: invalid,
                centroid: [invalid; 3],
                tensor: Some([invalid; 6]),
                changes: false,
            },
            Vec::new(),
        )
    });
    let shape = outlines.first().filter(|_| statement.shape.is_some()).cloned();
    let outlines = match statement.visuals.is_empty() {
        true => outlines,
        false => visual_outlines(translation, &statement.visuals),
    };
    let link = declare(translation, name, Some(inertia), (shape, outlines));
    if !is_wrong && is_placed_by_hand(translation, statement) {
        let (pose, center) = pose_by_hand(translation, statement, inertia);
        settle(translation, link, (pose, None), center);
    } else if is_wrong || !translation.names.is_placed_by_joint(&name.text) {
        let pose = Pose::invalid(&mut translation.terms());
        settle(translation, link, (pose, None), None);
        translation.space.iter_mut().for_each(|space| space.unplaced.push(name.clone()));
    }
}

/// True if the user specifies the place of a body; an unreadable place does not count if a joint
/// places the body.
fn is_placed_by_hand(translation: &Translation<'_>, statement: &ast::Body) -> bool {
    let is_read = |place: AstId| !matches!(translation.expressions.get(place), Expression::Invalid);
    let is_jointed = translation.names.is_placed_by_joint(&statement.name.text);
    let places = [statement.center, statement.origin, statement.angles];
    places.into_iter().flatten().any(|place| !is_jointed || is_read(place))
}

fn declare(
    translation: &mut Translation<'_>,
    name: &Name,
    inertia: Option<MassProperties>,
    (shape, outlines): (Option<Outline>, Vec<Outline>),
) -> usize {
    let is_frame = inertia.is_none();
    let Some(space) = &mut translation.space else { return 0 };
    let index = space.links.len();
    space.links.push(Link {
        name: name.clone(),
        inertia,
        placed: None,
        path: None,
        shape,
        outlines,
        energies: Energies::default(),
    });
    translation.names.declare(&name.text, Object::Link { index, is_frame });
    index
}

/// Returns the stated pose of a body, and the velocity of its centre of mass if that is the rate of
/// the stated position.
fn pose_by_hand(
    translation: &mut Translation<'_>,
    statement: &ast::Body,
    inertia: MassProperties,
) -> (Pose, Option<AstId>) {
    let name = &statement.name.text;
    let oriented = oriented(translation, statement);
    let (place, is_center) = match (statement.center, statement.origin) {
        (Some(center), None) => (triple_of(translation, center, &messages::center_of(name)), true),
        (None, Some(origin)) => (triple_of(translation, origin, &messages::origin_of(name)), false),
        (given, _) => {
            let message = messages::one_place(name, given.is_some());
            translation.report.error(statement.name.span, message).help(words::CENTER_HELP);
            ([translation.terms().invalid(); 3], true)
        }
    };
    let mut terms = translation.terms();
    let arm = oriented.in_world(&mut terms, inertia.centroid);
    let (center, origin) = match is_center {
        true => (place, minus(&mut terms, place, arm)),
        false => (plus(&mut terms, place, arm), place),
    };
    let center = named_vector(translation, &format!("{name}_center"), center);
    let origin = named_vector(translation, &format!("{name}_origin"), origin);
    let mut terms = translation.terms();
    let rate = origin.map(|component| terms.rate(component));
    let velocity = oriented.in_own_axes(&mut terms, rate);
    let center = terms.vector(&center);
    let center_velocity = terms.call("dot", &[center]);
    translation.note_place(center, &messages::place_of(name));
    (Pose { velocity, origin, ..oriented }, Some(center_velocity))
}

/// Returns the axes according to `angles` and `sequence`, at the origin.
fn oriented(translation: &mut Translation<'_>, statement: &ast::Body) -> Pose {
    let name = &statement.name;
    let mut pose = Pose::at_rest(&mut translation.terms());
    let (angles, sequence) = match (statement.angles, &statement.sequence) {
        (Some(angles), Some(sequence)) => (angles, sequence),
        (None, None) => return pose,
        (Some(angles), None) => {
            let origin = translation.expressions.origin(angles);
            let error = translation.report.error(origin, words::angles_without_sequence(&name.text));
            error.help(words::ANGLES_HELP);
            return pose;
        }
        (None, Some(sequence)) => {
            let error = translation.report.error(sequence.span, words::sequence_without_angles(&name.text));
            error.help(words::ANGLES_HELP);
            return pose;
        }
    };
    let angles = triple_of(translation, angles, &words::angles_of(&name.text));
    for (step, (letter, angle)) in sequence.text.bytes().zip(angles).enumerate() {
        let axis = JointAxis::positive(usize::from(letter.saturating_sub(b'x')).min(2));
        let wish = if step == 2 { name.text.clone() } else { format!("{}_turn", name.text) };
        pose = behind(translation, &wish, pose, FrameStep::Turn(axis, angle));
    }
    pose
}

/// Sets the place of a link, and writes its energies.
pub(super) fn settle(
    translation: &mut Translation<'_>,
    link: usize,
    (pose, path): (Pose, Option<Path>),
    center_velocity: Option<AstId>,
) {
    let origin = translation.origin;
    let Some(space) = &mut translation.space else { return };
    space.links[link].placed = Some((pose, origin));
    space.links[link].path = path;
    space.order.push(link);
    let Link { name, inertia, .. } = space.links[link].clone();
    let Some(inertia) = inertia else { return };
    let of_translation = push_translation(translation, &name, inertia, &pose, center_velocity);
    let of_rotation = push_rotation(translation, &name, inertia, &pose);
    if let Some(space) = &mut translation.space {
        space.links[link].energies = Energies { of_translation, of_rotation, potential: None };
    }
    weigh(translation, link);
}

/// Adds ½ m v_S², under a name.
fn push_translation(
    translation: &mut Translation<'_>,
    name: &Name,
    inertia: MassProperties,
    pose: &Pose,
    center_velocity: Option<AstId>,
) -> Option<AstId> {
    let velocity = center_velocity.or_else(|| {
        let velocity = pose.velocity_of(&mut translation.terms(), inertia.centroid);
        let velocity = named_vector(translation, &format!("{}_center_v", name.text), velocity);
        let mut terms = translation.terms();
        let moves = !velocity.iter().all(|&component| terms.is_zero(component));
        moves.then(|| terms.vector(&velocity))
    });
    let velocity = velocity?;
    let energy = translation.terms().call("kinetic_energy", &[inertia.mass, velocity]);
    let energy = translation.bind(&format!("{}_T_translation", name.text), energy);
    translation.push(StatementKind::Kinetic(energy));
    if inertia.changes {
        push_influx(translation, &format!("{}_influx", name.text), inertia.mass, velocity);
    }
    Some(energy)
}

/// Adds ½ ω·J ω, under a name.
fn push_rotation(
    translation: &mut Translation<'_>,
    name: &Name,
    inertia: MassProperties,
    pose: &Pose,
) -> Option<AstId> {
    let mut terms = translation.terms();
    if pose.spin.iter().all(|&component| terms.is_zero(component)) {
        return None;
    }
    let Some(tensor) = inertia.tensor else {
        let error = translation.report.error(name.span, words::no_tensor(&name.text));
        error.help(words::TENSOR_NEEDED_HELP);
        return None;
    };
    let energy = half_square(&mut terms, tensor, pose.spin);
    if terms.is_zero(energy) {
        return None;
    }
    let energy = translation.bind(&format!("{}_T_rotation", name.text), energy);
    translation.push(StatementKind::Kinetic(energy));
    if inertia.changes && tensor.iter().any(|&entry| translation.may_change(entry)) {
        let mut terms = translation.terms();
        let rates = tensor.map(|entry| terms.rate(entry));
        let momentum = apply(&mut terms, matrix_of(rates), pose.spin);
        let (momentum, spin) = (terms.vector(&momentum), terms.vector(&pose.spin));
        push_load(translation, &format!("{}_spin_influx", name.text), momentum, spin);
    }
    Some(energy)
}

/// Translates `gravity = (gx, gy, gz);`.
pub(in crate::bodies) fn translate_spatial_gravity(translation: &mut Translation<'_>, value: AstId) {
    let gravity = triple_of(translation, value, words::GRAVITY);
    let (origin, plain) = (translation.origin, plain_expression(translation, value));
    let Some(space) = &mut translation.space else { return };
    if let Some((_, first)) = space.gravity {
        let error = translation.report.error(origin, messages::GRAVITY_TWICE);
        error.related(first, messages::FIRST_DECLARED).help(messages::GRAVITY_TWICE_HELP);
        return;
    }
    space.gravity = Some((gravity, origin));
    let count = space.links.len();
    translation.obligations.push(Obligation::Uniform { gravity: plain });
    for link in 0..count {
        weigh(translation, link);
    }
}

/// Adds the potential −m g·r_S of a placed body, if there is gravity.
fn weigh(translation: &mut Translation<'_>, link: usize) {
    let Some(space) = &translation.space else { return };
    let Some((gravity, _)) = space.gravity else { return };
    let Link { name, inertia: Some(inertia), placed: Some((pose, _)), .. } = space.links[link].clone() else {
        return;
    };
    let mut terms = translation.terms();
    let center = pose.place_of(&mut terms, inertia.centroid);
    let force = scale(&mut terms, inertia.mass, gravity);
    let (at, force) = (terms.vector(&center), terms.vector(&force));
    let work = inner(&mut terms, gravity, center);
    let weighed = terms.times(inertia.mass, work);
    let potential = terms.negative(weighed);
    let does_no_work = terms.is_zero(potential);
    let load = Load { name: "gravity", cause: LoadOrigin::Gravity, body: Some(name.text.clone()) };
    draw_force(translation, load, [at, force], &[]);
    if does_no_work {
        return;
    }
    let potential = translation.bind(&format!("{}_V", name.text), potential);
    translation.push(StatementKind::Potential(potential));
    if let Some(space) = &mut translation.space {
        space.links[link].energies.potential = Some(potential);
    }
}

/// Reports gravity without bodies and links that no joint has placed.
pub(in crate::bodies) fn report_unplaced(translation: &mut Translation<'_>) {
    let Some(space) = &translation.space else { return };
    let has_bodies = space.links.iter().any(|link| link.inertia.is_some());
    let idle = space.gravity.filter(|_| !has_bodies).map(|(_, origin)| origin);
    let bodies = space.unplaced.iter().map(|name| ("body", name.clone()));
    let waiting = space.links.iter().filter(|link| link.placed.is_none());
    let waiting = waiting.map(|link| (link.describe().trim_start_matches("a "), link.name.clone()));
    let unplaced = bodies.chain(waiting).collect::<Vec<_>>();
    if let Some(origin) = idle.filter(|_| !translation.report.has_errors()) {
        translation.report.error(origin, messages::IDLE_GRAVITY).help(messages::IDLE_GRAVITY_HELP);
    }
    // After an error, the joint itself may have been unreadable.
    let are_certain = !translation.report.has_errors();
    for (what, name) in unplaced.into_iter().filter(|_| are_certain) {
        let message = joints::unplaced(what, &name.text);
        translation.report.error(name.span, message).help(words::JOINT_PLACES_HELP);
    }
}
