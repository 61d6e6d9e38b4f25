//! The order in which a quadratic form is pushed from the velocities it was written in down to the
//! generalised velocities.
//!
//! A variable may be pushed when no unprocessed variable depends on it; this is the reverse sweep of
//! Gower and Mello, "A new framework for the computation of Hessians", Optim. Methods Softw. 27 (2012),
//! 251–273, restricted to the part of the graph that is affine in the velocities.

use std::collections::BTreeSet;

use crate::calculus::{Degree, Degrees, partials};
use crate::collections::{HashMap, OrderedMap};
use crate::expr::{ExprId, Graph};

/// An affine variable written in its affine parts.
#[derive(Clone, Debug)]
struct Variable {
    /// `(part, slope)`; empty for a generalised velocity.
    parts: Vec<(ExprId, ExprId)>,
    /// The longest way down to a generalised velocity.
    height: u32,
    /// Position in the order of processing; higher goes first.
    rank: usize,
    /// Variables made of this one that are still unprocessed.
    users: usize,
}

/// What may be processed next.
#[derive(Clone, Debug)]
pub(super) struct Sweep {
    variables: OrderedMap<ExprId, Variable>,
    /// Ready variables by rank.
    inner: BTreeSet<(usize, ExprId)>,
    /// Ready generalised velocities.
    leaves: BTreeSet<ExprId>,
    velocities: HashMap<ExprId, ()>,
}

impl Sweep {
    /// The sweep from `heads`, which must be affine, to `velocities`.
    pub(super) fn new(graph: &mut Graph, heads: &[ExprId], velocities: &[ExprId]) -> Sweep {
        let velocities = velocities.iter().map(|&v| (v, ())).collect::<HashMap<_, _>>();
        let mut sweep = Sweep {
            variables: affine_variables(graph, heads, &velocities),
            inner: BTreeSet::new(),
            leaves: BTreeSet::new(),
            velocities,
        };
        sweep.rank(heads);
        let ids = sweep.variables.iter().map(|(id, _)| *id).collect::<Vec<_>>();
        for &id in &ids {
            for (part, _) in sweep.parts(id).to_vec() {
                if let Some(variable) = sweep.variables.get_mut(&part) {
                    variable.users += 1;
                }
            }
        }
        for id in ids {
            if sweep.variables.get(&id).is_some_and(|variable| variable.users == 0) {
                sweep.make_ready(id);
            }
        }
        sweep
    }

    /// Ranks variables in depth-first order, parts before wholes and the farthest part first. Processing
    /// by falling rank then finishes one body before it turns to the body that carries it.
    fn rank(&mut self, heads: &[ExprId]) {
        let mut heads = heads.to_vec();
        heads.sort_unstable_by_key(|&id| (self.height(id), id));
        let mut visited: HashMap<ExprId, bool> = HashMap::default();
        let mut ranked = 0;
        let mut pending = heads;
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

    fn make_ready(&mut self, id: ExprId) {
        if self.velocities.contains(&id) {
            self.leaves.insert(id);
        } else {
            let rank = self.variables.get(&id).map_or(0, |variable| variable.rank);
            self.inner.insert((rank, id));
        }
    }

    /// The next variable to push, and its parts.
    pub(super) fn next_inner(&mut self) -> Option<(ExprId, Vec<(ExprId, ExprId)>)> {
        let (_, id) = self.inner.pop_last()?;
        let parts = self.parts(id).to_vec();
        for &(part, _) in &parts {
            let Some(variable) = self.variables.get_mut(&part) else { continue };
            variable.users -= 1;
            if variable.users == 0 {
                self.make_ready(part);
            }
        }
        Some((id, parts))
    }

    /// The next generalised velocity that nothing unprocessed depends on.
    pub(super) fn next_leaf(&mut self) -> Option<ExprId> {
        self.leaves.pop_first()
    }

    /// The affine parts of a variable with their slopes.
    pub(super) fn parts(&self, id: ExprId) -> &[(ExprId, ExprId)] {
        self.variables.get(&id).map_or(&[], |variable| &variable.parts)
    }
}

/// Everything affine that the heads are made of, parts before wholes, with heights.
fn affine_variables(
    graph: &mut Graph,
    heads: &[ExprId],
    velocities: &HashMap<ExprId, ()>,
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
        variables.insert(id, Variable { parts, height, rank: 0, users: 0 });
    }
    variables
}

fn affine_parts(graph: &mut Graph, degrees: &Degrees, id: ExprId) -> Vec<(ExprId, ExprId)> {
    let mut parts = partials(graph, id);
    parts.retain(|(part, _)| degrees.of(graph, *part) == Degree::Affine);
    parts
}
