//! The quadratic form ½ Σ Wᵢⱼ xᵢ xⱼ + Σ cᵢ xᵢ over expressions that are affine in the velocities.

mod turning;

use std::collections::{BTreeMap, BTreeSet};

use super::sweep::Step;
use lagrange_algebra::simplify;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// A sum that is still being collected.
type Contributions = Vec<(ExprId, Number)>;

/// The row of one variable, removed from the form.
#[derive(Debug)]
pub(super) struct FormRow {
    /// Wᵢᵢ
    pub(super) own: ExprId,
    /// `(j, Wᵢⱼ)` for the other variables, in ascending order.
    pub(super) pairs: Vec<(ExprId, ExprId)>,
    /// cᵢ
    pub(super) linear: ExprId,
}

/// A symmetric quadratic form. Contributions to a coefficient are collected, and summed only when
/// the coefficient is needed. The complete sum lets the simplifier find terms that cancel.
#[derive(Clone, Default, Debug)]
pub(super) struct QuadraticForm {
    /// Wᵢⱼ under its ordered pair of variables.
    pairs: BTreeMap<(ExprId, ExprId), Contributions>,
    neighbours: HashMap<ExprId, BTreeSet<ExprId>>,
    linear: BTreeMap<ExprId, Contributions>,
    /// Variables that shared terms with removed variables, and variables that have lost their
    /// squares.
    changed: BTreeSet<ExprId>,
}

impl QuadraticForm {
    /// Adds `value·xᵢxⱼ` for i ≠ j and `½·value·xᵢ²` for i = j.
    pub(super) fn add_pair(&mut self, graph: &Graph, i: ExprId, j: ExprId, value: ExprId) {
        if graph.is_zero(value) {
            return;
        }
        self.pairs.entry((i.min(j), i.max(j))).or_default().push((value, Number::ONE));
        self.neighbours.get_or_insert_with(i, BTreeSet::new).insert(j);
        self.neighbours.get_or_insert_with(j, BTreeSet::new).insert(i);
    }

    /// Adds `value·xᵢ`.
    pub(super) fn add_linear(&mut self, graph: &Graph, i: ExprId, value: ExprId) {
        if !graph.is_zero(value) {
            self.linear.entry(i).or_default().push((value, Number::ONE));
        }
    }

    /// Adds every term of another form.
    pub(super) fn add(&mut self, other: &QuadraticForm) {
        for (&(i, j), contributions) in &other.pairs {
            self.pairs.entry((i, j)).or_default().extend_from_slice(contributions);
            self.neighbours.get_or_insert_with(i, BTreeSet::new).insert(j);
            self.neighbours.get_or_insert_with(j, BTreeSet::new).insert(i);
        }
        for (&i, contributions) in &other.linear {
            self.linear.entry(i).or_default().extend_from_slice(contributions);
        }
    }

    /// True if more than half of all pairs of `count` variables occur.
    pub(super) fn is_mostly_full(&self, count: usize) -> bool {
        self.pairs.len() * 4 > count * (count + 1)
    }

    /// True if any term contains xᵢ.
    pub(super) fn contains(&self, i: ExprId) -> bool {
        self.is_coupled(i) || self.linear.contains_key(&i)
    }

    /// True if a square or product contains xᵢ.
    pub(super) fn is_coupled(&self, i: ExprId) -> bool {
        self.neighbours.get(&i).is_some_and(|near| !near.is_empty())
    }

