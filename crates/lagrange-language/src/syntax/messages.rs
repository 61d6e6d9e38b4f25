//! Diagnostics for mistakes of writing, with what helps against them.

pub(super) mod arrays;
pub(super) mod forms;
pub(super) mod functions;
pub(super) mod habits;
pub(super) mod scenes;
pub(super) mod solve;
pub(super) mod tables;
pub(super) mod units;

use proc_macro2::{Delimiter, TokenTree};

use lagrange_expr::accuracy::Accuracy;

/// Longer pieces of the input are cut in messages.
const LONGEST_QUOTE: usize = 40;

/// A piece of the input as messages show it.
fn quoted(text: &str) -> String {
    format!("`{}`", shortened(text))
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(LONGEST_QUOTE) {
        None => text.to_owned(),
        Some((cut, _)) => format!("{}…", &text[..cut]),
    }
}

fn found(token: Option<&TokenTree>) -> String {
    match token {
        None => "nothing".to_owned(),
        Some(TokenTree::Group(group)) => match group.delimiter() {
            Delimiter::Parenthesis => "`(`".to_owned(),
            Delimiter::Bracket => "`[`".to_owned(),
            Delimiter::Brace => "`{`".to_owned(),
            Delimiter::None => "an expression".to_owned(),
        },
        Some(other) => quoted(&other.to_string()),
    }
}

/// Message for every place where only certain tokens can stand.
pub(super) fn expected(wanted: &str, token: Option<&TokenTree>) -> String {
    format!("expected {wanted}, found {}", found(token))
}

/// Message for a token that nothing can be made of.
pub(super) fn misplaced(token: Option<&TokenTree>) -> String {
    format!("unexpected {}", found(token))
}

pub(super) const MISPLACED_HELP: &str = "remove it";

/// Message for what can stand behind an expression.
pub(super) fn expected_operator_or(wanted: &str, token: Option<&TokenTree>) -> String {
    let conjunction = if wanted.contains(" or ") { "," } else { " or" };
    expected(&format!("an operator{conjunction} {wanted}"), token)
}

// Text that is no sequence of tokens.

pub(super) fn unbalanced(bracket: char) -> String {
    match bracket {
        '(' | '[' | '{' => format!("`{bracket}` is never closed"),
        _ => format!("`{bracket}` has no matching opening bracket"),
    }
}

pub(super) const UNCLOSED_QUOTE: &str = "this quotation mark does not begin a readable string";
pub(super) const UNREADABLE_END_HELP: &str = "close all brackets, quotation marks and comments";
pub(super) const UNREADABLE_END: &str = "unexpected end of the text";

pub(super) fn meaningless_character(character: char) -> String {
    format!("unexpected character `{}`", character.escape_debug())
}

// The head of a declaration.

pub(super) const HEADER: &str = "`struct Name;`";
pub(super) const EMPTY_DECLARATION: &str = "this declaration is empty";
pub(super) const HEADER_HELP: &str = "begin with the type to emit, such as `pub struct CartPole;`";
pub(super) const STRUCT_BODY: &str = "fields come from `param` and `input` statements, not from the struct";
pub(super) const TYPE_PARAMETERS: &str = "only one plain type parameter, the number type, is possible here";
pub(super) const TYPE_PARAMETERS_HELP: &str = "write `struct Name<S>;`, without bounds";

pub(super) const WHERE_CLAUSE: &str = "a `where` clause is not allowed here";

pub(super) fn number_type_as_parameter(number: &str) -> String {
    format!("`{number}` is a number type and cannot be a parameter")
}

pub(super) fn number_type_help(number: &str) -> String {
    format!("write `#[scalar({number})]` above the struct and remove `<{number}>`")
}

pub(super) const ATTRIBUTE: &str = "expected `[` after `#`";
pub(super) const ATTRIBUTE_FORM_HELP: &str =
    "write `#[name]`, `#[name(…)]` or `#[name = \"…\"]`, or `///` for documentation";
pub(super) const VISIBILITY: &str = "unknown visibility";
pub(super) const VISIBILITY_HELP: &str = "write `pub`, `pub(crate)`, `pub(super)` or `pub(in path)`";
pub(super) const INNER_ATTRIBUTE: &str = "attributes that begin with `#!` are not allowed here";
pub(super) const INNER_ATTRIBUTE_HELP: &str = "write `#[…]`, or `///` for documentation";
pub(super) const SCALAR_FORM: &str = "`scalar` takes a number type";
pub(super) const SCALAR_HELP: &str = "write `#[scalar(f64)]` or `#[scalar(f32)]`";
pub(super) const SCALAR_WITH_PARAMETER: &str = "the type parameter already specifies the number type";
pub(super) const SCALAR_WITH_PARAMETER_HELP: &str = "remove either `#[scalar(…)]` or the type parameter";
pub(super) const TYPE_PARAMETER_HERE: &str = "the type parameter is here";
pub(super) const ACCURACY_FORM: &str = "`accuracy` takes one level";
pub(super) const FIRST_HERE: &str = "first given here";

