//! Diagnostics for values that are defined by equations.

use super::quoted;
use crate::syntax::ast::Name;

pub(in crate::syntax) const NO_ZERO_ON_THE_LEFT: &str = "the left side of the equation is not `0`";

pub(in crate::syntax) const UNEQUAL_HELP: &str =
    "write one equation for each unknown, `solve (y, z): 0 = e, 0 = f;`";
pub(in crate::syntax) const TOO_MANY_HELP: &str =
    "define explicit values with `let`, and write uncoupled equations as separate `solve` statements";

pub(in crate::syntax) fn unequal(unknowns: usize, equations: usize) -> String {
    let (s, have) = if unknowns == 1 { ("", "has") } else { ("s", "have") };
    let of_equations = if equations == 1 { "" } else { "s" };
    format!("{unknowns} unknown{s} {have} {equations} equation{of_equations}")
}

pub(in crate::syntax) fn too_many(unknowns: usize, most: usize) -> String {
    format!("{unknowns} unknowns are coupled, and at most {most} can be solved for together")
}

pub(in crate::syntax) fn unequal_starts(unknowns: usize) -> String {
    format!("this does not give a start for each of the {unknowns} unknowns")
}

pub(in crate::syntax) fn starts_help(names: &[Name]) -> String {
    let starts = (1..=names.len()).map(|i| format!("s{i}")).collect::<Vec<_>>();
    format!("write `start: ({})`, one for each unknown in their order", starts.join(", "))
}

pub(in crate::syntax) fn zero_on_the_left(names: &[Name]) -> String {
    match names {
        [name] => format!("write `solve {}: 0 = e;`, where e is the difference of the two sides", name.text),
        _ => "write each equation as `0 = e`, where e is the difference of the two sides".to_owned(),
    }
}

pub(in crate::syntax) fn unknown_option(word: &str) -> String {
    format!("unknown label {} for an equation", quoted(word))
}
