//! Statements, one by one, to plain ones.

use super::body::translate_body;
use super::connectors::translate_connector;
use super::expressions::{plain_expression, translated_place, turning};
use super::gravity::{report_idle_gravity, translate_gravity};
use super::joints::translate_joint;
use super::lines::translate_line;
use super::messages;
use super::object::Body;
use super::plain::{Drawn, DrawnKind, LoadOrigin, Plain};
use super::translation::Translation;
use crate::syntax::ast::{
    Action, AstId, Declaration, Definition, Event, Expression, Friction, SceneStatement, Statement,
    StatementKind,
};

/// Translates all statements.
pub(super) fn translate(mut translation: Translation<'_>, mut declaration: Declaration) -> Plain {
    for statement in std::mem::take(&mut declaration.statements) {
        translation.origin = statement.origin;
        translate_statement(&mut translation, statement);
    }
    report_idle_gravity(&mut translation);
    translation.drawing.append(&mut translation.loads);
    Plain {
        declaration: Declaration {
            statements: translation.statements,
            expressions: translation.expressions,
            ..declaration
        },
        motions: translation.motions,
        drawing: translation.drawing,
        obligations: translation.obligations,
        joints: translation.joints,
        places: translation.places,
        mentioned: translation.mentioned,
    }
}

pub(super) fn translate_statement(translation: &mut Translation<'_>, statement: Statement) {
    match statement.kind {
        StatementKind::Scene(scene) => translate_scene(translation, scene),
        StatementKind::ForceAt { force, point } => translate_force(translation, force, point, statement),
        StatementKind::Torque { moment, angle } => translate_torque(translation, moment, angle, statement),
        kind => {
            if let StatementKind::Let(name, value) = &kind
                && let Some(body) = translation.body_of(*value)
            {
                translation.points.insert(name.text.clone(), body);
            }
            let kind = with_plain_expressions(translation, kind);
            translation.statements.push(Statement { kind, ..statement });
        }
    }
}

pub(super) fn translate_scene(translation: &mut Translation<'_>, statement: SceneStatement) {
    report_beside_lagrangian(translation, &statement);
    match statement {
        SceneStatement::Gravity(value) => translate_gravity(translation, value),
        SceneStatement::Body(body) => translate_body(translation, &body),
        SceneStatement::Line(line) => translate_line(translation, line),
        SceneStatement::Connector(connector) => translate_connector(translation, &connector),
        SceneStatement::Joint(joint) => translate_joint(translation, &joint),
    }
}

/// A Lagrangian says it all: no energy can be added to it.
pub(super) fn report_beside_lagrangian(translation: &mut Translation<'_>, statement: &SceneStatement) {
    let Some(lagrangian) = translation.lagrangian else { return };
    let (what, origin) = match statement {
        SceneStatement::Body(body) => (format!("body `{}`", body.name.text), body.name.span.into()),
        SceneStatement::Connector(connector) => (format!("`{}`", connector.kind.name()), translation.origin),
        _ => return,
    };
    let error = translation.report.error(origin, messages::beside_lagrangian(&what));
    error.related(lagrangian, messages::FIRST_DECLARED).help(messages::BESIDE_LAGRANGIAN_HELP);
}

pub(super) fn translate_force(
    translation: &mut Translation<'_>,
    force: AstId,
    point: AstId,
    statement: Statement,
) {
    let body = translation.body_of(point);
    let (force, point) = (plain_expression(translation, force), translated_place(translation, point));
    if is_in_plane(translation, force) && !translation.bodies.is_empty() {
        let (name, body) = ("force".to_owned(), body.map(|body| translation.bodies[body].name.text.clone()));
        let kind = DrawnKind::Force { name, cause: LoadOrigin::Applied, body };
        translation.loads.push(Drawn { kind, values: vec![point, force], needs: Vec::new() });
    }
    translation.statements.push(Statement { kind: StatementKind::ForceAt { force, point }, ..statement });
}

/// Not written as a vector in space.
pub(super) fn is_in_plane(translation: &Translation<'_>, force: AstId) -> bool {
    !matches!(translation.expressions.get(force), Expression::Tuple(components) if components.len() != 2)
}

