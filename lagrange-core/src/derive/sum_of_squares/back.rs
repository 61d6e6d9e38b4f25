//! Back substitution: the accelerations in reverse order of elimination.

use std::collections::BTreeMap;

use super::composition::{AffineExpansion, Composition};
use crate::derive::algebra::{Algebra, LinearForm};
use crate::derive::elimination::solution::Solution;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::ExprId;
use lagrange_expr::number::Number;

/// One eliminated unknown, standing for a velocity.
pub(super) struct EliminatedUnknown {
    pub(super) velocity: ExprId,
    /// The variable whose acceleration was eliminated.
    pub(super) unknown: ExprId,
    /// Links from the velocity up to the unknown.
    pub(super) ways: Vec<Way>,
    /// Ratio of the unknown to the acceleration of its variable.
    pub(super) scale: ExprId,
    pub(super) pivot: ExprId,
    pub(super) rule: Substitution,
    /// Variables that become known together with the unknown.
    pub(super) expansions: OrderedMap<ExprId, AffineExpansion>,
}

/// `part` enters only through `whole`, with the slope 1/inverse.
pub(super) struct Way {
    pub(super) part: ExprId,
    pub(super) whole: ExprId,
    pub(super) inverse: Number,
}

/// Rule by which an unknown follows from accelerations that are already known.
pub(super) enum Substitution {
    /// −Σ factor · variable − free
    Plain { factors: LinearForm, free: ExprId },
    /// The tangential acceleration of two carriers is −bend · normal − offset.
    InFrame { carriers: [(ExprId, AffineExpansion); 2], bend: ExprId, offset: ExprId },
}

/// An acceleration as `Σ coefficient · component + constant`. The components are computed; the sum
/// is only formed when it is needed, often as part of another sum.
#[derive(Clone)]
struct AffineValue {
    components: LinearForm,
    constant: ExprId,
}

pub(super) fn substitute_back(
    algebra: Algebra<'_>,
    composition: Composition,
    steps: &[EliminatedUnknown],
    velocities: &[ExprId],
) -> Solution {
    let index = velocities.iter().enumerate().map(|(i, &v)| (v, i)).collect();
    let mut back = Back { algebra, composition, known: HashMap::default(), index, labels: Vec::new() };
    for step in steps.iter().rev() {
        back.take(step);
    }
    let accelerations = velocities.iter().map(|&velocity| {
        let value = back.known(velocity);
        let value = back.evaluate(&value);
        let offset = back.composition.offset(back.algebra.graph, velocity);
        back.algebra.graph.subtract(value, offset)
    });
    Solution {
        values: accelerations.collect(),
        labels: back.labels,
        guards: back.algebra.guards,
        condition: None,
        elimination: None,
    }
}

struct Back<'g> {
    algebra: Algebra<'g>,
    composition: Composition,
    known: HashMap<ExprId, AffineValue>,
    index: HashMap<ExprId, usize>,
    labels: Vec<(ExprId, String)>,
}