pub(super) fn malformed_attribute(error: &syn::Error) -> String {
    format!("invalid attribute: {error}")
}

pub(super) fn keyword_as_type(name: &str) -> String {
    format!("{} is a Rust keyword and cannot name a type", quoted(name))
}

pub(super) fn unknown_accuracy(level: &str) -> String {
    format!("unknown level of accuracy {}", quoted(level))
}

pub(super) fn levels_of_accuracy() -> String {
    let levels = Accuracy::ALL.map(|level| format!("`#[accuracy({})]`", level.name()));
    format!("write one of {}", levels.join(", "))
}

pub(super) fn repeated_attribute(name: &str) -> String {
    format!("`{name}` is given twice")
}

pub(super) const REPEATED_ATTRIBUTE_HELP: &str = "remove one of them";

// Statements.

pub(super) const STATEMENT: &str = "a statement";
pub(super) const ATTRIBUTE_ON_STATEMENT: &str = "attributes are not allowed here";
pub(super) const ATTRIBUTE_ON_STATEMENT_HELP: &str = "documentation with `///` can stand before `param`, `input`, `coord`, `state`, `quaternion`, `velocity`, `body`, `frame`, `revolute`, `prismatic`, `screw`, `cylindrical`, `universal`, `planar`, `ball`, `free`, `constraint`, `event`, `friction`, `output` and `reduce`; other comments begin with `//`";
pub(super) const MISSING_SEMICOLON: &str = "missing `;` after this";
pub(super) const LINE_END: &str = "expected `;`, found `,`";
pub(super) const MISSING_COMMA: &str = "missing `,` before this";
pub(super) const MISSING_SEMICOLON_HELP: &str = "statements end in `;`";
pub(super) const NEXT_STATEMENT: &str = "the next statement begins here";
pub(super) const COORDINATE_WITH_VALUE: &str = "a coordinate cannot have a value in the declaration";
pub(super) const STATE_WITH_VALUE: &str = "a state cannot have a value in the declaration";
pub(super) const COORDINATE_WITH_VALUE_HELP: &str =
    "initial values belong to the state from which a simulation starts";

// Events.

pub(super) const DIRECTION: &str = "`rising`, `falling` or `crossing`";
pub(super) const DIRECTION_HELP: &str = "specify which zeros count, `rising`, `falling` or, for both, `crossing`: `event name = e, falling => stop;`";
pub(super) const ACTION: &str = "`stop`, `record`, `impact(e)` or `{`";
pub(super) const ACTION_HELP: &str =
    "write an action after `=>`: `stop`, `record`, `impact(e)` or `{ dot(x) = e; y = e; }`";
pub(super) const RESTITUTION: &str = "an impact needs a coefficient of restitution";
pub(super) const RESTITUTION_HELP: &str =
    "write `impact(e)`: `impact(0)` for bodies that stay together, `impact(1)` if no energy is lost";
pub(super) const ASSIGNMENT_HELP: &str = "write `dot(x) = e;` or `x = e;`";
pub(super) const NOTHING_ASSIGNED: &str = "nothing is assigned between these braces";
pub(super) const NOTHING_ASSIGNED_HELP: &str =
    "write `{ dot(x) = -dot(x); }`, or `record` for an event that changes nothing";

pub(super) const STATEMENT_IN_EVENT: &str = "an event can only assign coordinates and velocities";

pub(super) fn statement_in_event_help(keyword: &str) -> String {
    format!("write the `{keyword}` before the event; the braces contain only `dot(x) = e;` or `x = e;`")
}

pub(super) fn event_without_direction(name: &str) -> String {
    format!("the event {} has no direction", quoted(name))
}

pub(super) fn event_without_action(name: &str) -> String {
    format!("the event {} has no action", quoted(name))
}

// Friction.

pub(super) const ONE_LIMIT_HELP: &str =
    "write `kinetic: e, static: f`, or a single limit without a label for both";

pub(super) const EQUALS_BEHIND_LABEL: &str = "expected `:`, found `=`";

