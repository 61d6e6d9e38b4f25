//! `reduce` statements: resolution of names, and checks before anything is reduced.

use proc_macro2::Span;

use super::elaborator::Elaborator;
use super::messages;
use super::states::state_named;
use crate::model::{Pinned, Reduction};
use lagrange_expr::expr::ExprId;
use lagrange_language::syntax::ast::{self, Name, ReductionItem, ReductionKind, ScalarType, momentum_of};

/// Methods of reduced types; outputs must not have their names.
const METHODS_OF_REDUCED: [&str; 3] = ["expand", "deviation", "from_state"];
/// Method of types with states, such as reduced ones with ignored coordinates.
const METHOD_OF_STATES: &str = "position_rates";

/// True for names of methods of reduced types that other systems do not have.
pub fn is_method_of_reduced(name: &str, has_states: bool) -> bool {
    METHODS_OF_REDUCED.contains(&name) || has_states && name == METHOD_OF_STATES
}

pub(super) fn add_reduction(elaborator: &mut Elaborator<'_>, syntax: &ast::Reduction) {
    check_type_name(elaborator, syntax);
    let name = syntax.name.clone();
    let mut reduction = Reduction { name, frozen: Vec::new(), small: Vec::new(), ignored: Vec::new() };
    for item in &syntax.items {
        let Some(pinned) = pinned_coordinate(elaborator, item) else { continue };
        let named = reduction.frozen.iter().chain(&reduction.small).chain(&reduction.ignored);
        if let Some(earlier) = named.into_iter().find(|earlier| earlier.coordinate == pinned.coordinate) {
            let message = messages::reduced_twice(&item.coordinate.text);
            let error = elaborator.evaluator.report.error(pinned.span, message);
            error.related(earlier.span.into(), messages::NAMED_HERE).help(messages::NAMED_TWICE_HELP);
            continue;
        }
        match item.kind {
            ReductionKind::Frozen => reduction.frozen.push(pinned),
            ReductionKind::Small => reduction.small.push(pinned),
            ReductionKind::Ignored => reduction.ignored.push(pinned),
        }
    }
    reduction.ignored.sort_by_key(|pinned| pinned.coordinate);
    elaborator.reductions.push(reduction);
}

fn pinned_coordinate(elaborator: &mut Elaborator<'_>, item: &ReductionItem) -> Option<Pinned> {
    let name = &item.coordinate;
    elaborator.evaluator.scope.resolve(&name.text);
    let coordinate = elaborator.coordinates.iter().position(|(known, _)| known.name == name.text);
    let value = match item.value {
        Some(syntax) => elaborator.constant_in_motion(syntax, messages::PINNED_VALUE),
        None => Some(elaborator.evaluator.graph.number(0)),
    };
    if let Some(state) = state_named(elaborator, &name.text) {
        return pinned_state(elaborator, item, state, value);
    }
    let has_rate = |index| elaborator.speeds.iter().any(|(speed, _)| speed.coordinate == Some(index));
    match coordinate.map(has_rate) {
        None => elaborator.report_no_coordinate(name, messages::REDUCTION_HELP),
        Some(false) => {
            let message = messages::reduced_quaternion(&name.text);
            let help = match item.kind {
                ReductionKind::Ignored => messages::IGNORED_QUATERNION_HELP,
                ReductionKind::Frozen | ReductionKind::Small => messages::REDUCED_QUATERNION_HELP,
            };
            elaborator.evaluator.report.error(name.span, message).help(help);
            return None;
        }
        Some(true) => {}
    }
    Some(Pinned { coordinate: coordinate?, value: value?, span: name.span })
}

