//! Power series in time, each with its first variations.
//!
//! A jet is x(τ) = x₀ + x₁ τ + x₂ τ² along a motion, with its first-order change along neighbouring
//! motions. Arithmetic with jets needs nothing but the chain rule (Griewank and Walther,
//! *Evaluating Derivatives*, 2nd ed., chapter 13). The rate of a jet is its derivative by τ. No
//! formula is ever differentiated.

use std::collections::HashMap;

use lagrange_core::expr::Function;
use lagrange_core::number::Number;

use crate::digits::{Arithmetic, Real};
use crate::random::Random;

/// Known coefficients from the constant one upwards. A vanishing variation has none.
pub(crate) type Series = Vec<Real>;

/// The series of a motion with its variations.
#[derive(Clone, Debug)]
pub(crate) struct Jet {
    pub(crate) value: Series,
    pub(crate) variations: Vec<Series>,
}

/// Number of coefficients of coordinates: energies contain rates, and equations of motion the rates
/// of momenta.
pub(crate) const ORDERS: usize = 3;
/// Number of derivatives that a composition takes: those of the series, and one more for
/// variations.
const DERIVATIVES: usize = ORDERS + 1;

/// Arithmetic with jets, either exact or with a small random change of every result.
pub(crate) struct Field {
    pub(crate) arithmetic: Arithmetic,
    pub(crate) variations: usize,
    noise: Option<Noise>,
    decimals: HashMap<String, Real>,
    /// Values of functions, shared by all motions from a state.
    functions: HashMap<(Function, Vec<u64>), Real>,
}

/// Relative changes of results, the same for equal results, which show how roundings grow (Vignes,
/// "A stochastic arithmetic for reliable scientific computation", 1993).
struct Noise {
    bits: i32,
    seed: u64,
}

impl Field {
    pub(crate) fn exact(bits: usize) -> Field {
        Field {
            arithmetic: Arithmetic::new(bits),
            variations: 0,
            noise: None,
            decimals: HashMap::new(),
            functions: HashMap::new(),
        }
    }

    /// Returns a field that changes every result by a relative 2⁻ⁿ, or by a half or a quarter of
    /// that.
    pub(crate) fn noisy(bits: usize, n: i32, seed: u64) -> Field {
        let noise = Noise { bits: n, seed };
        Field { noise: Some(noise), ..Field::exact(bits) }
    }

    /// Returns a result, or a nearby number.
    pub(crate) fn rounded(&mut self, value: Real) -> Real {
        let Some(noise) = &self.noise else { return value };
        if value.is_zero() {
            return value;
        }
        let mut random =
            Random::of_case(noise.seed ^ fingerprint(&value).into_iter().fold(0, u64::wrapping_add));
        let mut change = value.clone();
        change.set_exponent(value.exponent().unwrap_or(0) - noise.bits - random.below(3) as i32);
        if random.below(2) == 0 {
            change.inv_sign();
        }
        self.arithmetic.add(&value, &change)
    }

    pub(crate) fn sum(&mut self, a: &Real, b: &Real) -> Real {
        match (a.is_zero(), b.is_zero()) {
            (true, _) => b.clone(),
            (_, true) => a.clone(),
            _ => {
                let sum = self.arithmetic.add(a, b);
                self.rounded(sum)
            }
        }
    }

    pub(crate) fn product(&mut self, a: &Real, b: &Real) -> Real {
        if a.is_zero() || b.is_zero() {
            return self.integer(0);
        }
        let product = self.arithmetic.multiply(a, b);
        self.rounded(product)
    }

    pub(crate) fn quotient(&mut self, a: &Real, b: &Real) -> Real {
        let quotient = self.arithmetic.divide(a, b);
        self.rounded(quotient)
    }

    pub(crate) fn integer(&self, value: i32) -> Real {
        self.arithmetic.integer(value)
    }

    pub(crate) fn function(&mut self, function: Function, arguments: &[Real]) -> Real {
        let fingerprints = arguments.iter().flat_map(fingerprint).collect();
        let key = (function, fingerprints);
        if let Some(known) = self.functions.get(&key) {
            return known.clone();
        }
        let value = self.arithmetic.call(function, arguments);
        let value = self.rounded(value);
        self.functions.insert(key, value.clone());
        value
    }

    /// Returns a jet that is constant on all motions.
    pub(crate) fn constant(&mut self, value: Real) -> Jet {
        let value = self.rounded(value);
        self.series(&[value])
    }

    /// Returns a jet of all orders from its first coefficients, without variations.
    pub(crate) fn series(&self, first: &[Real]) -> Jet {
        let mut value = first.to_vec();
        value.resize(ORDERS, self.integer(0));
        Jet { value, variations: vec![Vec::new(); self.variations] }
    }

