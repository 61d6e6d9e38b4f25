//! In which order unknowns are eliminated from the quadratic form, and what is remembered of it.

use super::pivot::{Eliminated, eliminate, eliminate_pair};
use super::queue::{Queue, Waiting};
use crate::collections::HashMap;
use crate::derive::cost::cost;
use crate::derive::quadratic_form::QuadraticForm;
use crate::derive::sweep::{Multiples, Step, Sweep};
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
pub(in crate::derive) enum Move {
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
pub(in crate::derive) struct Elimination {
    pub(in crate::derive) eliminated: Vec<Eliminated>,
    pub(in crate::derive) moves: Vec<Move>,
    /// How the variables that remained at an elimination are made of velocities, if they were not themselves.
    pub(in crate::derive) sweep: Option<Sweep>,
    /// Multipliers of constraints that follow from others wherever they hold.
    pub(in crate::derive) redundant: Vec<ExprId>,
    /// What eliminated velocities have added to the squares of multipliers, but for the sign.
    gained: HashMap<ExprId, Vec<ExprId>>,
    /// By how much a multiplier's square, or the row of a constraint, is larger than what is divided by.
    pub(in crate::derive) ratios: Vec<ExprId>,
}

impl Elimination {
    /// Eliminates all unknowns from a form that has been pushed down: a left-looking LDLᵀ factorisation of
    /// the mass matrix, bordered by the constraints, since every coefficient is summed only when its row is taken.
    /// Multipliers go as soon as their squares, −A M⁻¹ Aᵀ, are complete, which keeps chains of constrained bodies linear, or
    /// after all velocities, whichever counts cheaper. `None` if the matrix is structurally singular.
    pub(in crate::derive) fn dense(
        graph: &mut Graph,
        form: QuadraticForm,
        unknowns: &[ExprId],
    ) -> Option<Elimination> {
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
        let (multipliers, velocities) = separated(graph, unknowns);
        let [unknowns, partners] = [velocities, multipliers].map(|ids| Queue::new(&form, &ids));
        let mut waiting = Waiting { unknowns, partners };
        let mut elimination = Elimination::default();
        elimination.eliminate_massless(graph, &mut form, &mut waiting)?;
        // A multiplier may still share terms with velocities that its constraint does not hold.
        let held = waiting.partners.ids().map(|id| (id, form.near(id).collect::<Vec<_>>()));
        let held = held.collect::<HashMap<_, _>>();
        while !waiting.unknowns.is_empty() {
            elimination.eliminate_next(graph, &mut form, &mut waiting)?;
            if order == Multipliers::Early {
                let is_complete = |_: &Graph, _: &QuadraticForm, velocities: &Queue, id: ExprId| {
                    held.get(&id).is_some_and(|held| !held.iter().any(|&v| velocities.contains(v)))
                };
                elimination.eliminate_complete(graph, &mut form, &mut waiting, is_complete)?;
            }
        }
        elimination.eliminate_all(graph, &mut form, waiting.partners)?;
        Some(elimination)
    }