/// Resolves a state, which may only be held at a value.
fn pinned_state(
    elaborator: &mut Elaborator<'_>,
    item: &ReductionItem,
    state: usize,
    value: Option<ExprId>,
) -> Option<Pinned> {
    let name = &item.coordinate;
    let (message, help) = match item.kind {
        ReductionKind::Frozen => return Some(Pinned { coordinate: state, value: value?, span: name.span }),
        ReductionKind::Small => (messages::states::small(&name.text), messages::states::SMALL_HELP),
        ReductionKind::Ignored => (messages::states::ignored(&name.text), messages::states::IGNORED_HELP),
    };
    elaborator.evaluator.report.error(name.span, message).help(help);
    None
}

/// Checks the names of momenta: the momentum of an ignored coordinate is a parameter of the reduced
/// type.
fn check_momentum_names(elaborator: &mut Elaborator<'_>) {
    for pinned in elaborator.reductions.iter().flat_map(|reduction| &reduction.ignored) {
        let coordinate = &elaborator.coordinates[pinned.coordinate].0.name;
        let name = momentum_of(&Name::new(coordinate.clone(), pinned.span));
        let is_taken = elaborator.evaluator.scope.find(&name.text).is_some();
        let is_output = elaborator.declaration.outputs().any(|output| output.text == name.text);
        if is_taken || is_output {
            let message = messages::momentum_taken(&name.text);
            elaborator.evaluator.report.error(name.span, message).help(messages::OTHER_NAME_HELP);
        }
    }
}

/// Checks that the types `Name` and `NameState` are new.
fn check_type_name(elaborator: &mut Elaborator<'_>, syntax: &ast::Reduction) {
    let declaration = elaborator.declaration;
    let full = (declaration.name.text.as_str(), declaration.name.span);
    let earlier = declaration.reductions().map(|(r, _)| (r.name.text.as_str(), r.name.span));
    let earlier = earlier.take(elaborator.reductions.len());
    let parameter = match &declaration.scalar {
        ScalarType::Generic(name) => Some((name.text.as_str(), name.span)),
        _ => None,
    };
    let new = &syntax.name;
    let clashes = |&(name, _): &(&str, Span)| {
        let belongs = |name: &str, to: &str| {
            ["State", "Columns", "Inputs", "Prepared", "Lanes"]
                .iter()
                .any(|suffix| name.strip_suffix(suffix) == Some(to))
        };
        name == new.text || belongs(name, &new.text) || belongs(&new.text, name)
    };
    let types = std::iter::once(full).chain(earlier).chain(parameter);
    if let Some((_, span)) = types.into_iter().find(clashes) {
        let error = elaborator.evaluator.report.error(new.span, messages::type_name_taken(&new.text));
        error.related(span.into(), messages::TYPE_NAMED_HERE).help(messages::TYPE_NAME_HELP);
    }
}

/// Performs the checks that need all names.
pub(super) fn check_reductions(elaborator: &mut Elaborator<'_>) {
    if elaborator.reductions.is_empty() {
        return;
    }
    check_momentum_names(elaborator);
    let is_ignoring = elaborator.reductions.iter().any(|reduction| !reduction.ignored.is_empty());
    let adds_states = is_ignoring && elaborator.velocities_are_rates();
    let first = elaborator.first_state;
    let report = &mut *elaborator.evaluator.report;
    let all = elaborator.coordinates.len();
    let frozen =
        |reduction: &Reduction| reduction.frozen.iter().filter(|pinned| pinned.coordinate < first).count();
    let stay = |reduction: &&Reduction| frozen(reduction) + reduction.ignored.len() < all;
    for reduction in elaborator.reductions.iter().filter(|reduction| all > 0 && !stay(reduction)) {
        let (message, help) = match reduction.ignored.is_empty() {
            true => (messages::ALL_FROZEN, messages::ALL_FROZEN_HELP),
            false => (messages::ALL_IGNORED, messages::ALL_IGNORED_HELP),
        };
        report.error(reduction.name.span, message).help(help);
    }
    for name in elaborator.declaration.outputs() {
        if is_method_of_reduced(&name.text, adds_states) {
            let error = report.error(name.span, messages::output_of_reduced(&name.text));
            error.help(messages::OTHER_NAME_HELP);
        }
    }
}
