//! Messages about the syntax of units.

use super::quoted;
use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::syntax):

    UNIT = "a unit";
    UNIT_HELP =
        "units are made of names such as `kg`, `mm` or `N` with `*`, `/` and powers: `kg*m^2/s`, or `1` for plain numbers";
    BRACKETS_HELP = "a unit in brackets follows a number: `0.5 [kg]`";
    NOT_EXACT = "this root of a unit is not an exact number of SI units";
    NOT_EXACT_HELP = "take roots of SI units without prefixes, such as `m^(1/2)`";
    LARGE_EXPONENT = "this power of a unit is too large";
    SEVERAL_FACTORS = "a unit of several factors needs square brackets after its number";
    BEHIND_NAME = "a unit follows a colon";
    WITHOUT_SPACE = "a space is missing between a number and its unit";
    ON_LET_FUNCTION = "functions defined by `let` take quantities of any unit";
    ON_LET_FUNCTION_HELP = "remove the unit: it is checked wherever the function is called";
    behind_name(name, unit) = "write `param {name}: {unit} = …;`";
    unknown(word) = "{} is not a unit", quoted(word);
    offset_in_unit(unit) = "`{unit}` has an offset zero and cannot be part of another unit";
    offset_in_sum(unit) = "a number in `{unit}` has an offset zero: it cannot be added or multiplied";
    OFFSET_HELP = "differences of temperatures are in `K`";
    write_unit(unit) = "write {}", quoted(unit);
    did_you_mean(unit) = "did you mean {}?", quoted(unit);
}

pub(in crate::syntax) fn with_space(number: &str, unit: &str) -> String {
    format!("write {}", quoted(format!("{number} {unit}")))
}

/// Returns advice for factors of a unit after a number; `rest` is the remaining factor of the
/// product.
pub(in crate::syntax) fn in_brackets(number: &str, unit: &str, rest: &str) -> String {
    format!("write {}", quoted(format!("{number} [{unit}]{rest}")))
}

/// Returns advice for a word that is the name of both a unit and something declared.
pub(in crate::syntax) fn product_or_unit(number: &str, word: &str) -> String {
    format!(
        "write `*` between the factors of a product, or {} for the unit",
        quoted(format!("{number} [{word}]"))
    )
}
