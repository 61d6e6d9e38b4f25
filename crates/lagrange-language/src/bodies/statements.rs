//! Translation of statements to plain ones, one by one.

use super::body::translate_body;
use super::connectors::translate_connector;
use super::contacts::{default_compliance, mention_defaults, translate_contact};
use super::drawing::{Load, draw_force, draw_moment, torque_on};
use super::expressions::{plain_expression, translated_place, turning};
use super::gravity::{report_idle_gravity, translate_gravity};
use super::inertial::inertial_bodies;
use super::joints::translate_joint;
use super::lines::translate_line;
use super::messages;
use super::mobilizers::{report_waiting, translate_plane_mobilizer};
use super::object::{Body, WaitingBody};
use super::plain::{Drawn, DrawnKind, Plain, SpatialKinematics};
use super::space::{
    Asked, draw_force_on_coordinate, draw_scene, draw_torque_on_angle, kinematics_asked_for, point_on_link,
    push_gibbs_function, report_unplaced, translate_frame, translate_spatial_body, translate_spatial_force,
    translate_spatial_gravity, translate_spatial_mobilizer, translate_spatial_torque,
};
use super::surfaces::{declare_broken_surface, translate_surface};
use super::translation::Translation;
use super::unneeded::leave_out_unneeded;
use crate::syntax::ast::{
    self, AstId, ConnectorKind, Declaration, Expression, Expressions, JointKind, SceneStatement, Statement,
    StatementKind, SurfaceKind,
};

/// Translates all statements.
pub(super) fn translate(mut translation: Translation<'_>, mut declaration: Declaration) -> Plain {
    let (asked, has_regressor) = (Asked::of(&declaration), declaration.asks_for("regressor"));
    translation.compliance = default_compliance(&declaration.statements, translation.report);
    for statement in std::mem::take(&mut declaration.statements) {
        translation.origin = statement.origin;
        translate_statement(&mut translation, statement);
    }
    report_idle_gravity(&mut translation);
    report_waiting(&mut translation);
    report_unplaced(&mut translation);
    let mut inertial = Vec::new();
    let computed = |translation: &mut Translation<'_>| {
        push_gibbs_function(translation);
        if has_regressor {
            inertial = inertial_bodies(translation);
        }
    };
    Expressions::computed(&mut translation, |translation| &mut translation.expressions, computed);
    let in_space = kinematics_asked_for(&mut translation, asked);
    draw_scene(&mut translation);
    translation.drawing.append(&mut translation.loads);
    declaration.is_in_space = translation.space.take().is_some();
    let optional = std::mem::take(&mut translation.optional);
    let mut plain = Plain { inertial, ..plain_of(translation, declaration, in_space) };
    leave_out_unneeded(&mut plain, &optional);
    plain
}

fn plain_of(translation: Translation<'_>, declaration: Declaration, in_space: SpatialKinematics) -> Plain {
    Plain {
        declaration: Declaration {
            statements: translation.statements,
            expressions: translation.expressions,
            ..declaration
        },
        motions: translation.motions,
        in_space,
        inertial: Vec::new(),
        drawing: translation.drawing,
        obligations: translation.obligations,
        joints: translation.joints,
        places: translation.places,
        mentioned: translation.mentioned,
        heights: translation.heights,
    }
}

/// Replaces a statement by plain statements.
pub(super) fn translate_statement(translation: &mut Translation<'_>, statement: Statement) {
    match statement.kind {
        StatementKind::Scene(SceneStatement::Mobilizer(ref joint)) => {
            let joint = joint.clone();
            match translation.space {
                Some(_) => translate_spatial_mobilizer(translation, &joint, &statement),
                None => translate_plane_mobilizer(translation, &joint, &statement),
            }
        }
        StatementKind::Scene(SceneStatement::Contact(contact)) => {
            translate_contact(translation, &contact, &statement.docs);
        }
        StatementKind::Scene(scene) => translate_scene(translation, scene),
        StatementKind::ForceAt { force, point } => translate_force(translation, force, point, statement),
        StatementKind::Torque { moment, angle } => translate_torque(translation, moment, angle, statement),
        StatementKind::ForceOn(coordinate, value) if translation.space.is_some() => {
            let value = plain_expression(translation, value);
            draw_force_on_coordinate(translation, &coordinate.text, value);
            let kind = StatementKind::ForceOn(coordinate, value);
            translation.statements.push(Statement { kind, ..statement });
        }
        mut kind => {
            let named = kind.named_expressions(&translation.expressions).into_iter();
            let named = named.map(|(name, value)| (name.text.clone(), value)).collect::<Vec<_>>();
            for expression in kind.expressions_mut() {
                *expression = plain_expression(translation, *expression);
            }
            for (name, value) in named {
                note_point(translation, name, value);
            }
            translation.statements.push(Statement { kind, ..statement });
        }
    }
}

/// Records the body that a named point belongs to.
fn note_point(translation: &mut Translation<'_>, name: String, value: AstId) {
    if let Some(body) = translation.body_of(value) {
        translation.points.insert(name, body);
    } else if let Some(point) = point_on_link(translation, value)
        && let Some(space) = &mut translation.space
    {
        space.points.insert(name, point);
    }
}

