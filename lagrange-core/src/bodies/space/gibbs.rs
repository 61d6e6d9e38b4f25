//! The Gibbs function of bodies that joints carry: their equations of motion in accelerations, as recursive Newton–Euler has them.
//!
//! A body with the mass m, the first moment h and the tensor J about its origin adds
//! S = ½ m a² + a·A h + ½ α·J α + α·(ω × J ω), with the accelerations of [`super::accelerations`] in its own axes: ∂S/∂a = m a + A h is
//! the force on it and ∂S/∂α = J α + h × a + ω × J ω the moment about its origin. Since the ground accelerates by −g, weights are in
//! it. With [`super::base_parameters`] most entries of h and J are zero.
//!
//! Source: Gibbs, "On the fundamental formulae of dynamics", Am. J. Math. 2 (1879); Lurie, *Analytical Mechanics*, §7.9.

use super::accelerations::{
    Acceleration, acceleration_behind, acceleration_by_hand, acceleration_of_ground, relative,
};
use super::base_parameters::{InertialParameters, NumericStep};
use super::frames::{FrameStep, JointAxis, Pose, Relative};
use super::links::{Link, MassProperties, Path};
use super::numbers::{matrix_of_numbers, triple_of_numbers, value_of_numbers, written_number};
use super::poses::named_vector;
use super::vectors::{
    TENSOR_PLACES, Tensor, Triple, apply, inner, plus, scale, tensor_of_point, tensor_sum, zero_triple,
};
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{Accuracy, AstId, Statement, StatementKind};

/// Inertial parameters as syntax.
#[derive(Clone, Copy)]
struct WrittenParameters {
    mass: AstId,
    moment: Triple,
    tensor: Tensor,
}

/// Number of freedoms up to which energies are more accurate at the level `strict`: what cancels in their mass matrix is then found.
const FEW: usize = 3;

/// Writes the Gibbs function of all bodies that have their places by joints. A Lagrangian of the user's says it all by itself.
pub(in crate::bodies) fn push_gibbs_function(translation: &mut Translation<'_>) {
    if translation.lagrangian.is_some() || translation.report.has_errors() {
        return;
    }
    let Some(space) = &translation.space else { return };
    if translation.accuracy == Accuracy::Strict && freedoms(translation) <= FEW {
        return;
    }
    let order = space.order.clone();
    if !order.iter().any(|&link| space.links[link].path.is_some() && space.links[link].inertia.is_some()) {
        return;
    }
    let gravity = space.gravity.map(|(gravity, _)| gravity);
    let gravity = gravity.unwrap_or_else(|| zero_triple(&mut translation.terms()));
    // Of numbers that are too large energies may still tell.
    let Some(parameters) = parameters(translation, &order) else { return };
    let mut accelerations = vec![None; parameters.len()];
    let (mut functions, mut stated) = (Vec::new(), Vec::new());
    for link in order {
        let Some(found) = accelerations_of(translation, link, &accelerations, gravity) else { return };
        accelerations[link] = found.last().map(|(_, acceleration)| *acceleration);
        let is_at_rest = link_at(translation, link)
            .and_then(|link| link.placed)
            .is_some_and(|(pose, _)| pose.is_at_rest(&translation.terms()));
        if is_at_rest {
            // Welded to the ground: it has no equations.
            continue;
        }
        for (frame, parameters) in found.into_iter().zip(&parameters[link]) {
            functions
                .extend(parameters.map(|parameters| gibbs_of_frame(translation, link, frame, parameters)));
        }
        stated.push(lagrangian_of_link(translation, link));
    }
    if functions.is_empty() {
        return;
    }
    let mut terms = translation.terms();
    let (function, stated) = (sum_of(&mut terms, &functions), sum_of(&mut terms, &stated));
    translation.push(StatementKind::Gibbs { function, stated });
}

/// Number of velocities that are declared.
fn freedoms(translation: &Translation<'_>) -> usize {
    let of_statement = |statement: &Statement| match &statement.kind {
        StatementKind::Coordinates(names) => names.len(),
        StatementKind::Quaternion(quaternion) => quaternion.velocities.len(),
        _ => 0,
    };
    translation.statements.iter().map(of_statement).sum()
}

