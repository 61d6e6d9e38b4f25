//! Contacts of the corners of a body as loops over these.
//!
//! `contact foot = case.corners on ground { … }` becomes
//! `for k in 0..8 { contact foot[k] = case.corner(k) on ground { … } }`, with the number of
//! corners that the shape of the body has. A body whose shape has corners stands for all of them.
//!
//! Cuboids and rods on each other touch in contact points, which are numbered in the same way. Two
//! cuboids have up to eight of them, a rod has two, and a ball on one of them has one.
//!
//! A cylinder on anything else touches with the rims of its two ends.

use crate::syntax::ast::{
    ArrayExpression, AstId, Block, CONTACT_POINT, Contact, Declaration, END, Expression, Expressions, Name,
    Range, Repetition, SceneStatement, Shape, Statement, StatementKind,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::number::Number;

/// The variable of such a loop, which no identifier hides.
const VARIABLE: &str = "corner number";

/// Contact points of two cuboids, of a rod with a cuboid or another rod, and of a ball with one of
/// them.
const POINTS_OF_CUBOIDS: usize = 8;
const POINTS_OF_RODS: usize = 2;
const POINTS_OF_BALLS: usize = 1;
const ENDS_OF_CYLINDERS: usize = 2;

/// The points in which a shape may touch.
#[derive(Clone, Copy, Default)]
struct PointCounts {
    corners: usize,
    /// Contact points with cuboids.
    points: usize,
    /// True if edges touch it between their ends, where no corner is.
    is_cylinder: bool,
    /// Ends of a cylinder in space.
    ends: usize,
}

/// Numbers of points by the names of bodies or of their arrays.
type CornerCounts = HashMap<String, PointCounts>;

/// Touching points: a function of a body, and the number of its values.
struct Numbered {
    body: AstId,
    function: &'static str,
    count: usize,
}

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
        if let Some(numbered) = corners_of(&statement.kind, expressions, &counts) {
            repeat(statement, &numbered, expressions);
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
                    let count = body.shape.as_ref().map(PointCounts::of).unwrap_or_default();
                    counts.insert(body.name.text.clone(), count);
                }
                _ => {}
            }
        }
    }
    counts
}

impl PointCounts {
    fn of(shape: &Shape) -> Self {
        let is_cylinder = matches!(shape.solid.text.as_str(), "solid_cylinder" | "hollow_cylinder");
        let ends = match (shape.solid.text.as_str(), shape.dimensions.len()) {
            ("solid_cylinder", 2) | ("hollow_cylinder", 3) => ENDS_OF_CYLINDERS,
            _ => 0,
        };
        PointCounts { corners: shape.corner_count(), points: contact_points(shape), is_cylinder, ends }
    }
}

/// Returns the number of points in which a shape touches a cuboid with its faces and edges.
fn contact_points(shape: &Shape) -> usize {
    match (shape.solid.text.as_str(), shape.dimensions.len()) {
        ("cuboid", 3) => POINTS_OF_CUBOIDS,
        ("slender_rod", 1) => POINTS_OF_RODS,
        ("solid_sphere" | "thin_sphere", 1) => POINTS_OF_BALLS,
        _ => 0,
    }
}

/// Returns the body whose corners or contact points touch, and their number.
fn corners_of(kind: &StatementKind, expressions: &Expressions, counts: &CornerCounts) -> Option<Numbered> {
    let StatementKind::Scene(SceneStatement::Contact(contact)) = kind else { return None };
    let (body, is_whole) = match expressions.get(contact.object) {
        Expression::Component(body, part) if part.text == "corners" => (*body, false),
        _ => (contact.object, true),
    };
    let name = match expressions.get(body) {
        Expression::Name(name) => name,
        Expression::Array(ArrayExpression::Element(name)) => &name.text,
        _ => return None,
    };
    let PointCounts { corners, points, ends, .. } = *counts.get(name)?;
    if ends > 0 && is_whole && has_ends(contact, counts) {
        return Some(Numbered { body, function: END, count: ends });
    }
    let surface = counts.get(&contact.surface.text).copied().unwrap_or_default();
    let is_in_ball = contact.is_inside && surface.points == POINTS_OF_BALLS;
    let have_edges = points.max(surface.points) > POINTS_OF_BALLS;
    let (function, count) = match (is_whole, points.min(surface.points)) {
        (true, fewer) if fewer > 0 && have_edges && !is_in_ball => (CONTACT_POINT, fewer),
        (true, _) if surface.is_cylinder && !contact.is_inside => return None,
        _ => ("corner", corners),
    };
    (count > 0).then_some(Numbered { body, function, count })
}

/// True if a cylinder touches with its ends: on no other body, and without a radius or a rim.
fn has_ends(contact: &Contact, counts: &CornerCounts) -> bool {
    !counts.contains(&contact.surface.text) && contact.radius.or(contact.rim).is_none()
}

/// Writes `for k in 0..count { contact name[k] = body.corner(k) on … }`.
fn repeat(statement: &mut Statement, numbered: &Numbered, expressions: &mut Expressions) {
    let &Numbered { body, function, count } = numbered;
    let mut element = statement.clone();
    let StatementKind::Scene(SceneStatement::Contact(contact)) = &mut element.kind else { return };
    let origin = expressions.origin(contact.object);
    let mut add = |expression| expressions.add(expression, origin);
    let [from, to] = [0, count as i64].map(|number| add(Expression::Number(Number::from(number))));
    let number = add(Expression::Name(VARIABLE.to_owned()));
    contact.name.indices.push(number);
    contact.object = add(Expression::Call(Name::new(function, origin.start), vec![body, number]));
    let variable = Name::new(VARIABLE, origin.start);
    let range = Range { from, to, is_inclusive: false };
    let repetition = Repetition { variable, range, body: vec![element] };
    statement.kind = StatementKind::Block(Block::Repeat(Box::new(repetition)));
}
