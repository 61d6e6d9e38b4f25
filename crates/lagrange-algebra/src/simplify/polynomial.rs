//! Expanded sums.

use std::collections::BTreeMap;

use super::monomial::{Monomial, Term};
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// A polynomial over opaque expressions, with exact nonzero coefficients. Ordered by monomials, and
/// thus by the age of the expressions in them.
#[derive(Clone, PartialEq, Default, Debug)]
pub(super) struct Polynomial(BTreeMap<Monomial, Number>);

impl Polynomial {
    pub(super) fn of_terms(terms: impl IntoIterator<Item = Term>) -> Polynomial {
        let mut polynomial = Polynomial::default();
        for term in terms {
            polynomial.add(term.monomial, &term.coefficient);
        }
        polynomial
    }

    pub(super) fn constant(value: Number) -> Polynomial {
        Polynomial::of_terms([Term { coefficient: value, monomial: Monomial::default() }])
    }

    /// Creates a polynomial of an opaque expression, of which only numbers and the factors of
    /// products are visible.
    pub(super) fn atom(graph: &Graph, id: ExprId) -> Polynomial {
        let (coefficient, core) = graph.split_coefficient(id);
        match graph.node(core) {
            Node::Number(value) => Polynomial::constant(value.clone()),
            Node::Product(factors) => {
                Polynomial::of_terms([Term { coefficient, monomial: Monomial::new(factors.to_vec()) }])
            }
            _ => {
                let monomial = Monomial::new(vec![(core, Number::ONE)]);
                Polynomial::of_terms([Term { coefficient, monomial }])
            }
        }
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the only term, if there are no others.
    pub(super) fn single(&self) -> Option<(&Monomial, &Number)> {
        self.0.iter().next().filter(|_| self.len() == 1)
    }

    pub(super) fn terms(&self) -> Vec<Term> {
        self.iter().map(|(m, c)| Term { coefficient: c.clone(), monomial: m.clone() }).collect()
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = (&Monomial, &Number)> {
        self.0.iter()
    }

    fn add(&mut self, monomial: Monomial, coefficient: &Number) {
        let total = match self.0.get(&monomial) {
            Some(present) => present + coefficient,
            None => coefficient.clone(),
        };
        if total.is_zero() {
            self.0.remove(&monomial);
        } else {
            self.0.insert(monomial, total);
        }
    }

    pub(super) fn add_scaled(&mut self, other: &Polynomial, scale: &Number) {
        for (monomial, coefficient) in &other.0 {
            self.add(monomial.clone(), &(coefficient * scale));
        }
    }

    pub(super) fn times(&self, other: &Polynomial) -> Polynomial {
        let mut product = Polynomial::default();
        for (m, a) in &self.0 {
            for (n, b) in &other.0 {
                product.add(m.times(n), &(a * b));
            }
        }
        product
    }
}
