//! Units by name in a system.

use crate::collections::OrderedMap;

/// The unit of a field, a column or an output.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NamedUnit {
    /// The unit of its numbers at run time: `rad/s`, `kg*m^2`; `1` for plain numbers. Only outputs
    /// may have other than coherent units.
    pub unit: String,
    /// The declared unit, `mm`, if that is not the unit of the numbers at run time.
    pub declared: Option<String>,
    /// The default in its written unit, `500 mm`, if that is not the coherent unit.
    pub default: Option<String>,
}

impl NamedUnit {
    /// Returns the unit of a quantity whose declaration has the same unit.
    pub fn of(unit: impl Into<String>) -> NamedUnit {
        NamedUnit { unit: unit.into(), declared: None, default: None }
    }
}

/// Units by name, in the order of declaration. Names without an entry have no known unit.
#[derive(Clone, Default, Debug)]
pub struct NamedUnits(OrderedMap<String, NamedUnit>);

impl NamedUnits {
    /// Returns the unit of a name, such as that of a parameter, a coordinate, a velocity or an
    /// output.
    pub fn get(&self, name: &str) -> Option<&NamedUnit> {
        self.0.get(&name.to_owned())
    }

    /// Returns every name that has a unit.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &NamedUnit)> {
        self.0.iter().map(|(name, unit)| (name.as_str(), unit))
    }

    /// Sets the unit of a name, unless it has one.
    pub fn insert(&mut self, name: &str, unit: NamedUnit) {
        self.0.get_or_insert_with(name.to_owned(), || unit);
    }
}

/// Returns the name under which the unit of one component of an output is stored.
pub fn component_name(output: &str, index: usize) -> String {
    format!("{output}.{index}")
}

/// Returns the name under which the unit of the momentum of a coordinate is stored.
pub fn momentum_name(coordinate: &str) -> String {
    format!("momentum of {coordinate}")
}
