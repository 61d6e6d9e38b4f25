//! Order in which unknowns are eliminated from the quadratic form.

use super::pivot::{Eliminated, eliminate, eliminate_pair};
use super::queue::{Queue, Waiting};
use super::record::{Elimination, Move, is_multiplier, ratio};
use crate::derive::cost::cost;
use crate::derive::quadratic_form::QuadraticForm;
use crate::derive::sweep::{Multiples, Rotations, Sweep};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::functions;

/// Point at which multipliers are eliminated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Multipliers {
    /// Once their squares are complete.
    Early,
    /// After the velocities.
    Late,
}

/// Maximum number of unknowns for which both orders of elimination are tried. For more, the trial
/// would dominate the expansion time.
const LARGEST_TRIAL: usize = 40;

/// Eliminates all unknowns from a form that has been pushed down. This is an LDLᵀ factorisation of
/// the mass matrix, bordered by the constraints. It is left-looking, since a coefficient is only
/// summed when its row is taken. Multipliers are eliminated either as soon as their squares, −A M⁻¹
/// Aᵀ, are complete, or after all velocities. The first order keeps the cost linear for chains of
/// constrained bodies. The cheaper order is kept. `None` if the matrix is structurally singular.
pub(in crate::derive) fn eliminate_dense(
    graph: &mut Graph,
    form: QuadraticForm,
    unknowns: &[ExprId],
) -> Option<Elimination> {
    let early = eliminate_in_order(graph, form.clone(), unknowns, Multipliers::Early);
    let has_multipliers = unknowns.iter().any(|&id| is_multiplier(graph, id));
    if early.is_some() && (!has_multipliers || unknowns.len() > LARGEST_TRIAL) {
        return early;
    }
    let late = eliminate_in_order(graph, form, unknowns, Multipliers::Late);
    let costs = [&early, &late].map(|elimination| {
        let values = elimination.as_ref()?.values(graph, unknowns);
        Some(cost(graph, &values))
    });
    match costs {
        // Early elimination wins a tie: its cost is linear for chains of any length.
        [Some(early), Some(late)] if late < early => {}
        [None, _] => {}
        _ => return early,
    }
    late
}

fn eliminate_in_order(
    graph: &mut Graph,
    mut form: QuadraticForm,
    unknowns: &[ExprId],
    order: Multipliers,
) -> Option<Elimination> {
    let (multipliers, velocities) = separated(graph, unknowns);
    let [unknowns, partners] = [velocities, multipliers].map(|ids| Queue::new(&form, &ids));
    let mut waiting = Waiting { unknowns, partners };
    let mut elimination = Elimination::default();
    eliminate_massless(&mut elimination, graph, &mut form, &mut waiting)?;
    // Later a multiplier may also share terms with velocities that do not occur in its constraint.
    let constrained = waiting.partners.ids().map(|id| (id, form.near(id).collect::<Vec<_>>()));
    let constrained = constrained.collect::<HashMap<_, _>>();
    while !waiting.unknowns.is_empty() {
        eliminate_next(&mut elimination, graph, &mut form, &mut waiting)?;
        if order == Multipliers::Early {
            let is_complete = |_: &Graph, _: &QuadraticForm, velocities: &Queue, id: ExprId| {
                constrained
                    .get(&id)
                    .is_some_and(|constrained| !constrained.iter().any(|&v| velocities.contains(v)))
            };
            eliminate_complete(&mut elimination, graph, &mut form, &mut waiting, is_complete)?;
        }
    }
    eliminate_all(&mut elimination, graph, &mut form, waiting.partners)?;
    Some(elimination)
}

/// Eliminates each velocity as soon as nothing unprocessed depends on it, while the rest of the
/// form is still written in velocities of bodies. On chains and trees the fill-in stays within one
/// body: this is the articulated-body algorithm (Featherstone, *Rigid Body Dynamics Algorithms*,
/// §7) found by ordering. `None` if a pivot is missing.
pub(in crate::derive) fn eliminate_recursive(
    graph: &mut Graph,
    mut form: QuadraticForm,
    unknowns: &[ExprId],
    rotations: Rotations,
) -> Option<Elimination> {
    let (multipliers, velocities) = separated(graph, unknowns);
    // Variables without products couple nothing, so no velocity has to wait for them. The first is
    // the potential, which often depends on all bodies.
    let (heads, first): (Vec<_>, Vec<_>) = form.variables().into_iter().partition(|&id| form.is_coupled(id));
    let mut sweep = Sweep::new(graph, [&heads, &first], &velocities, Multiples::Merged, rotations);
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
            eliminate_complete(&mut elimination, graph, &mut form, &mut waiting, is_complete)?;
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
    eliminate_all(&mut elimination, graph, &mut form, waiting.partners)?;
    Some(elimination)
}

