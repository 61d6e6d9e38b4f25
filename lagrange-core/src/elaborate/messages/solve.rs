//! Diagnostics for values that equations define.

pub(in crate::elaborate) const START: &str = "the start of an unknown";
pub(in crate::elaborate) const ITERATIONS: &str = "the number of iterations";
pub(in crate::elaborate) const NO_ITERATIONS: &str = "this is not a valid number of iterations";

pub(in crate::elaborate) fn iterations_help(most: i32) -> String {
    format!("write a whole number from 1 to {most}, such as `iterations: 50`; the default is 30")
}

pub(in crate::elaborate) const START_HELP: &str =
    "write an expression that is known before the equation is solved, such as a number; the default is 0";
pub(in crate::elaborate) const RATE_HELP: &str =
    "its rate is known after the statement; for an equation of the rate itself declare a `state`";
pub(in crate::elaborate) const ONE_AT_A_TIME: &str = "move the declaration before this; if two unknowns depend on each other, eliminate one of them: equations are solved one at a time";

pub(in crate::elaborate) fn equation(name: &str) -> String {
    format!("the equation of `{name}`")
}

pub(in crate::elaborate) fn without_unknown(name: &str) -> String {
    format!("this equation does not depend on `{name}`")
}

pub(in crate::elaborate) fn without_unknown_help(name: &str) -> String {
    format!(
        "write an expression that changes with `{name}` and is zero at its value; write an explicit value as `let {name} = e;`"
    )
}

pub(in crate::elaborate) fn without_solution(name: &str) -> String {
    format!(
        "this equation has no solution for `{name}`: its right side has the same sign everywhere and is never zero"
    )
}

pub(in crate::elaborate) fn without_solution_help(name: &str) -> String {
    format!(
        "write an expression that is zero at the value of `{name}`, such as `{name}^2 - 2` for the root of 2"
    )
}

pub(in crate::elaborate) fn start_holds(name: &str) -> String {
    format!("the start of `{name}` depends on `{name}`")
}

pub(in crate::elaborate) fn rate_within(name: &str) -> String {
    format!("the rate of `{name}` is unknown in its own equation")
}

pub(in crate::elaborate) fn name_of_solver(name: &str, unknown: &str) -> String {
    format!("`{name}` is the name of the function that solves for `{unknown}`")
}
