//! The order in which a quadratic form is pushed down from its original velocities to the
//! generalised velocities.
//!
//! A variable may be pushed when no unprocessed variable depends on it. This is the reverse sweep
//! of Gower and Mello, restricted to the part of the graph that is affine in the velocities. Its
//! source is "A new framework for the computation of Hessians", Optim. Methods Softw. 27 (2012),
//! 251–273.
//!
//! # The double pendulum, step by step
//!
//! | step | variables | become |
//! |---|---|---|
//! | replace | ẏ₂ | ẏ₁ + l₂ sin θ₂ θ̇₂ |
//! | replace | ẋ₂ | ẋ₁ + l₂ cos θ₂ θ̇₂ |
//! | collapse | l₂ sin θ₂ θ̇₂ and l₂ cos θ₂ θ̇₂, together | multiples of θ̇₂ |
//! | free | θ̇₂ | nothing unprocessed is made of it |
//! | collapse | ẋ₁ and ẏ₁, together | multiples of θ̇₁ |
//! | free | θ̇₁ | |
//!
//! A strategy may eliminate θ̇₂ as soon as it is free, while the form still contains the end ẋ₁, ẏ₁
//! of the upper rod. This is the articulated-body algorithm. A strategy that waits for the last
//! step obtains the mass matrix.

use std::collections::BTreeSet;

use super::plane_rotation::{PendingRotations, TurnedPair, turned_pairs};
use lagrange_algebra::calculus::Degree;
use lagrange_algebra::calculus::Degrees;
use lagrange_algebra::calculus::partials;
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::Graph;

/// An affine variable written in its affine parts.
#[derive(Clone, Debug)]
struct Variable {
    /// `(part, slope)`; empty for a generalised velocity.
    parts: Vec<(ExprId, ExprId)>,
    /// Length of the longest path down to a generalised velocity.
    height: u32,
    /// Position in the order of processing; higher goes first.
    rank: usize,
    /// Variables made of this one that are still unprocessed.
    users: usize,
    /// Multiples of this variable that are to be replaced together.
    multiples: Vec<ExprId>,
}

/// Treatment of a multiple of a multiple of a variable, `l·(cos q·q̇)`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Multiples {
    /// Two substitutions: weights are multiplied by `l` once for everything that is pushed through.
    /// This is cheaper where the coefficients of all velocities meet.
    Kept,
    /// One substitution with the slope `l·cos q`, which positions and accelerations also need. This
    /// is cheaper where few coefficients remain.
    Merged,
}

/// Treatment of pairs of variables that result from rotating others by an angle, see
/// `plane_rotation`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Rotations {
    /// All pairs that turn by the same angle are substituted together, in the normal order. The
    /// inertia of composite bodies keeps its shape, which is cheapest if all velocities are
    /// eliminated at the end.
    InTurn,
    /// The pairs are substituted together when nothing else is left. Inertia that only one joint
    /// moves is thus eliminated in the axes of its body before these are turned.
    Last,
    /// The pairs are treated like any other sums.
    Split,
}

/// Substitution in the form.
#[derive(Debug)]
pub(super) enum Step {
    /// Substitutes the sum of its parts for a variable.
    Replace(ExprId, Vec<(ExprId, ExprId)>),
    /// Substitutes `slope · target` for each of the variables.
    Collapse(ExprId, Vec<(ExprId, ExprId)>),
    /// Substitutes the original pairs for pairs of variables that are turned by the same angle.
    Turn(Vec<TurnedPair>),
}

/// Variables in the order in which they may be processed.
#[derive(Clone, Debug)]
pub(super) struct Sweep {
    variables: OrderedMap<ExprId, Variable>,
    /// Ready variables by rank; one multiple represents all multiples of the same variable.
    inner: BTreeSet<(usize, ExprId)>,
    /// Ready generalised velocities.
    leaves: BTreeSet<ExprId>,
    velocities: HashSet<ExprId>,
    rotations: PendingRotations,
}

impl Sweep {
    /// Creates the sweep from heads, which must be affine, to `velocities`. The heads `first` and
    /// their parts have precedence over everything that they do not depend on.
    pub(super) fn new(
        graph: &mut Graph,
        [heads, first]: [&[ExprId]; 2],
        velocities: &[ExprId],
        multiples: Multiples,
        rotations: Rotations,
    ) -> Sweep {
        let all = [heads, first].concat();
        let velocities = velocities.iter().copied().collect::<HashSet<_>>();
        let mut sweep = Sweep {
            variables: affine_variables(graph, &all, &velocities),
            inner: BTreeSet::new(),
            leaves: BTreeSet::new(),
            velocities,
            rotations: PendingRotations::default(),
        };
        sweep.count_users();
        if multiples == Multiples::Merged {
            sweep.skip_multiples_of_multiples(graph, &all);
            sweep.count_users();
        }
        if rotations != Rotations::Split {
            sweep.join_rotations(graph, &all, rotations == Rotations::Last);
        }
        sweep.rank([heads, first]);
        for id in sweep.ids() {
            if sweep.variables.get(&id).is_some_and(|variable| variable.users == 0) {
                sweep.make_ready(id);
            }
        }
        sweep
    }

