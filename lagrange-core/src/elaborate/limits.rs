//! Ranges and nominal values of entries of the state: in declarations of coordinates and states,
//! and of any entry in `range` statements.

use super::assigned::DeclaredLimits;
use super::elaborator::Elaborator;
use super::entries::{assigned_index, spelling_of};
use super::messages::ranges as messages;
use super::ranges::bounds;
use crate::model::{Coordinate, EntryLimits, Speed};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::evaluate;
use lagrange_language::syntax::ast::{AllowedRange, AstId, LimitedEntry};

/// Adds `range x in 0..=1 nominal 0.1;`.
pub(super) fn add_limits(elaborator: &mut Elaborator<'_>, entry: &LimitedEntry) {
    let index = assigned_index(elaborator, entry.target, messages::ENTRY_HELP);
    let origin = elaborator.evaluator.origin(entry.target);
    set_limits(elaborator, index, origin, (entry.range, entry.nominal));
}

pub(super) fn set_limits(
    elaborator: &mut Elaborator<'_>,
    index: Option<usize>,
    origin: Origin,
    (range, nominal): (AllowedRange, Option<AstId>),
) {
    let bounds = bounds(elaborator, &range);
    let nominal = nominal.and_then(|nominal| magnitude(elaborator, nominal));
    let Some(index) = index else { return };
    let graph = &elaborator.evaluator.graph;
    let bounds = bounds.map(|bound| {
        let bound = bound?;
        Some((evaluate(graph, &[bound.value], |_| f64::NAN)[0], bound.is_included))
    });
    let limits = EntryLimits { bounds, nominal };
    if is_single(elaborator, (index, origin), &limits) {
        elaborator.limits.push(DeclaredLimits { index, origin, range, limits });
    }
}

/// The question for a range or a nominal value, and the message about two of them.
type LimitKind = (fn(&EntryLimits) -> bool, fn(String) -> String);

/// Returns true unless the entry has two ranges or two nominal values, which is reported once.
fn is_single(
    elaborator: &mut Elaborator<'_>,
    (index, origin): (usize, Origin),
    limits: &EntryLimits,
) -> bool {
    let kinds: [LimitKind; 2] = [
        (EntryLimits::is_bounded, messages::two_ranges),
        (|limits| limits.nominal.is_some(), messages::two_nominal_values),
    ];
    let others = elaborator.limits.iter().filter(|other| other.index == index);
    let twice = kinds.into_iter().filter(|(has, _)| has(limits)).find_map(|(has, message)| {
        let first = others.clone().find(|other| has(&other.limits))?;
        Some((first.origin, message))
    });
    let Some((first, message)) = twice else { return true };
    let message = message(spelling_of(elaborator, index));
    let error = elaborator.evaluator.report.error(origin, message);
    error.related(first, messages::LIMITED_HERE).help(messages::LIMITED_TWICE_HELP);
    false
}

/// Evaluates a nominal value.
fn magnitude(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<f64> {
    let value = elaborator.constant_scalar(syntax, messages::NOMINAL)?;
    let value = evaluate(&elaborator.evaluator.graph, &[value], |_| f64::NAN)[0];
    // Infinity is reported with all numbers that are too large.
    if value > 0.0 {
        return Some(value);
    }
    elaborator.evaluator.refuse(syntax, messages::not_positive(value), messages::NOT_POSITIVE_HELP)
}

/// Stores declared limits with the coordinates and the velocities.
pub(super) fn store_limits(
    declared: Vec<DeclaredLimits>,
    coordinates: &mut [Coordinate],
    speeds: &mut [Speed],
) {
    for DeclaredLimits { index, limits, .. } in declared {
        let stored = match index.checked_sub(coordinates.len()) {
            None => &mut coordinates[index].limits,
            Some(velocity) => &mut speeds[velocity].limits,
        };
        if limits.is_bounded() {
            stored.bounds = limits.bounds;
        }
        stored.nominal = limits.nominal.or(stored.nominal);
    }
}
