//! Units of columns, for axes and files.

use std::borrow::Cow;
use std::format;
#[cfg(all(feature = "linear", feature = "plot"))]
use std::string::{String, ToString};

use crate::simulate::builder::ENERGY;
use crate::simulate::table::TIME;
use crate::system::{Description, split_indices};
#[cfg(feature = "plot")]
use lagrange_plot::{label::Label, notation};

/// The unit of plain numbers, which labels omit.
const PLAIN: &str = "1";

/// Returns the unit of a column or a parameter of this name, if it is known; `1` for plain numbers.
pub(crate) fn unit(system: &Description, name: &str) -> Option<&'static str> {
    unit_among(system.units, name)
}

/// Returns a unit from the known ones by name, as [`unit`].
pub(crate) fn unit_among(units: &[(&str, &'static str)], name: &str) -> Option<&'static str> {
    let declared = |name: &str| units.iter().find(|(known, _)| *known == name).map(|(_, unit)| *unit);
    let of_array = || declared(split_indices(name).0);
    declared(name).or_else(of_array).or(match name {
        _ if units.is_empty() => None,
        TIME => Some("s"),
        ENERGY => Some("J"),
        _ => None,
    })
}

/// Returns a name with its unit, as in `x in m`.
pub(super) fn with_unit<'n>(name: &'n str, unit: Option<&str>) -> Cow<'n, str> {
    match unit {
        None | Some(PLAIN) => name.into(),
        Some(unit) => format!("{name} in {unit}").into(),
    }
}

/// Returns the name of a column with its unit.
pub(super) fn labelled<'n>(system: &Description, name: &'n str) -> Cow<'n, str> {
    with_unit(name, unit(system, name))
}

/// Returns a label followed by a unit, as in x in m/s².
#[cfg(feature = "plot")]
pub(crate) fn label_with_unit(label: Label, unit: Option<&str>) -> Label {
    let Some(unit) = unit.filter(|unit| *unit != PLAIN) else { return label };
    let before = if label.is_empty() { "in " } else { " in " };
    label.then(&format!("{before}{}", notation::unit(unit)))
}

/// Returns the unit of an output divided by that of an input; `None` if they are equal or unknown.
#[cfg(all(feature = "linear", feature = "plot"))]
pub(crate) fn quotient([input, output]: [Option<&str>; 2]) -> Option<String> {
    let (input, output) = (input?, output?);
    let factor = |unit: &str| match unit.contains(['*', '/']) {
        true => format!("({unit})"),
        false => unit.to_string(),
    };
    match (output, input) {
        (output, input) if output == input => None,
        (output, PLAIN) => Some(output.to_string()),
        (output, input) => Some(format!("{}/{}", factor(output), factor(input))),
    }
}