    /// Returns a number of the declaration.
    pub(crate) fn decimal(&mut self, text: &str) -> Jet {
        let known = self.decimals.get(text).cloned();
        let value = known.unwrap_or_else(|| self.arithmetic.decimal(text));
        self.decimals.insert(text.to_owned(), value.clone());
        self.constant(value)
    }

    pub(crate) fn whole(&self, value: i32) -> Jet {
        self.series(&[self.integer(value)])
    }

    fn series_sum(&mut self, a: &Series, b: &Series) -> Series {
        if a.is_empty() || b.is_empty() {
            return if a.is_empty() { b.clone() } else { a.clone() };
        }
        a.iter().zip(b).map(|(a, b)| self.sum(a, b)).collect()
    }

    fn series_product(&mut self, a: &Series, b: &Series) -> Series {
        let count = a.len().min(b.len());
        let coefficient = |k: usize| {
            (0..=k).fold(self.integer(0), |sum, i| {
                let product = self.product(&a[i], &b[k - i]);
                self.sum(&sum, &product)
            })
        };
        (0..count).map(coefficient).collect()
    }

    /// Returns a coefficient of a variation.
    pub(crate) fn change(&self, of: &Jet, variation: usize, order: usize) -> Real {
        of.variations[variation].get(order).cloned().unwrap_or_else(|| self.integer(0))
    }

    pub(crate) fn add(&mut self, a: &Jet, b: &Jet) -> Jet {
        let value = self.series_sum(&a.value, &b.value);
        let pairs = a.variations.iter().zip(&b.variations);
        Jet { value, variations: pairs.map(|(a, b)| self.series_sum(a, b)).collect() }
    }

    pub(crate) fn negate(&self, a: &Jet) -> Jet {
        let negated = |series: &Series| series.iter().map(Real::neg).collect();
        Jet { value: negated(&a.value), variations: a.variations.iter().map(negated).collect() }
    }

    pub(crate) fn subtract(&mut self, a: &Jet, b: &Jet) -> Jet {
        let b = self.negate(b);
        self.add(a, &b)
    }

    pub(crate) fn multiply(&mut self, a: &Jet, b: &Jet) -> Jet {
        let value = self.series_product(&a.value, &b.value);
        let pairs = a.variations.iter().zip(&b.variations);
        let variations = pairs.map(|(da, db)| {
            let [left, right] = [self.series_product(da, &b.value), self.series_product(&a.value, db)];
            self.series_sum(&left, &right)
        });
        Jet { value, variations: variations.collect() }
    }

    pub(crate) fn divide(&mut self, a: &Jet, b: &Jet) -> Jet {
        let inverse = self.power(b, &Number::MINUS_ONE);
        self.multiply(a, &inverse)
    }

    /// Returns Σ aᵢ bᵢ.
    pub(crate) fn dot(&mut self, a: &[Jet], b: &[Jet]) -> Jet {
        let zero = self.whole(0);
        a.iter().zip(b).fold(zero, |sum, (a, b)| {
            let product = self.multiply(a, b);
            self.add(&sum, &product)
        })
    }

    /// Returns the derivative by τ, with one known coefficient less.
    pub(crate) fn rate(&mut self, a: &Jet) -> Jet {
        let mut of = |series: &Series| {
            let rest = series.iter().enumerate().skip(1);
            rest.map(|(k, c)| self.product(&self.integer(k as i32), c)).collect()
        };
        Jet { value: of(&a.value), variations: a.variations.iter().map(&mut of).collect() }
    }

    /// Returns f(a) from f and its derivatives at a₀.
    pub(crate) fn compose(&mut self, a: &Jet, derivatives: &[Real; DERIVATIVES]) -> Jet {
        let value = self.composed(&a.value, &derivatives[..ORDERS]);
        let slope = self.composed(&a.value, &derivatives[1..]);
        let variations = a.variations.iter().map(|change| self.series_product(&slope, change)).collect();
        Jet { value, variations }
    }

    /// Returns f₀, f₁ a₁, f₁ a₂ + f₂ a₁²/2.
    fn composed(&mut self, a: &Series, derivatives: &[Real]) -> Series {
        let mut found = vec![derivatives[0].clone()];
        for k in 1..a.len() {
            let mut coefficient = self.product(&derivatives[1], &a[k]);
            if k == 2 {
                let square = self.product(&a[1], &a[1]);
                let square = self.product(&derivatives[2], &square);
                let half = self.product(&square, &self.arithmetic.float(0.5));
                coefficient = self.sum(&coefficient, &half);
            }
            found.push(coefficient);
        }
        found
    }
}

/// Returns words that identify a number.
fn fingerprint(value: &Real) -> Vec<u64> {
    let mut words = value.mantissa_digits().unwrap_or_default().to_vec();
    let exponent = i64::from(value.exponent().unwrap_or(0));
    words.extend([exponent.cast_unsigned(), u64::from(value.is_negative())]);
    words
}
