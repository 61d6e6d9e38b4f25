//! Elimination: from the quadratic form to mass matrix, forcing and accelerations.

use super::form::QuadraticForm;
use super::pivot::{Eliminated, Rest, eliminate, eliminate_pair, freed};
use super::sweep::{Multiples, Step, Sweep};
use crate::collections::HashMap;
use crate::expr::{Dependencies, ExprId, Function, Graph};
use crate::functions;
use crate::number::Number;

/// Pushes everything down to the generalised velocities.
pub(super) fn push_down(graph: &mut Graph, mut form: QuadraticForm, velocities: &[ExprId]) -> QuadraticForm {
    let mut sweep = Sweep::new(graph, &form.variables(), velocities, Multiples::Kept);
    while let Some(step) = sweep.next_step() {
        form.apply(graph, &step);
    }
    form
}

/// The stationary point of a form, and names for what was computed on the way.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    /// The accelerations in the order of the velocities, then the multipliers.
    pub(super) values: Vec<ExprId>,
    /// Names for pivots, factors and biases.
    pub(super) labels: Vec<(ExprId, String)>,
    /// How much of the constraints the others leave, as [`Elimination::condition`] says; `None` if they are always independent.
    pub(super) condition: Option<ExprId>,
}

/// Solves a form that has been pushed down; `None` if the equations are structurally singular.
pub(super) fn solve_dense(graph: &mut Graph, form: QuadraticForm, unknowns: &[ExprId]) -> Option<Solution> {
    Some(Elimination::dense(graph, form, unknowns)?.solution(graph, unknowns))
}

/// Solves a form body by body; `None` if a pivot is missing.
pub(super) fn solve_recursive(
    graph: &mut Graph,
    form: QuadraticForm,
    unknowns: &[ExprId],
) -> Option<Solution> {
    Some(Elimination::recursive(graph, form, unknowns)?.solution(graph, unknowns))
}

fn is_multiplier(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::MULTIPLIER)
}

/// Multipliers and velocities.
fn separated(graph: &Graph, unknowns: &[ExprId]) -> (Vec<ExprId>, Vec<ExprId>) {
    unknowns.iter().partition(|&&id| is_multiplier(graph, id))
}

/// What happens to the linear part of a form when its velocities are eliminated, in the order in which it happens.
enum Move {
    /// The step with this index.
    Eliminate(usize),
    /// Two steps, this one and the next.
    EliminatePair(usize),
    Substitute(Step),
}

/// Unknowns that have been eliminated from a form.
#[derive(Default)]
pub(super) struct Elimination {
    eliminated: Vec<Eliminated>,
    moves: Vec<Move>,
    /// How the variables that remained at an elimination are made of velocities, if they were not themselves.
    sweep: Option<Sweep>,
    /// Multipliers of constraints that follow from others wherever they hold.
    redundant: Vec<ExprId>,
    /// By how much a multiplier's square, or the row of a constraint, is larger than what is divided by.
    ratios: Vec<ExprId>,
}

impl Elimination {
    /// Eliminates all unknowns from a form that has been pushed down: a left-looking LDLᵀ factorisation of
    /// the mass matrix, bordered by the constraints, since every coefficient is summed only when its row is taken.
    /// Multipliers follow the velocities: their squares, −A M⁻¹ Aᵀ, are complete then. `None` if the matrix is
    /// structurally singular.
    pub(super) fn dense(
        graph: &mut Graph,
        mut form: QuadraticForm,
        unknowns: &[ExprId],
    ) -> Option<Elimination> {
        let (mut multipliers, mut velocities) = separated(graph, unknowns);
        let mut elimination = Elimination::default();
        elimination.eliminate_massless(graph, &mut form, &mut velocities, &mut multipliers)?;
        elimination.eliminate_all(graph, &mut form, velocities, &mut multipliers)?;
        elimination.eliminate_multipliers(graph, &mut form, multipliers)?;
        Some(elimination)
    }

    /// Eliminates each velocity as soon as nothing unprocessed depends on it, while the rest of the form is
    /// still written in velocities of bodies. On chains and trees the fill-in stays within one body: this is
    /// the articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*, §7) found by ordering.
    /// `None` if a pivot is missing.
    pub(super) fn recursive(
        graph: &mut Graph,
        mut form: QuadraticForm,
        unknowns: &[ExprId],
    ) -> Option<Elimination> {
        let (multipliers, velocities) = separated(graph, unknowns);
        let mut sweep = Sweep::new(graph, &form.variables(), &velocities, Multiples::Merged);
        let mut elimination = Elimination::default();
        loop {
            if let Some(velocity) = sweep.next_leaf() {
                elimination.push(eliminate(graph, &mut form, velocity)?);
            } else if let Some(step) = sweep.next_step() {
                form.apply(graph, &step);
                elimination.moves.push(Move::Substitute(step));
            } else {
                break;
            }
        }
        elimination.sweep = Some(sweep);
        if elimination.eliminated.len() < velocities.len() {
            return None;
        }
        elimination.eliminate_multipliers(graph, &mut form, multipliers)?;
        Some(elimination)
    }

