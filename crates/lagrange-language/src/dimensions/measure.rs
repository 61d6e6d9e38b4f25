//! Dimensions of scalars and vectors.

use super::exponents::Exponents;
use crate::syntax::ast::ArrayShape;

/// The known dimension of a number; unknown for zero, which has any dimension, and after a reported
/// error.
pub(super) type MeasuredComponent = Option<Exponents>;

/// The dimension of an expression.
#[derive(Clone, Debug)]
pub(super) struct Measure {
    /// One entry for a scalar, one per component for a vector or matrix.
    pub(super) components: Vec<MeasuredComponent>,
    pub(super) shape: ArrayShape,
    /// True if it contains rates.
    pub(super) has_rates: bool,
}

impl Measure {
    pub(super) fn scalar(component: MeasuredComponent) -> Measure {
        Measure::of(ArrayShape::Scalar, vec![component])
    }

    /// Returns an unknown dimension.
    pub(super) fn any() -> Measure {
        Measure::scalar(None)
    }

    pub(super) fn known(form: Exponents) -> Measure {
        Measure::scalar(Some(form))
    }

    pub(super) fn vector(components: Vec<MeasuredComponent>) -> Measure {
        Measure::of(ArrayShape::Vector(components.len()), components)
    }

    pub(super) fn of(shape: ArrayShape, components: Vec<MeasuredComponent>) -> Measure {
        Measure { components, shape, has_rates: false }
    }

    /// True for everything except vectors and matrices.
    pub(super) fn is_scalar(&self) -> bool {
        self.shape == ArrayShape::Scalar
    }

    /// Returns the measure at these indices; unknown if they are invalid.
    pub(super) fn entry(&self, indices: &[usize]) -> Measure {
        let found = self.shape.entry(indices);
        let entry = found.map(|(places, shape)| Measure::of(shape, self.components[places].to_vec()));
        entry.unwrap_or_else(Measure::any).with_rates(self.has_rates)
    }

    /// Returns the dimension of a scalar; unknown for a vector.
    pub(super) fn form(&self) -> MeasuredComponent {
        if self.is_scalar() { self.components.first().cloned().flatten() } else { None }
    }

    pub(super) fn with_rates(mut self, has_rates: bool) -> Measure {
        self.has_rates |= has_rates;
        self
    }

    /// Applies a change to the dimension of each component.
    pub(super) fn map(&self, change: impl Fn(&Exponents) -> Exponents) -> Measure {
        let components = self.components.iter().map(|component| component.as_ref().map(&change)).collect();
        Measure { components, ..*self }
    }

    /// Returns the measure of a product with a scalar, or of two scalars.
    pub(super) fn times(&self, other: &Measure) -> Measure {
        let (vector, scalar) = if other.is_scalar() { (self, other) } else { (other, self) };
        let product = match scalar.form() {
            Some(factor) => vector.map(|form| form.times(&factor)),
            None => Measure { components: vec![None; vector.components.len()], ..*vector },
        };
        product.with_rates(scalar.has_rates)
    }
}