/// Translates a statement about bodies, except joints that create coordinates.
pub(super) fn translate_scene(translation: &mut Translation<'_>, statement: SceneStatement) {
    report_beside_lagrangian(translation, &statement);
    let is_spatial = translation.space.is_some();
    if let Some(word) = word_of_the_plane(&statement).filter(|_| is_spatial) {
        let error = translation.report.error(translation.origin, messages::only_in_the_plane(word));
        error.help(messages::NOT_IN_SPACE_HELP);
        if let SceneStatement::Surface(surface) = &statement {
            declare_broken_surface(translation, surface);
        }
        return;
    }
    match statement {
        SceneStatement::Gravity(value) if is_spatial => translate_spatial_gravity(translation, value),
        SceneStatement::Gravity(value) => translate_gravity(translation, value),
        SceneStatement::Body(body) if is_spatial => translate_spatial_body(translation, &body),
        SceneStatement::Body(body) => translate_or_keep(translation, body),
        SceneStatement::Frame(name) if is_spatial => translate_frame(translation, &name),
        SceneStatement::Frame(name) => translation.waiting.push(WaitingBody::Frame(name)),
        SceneStatement::Surface(line) if line.kind == SurfaceKind::Line => translate_line(translation, line),
        SceneStatement::Surface(surface) => translate_surface(translation, &surface),
        SceneStatement::Connector(connector) => translate_connector(translation, &connector),
        SceneStatement::Joint(joint) => translate_joint(translation, &joint),
        // These are statements with separate documentation.
        SceneStatement::Mobilizer(_) | SceneStatement::Contact(_) => {}
        SceneStatement::Contacts(defaults) => mention_defaults(translation, &defaults),
    }
}

/// Translates a body in the plane, or keeps it if a joint is to place it.
fn translate_or_keep(translation: &mut Translation<'_>, body: Box<ast::Body>) {
    if let Some(sequence) = &body.sequence {
        let error = translation.report.error(sequence.span, messages::SEQUENCE_IN_THE_PLANE);
        error.help(messages::SEQUENCE_IN_THE_PLANE_HELP);
    }
    let is_given = |place: Option<AstId>| {
        // An unreadable place may be missing because a joint specifies it.
        place.is_some_and(|id| !matches!(translation.expressions.get(id), Expression::Invalid))
    };
    let is_placed = is_given(body.center) || is_given(body.origin);
    if is_placed || !translation.names.is_placed_by_joint(&body.name.text) {
        return translate_body(translation, &body);
    }
    if let Some(angle) = body.angle {
        let origin = translation.expressions.origin(angle);
        let error = translation.report.error(origin, messages::angle_beside_joint(&body.name.text));
        error.help(messages::ANGLE_BESIDE_JOINT_HELP);
    }
    let body = ast::Body { center: None, origin: None, ..*body };
    translation.waiting.push(WaitingBody::Body(Box::new(body)));
}

/// Returns the keyword of a statement that is invalid in space.
fn word_of_the_plane(statement: &SceneStatement) -> Option<&'static str> {
    match statement {
        SceneStatement::Surface(surface) => {
            Some(surface.kind.name()).filter(|_| !surface.kind.belongs_to(true))
        }
        SceneStatement::Joint(joint) => match joint.kind {
            JointKind::Pin { .. } => None,
            JointKind::Slide { .. } => Some("slide"),
            JointKind::Roll { .. } => Some("roll"),
        },
        SceneStatement::Connector(connector) => match connector.kind {
            ConnectorKind::Spring | ConnectorKind::Damper => None,
            ConnectorKind::TorsionSpring | ConnectorKind::TorsionDamper => Some(connector.kind.name()),
        },
        _ => None,
    }
}

/// Reports statements with energies next to a Lagrangian, which is already complete.
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
    if translation.space.is_some() {
        return translate_spatial_force(translation, force, point, statement);
    }
    let body = translation.body_of(point);
    let (force, point) = (plain_expression(translation, force), translated_place(translation, point));
    if is_in_plane(translation, force) && !translation.bodies.is_empty() {
        let body = body.map(|body| translation.bodies[body].name.text.clone());
        draw_force(translation, Load::applied("force", body), [point, force], &[]);
    }
    translation.statements.push(Statement { kind: StatementKind::ForceAt { force, point }, ..statement });
}

/// True unless a force is written as a vector in space.
pub(super) fn is_in_plane(translation: &Translation<'_>, force: AstId) -> bool {
    !matches!(translation.expressions.get(force), Expression::Tuple(components) if components.len() != 2)
}

pub(super) fn translate_torque(
    translation: &mut Translation<'_>,
    moment: AstId,
    angle: AstId,
    statement: Statement,
) {
    if let Some(link) = translation.link_named(angle) {
        return translate_spatial_torque(translation, moment, link, statement);
    }
    let body = translation.body_named(angle);
    let written = angle;
    let (moment, angle) = (plain_expression(translation, moment), turning(translation, angle));
    if translation.terms().is_zero(angle) {
        translation.report_no_turning(written, messages::TURNED_BY_TORQUE);
    }
    if let Some(body) = body {
        let Body { name, center, .. } = translation.bodies[body].clone();
        draw_moment(translation, Load::applied("torque", Some(name.text)), [center, moment]);
    } else if translation.space.is_some() {
        draw_torque_on_angle(translation, written, moment);
    } else if !translation.bodies.is_empty() {
        let kind = DrawnKind::Torque { name: torque_on(translation, written) };
        translation.loads.push(Drawn { kind, values: vec![moment, angle], needs: Vec::new() });
    }
    translation.statements.push(Statement { kind: StatementKind::Torque { moment, angle }, ..statement });
}
