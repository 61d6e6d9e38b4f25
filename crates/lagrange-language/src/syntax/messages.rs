//! Diagnostics for syntax errors, with help.

pub(super) mod arrays;
pub(super) mod forms;
pub(super) mod functions;
pub(super) mod habits;
pub(super) mod parts;
pub(super) mod ranges;
pub(super) mod scenes;
pub(super) mod solve;
pub(super) mod tables;
pub(super) mod units;

use std::fmt::Display;

use proc_macro2::{Delimiter, TokenTree};

use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::diagnostics::messages;

messages! {
    pub(super):

    MISPLACED_HELP = "remove it";

    UNCLOSED_QUOTE = "this quotation mark does not begin a readable string";
    UNREADABLE_END_HELP = "close all brackets, quotation marks and comments";
    UNREADABLE_END = "unexpected end of the text";

    HEADER = "`struct Name;`";
    EMPTY_DECLARATION = "this declaration is empty";
    HEADER_HELP = "begin with the type to emit, such as `pub struct CartPole;`";
    STRUCT_BODY = "fields come from `param` and `input` statements, not from the struct";
    TYPE_PARAMETERS = "only one plain type parameter, the number type, is possible here";
    TYPE_PARAMETERS_HELP = "write `struct Name<S>;`, without bounds";

    WHERE_CLAUSE = "a `where` clause is not allowed here";
    number_type_as_parameter(number) = "`{number}` is a number type and cannot be a parameter";
    number_type_help(number) = "write `#[scalar({number})]` above the struct and remove `<{number}>`";
    ATTRIBUTE = "expected `[` after `#`";
    ATTRIBUTE_FORM_HELP = "write `#[name]`, `#[name(…)]` or `#[name = \"…\"]`, or `///` for documentation";
    VISIBILITY = "unknown visibility";
    VISIBILITY_HELP = "write `pub`, `pub(crate)`, `pub(super)` or `pub(in path)`";
    INNER_ATTRIBUTE = "attributes that begin with `#!` are not allowed here";
    INNER_ATTRIBUTE_HELP = "write `#[…]`, or `///` for documentation";
    SCALAR_FORM = "`scalar` takes a number type";
    SCALAR_HELP = "write `#[scalar(f64)]` or `#[scalar(f32)]`";
    SCALAR_WITH_PARAMETER = "the type parameter already specifies the number type";
    SCALAR_WITH_PARAMETER_HELP = "remove either `#[scalar(…)]` or the type parameter";
    TYPE_PARAMETER_HERE = "the type parameter is here";
    ACCURACY_FORM = "`accuracy` takes one level";
    FIRST_HERE = "first given here";
    malformed_attribute(error) = "invalid attribute: {error}";
    keyword_as_type(name) = "{} is a Rust keyword and cannot name a type", quoted(name);
    unknown_accuracy(level) = "unknown level of accuracy {}", quoted(level);
    repeated_attribute(name) = "`{name}` is given twice";
    REPEATED_ATTRIBUTE_HELP = "remove one of them";

    STATEMENT = "a statement";
    ATTRIBUTE_ON_STATEMENT = "attributes are not allowed here";
    ATTRIBUTE_ON_STATEMENT_HELP =
        "documentation with `///` can stand before `param`, `input`, `coord`, `state`, `discrete`, `mode`, `quaternion`, `velocity`, `body`, `frame`, `constraint`, `event`, `friction`, `contact`, `output`, `reduce` and `part`. It can also stand before the joints `revolute`, `prismatic`, `screw`, `cylindrical`, `universal`, `planar`, `ball` and `free`. Other comments begin with `//`";
    MISSING_SEMICOLON = "missing `;` after this";
    LINE_END = "expected `;`, found `,`";
    MISSING_COMMA = "missing `,` before this";
    MISSING_SEMICOLON_HELP = "statements end in `;`";
    NEXT_STATEMENT = "the next statement begins here";

    DIRECTION = "`rising`, `falling` or `crossing`";
    DIRECTION_HELP =
        "specify which zeros count, `rising`, `falling` or, for both, `crossing`: `event name = e, falling => stop;`";
    ACTION = "`stop`, `record`, `impact(e)` or `{`";
    ACTION_HELP = "write an action after `=>`: `stop`, `record`, `impact(e)` or `{ dot(x) = e; y = e; }`";
    CLOCK_ACTION_HELP =
        "a clock only assigns, `every 0.01 => { held = e; }`; for an action at a time write `event name = t - 1, rising => stop;`";
    RESTITUTION = "an impact needs a coefficient of restitution";
    RESTITUTION_HELP =
        "write `impact(e)`: `impact(0)` for bodies that stay together, `impact(1)` if no energy is lost";
    ASSIGNMENT_HELP = "write `dot(x) = e;` or `x = e;`";
    NOTHING_ASSIGNED = "nothing is assigned between these braces";
    NOTHING_ASSIGNED_HELP = "write `{ dot(x) = -dot(x); }`, or `record` for an event that changes nothing";

    NOTHING_BEHIND_LOCAL = "no line behind this `let` could use its name";
    NOTHING_BEHIND_LOCAL_HELP = "write it before the lines that use its name, or remove it";
    LOCAL_ELEMENT = "a name between these braces has no index";
    LOCAL_ELEMENT_HELP = "remove it: each iteration of a loop has its own value";
    STATEMENT_IN_EVENT = "an event can only assign coordinates and velocities";
    statement_in_event_help(keyword) =
        "write the `{keyword}` before the event; the braces contain only `dot(x) = e;` or `x = e;`";
    event_without_direction(name) = "the event {} has no direction", quoted(name);
    event_without_action(name) = "the event {} has no action", quoted(name);
    ONE_LIMIT_HELP = "write `kinetic: e, static: f`, or a single limit without a label for both";

    EQUALS_BEHIND_LABEL = "expected `:`, found `=`";
    friction_without_limit(name) = "the friction {} has no limit", quoted(name);
    unknown_label(label) = "unknown label {} for friction", quoted(label);
    repeated_label(label) = "`{label}` is given twice";
    SECOND_LIMIT = "this friction has two limits without labels";
    UNLABELLED_LIMIT = "a limit without a label beside one with a label";
    lonely_limit(given, missing) = "`{given}` without `{missing}`";
    SMOOTH_WITH_STATIC = "smooth friction never sticks, so it has no static limit";
    SMOOTH_HELP = "write `friction name = slip, limit, smooth: width;`";

    NOTHING_REDUCED = "nothing is frozen, small or ignored here";
    REDUCTION_ITEM = "`freeze`, `small` or `ignore`";
    frozen_without_value(name) = "the frozen coordinate {} needs a value", quoted(name);
    frozen_without_value_help(name) =
        "write `freeze {} = 0;`, or a parameter after `=`, which is set when the program runs", shortened(name);
    ignored_with_value(name) = "the ignored coordinate {} takes no value", quoted(name);
    IGNORED_WITH_VALUE_HELP = "remove it: the momentum of the coordinate is a parameter of the reduced type";
    unknown_statement(word) = "unknown statement {}", quoted(word);
    meant(candidate) = "did you mean `{candidate}`?";
    meant_let(name) = "to name an expression, write `let {} = …;`", shortened(name);
    constant_without_value(name) = "the constant {} needs a value", quoted(name);
    CONSTANT_WITHOUT_VALUE_HELP =
        "write `const name = value;`, or `param name;` for a value known only when the program runs";
    noise_without_density(name) = "the noise {} needs a spectral density", quoted(name);
    ONE_COMPONENT = "a vector has two or more components, not 1";
    statement_keyword_as_name(name) = "{} begins a statement and cannot be a name", quoted(name);
    rust_keyword_as_name(name) = "{} is a Rust keyword and cannot be a name", quoted(name);
    function_as_name(name) = "{} is a function and cannot be declared", quoted(name);
    built_in_as_name(name, meaning) = "{} is {meaning} and cannot be declared", quoted(name);
    UNDERSCORE_AS_NAME = "`_` is not a name";
    reserved_name(name) =
        "{} begins with two underscores, which are reserved for generated code", quoted(name);
    raw_name(name) = "{} is a raw identifier, which cannot be used as a name here", quoted(name);
    OTHER_NAME_HELP = "choose another name";

    OPERAND = "an expression";
    NESTED_TOO_DEEPLY = "brackets are nested too deeply";
    NESTED_TOO_DEEPLY_HELP = "name a part of the expression with `let`";
    EMPTY_PARENTHESES = "these parentheses are empty";
    EMPTY_BLOCK = "these braces are empty";
    BLOCK_CONTENT = "a block contains exactly one expression";
    LET_HELP = "name parts of an expression with separate `let` statements";
    ONE_COMPONENT_HELP = "remove the comma to write a number in parentheses";
    MISSING_ELSE = "this `if` has no value when its condition is false";
    MISSING_ELSE_HELP = "add `else { … }`";
    one_value(name) = "the mode `{name}` needs at least two values";
    EQUALITY = "conditions compare with `==`, not `=`";
    EQUALITY_HELP = "write `if clutch == open { … } else { … }`, and `<`, `<=`, `>` or `>=` for what moves";
    LOGIC = "conditions are combined with `&&` and `||`, and are allowed only after `if`";
    LOGIC_HELP = "write `if a < b && !(c < d) || e < f { … } else { … }`";
    LONG_CONDITION_HELP =
        "nest one `if` in another, or define a number by each part of the condition, `let near = if a < b { 1 } else { 0 };`";
    long_condition(most) = "this condition takes more than {most} choices by one comparison each";
    COMPARISON_CHAIN = "a comparison has two sides";
    COMPARISON_CHAIN_HELP = "write two comparisons, `a < b && b < c`";
    COMPARISON_PLACE = "comparisons are allowed only between `if` and `{`";
    COMPARISON_PLACE_HELP = "write `if a < b { … } else { … }`";
    UNARY_PLUS = "`+` has nothing on its left";
    UNARY_PLUS_HELP = "remove the sign";
    REFERENCE = "references are not supported";
    REFERENCE_HELP = "remove the `&`: names stand for values";
    MAGNITUDE_HELP = "write `abs(x)` for a magnitude";
    VECTOR_HELP = "write vectors in parentheses: `(a, b)`";
    PARENTHESES_HELP = "group with parentheses";
    LEADING_ZERO_HELP = "write a digit before the point: `0.5`";
    COMMENT_HELP = "write `//` for comments";
    DOUBLE_STAR = "`**` is not an operator";
    DOUBLE_STAR_HELP = "write `^` for powers";
    PATH = "paths with `::` are not supported";
    PATH_HELP = "write functions without a path: `sin(x)` or `x.sin()`";
    MACRO = "macros cannot be called in expressions";
    CONVERSION = "`as` is not supported";
    CONVERSION_HELP = "remove the conversion: all numbers have one type";
    REMAINDER = "`%` is not an operator";
    MACRO_HELP = "write the expression itself, with functions such as `sin(x)`";
    FACTORIAL = "`!` is not an operator";
    FACTORIAL_HELP = "write a factorial as a number: `24` for 4!";
    REMAINDER_HELP =
        "angles need no remainder; comments begin with `//`";
    SECOND_EQUALS_HELP = "a statement assigns one value to one name; write a statement for each";
    INDEX = "square brackets are not allowed here";
    INDEX_HELP = "the components of a vector are `.x`, `.y` and `.z`";
    NUMBERED_COMPONENT = "components are not numbered";
    ARGUMENT_HELP = "write the argument of a function in parentheses: `cos(x)`";
    TYPE_HELP = "`#[scalar(f32)]` or `struct Name<S>;` specifies the type of all numbers";
    MATRIX_PRODUCT_HELP = "write `*` for the product of a matrix and a vector, `A * v`";
    INDEX_LAST_HELP = "indices are at the end of names: `case_z[i]` for `z` of `case[i]`";
    PRODUCT_HELP = "write `*` between the factors of a product";
    keyword_as_value(word) = "the keyword {} has no value", quoted(word);
    KEYWORD_AS_VALUE_HELP = "give the expression a name with `let` and use that name in both places";
    no_number(literal) = "{} is not a number", quoted(literal);
    SUFFIX = "numbers have no individual types here";
    suffix_help(digits) = "write {}", quoted(digits);
    LETTERS = "letters follow this number directly";

    NUMBER_HELP = "write a number such as `2`, `0.5` or `1e-3`";
    EXCESSIVE_NUMBER_HELP = "round it, or choose other units";
    NOT_DECIMAL = "numbers are written in decimal";
    excessive_number(literal) = "the number {} is too long or too extreme to be exact", quoted(literal);

    /// Message as in [`expected`], for an operator of two characters.
    expected_instead(wanted, found) = "expected {wanted}, found `{found}`";
}

