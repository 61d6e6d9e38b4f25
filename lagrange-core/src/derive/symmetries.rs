//! Symmetries of a model: translations, rotations and turns that leave its equations unchanged.
//!
//! A displacement δq = ξ(q) of the positions changes the velocities, too. It is a symmetry if δL
//! vanishes, and with it the work of all forces, constraints and contacts. The momentum along it is
//! then conserved (Noether; Arnold, *Mathematical Methods of Classical Mechanics*, §20).
//!
//! These conditions are linear in the displacement. The conditions of the candidates are the
//! columns of a matrix, with rows at many random points. Combinations of candidates in its null
//! space are symmetries.
//!
//! In numbers, take two masses on a line with a spring between them, L = (v₁² + 2 v₂²)/2 − (q₁ −
//! q₂)²/2. The candidates are the translations of q₁ and q₂. At q = (1, 3) the row is (2, −2), and
//! at any other point a multiple of it. The null space is (1, 1): the sum of the momenta is
//! conserved.

use super::displacements::{Displacement, Generator, displacements, generator};
use super::null_space::null_space;
use super::virtual_displacements::applied_forces;
use crate::model::{Action, Assignment, Entry, Model, entries, may_be_flat};
use lagrange_algebra::calculus::{gradient, substitute_all};
use lagrange_algebra::simplify::vanishing;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Number of additional points, beyond the number of candidates, at which combinations are tested.
const FURTHER_POINTS: usize = 8;
/// Rounding error of a zero, as a fraction of the largest number at a point.
const ROUNDING: f64 = 1e-9;
/// Largest denominator of a coefficient.
const LARGEST_DENOMINATOR: i64 = 12;

/// A combination of candidates that leaves the equations unchanged.
pub(super) struct Symmetry {
    /// Candidates with their coefficients.
    pub(super) terms: Vec<(Displacement, Number)>,
    /// Its momentum.
    pub(super) momentum: ExprId,
}

/// Derivatives of a model along its positions and velocities.
struct Slopes {
    positions: Vec<ExprId>,
    momenta: Vec<ExprId>,
    forces: Vec<ExprId>,
    /// Rows of constraints and of contacts, by the velocities.
    rows: Vec<Vec<ExprId>>,
}

/// Finds the symmetries of a model, except for combinations whose coefficients are not simple
/// fractions.
pub(super) fn symmetries(model: &mut Model) -> Vec<Symmetry> {
    let slopes = Slopes::of(model);
    let generators = displacements(model).into_iter().map(|displacement| generator(model, displacement));
    let generators = generators.collect::<Vec<_>>();
    let momenta = generators.iter().map(|of| pairing(&mut model.graph, &of.along, &slopes.momenta));
    let momenta = momenta.collect::<Vec<_>>();
    let columns = conditions(model, &slopes, &generators, &momenta);
    let combinations = invariant_combinations(model, &columns);
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
}

/// Returns the quantities that vanish for symmetries, one column for each candidate. They are δL
/// and the work of forces, the work of each constraint and contact, and the change of the momentum
/// at assignments.
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

/// Returns the entries of the state that each event and each clock replaces.
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

/// Returns Σ cᵢ xᵢ over the given entries.
fn pairing(graph: &mut Graph, coefficients: &[(usize, ExprId)], of: &[ExprId]) -> ExprId {
    let products = coefficients.iter().map(|&(index, c)| graph.multiply(c, of[index]));
    let products = products.collect::<Vec<_>>();
    graph.total(products)
}

/// Finds combinations of columns that vanish at random points. A formula that may be flat at these
/// points but not elsewhere requires a proof.
fn invariant_combinations(model: &mut Model, columns: &[Vec<ExprId>]) -> Vec<Vec<Number>> {
    let samples = samples(model, columns);
    let (used, further) = samples.split_at(samples.len().min(columns.len() + 1));
    if further.is_empty() {
        return Vec::new();
    }
    let scale = |column: usize| {
        let magnitudes = used.iter().flatten().map(|row| row[column].magnitude);
        magnitudes.fold(0.0, f64::max)
    };
    let scales = (0..columns.len()).map(scale).map(|scale| if scale > 0.0 { scale } else { 1.0 });
    let scales = scales.collect::<Vec<_>>();
    let scaled =
        |row: &Vec<Entry>| row.iter().zip(&scales).map(|(entry, scale)| entry.value / scale).collect();
    let candidates = null_space(used.iter().flatten().map(scaled).collect(), columns.len(), ROUNDING);
    let simple = candidates.iter().filter_map(|vector| combination(vector, &scales));
    let found = simple.filter(|found| further.iter().flatten().all(|row| vanishes(row, found)));
    let found = found.collect::<Vec<_>>();
    if !columns.concat().iter().any(|&root| may_be_flat(&model.graph, root)) {
        return found;
    }
    found.into_iter().filter(|combination| is_proved(&mut model.graph, columns, combination)).collect()
}

/// Returns the coefficients of a vector of scaled columns, normalised so that the last one is one,
/// if they are simple.
fn combination(vector: &[f64], scales: &[f64]) -> Option<Vec<Number>> {
    let known = vector.iter().map(|entry| if entry.abs() > ROUNDING { *entry } else { 0.0 });
    let unscaled = known.zip(scales).map(|(entry, scale)| entry / scale).collect::<Vec<_>>();
    let last = unscaled.iter().rev().find(|entry| **entry != 0.0)?;
    unscaled.iter().map(|entry| fraction(entry / last)).collect()
}

/// True if the sum of the entries is zero up to rounding errors of their terms.
fn vanishes(row: &[Entry], combination: &[Number]) -> bool {
    let (mut sum, mut magnitude) = (0.0, 0.0);
    for (entry, coefficient) in row.iter().zip(combination) {
        let coefficient = coefficient.to_f64();
        sum += coefficient * entry.value;
        magnitude += coefficient.abs() * entry.magnitude;
    }
    sum.abs() <= ROUNDING * magnitude
}

/// Evaluates the rows of conditions at points where all are finite.
fn samples(model: &Model, columns: &[Vec<ExprId>]) -> Vec<Vec<Vec<Entry>>> {
    let height = columns.first().map_or(0, Vec::len);
    let parts = model.graph.reachable(&columns.concat());
    let at_point = |point: usize| {
        let entries = entries(model, &parts, point);
        let at = |column: &Vec<ExprId>, row: usize| entries.get(&column[row]).copied();
        let row = |row: usize| columns.iter().map(|column| at(column, row)).collect::<Option<Vec<_>>>();
        let rows = (0..height).map(row).collect::<Option<Vec<_>>>()?;
        rows.iter().flatten().all(|entry| entry.magnitude.is_finite()).then_some(rows)
    };
    let wanted = columns.len() + 1 + FURTHER_POINTS;
    (0..2 * wanted).filter_map(at_point).take(wanted).collect()
}

/// Returns a coefficient as a fraction, if it is a simple one.
fn fraction(value: f64) -> Option<Number> {
    (1..=LARGEST_DENOMINATOR).find_map(|denominator| {
        let numerator = (value * denominator as f64).round();
        let is_close = (numerator / denominator as f64 - value).abs() < ROUNDING.sqrt();
        if is_close { Number::ratio(numerator as i64, denominator) } else { None }
    })
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
