//! Numbers that are known during the translation of statements.

use crate::syntax::ast::{AstId, BinaryOperator, Declaration, Expression, Expressions, StatementKind};
use lagrange_expr::collections::HashMap;

/// Returns the values of constants that consist of numbers and earlier constants.
pub(super) fn constants_of(declaration: &Declaration) -> HashMap<String, f64> {
    let mut known = HashMap::default();
    for statement in &declaration.statements {
        let StatementKind::Constants(list) = &statement.kind else { continue };
        for row in list {
            let value = row.value.and_then(|value| number(&declaration.expressions, &known, value));
            value.map(|value| known.insert(row.name.text.clone(), value));
        }
    }
    known
}

/// Returns the value of an expression that consists of numbers, π and constants.
pub(super) fn number(
    expressions: &Expressions,
    constants: &HashMap<String, f64>,
    root: AstId,
) -> Option<f64> {
    let mut values: Vec<f64> = Vec::new();
    let mut pending = vec![(root, false)];
    while let Some((id, are_parts_known)) = pending.pop() {
        match expressions.get(id) {
            Expression::Number(number) => values.push(number.to_f64()),
            Expression::Name(name) if name == "pi" => values.push(std::f64::consts::PI),
            Expression::Name(name) => values.push(*constants.get(name)?),
            Expression::Quantity(_, unit) if are_parts_known => {
                let value = values.pop()?;
                values.push(value * unit.scale.to_f64() + unit.offset.to_f64());
            }
            Expression::Negate(_) if are_parts_known => {
                let value = values.pop()?;
                values.push(-value);
            }
            Expression::Binary(operator, ..) if are_parts_known => {
                let (right, left) = (values.pop()?, values.pop()?);
                values.push(applied(*operator, left, right));
            }
            Expression::Negate(of) | Expression::Quantity(of, _) => {
                pending.extend([(id, true), (*of, false)]);
            }
            Expression::Binary(_, _, left, right) => {
                pending.extend([(id, true), (*right, false), (*left, false)]);
            }
            _ => return None,
        }
    }
    values.pop().filter(|value| value.is_finite())
}

fn applied(operator: BinaryOperator, left: f64, right: f64) -> f64 {
    match operator {
        BinaryOperator::Add => left + right,
        BinaryOperator::Subtract => left - right,
        BinaryOperator::Multiply => left * right,
        BinaryOperator::Divide => left / right,
        BinaryOperator::Power => left.powf(right),
        BinaryOperator::Remainder => left.rem_euclid(right),
    }
}
