//! Regrouping of inertial parameters towards the ground: their remainder in the frame after each
//! step.
//!
//! Links are visited from the leaves to the ground. After every moving step, each link keeps the
//! part that the step can distinguish from its carrier ([`super::base_parameters`]). The carrier
//! receives the rest. Expressions of parameters receive a name at every link, so that the length of
//! the text is proportional to the scene.

use super::base_parameters::{InertialParameters, JointStep};
use super::frames::{FrameStep, JointAxis};
use super::links::{Link, MassProperties, Path};
use super::numbers::matrix_of_numbers;
use super::poses::{is_atom, link_at, named_vector, under_name};
use super::quantities::Quantity;
use super::vectors::{TENSOR_PLACES, Tensor, Triple};
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::AstId;
use lagrange_expr::accuracy::Accuracy;

/// Inertial parameters as syntax.
#[derive(Clone, Copy)]
pub(super) struct WrittenParameters {
    pub(super) mass: AstId,
    pub(super) moment: Triple,
    pub(super) tensor: Tensor,
}

/// Returns the parameters that remain in each frame on the path to each link, after hidden
/// parameters have been moved to its carrier. Empty for bodies placed by hand, whose energies
/// define their motion. `None` if a computed number is too large.
pub(super) fn regrouped(
    translation: &mut Translation<'_>,
    order: &[usize],
) -> Option<Vec<Vec<Option<WrittenParameters>>>> {
    let count = translation.space.as_ref().map_or(0, |space| space.links.len());
    let mut received = vec![InertialParameters::NONE; count];
    let mut found = vec![Vec::new(); count];
    for &link in order.iter().rev() {
        let Some(Link { name, inertia, path: Some(path), .. }) = link_at(translation, link) else { continue };
        let all = own_parameters(translation, inertia).plus(&mut translation.terms(), received[link]);
        if !all.is_finite() {
            return None;
        }
        let kept = match regrouping_steps(translation, &path, &all, &received) {
            Some(steps) => {
                let all = under_names(translation, &name.text, all);
                let (kept, hidden) = split(&mut translation.terms(), all, &steps);
                if let Some(carrier) = path.carrier {
                    received[carrier] = received[carrier].plus(&mut translation.terms(), hidden);
                }
                kept
            }
            None => {
                let whole = all.as_terms(&mut translation.terms());
                unsplit(&path, under_names(translation, &name.text, whole))
            }
        };
        let mut terms = translation.terms();
        let kept = kept.into_iter().map(|kept| (!kept.is_nothing()).then(|| written(&mut terms, kept)));
        found[link] = kept.collect();
    }
    Some(found)
}

/// Returns the parameters of the body itself; zero for a frame, and for a body whose mass changes,
/// whose energies define its motion.
fn own_parameters(translation: &mut Translation<'_>, inertia: Option<MassProperties>) -> InertialParameters {
    let fixed = inertia.filter(|inertia| !inertia.changes);
    let Some(MassProperties { mass, centroid, tensor, .. }) = fixed else { return InertialParameters::NONE };
    let mass = Quantity::of(translation, mass);
    let centroid = centroid.map(|component| Quantity::of(translation, component));
    let tensor = tensor.map(|tensor| tensor.map(|component| Quantity::of(translation, component)));
    let tensor = tensor.unwrap_or([Quantity::ZERO; 6]);
    InertialParameters::of_body(&mut translation.terms(), mass, centroid, tensor)
}

/// Names parameters that are not numbers.
fn under_names(
    translation: &mut Translation<'_>,
    name: &str,
    parameters: InertialParameters,
) -> InertialParameters {
    let InertialParameters { mass, moment, tensor } = parameters;
    let mass = Quantity {
        term: mass.term.map(|term| under_name(translation, &format!("{name}_mass"), term)),
        ..mass
    };
    let moment = vector_under_name(translation, &format!("{name}_moment"), moment);
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = tensor;
    let [xx, yy, zz] = vector_under_name(translation, &format!("{name}_J"), [xx, yy, zz]);
    let [xy, xz, yz] = vector_under_name(translation, &format!("{name}_J_products"), [xy, xz, yz]);
    InertialParameters { mass, moment, tensor: [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]] }
}

fn vector_under_name(translation: &mut Translation<'_>, wish: &str, vector: [Quantity; 3]) -> [Quantity; 3] {
    let needs_name = |entry: &Quantity| entry.term.is_some_and(|term| !is_atom(translation, term));
    if !vector.iter().any(needs_name) {
        return vector;
    }
    let mut terms = translation.terms();
    let written = vector.map(|entry| entry.term.unwrap_or_else(|| entry.written(&mut terms)));
    let named = named_vector(translation, wish, written);
    [0, 1, 2].map(|axis| {
        let Quantity { number, term } = vector[axis];
        Quantity { number, term: term.map(|_| named[axis]) }
    })
}

