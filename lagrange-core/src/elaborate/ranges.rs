//! Ranges of parameters, and of quantities of contacts.

use super::assigned::Bounds;
use super::elaborator::Elaborator;
use super::messages::ranges as messages;
use crate::model::{Bound, Quantity};
use lagrange_expr::expr::{Dependencies, ExprId, evaluate};
use lagrange_language::syntax::ast::{AllowedRange, AstId, Definition, Limit, Name};
use lagrange_language::syntax::print;

/// Returns the range of a parameter, once for all elements of an array. The default must be within
/// it.
pub(super) fn range_of(
    elaborator: &mut Elaborator<'_>,
    definition: &Definition,
    default: Option<ExprId>,
) -> Bounds {
    let AllowedRange { lower, upper } = definition.range;
    let known = elaborator.ranges.iter().find(|(limits, _)| *limits == [lower, upper]);
    let bounds = match known {
        Some((_, bounds)) => *bounds,
        None => {
            let bounds = bounds(elaborator, &definition.range);
            elaborator.ranges.push(([lower, upper], bounds));
            bounds
        }
    };
    if let Some((syntax, default)) = definition.value.zip(default) {
        check_default(elaborator, definition, (syntax, default), bounds);
    }
    bounds
}

impl Elaborator<'_> {
    /// Adds the bounds of a quantity of a contact, if it depends on parameters alone.
    pub(super) fn bound_quantity(
        &mut self,
        contact: &Name,
        quantity: &str,
        value: ExprId,
        range: [Option<Bound>; 2],
    ) {
        let graph = &self.evaluator.graph;
        let values = range.iter().flatten().map(|bound| bound.value).chain([value]);
        let all = values.fold(Dependencies::NONE, |all, value| all | graph.dependencies(value));
        if all == Dependencies::PARAMETER {
            let (contact, quantity) = (contact.clone(), quantity.to_owned());
            self.quantities.push(Quantity { contact, quantity, value, range });
        }
    }
}

/// Returns the bounds of a range.
pub(super) fn bounds(elaborator: &mut Elaborator<'_>, range: &AllowedRange) -> Bounds {
    let mut bound = |limit: Limit| {
        let value = elaborator.constant_scalar(limit.value, messages::BOUND)?;
        Some(Bound { value, is_included: limit.is_included })
    };
    let bounds = [range.lower.and_then(&mut bound), range.upper.and_then(&mut bound)];
    if let ([Some(lower), Some(upper)], Some(last)) = (bounds, range.upper) {
        let order = order(elaborator, lower.value, upper.value);
        let has_one = lower.is_included && upper.is_included;
        if order.is_gt() || order.is_eq() && !has_one {
            let help = messages::EMPTY_RANGE_HELP;
            elaborator.evaluator.refuse::<()>(last.value, messages::EMPTY_RANGE, help);
            return [None, None];
        }
    }
    bounds
}

fn check_default(
    elaborator: &mut Elaborator<'_>,
    definition: &Definition,
    (syntax, default): (AstId, ExprId),
    [lower, upper]: Bounds,
) {
    let is_outside = |bound: Option<Bound>, is_lower: bool| {
        bound.is_some_and(|bound| {
            let order = order(elaborator, default, bound.value);
            let is_beyond = if is_lower { order.is_lt() } else { order.is_gt() };
            is_beyond || order.is_eq() && !bound.is_included
        })
    };
    if is_outside(lower, true) || is_outside(upper, false) {
        let expressions = &elaborator.declaration.expressions;
        let range = print::range(expressions, &definition.range);
        let message = messages::default_outside(&definition.name.text, range);
        elaborator.evaluator.refuse::<()>(syntax, message, messages::DEFAULT_OUTSIDE_HELP);
    }
}

/// Compares two constants, exactly if both are rational.
fn order(elaborator: &Elaborator<'_>, left: ExprId, right: ExprId) -> std::cmp::Ordering {
    let graph = &elaborator.evaluator.graph;
    match (graph.as_number(left), graph.as_number(right)) {
        (Some(left), Some(right)) => left.cmp(right),
        _ => {
            let values = evaluate(graph, &[left, right], |_| f64::NAN);
            values[0].total_cmp(&values[1])
        }
    }
}
