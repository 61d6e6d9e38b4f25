//! Quotients without common factors of numerator and denominator.

use super::monomial::MAX_FACTORS;
use super::monomial::Monomial;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::Graph;
use lagrange_expr::expr::Node;
use lagrange_expr::number::Number;

/// Maximum depth of the search for common factors in sums. Common factors of all terms are found
/// near the top, and each level expands shared sums.
const DEEPEST: usize = 6;

/// Returns `numerator / denominator`. Factors that a product in the denominator shares with all
/// terms of the numerator are cancelled. Other common factors are factored out. Both only happen if
/// the formula becomes shorter.
pub fn quotient(graph: &mut Graph, numerator: ExprId, denominator: ExprId) -> ExprId {
    let plain = graph.divide(numerator, denominator);
    let (scale, core) = graph.split_coefficient(denominator);
    let Some(below) = Monomial::of(graph, core, MAX_FACTORS) else { return plain };
    let mut canceller = Canceller::default();
    let common = canceller.common_factor(graph, numerator, DEEPEST);
    let cancels = |(base, _): &(ExprId, Number)| below.exponent(*base).is_some_and(|e| !e.is_negative());
    if !common.factors().iter().any(cancels) {
        return plain;
    }
    let rest = canceller.divide(graph, numerator, &common, DEEPEST);
    let factor = common.over(&below).build(graph);
    let product = graph.multiply(rest, factor);
    let cancelled = graph.scale(scale.reciprocal().unwrap_or(Number::ONE), product);
    // Cancelling expands shared sums, which only pays off if the result is shorter.
    if graph.written_size(cancelled) < graph.written_size(plain) { cancelled } else { plain }
}

/// Results for parts of one numerator, so that repeated parts are examined only once.
#[derive(Default)]
struct Canceller {
    common: HashMap<ExprId, Monomial>,
    divided: HashMap<(ExprId, Monomial), ExprId>,
}

impl Canceller {
    /// Returns the positive powers that divide an expression, found within `depth` levels of
    /// nesting.
    fn common_factor(&mut self, graph: &Graph, id: ExprId, depth: usize) -> Monomial {
        if let Some(known) = self.common.get(&id) {
            return known.clone();
        }
        let (_, core) = graph.split_coefficient(id);
        let common = match graph.node(core) {
            Node::Number(_) => Monomial::default(),
            Node::Sum { constant, terms } if depth > 0 && constant.is_zero() => {
                let mut parts = terms.iter().map(|(term, _)| self.common_factor(graph, *term, depth - 1));
                let first = parts.next().unwrap_or_default();
                parts.fold(first, |common, part| common.least(&part))
            }
            Node::Product(_) if depth > 0 => {
                let flat = Monomial::of(graph, core, MAX_FACTORS).unwrap_or_default();
                let positive = flat.factors().iter().filter(|(_, e)| e.is_integer() && !e.is_negative());
                positive.fold(Monomial::default(), |common, (base, exponent)| {
                    common.times(&self.common_factor(graph, *base, depth - 1).power(exponent))
                })
            }
            _ => Monomial::new(vec![(core, Number::ONE)]),
        };
        self.common.insert(id, common.clone());
        common
    }

    /// Divides an expression by positive powers that divide it, within its sums.
    fn divide(&mut self, graph: &mut Graph, id: ExprId, divisor: &Monomial, depth: usize) -> ExprId {
        if divisor.is_one() {
            return id;
        }
        let key = (id, divisor.clone());
        if let Some(&known) = self.divided.get(&key) {
            return known;
        }
        let (coefficient, core) = graph.split_coefficient(id);
        // An expression divided by itself is not examined.
        let is_opened = depth > 0 && divisor.exponent(core).is_none();
        let quotient = match graph.node(core).clone() {
            Node::Sum { constant, terms } if is_opened && constant.is_zero() => {
                let terms =
                    terms.iter().map(|(t, c)| (self.divide(graph, *t, divisor, depth - 1), c.clone()));
                let terms = terms.collect();
                flat_sum(graph, terms)
            }
            Node::Product(_) if is_opened => self.divide_product(graph, core, divisor, depth),
            _ => {
                let one_over = divisor.power(&Number::MINUS_ONE).build(graph);
                graph.multiply(core, one_over)
            }
        };
        let quotient = graph.scale(coefficient, quotient);
        self.divided.insert(key, quotient);
        quotient
    }

