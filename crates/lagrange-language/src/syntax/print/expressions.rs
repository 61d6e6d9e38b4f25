//! Expressions as text.
//!
//! Remaining expressions wait on a stack, so that chains of any length are printed without
//! recursion.

use super::Printer;
use super::numbers::{Form, numeral};
use crate::syntax::ast::{
    ArrayExpression, AstId, BinaryOperator, CombinedCondition, Comparison, Condition, Expression,
    Expressions, IN_AXES, Range, TestKind,
};

/// Piece to be printed.
enum PrintedPiece {
    Text(String),
    /// An expression, in parentheses if it binds less tightly than this.
    Expression(AstId, PrintedBinding),
}

/// Binding strength of an expression; larger is tighter.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum PrintedBinding {
    /// A condition, which reads badly within other expressions.
    Choice,
    Sum,
    Product,
    Sign,
    Power,
    Operand,
}

impl Printer<'_> {
    /// Prints an expression.
    pub(super) fn expression(&mut self, id: AstId) {
        self.pieces(vec![PrintedPiece::Expression(id, PrintedBinding::Choice)]);
    }

    /// Prints a condition on indices.
    pub(super) fn index_condition(&mut self, condition: &CombinedCondition) {
        self.pieces(index_condition(condition));
    }

    fn pieces(&mut self, mut waiting: Vec<PrintedPiece>) {
        waiting.reverse();
        while let Some(piece) = waiting.pop() {
            match piece {
                PrintedPiece::Text(text) => self.text(&text),
                PrintedPiece::Expression(id, least) => {
                    let pieces = pieces(self.expressions, id);
                    let pieces =
                        if binding(self.expressions, id) < least { bracketed(pieces) } else { pieces };
                    waiting.extend(pieces.into_iter().rev());
                }
            }
        }
    }
}

fn text(text: impl Into<String>) -> PrintedPiece {
    PrintedPiece::Text(text.into())
}

fn bracketed(pieces: Vec<PrintedPiece>) -> Vec<PrintedPiece> {
    let (open, close) = (text("("), text(")"));
    std::iter::once(open).chain(pieces).chain([close]).collect()
}

/// Returns expressions separated by commas, in parentheses.
fn bracketed_list(ids: &[AstId]) -> Vec<PrintedPiece> {
    let mut pieces = Vec::new();
    for (i, id) in ids.iter().enumerate() {
        pieces.push(text(if i == 0 { "" } else { ", " }));
        pieces.push(PrintedPiece::Expression(*id, PrintedBinding::Choice));
    }
    bracketed(pieces)
}

fn binding(expressions: &Expressions, id: AstId) -> PrintedBinding {
    match expressions.get(id) {
        Expression::Number(number) => match numeral(number).1 {
            Form::Literal => PrintedBinding::Operand,
            Form::Negative => PrintedBinding::Sign,
            Form::Quotient => PrintedBinding::Product,
        },
        Expression::Quantity(..) => PrintedBinding::Operand,
        Expression::Negate(_) => PrintedBinding::Sign,
        Expression::Binary(operator, ..) => own_binding(*operator),
        Expression::If { .. } | Expression::Array(ArrayExpression::Select { .. }) => PrintedBinding::Choice,
        Expression::Call(function, _) if function.text == IN_AXES => PrintedBinding::Choice,
        Expression::Name(_) | Expression::Tuple(_) | Expression::Call(..) => PrintedBinding::Operand,
        Expression::Component(..) | Expression::Entry { .. } => PrintedBinding::Operand,
        Expression::Array(_) | Expression::Invalid => PrintedBinding::Operand,
    }
}

fn own_binding(operator: BinaryOperator) -> PrintedBinding {
    match operator {
        BinaryOperator::Add | BinaryOperator::Subtract => PrintedBinding::Sum,
        BinaryOperator::Multiply | BinaryOperator::Divide | BinaryOperator::Remainder => {
            PrintedBinding::Product
        }
        BinaryOperator::Power => PrintedBinding::Power,
    }
}

/// Returns the binding strengths that the operands of an operator need to be without parentheses.
fn operand_bindings(operator: BinaryOperator) -> (PrintedBinding, PrintedBinding) {
    match operator {
        BinaryOperator::Add | BinaryOperator::Subtract => (PrintedBinding::Sum, PrintedBinding::Product),
        BinaryOperator::Multiply | BinaryOperator::Divide | BinaryOperator::Remainder => {
            (PrintedBinding::Product, PrintedBinding::Sign)
        }
        BinaryOperator::Power => (PrintedBinding::Operand, PrintedBinding::Sign),
    }
}

