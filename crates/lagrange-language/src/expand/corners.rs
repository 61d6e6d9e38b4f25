//! Contacts of the corners of a body as loops over these.
//!
//! `contact foot = case.corners on ground { … }` becomes
//! `for k in 0..8 { contact foot[k] = case.corner(k) on ground { … } }`, with the number of
//! corners that the shape of the body has. A body whose shape has corners stands for all of them.

use crate::syntax::ast::{
    ArrayExpression, AstId, Block, Declaration, Expression, Expressions, Name, Range, Repetition,
    SceneStatement, Shape, Statement, StatementKind,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::number::Number;

/// The variable of such a loop, which no identifier hides.
const VARIABLE: &str = "corner number";

/// Numbers of corners of bodies, by the names of these or of their arrays.
type CornerCounts = HashMap<String, usize>;

/// True if a contact is one of several corners.
pub(super) fn has_corners(declaration: &Declaration) -> bool {
    any_corners(&declaration.statements, &declaration.expressions)
}

fn any_corners(statements: &[Statement], expressions: &Expressions) -> bool {
    let counts = corner_counts(statements);
    let mut pending = vec![statements];
    while let Some(statements) = pending.pop() {
        for Statement { kind, .. } in statements {
            match kind {
                StatementKind::Block(Block::Part(part)) if any_corners(&part.body, expressions) => {
                    return true;
                }
                StatementKind::Block(block) => pending.extend(block.bodies()),
                kind if corners_of(kind, expressions, &counts).is_some() => return true,
                _ => {}
            }
        }
    }
    false
}

/// Replaces contacts of corners by loops. A part knows its own bodies only.
pub(super) fn loop_over_corners(statements: &mut [Statement], expressions: &mut Expressions) {
    let counts = corner_counts(statements);
    let mut pending = statements.iter_mut().collect::<Vec<_>>();
    while let Some(statement) = pending.pop() {
        if let Some((body, count)) = corners_of(&statement.kind, expressions, &counts) {
            repeat(statement, body, count, expressions);
        } else if let StatementKind::Block(block) = &mut statement.kind {
            match block {
                Block::Part(part) => loop_over_corners(&mut part.body, expressions),
                block => pending.extend(block.parts_mut().1.into_iter().flatten()),
            }
        }
    }
}

fn corner_counts(statements: &[Statement]) -> CornerCounts {
    let mut counts = CornerCounts::default();
    let mut pending = vec![statements];
    while let Some(statements) = pending.pop() {
        for Statement { kind, .. } in statements {
            match kind {
                StatementKind::Block(block) => pending.extend(block.bodies()),
                StatementKind::Scene(SceneStatement::Body(body)) => {
                    let count = body.shape.as_ref().map_or(0, Shape::corner_count);
                    counts.insert(body.name.text.clone(), count);
                }
                _ => {}
            }
        }
    }
    counts
}

/// The body whose corners touch, and their number.
fn corners_of(
    kind: &StatementKind,
    expressions: &Expressions,
    counts: &CornerCounts,
) -> Option<(AstId, usize)> {
    let StatementKind::Scene(SceneStatement::Contact(contact)) = kind else { return None };
    let body = match expressions.get(contact.object) {
        Expression::Component(body, part) if part.text == "corners" => *body,
        _ => contact.object,
    };
    let name = match expressions.get(body) {
        Expression::Name(name) => name,
        Expression::Array(ArrayExpression::Element(name)) => &name.text,
        _ => return None,
    };
    counts.get(name).copied().filter(|&count| count > 0).map(|count| (body, count))
}

/// `for k in 0..count { contact name[k] = body.corner(k) on … }`
fn repeat(statement: &mut Statement, body: AstId, count: usize, expressions: &mut Expressions) {
    let mut element = statement.clone();
    let StatementKind::Scene(SceneStatement::Contact(contact)) = &mut element.kind else { return };
    let origin = expressions.origin(contact.object);
    let mut add = |expression| expressions.add(expression, origin);
    let [from, to] = [0, count as i64].map(|number| add(Expression::Number(Number::from(number))));
    let number = add(Expression::Name(VARIABLE.to_owned()));
    contact.name.indices.push(number);
    contact.object = add(Expression::Call(Name::new("corner", origin.start), vec![body, number]));
    let variable = Name::new(VARIABLE, origin.start);
    let range = Range { from, to, is_inclusive: false };
    let repetition = Repetition { variable, range, body: vec![element] };
    statement.kind = StatementKind::Block(Block::Repeat(Box::new(repetition)));
}
