//! Totals of all bodies: their centre of mass G, and their momentum about it.
//!
//! The centroidal momentum is Σ (J ω + m (c − G) × ċ) with the centres c, and Σ m ċ. Both are
//! affine in the velocities, and the matrix of the linear part is its gradient, as for frames.
//! Lever arms from G keep their digits far from the origin.
//!
//! Source: Orin, Goswami, Lee, "Centroidal dynamics of a humanoid robot", Autonomous Robots 35
//! (2013) 161–176.

use crate::model::{BodyMotion, Model};
use lagrange_algebra::calculus::gradient;
use lagrange_expr::expr::{ExprId, Graph};

/// Returns the centre of mass.
pub(super) fn center_of_mass(model: &mut Model) -> Vec<ExprId> {
    let (graph, motions) = (&mut model.graph, &model.scene.motions);
    let mass = graph.total(motions.iter().map(BodyMotion::mass).collect::<Vec<_>>());
    let inverse = graph.reciprocal(mass);
    let moments = weighted(graph, motions, BodyMotion::place);
    moments.into_iter().map(|moment| graph.multiply(moment, inverse)).collect()
}

/// Returns the angular momentum about the centre of mass, then the linear momentum.
pub(super) fn centroidal_momentum(model: &mut Model) -> Vec<ExprId> {
    let center = center_of_mass(model);
    let (graph, motions) = (&mut model.graph, &model.scene.motions);
    let mut angular = Vec::new();
    for motion in motions {
        let arm = motion.place().iter().zip(&center).map(|(&place, &center)| graph.subtract(place, center));
        let arm = arm.collect::<Vec<_>>();
        let moments = cross(graph, &arm, motion.velocity());
        let moments = moments.into_iter().map(|moment| graph.multiply(motion.mass(), moment));
        let moments = moments.collect::<Vec<_>>();
        angular.push(moments);
        angular.push(spin(graph, motion));
    }
    let count = angular.first().map_or(0, Vec::len);
    let total = |axis| graph.total(angular.iter().map(|part| part[axis]).collect::<Vec<_>>());
    let mut momentum = (0..count).map(total).collect::<Vec<_>>();
    momentum.extend(weighted(graph, motions, BodyMotion::velocity));
    momentum
}

/// Returns the derivatives of the momentum with respect to the velocities, in rows.
pub(super) fn centroidal_momentum_matrix(model: &mut Model) -> Vec<ExprId> {
    let velocities = model.velocities();
    let momentum = centroidal_momentum(model);
    momentum.into_iter().flat_map(|part| gradient(&mut model.graph, part, &velocities)).collect()
}

/// Returns the sum of vectors of bodies, multiplied by their masses.
fn weighted(
    graph: &mut Graph,
    motions: &[BodyMotion],
    vector: for<'a> fn(&'a BodyMotion) -> &'a [ExprId],
) -> Vec<ExprId> {
    let count = motions.first().map_or(0, |motion| vector(motion).len());
    let sum = |axis: usize| {
        let products = motions.iter().map(|motion| graph.multiply(motion.mass(), vector(motion)[axis]));
        let products = products.collect::<Vec<_>>();
        graph.total(products)
    };
    (0..count).map(sum).collect()
}

/// Returns the angular momentum of a body about its own centre, in world axes.
fn spin(graph: &mut Graph, motion: &BodyMotion) -> Vec<ExprId> {
    let (inertia, spin) = (motion.inertia(), motion.angular_velocity());
    let Some(rotation) = motion.rotation() else {
        return vec![graph.multiply(inertia[0], spin[0])];
    };
    let columns = (0..9).map(|k| rotation[3 * (k % 3) + k / 3]).collect::<Vec<_>>();
    [&columns[..], inertia, rotation]
        .iter()
        .fold(spin.to_vec(), |vector, matrix| product(graph, matrix, &vector))
}

/// Returns the product of a matrix in rows and a vector.
fn product(graph: &mut Graph, rows: &[ExprId], vector: &[ExprId]) -> Vec<ExprId> {
    let entry = |row: &[ExprId]| {
        let products = row.iter().zip(vector).map(|(&a, &b)| graph.multiply(a, b)).collect::<Vec<_>>();
        graph.total(products)
    };
    rows.chunks_exact(vector.len()).map(entry).collect()
}

/// Returns the components of a vector product: one in the plane, three in space.
fn cross(graph: &mut Graph, a: &[ExprId], b: &[ExprId]) -> Vec<ExprId> {
    let mut minor = |i: usize, j: usize| {
        let products = [graph.multiply(a[i], b[j]), graph.multiply(a[j], b[i])];
        graph.subtract(products[0], products[1])
    };
    match a.len() {
        2 => vec![minor(0, 1)],
        _ => vec![minor(1, 2), minor(2, 0), minor(0, 1)],
    }
}
