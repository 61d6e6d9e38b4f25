//! Rigid bodies in space in the statements of the plain language.
//!
//! Velocities are written recursively in the axes of each body ([`poses`]), as in the methods of Newton–Euler: ω and the velocity of the
//! origin follow from those of the carrier by a rotation and what the joint adds. T = ½ m v_S² + ½ ω·J ω of each body is then sparse, and
//! the equations that follow from it cost a fraction of those from rotation matrices and their rates. Places in the world are written
//! beside, for weights, points and outputs.
//!
//! Source: Featherstone, *Rigid Body Dynamics Algorithms*, ch. 4 and 5; Roberson, Schwertassek, *Dynamics of Multibody Systems*, ch. 5.

mod accelerations;
mod base_parameters;
mod bodies;
mod compound;
mod expressions;
mod gibbs;
mod inertia;
mod kinematics;
mod links;
mod loads;
mod messages;
mod mobilizers;
mod numbers;
mod orientations;
mod poses;
mod solids;
mod vectors;

pub(super) use bodies::{
    report_unplaced, translate_frame, translate_spatial_body, translate_spatial_gravity,
};
pub(super) use expressions::{
    call_of_link, in_axes, part_of_link, place_of_link, point_on_link, rate_of_link_point,
};
pub(super) use gibbs::push_gibbs_function;
pub(super) use kinematics::{Asked, kinematics_asked_for};
pub(super) use loads::{translate_spatial_force, translate_spatial_torque};
pub(super) use mobilizers::translate_spatial_mobilizer;
pub(super) use mobilizers::{coordinates_of, dampen};
pub(super) use numbers::is_no_vector;

use crate::collections::HashMap;
use crate::diagnostics::Origin;
use crate::syntax::ast::{
    AstId, Declaration, Expression, Expressions, MobilizerKind, Name, SceneStatement, StatementKind,
};
use accelerations::Relative;
use links::Link;
use vectors::Triple;

/// What is known of a scene in space.
#[derive(Default)]
pub(super) struct Space {
    pub(super) links: Vec<Link>,
    /// Bodies that nothing places.
    unplaced: Vec<Name>,
    /// Those that have their place, carriers first.
    order: Vec<usize>,
    gravity: Option<(Triple, Origin)>,
    /// Relative accelerations by angular velocity and angular acceleration of their frame.
    relatives: HashMap<[Triple; 2], Relative>,
    /// Names of `let`s that say where frames are and how they move: those that nothing needs are left out in the end.
    pub(super) kinematic: HashMap<String, ()>,
    /// Names of `let`s that are points of links, with the link and their own coordinates.
    pub(super) points: HashMap<String, (usize, Triple)>,
}

impl Space {
    /// The name of a body or frame.
    pub(super) fn name_of(&self, link: usize) -> &str {
        &self.links[link].name.text
    }
}

/// Whether the bodies of a declaration move in space: a vector in what is said of them has three components, or a joint leads out of the
/// plane.
pub(super) fn is_spatial(declaration: &Declaration) -> bool {
    let mut lets = HashMap::default();
    for statement in &declaration.statements {
        match &statement.kind {
            StatementKind::Let(name, value) => drop(lets.insert(name.text.clone(), *value)),
            StatementKind::Scene(scene) if leads_out_of_the_plane(scene) => return true,
            _ => {}
        }
    }
    let vectors = declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Scene(scene) => Some(vectors_of(scene)),
        _ => None,
    });
    vectors.flatten().any(|vector| has_three_components(&declaration.expressions, &lets, vector))
}

fn leads_out_of_the_plane(statement: &SceneStatement) -> bool {
    use MobilizerKind::{Cylindrical, Screw, Universal};
    match statement {
        SceneStatement::Body(body) => body.tensor.is_some() || body.angles.is_some(),
        SceneStatement::Mobilizer(joint) => matches!(joint.kind, Cylindrical | Screw | Universal),
        _ => false,
    }
}

/// What is a vector in a statement about bodies.
fn vectors_of(statement: &SceneStatement) -> Vec<AstId> {
    let given = match statement {
        SceneStatement::Gravity(value) => vec![Some(*value)],
        SceneStatement::Body(body) => {
            let places = body.parts.iter().flat_map(|part| [part.at, part.turned]);
            places.chain([body.inertia, body.center, body.origin, body.centroid]).collect()
        }
        SceneStatement::Mobilizer(joint) => vec![joint.at, joint.turned, joint.axis],
        _ => Vec::new(),
    };
    given.into_iter().flatten().collect()
}

fn has_three_components(expressions: &Expressions, lets: &HashMap<String, AstId>, root: AstId) -> bool {
    let mut pending = vec![root];
    // A name that stands for itself is a mistake that is reported elsewhere.
    let mut followed: HashMap<String, ()> = HashMap::default();
    while let Some(id) = pending.pop() {
        match expressions.get(id) {
            Expression::Tuple(components) => return components.len() == 3,
            Expression::Name(name) if followed.insert(name.clone(), ()).is_none() => {
                pending.extend(lets.get(name));
            }
            Expression::Negate(of) => pending.push(*of),
            Expression::Binary(_, _, left, right) => pending.extend([*left, *right]),
            _ => {}
        }
    }
    false
}
