//! Diagnostics for values that equations define.

use lagrange_expr::diagnostics::messages;
use lagrange_language::syntax::ast::Name;

/// Returns the quoted names of unknowns.
pub(in crate::elaborate) fn names(names: &[Name]) -> String {
    let quoted = names.iter().map(|name| format!("`{}`", name.text)).collect::<Vec<_>>();
    match quoted.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
        None => String::new(),
    }
}

messages! {
    pub(in crate::elaborate):

    START = "the start of an unknown";
    ITERATIONS = "the number of iterations";
    NO_ITERATIONS = "this is not a valid number of iterations";
    iterations_help(most) =
        "write a whole number from 1 to {most}, such as `iterations: 50`; the default is 30";
    START_HELP =
        "write an expression that is known before the equation is solved, such as a number; the default is 0";
    RATE_HELP = "its rate is known after the statement; for an equation of the rate itself declare a `state`";
    TOGETHER =
        "move the declaration before this; unknowns that depend on each other are solved for together: `solve (y, z): 0 = e, 0 = f;`";
    DEPENDENT_HELP = "write equations none of which follows from the others";
    dependent(names) = "these equations do not determine {names}: one of them follows from the others";
    in_no_equation(name) = "no equation depends on {name}";
    equation(name) = "the equation of {name}";
    without_unknown(name) = "this equation does not depend on {name}";
    without_unknown_help(name) =
        "write an expression that changes with {name} and is zero at its value; write an explicit value as `let y = e;`";
    without_solution(name) =
        "this equation has no solution for {name}: its right side has the same sign everywhere and is never zero";
    without_solution_help(name) =
        "write an expression that is zero at the value of {name}, such as `y^2 - 2` for the root of 2";
    start_holds(name) = "the start of `{name}` depends on `{name}`";
    rate_within(name) = "the rate of `{name}` is unknown in its own equation";
    name_of_solver(name, unknown) = "`{name}` is the name of the function that solves for {unknown}";
}
