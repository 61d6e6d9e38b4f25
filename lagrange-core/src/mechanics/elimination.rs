//! In which order unknowns are eliminated from the quadratic form, and what is remembered of it.

use super::cost::cost;
use super::form::QuadraticForm;
use super::pivot::{Eliminated, eliminate, eliminate_pair};
use super::sweep::{Multiples, Step, Sweep};
use crate::collections::HashMap;
use crate::expr::{Dependencies, ExprId, Function, Graph};
use crate::functions;

fn is_multiplier(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::MULTIPLIER)
}

/// Multipliers and velocities.
fn separated(graph: &Graph, unknowns: &[ExprId]) -> (Vec<ExprId>, Vec<ExprId>) {
    unknowns.iter().partition(|&&id| is_multiplier(graph, id))
}

/// What happens to the linear part of a form when its velocities are eliminated, in the order in which it happens.
pub(super) enum Move {
    /// The step with this index.
    Eliminate(usize),
    /// Two steps, this one and the next.
    EliminatePair(usize),
    Substitute(Step),
}

/// When multipliers are eliminated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Multipliers {
    /// As soon as they can be.
    Early,
    /// After the velocities.
    Late,
}

/// With more unknowns only one order of elimination is written down.
const LARGEST_TRIAL: usize = 40;

/// Unknowns that have been eliminated from a form.
#[derive(Default)]
pub(super) struct Elimination {
    pub(super) eliminated: Vec<Eliminated>,
    pub(super) moves: Vec<Move>,
    /// How the variables that remained at an elimination are made of velocities, if they were not themselves.
    pub(super) sweep: Option<Sweep>,
    /// Multipliers of constraints that follow from others wherever they hold.
    pub(super) redundant: Vec<ExprId>,
    /// What eliminated velocities have added to the squares of multipliers, but for the sign.
    gained: HashMap<ExprId, Vec<ExprId>>,
    /// By how much a multiplier's square, or the row of a constraint, is larger than what is divided by.
    pub(super) ratios: Vec<ExprId>,
}

impl Elimination {
    /// Eliminates all unknowns from a form that has been pushed down: a left-looking LDLᵀ factorisation of
    /// the mass matrix, bordered by the constraints, since every coefficient is summed only when its row is taken.
    /// Multipliers go as soon as their squares, −A M⁻¹ Aᵀ, are complete, which keeps chains of constrained bodies linear, or
    /// after all velocities, whichever counts cheaper. `None` if the matrix is structurally singular.
    pub(super) fn dense(graph: &mut Graph, form: QuadraticForm, unknowns: &[ExprId]) -> Option<Elimination> {
        let early = Elimination::ordered(graph, form.clone(), unknowns, Multipliers::Early);
        let has_multipliers = unknowns.iter().any(|&id| is_multiplier(graph, id));
        if early.is_some() && (!has_multipliers || unknowns.len() > LARGEST_TRIAL) {
            return early;
        }
        let late = Elimination::ordered(graph, form, unknowns, Multipliers::Late);
        let costs = [&early, &late].map(|elimination| {
            let values = elimination.as_ref()?.values(graph, unknowns);
            Some(cost(graph, &values))
        });
        match costs {
            [Some(early), Some(late)] if late < early => {}
            [None, _] => {}
            _ => return early,
        }
        late
    }

