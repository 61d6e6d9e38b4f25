//! Messages about the syntax of units.

use super::quoted;

pub(in crate::syntax) const UNIT: &str = "a unit";
pub(in crate::syntax) const UNIT_HELP: &str = "units are made of names such as `kg`, `mm` or `N` with `*`, `/` and powers: `kg*m^2/s`, or `1` for plain numbers";
pub(in crate::syntax) const NOT_EXACT: &str = "this root of a unit is not an exact number of SI units";
pub(in crate::syntax) const NOT_EXACT_HELP: &str =
    "take roots of SI units without prefixes, such as `m^(1/2)`";
pub(in crate::syntax) const LARGE_EXPONENT: &str = "this power of a unit is too large";
pub(in crate::syntax) const SEVERAL_FACTORS: &str =
    "a unit of several factors needs square brackets after its number";
pub(in crate::syntax) const BEHIND_NAME: &str = "a unit follows a colon";
pub(in crate::syntax) const WITHOUT_SPACE: &str = "a space is missing between a number and its unit";
pub(in crate::syntax) const ON_LET_FUNCTION: &str = "functions defined by `let` take quantities of any unit";
pub(in crate::syntax) const ON_LET_FUNCTION_HELP: &str =
    "remove the unit: it is checked wherever the function is called";

pub(in crate::syntax) fn behind_name(name: &str, unit: &str) -> String {
    format!("write `param {name}: {unit} = …;`")
}

pub(in crate::syntax) fn unknown(word: &str) -> String {
    format!("{} is not a unit", quoted(word))
}

pub(in crate::syntax) const KELVIN_HELP: &str =
    "write `K`, with 273.15 added to a temperature in degrees Celsius: units are factors";

pub(in crate::syntax) fn write_unit(unit: &str) -> String {
    format!("write {}", quoted(unit))
}

pub(in crate::syntax) fn did_you_mean(unit: &str) -> String {
    format!("did you mean {}?", quoted(unit))
}

pub(in crate::syntax) fn with_space(number: &str, unit: &str) -> String {
    format!("write {}", quoted(&format!("{number} {unit}")))
}

/// Advice where the factors of a unit stand behind a number; `rest` is what the quantity is multiplied with.
pub(in crate::syntax) fn in_brackets(number: &str, unit: &str, rest: &str) -> String {
    format!("write {}", quoted(&format!("{number} [{unit}]{rest}")))
}

/// Advice where a word is the name of a unit and of something that is declared.
pub(in crate::syntax) fn product_or_unit(number: &str, word: &str) -> String {
    format!(
        "write `*` between the factors of a product, or {} for the unit",
        quoted(&format!("{number} [{word}]"))
    )
}
