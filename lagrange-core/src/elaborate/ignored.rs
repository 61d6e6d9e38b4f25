//! Coordinates that cannot be ignored, and the reasons.

use super::elaborator::{Elaborator, SourceTerm};
use super::messages;
use super::pinned::holding;
use crate::model::{Entry, Model, Pinned, Reduction, entries, may_be_flat};
use lagrange_algebra::calculus::gradient;
use lagrange_algebra::simplify::vanishing;
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::{Origin, Report};
use lagrange_expr::expr::{ExprId, Function, Graph, Node};

/// Number of points at which a formula must vanish if no proof is found.
const POINTS: usize = 12;
/// Rounding error of a zero, as a fraction of its terms.
const ROUNDING: f64 = 1e-9;

/// Terms of a declaration, with their places.
pub(super) struct Terms {
    energies: Vec<(ExprId, Origin)>,
    dissipation: Vec<(ExprId, Origin)>,
    loads: HashMap<String, Origin>,
}

impl Terms {
    pub(super) fn of(elaborator: &Elaborator<'_>) -> Terms {
        let place = |term: &SourceTerm| (term.value, term.keyword.into());
        let energies = elaborator.kinetic.iter().chain(&elaborator.potential).chain(&elaborator.lagrangian);
        let dissipation = elaborator.dissipation.iter().map(place).collect();
        let statements = &elaborator.declaration.statements;
        let loads = elaborator.load_statements.iter();
        let loads = loads.map(|(name, statement)| (name.clone(), statements[*statement].origin)).collect();
        Terms { energies: energies.map(place).collect(), dissipation, loads }
    }
}

/// Obstacle to ignoring a coordinate.
pub(super) enum Obstacle {
    /// The Lagrangian depends on it.
    Energy,
    /// A load acts on it. The name is that of its statement, if a single one is responsible.
    Load(Option<String>),
    Dissipation,
    /// Its momentum is not linear in velocities.
    Nonlinear,
    /// Velocities do not follow from momenta.
    Undetermined,
    /// The Lagrangian has no value at zero.
    Undefined,
}

/// A coordinate that cannot be ignored, and the reason.
pub(super) struct Refusal {
    pub(super) pinned: Pinned,
    pub(super) obstacle: Obstacle,
}

/// Marks values that are zero everywhere: by proof, or by sampling many points unless the formula
/// may be flat there but not elsewhere.
pub(super) fn vanish(model: &mut Model, values: &[ExprId]) -> Vec<bool> {
    let proved = vanishing(&mut model.graph, values);
    let vanishes = |(&value, proved): (&ExprId, bool)| proved || vanishes_at_points(model, value);
    values.iter().zip(proved).map(vanishes).collect()
}

fn vanishes_at_points(model: &Model, value: ExprId) -> bool {
    let parts = model.graph.reachable(&[value]);
    let vanishes = |point: usize| {
        let entry = entries(model, &parts, point).get(&value).copied();
        entry.is_some_and(|Entry { value, magnitude }| {
            magnitude.is_finite() && value.abs() <= ROUNDING * magnitude
        })
    };
    !may_be_flat(&model.graph, value) && (0..POINTS).all(vanishes)
}

/// Marks symbols on which no value depends, neither smoothly nor by conditions.
pub(super) fn independent(model: &mut Model, values: &[ExprId], symbols: &[ExprId]) -> Vec<bool> {
    let all = [values, &deciding(&mut model.graph, values)].concat();
    let slopes = all.iter().flat_map(|&value| gradient(&mut model.graph, value, symbols));
    let slopes = slopes.collect::<Vec<_>>();
    let vanish = vanish(model, &slopes);
    let of_symbol = |index| vanish.iter().skip(index).step_by(symbols.len());
    (0..symbols.len()).map(|index| of_symbol(index).all(|&vanishes| vanishes)).collect()
}

/// Returns parts of values whose influence gradients do not show: the deciding values of conditions
/// and signs, and arguments of functions without a formula.
pub(super) fn deciding(graph: &mut Graph, values: &[ExprId]) -> Vec<ExprId> {
    use Function::{Abs, MagnitudeSlope, Sign};
    let mut found = Vec::new();
    for id in graph.reachable(values) {
        match *graph.node(id) {
            Node::Choose { left, right, .. } => found.push(graph.subtract(left, right)),
            Node::Call(Abs | MagnitudeSlope | Sign, ref arguments) | Node::Opaque(_, ref arguments) => {
                found.extend(arguments.iter().copied());
            }
            _ => {}
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

impl Refusal {
    pub(super) fn report(self, model: &Model, reduction: &Reduction, terms: &Terms, report: &mut Report) {
        let name = &model.coordinates[self.pinned.coordinate].name;
        let (message, help) = match &self.obstacle {
            Obstacle::Energy => (messages::ignored_in_energy(name), messages::NOT_CYCLIC_HELP),
            Obstacle::Load(_) => (messages::ignored_with_force(name), messages::IGNORED_FORCE_HELP),
            Obstacle::Dissipation => {
                (messages::ignored_with_dissipation(name), messages::IGNORED_DISSIPATION_HELP)
            }
            Obstacle::Nonlinear => (messages::ignored_nonlinear(name), messages::IGNORED_NONLINEAR_HELP),
            Obstacle::Undetermined => {
                (messages::ignored_undetermined(name), messages::IGNORED_UNDETERMINED_HELP)
            }
            Obstacle::Undefined => (messages::ignored_undefined(name), messages::IGNORED_UNDEFINED_HELP),
        };
        let place = self.place(model, reduction, terms);
        let error = report.error(self.pinned.span, message);
        if let Some((origin, words)) = place {
            error.related(origin, words);
        }
        error.help(help);
    }

    /// Finds the first statement that is an obstacle.
    fn place(&self, model: &Model, reduction: &Reduction, terms: &Terms) -> Option<(Origin, &'static str)> {
        let mut model = model.clone();
        let zero = model.graph.number(0);
        let mut frozen = holding(&model, &reduction.frozen, zero);
        let speed = model.speeds.iter().find(|speed| speed.coordinate == Some(self.pinned.coordinate))?;
        let position = model.coordinates[self.pinned.coordinate].position;
        let (terms, symbol, words) = match &self.obstacle {
            Obstacle::Load(name) => return Some((*terms.loads.get(name.as_ref()?)?, messages::FORCED_HERE)),
            Obstacle::Energy => (&terms.energies, position, messages::DEPENDS_HERE),
            Obstacle::Dissipation => (&terms.dissipation, speed.velocity, messages::DISSIPATED_HERE),
            _ => return None,
        };
        let depends = |(value, _): &&(ExprId, Origin)| {
            let held = frozen.of(&mut model.graph, *value, 0).map_or(*value, |series| series.closed);
            let depends = match &self.obstacle {
                Obstacle::Energy => independent(&mut model, &[held], &[symbol]),
                _ => {
                    let slope = gradient(&mut model.graph, held, &[symbol]);
                    vanish(&mut model, &slope)
                }
            };
            depends != [true]
        };
        terms.iter().find(depends).map(|(_, origin)| (*origin, words))
    }
}