    fn ordered(
        graph: &mut Graph,
        mut form: QuadraticForm,
        unknowns: &[ExprId],
        order: Multipliers,
    ) -> Option<Elimination> {
        let (mut multipliers, mut velocities) = separated(graph, unknowns);
        let mut elimination = Elimination::default();
        elimination.eliminate_massless(graph, &mut form, &mut velocities, &mut multipliers)?;
        let mut partners = multipliers;
        // A multiplier may still share terms with velocities that its constraint does not hold.
        let held = partners.iter().map(|&id| (id, form.near(id).collect::<Vec<_>>()));
        let held = held.collect::<HashMap<_, _>>();
        while !velocities.is_empty() {
            elimination.eliminate_next(graph, &mut form, &mut velocities, &mut partners)?;
            if order == Multipliers::Early {
                let is_free = |id: &ExprId| !velocities.contains(id);
                let is_complete = |_: &Graph, _: &QuadraticForm, id: ExprId| {
                    held.get(&id).is_some_and(|held| held.iter().all(is_free))
                };
                elimination.eliminate_complete(graph, &mut form, &mut partners, is_complete)?;
            }
        }
        elimination.eliminate_all(graph, &mut form, partners)?;
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
        let (mut multipliers, velocities) = separated(graph, unknowns);
        let mut sweep = Sweep::new(graph, &form.variables(), &velocities, Multiples::Merged);
        let mut elimination = Elimination::default();
        loop {
            if let Some(velocity) = sweep.next_leaf() {
                let step = eliminate(graph, &mut form, velocity)?;
                elimination.push(graph, step);
                let is_complete = |graph: &Graph, form: &QuadraticForm, id: ExprId| {
                    form.near(id).all(|j| is_multiplier(graph, j))
                };
                elimination.eliminate_complete(graph, &mut form, &mut multipliers, is_complete)?;
            } else if let Some(step) = sweep.next_step() {
                form.apply(graph, &step);
                elimination.moves.push(Move::Substitute(step));
            } else {
                break;
            }
        }
        elimination.sweep = Some(sweep);
        let is_velocity = |step: &&Eliminated| !is_multiplier(graph, step.velocity);
        if elimination.eliminated.iter().filter(is_velocity).count() < velocities.len() {
            return None;
        }
        elimination.eliminate_all(graph, &mut form, multipliers)?;
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

    /// Eliminates the multipliers to whose squares the velocities have added all that they can.
    fn eliminate_complete(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        multipliers: &mut Vec<ExprId>,
        is_complete: impl Fn(&Graph, &QuadraticForm, ExprId) -> bool,
    ) -> Option<()> {
        loop {
            let is_ready = |id: ExprId| form.has_square(id) && is_complete(graph, form, id);
            let complete = multipliers.iter().enumerate().filter(|(_, id)| is_ready(**id));
            let Some((position, &id)) = complete.min_by_key(|(_, id)| form.degree(**id)) else {
                return Some(());
            };
            if !form.drop_vanished_square(graph, id) {
                multipliers.remove(position);
                let step = eliminate(graph, form, id)?;
                self.push(graph, step);
            }
        }
    }

    fn eliminate_all(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        mut remaining: Vec<ExprId>,
    ) -> Option<()> {
        while !remaining.is_empty() {
            self.eliminate_next(graph, form, &mut remaining, &mut Vec::new())?;
        }
        Some(())
    }

    /// Eliminates one of these unknowns; rows with the fewest neighbours go first. What has no square of its own goes with another,
    /// or with one of `partners`, which is taken out of them. A constraint of which nothing is left follows from others.
    fn eliminate_next(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        remaining: &mut Vec<ExprId>,
        partners: &mut Vec<ExprId>,
    ) -> Option<()> {
        let candidates = remaining.iter().enumerate().filter(|(_, v)| form.has_square(**v));
        if let Some((position, &v)) = candidates.min_by_key(|(_, v)| form.degree(**v)) {
            // What was left of the square may have cancelled; another row, or a pair, goes first then.
            if !form.drop_vanished_square(graph, v) {
                remaining.remove(position);
                let step = eliminate(graph, form, v)?;
                self.push(graph, step);
            }
            return Some(());
        }
        let first = remaining.remove(0);
        if is_multiplier(graph, first) && form.degree(first) == 0 {
            self.redundant.push(first);
            return Some(());
        }
        let is_near = |&id: &ExprId| form.has_pair(first, id);
        if let Some(position) = remaining.iter().position(is_near) {
            self.push_pair(eliminate_pair(graph, form, first, remaining.remove(position))?);
            return Some(());
        }
        let partner = partners.remove(partners.iter().position(is_near)?);
        if !form.has_square(partner) {
            return self.push_held(graph, form, first, partner);
        }
        // What holds the velocity, which lost its square on the way, gives it another.
        remaining.push(first);
        let step = eliminate(graph, form, partner)?;
        self.push(graph, step);
        Some(())
    }

    fn push_pair(&mut self, pair: [Eliminated; 2]) {
        self.moves.push(Move::EliminatePair(self.eliminated.len()));
        self.eliminated.extend(pair);
    }

    /// Keeps a step, and what it says about how independent constraints are: all that velocities add to the square of a
    /// multiplier has one sign, and other multipliers take away from it.
    fn push(&mut self, graph: &mut Graph, step: Eliminated) {
        if is_multiplier(graph, step.velocity) {
            let gained = self.gained.remove(&step.velocity).unwrap_or_default();
            let square = graph.total(gained);
            self.ratios.push(ratio(graph, square, step.pivot));
        } else {
            for &(id, factor) in &step.factors {
                if !is_multiplier(graph, id) {
                    continue;
                }
                let weight = graph.multiply(factor, step.pivot);
                let part = graph.multiply(factor, weight);
                self.gained.get_or_insert_with(id, Vec::new).push(part);
            }
        }
        self.moves.push(Move::Eliminate(self.eliminated.len()));
        self.eliminated.push(step);
    }
}

/// |whole/part|
fn ratio(graph: &mut Graph, whole: ExprId, part: ExprId) -> ExprId {
    let inverse = graph.reciprocal(part);
    let ratio = graph.multiply(whole, inverse);
    functions::apply(graph, Function::Abs, &[ratio])
}
