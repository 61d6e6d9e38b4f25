//! Diagnostics for habits from other languages and from paper, with what is written here.

use proc_macro2::{Delimiter, TokenTree};

use super::forms::form;
use super::{quoted, shortened};

// Statements.

pub(in crate::syntax) const COMMENT: &str = "this does not begin a comment";
pub(in crate::syntax) const SECOND_SYSTEM: &str = "a declaration contains one system";
pub(in crate::syntax) const SECOND_SYSTEM_HELP: &str =
    "declare the other one in a separate `lagrange::system!`, or as a `reduce` of this one";
pub(in crate::syntax) const ADDS_UP: &str =
    "write `=`: statements such as `kinetic = e;` may be repeated, and add up";

/// Message for a statement that should begin with a name.
pub(in crate::syntax) fn nameless(keyword: &str) -> String {
    let article = if keyword.starts_with(['e', 'o']) { "an" } else { "a" };
    format!("{article} {keyword} needs a name")
}

pub(in crate::syntax) const TYPED: &str = "names have no individual types here";

pub(in crate::syntax) const TWICE_IN_A_ROW: &str = "this name is written twice";

/// Message for brackets between a name and its value.
pub(in crate::syntax) fn behind_name(keyword: &str) -> (&'static str, &'static str) {
    match keyword {
        "coord" => (
            "coordinates always depend on time, and units follow a colon",
            "write `coord x, theta;`, or `coord x: m, theta: rad;` with units",
        ),
        keyword => (
            "only a colon and a unit can stand between a name and its value",
            match keyword {
                "param" => "write `param m = 1.0;`, or `param m: kg = 1.0;` with a unit",
                other => form(other),
            },
        ),
    }
}

pub(in crate::syntax) const MUTABLE: &str = "names cannot be reassigned";
pub(in crate::syntax) const MUTABLE_HELP: &str =
    "remove `mut`: `let name = e;` names an expression, and an `input` may change during the motion";

pub(in crate::syntax) fn declared_already(name: &str) -> String {
    format!("{} is already declared", quoted(name))
}

pub(in crate::syntax) fn value_where_declared(name: &str) -> String {
    format!("give it its value where it is declared: `param {} = …;`", shortened(name))
}

/// Message for an equation of motion.
pub(in crate::syntax) fn equations_are_derived() -> String {
    "equations of motion are derived: write the energies that they follow from, `kinetic = …;` and `potential = …;`, and forces, `force x = …;`"
        .to_owned()
}

/// Message for `dot(x) = …` and `ddot(x) = …` as statements.
pub(in crate::syntax) fn rate_as_statement(function: &str) -> String {
    match function {
        "dot" => "initial velocities belong to the state from which a simulation starts; for a condition that always holds write `constraint name = …;`".to_owned(),
        _ => equations_are_derived(),
    }
}

/// Advice for the rate of a state in the spelling of another language.
pub(in crate::syntax) fn rate_of_state(rate: &str) -> String {
    format!("the rate of a state is stated as `{rate} = …;`")
}

// Constraints and events.

pub(in crate::syntax) const EQUATION: &str = "a constraint is one expression that stays zero";

pub(in crate::syntax) fn difference(name: &str) -> String {
    format!("write a = b as `constraint {} = a - (b);`", shortened(name))
}

pub(in crate::syntax) const INEQUALITY: &str =
    "a constraint is an expression that stays zero, not an inequality";

pub(in crate::syntax) fn contact(name: &str) -> String {
    format!(
        "a one-sided condition is a contact: for a ≥ b write `event {} = a - (b), falling => impact(0);`",
        shortened(name)
    )
}

pub(in crate::syntax) const CONDITION_IN_EVENT: &str =
    "an event is an expression whose zeros count, not a condition";

pub(in crate::syntax) fn zero_and_direction(name: &str) -> String {
    format!("write a < b as `event {} = a - (b), falling => stop;`, and a > b with `rising`", shortened(name))
}

// Names.

/// Message for a token that is no name where one is needed.
pub(in crate::syntax) fn name_help(token: Option<&TokenTree>) -> &'static str {
    match token {
        Some(TokenTree::Literal(literal)) if literal.to_string().starts_with('"') => {
            "write the name without quotation marks"
        }
        Some(TokenTree::Literal(_)) => "names begin with a letter",
        Some(TokenTree::Group(group)) if group.delimiter() != Delimiter::Brace => {
            "write the name without brackets"
        }
        _ => "a name consists of letters, digits and `_`, and begins with a letter",
    }
}

// Expressions.

pub(in crate::syntax) const DECIMAL_COMMA: &str = "a comma is not a decimal point";

pub(in crate::syntax) fn decimal_point(number: &str) -> String {
    format!("write {}", quoted(number))
}

pub(in crate::syntax) fn compound_assignment(operator: char) -> String {
    format!("`{operator}=` is not an operator")
}

pub(in crate::syntax) const COMPOUND_ASSIGNMENT_HELP: &str = "write the whole new value, `x = x + e;`";
pub(in crate::syntax) const QUOTIENT: &str = "derivatives by time are not written as `d/dt`";
pub(in crate::syntax) const NO_ACCELERATIONS_HELP: &str =
    "write `dot(x)` for a velocity; `ddot(x)` is accepted in outputs, events and Gibbs functions only";
pub(in crate::syntax) const POWER_OF_FUNCTION: &str = "the exponent of a function follows its argument";

pub(in crate::syntax) fn written(usage: &str) -> String {
    format!("write {}", quoted(usage))
}

pub(in crate::syntax) const RUST_NAME_HELP: &str =
    "Rust variables are not visible here: declare `param name;` and set that field at run time";

pub(in crate::syntax) const LIBRARY: &str = "library names are not supported";
pub(in crate::syntax) const STRING: &str = "quotation marks are not allowed here";

/// Message for quotation marks around a text.
pub(in crate::syntax) fn unquoted(literal: &str) -> String {
    let text = literal.trim_matches(['"', '\'']);
    format!("remove them: write {}", quoted(text))
}

pub(in crate::syntax) fn missing_operand(operator: &str) -> String {
    format!("write an operand after `{operator}`, or remove it")
}

pub(in crate::syntax) const MISSING_EXPRESSION: &str = "write an expression here, such as `0`";
pub(in crate::syntax) const SUM_HELP: &str = "write a sum over a loop as `sum(i in 0..n, e)`";
pub(in crate::syntax) const QUESTION_HELP: &str = "write `if a < b { … } else { … }`";
pub(in crate::syntax) const LIST_HELP: &str =
    "write vectors in parentheses, `(a, b)`, and `;` after the statement";
pub(in crate::syntax) const LINE_END_HELP: &str = "each line between the braces ends in `;`, not in `,`";
pub(in crate::syntax) const LONELY_CHARACTER_HELP: &str = "expressions are made of numbers, names, calls such as `sin(x)`, parentheses and the operators `+ - * / ^`";
pub(in crate::syntax) const SELF_HELP: &str =
    "write parameters and coordinates by name alone: `m`, not `self.m`";
pub(in crate::syntax) const WORD_HELP: &str = "expressions consist of names, calls such as `sin(x)` and `if a < b { … } else { … }`, without other Rust keywords";
