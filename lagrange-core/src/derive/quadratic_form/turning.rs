//! Substitution of pairs of variables that are turned by the same angle.

use std::collections::BTreeMap;

use super::QuadraticForm;
use crate::derive::plane_rotation::{TurnedPair, turned_back, turned_block};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Coefficients of the variables of pairs, with the signs of the turned components.
struct TurnedRows {
    /// Wᵢⱼ between the variables of pairs.
    among: HashMap<(ExprId, ExprId), ExprId>,
    /// cᵢ of each pair.
    linear: Vec<[ExprId; 2]>,
    /// Wᵢⱼ of each pair with other variables j.
    others: Vec<BTreeMap<ExprId, [ExprId; 2]>>,
}

impl QuadraticForm {
    /// Substitutes pairs that are turned by the same angle.
    pub(super) fn turn(&mut self, graph: &mut Graph, pairs: &[TurnedPair]) {
        let Some(TurnedPair { cosine, sine, .. }) = pairs.first() else { return };
        let angle = [*cosine, *sine];
        let rows = self.take_turned(graph, pairs);
        for (n, pair) in pairs.iter().enumerate() {
            let linear = turned_back(graph, angle, rows.linear[n]);
            for ((part, sign), value) in pair.parts.iter().zip(linear) {
                let value = graph.scale(sign.clone(), value);
                self.add_linear(graph, *part, value);
            }
            for (&other, &weights) in &rows.others[n] {
                let weights = turned_back(graph, angle, weights);
                for ((part, sign), value) in pair.parts.iter().zip(weights) {
                    let value = graph.scale(sign.clone(), value);
                    self.add_product(graph, *part, other, value);
                }
            }
            for other in &pairs[n..] {
                self.turn_products(graph, angle, &rows.among, [pair, other]);
            }
        }
    }

    /// Removes the rows of all variables of pairs.
    fn take_turned(&mut self, graph: &mut Graph, pairs: &[TurnedPair]) -> TurnedRows {
        let variables = pairs.iter().flat_map(|pair| pair.turned.iter().cloned());
        let signs = variables.collect::<HashMap<_, _>>();
        let zero = graph.number(0);
        let mut rows = TurnedRows { among: HashMap::default(), linear: Vec::new(), others: Vec::new() };
        for pair in pairs {
            let mut linear = [zero; 2];
            let mut others: BTreeMap<ExprId, [ExprId; 2]> = BTreeMap::new();
            for (side, (id, sign)) in pair.turned.iter().enumerate() {
                let row = self.take(graph, *id);
                linear[side] = graph.scale(sign.clone(), row.linear);
                rows.among.insert((*id, *id), row.own);
                for (other, weight) in row.pairs {
                    let weight = graph.scale(sign.clone(), weight);
                    match signs.get(&other) {
                        Some(sign) => {
                            let weight = graph.scale(sign.clone(), weight);
                            rows.among.insert((*id, other), weight);
                            rows.among.insert((other, *id), weight);
                        }
                        None => others.entry(other).or_insert([zero; 2])[side] = weight,
                    }
                }
            }
            rows.linear.push(linear);
            rows.others.push(others);
        }
        rows
    }

    /// Adds the terms that replace products of variables of two pairs, or of one pair.
    fn turn_products(
        &mut self,
        graph: &mut Graph,
        angle: [ExprId; 2],
        among: &HashMap<(ExprId, ExprId), ExprId>,
        [one, other]: [&TurnedPair; 2],
    ) {
        let zero = graph.number(0);
        let weight = |i: usize, j: usize| among.get(&(one.turned[i].0, other.turned[j].0)).copied();
        let block = [0, 1].map(|i| [0, 1].map(|j| weight(i, j).unwrap_or(zero)));
        if block.iter().flatten().all(|&weight| graph.is_zero(weight)) {
            return;
        }
        let is_same = one.turned[0].0 == other.turned[0].0;
        let block = turned_block(graph, angle, block);
        for (i, row) in block.into_iter().enumerate() {
            // For a single pair, the products are on both sides of the diagonal.
            for (j, terms) in row.into_iter().enumerate().skip(if is_same { i } else { 0 }) {
                let [(x, sign), (y, other_sign)] = [&one.parts[i], &other.parts[j]];
                for term in terms {
                    let value = graph.scale(sign * other_sign, term);
                    match is_same {
                        true => self.add_pair(graph, *x, *y, value),
                        false => self.add_product(graph, *x, *y, value),
                    }
                }
            }
        }
    }

    /// Adds `value·xᵢxⱼ`, also for i = j.
    fn add_product(&mut self, graph: &mut Graph, i: ExprId, j: ExprId, value: ExprId) {
        let value = if i == j { graph.scale(Number::TWO, value) } else { value };
        self.add_pair(graph, i, j, value);
    }
}
