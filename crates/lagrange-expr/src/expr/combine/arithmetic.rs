//! Arithmetic with one or two operands, by the constructors of sums and products.

use crate::expr::{ExprId, Graph};
use crate::number::Number;

impl Graph {
    /// Returns `a + b`.
    pub fn add(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.sum(Number::ZERO, [(a, Number::ONE), (b, Number::ONE)])
    }

    /// Returns `a - b`.
    pub fn subtract(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.sum(Number::ZERO, [(a, Number::ONE), (b, Number::MINUS_ONE)])
    }

    /// Returns `-a`.
    pub fn negate(&mut self, a: ExprId) -> ExprId {
        self.scale(Number::MINUS_ONE, a)
    }

    /// Returns `c · a`.
    pub fn scale(&mut self, c: Number, a: ExprId) -> ExprId {
        self.sum(Number::ZERO, [(a, c)])
    }

    /// Returns `Σ aᵢ`.
    pub fn total(&mut self, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
        self.sum(Number::ZERO, terms.into_iter().map(|term| (term, Number::ONE)))
    }

    /// Returns `a · b`.
    pub fn multiply(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.product([(a, Number::ONE), (b, Number::ONE)])
    }

    /// Returns `a / b`.
    pub fn divide(&mut self, a: ExprId, b: ExprId) -> ExprId {
        self.product([(a, Number::ONE), (b, Number::MINUS_ONE)])
    }

    /// Returns `1 / a`.
    pub fn reciprocal(&mut self, a: ExprId) -> ExprId {
        self.product([(a, Number::MINUS_ONE)])
    }

    /// Returns `a ^ exponent`.
    pub fn power(&mut self, a: ExprId, exponent: Number) -> ExprId {
        self.product([(a, exponent)])
    }

    /// Returns `a ^ 2`.
    pub fn square(&mut self, a: ExprId) -> ExprId {
        self.power(a, Number::TWO)
    }
}
