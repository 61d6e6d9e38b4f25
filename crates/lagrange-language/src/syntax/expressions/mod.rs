//! Expressions: chains of operators between operands.
//!
//! Operators wait on a stack until the operator after their right operand binds no tighter
//! (operator precedence parsing). Chains of any length are thus read without recursion.

mod arrays;
mod conditionals;
mod offsets;
mod operands;

use proc_macro2::Span;

use crate::syntax::ast::{AstId, BinaryOperator, Expression, IN_AXES, Name};
use crate::syntax::cursor::Cursor;
use crate::syntax::messages;
use crate::syntax::parser::{Parsed, Parser, Reported};
use crate::syntax::recovery::Turn;
use crate::syntax::unexpected::at_range;
pub(super) use arrays::at_loop;
use lagrange_expr::diagnostics::Origin;

/// A readable piece of an expression, and the tokens it covers including its parentheses.
#[derive(Clone, Copy)]
pub(super) struct ReadOperand {
    pub(super) id: AstId,
    pub(super) origin: Origin,
}

/// An operator that waits for the end of its right operand.
#[derive(Clone, Copy)]
enum WaitingOperator {
    Negate(Span),
    Binary(ReadOperand, BinaryOperator, Span),
}

/// Binding strength of operators; larger is tighter.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Power,
}

impl Parser<'_> {
    /// Reads an expression and stops at the first token that cannot continue it.
    pub(super) fn expression(&mut self, cursor: &mut Cursor) -> Parsed<AstId> {
        let whole = self.operators(cursor)?;
        match cursor.ident() {
            Some(word) if word == IN_AXES && at_range(cursor) => Err(self.range_behind_value(cursor)),
            Some(word) if word == IN_AXES => Ok(self.in_axes(whole, cursor)?.id),
            _ => Ok(whole.id),
        }
    }

    /// Reads an expression that `in` and a range may follow.
    pub(super) fn before_range(&mut self, cursor: &mut Cursor) -> Parsed<AstId> {
        Ok(self.operators(cursor)?.id)
    }

    /// Reads `in body` after a whole expression.
    fn in_axes(&mut self, vector: ReadOperand, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        let word = Name::new(IN_AXES, cursor.skip_one().start);
        let body = self.name(cursor)?;
        let body = self.indexed(body, cursor)?;
        let body = self.named(body, cursor)?;
        let origin = vector.origin.to(body.origin);
        Ok(self.add(Expression::Call(word, vec![vector.id, body.id]), origin))
    }

    fn operators(&mut self, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        let mut waiting = Vec::new();
        let mut whole = None;
        self.turns(cursor, |parser, cursor| {
            waiting.extend(cursor.eat_all('-').map(WaitingOperator::Negate));
            let mut left = parser.operand(cursor)?;
            let next = parser.operator(cursor)?;
            let complete =
                |top: &mut WaitingOperator| next.is_none_or(|(operator, _)| ends_before(top, operator));
            while let Some(top) = waiting.pop_if(complete) {
                left = parser.apply(top, left);
            }
            match next {
                None => whole = Some(left),
                Some((operator, span)) => waiting.push(WaitingOperator::Binary(left, operator, span)),
            }
            Ok(Turn::next_if(next.is_some()))
        })?;
        whole.ok_or(Reported)
    }

    /// Consumes a binary operator, if there is one.
    fn operator(&mut self, cursor: &mut Cursor) -> Parsed<Option<(BinaryOperator, Span)>> {
        if cursor.at_pair('*', '*') {
            let origin = cursor.skip_one().to(cursor.here());
            return Err(self.fail_with_help(origin, messages::DOUBLE_STAR, messages::DOUBLE_STAR_HELP));
        }
        let operators = [
            ('+', BinaryOperator::Add),
            ('-', BinaryOperator::Subtract),
            ('*', BinaryOperator::Multiply),
            ('/', BinaryOperator::Divide),
            ('^', BinaryOperator::Power),
            ('%', BinaryOperator::Remainder),
        ];
        let is_known = |operator| operator != BinaryOperator::Remainder || self.counts;
        let found =
            operators.into_iter().find(|&(character, operator)| cursor.at(character) && is_known(operator));
        Ok(found.map(|(_, operator)| (operator, cursor.skip_one().end)))
    }

    fn apply(&mut self, operator: WaitingOperator, right: ReadOperand) -> ReadOperand {
        match operator {
            WaitingOperator::Negate(minus) => self.negated(right, Origin::from(minus).to(right.origin)),
            WaitingOperator::Binary(left, operator, span) => {
                self.refuse_offset(operator, [left, right]);
                let expression = Expression::Binary(operator, span, left.id, right.id);
                self.add(expression, left.origin.to(right.origin))
            }
        }
    }

    /// Adds an expression that covers these tokens.
    pub(super) fn add(&mut self, expression: Expression, origin: Origin) -> ReadOperand {
        ReadOperand { id: self.expressions.add(expression, origin), origin }
    }
}

/// True if the right operand of a waiting operator ends before this operator.
fn ends_before(waiting: &WaitingOperator, next: BinaryOperator) -> bool {
    let waiting = match waiting {
        WaitingOperator::Negate(_) => Binding::Sign,
        WaitingOperator::Binary(_, operator, _) => binding(*operator),
    };
    // Powers associate to the right, everything else to the left.
    next != BinaryOperator::Power && waiting >= binding(next)
}

fn binding(operator: BinaryOperator) -> Binding {
    match operator {
        BinaryOperator::Add | BinaryOperator::Subtract => Binding::Sum,
        BinaryOperator::Multiply | BinaryOperator::Divide | BinaryOperator::Remainder => Binding::Product,
        BinaryOperator::Power => Binding::Power,
    }
}