    /// Divides each factor by its common factor with the divisor.
    fn divide_product(
        &mut self,
        graph: &mut Graph,
        product: ExprId,
        divisor: &Monomial,
        depth: usize,
    ) -> ExprId {
        let Some(flat) = Monomial::of(graph, product, MAX_FACTORS) else {
            let one_over = divisor.power(&Number::MINUS_ONE).build(graph);
            return graph.multiply(product, one_over);
        };
        let mut remaining = divisor.clone();
        let mut factors = Vec::new();
        for (base, exponent) in flat.factors() {
            if remaining.is_one() || !exponent.is_one() {
                factors.push((*base, exponent.clone()));
                continue;
            }
            let part = self.common_factor(graph, *base, depth - 1).least(&remaining);
            remaining = remaining.over(&part);
            factors.push((self.divide(graph, *base, &part, depth - 1), Number::ONE));
        }
        let left = remaining.power(&Number::MINUS_ONE);
        graph.product(factors.into_iter().chain(left.factors().iter().cloned()))
    }
}

/// Returns the sum of terms with nested sums and products expanded, so that terms cancel.
fn flat_sum(graph: &mut Graph, terms: Vec<(ExprId, Number)>) -> ExprId {
    let mut constant = Number::ZERO;
    let mut flat = Vec::new();
    for (term, coefficient) in terms {
        let (inner, core) = graph.split_coefficient(term);
        let scale = &inner * &coefficient;
        match graph.node(core).clone() {
            Node::Sum { constant: shift, terms } => {
                constant = &constant + &(&shift * &scale);
                flat.extend(terms.iter().map(|(term, c)| (flat_product(graph, *term), c * &scale)));
            }
            _ => flat.push((flat_product(graph, core), scale)),
        }
    }
    graph.sum(constant, flat)
}

fn flat_product(graph: &mut Graph, id: ExprId) -> ExprId {
    match graph.node(id) {
        Node::Product(_) => Monomial::of(graph, id, MAX_FACTORS).map_or(id, |flat| flat.build(graph)),
        _ => id,
    }
}

#[cfg(test)]
mod tests {
    use super::quotient;
    use lagrange_expr::expr::{Function, Graph};
    use lagrange_expr::functions::apply;
    use lagrange_expr::number::Number;
    use lagrange_expr::symbol::Role;

    #[test]
    fn what_all_terms_share_with_the_denominator_is_cancelled() {
        let mut g = Graph::new();
        let [m, l, k] = [("m", 0), ("l", 1), ("k", 2)].map(|(name, i)| g.symbol(name, Role::Parameter(i)));
        let x = g.symbol("x", Role::Coordinate(0));
        let sin = apply(&mut g, Function::Sin, &[x]);
        let product = |g: &mut Graph, factors: &[_]| g.product(factors.iter().map(|&f| (f, Number::ONE)));
        let inertia = product(&mut g, &[m, l, l]);
        let weight = product(&mut g, &[m, l, k, sin]);
        let moment = g.scale(Number::MINUS_ONE, weight);
        let numerator = product(&mut g, &[k, sin]);
        let flat = g.product([(k, Number::ONE), (sin, Number::ONE), (l, Number::MINUS_ONE)]);
        let expected = g.negate(flat);
        assert_eq!(quotient(&mut g, moment, inertia), expected);

        let nested = g.add(weight, inertia);
        let nested = product(&mut g, &[l, nested]);
        let short = g.add(numerator, l);
        assert_eq!(quotient(&mut g, nested, inertia), short);

        let shifted = g.sum(Number::ONE, [(x, Number::ONE)]);
        let numerator = product(&mut g, &[m, k, shifted]);
        let denominator = product(&mut g, &[m, shifted, shifted]);
        let expected = g.divide(k, shifted);
        assert_eq!(quotient(&mut g, numerator, denominator), expected);

        let forcing = product(&mut g, &[m, shifted]);
        let expected = g.divide(shifted, k);
        let inertia_by_k = product(&mut g, &[m, k]);
        assert_eq!(quotient(&mut g, forcing, inertia_by_k), expected);

        let foreign = g.add(weight, k);
        let plain = g.divide(foreign, inertia);
        assert_eq!(quotient(&mut g, foreign, inertia), plain);
    }
}
