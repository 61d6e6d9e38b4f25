//! Dimensions of quantities.

use crate::number::Number;

/// The base units of the SI, in the order of exponents.
pub const BASE_UNITS: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

/// Exponents of the base units.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Dimension([Number; 7]);

impl Dimension {
    /// The dimension of plain numbers and of angles.
    pub const NONE: Dimension = Dimension([Number::ZERO; 7]);

    /// Creates a dimension from whole exponents of the [`BASE_UNITS`].
    pub fn of(exponents: [i8; 7]) -> Dimension {
        Dimension(exponents.map(|exponent| Number::from(i64::from(exponent))))
    }

    /// Returns the exponents of the [`BASE_UNITS`].
    pub fn exponents(&self) -> &[Number; 7] {
        &self.0
    }

    /// True if this is the dimension of plain numbers.
    pub fn is_none(&self) -> bool {
        self.0.iter().all(Number::is_zero)
    }

    /// Returns the dimension of a product.
    pub fn times(&self, other: &Dimension) -> Dimension {
        Dimension(std::array::from_fn(|i| &self.0[i] + &other.0[i]))
    }

    /// Returns the dimension of a quotient.
    pub fn over(&self, other: &Dimension) -> Dimension {
        Dimension(std::array::from_fn(|i| &self.0[i] - &other.0[i]))
    }

    /// Returns the dimension of a power.
    pub fn power(&self, exponent: &Number) -> Dimension {
        Dimension(std::array::from_fn(|i| &self.0[i] * exponent))
    }
}
