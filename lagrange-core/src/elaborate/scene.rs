//! Conversion of statements on rigid bodies to the scene of a model.
//!
//! [`lagrange_language::bodies`] selects the relevant expressions. Here they are evaluated and
//! differentiated with respect to time, but only if a product that needs them is requested. The
//! equations of motion do not depend on the scene.

use super::elaborator::Elaborator;
use super::expression::value_of;
use super::messages::{self, scene};
use super::operand::Operand;
use super::scene_in_space::add_scene_in_space;
use super::scope::NameKind;
use super::staged::Staged;
use super::torques::torque_item;
use crate::model::BodyMotion;
use crate::model::DrawnItem;
use crate::model::InertialBody;
use crate::model::LinkPose;
use crate::model::OutlinedPart;
use crate::model::Product;
use crate::model::SampledHeight;
use lagrange_expr::expr::ExprId;
use lagrange_language::bodies;
use lagrange_language::bodies::Drawn;
use lagrange_language::bodies::DrawnKind;
use lagrange_language::bodies::Motion;
use lagrange_language::bodies::Outline;
use lagrange_language::bodies::Plain;
use lagrange_language::syntax::ast::AstId;
use lagrange_language::syntax::ast::Declaration;
use lagrange_language::syntax::ast::Name;

/// Adds the requested quantities of bodies to the model.
pub(super) fn add_scene(elaborator: &mut Elaborator<'_>, plain: &Plain) {
    elaborator.staged = staged(plain);
    add_scene_in_space(elaborator, &plain.in_space);
    let products = elaborator.products();
    let is_drawn = products.contains(&Product::Drawing);
    if products.iter().any(|product| product.needs_motions()) {
        let motions = plain.motions.iter().map(|motion| body_motion(elaborator, motion)).collect::<Vec<_>>();
        elaborator.scene.motions.extend(motions.into_iter().flatten());
    }
    let inertial = plain.inertial.iter().map(|body| inertial_body(elaborator, body)).collect::<Vec<_>>();
    elaborator.scene.inertial.extend(inertial.into_iter().flatten());
    // An unknown motion of a body has been reported.
    if is_drawn && elaborator.scene.motions.len() == plain.motions.len() + plain.in_space.motions.len() {
        add_drawing(elaborator, &plain.drawing);
    }
}

fn staged(plain: &Plain) -> Staged {
    let Declaration { bodies, is_in_space, .. } = &plain.declaration;
    let named = |is_frame: bool| {
        let bodies = bodies.iter().filter(|body| body.is_frame == is_frame);
        bodies.map(|body| body.name.clone()).collect()
    };
    Staged {
        bodies: named(false),
        frames: named(true),
        is_in_space: *is_in_space,
        is_visible: !plain.drawing.is_empty(),
    }
}

fn body_motion(elaborator: &mut Elaborator<'_>, motion: &Motion) -> Option<BodyMotion> {
    let known = [motion.mass, motion.inertia, motion.centroid, motion.center, motion.angle];
    let [position, angle] =
        [motion.center, motion.angle].map(|syntax| value_of(&mut elaborator.evaluator, syntax));
    let [position, angle] = [(motion.center, position?), (motion.angle, angle?)];
    let mut rate = |(syntax, value): &(AstId, Operand)| {
        elaborator.evaluator.rate(value, *syntax).map(|rate| (*syntax, rate))
    };
    let (velocity, spin) = (rate(&position)?, rate(&angle)?);
    let (acceleration, change) = (rate(&velocity)?, rate(&spin)?);
    let mut values = flattened(elaborator, &known)?;
    for (_, operand) in [velocity, spin, acceleration, change] {
        values.extend(operand.components());
    }
    let body = motion.body.clone();
    if values.len() != BodyMotion::VALUES[0] {
        let error = elaborator.evaluator.report.error(body.span, scene::not_in_the_plane(&body.text));
        error.help(scene::PLANE_HELP);
        return None;
    }
    Some(BodyMotion { body, values })
}