    fn ids(&self) -> Vec<ExprId> {
        self.variables.iter().map(|(id, _)| *id).collect()
    }

    fn count_users(&mut self) {
        let ids = self.ids();
        for id in &ids {
            self.variables.get_mut(id).into_iter().for_each(|variable| variable.users = 0);
        }
        for id in ids {
            for (part, _) in self.parts(id).to_vec() {
                self.variables.get_mut(&part).into_iter().for_each(|variable| variable.users += 1);
            }
        }
    }

    /// Writes a multiple of a multiple as a multiple of its base, unless something else needs the
    /// intermediate one. Thus `l·(cos q·q̇)` becomes `(l·cos q)·q̇`, and `l·cos q` often exists
    /// already.
    fn skip_multiples_of_multiples(&mut self, graph: &mut Graph, heads: &[ExprId]) {
        let is_head = heads.iter().copied().collect::<HashSet<_>>();
        for id in self.ids() {
            let &[(part, slope)] = self.parts(id) else { continue };
            let &[(below, inner)] = self.parts(part) else { continue };
            let only_user = self.variables.get(&part).is_some_and(|variable| variable.users == 1);
            if only_user && !is_head.contains(&part) {
                let slope = graph.multiply(slope, inner);
                self.set_parts(id, vec![(below, slope)]);
                self.set_parts(part, Vec::new());
            }
        }
    }

    /// Finds turned pairs; heads are excluded, since they have coefficients of their own.
    fn join_rotations(&mut self, graph: &Graph, heads: &[ExprId], are_last: bool) {
        let is_head = heads.iter().copied().collect::<HashSet<_>>();
        let users = |id: ExprId| self.variables.get(&id).map_or(0, |variable| variable.users);
        let pairs = turned_pairs(
            graph,
            &self.ids(),
            |id| self.parts(id).to_vec(),
            |id| users(id) == 1 && !is_head.contains(&id),
        );
        self.rotations = PendingRotations::new(pairs, are_last);
    }

    fn set_parts(&mut self, id: ExprId, parts: Vec<(ExprId, ExprId)>) {
        if let Some(variable) = self.variables.get_mut(&id) {
            variable.parts = parts;
        }
    }

    /// Ranks variables in depth-first order, parts before wholes and the farthest part first.
    /// Processing in descending rank then finishes one body before the body that carries it.
    fn rank(&mut self, heads: [&[ExprId]; 2]) {
        let by_height = |heads: &[ExprId]| {
            let mut heads = heads.to_vec();
            heads.sort_unstable_by_key(|&id| (self.height(id), id));
            heads
        };
        let mut visited: HashMap<ExprId, bool> = HashMap::default();
        let mut ranked = 0;
        let mut pending = heads.map(by_height).concat();
        pending.reverse();
        while let Some(&id) = pending.last() {
            match visited.get(&id) {
                None => {
                    visited.insert(id, false);
                    let mut parts = self.parts(id).iter().map(|(part, _)| *part).collect::<Vec<_>>();
                    // The last one pushed is visited first.
                    parts.sort_by_key(|&part| self.height(part));
                    pending.extend(parts.into_iter().filter(|part| !visited.contains(part)));
                }
                Some(done) => {
                    let done = *done;
                    pending.pop();
                    if !done {
                        visited.insert(id, true);
                        ranked += 1;
                        if let Some(variable) = self.variables.get_mut(&id) {
                            variable.rank = ranked;
                        }
                    }
                }
            }
        }
    }

    fn height(&self, id: ExprId) -> u32 {
        self.variables.get(&id).map_or(0, |variable| variable.height)
    }

    /// Marks a variable as ready. Called once for each variable, when nothing unprocessed depends
    /// on it.
    fn make_ready(&mut self, id: ExprId) {
        if self.velocities.contains(&id) {
            self.leaves.insert(id);
            return;
        }
        if self.rotations.contains(id) {
            self.rotations.make_ready(id, self.rank_of(id));
            return;
        }
        match *self.parts(id) {
            // The variables that depend on it have skipped it.
            [] => {}
            [(target, _)] => {
                let Some(variable) = self.variables.get_mut(&target) else { return };
                variable.multiples.push(id);
                self.collapse_if_complete(target);
            }
            _ => {
                self.inner.insert((self.rank_of(id), id));
            }
        }
    }