fn sum_of(terms: &mut TermWriter<'_>, values: &[AstId]) -> AstId {
    let zero = terms.number(0);
    values.iter().fold(zero, |sum, &value| terms.plus(sum, value))
}

fn link_at(translation: &Translation<'_>, link: usize) -> Option<Link> {
    translation.space.as_ref().map(|space| space.links[link].clone())
}

/// T − V of a body that a joint carries, by the names of its energies.
fn lagrangian_of_link(translation: &mut Translation<'_>, link: usize) -> AstId {
    let link = link_at(translation, link).filter(|link| link.path.is_some());
    let energies = link.map(|link| link.energies).unwrap_or_default();
    let mut terms = translation.terms();
    let kinetic = [energies.of_translation, energies.of_rotation].into_iter().flatten().collect::<Vec<_>>();
    let kinetic = sum_of(&mut terms, &kinetic);
    match energies.potential {
        Some(potential) => terms.minus(kinetic, potential),
        None => kinetic,
    }
}

/// Accelerations of the frames on the way to a link, whose carrier's is known, itself being the last.
fn accelerations_of(
    translation: &mut Translation<'_>,
    link: usize,
    known: &[Option<Acceleration>],
    gravity: Triple,
) -> Option<Vec<(Pose, Acceleration)>> {
    let Link { name, placed, path, .. } = link_at(translation, link)?;
    let (pose, _) = placed?;
    let Some(Path { carrier, steps }) = path else {
        return Some(vec![(pose, acceleration_by_hand(translation, &name.text, &pose, gravity))]);
    };
    let (mut before, mut acceleration) = match carrier {
        Some(carrier) => (link_at(translation, carrier)?.placed?.0, known[carrier]?),
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
        // A weld at the place of its carrier.
        found.push((before, acceleration));
    }
    Some(found)
}

/// ½ m a² + a·A h + ½ α·J α + α·(ω × J ω), under a name.
fn gibbs_of_frame(
    translation: &mut Translation<'_>,
    link: usize,
    (pose, acceleration): (Pose, Acceleration),
    parameters: WrittenParameters,
) -> AstId {
    let name = link_at(translation, link).map_or_else(String::new, |link| link.name.text);
    let relative = relative(translation, &name, [pose.spin, acceleration.spin]);
    let WrittenParameters { mass, moment, tensor } = parameters;
    let mut terms = translation.terms();
    let mut parts = Vec::new();
    for component in acceleration.origin {
        if terms.is_zero(component) {
            continue;
        }
        let (half, square) = (terms.half(), terms.square(component));
        let weight = terms.times(half, mass);
        parts.push(terms.times(weight, square));
    }
    let carried = apply(&mut terms, relative.matrix, moment);
    parts.push(inner(&mut terms, acceleration.origin, carried));
    parts.extend(rotational_parts(&mut terms, tensor, acceleration.spin, &relative));
    let function = sum_of(&mut terms, &parts);
    match terms.is_zero(function) {
        true => function,
        false => translation.bind(&format!("{name}_S"), function),
    }
}

/// ½ α·J α + α·(ω × J ω) by components. With x, y, z in cyclic order the moments add ½ J_zz α_z² + (J_yy − J_xx) ω_x ω_y α_z, and the
/// products J_xy (α_y − ω_z ω_x) (α_x + ω_y ω_z) + J_xy (ω_x² − ω_y²) α_z, but for terms without accelerations.
fn rotational_parts(
    terms: &mut TermWriter<'_>,
    tensor: Tensor,
    change: Triple,
    relative: &Relative,
) -> Vec<AstId> {
    let [moments, products] = [[tensor[0], tensor[1], tensor[2]], [tensor[5], tensor[4], tensor[3]]];
    let mut parts = Vec::new();
    for z in 0..3 {
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        if !terms.is_zero(change[z]) {
            let (half, square) = (terms.half(), terms.square(change[z]));
            let weight = terms.times(half, moments[z]);
            parts.push(terms.times(weight, square));
        }
        let difference = terms.minus(moments[y], moments[x]);
        let gyroscopic = terms.times(difference, relative.mixed[z]);
        parts.push(terms.times(gyroscopic, change[z]));
        let [to_x, to_y] = [relative.matrix[z][x], relative.matrix[z][y]];
        let coupled = terms.times(to_x, to_y);
        let coupled = terms.times(products[z], coupled);
        parts.push(terms.negative(coupled));
        let squares = terms.minus(relative.squares[x], relative.squares[y]);
        let spread = terms.times(products[z], squares);
        parts.push(terms.times(spread, change[z]));
    }
    parts
}

