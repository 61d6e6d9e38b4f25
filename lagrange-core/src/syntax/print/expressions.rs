//! Expressions as text.
//!
//! What is still to be written waits on a stack, so that chains of any length are printed without recursion.

use super::Printer;
use super::numbers::{Form, numeral};
use crate::expr::Relation;
use crate::syntax::ast::{AstId, BinaryOperator, Condition, Expression, Expressions};

/// Something to be written.
enum Piece {
    Text(String),
    /// An expression, in parentheses if it binds less tightly than this.
    Expression(AstId, Binding),
}

/// How tightly an expression holds together; larger is tighter.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    /// A condition, which reads badly within other expressions.
    Choice,
    Sum,
    Product,
    Sign,
    Power,
    Operand,
}

impl Printer<'_> {
    /// An expression.
    pub(super) fn expression(&mut self, id: AstId) {
        let mut waiting = vec![Piece::Expression(id, Binding::Choice)];
        while let Some(piece) = waiting.pop() {
            match piece {
                Piece::Text(text) => self.text(&text),
                Piece::Expression(id, least) => {
                    let pieces = pieces(self.expressions, id);
                    let pieces =
                        if binding(self.expressions, id) < least { bracketed(pieces) } else { pieces };
                    waiting.extend(pieces.into_iter().rev());
                }
            }
        }
    }
}

fn text(text: impl Into<String>) -> Piece {
    Piece::Text(text.into())
}

fn bracketed(pieces: Vec<Piece>) -> Vec<Piece> {
    let (open, close) = (text("("), text(")"));
    std::iter::once(open).chain(pieces).chain([close]).collect()
}

/// Expressions with a comma between them, in parentheses.
fn bracketed_list(ids: &[AstId]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for (i, id) in ids.iter().enumerate() {
        pieces.push(text(if i == 0 { "" } else { ", " }));
        pieces.push(Piece::Expression(*id, Binding::Choice));
    }
    bracketed(pieces)
}

fn binding(expressions: &Expressions, id: AstId) -> Binding {
    match expressions.get(id) {
        Expression::Number(number) => match numeral(number).1 {
            Form::Literal => Binding::Operand,
            Form::Negative => Binding::Sign,
            Form::Quotient => Binding::Product,
        },
        Expression::Negate(_) => Binding::Sign,
        Expression::Binary(operator, ..) => own_binding(*operator),
        Expression::If { .. } => Binding::Choice,
        Expression::Name(_) | Expression::Tuple(_) | Expression::Call(..) => Binding::Operand,
        Expression::Component(..) | Expression::Invalid => Binding::Operand,
    }
}

fn own_binding(operator: BinaryOperator) -> Binding {
    match operator {
        BinaryOperator::Add | BinaryOperator::Subtract => Binding::Sum,
        BinaryOperator::Multiply | BinaryOperator::Divide => Binding::Product,
        BinaryOperator::Power => Binding::Power,
    }
}

/// What the operands of an operator must be without parentheses.
fn operand_bindings(operator: BinaryOperator) -> (Binding, Binding) {
    match operator {
        BinaryOperator::Add | BinaryOperator::Subtract => (Binding::Sum, Binding::Product),
        BinaryOperator::Multiply | BinaryOperator::Divide => (Binding::Product, Binding::Sign),
        BinaryOperator::Power => (Binding::Operand, Binding::Sign),
    }
}

fn pieces(expressions: &Expressions, id: AstId) -> Vec<Piece> {
    match expressions.get(id) {
        Expression::Number(number) => vec![text(numeral(number).0)],
        Expression::Name(name) => vec![text(name.as_str())],
        Expression::Tuple(components) => bracketed_list(components),
        Expression::Negate(inner) => vec![text("-"), Piece::Expression(*inner, Binding::Sign)],
        Expression::Binary(operator, _, left, right) => {
            let (least_left, least_right) = operand_bindings(*operator);
            let sign = sign(*operator, [*left, *right].iter().all(|id| is_word(expressions, *id)));
            vec![Piece::Expression(*left, least_left), text(sign), Piece::Expression(*right, least_right)]
        }
        Expression::Call(function, arguments) => {
            std::iter::once(text(function.text.as_str())).chain(bracketed_list(arguments)).collect()
        }
        Expression::Component(vector, name) => {
            vec![receiver(expressions, *vector), text(format!(".{}", name.text))]
        }
        Expression::If { condition, then, otherwise } => choice(expressions, condition, *then, *otherwise),
        Expression::Invalid => vec![text("?")],
    }
}

/// What stands before a dot. A number takes brackets: the dot behind it would be read as a decimal point.
fn receiver(expressions: &Expressions, id: AstId) -> Piece {
    match expressions.get(id) {
        Expression::Number(number) => text(format!("({})", numeral(number).0)),
        _ => Piece::Expression(id, Binding::Operand),
    }
}

/// `if c { a } else { b }`, or `else if` behind the first block.
fn choice(expressions: &Expressions, condition: &Condition, then: AstId, otherwise: AstId) -> Vec<Piece> {
    let block = |id: AstId| [text("{ "), Piece::Expression(id, Binding::Choice), text(" }")];
    let mut pieces = vec![
        text("if "),
        Piece::Expression(condition.left, Binding::Sum),
        text(relation(condition.relation)),
        Piece::Expression(condition.right, Binding::Sum),
        text(" "),
    ];
    pieces.extend(block(then));
    pieces.push(text(" else "));
    match expressions.get(otherwise) {
        Expression::If { .. } => pieces.push(Piece::Expression(otherwise, Binding::Choice)),
        _ => pieces.extend(block(otherwise)),
    }
    pieces
}

/// Whether an expression is a single name or number.
fn is_word(expressions: &Expressions, id: AstId) -> bool {
    match expressions.get(id) {
        Expression::Name(_) => true,
        Expression::Number(number) => numeral(number).1 == Form::Literal,
        _ => false,
    }
}

/// An operator with the spaces around it; simple quotients have none.
fn sign(operator: BinaryOperator, between_words: bool) -> &'static str {
    match operator {
        BinaryOperator::Add => " + ",
        BinaryOperator::Subtract => " - ",
        BinaryOperator::Multiply => " * ",
        BinaryOperator::Divide if between_words => "/",
        BinaryOperator::Divide => " / ",
        BinaryOperator::Power => "^",
    }
}

fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => " < ",
        Relation::LessEqual => " <= ",
        Relation::Greater => " > ",
        Relation::GreaterEqual => " >= ",
    }
}