    /// Makes the multiples of a variable ready if nothing else that is unprocessed depends on it.
    fn collapse_if_complete(&mut self, target: ExprId) {
        let Some(variable) = self.variables.get(&target) else { return };
        if variable.users == variable.multiples.len() {
            let last = variable.multiples.iter().map(|&id| (self.rank_of(id), id)).max();
            self.inner.extend(last);
        }
    }

    fn rank_of(&self, id: ExprId) -> usize {
        self.variables.get(&id).map_or(0, |variable| variable.rank)
    }

    /// Returns the next substitution.
    pub(super) fn next_step(&mut self) -> Option<Step> {
        let highest = self.inner.last().map(|(rank, _)| *rank);
        if let Some(pairs) = self.rotations.take_next(highest) {
            return Some(self.turn(pairs));
        }
        let (_, id) = self.inner.pop_last()?;
        if let [(target, _)] = *self.parts(id) {
            return Some(self.collapse(target));
        }
        let parts = self.parts(id).to_vec();
        for &(part, _) in &parts {
            self.variables.get_mut(&part).into_iter().for_each(|variable| variable.users -= 1);
            self.collapse_if_complete(part);
            self.ready_if_unused(part);
        }
        Some(Step::Replace(id, parts))
    }

    fn turn(&mut self, pairs: Vec<TurnedPair>) -> Step {
        for (part, _) in pairs.iter().flat_map(|pair| &pair.parts) {
            // Its users are one multiple by the cosine and one by the sine.
            self.variables.get_mut(part).into_iter().for_each(|variable| variable.users -= 2);
            self.collapse_if_complete(*part);
            self.ready_if_unused(*part);
        }
        Step::Turn(pairs)
    }

    /// True if there are turned pairs.
    pub(super) fn has_rotations(&self) -> bool {
        !self.rotations.is_empty()
    }

    fn collapse(&mut self, target: ExprId) -> Step {
        let multiples = match self.variables.get_mut(&target) {
            Some(variable) => {
                variable.users = 0;
                std::mem::take(&mut variable.multiples)
            }
            None => Vec::new(),
        };
        let slopes =
            multiples.iter().flat_map(|&id| self.parts(id).iter().map(move |&(_, slope)| (id, slope)));
        let slopes = slopes.collect();
        self.ready_if_unused(target);
        Step::Collapse(target, slopes)
    }

    fn ready_if_unused(&mut self, id: ExprId) {
        if self.variables.get(&id).is_some_and(|variable| variable.users == 0) {
            self.make_ready(id);
        }
    }

    /// Returns the next generalised velocity that nothing unprocessed depends on.
    pub(super) fn next_leaf(&mut self) -> Option<ExprId> {
        self.leaves.pop_first()
    }

    /// Returns the affine parts of a variable with their slopes.
    pub(super) fn parts(&self, id: ExprId) -> &[(ExprId, ExprId)] {
        self.variables.get(&id).map_or(&[], |variable| &variable.parts)
    }
}

/// Returns the affine expressions below the heads, parts before wholes, with heights.
fn affine_variables(
    graph: &mut Graph,
    heads: &[ExprId],
    velocities: &HashSet<ExprId>,
) -> OrderedMap<ExprId, Variable> {
    let mut degrees = Degrees::default();
    degrees.classify(graph, heads);
    let mut variables: OrderedMap<ExprId, Variable> = OrderedMap::default();
    for id in graph.reachable_until(heads, |id| velocities.contains(&id)) {
        if degrees.of(graph, id) != Degree::Affine {
            continue;
        }
        let parts = if velocities.contains(&id) { Vec::new() } else { affine_parts(graph, &degrees, id) };
        let heights = parts.iter().filter_map(|(part, _)| Some(variables.get(part)?.height + 1));
        let height = heights.max().unwrap_or(0);
        variables.insert(id, Variable { parts, height, rank: 0, users: 0, multiples: Vec::new() });
    }
    variables
}

fn affine_parts(graph: &mut Graph, degrees: &Degrees, id: ExprId) -> Vec<(ExprId, ExprId)> {
    let mut parts = partials(graph, id);
    parts.retain(|(part, _)| degrees.of(graph, *part) == Degree::Affine);
    parts
}

#[cfg(test)]
mod tests;
