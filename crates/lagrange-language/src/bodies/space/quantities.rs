//! Quantities that consist of numbers and terms: known values are computed, others are written.
//!
//! Inertial parameters are regrouped by sums and by products with lengths and direction cosines. In
//! a sum of numbers and parameters, the numbers stay numbers. Products of two quantities with terms
//! are written as a whole: nothing is expanded.

use super::numbers::{value_of_numbers, written_number};
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::AstId;

/// The sum of a number and, if there is one, a term.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Quantity {
    pub(super) number: f64,
    pub(super) term: Option<AstId>,
}

impl Quantity {
    pub(super) const ZERO: Quantity = Quantity::known(0.0);

    pub(super) const fn known(number: f64) -> Quantity {
        Quantity { number, term: None }
    }

    /// Returns the quantity of an expression, with its value if known.
    pub(super) fn of(translation: &Translation<'_>, id: AstId) -> Quantity {
        match value_of_numbers(translation, id) {
            Some(number) => Quantity::known(number),
            None => Quantity { number: 0.0, term: Some(id) },
        }
    }

    /// True for the number zero.
    pub(super) fn is_zero(self) -> bool {
        self.number == 0.0 && self.term.is_none()
    }

    /// Writes the number of a quantity into its term, if it has one.
    pub(super) fn as_term(self, terms: &mut TermWriter<'_>) -> Quantity {
        match self.term {
            None => self,
            Some(_) => Quantity { number: 0.0, term: Some(self.written(terms)) },
        }
    }

    fn as_number(self) -> Option<f64> {
        self.term.is_none().then_some(self.number)
    }

    /// Returns the quantity as one expression.
    pub(super) fn written(self, terms: &mut TermWriter<'_>) -> AstId {
        match self.term {
            None => written_number(terms, self.number),
            Some(term) if self.number == 0.0 => term,
            Some(term) => {
                let number = written_number(terms, self.number);
                terms.plus(number, term)
            }
        }
    }
}

/// Returns a + b.
pub(super) fn sum(terms: &mut TermWriter<'_>, a: Quantity, b: Quantity) -> Quantity {
    let term = match (a.term, b.term) {
        (Some(a), Some(b)) => Some(terms.plus(a, b)),
        (a, b) => a.or(b),
    };
    Quantity { number: a.number + b.number, term }
}

/// Returns a − b, in which equal terms cancel.
pub(super) fn difference(terms: &mut TermWriter<'_>, a: Quantity, b: Quantity) -> Quantity {
    let term = match (a.term, b.term) {
        (Some(a), Some(b)) if a == b => None,
        (Some(a), Some(b)) => Some(terms.minus(a, b)),
        (None, Some(b)) => Some(terms.negative(b)),
        (a, None) => a,
    };
    Quantity { number: a.number - b.number, term }
}

/// Returns a b.
pub(super) fn product(terms: &mut TermWriter<'_>, a: Quantity, b: Quantity) -> Quantity {
    match (a.as_number(), b.as_number()) {
        (Some(a), _) => multiple(terms, a, b),
        (_, Some(b)) => multiple(terms, b, a),
        (None, None) => {
            let (a, b) = (a.written(terms), b.written(terms));
            Quantity { number: 0.0, term: Some(terms.times(a, b)) }
        }
    }
}

fn multiple(terms: &mut TermWriter<'_>, factor: f64, of: Quantity) -> Quantity {
    let term = of.term.filter(|_| factor != 0.0).map(|term| {
        let factor = written_number(terms, factor);
        terms.times(factor, term)
    });
    Quantity { number: factor * of.number, term }
}

/// Returns a · b.
pub(super) fn inner(terms: &mut TermWriter<'_>, a: [Quantity; 3], b: [Quantity; 3]) -> Quantity {
    let products = a.into_iter().zip(b).map(|(a, b)| product(terms, a, b)).collect::<Vec<_>>();
    products.into_iter().fold(Quantity::ZERO, |total, product| sum(terms, total, product))
}