    /// Eliminates velocities without any inertia, each together with a multiplier whose constraint determines it.
    fn eliminate_massless(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        velocities: &mut Vec<ExprId>,
        multipliers: &mut Vec<ExprId>,
    ) -> Option<()> {
        while let Some(position) = velocities.iter().position(|&v| !form.has_square(v)) {
            let partner = |&id: &ExprId| form.has_pair(velocities[position], id) && !form.has_square(id);
            let Some(multiplier) = multipliers.iter().position(partner) else { break };
            let (velocity, multiplier) = (velocities.remove(position), multipliers.remove(multiplier));
            self.push_held(graph, form, velocity, multiplier)?;
        }
        Some(())
    }

    /// Eliminates a velocity without inertia with the multiplier of a constraint that determines it.
    fn push_held(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        velocity: ExprId,
        multiplier: ExprId,
    ) -> Option<()> {
        let row = form.couplings(graph, multiplier);
        let pair = eliminate_pair(graph, form, velocity, multiplier)?;
        let parts = row.into_iter().map(|weight| functions::apply(graph, Function::Abs, &[weight]));
        let parts = parts.collect::<Vec<_>>();
        let size = graph.total(parts);
        self.ratios.push(ratio(graph, size, pair[0].pivot));
        self.push_pair(pair);
        Some(())
    }

    /// Eliminates the multipliers, whose squares −A M⁻¹ Aᵀ are complete. A constraint of which nothing is left follows from others.
    fn eliminate_multipliers(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        multipliers: Vec<ExprId>,
    ) -> Option<()> {
        let squares = multipliers.iter().map(|&id| (id, form.coefficient(graph, id, id)));
        let squares = squares.collect::<HashMap<_, _>>();
        let first = self.eliminated.len();
        self.eliminate_all(graph, form, multipliers, &mut Vec::new())?;
        for step in &self.eliminated[first..] {
            let Some(&square) = squares.get(&step.velocity) else { continue };
            self.ratios.push(ratio(graph, square, step.pivot));
        }
        Some(())
    }

    /// Eliminates these unknowns; rows with the fewest neighbours go first. What has no square of its own goes with another, or
    /// with one of `partners`, which is taken out of them.
    fn eliminate_all(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        mut remaining: Vec<ExprId>,
        partners: &mut Vec<ExprId>,
    ) -> Option<()> {
        while !remaining.is_empty() {
            let candidates = remaining.iter().enumerate().filter(|(_, v)| form.has_square(**v));
            match candidates.min_by_key(|(_, v)| form.degree(**v)) {
                // What was left of the square may have cancelled; another row, or a pair, goes first then.
                Some((_, &v)) if form.drop_vanished_square(graph, v) => {}
                Some((position, _)) => self.push(eliminate(graph, form, remaining.remove(position))?),
                None => {
                    let first = remaining.remove(0);
                    if is_multiplier(graph, first) && form.degree(first) == 0 {
                        self.redundant.push(first);
                        continue;
                    }
                    let is_near = |&id: &ExprId| form.has_pair(first, id);
                    if let Some(position) = remaining.iter().position(is_near) {
                        self.push_pair(eliminate_pair(graph, form, first, remaining.remove(position))?);
                    } else {
                        let position = partners.iter().position(|id| is_near(id) && !form.has_square(*id))?;
                        self.push_held(graph, form, first, partners.remove(position))?;
                    }
                }
            }
        }
        Some(())
    }

    fn push_pair(&mut self, pair: [Eliminated; 2]) {
        self.moves.push(Move::EliminatePair(self.eliminated.len()));
        self.eliminated.extend(pair);
    }

    fn push(&mut self, step: Eliminated) {
        self.moves.push(Move::Eliminate(self.eliminated.len()));
        self.eliminated.push(step);
    }

    /// The stationary point of the form.
    pub(super) fn solution(&self, graph: &mut Graph, unknowns: &[ExprId]) -> Solution {
        let free = self.eliminated.iter().map(|step| step.free).collect::<Vec<_>>();
        let values = self.substitute_back(graph, &free, unknowns);
        let condition = self.condition(graph);
        Solution { values, labels: labels(graph, &self.eliminated, unknowns), condition }
    }

    /// The largest of the factors by which rounding grows where constraints are nearly dependent; infinite where they are. `None`
    /// if it is one everywhere.
    fn condition(&self, graph: &mut Graph) -> Option<ExprId> {
        let mut ratios =
            self.ratios.iter().copied().filter(|&ratio| !graph.is_one(ratio)).collect::<Vec<_>>();
        ratios.dedup();
        ratios.into_iter().reduce(|a, b| functions::apply(graph, Function::Max, &[a, b]))
    }

