//! Elements of arrays that are declared as a whole: their number, and their values.

use super::complaints::Complaints;
use super::messages;
use crate::syntax::ast::{ArrayExpression, AstId, Expression, Expressions};
use lagrange_expr::limits::MAX_ELEMENTS;

/// Returns the number of elements of an array; `None` if one of its sizes is invalid.
pub(super) fn count(sizes: &[i64]) -> Option<u64> {
    let are_sizes = sizes.iter().all(|size| *size > 0);
    are_sizes.then(|| sizes.iter().fold(1, |count: u64, size| count.saturating_mul(size.unsigned_abs())))
}

/// Returns the indices of all elements of an array, with the last index changing fastest; none if
/// there are too many.
pub(super) fn positions(sizes: &[i64]) -> Vec<Vec<i64>> {
    let longer = |positions: Vec<Vec<i64>>, size: &i64| {
        let with = |position: &Vec<i64>, index| position.iter().copied().chain([index]).collect();
        positions.iter().flat_map(|position| (0..*size).map(move |index| with(position, index))).collect()
    };
    match count(sizes) {
        Some(count) if count <= MAX_ELEMENTS => sizes.iter().fold(vec![Vec::new()], longer),
        _ => Vec::new(),
    }
}

/// Returns the value of an element: the one at its place in lists, otherwise the same for all.
pub(super) fn element_of(expressions: &Expressions, value: AstId, position: &[i64]) -> Option<AstId> {
    let mut value = value;
    for index in position {
        let Expression::Array(ArrayExpression::List(elements)) = expressions.get(value) else { break };
        value = *elements.get(usize::try_from(*index).ok()?)?;
    }
    Some(value)
}

/// Checks that lists have the sizes of the array in every dimension; reports others.
pub(super) fn fits(
    expressions: &Expressions,
    value: AstId,
    sizes: &[i64],
    complaints: &mut Complaints<'_>,
) -> bool {
    let is_list = |element: &AstId| matches!(expressions.get(*element), Expression::Array(_));
    let (message, help) = match (expressions.get(value), sizes) {
        (Expression::Tuple(_), [_, ..]) => (messages::LIST_AS_TUPLE.to_owned(), messages::LIST_AS_TUPLE_HELP),
        (Expression::Array(ArrayExpression::List(elements)), [size, inner @ ..]) => {
            if usize::try_from(*size) == Ok(elements.len()) {
                return elements.iter().all(|element| fits(expressions, *element, inner, complaints));
            }
            let are_rows = inner.is_empty() || elements.iter().any(is_list);
            let help = if are_rows { messages::LIST_HELP } else { messages::LIST_OF_LISTS_HELP };
            (messages::list_length(elements.len(), *size), help)
        }
        (Expression::Array(ArrayExpression::List(_)), []) => {
            (messages::LIST_IN_LIST.to_owned(), messages::LIST_HELP)
        }
        _ => return true,
    };
    let origin = expressions.origin(value);
    if let Some(error) = complaints.once(value, origin, message) {
        error.help(help);
    }
    false
}