    /// Returns the variables that occur.
    pub(super) fn variables(&self) -> Vec<ExprId> {
        let quadratic = self.pairs.keys().flat_map(|&(i, j)| [i, j]);
        quadratic.chain(self.linear.keys().copied()).collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// Counts the other variables that share a term with this one.
    pub(super) fn degree(&self, i: ExprId) -> usize {
        self.neighbours.get(&i).map_or(0, |near| near.len() - usize::from(near.contains(&i)))
    }

    /// Takes the variables whose squares and neighbours may have changed since the last call,
    /// because of removed terms.
    pub(super) fn take_changed(&mut self) -> BTreeSet<ExprId> {
        std::mem::take(&mut self.changed)
    }

    /// True if xᵢ² occurs.
    pub(super) fn has_square(&self, i: ExprId) -> bool {
        self.pairs.contains_key(&(i, i))
    }

    /// Returns Wᵢⱼ.
    pub(super) fn coefficient(&self, graph: &mut Graph, i: ExprId, j: ExprId) -> ExprId {
        total(graph, self.pairs.get(&(i.min(j), i.max(j))).cloned())
    }

    /// Returns the other variables that share a term with i.
    pub(super) fn near(&self, i: ExprId) -> impl Iterator<Item = ExprId> {
        self.neighbours.get(&i).into_iter().flatten().copied().filter(move |&j| j != i)
    }

    /// Returns Wᵢⱼ for all variables j that share a term with i.
    pub(super) fn couplings(&self, graph: &mut Graph, i: ExprId) -> Vec<ExprId> {
        self.near(i).map(|j| self.coefficient(graph, i, j)).collect()
    }

    /// Returns sign·Wᵢⱼ in rows, with one row for each of `rows` and one entry for each of
    /// `columns`.
    pub(super) fn matrix(
        &self,
        graph: &mut Graph,
        sign: &Number,
        rows: &[ExprId],
        columns: &[ExprId],
    ) -> Vec<Vec<ExprId>> {
        let zero = graph.number(0);
        let places = columns.iter().enumerate().map(|(place, &j)| (j, place)).collect::<HashMap<_, _>>();
        let row = |&i: &ExprId| {
            let mut row = vec![zero; columns.len()];
            let near = self.neighbours.get(&i).into_iter().flatten();
            let mut near = near.filter_map(|&j| Some((*places.get(&j)?, j))).collect::<Vec<_>>();
            near.sort_unstable();
            for (place, j) in near {
                let weight = self.coefficient(graph, i, j);
                row[place] = graph.scale(sign.clone(), weight);
            }
            row
        };
        rows.iter().map(row).collect()
    }

    /// Returns cᵢ.
    pub(super) fn linear(&self, graph: &mut Graph, i: ExprId) -> ExprId {
        total(graph, self.linear.get(&i).cloned())
    }

    /// Removes the terms with xᵢ xⱼ, i ≠ j.
    pub(super) fn separate(&mut self, i: ExprId, j: ExprId) {
        self.pairs.remove(&(i.min(j), i.max(j)));
        self.neighbours.get_or_insert_with(i, BTreeSet::new).remove(&j);
        self.neighbours.get_or_insert_with(j, BTreeSet::new).remove(&i);
    }

    /// Removes xᵢ² if its coefficient is zero, and returns true in this case.
    pub(super) fn drop_vanished_square(&mut self, graph: &mut Graph, i: ExprId) -> bool {
        let square = self.coefficient(graph, i, i);
        let vanished = graph.is_zero(square);
        if vanished {
            self.pairs.remove(&(i, i));
            self.changed.insert(i);
        }
        vanished
    }

    /// Removes the products xᵢxⱼ whose coefficients are zero.
    pub(super) fn separate_uncoupled(&mut self, graph: &mut Graph, i: ExprId) {
        for j in self.near(i).collect::<Vec<_>>() {
            let product = self.coefficient(graph, i, j);
            if graph.is_zero(product) {
                self.separate(i, j);
            }
        }
    }

    /// Removes every term with xᵢ and returns its row.
    pub(super) fn take(&mut self, graph: &mut Graph, i: ExprId) -> FormRow {
        let near = self.neighbours.remove(&i).unwrap_or_default();
        let own = total(graph, self.pairs.remove(&(i, i)));
        let mut pairs = Vec::with_capacity(near.len());
        for j in near.into_iter().filter(|&j| j != i) {
            let value = total(graph, self.pairs.remove(&(i.min(j), i.max(j))));
            self.neighbours.get_or_insert_with(j, BTreeSet::new).remove(&i);
            self.changed.insert(j);
            if !graph.is_zero(value) {
                pairs.push((j, value));
            }
        }
        let linear = total(graph, self.linear.remove(&i));
        FormRow { own, pairs, linear }
    }

    /// Substitutes xᵢ = Σ slope · part.
    pub(super) fn push(&mut self, graph: &mut Graph, i: ExprId, parts: &[(ExprId, ExprId)]) {
        let row = self.take(graph, i);
        if !graph.is_zero(row.own) {
            self.push_square(graph, row.own, parts);
        }
        for &(a, slope) in parts {
            let linear = graph.multiply(slope, row.linear);
            self.add_linear(graph, a, linear);
            for &(j, weight) in &row.pairs {
                let value = graph.multiply(slope, weight);
                let value = if a == j { graph.scale(Number::TWO, value) } else { value };
                self.add_pair(graph, a, j, value);
            }
        }
    }

    /// Adds ½·own·(Σ slope · part)². The time is quadratic in the number of parts, as is the size
    /// of the result.
    fn push_square(&mut self, graph: &mut Graph, own: ExprId, parts: &[(ExprId, ExprId)]) {
        for (n, &(a, slope)) in parts.iter().enumerate() {
            // W·slope is shared by every pair with `a`.
            let weighted = graph.multiply(slope, own);
            let square = graph.multiply(slope, weighted);
            self.add_pair(graph, a, a, square);
            for &(b, other) in &parts[n + 1..] {
                let value = graph.multiply(other, weighted);
                self.add_pair(graph, a, b, value);
            }
        }
    }
}

/// Substitution of multiples of one variable.
impl QuadraticForm {
    /// Performs one step of a sweep.
    pub(super) fn apply(&mut self, graph: &mut Graph, step: &Step) {
        match step {
            Step::Replace(id, parts) => self.push(graph, *id, parts),
            Step::Collapse(target, multiples) => self.collapse(graph, *target, multiples),
            Step::Turn(pairs) => self.turn(graph, pairs),
        }
    }

