//! Numbers with units in the syntax tree.

use crate::syntax::ast::{AstId, BinaryOperator, Expression, Expressions};
use lagrange_expr::number::Number;
use lagrange_expr::units::Unit;

/// True if an expression consists of only numbers, so that a unit can apply to all of it.
pub(super) fn is_of_numbers(expressions: &Expressions, root: AstId) -> bool {
    let is_other = |id: &AstId| {
        matches!(expressions.get(*id), Expression::Quantity(..) | Expression::Invalid)
            || is_name(expressions, *id)
    };
    !expressions.parts(root).iter().any(is_other)
}

/// True if an expression is a name with its own unit.
pub(super) fn is_name(expressions: &Expressions, id: AstId) -> bool {
    matches!(expressions.get(id), Expression::Name(name) if name != "pi")
}

/// Writes `500` as `500 [mm]`, anything else as `(…) * 1 [mm]`. A unit with its own zero and factor
/// one yields `(…) * 1 [K] + 273.15 [K]`.
pub(super) fn with_unit(expressions: &mut Expressions, value: AstId, unit: &Unit) -> AstId {
    let origin = expressions.origin(value);
    if let Expression::Number(_) = expressions.get(value) {
        return expressions.add(Expression::Quantity(value, Box::new(unit.clone())), origin);
    }
    let mut quantity = |number, unit| {
        let number = expressions.add(Expression::Number(number), origin);
        expressions.add(Expression::Quantity(number, Box::new(unit)), origin)
    };
    let binary = |operator, left, right| Expression::Binary(operator, origin.start, left, right);
    if unit.offset.is_zero() {
        let one = quantity(Number::ONE, unit.clone());
        return expressions.add(binary(BinaryOperator::Multiply, value, one), origin);
    }
    let one = quantity(Number::ONE, unit.coherent());
    let zero = quantity(unit.offset.clone(), unit.coherent());
    let above = expressions.add(binary(BinaryOperator::Multiply, value, one), origin);
    expressions.add(binary(BinaryOperator::Add, above, zero), origin)
}
