//! Composition of velocities from each other.

use std::collections::{BTreeMap, BTreeSet};

use crate::derive::algebra::{Algebra, LinearForm};
use crate::derive::sweep::Sweep;
use lagrange_algebra::calculus::{AccelerationTerms, Rates};
use lagrange_expr::collections::HashSet;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// An acceleration as `slope·x + Σ rest + drift`, where x is the unknown to be eliminated.
#[derive(Clone, Debug)]
pub(super) struct AffineExpansion {
    pub(super) slope: ExprId,
    pub(super) rest: LinearForm,
    pub(super) drift: ExprId,
}

/// The composition of each variable: y = Σ slope·part, hence ÿ = Σ slope·p̈ + drift.
///
/// Variables may be measured from an offset: the acceleration of y then means ÿ plus the offset.
/// With gravity as the offset of all points, no force of gravity remains.
pub(super) struct Composition {
    parts: HashMap<ExprId, LinearForm>,
    /// Variables made of this one that are still in use.
    users: HashMap<ExprId, BTreeSet<ExprId>>,
    offsets: HashMap<ExprId, ExprId>,
    rates: Rates,
}

impl Composition {
    /// Collects the composition of everything that `heads` depend on.
    pub(super) fn new(sweep: &Sweep, heads: impl IntoIterator<Item = ExprId>) -> Composition {
        let mut parts: HashMap<ExprId, LinearForm> = HashMap::default();
        let mut users: HashMap<ExprId, BTreeSet<ExprId>> = HashMap::default();
        let mut pending = heads.into_iter().collect::<Vec<_>>();
        while let Some(id) = pending.pop() {
            if parts.contains(&id) {
                continue;
            }
            for &(part, _) in sweep.parts(id) {
                users.get_or_insert_with(part, BTreeSet::new).insert(id);
                pending.push(part);
            }
            parts.insert(id, sweep.parts(id).to_vec());
        }
        Composition {
            parts,
            users,
            offsets: HashMap::default(),
            rates: Rates::new(AccelerationTerms::Dropped),
        }
    }

    pub(super) fn parts(&self, id: ExprId) -> &[(ExprId, ExprId)] {
        self.parts.get(&id).map_or(&[], |parts| parts)
    }

    /// Measures a variable from `offset`.
    pub(super) fn set_offset(&mut self, id: ExprId, offset: ExprId) {
        self.offsets.insert(id, offset);
    }

    /// Returns the offset from which a variable is measured.
    pub(super) fn offset(&self, graph: &mut Graph, id: ExprId) -> ExprId {
        self.offsets.get(&id).copied().unwrap_or_else(|| graph.number(0))
    }

    /// Returns the acceleration of a variable if its parts do not accelerate.
    pub(super) fn drift(&mut self, algebra: &mut Algebra<'_>, id: ExprId) -> ExprId {
        let parts = self.parts(id).to_vec();
        let graph = &mut *algebra.graph;
        let offset = self.offset(graph, id);
        if parts.is_empty() {
            return offset;
        }
        let mut rates = vec![(self.rates.of(graph, id), Number::ONE)];
        let mut offsets = vec![(offset, Number::ONE)];
        for (part, slope) in parts {
            let values = [self.rates.of(graph, part), self.offset(graph, part)];
            let [rate, offset] = values.map(|value| graph.multiply(slope, value));
            rates.push((rate, Number::MINUS_ONE));
            offsets.push((offset, Number::MINUS_ONE));
        }
        // The rate of the whole contains those of its parts unchanged. If they were expanded, they
        // might not be found.
        let own = graph.sum(Number::ZERO, rates);
        offsets.push((own, Number::ONE));
        algebra.total(offsets)
    }

    /// Returns the only variable that contains `x` directly, if the slope is a number. Its
    /// acceleration can then replace that of `x` as the unknown, and fewer variables depend on it.
    pub(super) fn only_user(&self, graph: &Graph, x: ExprId) -> Option<(ExprId, Number)> {
        let users = self.users.get(&x)?;
        let user = *users.first().filter(|_| users.len() == 1)?;
        let parts = self.parts(user);
        let (_, slope) = parts.iter().find(|(part, _)| *part == x)?;
        Some((user, graph.as_number(*slope)?.clone()))
    }

    /// Writes every variable that contains `x` in terms of `x` and of variables that do not contain
    /// it.
    pub(super) fn expand(
        &mut self,
        algebra: &mut Algebra<'_>,
        x: ExprId,
    ) -> OrderedMap<ExprId, AffineExpansion> {
        let mut expansions: OrderedMap<ExprId, AffineExpansion> = OrderedMap::default();
        for id in self.made_of(x) {
            let expansion = match id == x {
                true => {
                    let (slope, drift) = (algebra.graph.number(1), algebra.graph.number(0));
                    AffineExpansion { slope, rest: Vec::new(), drift }
                }
                false => self.expand_one(algebra, &expansions, id),
            };
            expansions.insert(id, expansion);
        }
        expansions
    }

    /// Returns every variable that contains `x`, including itself, parts before wholes.
    pub(super) fn made_of(&self, x: ExprId) -> Vec<ExprId> {
        let mut seen: HashSet<ExprId> = HashSet::default();
        let mut found = Vec::new();
        let mut pending = vec![x];
        while let Some(id) = pending.pop() {
            if seen.insert(id) {
                found.push(id);
                pending.extend(self.users.get(&id).into_iter().flatten());
            }
        }
        found.sort_unstable();
        found
    }

    fn expand_one(
        &mut self,
        algebra: &mut Algebra<'_>,
        known: &OrderedMap<ExprId, AffineExpansion>,
        id: ExprId,
    ) -> AffineExpansion {
        let mut slopes = Vec::new();
        let mut rest: BTreeMap<ExprId, Vec<(ExprId, Number)>> = BTreeMap::new();
        let mut drift = vec![(self.drift(algebra, id), Number::ONE)];
        for (part, slope) in self.parts(id).to_vec() {
            let Some(inner) = known.get(&part) else {
                rest.entry(part).or_default().push((slope, Number::ONE));
                continue;
            };
            slopes.push((algebra.graph.multiply(slope, inner.slope), Number::ONE));
            drift.push((algebra.graph.multiply(slope, inner.drift), Number::ONE));
            for &(below, inner) in &inner.rest {
                let product = algebra.graph.multiply(slope, inner);
                rest.entry(below).or_default().push((product, Number::ONE));
            }
        }
        AffineExpansion {
            slope: algebra.total(slopes),
            rest: algebra.linear_form(rest),
            drift: algebra.total(drift),
        }
    }

    /// Removes variables that have been eliminated or expressed by others.
    pub(super) fn retire(&mut self, retired: &[ExprId]) {
        for id in retired {
            for (part, _) in self.parts(*id).to_vec() {
                self.users.get_mut(&part).into_iter().for_each(|users| {
                    users.remove(id);
                });
            }
        }
    }
}
