//! Numbers in units with their own zero, in sums and products.

use super::ReadOperand;
use crate::syntax::ast::{BinaryOperator, Expression};
use crate::syntax::messages::units as words;
use crate::syntax::parser::Parser;
use lagrange_expr::diagnostics::Origin;

impl Parser<'_> {
    /// Negates an operand. `-5 degC` is five degrees below its zero.
    pub(super) fn negated(&mut self, operand: ReadOperand, origin: Origin) -> ReadOperand {
        match self.expressions.get(operand.id).clone() {
            Expression::Quantity(number, unit) if !unit.offset.is_zero() => {
                let negative = self.add(Expression::Negate(number), origin);
                self.add(Expression::Quantity(negative.id, unit), origin)
            }
            _ => self.add(Expression::Negate(operand.id), origin),
        }
    }

    /// Reports an operand in a unit with its own zero, unless it is subtracted.
    pub(super) fn refuse_offset(&mut self, operator: BinaryOperator, operands: [ReadOperand; 2]) {
        for operand in operands.iter().filter(|_| operator != BinaryOperator::Subtract) {
            if let Expression::Quantity(_, unit) = self.expressions.get(operand.id)
                && !unit.offset.is_zero()
            {
                let message = words::offset_in_sum(unit.to_string());
                self.fail_with_help(operand.origin, message, words::OFFSET_HELP);
            }
        }
    }
}