pub(super) fn friction_without_limit(name: &str) -> String {
    format!("the friction {} has no limit", quoted(name))
}

pub(super) fn unknown_label(label: &str) -> String {
    format!("unknown label {} for friction", quoted(label))
}

pub(super) fn repeated_label(label: &str) -> String {
    format!("`{label}` is given twice")
}

pub(super) const SECOND_LIMIT: &str = "this friction has two limits without labels";
pub(super) const UNLABELLED_LIMIT: &str = "a limit without a label beside one with a label";

pub(super) fn lonely_limit(given: &str, missing: &str) -> String {
    format!("`{given}` without `{missing}`")
}

pub(super) const SMOOTH_WITH_STATIC: &str = "smooth friction never sticks, so it has no static limit";
pub(super) const SMOOTH_HELP: &str = "write `friction name = slip, limit, smooth: width;`";

// Reduced types.

pub(super) const NOTHING_REDUCED: &str = "nothing is frozen or small here";
pub(super) const REDUCTION_ITEM: &str = "`freeze` or `small`";

pub(super) fn frozen_without_value(name: &str) -> String {
    format!("the frozen coordinate {} needs a value", quoted(name))
}

pub(super) fn frozen_without_value_help(name: &str) -> String {
    format!("write `freeze {} = 0;`", shortened(name))
}

pub(super) fn unknown_statement(word: &str) -> String {
    format!("unknown statement {}", quoted(word))
}

pub(super) fn meant(candidate: &str) -> String {
    format!("did you mean `{candidate}`?")
}

pub(super) fn meant_let(name: &str) -> String {
    format!("to name an expression, write `let {} = …;`", shortened(name))
}

pub(super) fn statements_are(keywords: &[&str]) -> String {
    format!("statements begin with one of `{}`", keywords.join("`, `"))
}

pub(super) fn constant_without_value(name: &str) -> String {
    format!("the constant {} needs a value", quoted(name))
}

pub(super) const CONSTANT_WITHOUT_VALUE_HELP: &str =
    "write `const name = value;`, or `param name;` for a value known only when the program runs";

pub(super) fn component_count(count: usize) -> String {
    format!("a vector has two or three components, not {count}")
}

pub(super) const COMPONENT_COUNT_HELP: &str = "name the numbers one by one, `let a = …;`";

// Names.

pub(super) fn statement_keyword_as_name(name: &str) -> String {
    format!("{} begins a statement and cannot be a name", quoted(name))
}

pub(super) fn rust_keyword_as_name(name: &str) -> String {
    format!("{} is a Rust keyword and cannot be a name", quoted(name))
}

pub(super) fn function_as_name(name: &str) -> String {
    format!("{} is a function and cannot be declared", quoted(name))
}

pub(super) fn built_in_as_name(name: &str, meaning: &str) -> String {
    format!("{} is {meaning} and cannot be declared", quoted(name))
}

pub(super) const UNDERSCORE_AS_NAME: &str = "`_` is not a name";

pub(super) fn reserved_name(name: &str) -> String {
    format!("{} begins with two underscores, which are reserved for generated code", quoted(name))
}

pub(super) fn raw_name(name: &str) -> String {
    format!("{} is a raw identifier, which cannot be used as a name here", quoted(name))
}

pub(super) const OTHER_NAME_HELP: &str = "choose another name";

// Expressions.

pub(super) const OPERAND: &str = "an expression";
pub(super) const NESTED_TOO_DEEPLY: &str = "brackets are nested too deeply";
pub(super) const NESTED_TOO_DEEPLY_HELP: &str = "name a part of the expression with `let`";
pub(super) const EMPTY_PARENTHESES: &str = "these parentheses are empty";
pub(super) const EMPTY_BLOCK: &str = "these braces are empty";
pub(super) const BLOCK_CONTENT: &str = "a block contains exactly one expression";
pub(super) const LET_HELP: &str = "name parts of an expression with separate `let` statements";
pub(super) const ONE_COMPONENT_HELP: &str = "remove the comma to write a number in parentheses";
pub(super) const MISSING_ELSE: &str = "this `if` has no value when its condition is false";
pub(super) const MISSING_ELSE_HELP: &str = "add `else { … }`";
pub(super) const COMPARISON: &str = "`<`, `<=`, `>` or `>=`";
pub(super) const EQUALITY: &str = "numbers cannot be compared for equality";
pub(super) const EQUALITY_HELP: &str =
    "compare with `<`, `<=`, `>` or `>=`; `==` compares indices, as in `if i == 2 { … }`";