/// What is left in each frame on the way to each link when base parameters have gone to its carrier; nothing for bodies placed by hand,
/// whose energies say how they move. `None` if what is computed of numbers is too large for one.
fn parameters(
    translation: &mut Translation<'_>,
    order: &[usize],
) -> Option<Vec<Vec<Option<WrittenParameters>>>> {
    let count = translation.space.as_ref().map_or(0, |space| space.links.len());
    let mut received = vec![InertialParameters::NONE; count];
    let mut found = vec![Vec::new(); count];
    for &link in order.iter().rev() {
        let Some(Link { inertia, path: Some(path), .. }) = link_at(translation, link) else { continue };
        let own = match inertia {
            Some(inertia) => numeric_parameters(translation, inertia),
            None => Some(InertialParameters::NONE),
        };
        let own = own.map(|own| own.plus(received[link]));
        if !own.unwrap_or(received[link]).is_finite() {
            return None;
        }
        let steps = regrouping_steps(translation, &path, &received);
        found[link] = match (own, inertia, steps) {
            (Some(own), _, Some(steps)) => {
                let (rest, hidden) = split(own, &steps);
                if let Some(carrier) = path.carrier {
                    received[carrier] = received[carrier].plus(hidden);
                }
                let rest =
                    rest.into_iter().map(|rest| (!rest.is_nothing()).then(|| written(translation, rest)));
                rest.collect()
            }
            (Some(own), ..) if !own.is_nothing() => {
                let all = written(translation, own);
                unsplit(translation, &path, all)
            }
            (None, Some(inertia), _) => {
                let all = symbolic_parameters(translation, link, inertia, received[link]);
                unsplit(translation, &path, all)
            }
            _ => vec![None; path.steps.len().max(1)],
        };
    }
    Some(found)
}

/// The steps to a link in numbers, if its parameters are to be regrouped along them.
fn regrouping_steps(
    translation: &Translation<'_>,
    path: &Path,
    received: &[InertialParameters],
) -> Option<Vec<NumericStep>> {
    numeric_steps(translation, path).filter(|steps| match (path.carrier, motions(steps)) {
        // What turns in any direction is to accelerate in axes that do not.
        _ if is_free(path) => true,
        _ if translation.accuracy == Accuracy::Strict => false,
        (Some(carrier), _) if !is_carried(translation, carrier) => false,
        (_, 0) | (None, 1) => true,
        // A frame without inertia would get some only to carry it.
        (Some(carrier), 1) => has_inertia(translation, carrier) || !received[carrier].is_nothing(),
        _ => false,
    })
}

/// All parameters in the last frame of a path; of what turns in any direction the mass in the frame before, whose axes do not turn with it:
/// there it is the same in all directions.
fn unsplit(
    translation: &mut Translation<'_>,
    path: &Path,
    mut all: WrittenParameters,
) -> Vec<Option<WrittenParameters>> {
    let mut kept = vec![None; path.steps.len().max(1)];
    if let [.., before, _] = &mut kept[..]
        && turns_freely(path)
    {
        let nothing = written(translation, InertialParameters::NONE);
        let mass = std::mem::replace(&mut all.mass, nothing.mass);
        *before = Some(WrittenParameters { mass, ..nothing });
    }
    kept.last_mut().into_iter().for_each(|place| *place = Some(all));
    kept
}

/// True of links that move in any direction and nothing carries.
fn is_free(path: &Path) -> bool {
    path.carrier.is_none() && path.steps.len() > 1 && turns_freely(path)
}

fn turns_freely(path: &Path) -> bool {
    matches!(path.steps.last(), Some((FrameStep::Orientation(_), _)))
}

