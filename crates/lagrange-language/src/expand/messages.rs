//! Messages about arrays, loops and sums, and the names of their elements.

use lagrange_expr::number::Number;

pub(super) const FIRST_DECLARED: &str = "first declared here";
pub(super) const OTHER_NAME_HELP: &str = "choose another name";
pub(super) const OTHER_VARIABLE_HELP: &str = "choose another name for the variable of the loop";
pub(super) const DECLARE_HELP: &str = "declare it, `const n = 3;`, or use the variable of a loop around this";
pub(super) const INDEX_HELP: &str = "indices are integers, made of numbers, constants and variables of loops";
pub(super) const CONDITION_HELP: &str = "write `let name = if a < b { … } else { … };`";
pub(super) const CONDITION_IN_VALUE_HELP: &str = "compare other values with `<`, `<=`, `>` or `>=` in a nested `if`: `if i == 0 { if x < 1 { a } else { b } } else { b }`";
pub(super) const NO_INDEX: &str = "an index must be known at compile time";
pub(super) const TOO_LARGE: &str = "this index is too large";
pub(super) const FROM_ZERO_HELP: &str = "indices begin at 0";
pub(super) const SIZE_HELP: &str =
    "write the number of elements: `coord theta[3];` declares theta[0], theta[1] and theta[2]";
pub(super) const ARRAY_IN_LOOP_HELP: &str = "declare all of it before the loop: `param m[n] = 1;`";
pub(super) const LIST_IN_LIST: &str = "an element has one value, not a list of them";
pub(super) const LIST_HELP: &str = "write one value for each element, or a single one for all";
pub(super) const TOO_LONG_HELP: &str = "write shorter loops";

/// Returns the name of an element in expanded declarations: `u_1_2`.
pub(super) fn element(name: &str, indices: &[i64]) -> String {
    indices.iter().fold(name.to_owned(), |text, index| format!("{text}_{index}"))
}

/// An element as it is written: `u[1][2]`.
pub(super) fn written(name: &str, indices: &[i64]) -> String {
    indices.iter().fold(name.to_owned(), |text, index| format!("{text}[{index}]"))
}

pub(super) fn shadowed_variable(name: &str) -> String {
    format!("`{name}` is already the variable of an enclosing loop")
}

pub(super) fn variable_is_parameter(name: &str) -> String {
    format!("`{name}` is a parameter of the function and cannot be the variable of a sum in it")
}

pub(super) fn variable_is_declared(name: &str) -> String {
    format!("`{name}` is already declared and cannot be the variable of a loop")
}

pub(super) fn too_many_statements(most: u64) -> String {
    format!("loops up to this one expand to more than {most} statements")
}

pub(super) fn too_many_terms(most: u64) -> String {
    format!("loops and sums up to this one expand to more than {most} terms")
}

pub(super) fn too_many_elements(most: u64) -> String {
    format!("arrays up to this one have more than {most} elements")
}

pub(super) fn no_constant(name: &str) -> String {
    format!("`{name}` cannot be an index, which must be known at compile time")
}

pub(super) fn constant_help(name: &str) -> String {
    format!("declare it as an integer, `const {name} = 3;`, or use the variable of a loop")
}

pub(super) fn no_integer(number: &Number, place: &str) -> String {
    format!("the index {number} is not an integer{place}")
}

pub(super) fn division_by_zero(place: &str) -> String {
    format!("this index contains a division by zero{place}")
}

pub(super) fn unknown_name(name: &str) -> String {
    format!("unknown name `{name}`")
}

pub(super) fn declare_array(name: &str) -> String {
    format!("declare it, `param {name}[n] = 1;`, with its number of elements")
}

pub(super) fn write(text: &str) -> String {
    format!("write `{text}`")
}

pub(super) fn in_its_loop(name: &str) -> String {
    format!("the variable `{name}` is known only inside its loop")
}

/// Message for a name in a condition with `==`, `&&` or the like.
pub(super) fn condition_in_value(name: &str) -> String {
    format!(
        "`{name}` is not an index: only indices can be compared with `==` or combined with `&&`, `||`, `!` and `%`"
    )
}

pub(super) fn condition(name: &str) -> String {
    format!("conditions around statements can only use indices, and `{name}` is known only at run time")
}

pub(super) fn did_you_mean(name: &str) -> String {
    format!("did you mean `{name}`?")
}

pub(super) fn no_array(name: &str) -> String {
    format!("`{name}` is not an array and has no elements")
}

pub(super) fn no_array_help(name: &str) -> String {
    format!("write `{name}`; the components of a vector are `.x`, `.y` and `.z`")
}

pub(super) fn no_index(name: &str) -> String {
    format!("`{name}` is an array: specify one of its elements")
}

pub(super) fn written_help(example: &str) -> String {
    format!("write an index after it, as in `{example}`")
}

pub(super) fn index_count(name: &str, wanted: usize, given: usize) -> String {
    let indices = if wanted == 1 { "index" } else { "indices" };
    format!("elements of `{name}` have {wanted} {indices}, not {given}")
}

pub(super) fn no_element(element: &str) -> String {
    format!("there is no `{element}`")
}

pub(super) fn negative_index(element: &str) -> String {
    format!("there is no `{element}`: an index is negative")
}

pub(super) fn elements_are(name: &str, first: &str, last: &str) -> String {
    match first == last {
        true => format!("the only element of `{name}` is `{first}`"),
        false => format!("the elements of `{name}` are `{first}` to `{last}`"),
    }
}

pub(super) fn elements_lie_between(name: &str, first: &str, last: &str) -> String {
    match first == last {
        true => format!("only `{first}` is declared"),
        false => format!("the declared elements of `{name}` lie between `{first}` and `{last}`"),
    }
}

pub(super) fn declared_again(name: &str) -> String {
    format!("`{name}` is declared again in every iteration of the loop")
}

pub(super) fn declared_again_help(name: &str) -> String {
    format!("declare an element in each, `{name}[i]`, or declare it before the loop")
}

pub(super) fn array_in_loop(name: &str) -> String {
    format!("all elements of `{name}` are declared again in every iteration of the loop")
}

pub(super) fn no_size(name: &str, size: i64) -> String {
    format!("`{name}` cannot have {size} elements: an array has at least one")
}

pub(super) fn list_length(given: usize, wanted: i64) -> String {
    let values = if given == 1 { "value is" } else { "values are" };
    let elements = if wanted == 1 { "element" } else { "elements" };
    format!("{given} {values} given for {wanted} {elements}")
}

pub(super) fn element_twice(element: &str) -> String {
    format!("the name `{element}` is declared twice")
}

pub(super) fn declared_as_whole(name: &str) -> String {
    format!("all elements of `{name}` are already declared")
}

pub(super) fn array_and_name(name: &str) -> String {
    format!("`{name}` is declared both with an index and without")
}

pub(super) fn same_text(text: &str) -> String {
    format!("an element and another name both become `{text}` when arrays are expanded")
}