/// Returns the steps to a link, if its parameters are to be regrouped along them.
fn regrouping_steps(
    translation: &Translation<'_>,
    path: &Path,
    all: &InertialParameters,
    received: &[InertialParameters],
) -> Option<Vec<JointStep>> {
    fixed_steps(translation, path).filter(|steps| match (path.carrier, motions(steps)) {
        // Links that turn in any direction should accelerate in axes that do not turn.
        _ if is_free(path) => true,
        _ if translation.accuracy == Accuracy::Strict => false,
        // Only the mass would be moved, and its contribution to the carrier would cost more than it
        // saves.
        _ if turns_freely(path) && !all.is_known() => false,
        (Some(carrier), _) if !is_carried(translation, carrier) => false,
        (_, 0) | (None, 1) => true,
        // A frame without inertia would only receive some to carry it.
        (Some(carrier), 1) => has_inertia(translation, carrier) || !received[carrier].is_nothing(),
        _ => false,
    })
}

/// Returns all parameters in the last frame of a path. The mass of a part that turns in any
/// direction is in the previous frame, whose axes do not turn with it. There it is the same in all
/// directions.
fn unsplit(path: &Path, mut all: InertialParameters) -> Vec<InertialParameters> {
    let mut kept = vec![InertialParameters::NONE; path.steps.len().max(1)];
    if let [.., before, _] = &mut kept[..]
        && turns_freely(path)
    {
        before.mass = std::mem::replace(&mut all.mass, Quantity::ZERO);
    }
    kept.last_mut().into_iter().for_each(|place| *place = all);
    kept
}

/// True for links that move in any direction without a carrier.
fn is_free(path: &Path) -> bool {
    path.carrier.is_none() && path.steps.len() > 1 && turns_freely(path)
}

fn turns_freely(path: &Path) -> bool {
    matches!(path.steps.last(), Some((FrameStep::Orientation(_), _)))
}

/// True for links on joints: only their equations are in the Gibbs function.
fn is_carried(translation: &Translation<'_>, link: usize) -> bool {
    translation.space.as_ref().is_some_and(|space| space.links[link].path.is_some())
}

fn has_inertia(translation: &Translation<'_>, link: usize) -> bool {
    translation.space.as_ref().is_some_and(|space| space.links[link].inertia.is_some())
}

fn motions(steps: &[JointStep]) -> usize {
    let moves = |step: &&JointStep| !matches!(step, JointStep::Shift(_) | JointStep::Reorientation(_));
    steps.iter().filter(moves).count()
}

/// Splits parameters at each step into those that stay in the frame after it and those that move to
/// the carrier.
fn split(
    terms: &mut TermWriter<'_>,
    own: InertialParameters,
    steps: &[JointStep],
) -> (Vec<InertialParameters>, InertialParameters) {
    let mut kept = vec![InertialParameters::NONE; steps.len()];
    let mut moving = own;
    for (place, &step) in kept.iter_mut().zip(steps).rev() {
        let hidden = moving.take_hidden(terms, step);
        *place = moving.without_rounding();
        moving = hidden;
    }
    (kept, moving)
}

/// Returns the steps of a path, if its orientations are numeric.
fn fixed_steps(translation: &Translation<'_>, path: &Path) -> Option<Vec<JointStep>> {
    let fixed = |(step, _): &(FrameStep, _)| match *step {
        FrameStep::Shift(by) => Some(JointStep::Shift(by.map(|length| Quantity::of(translation, length)))),
        FrameStep::Reorientation(by) => matrix_of_numbers(translation, by).map(JointStep::Reorientation),
        FrameStep::Turn(JointAxis::Coordinate { axis, .. }, _) => Some(JointStep::Turn(axis)),
        FrameStep::Turn(JointAxis::Direction(_), _) => None,
        FrameStep::Slide(..) => Some(JointStep::Slide),
        FrameStep::Orientation(_) => Some(JointStep::Orientation),
    };
    path.steps.iter().map(fixed).collect()
}

fn written(terms: &mut TermWriter<'_>, parameters: InertialParameters) -> WrittenParameters {
    let InertialParameters { mass, moment, tensor } = parameters;
    WrittenParameters {
        mass: mass.written(terms),
        moment: moment.map(|entry| entry.written(terms)),
        tensor: TENSOR_PLACES.map(|(row, column)| tensor[row][column].written(terms)),
    }
}
