//! Dimensions that are not yet known: products of powers of unknown dimensions.
//!
//! In terms of exponents, these are linear forms with rational coefficients, so equations between
//! them are solved by elimination. Source: Kennedy, *Dimension types*, ESOP 1994.

use std::collections::BTreeMap;

use lagrange_expr::number::Number;
use lagrange_expr::units::Dimension;

/// The dimension of a name.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Unknown(pub(super) usize);

/// A known dimension times powers of unknown ones.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Exponents {
    pub(super) known: Dimension,
    /// Nonzero exponents of unknown dimensions.
    pub(super) unknowns: BTreeMap<Unknown, Number>,
}

impl Exponents {
    /// Returns the exponents of plain numbers.
    pub(super) fn plain() -> Exponents {
        Exponents::from(Dimension::NONE)
    }

    pub(super) fn of(unknown: Unknown) -> Exponents {
        Exponents { known: Dimension::NONE, unknowns: BTreeMap::from([(unknown, Number::ONE)]) }
    }

    pub(super) fn times(&self, other: &Exponents) -> Exponents {
        self.times_power(other, &Number::ONE)
    }

    pub(super) fn over(&self, other: &Exponents) -> Exponents {
        self.times_power(other, &Number::MINUS_ONE)
    }

    pub(super) fn power(&self, exponent: &Number) -> Exponents {
        Exponents::plain().times_power(self, exponent)
    }

    /// Returns the product with a power of another dimension.
    pub(super) fn times_power(&self, other: &Exponents, exponent: &Number) -> Exponents {
        let mut product = self.clone();
        product.known = product.known.times(&other.known.power(exponent));
        for (unknown, of_other) in &other.unknowns {
            let sum = match product.unknowns.get(unknown) {
                Some(own) => own + &(of_other * exponent),
                None => of_other * exponent,
            };
            match sum.is_zero() {
                true => drop(product.unknowns.remove(unknown)),
                false => drop(product.unknowns.insert(*unknown, sum)),
            }
        }
        product
    }
}

impl From<Dimension> for Exponents {
    fn from(known: Dimension) -> Exponents {
        Exponents { known, unknowns: BTreeMap::new() }
    }
}
