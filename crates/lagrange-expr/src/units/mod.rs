//! Units of measurement: their spelling, their dimension, and their factor to coherent SI units.
//!
//! A unit is a product of powers of named units, such as `kg*m^2/s`. It has a [`Dimension`], the
//! exponents of the base units, and a [`Scale`], the exact factor to the coherent unit of that
//! dimension. Numbers at run time are always in coherent units, so units have no run-time cost;
//! other units scale numbers in a declaration.
//!
//! Definitions of units: *The International System of Units*, 9th edition, BIPM 2019, and NIST
//! Special Publication 811, appendix B.

mod dimension;
mod named;
mod spelling;
mod table;
#[cfg(test)]
mod tests;

use std::fmt;

use crate::diagnostics::Origin;
use crate::number::Number;

pub use dimension::{BASE_UNITS, Dimension};
pub use named::{NamedUnit, NamedUnits, component_name, momentum_name};
pub use spelling::{described, noun, spelled};
pub use table::{UnitMeaning, meaning, meant, names};

/// The factor from a unit to the coherent unit: a rational number times a power of π.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Scale {
    /// The rational part.
    pub number: Number,
    /// The exponent of π.
    pub pi: i32,
}

impl Scale {
    /// The scale of coherent units.
    pub const ONE: Scale = Scale { number: Number::ONE, pi: 0 };

    /// True if nothing is scaled.
    pub fn is_one(&self) -> bool {
        *self == Scale::ONE
    }

    /// Returns the nearest number; if π occurs, a number within a few roundings.
    pub fn to_f64(&self) -> f64 {
        self.number.to_f64() * std::f64::consts::PI.powi(self.pi)
    }

    fn times(&self, other: &Scale) -> Scale {
        Scale { number: &self.number * &other.number, pi: self.pi + other.pi }
    }

    /// Returns a power; `None` if it is not a rational number times an integer power of π.
    fn power(&self, exponent: &Number) -> Option<Scale> {
        if self.is_one() {
            return Some(Scale::ONE);
        }
        let exponent = exponent.to_i32()?;
        Some(Scale { number: self.number.power(exponent)?, pi: self.pi.checked_mul(exponent)? })
    }
}

/// A named unit to a power.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnitFactor {
    /// The name, such as `kN`.
    pub name: String,
    /// The exponent, not zero.
    pub exponent: Number,
}

/// A unit as written; without factors it is `1`, the unit of plain numbers.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Factors in the written order.
    pub factors: Vec<UnitFactor>,
    /// Dimension.
    pub dimension: Dimension,
    /// Its factor to the coherent unit.
    pub scale: Scale,
    /// The value of its zero in the coherent unit: 273.15 K for `degC`, otherwise zero.
    pub offset: Number,
    /// Place in the declaration.
    pub origin: Origin,
}

impl Unit {
    /// Creates the product of these factors, which must be known. Returns `None` if the factor to
    /// the coherent unit is not exact, or if one of several factors has its own zero.
    pub fn of(factors: Vec<UnitFactor>, origin: Origin) -> Option<Unit> {
        let (dimension, scale, offset) = (Dimension::NONE, Scale::ONE, Number::ZERO);
        let mut unit = Unit { factors: Vec::new(), dimension, scale, offset, origin };
        for factor in &factors {
            let UnitMeaning { dimension, scale, offset, .. } = meaning(&factor.name)?;
            if !offset.is_zero() && (factors.len() > 1 || factor.exponent != Number::ONE) {
                return None;
            }
            unit.offset = offset;
            unit.dimension = unit.dimension.times(&dimension.power(&factor.exponent));
            unit.scale = unit.scale.times(&scale.power(&factor.exponent)?);
        }
        unit.factors = factors.into_iter().filter(|factor| !factor.exponent.is_zero()).collect();
        Some(unit)
    }

    /// Creates a product of integer powers of coherent units.
    pub fn coherent_of(powers: &[(&str, i8)], origin: Origin) -> Option<Unit> {
        let factor = |(name, exponent): &(&str, i8)| UnitFactor {
            name: (*name).to_owned(),
            exponent: Number::from(i64::from(*exponent)),
        };
        Unit::of(powers.iter().map(factor).collect(), origin)
    }

    /// True if numbers in this unit equal those in the coherent unit.
    pub fn is_coherent(&self) -> bool {
        self.scale.is_one() && self.offset.is_zero()
    }

    /// Returns the unit of the same dimension that numbers have at run time: itself if coherent,
    /// otherwise with its factors replaced by coherent units.
    pub fn coherent(&self) -> Unit {
        if self.is_coherent() {
            return self.clone();
        }
        let mut factors: Vec<UnitFactor> = Vec::new();
        for factor in &self.factors {
            for (name, exponent) in meaning(&factor.name).into_iter().flat_map(|meaning| meaning.coherent) {
                let exponent = &factor.exponent * &Number::from(i64::from(exponent));
                match factors.iter_mut().find(|known| known.name == name) {
                    Some(known) => known.exponent = &known.exponent + &exponent,
                    None => factors.push(UnitFactor { name: name.to_owned(), exponent }),
                }
            }
        }
        Unit::of(factors, self.origin).unwrap_or_else(|| self.clone())
    }
}

/// `kg*m^2/s`, as units are written in declarations.
impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let powers = self.factors.iter().map(|factor| (factor.name.as_str(), factor.exponent.clone()));
        f.write_str(&spelling::product(&powers.collect::<Vec<_>>()))
    }
}