    /// Whether a constraint follows from others wherever they hold.
    pub(super) fn is_redundant(&self) -> bool {
        !self.redundant.is_empty()
    }

    /// The stationary point of the form with another linear part, given by its coefficients at the unknowns: without
    /// constraints M⁻¹ times their opposites, by the factors that are already there.
    pub(super) fn solve_again(
        &self,
        graph: &mut Graph,
        linear: &[ExprId],
        unknowns: &[ExprId],
    ) -> Vec<ExprId> {
        let mut rest = Rest::default();
        unknowns.iter().zip(linear).for_each(|(&v, &value)| rest.add(v, value));
        let mut free = vec![graph.number(0); self.eliminated.len()];
        for step in &self.moves {
            match *step {
                Move::Eliminate(i) => {
                    let step = &self.eliminated[i];
                    let value = rest.take(graph, step.velocity);
                    free[i] = freed(graph, step, value);
                    rest.subtract(graph, &step.factors, value);
                }
                Move::EliminatePair(i) => {
                    // Each of the two accelerations follows from the row of the other, and so do the factors.
                    let (first, second) = (&self.eliminated[i], &self.eliminated[i + 1]);
                    let values = [first, second].map(|step| rest.take(graph, step.velocity));
                    free[i] = freed(graph, first, values[1]);
                    free[i + 1] = freed(graph, second, values[0]);
                    rest.subtract(graph, &second.factors, values[1]);
                    rest.subtract(graph, &first.factors, values[0]);
                }
                Move::Substitute(ref step) => rest.substitute(graph, step),
            }
        }
        self.substitute_back(graph, &free, unknowns)
    }

    fn substitute_back(&self, graph: &mut Graph, free: &[ExprId], unknowns: &[ExprId]) -> Vec<ExprId> {
        let zero = graph.number(0);
        let mut known = self.redundant.iter().map(|&id| (id, zero)).collect::<HashMap<_, _>>();
        for (step, &free) in self.eliminated.iter().zip(free).rev() {
            let mut terms = vec![(free, Number::ONE)];
            for &(j, factor) in &step.factors {
                let value = acceleration_of(graph, &mut known, self.sweep.as_ref(), j);
                terms.push((graph.multiply(factor, value), Number::MINUS_ONE));
            }
            let acceleration = graph.sum(Number::ZERO, terms);
            known.insert(step.velocity, acceleration);
        }
        unknowns.iter().map(|v| known.get(v).copied().unwrap_or(*v)).collect()
    }
}

/// |whole/part|
fn ratio(graph: &mut Graph, whole: ExprId, part: ExprId) -> ExprId {
    let inverse = graph.reciprocal(part);
    let ratio = graph.multiply(whole, inverse);
    functions::apply(graph, Function::Abs, &[ratio])
}

fn labels(graph: &mut Graph, eliminated: &[Eliminated], velocities: &[ExprId]) -> Vec<(ExprId, String)> {
    let index = velocities.iter().enumerate().map(|(i, &v)| (v, i)).collect::<HashMap<_, _>>();
    let mut labels = Vec::new();
    for step in eliminated {
        let Some(i) = index.get(&step.velocity) else { continue };
        labels.push((step.pivot, format!("pivot_{i}")));
        labels.push((graph.negate(step.bias), format!("forcing_{i}")));
        for (j, factor) in &step.factors {
            labels.extend(index.get(j).map(|j| (*factor, format!("factor_{j}_{i}"))));
        }
    }
    labels
}

/// Σ slope · acceleration over the parts of a variable, without recursion.
fn acceleration_of(
    graph: &mut Graph,
    known: &mut HashMap<ExprId, ExprId>,
    sweep: Option<&Sweep>,
    variable: ExprId,
) -> ExprId {
    let parts_of = |id: ExprId| sweep.map_or(&[][..], |sweep| sweep.parts(id));
    let mut pending = vec![variable];
    while let Some(&id) = pending.last() {
        let before = pending.len();
        if !known.contains(&id) {
            pending.extend(parts_of(id).iter().map(|(part, _)| *part).filter(|part| !known.contains(part)));
        }
        if pending.len() > before {
            continue;
        }
        pending.pop();
        if !known.contains(&id) {
            let mut terms = Vec::new();
            for &(part, slope) in parts_of(id) {
                let value = known.get(&part).copied().unwrap_or(part);
                terms.push((graph.multiply(slope, value), Number::ONE));
            }
            let value = graph.sum(Number::ZERO, terms);
            known.insert(id, value);
        }
    }
    known.get(&variable).copied().unwrap_or(variable)
}
