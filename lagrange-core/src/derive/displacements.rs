//! Displacements of a model that may be symmetries: translations, rotations in planes of
//! coordinates, and rotations of orientations.

use crate::model::{Model, Orientation};
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Maximum number of candidates if these include rotations in the planes of two coordinates.
const MAX_CANDIDATES: usize = 300;

/// A candidate for a symmetry.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Displacement {
    /// A displacement of a coordinate, by its index among the positions.
    Translation(usize),
    /// A rotation of the first coordinate towards the second, about the origin of both.
    Rotation(usize, usize),
    /// A rotation of an orientation about an axis of the world, by the indices of both.
    Turn(usize, usize),
    /// A rotation of an orientation about an axis of the body, by the indices of both.
    Spin(usize, usize),
}

/// A candidate as expressions: the changes of positions and velocities, and the displacement along
/// each velocity.
pub(super) struct Generator {
    pub(super) displacement: Displacement,
    pub(super) positions: Vec<(usize, ExprId)>,
    pub(super) velocities: Vec<(usize, ExprId)>,
    pub(super) along: Vec<(usize, ExprId)>,
}

/// Returns the candidates of a model, without rotations in planes if there would be too many.
pub(super) fn displacements(model: &Model) -> Vec<Displacement> {
    let plain = model.speeds.iter().filter_map(|speed| speed.coordinate).collect::<Vec<_>>();
    let mut all = plain.iter().map(|&position| Displacement::Translation(position)).collect::<Vec<_>>();
    let axes = || (0..model.orientations.len()).flat_map(|body| (0..3).map(move |axis| (body, axis)));
    all.extend(axes().map(|(body, axis)| Displacement::Turn(body, axis)));
    all.extend(axes().map(|(body, axis)| Displacement::Spin(body, axis)));
    if all.len() + plain.len() * plain.len().saturating_sub(1) / 2 <= MAX_CANDIDATES {
        for (index, &first) in plain.iter().enumerate() {
            all.extend(plain[index + 1..].iter().map(|&second| Displacement::Rotation(first, second)));
        }
    }
    all
}

/// Writes a candidate as expressions.
pub(super) fn generator(model: &mut Model, displacement: Displacement) -> Generator {
    let (positions, velocities) = (model.positions(), model.velocities());
    let speed_of = |model: &Model, position| {
        model.speeds.iter().position(|speed| speed.coordinate == Some(position)).unwrap_or_default()
    };
    let mut generator =
        Generator { displacement, positions: Vec::new(), velocities: Vec::new(), along: Vec::new() };
    match displacement {
        Displacement::Translation(position) => {
            let one = model.graph.number(1);
            generator.positions.push((position, one));
            generator.along.push((speed_of(model, position), one));
        }
        Displacement::Rotation(first, second) => {
            let [from, to] = [first, second].map(|position| speed_of(model, position));
            let back = [model.graph.negate(positions[second]), model.graph.negate(velocities[to])];
            generator.positions = vec![(first, back[0]), (second, positions[first])];
            generator.velocities = vec![(from, back[1]), (to, velocities[from])];
            generator.along = vec![(from, back[0]), (to, positions[first])];
        }
        Displacement::Turn(body, axis) => {
            let of = model.orientations[body];
            let quaternion = quaternion(of, &positions);
            generator.positions = turned(&mut model.graph, of, quaternion, axis, &Number::ONE);
            let components = world_axis(&mut model.graph, quaternion, axis);
            generator.along = (of.velocity..).zip(components).collect();
        }
        Displacement::Spin(body, axis) => {
            let of = model.orientations[body];
            let [next, last] = [(axis + 1) % 3, (axis + 2) % 3].map(|other| of.velocity + other);
            generator.positions =
                turned(&mut model.graph, of, quaternion(of, &positions), axis, &Number::MINUS_ONE);
            // The same vector ω in axes that are turned by d is ω + ω × d.
            let back = model.graph.negate(velocities[next]);
            generator.velocities = vec![(next, velocities[last]), (last, back)];
            generator.along = vec![(of.velocity + axis, model.graph.number(1))];
        }
    }
    generator
}

fn quaternion(of: Orientation, positions: &[ExprId]) -> [ExprId; 4] {
    std::array::from_fn(|part| positions[of.position + part])
}

/// Returns the change of a quaternion that is multiplied by half the unit of an axis. The factor is
/// on the left, or on the right for a negative `sign` of the vector product.
fn turned(
    graph: &mut Graph,
    of: Orientation,
    [w, vector @ ..]: [ExprId; 4],
    axis: usize,
    sign: &Number,
) -> Vec<(usize, ExprId)> {
    let half = Number::HALF;
    let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
    let mut changes = vec![
        (of.position, graph.scale(-&half, vector[axis])),
        (of.position + 1 + axis, graph.scale(half.clone(), w)),
    ];
    // e × v has the components −v_last along the next axis and v_next along the last.
    changes.push((of.position + 1 + next, graph.scale(-&(&half * sign), vector[last])));
    changes.push((of.position + 1 + last, graph.scale(&half * sign, vector[next])));
    changes
}

/// Returns the components of a world axis in the axes of the body: a row of its rotation matrix.
fn world_axis(graph: &mut Graph, [w, vector @ ..]: [ExprId; 4], axis: usize) -> [ExprId; 3] {
    std::array::from_fn(|column| {
        let product = graph.multiply(vector[axis], vector[column]);
        let mut terms = vec![(product, Number::TWO)];
        if column == axis {
            let square = graph.multiply(w, w);
            terms.push((square, Number::TWO));
            return graph.sum(Number::MINUS_ONE, terms);
        }
        let (third, is_even) = (3 - axis - column, (axis + 1) % 3 == column);
        let sign = if is_even { -&Number::TWO } else { Number::TWO };
        terms.push((graph.multiply(w, vector[third]), sign));
        graph.sum(Number::ZERO, terms)
    })
}
