//! Polynomials with exact coefficients, differentiated by the power rule: a reference that shares
//! nothing with the calculus under test.

use std::collections::BTreeMap;

use lagrange_core::number::Number;

/// The number of variables: two coordinates, their velocities and one parameter.
pub(crate) const VARIABLES: usize = 5;

/// Coefficients by exponents.
#[derive(Clone, Default, Debug)]
pub(crate) struct Polynomial(BTreeMap<[i32; VARIABLES], Number>);

impl Polynomial {
    pub(crate) fn constant(value: Number) -> Polynomial {
        Polynomial(BTreeMap::from([([0; VARIABLES], value)]))
    }

    pub(crate) fn variable(index: usize) -> Polynomial {
        let exponents = std::array::from_fn(|i| i32::from(i == index));
        Polynomial(BTreeMap::from([(exponents, Number::ONE)]))
    }

    pub(crate) fn plus(&self, other: &Polynomial) -> Polynomial {
        let mut sum = self.clone();
        for (exponents, coefficient) in &other.0 {
            let entry = sum.0.entry(*exponents).or_insert(Number::ZERO);
            *entry = &*entry + coefficient;
        }
        sum
    }

    pub(crate) fn scaled(&self, factor: &Number) -> Polynomial {
        Polynomial(self.0.iter().map(|(exponents, c)| (*exponents, c * factor)).collect())
    }

    pub(crate) fn minus(&self, other: &Polynomial) -> Polynomial {
        self.plus(&other.scaled(&Number::from(-1)))
    }

    pub(crate) fn times(&self, other: &Polynomial) -> Polynomial {
        let mut product = Polynomial::default();
        for (a, factor) in &self.0 {
            let shifted = other.0.iter().map(|(b, c)| (std::array::from_fn(|i| a[i] + b[i]), c * factor));
            product = product.plus(&Polynomial(shifted.collect()));
        }
        product
    }

    pub(crate) fn power(&self, exponent: u32) -> Polynomial {
        (0..exponent).fold(Polynomial::constant(Number::ONE), |power, _| power.times(self))
    }

    /// Returns ∂/∂x for the variable with this index.
    pub(crate) fn derivative(&self, index: usize) -> Polynomial {
        let terms = self.0.iter().filter(|(exponents, _)| exponents[index] > 0).map(|(exponents, c)| {
            let mut lowered = *exponents;
            lowered[index] -= 1;
            (lowered, c * &Number::from(i64::from(exponents[index])))
        });
        Polynomial(terms.collect())
    }

    pub(crate) fn at(&self, point: &[Number; VARIABLES]) -> Number {
        self.0.iter().fold(Number::ZERO, |sum, (exponents, c)| {
            let powers = exponents.iter().zip(point).map(|(&e, x)| x.power(e).expect("no division"));
            &sum + &powers.fold(c.clone(), |product, power| &product * &power)
        })
    }
}
