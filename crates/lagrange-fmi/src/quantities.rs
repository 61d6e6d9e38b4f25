//! Units of measurement as unit definitions of the FMI standard.

use std::collections::BTreeMap;
use std::fmt::Write;

use lagrange_core::syntax::parse_unit;
use lagrange_core::units::{Unit, UnitFactor};

/// Base units of the standard, in the order of the exponents of a dimension.
const BASES: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];
/// Unit of angles, which are plain numbers.
const RADIAN: &str = "rad";

/// Units by name.
#[derive(Default)]
pub(crate) struct Definitions {
    units: BTreeMap<String, Unit>,
}

impl Definitions {
    /// Defines a unit, or the unit of a rate of change in it. Returns its name; `None` for plain
    /// numbers and unknown units.
    pub(crate) fn define(&mut self, unit: Option<&str>, is_rate: bool) -> Option<String> {
        let unit = parse_unit(unit?)?;
        let unit = if is_rate { per_second(&unit)? } else { unit };
        let name = unit.to_string();
        if unit.factors.is_empty() {
            return None;
        }
        self.units.insert(name.clone(), unit);
        Some(name)
    }

    /// Returns the element that defines all units; it is empty without units.
    pub(crate) fn written(&self) -> String {
        let units = self.units.iter().map(|(name, unit)| match base(unit) {
            Some(base) => format!("    <Unit name=\"{name}\">\n      {base}\n    </Unit>\n"),
            None => format!("    <Unit name=\"{name}\"/>\n"),
        });
        let units = units.collect::<String>();
        if units.is_empty() { units } else { format!("  <UnitDefinitions>\n{units}  </UnitDefinitions>\n") }
    }
}

fn per_second(unit: &Unit) -> Option<Unit> {
    let mut factors = unit.factors.clone();
    match factors.iter_mut().find(|factor| factor.name == "s") {
        Some(factor) => factor.exponent = &factor.exponent - &1.into(),
        None => factors.push(UnitFactor { name: "s".to_owned(), exponent: (-1).into() }),
    }
    Unit::of(factors, unit.origin)
}

/// Returns the unit in base units; `None` for fractional exponents, which the standard does not
/// support.
fn base(unit: &Unit) -> Option<String> {
    let mut base = "<BaseUnit".to_owned();
    let radians = unit.factors.iter().find(|factor| factor.name == RADIAN).map(|factor| &factor.exponent);
    let bases = BASES.iter().zip(unit.dimension.exponents()).map(|(name, exponent)| (*name, exponent));
    for (name, exponent) in bases.chain(radians.map(|exponent| (RADIAN, exponent))) {
        let exponent = exponent.to_i32()?;
        if exponent != 0 {
            write!(base, " {name}=\"{exponent}\"").ok()?;
        }
    }
    if !unit.is_coherent() {
        write!(base, " factor=\"{:?}\"", unit.scale.to_f64()).ok()?;
    }
    if !unit.offset.is_zero() {
        write!(base, " offset=\"{:?}\"", unit.offset.to_f64()).ok()?;
    }
    Some(base + "/>")
}