fn inertial_body(elaborator: &mut Elaborator<'_>, body: &bodies::InertialBody) -> Option<InertialBody> {
    let bodies::InertialBody { ref parameters, lagrangian, ref twist, ref change, .. } = *body;
    let [parameters, twist, change] =
        [&parameters[..], twist, change].map(|list| scalars_of(elaborator, list));
    Some(InertialBody {
        body: body.body.clone(),
        parameters: parameters?.try_into().ok()?,
        lagrangian: scalars_of(elaborator, &[lagrangian])?[0],
        twist: twist?.try_into().ok()?,
        change: change?.try_into().ok()?,
    })
}

/// Returns the values of scalars; others are reported.
fn scalars_of(elaborator: &mut Elaborator<'_>, syntax: &[AstId]) -> Option<Vec<ExprId>> {
    let scalar = |&id: &AstId| {
        value_of(&mut elaborator.evaluator, id)?;
        elaborator.evaluator.scalar(id, scene::DIMENSION)
    };
    syntax.iter().map(scalar).collect()
}

/// Returns the components of values, one after another.
fn flattened(elaborator: &mut Elaborator<'_>, values: &[AstId]) -> Option<Vec<ExprId>> {
    let values = values.iter().map(|&value| value_of(&mut elaborator.evaluator, value)).collect::<Vec<_>>();
    let values = values.into_iter().collect::<Option<Vec<_>>>()?;
    Some(values.iter().flat_map(|value| value.components().to_vec()).collect())
}

/// Adds the items to draw. Joints that the coordinates fulfil identically have no multipliers, so
/// their forces are omitted.
fn add_drawing(elaborator: &mut Elaborator<'_>, drawing: &[Drawn]) {
    let constraints = elaborator.constraints.iter().map(|(constraint, _)| constraint.name.clone());
    let constraints = constraints.collect::<Vec<_>>();
    let is_there = |name: &String| constraints.contains(name);
    let exists = |item: &Drawn| item.needs.is_empty() || item.needs.iter().any(is_there);
    let mut items: Vec<DrawnItem> = Vec::new();
    for item in drawing {
        match &item.kind {
            DrawnKind::Torque { name } => items.extend(torque_item(elaborator, name, &item.values)),
            DrawnKind::Force { name, .. } if !exists(item) => {
                let joint = name.split('.').next().unwrap_or(name);
                let is_said =
                    |other: &DrawnItem| matches!(&other.kind, DrawnKind::Omitted { name } if name == joint);
                if !items.iter().any(is_said) {
                    items.push(DrawnItem::omitted(joint));
                }
            }
            _ => items.extend(drawn_item(elaborator, item)),
        }
    }
    elaborator.scene.drawing = items;
    elaborator.scene.drawing.sort_by_key(|item| layer(&item.kind));
}

fn drawn_item(elaborator: &mut Elaborator<'_>, item: &Drawn) -> Option<DrawnItem> {
    let values = flattened(elaborator, &item.values)?;
    // Forces in space are not drawn in the plane.
    if values.len() != value_count(&item.kind, elaborator.staged.is_in_space) {
        return None;
    }
    let parts = match &item.kind {
        DrawnKind::Body { outlines, .. } => {
            outlines.iter().map(|outline| outlined_part(elaborator, outline)).collect::<Option<_>>()?
        }
        _ => Vec::new(),
    };
    let height = match &item.kind {
        DrawnKind::Surface { height: Some((variables, value)), .. } => {
            Some(sampled_height(elaborator, variables, *value)?)
        }
        _ => None,
    };
    Some(DrawnItem { kind: item.kind.clone(), values, parts, height })
}

