//! Symmetries of a model: translations, rotations and turns that leave its equations unchanged.
//!
//! A displacement δq = ξ(q) of the positions changes the velocities, too. It is a symmetry if δL
//! vanishes, and with it the work of all forces, constraints and contacts. The momentum along it is
//! then conserved (Noether; Arnold, *Mathematical Methods of Classical Mechanics*, §20).
//!
//! These conditions are linear in the displacement. Those of the candidates are the columns of a
//! matrix, with rows at many random points. Combinations of candidates in its null space are
//! symmetries.
//!
//! In numbers, take two masses on a line with a spring between them, L = (v₁² + 2 v₂²)/2 − (q₁ −
//! q₂)²/2. The candidates are the translations of q₁ and q₂. At q = (1, 3) the row is (2, −2), and
//! at any other point a multiple of it. The null space is (1, 1): the sum of the momenta is
//! conserved.

use super::null_space::null_space;
use super::virtual_displacements::applied_forces;
use crate::model::{Action, Assignment, Model, Orientation};
use lagrange_algebra::calculus::{gradient, substitute_all};
use lagrange_algebra::simplify::{somewhere, vanishing};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node, evaluate};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Number of candidates up to which rotations in the planes of two coordinates are among them.
const MOST_CANDIDATES: usize = 300;
/// Number of points beyond that of the candidates, at which combinations are tested.
const FURTHER_POINTS: usize = 8;
/// Fraction of the largest number at a point that rounding may leave of a zero.
const ROUNDING: f64 = 1e-9;
/// Largest denominator of a coefficient.
const LARGEST_DENOMINATOR: i64 = 12;

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

/// A combination of candidates that leaves the equations unchanged.
pub(super) struct Symmetry {
    /// Candidates with their coefficients.
    pub(super) terms: Vec<(Displacement, Number)>,
    /// Its momentum.
    pub(super) momentum: ExprId,
}

/// A candidate as expressions: changes of positions and of velocities, and the displacement along
/// each velocity.
struct Generator {
    displacement: Displacement,
    positions: Vec<(usize, ExprId)>,
    velocities: Vec<(usize, ExprId)>,
    along: Vec<(usize, ExprId)>,
}

/// Derivatives of a model along its positions and velocities.
struct Slopes {
    positions: Vec<ExprId>,
    momenta: Vec<ExprId>,
    forces: Vec<ExprId>,
    /// Rows of constraints and of contacts, by the velocities.
    rows: Vec<Vec<ExprId>>,
}

/// Finds the symmetries of a model. Those whose coefficients are no simple fractions are not found.
pub(super) fn symmetries(model: &mut Model) -> Vec<Symmetry> {
    let slopes = Slopes::of(model);
    let generators = displacements(model).into_iter().map(|displacement| generator(model, displacement));
    let generators = generators.collect::<Vec<_>>();
    let momenta = generators.iter().map(|of| pairing(&mut model.graph, &of.along, &slopes.momenta));
    let momenta = momenta.collect::<Vec<_>>();
    let columns = conditions(model, &slopes, &generators, &momenta);
    let combinations = invariant_combinations(model, &slopes, &columns);
    combinations
        .into_iter()
        .map(|coefficients| {
            let used = || coefficients.iter().enumerate().filter(|(_, c)| !c.is_zero());
            let terms = used().map(|(index, c)| (generators[index].displacement, c.clone())).collect();
            let momentum =
                model.graph.sum(Number::ZERO, used().map(|(index, c)| (momenta[index], c.clone())));
            Symmetry { terms, momentum }
        })
        .collect()
}

fn displacements(model: &Model) -> Vec<Displacement> {
    let plain = model.speeds.iter().filter_map(|speed| speed.coordinate).collect::<Vec<_>>();
    let mut all = plain.iter().map(|&position| Displacement::Translation(position)).collect::<Vec<_>>();
    let axes = || (0..model.orientations.len()).flat_map(|body| (0..3).map(move |axis| (body, axis)));
    all.extend(axes().map(|(body, axis)| Displacement::Turn(body, axis)));
    all.extend(axes().map(|(body, axis)| Displacement::Spin(body, axis)));
    if all.len() + plain.len() * plain.len().saturating_sub(1) / 2 <= MOST_CANDIDATES {
        for (index, &first) in plain.iter().enumerate() {
            all.extend(plain[index + 1..].iter().map(|&second| Displacement::Rotation(first, second)));
        }
    }
    all
}

