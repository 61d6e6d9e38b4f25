//! Differences between C and JavaScript beyond statements.

use lagrange_core::code::Target;

use crate::names::number;

/// Returns the text in the target's language.
pub(crate) fn in_language<T>(target: Target, [c, script]: [T; 2]) -> T {
    if target == Target::JavaScript { script } else { c }
}

/// Returns the head of a function from its C form.
pub(crate) fn head(target: Target, result: &str, name: &str, parameters: &str) -> String {
    let name_of = |parameter: &str| parameter.rsplit([' ', '*']).next().unwrap_or_default().to_owned();
    let names = || parameters.split(", ").map(name_of).collect::<Vec<_>>().join(", ");
    match target {
        Target::C(_) => format!("{result} {name}({parameters})"),
        Target::JavaScript => format!("function {name}({})", names()),
    }
}

/// Returns an array within an expression.
pub(crate) fn list(target: Target, values: &str) -> String {
    let [open, close] = in_language(target, [["(const double[]){ ", " }"], ["[", "]"]]);
    format!("{open}{values}{close}")
}

/// Returns the definition of an array of numbers.
pub(crate) fn constants(target: Target, name: &str, values: &[f64]) -> String {
    let values = values.iter().map(|value| number(*value)).collect::<Vec<_>>();
    let lines = values.chunks(8).map(|line| format!("    {},\n", line.join(", "))).collect::<String>();
    let [before, open, close] =
        in_language(target, [["static const double ", "[] = {", "}"], ["const ", " = [", "]"]]);
    format!("{before}{name}{open}\n{lines}{close};\n")
}