    /// Eliminates each velocity as soon as nothing unprocessed depends on it, while the rest of the form is
    /// still written in velocities of bodies. On chains and trees the fill-in stays within one body: this is
    /// the articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*, §7) found by ordering.
    /// `None` if a pivot is missing.
    pub(in crate::derive) fn recursive(
        graph: &mut Graph,
        mut form: QuadraticForm,
        unknowns: &[ExprId],
    ) -> Option<Elimination> {
        let (multipliers, velocities) = separated(graph, unknowns);
        // What stands in no product couples nothing, and no velocity need wait for it: first of all the potential, which is often
        // made of all bodies.
        let (heads, first): (Vec<_>, Vec<_>) =
            form.variables().into_iter().partition(|&id| form.is_coupled(id));
        let mut sweep = Sweep::new(graph, [&heads, &first], &velocities, Multiples::Merged);
        let mut waiting = Waiting { partners: Queue::new(&form, &multipliers), ..Waiting::default() };
        let mut elimination = Elimination::default();
        loop {
            if let Some(velocity) = sweep.next_leaf() {
                let step = eliminate(graph, &mut form, velocity)?;
                elimination.push(graph, step);
                waiting.follow(&mut form);
                let is_complete = |graph: &Graph, form: &QuadraticForm, _: &Queue, id: ExprId| {
                    form.near(id).all(|j| is_multiplier(graph, j))
                };
                elimination.eliminate_complete(graph, &mut form, &mut waiting, is_complete)?;
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
        elimination.eliminate_all(graph, &mut form, waiting.partners)?;
        Some(elimination)
    }

    /// Eliminates velocities without any inertia, each together with a multiplier whose constraint determines it.
    fn eliminate_massless(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        waiting: &mut Waiting,
    ) -> Option<()> {
        while let Some(velocity) = waiting.unknowns.first_squareless() {
            let partner = waiting.partners.first_near(form, velocity, |id| !form.has_square(id));
            let Some(multiplier) = partner else { break };
            waiting.unknowns.remove(velocity);
            waiting.partners.remove(multiplier);
            self.push_held(graph, form, velocity, multiplier)?;
            waiting.follow(form);
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

    /// Eliminates the partners, multipliers, to whose squares the velocities have added all that they can.
    fn eliminate_complete(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        waiting: &mut Waiting,
        is_complete: impl Fn(&Graph, &QuadraticForm, &Queue, ExprId) -> bool,
    ) -> Option<()> {
        // What was not complete is not until something happens to it.
        let mut candidates = waiting.partners.take_touched();
        loop {
            let is_ready =
                |id: ExprId| form.has_square(id) && is_complete(graph, form, &waiting.unknowns, id);
            let complete = candidates.iter().copied().filter(|&id| is_ready(id));
            let key = |&id: &ExprId| (form.degree(id), waiting.partners.place(id));
            let Some(id) = complete.min_by_key(key) else { return Some(()) };
            if !form.drop_vanished_square(graph, id) {
                candidates.remove(&id);
                waiting.partners.remove(id);
                let step = eliminate(graph, form, id)?;
                self.push(graph, step);
            }
            waiting.follow(form);
            candidates.append(&mut waiting.partners.take_touched());
        }
    }

    fn eliminate_all(&mut self, graph: &mut Graph, form: &mut QuadraticForm, remaining: Queue) -> Option<()> {
        let mut waiting = Waiting { unknowns: remaining, ..Waiting::default() };
        while !waiting.unknowns.is_empty() {
            self.eliminate_next(graph, form, &mut waiting)?;
        }
        Some(())
    }

    /// Eliminates one of the unknowns; rows with the fewest neighbours go first. What has no square of its own goes with another,
    /// or with one of the partners. A constraint of which nothing is left follows from others.
    fn eliminate_next(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        waiting: &mut Waiting,
    ) -> Option<()> {
        match waiting.unknowns.least_coupled() {
            // What was left of the square may have cancelled; another row, or a pair, goes first then.
            Some(v) if form.drop_vanished_square(graph, v) => {}
            Some(v) => {
                waiting.unknowns.remove(v);
                let step = eliminate(graph, form, v)?;
                self.push(graph, step);
            }
            None => self.eliminate_squareless(graph, form, waiting)?,
        }
        waiting.follow(form);
        Some(())
    }

    /// Eliminates an unknown if none has a square.
    fn eliminate_squareless(
        &mut self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        waiting: &mut Waiting,
    ) -> Option<()> {
        let first = waiting.unknowns.first_squareless()?;
        waiting.unknowns.remove(first);
        if is_multiplier(graph, first) && form.degree(first) == 0 {
            self.redundant.push(first);
            return Some(());
        }
        if let Some(second) = waiting.unknowns.first_near(form, first, |_| true) {
            waiting.unknowns.remove(second);
            self.push_pair(eliminate_pair(graph, form, first, second)?);
            return Some(());
        }
        let partner = waiting.partners.first_near(form, first, |_| true)?;
        waiting.partners.remove(partner);
        if !form.has_square(partner) {
            return self.push_held(graph, form, first, partner);
        }
        // What holds the velocity, which lost its square on the way, gives it another.
        let step = eliminate(graph, form, partner)?;
        waiting.unknowns.push(form, first);
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

/// |whole/part|, one magnitude: nothing will be differentiated that holds it.
fn ratio(graph: &mut Graph, whole: ExprId, part: ExprId) -> ExprId {
    let inverse = graph.reciprocal(part);
    let ratio = graph.multiply(whole, inverse);
    match graph.as_number(ratio) {
        Some(_) => functions::apply(graph, Function::Abs, &[ratio]),
        None => graph.call(Function::Abs, &[ratio]),
    }
}
