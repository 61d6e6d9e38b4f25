//! Diagnostics for functions of the user's crate.

use super::quoted;
use crate::syntax::ast::Name;

pub(in crate::syntax) const DERIVATIVE: &str = "a derivative";
pub(in crate::syntax) const REPEATED_DERIVATIVE: &str = "this derivative is named twice";

pub(in crate::syntax) const VALUE_OF_EXTERNAL: &str =
    "a function of your crate is defined there, not in the declaration";

pub(in crate::syntax) fn defined_function(name: &str) -> String {
    format!(
        "end the statement with `;`, or write `let {name}(…) = …;` for a function defined by an expression"
    )
}

/// Describes the syntax for derivatives of a function with these arguments.
pub(in crate::syntax) fn derivatives_are(parameters: &[Name]) -> String {
    match parameters {
        [_] => {
            "write `derivative: name;`, `second_derivative: name;` or `third_derivative: name;`".to_owned()
        }
        _ => {
            let names = parameters.iter().map(|name| name.text.as_str()).collect::<Vec<_>>();
            let first = names.first().copied().unwrap_or("x");
            let all = names.join(", ");
            format!(
                "write `by {first}: name;` for the derivative by `{first}`, and `by {all}: name;` for a mixed one"
            )
        }
    }
}

pub(in crate::syntax) fn no_derivative(label: &str) -> String {
    format!("unknown label {} for derivatives", quoted(label))
}

pub(in crate::syntax) fn by_which(function: &str, arguments: usize) -> String {
    format!("`{function}` has {arguments} arguments: specify by which to differentiate")
}

pub(in crate::syntax) fn no_argument(function: &str, name: &str) -> String {
    format!("`{function}` has no argument {}", quoted(name))
}

pub(in crate::syntax) fn repeated_argument(name: &str) -> String {
    format!("the argument {} is repeated", quoted(name))
}

pub(in crate::syntax) fn of_emitted_code(name: &str) -> String {
    format!("{} is reserved for generated code", quoted(name))
}