impl Back<'_> {
    fn take(&mut self, step: &EliminatedUnknown) {
        self.label(step.pivot, "pivot", step);
        let unknown = match &step.rule {
            Substitution::Plain { factors, free } => {
                let graph = &mut *self.algebra.graph;
                let terms =
                    factors.iter().map(|&(id, factor)| (graph.negate(factor), id)).collect::<Vec<_>>();
                let constant = graph.negate(*free);
                let value = self.combine(&terms, constant);
                self.evaluate(&value)
            }
            Substitution::InFrame { carriers, bend, offset } => {
                self.take_in_frame(step, carriers, *bend, *offset)
            }
        };
        let acceleration = self.algebra.graph.divide(unknown, step.scale);
        let value = self.component(acceleration);
        self.known.insert(step.unknown, value);
        for (id, expansion) in step.expansions.iter() {
            if !self.known.contains(id) {
                let value = self.moved(expansion, unknown);
                self.known.insert(*id, value);
            }
        }
        for way in step.ways.iter().rev() {
            self.go_down(way);
        }
    }

    /// Computes two carriers in the frame of the direction in which the unknown moves them; returns
    /// the unknown.
    fn take_in_frame(
        &mut self,
        step: &EliminatedUnknown,
        carriers: &[(ExprId, AffineExpansion); 2],
        bend: ExprId,
        offset: ExprId,
    ) -> ExprId {
        let [(x, a), (y, b)] = carriers;
        let graph = &mut *self.algebra.graph;
        let opposite = graph.negate(b.slope);
        let normal = self.combine_rest(&[(opposite, a), (a.slope, b)]);
        let normal = self.evaluate(&normal);
        self.label(normal, "normal", step);
        let graph = &mut *self.algebra.graph;
        let bent = graph.multiply(bend, normal);
        let reverse = graph.add(bent, offset);
        self.label(reverse, "minus_tangential", step);
        let carried = self.combine_rest(&[(a.slope, a), (b.slope, b)]);
        let carried = self.evaluate(&carried);
        for (id, along, across) in [(*x, a.slope, opposite), (*y, b.slope, a.slope)] {
            let mut components = vec![(reverse, self.algebra.graph.negate(along)), (normal, across)];
            components.sort_unstable_by_key(|(component, _)| *component);
            let constant = self.algebra.graph.number(0);
            self.known.insert(id, AffineValue { components, constant });
        }
        let graph = &mut *self.algebra.graph;
        let value = graph.add(reverse, carried);
        graph.negate(value)
    }

    /// Returns Σ coefficient · y′ over expansions, where y′ is the part without the unknown.
    fn combine_rest(&mut self, expansions: &[(ExprId, &AffineExpansion)]) -> AffineValue {
        let mut terms = Vec::new();
        let mut drifts = Vec::new();
        for &(coefficient, expansion) in expansions {
            for &(part, slope) in &expansion.rest {
                terms.push((self.algebra.graph.multiply(coefficient, slope), part));
            }
            drifts.push((coefficient, expansion.drift, Number::ONE));
        }
        let drift = self.algebra.products(&drifts);
        let drift = self.algebra.factored(drift);
        self.combine(&terms, drift)
    }

    /// Returns the acceleration of a variable that the unknown moves.
    fn moved(&mut self, expansion: &AffineExpansion, unknown: ExprId) -> AffineValue {
        let one = self.algebra.graph.number(1);
        let rest = self.combine_rest(&[(one, expansion)]);
        let rest = self.evaluate(&rest);
        let graph = &mut *self.algebra.graph;
        let step = graph.multiply(expansion.slope, unknown);
        let value = graph.add(rest, step);
        self.component(value)
    }

    /// Computes the acceleration of a part from that of the whole.
    fn go_down(&mut self, Way { part, whole, inverse }: &Way) {
        let drift = self.composition.drift(&mut self.algebra, *whole);
        let graph = &mut *self.algebra.graph;
        let mut terms = vec![(graph.number(1), *whole)];
        for &(other, slope) in self.composition.parts(*whole).iter().filter(|(id, _)| id != part) {
            terms.push((graph.negate(slope), other));
        }
        let drift = graph.negate(drift);
        let value = self.combine(&terms, drift);
        let value = self.evaluate(&value);
        let value = self.algebra.graph.scale(inverse.clone(), value);
        let value = self.component(value);
        self.known.insert(*part, value);
    }

    /// Returns Σ coefficient · variable + constant.
    fn combine(&mut self, terms: &[(ExprId, ExprId)], constant: ExprId) -> AffineValue {
        let mut components: BTreeMap<ExprId, Vec<(ExprId, ExprId, Number)>> = BTreeMap::new();
        let mut constants = vec![(constant, Number::ONE)];
        for &(coefficient, id) in terms {
            let value = self.known(id);
            for (component, inner) in value.components {
                components.entry(component).or_default().push((coefficient, inner, Number::ONE));
            }
            constants.push((self.algebra.graph.multiply(coefficient, value.constant), Number::ONE));
        }
        let components = self.algebra.form_of_products(components);
        AffineValue { components, constant: self.algebra.total(constants) }
    }

    fn known(&mut self, id: ExprId) -> AffineValue {
        match self.known.get(&id) {
            Some(value) => value.clone(),
            None => self.component(id),
        }
    }

    fn component(&mut self, id: ExprId) -> AffineValue {
        let graph = &mut *self.algebra.graph;
        AffineValue { components: vec![(id, graph.number(1))], constant: graph.number(0) }
    }

    fn evaluate(&mut self, value: &AffineValue) -> ExprId {
        let graph = &mut *self.algebra.graph;
        let mut terms = vec![(value.constant, Number::ONE)];
        for &(component, coefficient) in &value.components {
            terms.push((graph.multiply(coefficient, component), Number::ONE));
        }
        graph.sum(Number::ZERO, terms)
    }

    fn label(&mut self, id: ExprId, name: &str, step: &EliminatedUnknown) {
        let index = self.index.get(&step.velocity);
        self.labels.extend(index.map(|i| (id, format!("{name}_{i}"))));
    }
}
