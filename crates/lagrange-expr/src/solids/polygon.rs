//! Polygons as fans of triangles about their first corner.
//!
//! Let u and w be the positions of two corners relative to the first. A triangle (0, u, w) has
//! twice the area D = u × w and its centroid at (u + w)/3. Its second moment of area about the
//! first corner is D (u·u + u·w + w·w)/12. Areas are signed, so only the order of corners matters,
//! and the quotients do not depend on the orientation.

use super::formulas::fraction;
use crate::expr::{ExprId, Graph};
use crate::number::Number;

/// A vector of the plane.
type Vector = [ExprId; 2];

/// Twice the area D of a triangle of the fan, with the sides that meet in the first corner.
struct Triangle {
    area: ExprId,
    sides: [Vector; 2],
}

/// Returns Σ D (u + w) / 3 Σ D, measured from the first corner.
pub(super) fn center(graph: &mut Graph, coordinates: &[ExprId]) -> Vector {
    let fan = fan(graph, coordinates);
    let offset = offset(graph, &fan);
    [0, 1].map(|axis| graph.add(coordinates[axis], offset[axis]))
}

/// Returns Σ D (u·u + u·w + w·w) / 6 Σ D about the first corner, less the squared distance of the
/// centre of mass from this corner.
pub(super) fn inertia(graph: &mut Graph, coordinates: &[ExprId]) -> ExprId {
    let fan = fan(graph, coordinates);
    let moments = fan.iter().map(|triangle| {
        let [u, w] = triangle.sides;
        let products = [(u, u), (u, w), (w, w)].map(|(a, b)| inner(graph, a, b));
        let sum = graph.total(products);
        graph.multiply(triangle.area, sum)
    });
    let moments = moments.collect::<Vec<_>>();
    let about_corner = mean(graph, moments, &fan, 6);
    let offset = offset(graph, &fan);
    let square = inner(graph, offset, offset);
    graph.subtract(about_corner, square)
}

/// Returns the centre of mass relative to the first corner.
fn offset(graph: &mut Graph, fan: &[Triangle]) -> Vector {
    [0, 1].map(|axis| {
        let terms = fan.iter().map(|triangle| {
            let [u, w] = triangle.sides;
            let sum = graph.add(u[axis], w[axis]);
            graph.multiply(triangle.area, sum)
        });
        let terms = terms.collect::<Vec<_>>();
        mean(graph, terms, fan, 3)
    })
}

/// Returns Σ terms / (divisor · Σ D).
fn mean(graph: &mut Graph, terms: Vec<ExprId>, fan: &[Triangle], divisor: i64) -> ExprId {
    let area = graph.total(fan.iter().map(|triangle| triangle.area));
    let sum = graph.total(terms);
    let quotient = graph.divide(sum, area);
    fraction(graph, 1, quotient, divisor)
}

/// Returns twice the area, positive for corners in counterclockwise order.
pub fn double_area(graph: &mut Graph, coordinates: &[ExprId]) -> ExprId {
    let fan = fan(graph, coordinates);
    graph.total(fan.iter().map(|triangle| triangle.area))
}

fn fan(graph: &mut Graph, coordinates: &[ExprId]) -> Vec<Triangle> {
    let places = coordinates.chunks_exact(2).skip(1);
    let places = places.map(|p| [0, 1].map(|axis| graph.subtract(p[axis], coordinates[axis])));
    let places = places.collect::<Vec<_>>();
    let triangles = places.windows(2).map(|pair| {
        let [u, w] = [pair[0], pair[1]];
        let (forward, backward) = (graph.multiply(u[0], w[1]), graph.multiply(u[1], w[0]));
        Triangle { area: graph.subtract(forward, backward), sides: [u, w] }
    });
    triangles.collect()
}

fn inner(graph: &mut Graph, a: Vector, b: Vector) -> ExprId {
    let products = [0, 1].map(|axis| graph.multiply(a[axis], b[axis]));
    graph.sum(Number::ZERO, products.map(|product| (product, Number::ONE)))
}
