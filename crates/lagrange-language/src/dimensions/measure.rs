//! Dimensions of scalars and vectors.

use super::exponents::Exponents;

/// The known dimension of a number; unknown for zero, which fits every dimension, and after a
/// reported mistake.
pub(super) type MeasuredComponent = Option<Exponents>;

/// The dimension of an expression.
#[derive(Clone, Debug)]
pub(super) struct Measure {
    /// One entry for a scalar, one per component for a vector.
    pub(super) components: Vec<MeasuredComponent>,
    pub(super) is_vector: bool,
    /// True if it is made of rates.
    pub(super) has_rates: bool,
}

impl Measure {
    pub(super) fn scalar(component: MeasuredComponent) -> Measure {
        Measure { components: vec![component], is_vector: false, has_rates: false }
    }

    /// Returns an unknown dimension.
    pub(super) fn any() -> Measure {
        Measure::scalar(None)
    }

    pub(super) fn known(form: Exponents) -> Measure {
        Measure::scalar(Some(form))
    }

    pub(super) fn vector(components: Vec<MeasuredComponent>) -> Measure {
        Measure { components, is_vector: true, has_rates: false }
    }

    /// Its own dimension; nothing is known of that of a vector.
    pub(super) fn form(&self) -> MeasuredComponent {
        if self.is_vector { None } else { self.components.first().cloned().flatten() }
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
        let (vector, scalar) = if other.is_vector { (other, self) } else { (self, other) };
        let product = match scalar.form() {
            Some(factor) => vector.map(|form| form.times(&factor)),
            None => Measure { components: vec![None; vector.components.len()], ..*vector },
        };
        product.with_rates(scalar.has_rates)
    }
}
