//! Diagnostics for notations from other languages and from paper, with the spelling here.

use proc_macro2::{Delimiter, TokenTree};

use super::forms::form;
use super::{quoted, shortened};
use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::syntax):

    COMMENT = "this does not begin a comment";
    SECOND_SYSTEM = "a declaration contains one system";
    SECOND_SYSTEM_HELP =
        "declare the other one in a separate `lagrange::system!`, or as a `reduce` of this one";
    ADDS_UP = "write `=`: statements such as `kinetic = e;` may be repeated, and add up";

    TYPED = "names have no individual types here";

    TWICE_IN_A_ROW = "this name is written twice";

    MUTABLE = "names cannot be reassigned";
    MUTABLE_HELP =
        "remove `mut`: `let name = e;` names an expression, and an `input` may change during the motion";
    declared_already(name) = "{} is already declared", quoted(name);
    value_where_declared(name) = "give it its value where it is declared: `param {} = …;`", shortened(name);

    VALUE_BEHIND_WORD = "an initial value follows an equals sign";
    TIME_OF_START = "initial values have no argument: they hold at the start of a run";
    TIME_OF_HISTORY = "a history has no argument: its formula is a function of the time t";
    RATE_AMONG_COORDINATES = "velocities are not declared: each coordinate has one";
    start_of(target) = "for its initial value write `start {target} = …;`";
    history_of(target) = "write `history {target} = …;`";

    /// Advice for the rate of a state in the spelling of another language.
    rate_of_state(rate) = "the rate of a state is stated as `{rate} = …;`";
    EQUATION = "a constraint is one expression that stays zero";
    difference(name) = "write a = b as `constraint {} = a - (b);`", shortened(name);
    INEQUALITY = "a constraint is an expression that stays zero, not an inequality";
    contact(name) =
        "a one-sided condition is a contact: for a ≥ b write `event {} = a - (b), falling => impact(0);`", shortened(name);
    CONDITION_IN_EVENT = "an event is an expression whose zeros count, not a condition";
    zero_and_direction(name) =
        "write a < b as `event {} = a - (b), falling => stop;`, and a > b with `rising`", shortened(name);
    several_conditions(name) =
        "write `a < b && c < d` as `event {} = max(a - (b), c - (d)), falling => stop;`, and `||` with `min`", shortened(name);
    DECIMAL_COMMA = "a comma is not a decimal point";
    decimal_point(number) = "write {}", quoted(number);
    compound_assignment(operator) = "`{operator}=` is not an operator";
    COMPOUND_ASSIGNMENT_HELP = "write the whole new value, `x = x + e;`";
    INCREMENT = "`++` is not an operator";
    INCREMENT_HELP = "write `x + 1`; an event assigns the whole new value, `x = x + 1;`";
    QUOTIENT = "derivatives with respect to time are not written as `d/dt`";
    NO_ACCELERATIONS_HELP =
        "write `dot(x)` for a velocity; `ddot(x)` is accepted in outputs, events and Gibbs functions only";
    POWER_OF_FUNCTION = "the exponent of a function follows its argument";
    written(usage) = "write {}", quoted(usage);
    RUST_NAME_HELP =
        "Rust variables are not visible here: declare `param name;` and set that field at run time";

    LIBRARY = "library names are not supported";
    STRING = "quotation marks are not allowed here";
    missing_operand(operator) = "write an operand after `{operator}`, or remove it";
    MISSING_EXPRESSION = "write an expression here, such as `0`";
    SUM_HELP = "write a sum over a loop as `sum(i in 0..n, e)`";
    QUESTION_HELP = "write `if a < b { … } else { … }`";
    SECOND_DEFINITION_HELP = "end each definition with `;`, and begin the next with its keyword: `let b = e;`";
    LIST_HELP = "write vectors in parentheses, `(a, b)`, and `;` after the statement";
    LINE_END_HELP = "each line between the braces ends in `;`, not in `,`";
    LONELY_CHARACTER_HELP =
        "expressions are made of numbers, names, calls such as `sin(x)`, parentheses and the operators `+ - * / ^`";
    SELF_HELP = "write parameters and coordinates by name alone: `m`, not `self.m`";
    WORD_HELP =
        "expressions consist of names, calls such as `sin(x)` and `if a < b { … } else { … }`, without other Rust keywords";
}

// Statements.

/// Returns the message for a statement that should begin with a name.
pub(in crate::syntax) fn nameless(keyword: &str) -> String {
    let article = if keyword.starts_with(['e', 'o']) { "an" } else { "a" };
    format!("{article} {keyword} needs a name")
}

/// Returns the message for brackets between a name and its value.
pub(in crate::syntax) fn behind_name(keyword: &str) -> (&'static str, &'static str) {
    match keyword {
        "coord" => (
            "coordinates always depend on time, and units follow a colon",
            "write `coord x, theta;`, `coord x: m, theta: rad;` with units, or `coord x = 1;` with an initial value",
        ),
        keyword => (
            match keyword {
                "param" => "only a colon, a unit and a range are allowed between a name and its value",
                _ => "only a colon and a unit are allowed between a name and its value",
            },
            match keyword {
                "param" => "write `param m = 1.0;`, or `param m: kg > 0 = 1.0;` with a unit and a range",
                other => form(other),
            },
        ),
    }
}

/// Returns the message for an equation of motion.
pub(in crate::syntax) fn equations_are_derived() -> String {
    "equations of motion are derived: write the energies that they follow from, `kinetic = …;` and `potential = …;`, and forces, `force x = …;`"
        .to_owned()
}

/// Returns the message for `dot(x) = …` and `ddot(x) = …` as statements.
pub(in crate::syntax) fn rate_as_statement(function: &str) -> String {
    match function {
        "dot" => "for an initial velocity write `start dot(x) = …;`, for a condition that always holds `constraint name = …;`".to_owned(),
        _ => equations_are_derived(),
    }
}

// Constraints and events.

// Names.

/// Returns the message for a token that is not a name where one is needed.
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

/// Returns the message for quotation marks around a text.
pub(in crate::syntax) fn unquoted(literal: &str) -> String {
    let text = literal.trim_matches(['"', '\'']);
    format!("remove them: write {}", quoted(text))
}
