//! Diagnostics for mistakes in units.

/// Message for a unit that is not coherent where there is no number in it.
pub(super) fn nothing_to_convert(name: &str) -> String {
    format!("there is no number here for this unit to scale: values of `{name}` are in units of the SI")
}

pub(super) fn write_coherent(name: &str, unit: &str) -> String {
    format!("write `{name}: {unit}`")
}

/// Message for a value made of names behind a unit that is not coherent.
pub(super) fn made_of_names(unit: &str) -> String {
    format!("values made of names are in units of the SI, not in `{unit}`")
}

pub(super) fn made_of_names_help(name: &str, unit: &str, coherent: &str) -> String {
    format!("write `{name}: {coherent}`, and the unit behind the numbers that are in it: `2 [{unit}]`")
}