pub(super) fn translate_torque(
    translation: &mut Translation<'_>,
    moment: AstId,
    angle: AstId,
    statement: Statement,
) {
    let body = translation.body_named(angle);
    let written = angle;
    let (moment, angle) = (plain_expression(translation, moment), turning(translation, angle));
    if translation.terms().is_zero(angle) {
        translation.report_no_turning(written, messages::TURNED_BY_TORQUE);
    }
    if let Some(body) = body {
        let Body { name, center, .. } = translation.bodies[body].clone();
        let kind = DrawnKind::Moment {
            name: "torque".to_owned(),
            cause: LoadOrigin::Applied,
            body: Some(name.text),
        };
        translation.loads.push(Drawn { kind, values: vec![center, moment], needs: Vec::new() });
    } else if !translation.bodies.is_empty() {
        let of = |id| match translation.expressions.get(id) {
            Expression::Name(name) => format!("`{name}`"),
            _ => "an angle".to_owned(),
        };
        let kind = DrawnKind::Torque { name: format!("torque on {}", of(written)) };
        translation.loads.push(Drawn { kind, values: vec![moment, angle], needs: Vec::new() });
    }
    translation.statements.push(Statement { kind: StatementKind::Torque { moment, angle }, ..statement });
}

/// The statement with every expression in plain words.
pub(super) fn with_plain_expressions(
    translation: &mut Translation<'_>,
    kind: StatementKind,
) -> StatementKind {
    use StatementKind as Kind;
    let mut plain = |id: AstId| plain_expression(translation, id);
    match kind {
        Kind::Parameters(list) => Kind::Parameters(definitions(list, plain)),
        Kind::Inputs(list) => Kind::Inputs(definitions(list, plain)),
        Kind::Constants(list) => Kind::Constants(definitions(list, plain)),
        Kind::Let(name, value) => Kind::Let(name, plain(value)),
        Kind::LetTuple(names, value) => Kind::LetTuple(names, plain(value)),
        Kind::Kinetic(value) => Kind::Kinetic(plain(value)),
        Kind::Potential(value) => Kind::Potential(plain(value)),
        Kind::Lagrangian(value) => Kind::Lagrangian(plain(value)),
        Kind::Dissipation(value) => Kind::Dissipation(plain(value)),
        Kind::Gibbs { function, stated } => Kind::Gibbs { function: plain(function), stated: plain(stated) },
        Kind::ForceOn(name, value) => Kind::ForceOn(name, plain(value)),
        Kind::Constraint(name, value) => Kind::Constraint(name, plain(value)),
        Kind::Stabilise(value) => Kind::Stabilise(plain(value)),
        Kind::Output(name, value) => Kind::Output(name, plain(value)),
        Kind::Event(event) => Kind::Event(with_plain_event(event, plain)),
        Kind::Friction(friction) => Kind::Friction(Friction {
            slip: plain(friction.slip),
            kinetic: plain(friction.kinetic),
            fixed: friction.fixed.map(&mut plain),
            width: friction.width.map(&mut plain),
            ..friction
        }),
        Kind::Reduce(mut reduction) => {
            for item in &mut reduction.items {
                item.value = item.value.map(&mut plain);
            }
            Kind::Reduce(reduction)
        }
        // These have been translated before.
        Kind::ForceAt { .. } | Kind::Torque { .. } | Kind::Scene(_) => kind,
        Kind::Coordinates(_) | Kind::Emit(_) => kind,
    }
}

fn definitions(list: Vec<Definition>, mut plain: impl FnMut(AstId) -> AstId) -> Vec<Definition> {
    let plain = |definition: Definition| Definition { value: definition.value.map(&mut plain), ..definition };
    list.into_iter().map(plain).collect()
}

fn with_plain_event(mut event: Event, mut plain: impl FnMut(AstId) -> AstId) -> Event {
    event.value = plain(event.value);
    match &mut event.action {
        Action::Impact(restitution) => *restitution = plain(*restitution),
        Action::Assign(assignments) => {
            for assignment in assignments {
                assignment.value = plain(assignment.value);
                assignment.target = plain(assignment.target);
            }
        }
        Action::Stop | Action::Record => {}
    }
    event
}