fn pieces(expressions: &Expressions, id: AstId) -> Vec<PrintedPiece> {
    match expressions.get(id) {
        Expression::Number(number) => vec![text(numeral(number).0)],
        // In brackets, since names of units may also be names of parameters.
        Expression::Quantity(number, unit) => {
            vec![PrintedPiece::Expression(*number, PrintedBinding::Operand), text(format!(" [{unit}]"))]
        }
        Expression::Name(name) => vec![text(name.as_str())],
        Expression::Tuple(components) => bracketed_list(components),
        Expression::Negate(inner) => vec![text("-"), PrintedPiece::Expression(*inner, PrintedBinding::Sign)],
        Expression::Binary(operator, _, left, right) => {
            let (least_left, least_right) = operand_bindings(*operator);
            let sign = sign(*operator, [*left, *right].iter().all(|id| is_word(expressions, *id)));
            vec![
                PrintedPiece::Expression(*left, least_left),
                text(sign),
                PrintedPiece::Expression(*right, least_right),
            ]
        }
        Expression::Call(function, arguments) if function.text == IN_AXES && arguments.len() == 2 => vec![
            PrintedPiece::Expression(arguments[0], PrintedBinding::Sum),
            text(" in "),
            PrintedPiece::Expression(arguments[1], PrintedBinding::Operand),
        ],
        Expression::Call(function, arguments) => {
            let name = std::iter::once(text(function.text.as_str())).chain(indexed(&function.indices));
            name.chain(bracketed_list(arguments)).collect()
        }
        Expression::Component(vector, name) => {
            let member = [receiver(expressions, *vector), text(format!(".{}", name.text))].into_iter();
            member.chain(indexed(&name.indices)).collect()
        }
        Expression::Entry { of, indices, .. } => {
            std::iter::once(receiver(expressions, *of)).chain(indexed(indices)).collect()
        }
        Expression::If { condition, then, otherwise } => {
            choice(expressions, condition_pieces(condition), *then, *otherwise)
        }
        Expression::Array(ArrayExpression::Select { condition, then, otherwise }) => {
            choice(expressions, index_condition(condition), *then, *otherwise)
        }
        Expression::Array(array) => array_pieces(array),
        Expression::Invalid => vec![text("?")],
    }
}

/// Returns `[i][j]`.
fn indexed(indices: &[AstId]) -> impl Iterator<Item = PrintedPiece> {
    indices
        .iter()
        .flat_map(|index| [text("["), PrintedPiece::Expression(*index, PrintedBinding::Choice), text("]")])
}

fn array_pieces(array: &ArrayExpression) -> Vec<PrintedPiece> {
    let whole = |id: AstId| PrintedPiece::Expression(id, PrintedBinding::Choice);
    match array {
        ArrayExpression::Element(name) => {
            std::iter::once(text(name.text.as_str())).chain(indexed(&name.indices)).collect()
        }
        ArrayExpression::Fold { fold, variable, range, term } => vec![
            text(format!("{}({} in ", fold.word(), variable.text)),
            whole(range.from),
            text(dots(range)),
            whole(range.to),
            text(", "),
            whole(*term),
            text(")"),
        ],
        ArrayExpression::List(elements) => {
            let mut pieces = bracketed_list(elements);
            let last = pieces.len() - 1;
            (pieces[0], pieces[last]) = (text("["), text("]"));
            pieces
        }
        ArrayExpression::Select { condition, .. } => index_condition(condition),
    }
}

/// Returns the text between the ends of a range.
pub(super) fn dots(range: &Range) -> &'static str {
    if range.is_inclusive { "..=" } else { ".." }
}

/// Returns the text before a dot. A number is parenthesised, since the dot after it would be read
/// as a decimal point.
fn receiver(expressions: &Expressions, id: AstId) -> PrintedPiece {
    match expressions.get(id) {
        Expression::Number(number) => text(format!("({})", numeral(number).0)),
        _ => PrintedPiece::Expression(id, PrintedBinding::Operand),
    }
}

/// Returns `if c { a } else { b }`, or `else if` after the first block.
fn choice(
    expressions: &Expressions,
    condition: Vec<PrintedPiece>,
    then: AstId,
    otherwise: AstId,
) -> Vec<PrintedPiece> {
    let block = |id: AstId| [text("{ "), PrintedPiece::Expression(id, PrintedBinding::Choice), text(" }")];
    let mut pieces = vec![text("if ")];
    pieces.extend(condition);
    pieces.push(text(" "));
    pieces.extend(block(then));
    pieces.push(text(" else "));
    match binding(expressions, otherwise) {
        PrintedBinding::Choice => pieces.push(PrintedPiece::Expression(otherwise, PrintedBinding::Choice)),
        _ => pieces.extend(block(otherwise)),
    }
    pieces
}

fn condition_pieces(condition: &Condition) -> Vec<PrintedPiece> {
    compared(condition.left, condition.relation, condition.right)
}

fn compared(left: AstId, comparison: Comparison, right: AstId) -> Vec<PrintedPiece> {
    let side = |id| PrintedPiece::Expression(id, PrintedBinding::Sum);
    vec![side(left), text(format!(" {} ", comparison.sign())), side(right)]
}

/// Returns `i > 0 && i < n || …`.
fn index_condition(condition: &CombinedCondition) -> Vec<PrintedPiece> {
    let mut pieces = Vec::new();
    for (number, tests) in condition.alternatives.iter().enumerate() {
        pieces.push(text(if number == 0 { "" } else { " || " }));
        for (number, test) in tests.iter().enumerate() {
            pieces.push(text(if number == 0 { "" } else { " && " }));
            pieces.push(text(if test.is_negated { "!" } else { "" }));
            pieces.extend(match &test.kind {
                TestKind::Comparison(left, comparison, right) => compared(*left, *comparison, *right),
                TestKind::Nested(condition) => bracketed(index_condition(condition)),
            });
        }
    }
    pieces
}

/// True if an expression is a single name or number.
fn is_word(expressions: &Expressions, id: AstId) -> bool {
    match expressions.get(id) {
        Expression::Name(_) => true,
        Expression::Number(number) => numeral(number).1 == Form::Literal,
        _ => false,
    }
}

/// Returns an operator with the spaces around it; simple quotients have none.
fn sign(operator: BinaryOperator, between_words: bool) -> &'static str {
    match operator {
        BinaryOperator::Add => " + ",
        BinaryOperator::Subtract => " - ",
        BinaryOperator::Multiply => " * ",
        BinaryOperator::Divide if between_words => "/",
        BinaryOperator::Divide => " / ",
        BinaryOperator::Power => "^",
        BinaryOperator::Remainder => " % ",
    }
}