/// Eliminates velocities without inertia, each together with a multiplier whose constraint
/// determines it.
fn eliminate_massless(
    elimination: &mut Elimination,
    graph: &mut Graph,
    form: &mut QuadraticForm,
    waiting: &mut Waiting,
) -> Option<()> {
    while let Some(velocity) = waiting.unknowns.first_squareless() {
        let partner = waiting.partners.first_near(form, velocity, |id| !form.has_square(id));
        let Some(multiplier) = partner else { break };
        waiting.unknowns.remove(velocity);
        waiting.partners.remove(multiplier);
        push_constrained(elimination, graph, form, velocity, multiplier)?;
        waiting.follow(form);
    }
    Some(())
}

/// Eliminates a velocity without inertia with the multiplier of a constraint that determines it.
fn push_constrained(
    elimination: &mut Elimination,
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
    elimination.ratios.push(ratio(graph, size, pair[0].pivot));
    elimination.push_pair(pair);
    Some(())
}

/// Eliminates multipliers among the partners whose squares have received all contributions of
/// velocities.
fn eliminate_complete(
    elimination: &mut Elimination,
    graph: &mut Graph,
    form: &mut QuadraticForm,
    waiting: &mut Waiting,
    is_complete: impl Fn(&Graph, &QuadraticForm, &Queue, ExprId) -> bool,
) -> Option<()> {
    // An incomplete multiplier can only become complete when its terms change.
    let mut candidates = waiting.partners.take_touched();
    loop {
        let is_ready = |id: ExprId| form.has_square(id) && is_complete(graph, form, &waiting.unknowns, id);
        let complete = candidates.iter().copied().filter(|&id| is_ready(id));
        let key = |&id: &ExprId| (form.degree(id), waiting.partners.place(id));
        let Some(id) = complete.min_by_key(key) else { return Some(()) };
        if !form.drop_vanished_square(graph, id) {
            candidates.remove(&id);
            waiting.partners.remove(id);
            let step = eliminate(graph, form, id)?;
            elimination.push(graph, step);
        }
        waiting.follow(form);
        candidates.append(&mut waiting.partners.take_touched());
    }
}

fn eliminate_all(
    elimination: &mut Elimination,
    graph: &mut Graph,
    form: &mut QuadraticForm,
    remaining: Queue,
) -> Option<()> {
    let mut waiting = Waiting { unknowns: remaining, ..Waiting::default() };
    while !waiting.unknowns.is_empty() {
        eliminate_next(elimination, graph, form, &mut waiting)?;
    }
    Some(())
}

/// Eliminates one of the unknowns. The row with the fewest neighbours is first, which limits
/// fill-in (minimum degree; Tinney, Walker, Proc. IEEE 55 (1967) 1801–1809). An unknown without a
/// square is eliminated with another one, or with one of the partners. A constraint that retains no
/// terms follows from others.
fn eliminate_next(
    elimination: &mut Elimination,
    graph: &mut Graph,
    form: &mut QuadraticForm,
    waiting: &mut Waiting,
) -> Option<()> {
    match waiting.unknowns.least_coupled() {
        // The remaining square may have cancelled; then another row, or a pair, is eliminated
        // first.
        Some(v) if form.drop_vanished_square(graph, v) => {}
        Some(v) => {
            waiting.unknowns.remove(v);
            let step = eliminate(graph, form, v)?;
            elimination.push(graph, step);
        }
        None => eliminate_squareless(elimination, graph, form, waiting)?,
    }
    waiting.follow(form);
    Some(())
}

/// Eliminates an unknown when none has a square.
fn eliminate_squareless(
    elimination: &mut Elimination,
    graph: &mut Graph,
    form: &mut QuadraticForm,
    waiting: &mut Waiting,
) -> Option<()> {
    let first = waiting.unknowns.first_squareless()?;
    waiting.unknowns.remove(first);
    form.separate_uncoupled(graph, first);
    if is_multiplier(graph, first) && form.degree(first) == 0 {
        elimination.redundant.push(first);
        return Some(());
    }
    if let Some(second) = waiting.unknowns.first_near(form, first, |_| true) {
        waiting.unknowns.remove(second);
        elimination.push_pair(eliminate_pair(graph, form, first, second)?);
        return Some(());
    }
    let partner = waiting.partners.first_near(form, first, |_| true)?;
    waiting.partners.remove(partner);
    if !form.has_square(partner) {
        return push_constrained(elimination, graph, form, first, partner);
    }
    // The elimination of a partner restores the square of the velocity, which has cancelled.
    let step = eliminate(graph, form, partner)?;
    waiting.unknowns.push(form, first);
    elimination.push(graph, step);
    Some(())
}

/// Separates multipliers from velocities.
fn separated(graph: &Graph, unknowns: &[ExprId]) -> (Vec<ExprId>, Vec<ExprId>) {
    unknowns.iter().partition(|&&id| is_multiplier(graph, id))
}