/// Maximum length of quotations in messages.
const LONGEST_QUOTE: usize = 40;

/// Quotes a piece of the input.
fn quoted(text: impl Display) -> String {
    format!("`{}`", shortened(text))
}

fn shortened(text: impl Display) -> String {
    let text = text.to_string();
    match text.char_indices().nth(LONGEST_QUOTE) {
        None => text,
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
        Some(other) => quoted(other.to_string()),
    }
}

/// Returns the message for a place that only admits certain tokens.
pub(super) fn expected(wanted: &str, token: Option<&TokenTree>) -> String {
    format!("expected {wanted}, found {}", found(token))
}

/// Returns the message for a meaningless token.
pub(super) fn misplaced(token: Option<&TokenTree>) -> String {
    format!("unexpected {}", found(token))
}

/// Returns the message for an unexpected token after an expression.
pub(super) fn expected_operator_or(wanted: &str, token: Option<&TokenTree>) -> String {
    let conjunction = if wanted.contains(" or ") { "," } else { " or" };
    expected(&format!("an operator{conjunction} {wanted}"), token)
}

// Text that is not a sequence of tokens.

pub(super) fn unbalanced(bracket: char) -> String {
    match bracket {
        '(' | '[' | '{' => format!("`{bracket}` is never closed"),
        _ => format!("`{bracket}` has no matching opening bracket"),
    }
}

pub(super) fn meaningless_character(character: char) -> String {
    format!("unexpected character `{}`", character.escape_debug())
}

// The head of a declaration.

pub(super) fn levels_of_accuracy() -> String {
    let levels = Accuracy::ALL.map(|level| format!("`#[accuracy({})]`", level.name()));
    format!("write one of {}", levels.join(", "))
}

// Statements.

// Events.

// Friction.

// Reduced types.

pub(super) fn statements_are(keywords: &[&str]) -> String {
    format!("statements begin with one of `{}`", keywords.join("`, `"))
}

// Names.

// Expressions.

// Numbers.

pub(super) fn letters_help(digits: &str, letters: &str) -> String {
    format!("write {} for a product", quoted(format!("{digits} * {letters}")))
}
