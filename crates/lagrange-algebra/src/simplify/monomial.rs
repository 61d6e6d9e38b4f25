//! Flat products, for comparisons that ignore nesting.

use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Maximum number of nested parts of a flat product. Products grow with every elimination; flat
/// copies of all of them would take quadratic time in the length of a chain.
pub(super) const MAX_FACTORS: usize = 16;

/// `Π base ^ exponent`: ascending bases, no exponent zero. Equal monomials are equal values.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Debug)]
pub(super) struct Monomial(Vec<(ExprId, Number)>);

/// `coefficient · monomial`
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Term {
    pub(super) coefficient: Number,
    pub(super) monomial: Monomial,
}

impl Term {
    /// Returns `scale · id` with its factors expanded; an expression with too many of them is a
    /// single factor.
    pub(super) fn of(graph: &Graph, id: ExprId, scale: &Number) -> Term {
        let (inner, core) = graph.split_coefficient(id);
        let coefficient = scale * &inner;
        if let Some(value) = graph.as_number(core) {
            return Term { coefficient: &coefficient * value, monomial: Monomial::default() };
        }
        let flat = Monomial::of(graph, core, MAX_FACTORS);
        Term { coefficient, monomial: flat.unwrap_or_else(|| Monomial::new(vec![(core, Number::ONE)])) }
    }
}

impl Monomial {
    pub(super) fn new(mut factors: Vec<(ExprId, Number)>) -> Monomial {
        factors.sort_unstable_by_key(|(base, _)| *base);
        factors.dedup_by(|later, kept| {
            let same = later.0 == kept.0;
            if same {
                kept.1 = &kept.1 + &later.1;
            }
            same
        });
        factors.retain(|(_, exponent)| !exponent.is_zero());
        Monomial(factors)
    }

    pub(super) fn factors(&self) -> &[(ExprId, Number)] {
        &self.0
    }

    pub(super) fn is_one(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the exponent of a factor.
    pub(super) fn exponent(&self, base: ExprId) -> Option<&Number> {
        self.0.iter().find(|(factor, _)| *factor == base).map(|(_, exponent)| exponent)
    }

    /// Returns the sum of the exponents.
    pub(super) fn degree(&self) -> Number {
        self.0.iter().fold(Number::ZERO, |degree, (_, exponent)| &degree + exponent)
    }

    pub(super) fn times(&self, other: &Monomial) -> Monomial {
        Monomial::new(self.0.iter().chain(&other.0).cloned().collect())
    }

    pub(super) fn times_power(&self, base: ExprId, exponent: i64) -> Monomial {
        self.times(&Monomial(vec![(base, Number::from(exponent))]))
    }

    pub(super) fn power(&self, exponent: &Number) -> Monomial {
        Monomial::new(self.0.iter().map(|(base, e)| (*base, e * exponent)).collect())
    }

    /// Returns `self / other`
    pub(super) fn over(&self, other: &Monomial) -> Monomial {
        self.times(&other.power(&Number::MINUS_ONE))
    }

    /// Returns the largest monomial that divides both, for positive exponents.
    pub(super) fn least(&self, other: &Monomial) -> Monomial {
        let least = |(base, exponent): &(ExprId, Number)| {
            Some((*base, exponent.clone().min(other.exponent(*base)?.clone())))
        };
        Monomial(self.0.iter().filter_map(least).collect())
    }

    /// Returns the factors that `keep` accepts, and the others.
    pub(super) fn split(&self, keep: impl Fn(ExprId, &Number) -> bool) -> (Monomial, Monomial) {
        let (kept, others) = self.0.iter().cloned().partition(|(base, exponent)| keep(*base, exponent));
        (Monomial(kept), Monomial(others))
    }

    pub(super) fn build(&self, graph: &mut Graph) -> ExprId {
        graph.product(self.0.iter().cloned())
    }

    /// Returns the monomial of a product with nested products expanded; `None` if more than `limit`
    /// nodes would have to be visited.
    ///
    /// Integer powers of products are distributed over the factors. Other powers are not: the root
    /// of a product is not the product of the roots if two factors are negative.
    pub(super) fn of(graph: &Graph, id: ExprId, limit: usize) -> Option<Monomial> {
        let mut pending = vec![(id, Number::ONE)];
        let mut factors = Vec::new();
        let mut visited = 0;
        while let Some((id, exponent)) = pending.pop() {
            visited += 1;
            if visited > limit {
                return None;
            }
            match graph.node(id) {
                Node::Product(inner) if exponent.is_integer() => {
                    pending.extend(inner.iter().map(|(base, e)| (*base, e * &exponent)));
                }
                _ => factors.push((id, exponent)),
            }
        }
        Some(Monomial::new(factors))
    }
}
