//! Numbers with units in the syntax tree.

use crate::syntax::ast::{AstId, BinaryOperator, Expression, Expressions};
use lagrange_expr::number::Number;
use lagrange_expr::units::Unit;

/// True if an expression is made of numbers alone, so that a unit can be meant for all of it.
pub(super) fn is_of_numbers(expressions: &Expressions, root: AstId) -> bool {
    let is_other = |id: &AstId| {
        matches!(expressions.get(*id), Expression::Quantity(..) | Expression::Invalid)
            || is_name(expressions, *id)
    };
    !expressions.parts(root).iter().any(is_other)
}

/// True if an expression is a name that has a unit of its own.
pub(super) fn is_name(expressions: &Expressions, id: AstId) -> bool {
    matches!(expressions.get(id), Expression::Name(name) if name != "pi")
}

/// `500` as `500 [mm]`, anything else as `(…) * 1 [mm]`.
pub(super) fn with_unit(expressions: &mut Expressions, value: AstId, unit: &Unit) -> AstId {
    let origin = expressions.origin(value);
    let quantity = |of| Expression::Quantity(of, Box::new(unit.clone()));
    if let Expression::Number(_) = expressions.get(value) {
        return expressions.add(quantity(value), origin);
    }
    let one = expressions.add(Expression::Number(Number::ONE), origin);
    let unit = expressions.add(quantity(one), origin);
    expressions.add(Expression::Binary(BinaryOperator::Multiply, origin.start, value, unit), origin)
}