pub(super) const LOGIC: &str = "a condition is a single comparison, without `&&`, `||` and `!`";
pub(super) const LOGIC_HELP: &str =
    "nest one `if` in the other, or compare `min(a, b)` or `max(a, b)` with zero";
pub(super) const COMPARISON_CHAIN: &str = "a condition is a single comparison";
pub(super) const COMPARISON_PLACE: &str = "comparisons are allowed only between `if` and `{`";
pub(super) const COMPARISON_PLACE_HELP: &str = "write `if a < b { … } else { … }`";
pub(super) const UNARY_PLUS: &str = "`+` has nothing on its left";
pub(super) const UNARY_PLUS_HELP: &str = "remove the sign";
pub(super) const REFERENCE: &str = "references are not supported";
pub(super) const REFERENCE_HELP: &str = "remove the `&`: names stand for values";
pub(super) const MAGNITUDE_HELP: &str = "write `abs(x)` for a magnitude";
pub(super) const VECTOR_HELP: &str = "write vectors in parentheses: `(a, b)`";
pub(super) const PARENTHESES_HELP: &str = "group with parentheses";
pub(super) const LEADING_ZERO_HELP: &str = "write a digit before the point: `0.5`";
pub(super) const COMMENT_HELP: &str = "write `//` for comments";
pub(super) const DOUBLE_STAR: &str = "`**` is not an operator";
pub(super) const DOUBLE_STAR_HELP: &str = "write `^` for powers";
pub(super) const PATH: &str = "paths with `::` are not supported";
pub(super) const PATH_HELP: &str = "write functions without a path: `sin(x)` or `x.sin()`";
pub(super) const MACRO: &str = "macros cannot be called in expressions";
pub(super) const CONVERSION: &str = "`as` is not supported";
pub(super) const CONVERSION_HELP: &str = "remove the conversion: all numbers have one type";
pub(super) const REMAINDER: &str = "`%` is not an operator";
pub(super) const MACRO_HELP: &str = "write the expression itself, with functions such as `sin(x)`";
pub(super) const FACTORIAL: &str = "`!` is not an operator";
pub(super) const FACTORIAL_HELP: &str = "write a factorial as a number: `24` for 4!";
pub(super) const REMAINDER_HELP: &str =
    "angles need no remainder; write a percentage as a fraction, `5/100`; comments begin with `//`";
pub(super) const SECOND_EQUALS_HELP: &str =
    "a statement assigns one value to one name; write a statement for each";
pub(super) const INDEX: &str = "square brackets are not allowed here";
pub(super) const INDEX_HELP: &str = "the components of a vector are `.x`, `.y` and `.z`";
pub(super) const NUMBERED_COMPONENT: &str = "components are not numbered";
pub(super) const ARGUMENT_HELP: &str = "write the argument of a function in parentheses: `cos(x)`";
pub(super) const TYPE_HELP: &str = "`#[scalar(f32)]` or `struct Name<S>;` specifies the type of all numbers";
pub(super) const PRODUCT_HELP: &str = "write `*` between the factors of a product";

pub(super) fn keyword_as_value(word: &str) -> String {
    format!("the keyword {} has no value", quoted(word))
}

pub(super) const KEYWORD_AS_VALUE_HELP: &str =
    "give the expression a name with `let` and use that name in both places";

// Numbers.

pub(super) fn no_number(literal: &str) -> String {
    format!("{} is not a number", quoted(literal))
}

pub(super) const SUFFIX: &str = "numbers have no individual types here";

pub(super) fn suffix_help(digits: &str) -> String {
    format!("write {}", quoted(digits))
}

pub(super) const LETTERS: &str = "letters follow this number directly";

pub(super) fn letters_help(digits: &str, letters: &str) -> String {
    format!("write {} for a product", quoted(&format!("{digits} * {letters}")))
}

pub(super) const NUMBER_HELP: &str = "write a number such as `2`, `0.5` or `1e-3`";
pub(super) const EXCESSIVE_NUMBER_HELP: &str = "round it, or choose other units";
pub(super) const NOT_DECIMAL: &str = "numbers are written in decimal";

pub(super) fn excessive_number(literal: &str) -> String {
    format!("the number {} is too long or too extreme to be exact", quoted(literal))
}

/// Message as of [`expected`], for an operator of two characters.
pub(super) fn expected_instead(wanted: &str, found: &str) -> String {
    format!("expected {wanted}, found `{found}`")
}
