//! Detection of plane and spatial scenes.

use super::solids;
use crate::syntax::ast::AstId;
use crate::syntax::ast::Declaration;
use crate::syntax::ast::Expression;
use crate::syntax::ast::Expressions;
use crate::syntax::ast::SceneStatement;
use crate::syntax::ast::StatementKind;
use crate::syntax::ast::SurfaceKind;
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;

/// True if the bodies of a declaration move in space: their vectors have three components, or
/// something leads out of the plane.
pub(in crate::bodies) fn is_spatial(declaration: &Declaration) -> bool {
    let mut lets = HashMap::default();
    for statement in &declaration.statements {
        for (name, value) in statement.kind.named_expressions(&declaration.expressions) {
            lets.insert(name.text.clone(), value);
        }
    }
    let scene = declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Scene(scene) => Some(scene),
        _ => None,
    });
    if scene.clone().any(leads_out_of_the_plane) {
        return true;
    }
    // In an inconsistent scene, the majority of vectors decides.
    let mut votes = 0;
    for scene in scene {
        let weight = if matches!(scene, SceneStatement::Gravity(_)) { 2 } else { 1 };
        for vector in vectors_of(scene) {
            match component_count(&declaration.expressions, &lets, vector) {
                Some(3) => votes += weight,
                Some(2) => votes -= weight,
                _ => {}
            }
        }
    }
    votes > 0
}

fn leads_out_of_the_plane(statement: &SceneStatement) -> bool {
    match statement {
        SceneStatement::Body(body) => {
            let shapes = body.shape.iter().chain(body.parts.iter().map(|part| &part.shape));
            body.tensor.is_some() || body.angles.is_some() || shapes.into_iter().any(solids::is_only_in_space)
        }
        SceneStatement::Mobilizer(joint) => joint.kind.leads_out_of_the_plane(),
        SceneStatement::Gravity(_)
        | SceneStatement::Frame(_)
        | SceneStatement::Surface(_)
        | SceneStatement::Contact(_)
        | SceneStatement::Contacts(_)
        | SceneStatement::Connector(_)
        | SceneStatement::Joint(_) => false,
    }
}

/// Returns the vectors in a statement about bodies.
fn vectors_of(statement: &SceneStatement) -> Vec<AstId> {
    let given = match statement {
        SceneStatement::Gravity(value) => vec![Some(*value)],
        SceneStatement::Body(body) => {
            let places = body.parts.iter().flat_map(|part| [part.at, part.turned]);
            places.chain([body.inertia, body.center, body.origin, body.centroid]).collect()
        }
        SceneStatement::Mobilizer(joint) => vec![joint.at, joint.turned, joint.axis],
        SceneStatement::Surface(surface) if surface.kind != SurfaceKind::Line => {
            vec![surface.place, surface.direction]
        }
        SceneStatement::Frame(_)
        | SceneStatement::Surface(_)
        | SceneStatement::Contact(_)
        | SceneStatement::Contacts(_)
        | SceneStatement::Connector(_)
        | SceneStatement::Joint(_) => Vec::new(),
    };
    given.into_iter().flatten().collect()
}

/// Returns the number of components of a vector, if its form shows it.
fn component_count(expressions: &Expressions, lets: &HashMap<String, AstId>, root: AstId) -> Option<usize> {
    let mut pending = vec![root];
    // A name defined by itself is an error that is reported elsewhere.
    let mut followed: HashSet<String> = HashSet::default();
    while let Some(id) = pending.pop() {
        match expressions.get(id) {
            Expression::Tuple(components) => return Some(components.len()),
            Expression::Name(name) if followed.insert(name.clone()) => {
                pending.extend(lets.get(name));
            }
            Expression::Negate(of) => pending.push(*of),
            Expression::Binary(_, _, left, right) => pending.extend([*left, *right]),
            _ => {}
        }
    }
    None
}
