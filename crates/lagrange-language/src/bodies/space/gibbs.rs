//! The Gibbs function of bodies on joints: their equations of motion in terms of accelerations, as
//! in the recursive Newton–Euler algorithm.
//!
//! A body has the mass m, the first moment h and the tensor J about its origin. It contributes S =
//! ½ m a² + a·A h + ½ α·J α + α·(ω × J ω), with the accelerations of [`super::accelerations`] in
//! its own axes. Then ∂S/∂a = m a + A h is the force on it, and ∂S/∂α = J α + h × a + ω × J ω the
//! moment about its origin. Since the ground accelerates by −g, weights are included. With
//! [`super::base_parameters`] most entries of h and J are zero.
//!
//! Source: Gibbs, "On the fundamental formulae of dynamics", Am. J. Math. 2 (1879); Lurie, *Analytical
//! Mechanics*, §7.9.

use super::accelerations::{accelerations_on_path, relative};
use super::frames::{Acceleration, Pose, Relative};
use super::links::Link;
use super::poses::link_at;
use super::regrouping::{WrittenParameters, regrouped};
use super::vectors::{Tensor, Triple, apply, inner};
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, Statement, StatementKind};
use lagrange_expr::accuracy::Accuracy;

/// Maximum number of degrees of freedom for which energies are more accurate at the level `strict`.
/// Terms that cancel in their mass matrix are then found.
const FEW: usize = 3;

/// Writes the Gibbs function of all bodies that are placed by joints, unless the user states the
/// Lagrangian.
pub(in crate::bodies) fn push_gibbs_function(translation: &mut Translation<'_>) {
    if translation.lagrangian.is_some() || translation.report.has_errors() {
        return;
    }
    let Some(space) = &translation.space else { return };
    if translation.accuracy == Accuracy::Strict && freedoms(translation) <= FEW {
        return;
    }
    let order = space.order.clone();
    if !order.iter().any(|&link| space.links[link].path.is_some() && space.links[link].inertia.is_some()) {
        return;
    }
    // If numbers are too large, energies may still work.
    let Some(parameters) = regrouped(translation, &order) else { return };
    let (mut functions, mut stated) = (Vec::new(), Vec::new());
    for link in order {
        let Some(found) = accelerations_on_path(translation, link) else { return };
        let is_at_rest = link_at(translation, link)
            .and_then(|link| link.placed)
            .is_some_and(|(pose, _)| pose.is_at_rest(&translation.terms()));
        if is_at_rest {
            // A body welded to the ground has no equations.
            continue;
        }
        for (frame, parameters) in found.into_iter().zip(&parameters[link]) {
            functions
                .extend(parameters.map(|parameters| gibbs_of_frame(translation, link, frame, parameters)));
        }
        stated.push(lagrangian_of_link(translation, link));
    }
    if functions.is_empty() {
        return;
    }
    let mut terms = translation.terms();
    let (function, stated) = (sum_of(&mut terms, &functions), sum_of(&mut terms, &stated));
    translation.push(StatementKind::Gibbs { function, stated });
}

/// Returns the number of declared velocities.
fn freedoms(translation: &Translation<'_>) -> usize {
    let of_statement = |statement: &Statement| match &statement.kind {
        StatementKind::Coordinates(names) => names.len(),
        StatementKind::Quaternion(quaternion) => quaternion.velocities.len(),
        _ => 0,
    };
    translation.statements.iter().map(of_statement).sum()
}

fn sum_of(terms: &mut TermWriter<'_>, values: &[AstId]) -> AstId {
    let zero = terms.number(0);
    values.iter().fold(zero, |sum, &value| terms.plus(sum, value))
}

/// Returns T − V of a body on a joint whose mass does not change, from the names of its energies.
fn lagrangian_of_link(translation: &mut Translation<'_>, link: usize) -> AstId {
    let is_fixed = |link: &Link| link.inertia.is_none_or(|inertia| !inertia.changes);
    let link = link_at(translation, link).filter(|link| link.path.is_some() && is_fixed(link));
    let energies = link.map(|link| link.energies).unwrap_or_default();
    energies.lagrangian(&mut translation.terms())
}

/// Returns ½ m a² + a·A h + ½ α·J α + α·(ω × J ω), under a name.
fn gibbs_of_frame(
    translation: &mut Translation<'_>,
    link: usize,
    (pose, acceleration): (Pose, Acceleration),
    parameters: WrittenParameters,
) -> AstId {
    let name = link_at(translation, link).map_or_else(String::new, |link| link.name.text);
    let relative = relative(translation, &name, [pose.spin, acceleration.spin]);
    let WrittenParameters { mass, moment, tensor } = parameters;
    let mut terms = translation.terms();
    let mut parts = Vec::new();
    for component in acceleration.origin {
        if terms.is_zero(component) {
            continue;
        }
        let (half, square) = (terms.half(), terms.square(component));
        let weight = terms.times(half, mass);
        parts.push(terms.times(weight, square));
    }
    let carried = apply(&mut terms, relative.matrix, moment);
    parts.push(inner(&mut terms, acceleration.origin, carried));
    parts.extend(rotational_parts(&mut terms, tensor, acceleration.spin, &relative));
    let function = sum_of(&mut terms, &parts);
    match terms.is_zero(function) {
        true => function,
        false => translation.bind(&format!("{name}_S"), function),
    }
}

/// Writes ½ α·J α + α·(ω × J ω) by components. Take x, y, z in cyclic order and omit terms without
/// accelerations. The moments add ½ J_zz α_z² + (J_yy − J_xx) ω_x ω_y α_z, and the products J_xy
/// (α_y − ω_z ω_x) (α_x + ω_y ω_z) + J_xy (ω_x² − ω_y²) α_z.
fn rotational_parts(
    terms: &mut TermWriter<'_>,
    tensor: Tensor,
    change: Triple,
    relative: &Relative,
) -> Vec<AstId> {
    let [moments, products] = [[tensor[0], tensor[1], tensor[2]], [tensor[5], tensor[4], tensor[3]]];
    let mut parts = Vec::new();
    for z in 0..3 {
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        if !terms.is_zero(change[z]) {
            let (half, square) = (terms.half(), terms.square(change[z]));
            let weight = terms.times(half, moments[z]);
            parts.push(terms.times(weight, square));
        }
        let difference = terms.minus(moments[y], moments[x]);
        let gyroscopic = terms.times(difference, relative.mixed[z]);
        parts.push(terms.times(gyroscopic, change[z]));
        let [to_x, to_y] = [relative.matrix[z][x], relative.matrix[z][y]];
        let coupled = terms.times(to_x, to_y);
        let coupled = terms.times(products[z], coupled);
        parts.push(terms.negative(coupled));
        let squares = terms.minus(relative.squares[x], relative.squares[y]);
        let spread = terms.times(products[z], squares);
        parts.push(terms.times(spread, change[z]));
    }
    parts
}
