//! Numbers, parameters and constants, with their units where they are written.

use crate::tree::{Expr, Statement, Unit, Values};

use super::Generator;

/// Exponents of kilogram, metre and second.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Dimension(pub(super) [i32; 3]);

impl Dimension {
    pub(super) const NONE: Dimension = Dimension([0, 0, 0]);
    pub(super) const TIME: Dimension = Dimension([0, 0, 1]);
    pub(super) const LENGTH: Dimension = Dimension([0, 1, 0]);
    pub(super) const MASS: Dimension = Dimension([1, 0, 0]);
    pub(super) const INERTIA: Dimension = Dimension([1, 2, 0]);
    pub(super) const ENERGY: Dimension = Dimension([1, 2, -2]);
    pub(super) const FORCE: Dimension = Dimension([1, 1, -2]);
    pub(super) const GRAVITY: Dimension = Dimension([0, 1, -2]);

    pub(super) fn times(self, other: Dimension) -> Dimension {
        Dimension([0, 1, 2].map(|k| self.0[k] + other.0[k]))
    }

    pub(super) fn over(self, other: Dimension) -> Dimension {
        Dimension([0, 1, 2].map(|k| self.0[k] - other.0[k]))
    }

    pub(super) fn rate(self) -> Dimension {
        self.over(Dimension::TIME)
    }
}

/// Units as powers of ten of the coherent one.
const UNITS: [&[(&str, i32)]; 3] =
    [&[("kg", 0), ("g", -3)], &[("m", 0), ("mm", -3), ("cm", -2)], &[("s", 0), ("ms", -3)]];

impl Generator {
    /// Returns a unit of a dimension, if units are written.
    fn unit(&mut self, dimension: Dimension) -> Option<Unit> {
        if !self.with_units || dimension == Dimension::NONE {
            return None;
        }
        let (mut parts, mut power) = (Vec::new(), 0);
        for (exponent, units) in dimension.0.into_iter().zip(UNITS) {
            let (name, of_one) = units[if self.chance(3) { self.random.below(units.len()) } else { 0 }];
            match exponent {
                0 => continue,
                1 => parts.push(name.to_owned()),
                _ => parts.push(format!("{name}^{exponent}")),
            }
            power += of_one * exponent;
        }
        Some(Unit { text: parts.join("*"), power })
    }

    /// Returns the unit of values at run time.
    pub(super) fn coherent_unit(&mut self, dimension: Dimension) -> Option<Unit> {
        let mut unit = self.unit(dimension);
        while unit.as_ref().is_some_and(|unit| unit.power != 0 || !unit.is_coherent()) {
            unit = self.unit(dimension);
        }
        unit
    }

    /// Returns a number of few digits.
    pub(super) fn decimal(&mut self, low: f64, high: f64) -> String {
        let value = self.random.between(low, high);
        match self.random.below(3) {
            0 => format!("{value:.1}"),
            1 => format!("{value:.2}"),
            _ => format!("{value:.4}"),
        }
    }

    /// Returns a number of few digits in a unit.
    fn decimal_in(&mut self, unit: Option<&Unit>, low: f64, high: f64) -> String {
        let decimal = self.decimal(low, high);
        match unit {
            Some(unit) if unit.power != 0 => format!("{decimal}e{}", -unit.power),
            _ => decimal,
        }
    }

    /// Returns a constant quantity: a number, a parameter, or a constant.
    pub(super) fn quantity(&mut self, dimension: Dimension, low: f64, high: f64) -> Expr {
        let unit = self.unit(dimension);
        let decimal = self.decimal_in(unit.as_ref(), low, high);
        let word = match self.random.below(8) {
            0..3 => return Expr::Number(decimal, unit),
            3 => "const",
            _ => "param",
        };
        let name = self.fresh(&word[..1]);
        let values = Values::One(decimal);
        self.say(Statement::Values { word, name: name.clone(), unit, values });
        Expr::Name(name)
    }

    /// Returns a quantity of either sign.
    pub(super) fn signed(&mut self, dimension: Dimension, size: f64) -> Expr {
        let quantity = self.quantity(dimension, 0.1 * size, size);
        if self.chance(2) { quantity } else { Expr::Negative(Box::new(quantity)) }
    }

    /// Declares a parameter where a quantity must be known to be positive.
    pub(super) fn parameter(&mut self, dimension: Dimension, low: f64, high: f64) -> Expr {
        let unit = self.unit(dimension);
        let decimal = self.decimal_in(unit.as_ref(), low, high);
        let name = self.fresh("p");
        let values = Values::One(decimal);
        self.say(Statement::Values { word: "param", name: name.clone(), unit, values });
        Expr::Name(name)
    }
}

impl Unit {
    fn is_coherent(&self) -> bool {
        ["mm", "cm", "ms", "g"].iter().all(|name| self.text.split(['*', '^']).all(|part| part != *name))
    }
}