/// True of links that joints carry: only their equations are in the Gibbs function.
fn is_carried(translation: &Translation<'_>, link: usize) -> bool {
    translation.space.as_ref().is_some_and(|space| space.links[link].path.is_some())
}

fn has_inertia(translation: &Translation<'_>, link: usize) -> bool {
    translation.space.as_ref().is_some_and(|space| space.links[link].inertia.is_some())
}

fn motions(steps: &[NumericStep]) -> usize {
    let moves = |step: &&NumericStep| !matches!(step, NumericStep::Shift(_) | NumericStep::Reorientation(_));
    steps.iter().filter(moves).count()
}

/// What stays in the frame behind each step, and what goes to the carrier.
fn split(own: InertialParameters, steps: &[NumericStep]) -> (Vec<InertialParameters>, InertialParameters) {
    let mut kept = vec![InertialParameters::NONE; steps.len()];
    let mut moving = own;
    for (place, &step) in kept.iter_mut().zip(steps).rev() {
        let hidden = moving.take_hidden(step);
        *place = moving.without_rounding();
        moving = hidden;
    }
    (kept, moving)
}

fn numeric_parameters(translation: &Translation<'_>, inertia: MassProperties) -> Option<InertialParameters> {
    let mass = value_of_numbers(translation, inertia.mass)?;
    let centroid = triple_of_numbers(translation, inertia.centroid)?;
    let mut tensor = [0.0; 6];
    if let Some(given) = inertia.tensor {
        for (number, component) in tensor.iter_mut().zip(given) {
            *number = value_of_numbers(translation, component)?;
        }
    }
    Some(InertialParameters::of_body(mass, centroid, tensor))
}

fn numeric_steps(translation: &Translation<'_>, path: &Path) -> Option<Vec<NumericStep>> {
    let number = |(step, _): &(FrameStep, Pose)| match *step {
        FrameStep::Shift(by) => triple_of_numbers(translation, by).map(NumericStep::Shift),
        FrameStep::Reorientation(by) => matrix_of_numbers(translation, by).map(NumericStep::Reorientation),
        FrameStep::Turn(JointAxis::Coordinate { axis, .. }, _) => Some(NumericStep::Turn(axis)),
        FrameStep::Turn(JointAxis::Direction(_), _) => None,
        FrameStep::Slide(..) => Some(NumericStep::Slide),
        FrameStep::Orientation(_) => Some(NumericStep::Orientation),
    };
    path.steps.iter().map(number).collect()
}

fn written(translation: &mut Translation<'_>, parameters: InertialParameters) -> WrittenParameters {
    let mut terms = translation.terms();
    let InertialParameters { mass, moment, tensor } = parameters;
    WrittenParameters {
        mass: written_number(&mut terms, mass),
        moment: moment.map(|component| written_number(&mut terms, component)),
        tensor: TENSOR_PLACES.map(|(row, column)| written_number(&mut terms, tensor[row][column])),
    }
}

/// m, m c and J + m (c² 1 − c cᵀ), under names, and what was received from bodies further out.
fn symbolic_parameters(
    translation: &mut Translation<'_>,
    link: usize,
    inertia: MassProperties,
    received: InertialParameters,
) -> WrittenParameters {
    let received = written(translation, received);
    let name = link_at(translation, link).map_or_else(String::new, |link| link.name.text);
    let mut terms = translation.terms();
    let moment = scale(&mut terms, inertia.mass, inertia.centroid);
    let moment = plus(&mut terms, moment, received.moment);
    let about_center = inertia.tensor.unwrap_or([terms.number(0); 6]);
    let moved = tensor_of_point(&mut terms, inertia.mass, inertia.centroid);
    let own = tensor_sum(&mut terms, about_center, moved);
    let [xx, yy, zz, xy, xz, yz] = tensor_sum(&mut terms, own, received.tensor);
    let mass = terms.plus(inertia.mass, received.mass);
    let moment = named_vector(translation, &format!("{name}_moment"), moment);
    let moments = named_vector(translation, &format!("{name}_J"), [xx, yy, zz]);
    let products = named_vector(translation, &format!("{name}_J_products"), [xy, xz, yz]);
    let tensor = [moments[0], moments[1], moments[2], products[0], products[1], products[2]];
    WrittenParameters { mass, moment, tensor }
}