/// Returns a height as an expression of symbols for its variables.
fn sampled_height(
    elaborator: &mut Elaborator<'_>,
    variables: &[String],
    value: AstId,
) -> Option<SampledHeight> {
    let mut roles = Vec::new();
    for name in variables {
        let symbol = elaborator.evaluator.graph.operand(name);
        roles.extend(elaborator.evaluator.graph.symbol_of(symbol).map(|symbol| symbol.role));
        let name = Name::new(name.clone(), elaborator.declaration.name.span);
        elaborator.declare(&name, NameKind::Coordinate, Some(Operand::Scalar(symbol)));
    }
    let value = scalars_of(elaborator, &[value])?[0];
    Some(SampledHeight { variables: roles, value })
}

fn outlined_part(elaborator: &mut Elaborator<'_>, outline: &Outline) -> Option<OutlinedPart> {
    let Outline { variant, ref dimensions, ref place, is_hole } = *outline;
    let written = dimensions.len();
    let dimensions = match elaborator.staged.is_in_space {
        true => scalars_of(elaborator, dimensions)?,
        false => flattened(elaborator, dimensions)?,
    };
    let (has_corners, dimension_count) = (dimensions.len() > written, dimensions.len());
    let values = [dimensions, flattened(elaborator, place)?].concat();
    Some(OutlinedPart { variant, has_corners, dimension_count, values, is_hole })
}

/// Checks that no two methods have the same name.
pub(super) fn check_names_of_bodies(elaborator: &mut Elaborator<'_>) {
    let products = elaborator.products();
    // Bodies may be called `parameter` or `tangent`.
    let others = products.iter().filter(|product| product.is_method()).map(|product| product.name());
    let mut others = others.collect::<Vec<_>>();
    others.extend((!elaborator.constraints.is_empty()).then_some("redundant_motion"));
    for product in products {
        let report = &mut *elaborator.evaluator.report;
        for (body, method) in elaborator.staged.methods(product) {
            if others.contains(&method.as_str()) {
                let what = if elaborator.staged.is_frame(&body.text) { "a frame" } else { "a body" };
                let error = report.error(body.span, scene::reserved_body(what, &body.text, &method));
                error.help(messages::OTHER_NAME_HELP);
            }
            for name in elaborator.declaration.outputs().filter(|name| name.text == method) {
                let error = report.error(name.span, messages::reserved_output(&name.text));
                error.help(messages::OTHER_NAME_HELP);
            }
        }
    }
}

/// Returns the number of values of an item.
fn value_count(kind: &DrawnKind, is_in_space: bool) -> usize {
    let (vector, moment) = if is_in_space { (3, 3) } else { (2, 1) };
    match kind {
        DrawnKind::Body { .. } | DrawnKind::Omitted { .. } => 0,
        DrawnKind::Joint { .. } => vector,
        DrawnKind::Torque { .. } => 2,
        DrawnKind::Surface { kind, .. } => {
            let rotation = if is_in_space { 9 } else { 1 };
            vector + rotation + usize::from(kind.labels().contains(&"radius"))
        }
        DrawnKind::Cone { .. } => 2 * vector + 1,
        DrawnKind::Moment { .. } => vector + moment,
        DrawnKind::Force { .. } | DrawnKind::SpatialJoint { .. } => 2 * vector,
        DrawnKind::Connector { .. } => 2 * vector + 1,
        DrawnKind::Frame { .. } => LinkPose::VALUES,
    }
}

/// Returns the layer of an item: lower layers are drawn first, below the others.
fn layer(kind: &DrawnKind) -> u8 {
    match kind {
        DrawnKind::Surface { .. } => 0,
        DrawnKind::Body { .. } | DrawnKind::Frame { .. } => 1,
        DrawnKind::Connector { .. } => 2,
        DrawnKind::Joint { .. } | DrawnKind::SpatialJoint { .. } => 3,
        DrawnKind::Cone { .. } => 4,
        DrawnKind::Force { .. } | DrawnKind::Moment { .. } | DrawnKind::Torque { .. } => 5,
        DrawnKind::Omitted { .. } => 6,
    }
}