fn generator(model: &mut Model, displacement: Displacement) -> Generator {
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

/// The change of a quaternion that is multiplied by half the unit of an axis. It is multiplied from
/// the left, or from the right for a negative `sign` of the vector product.
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

/// The components of an axis of the world in the axes of the body: a row of its rotation matrix.
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

impl Slopes {
    fn of(model: &mut Model) -> Slopes {
        let (positions, velocities) = (model.positions(), model.velocities());
        let of_constraints = model.constraints.iter().map(|constraint| constraint.velocity);
        let held = of_constraints.chain(model.reactions.iter().map(|of| of.velocity)).collect::<Vec<_>>();
        let forces = applied_forces(model);
        let graph = &mut model.graph;
        Slopes {
            positions: gradient(graph, model.lagrangian, &positions),
            momenta: gradient(graph, model.lagrangian, &velocities),
            forces,
            rows: held.into_iter().map(|velocity| gradient(graph, velocity, &velocities)).collect(),
        }
    }

    fn all(&self) -> Vec<ExprId> {
        let vectors = [&self.positions, &self.momenta, &self.forces];
        vectors.into_iter().chain(&self.rows).flatten().copied().collect()
    }
}

/// Quantities that vanish for symmetries, one column for each candidate. They are δL and the work
/// of forces, the work of each constraint and contact, and the change of the momentum at
/// assignments.
fn conditions(
    model: &mut Model,
    slopes: &Slopes,
    generators: &[Generator],
    momenta: &[ExprId],
) -> Vec<Vec<ExprId>> {
    let graph = &mut model.graph;
    let mut columns = Vec::new();
    for generator in generators {
        let work = [
            pairing(graph, &generator.positions, &slopes.positions),
            pairing(graph, &generator.velocities, &slopes.momenta),
            pairing(graph, &generator.along, &slopes.forces),
        ];
        let mut column = vec![graph.total(work)];
        column.extend(slopes.rows.iter().map(|row| pairing(graph, &generator.along, row)));
        columns.push(column);
    }
    for changes in state_changes(model) {
        let after = substitute_all(&mut model.graph, momenta, &changes);
        for ((column, &before), after) in columns.iter_mut().zip(momenta).zip(after) {
            column.push(model.graph.subtract(after, before));
        }
    }
    columns
}

/// The entries of the state that each event and each clock replaces.
fn state_changes(model: &Model) -> Vec<HashMap<ExprId, ExprId>> {
    let state = [model.positions(), model.velocities()].concat();
    let of_events = model.events.iter().filter_map(|event| match &event.action {
        Action::Assign(assignments) => Some(assignments),
        Action::Stop | Action::Record | Action::Impact(_) => None,
    });
    let assigned = of_events.chain(model.clocks.iter().map(|clock| &clock.assignments));
    let change = |assignment: &Assignment| (state[assignment.index], assignment.value);
    assigned.map(|assignments| assignments.iter().map(change).collect()).collect()
}

/// Σ cᵢ xᵢ over the entries that are given.
fn pairing(graph: &mut Graph, coefficients: &[(usize, ExprId)], of: &[ExprId]) -> ExprId {
    let products = coefficients.iter().map(|&(index, c)| graph.multiply(c, of[index]));
    let products = products.collect::<Vec<_>>();
    graph.total(products)
}

/// Combinations of columns that vanish at random points and, where a formula is made of pieces, by
/// proof.
fn invariant_combinations(model: &mut Model, slopes: &Slopes, columns: &[Vec<ExprId>]) -> Vec<Vec<Number>> {
    let rows = rows_at_points(model, slopes, columns);
    let (used, further) = rows.split_at(rows.len().min(columns.len() + 1));
    if further.is_empty() {
        return Vec::new();
    }
    let candidates = null_space(used.concat(), columns.len(), ROUNDING);
    let simple = candidates.iter().filter_map(|vector| vector.iter().map(|&c| fraction(c)).collect());
    let vanishes = |combination: &Vec<Number>| {
        let numbers = combination.iter().map(Number::to_f64).collect::<Vec<_>>();
        let sum = |row: &Vec<f64>| row.iter().zip(&numbers).map(|(entry, c)| entry * c).sum::<f64>();
        further.iter().flatten().all(|row| sum(row).abs() <= ROUNDING * numbers.len() as f64)
    };
    let found = simple.filter(vanishes).collect::<Vec<_>>();
    if !columns.concat().iter().any(|&root| has_pieces(&model.graph, root)) {
        return found;
    }
    found.into_iter().filter(|combination| is_proved(&mut model.graph, columns, combination)).collect()
}

/// Values of the columns at points where all are finite, relative to the largest number there.
fn rows_at_points(model: &Model, slopes: &Slopes, columns: &[Vec<ExprId>]) -> Vec<Vec<Vec<f64>>> {
    let (entries, scales) = (columns.concat(), slopes.all());
    let roots = [entries.clone(), scales].concat();
    let height = columns.first().map_or(0, Vec::len);
    let at_point = |point: usize| {
        let values = evaluate(&model.graph, &roots, |role| value_at(model, role, point));
        let largest = values.iter().fold(1.0, |a: f64, b| if b.is_nan() { f64::NAN } else { a.max(b.abs()) });
        let row = |i: usize| (0..columns.len()).map(|k| values[k * height + i] / largest).collect::<Vec<_>>();
        largest.is_finite().then(|| (0..height).map(row).collect::<Vec<_>>())
    };
    (0..2 * columns.len() + 2 * FURTHER_POINTS)
        .filter_map(at_point)
        .take(columns.len() + 1 + FURTHER_POINTS)
        .collect()
}

/// A number between 1/2 and 3/2 for a symbol at a point; quaternions have the length one.
fn value_at(model: &Model, role: Role, point: usize) -> f64 {
    let Role::Coordinate(index) = role else { return spread(role, point) };
    let of = model.orientations.iter().find(|of| (of.position..of.position + 4).contains(&(index as usize)));
    let Some(of) = of else { return spread(role, point) };
    let parts = (0..4).map(|part| spread(Role::Coordinate((of.position + part) as u32), point) - 1.0);
    let length = parts.map(|part| part * part).sum::<f64>().sqrt();
    (spread(role, point) - 1.0) / length
}

/// Sebastiano Vigna's splitmix64, a hash whose values are independent for each symbol and point.
fn spread(role: Role, point: usize) -> f64 {
    let symbol = somewhere(role).to_bits();
    let mut hash = symbol.wrapping_add((point as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    hash = (hash ^ (hash >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    hash = (hash ^ (hash >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    0.5 + ((hash ^ (hash >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

/// The fraction that a coefficient is, if it is a simple one.
fn fraction(value: f64) -> Option<Number> {
    (1..=LARGEST_DENOMINATOR).find_map(|denominator| {
        let numerator = (value * denominator as f64).round();
        let is_close = (numerator / denominator as f64 - value).abs() < ROUNDING.sqrt();
        if is_close { Number::ratio(numerator as i64, denominator) } else { None }
    })
}

/// True of a formula that is not analytic: what holds at points may not hold elsewhere.
fn has_pieces(graph: &Graph, root: ExprId) -> bool {
    let is_piecewise = |id: ExprId| match graph.node(id) {
        Node::Choose { .. } | Node::Opaque(..) => true,
        Node::Call(function, _) => matches!(
            function,
            Function::Abs | Function::Sign | Function::MagnitudeSlope | Function::Min | Function::Max
        ),
        _ => false,
    };
    graph.reachable(&[root]).into_iter().any(is_piecewise)
}

fn is_proved(graph: &mut Graph, columns: &[Vec<ExprId>], combination: &[Number]) -> bool {
    let height = columns.first().map_or(0, Vec::len);
    let sums = (0..height).map(|row| {
        let terms = columns.iter().zip(combination).map(|(column, c)| (column[row], c.clone()));
        graph.sum(Number::ZERO, terms)
    });
    let sums = sums.collect::<Vec<_>>();
    vanishing(graph, &sums).into_iter().all(|is_zero| is_zero)
}
