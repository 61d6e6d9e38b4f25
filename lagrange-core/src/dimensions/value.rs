//! Dimensions of scalars and vectors.

use super::form::Form;

/// What is known of the dimension of a number: nothing of zero, which fits all, and of what was reported elsewhere.
pub(super) type Component = Option<Form>;

/// The dimension of an expression.
#[derive(Clone, Debug)]
pub(super) struct Value {
    /// Of a scalar its own, of a vector those of its components.
    pub(super) components: Vec<Component>,
    pub(super) is_vector: bool,
    /// Whether it is made of rates.
    pub(super) has_rates: bool,
}

impl Value {
    pub(super) fn scalar(component: Component) -> Value {
        Value { components: vec![component], is_vector: false, has_rates: false }
    }

    /// Of which nothing is known.
    pub(super) fn any() -> Value {
        Value::scalar(None)
    }

    pub(super) fn known(form: Form) -> Value {
        Value::scalar(Some(form))
    }

    pub(super) fn vector(components: Vec<Component>) -> Value {
        Value { components, is_vector: true, has_rates: false }
    }

    /// Its own dimension; nothing is known of that of a vector.
    pub(super) fn form(&self) -> Component {
        if self.is_vector { None } else { self.components.first().cloned().flatten() }
    }

    pub(super) fn with_rates(mut self, has_rates: bool) -> Value {
        self.has_rates |= has_rates;
        self
    }

    /// The same with another dimension for each component.
    pub(super) fn map(&self, change: impl Fn(&Form) -> Form) -> Value {
        let components = self.components.iter().map(|component| component.as_ref().map(&change)).collect();
        Value { components, ..*self }
    }

    /// That of a product with a scalar, or of two scalars.
    pub(super) fn times(&self, other: &Value) -> Value {
        let (vector, scalar) = if other.is_vector { (other, self) } else { (self, other) };
        let product = match scalar.form() {
            Some(factor) => vector.map(|form| form.times(&factor)),
            None => Value { components: vec![None; vector.components.len()], ..*vector },
        };
        product.with_rates(scalar.has_rates)
    }
}