    /// Substitutes xᵢ = tᵢ·y for all `multiples` (xᵢ, tᵢ) of y at once.
    ///
    /// The square of y then gets Σ tⱼ·wⱼ with wⱼ = Σ tᵢ Wᵢⱼ. If xⱼ is not one of the multiples, for
    /// example the velocity of the carrying body, wⱼ is also its coefficient with y.
    fn collapse(&mut self, graph: &mut Graph, y: ExprId, multiples: &[(ExprId, ExprId)]) {
        let mut among: BTreeMap<ExprId, Contributions> = BTreeMap::new();
        let slope_of = multiples.iter().copied().collect::<HashMap<_, _>>();
        for &(i, slope) in multiples {
            let row = self.take(graph, i);
            let linear = graph.multiply(slope, row.linear);
            self.add_linear(graph, y, linear);
            among.entry(i).or_default().push((graph.multiply(slope, row.own), Number::ONE));
            for (j, weight) in row.pairs {
                let value = graph.multiply(slope, weight);
                if let Some(&other) = slope_of.get(&j) {
                    among.entry(j).or_default().push((value, Number::ONE));
                    among.entry(i).or_default().push((graph.multiply(other, weight), Number::ONE));
                } else {
                    let value = if j == y { graph.scale(Number::TWO, value) } else { value };
                    self.add_pair(graph, y, j, value);
                }
            }
        }
        for &(j, slope) in multiples {
            let weight = total(graph, among.remove(&j));
            let square = graph.multiply(slope, weight);
            self.add_pair(graph, y, y, square);
        }
    }
}

fn total(graph: &mut Graph, contributions: Option<Contributions>) -> ExprId {
    simplify::collect(graph, contributions.unwrap_or_default())
}
