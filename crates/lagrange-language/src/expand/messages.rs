//! Messages about arrays, loops and sums, and the names of their elements.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(super):

    FIRST_DECLARED = "first declared here";
    OTHER_NAME_HELP = "choose another name";
    OTHER_VARIABLE_HELP = "choose another name for the variable of the loop";
    DECLARE_HELP = "declare it, `const n = 3;`, or use the variable of a loop around this";
    INDEX_HELP = "indices are integers, made of numbers, constants and variables of loops";
    CONDITION_HELP = "write `let name = if a < b { … } else { … };`";
    CONDITION_IN_VALUE_HELP =
        "compare other values with `<`, `<=`, `>` or `>=` in a nested `if`: `if i == 0 { if x < 1 { a } else { b } } else { b }`";
    NO_INDEX = "an index must be known at compile time";
    TOO_LARGE = "this index is too large";
    FROM_ZERO_HELP = "indices begin at 0";
    SIZE_HELP = "write the number of elements: `coord theta[3];` declares theta[0], theta[1] and theta[2]";
    ARRAY_IN_LOOP_HELP = "declare all of it before the loop: `param m[n] = 1;`";
    LIST_IN_LIST = "an element has one value, not a list of them";
    LIST_AS_TUPLE = "the values of an array are a list in square brackets";
    LIST_AS_TUPLE_HELP = "write `[a, b]`; parentheses are for vectors, `let v = (a, b);`";
    LIST_OF_LISTS_HELP = "write a list for each row, `[[a, b], [c, d]]`, or a single value for all elements";
    LIST_HELP = "write one value for each element, or a single one for all";
    TOO_LONG_HELP = "write shorter loops";
    shadowed_variable(name) = "`{name}` is already the variable of an enclosing loop";
    variable_is_parameter(name) =
        "`{name}` is a parameter of the function or height and cannot be the variable of a sum in it";
    variable_is_declared(name) = "`{name}` is already declared and cannot be the variable of a loop";
    local_is_declared(name) = "`{name}` is already declared, and a local name must be new";
    known_in_loop(name) =
        "`{name}` is known only inside its loop or braces: outside, declare it again, or an element of a loop, `let {name}[i] = …; … {name}[0]`";
    values_called(name) = "`{name}` is an array of values, which cannot be called";
    VALUES_CALLED_HELP = "write `*` before the parentheses for a product";
    NOTHING_LEFT = "the braces are empty after expansion: no condition in them holds, or every range is empty";
    NOTHING_LEFT_HELP = "enclose the statement in an `if` that holds only where the braces are not empty";
    too_many_statements(most) = "loops up to this one expand to more than {most} statements";
    too_many_terms(most) = "loops and sums up to this one expand to more than {most} terms";
    too_many_elements(most) = "arrays up to this one have more than {most} elements";
    no_constant(name) = "`{name}` cannot be an index, which must be known at compile time";
    constant_help(name) = "declare it as an integer, `const {name} = 3;`, or use the variable of a loop";
    index_or_unit(name) = "declare it as an integer, `const {name} = 3;`, or write a unit behind a colon, `: {name}`";
    no_integer(number, place) = "the index {number} is not an integer{place}";
    division_by_zero(place) = "this index contains a division by zero{place}";
    unknown_name(name) = "unknown name `{name}`";
    declare_array(name) = "declare it, `param {name}[n] = 1;`, with its number of elements";
    write(text) = "write `{text}`";
    in_its_loop(name) = "the variable `{name}` is known only inside its loop";

    /// Message for a name in a condition with `==`, `&&` or similar operators.
    condition_in_value(name) =
        "`{name}` is not an index: only indices can be compared with `==` or combined with `&&`, `||`, `!` and `%`";
    condition(name) =
        "conditions around statements can only use indices, and `{name}` is known only at run time";
    did_you_mean(name) = "did you mean `{name}`?";
    no_array(name) = "`{name}` is not an array and has no elements";
    no_array_help(name) = "write `{name}`; vectors and matrices have indices, `let p = (x, y); … p[0]`";
    no_index(name) = "`{name}` is an array: specify one of its elements";
    written_help(example) = "write an index after it, as in `{example}`";
    nothing_to_compare(function) = "there is no `{function}` of an empty range";
    NOTHING_TO_COMPARE_HELP = "let the range have at least one value";
    NO_WHOLE = "an array with more than two indices has no value as a whole";
    no_element(element) = "there is no `{element}`";
    below_zero(index) = "the index {index} is negative";
    negative_index(element) = "there is no `{element}`: an index is negative";
    declared_again(name) = "`{name}` is declared again in every iteration of the loop";
    declared_again_help(name) = "declare an element in each, `{name}[i]`, or declare it before the loop";
    array_in_loop(name) = "all elements of `{name}` are declared again in every iteration of the loop";
    no_size(name, size) = "`{name}` cannot have {size} elements: an array has at least one";
    element_twice(element) = "the name `{element}` is declared twice";
    declared_as_whole(name) = "all elements of `{name}` are already declared";
    array_and_name(name) = "`{name}` is declared both with an index and without";
    same_text(text) =
        "an element or a member and another name both become `{text}` when arrays and parts are expanded";

    DECLARE_PART = "place a part of this name before: `leg: Leg { … }`";
    ARRAY_OF_PARTS_HELP = "write the number of elements: `leg[i in 0..4]: Leg { … }`";
    UNPLACED_HELP = "place it where the same conditions hold";
    LIST_OUTSIDE_ARRAY = "a list of values belongs to an array of parts";
    LIST_OUTSIDE_ARRAY_HELP = "write `leg[i in 0..4]: Leg { … }`, or give a single value";
    ONE_ELEMENT_HELP = "for all of them, write `[i in 0..n]` after the name";
    INCLUDE_INSIDE = "a file is included inside of a loop or a condition";
    INCLUDE_INSIDE_HELP = "include it before: its parts can be placed everywhere";
    PART_INSIDE = "a part is declared inside of something else";
    PART_INSIDE_HELP = "declare it before: a part can be placed in other parts and in loops";
    RECURSION_HELP = "remove this placement, or place what it needs where the part is placed";
    NEEDS_NAME_HELP = "give the name of something declared, such as `leg: Leg { on: trunk; }`";
    unknown_part(name) = "unknown part `{name}`";
    declare_the_part(name) = "declare it, `part {name}(…) {{ … }}`";
    unknown_argument(argument, part) = "the part `{part}` has no argument `{argument}`";
    missing_argument(argument, part) = "the argument `{argument}` of the part `{part}` is missing";
    give(argument) = "give it between the braces, `{argument}: e;`, or a default where the part is declared";
    repeated_argument(name) = "the argument `{name}` is declared twice";
    argument_as_name(name, part) = "`{name}` is an argument of the part `{part}` and is declared again in it";
    late_argument(name) = "the argument `{name}` is declared after this one";
    late_argument_help(name) = "move `{name}` before this argument";
    outside_statement(word) = "`{word}` is about the whole system and cannot be in a part";
    outside_statement_help(word) = "move `{word}` outside of the part";
    free_argument(name) = "`{name}` is an argument, and a joint `free` belongs where its body is declared";
    free_argument_help(name) = "write `free {name};` outside of the part, with the name that the body has there";
    outside(name, part) = "`{name}` is declared outside the part `{part}`, where only its own names and arguments are visible";
    outside_help(name, part) = "add it to the arguments, `part {part}({name})`, and give it where the part is placed: `{name}: {name};`";
    unknown_in_part(name, part) = "unknown name `{name}` in the part `{part}`";
    declare_in_part(name, part) = "declare it in the part, or add it to the arguments, `part {part}({name})`";
    unplaced(name) = "the part `{name}` is not placed here";
    no_member(member, part) = "there is no `{member}`: the part `{part}` does not declare it";
    no_part(name) = "`{name}` is not a placed part and has no members here";
    no_part_help(name) = "write `{name}` alone, or place a part of this name: `{name}: Leg {{ … }}`";
    part_as_value(part) = "`{part}` is a part and has no value";
    needs_name(argument) = "the argument `{argument}` stands for an expression, and a name is needed here";
    recursion(part) = "the part `{part}` contains itself";
    contained_in(outer, inner) = "`{inner}` is placed in `{outer}` here";
    part_twice(name) = "the part `{name}` is declared twice";
    part_and_name(name) = "`{name}` is both a placed part and another name";
    part_and_declared(name) = "`{name}` is both a part and another name";
    placed_twice(name) = "`{name}` is placed twice";
    no_parts(name, count) = "`{name}` cannot have {count} elements: an array has at least one";
    lacks_first(first, given) = "`{given}` is placed, but not `{first}`";
    expanded_too_deep(most) = "loops, conditions and parts are nested more than {most} deep";
    too_deep(most) = "parts are nested more than {most} deep";
    too_many_parts(most) = "placements up to this one are more than {most}";
    placed_here(part, name) = "in the part `{part}`, placed here as `{name}`";
    placed_here_twice(part, name) = "in the part `{part}`, placed here as `{name}` and once more";
    placed_here_and(part, name, others) = "in the part `{part}`, placed here as `{name}` and {others} times more";
    never_placed(name) = "the part `{name}` is never placed";
    never_placed_help(name) = "place it, `name: {name} {{ … }}`, or begin its name with `_`";
}

/// Returns the name of an element in expanded declarations: `u_1_2`.
pub(super) fn element(name: &str, indices: &[i64]) -> String {
    indices.iter().fold(name.to_owned(), |text, index| format!("{text}_{index}"))
}

/// Returns the spelling of an element: `u[1][2]`.
pub(super) fn written(name: &str, indices: &[i64]) -> String {
    indices.iter().fold(name.to_owned(), |text, index| format!("{text}[{index}]"))
}

pub(super) fn index_count(name: &str, wanted: usize, given: usize) -> String {
    let indices = if wanted == 1 { "index" } else { "indices" };
    format!("elements of `{name}` have {wanted} {indices}, not {given}")
}

pub(super) fn elements_are(name: &str, first: &str, last: &str) -> String {
    match first == last {
        true => format!("the only element of `{name}` is `{first}`"),
        false => format!("the elements of `{name}` are `{first}` to `{last}`"),
    }
}

pub(super) fn elements_lie_between(name: &str, first: &str, last: &str) -> String {
    match first == last {
        true => format!("only `{first}` is declared; its brackets hold an index, not the number of elements"),
        false => format!("the declared elements of `{name}` lie between `{first}` and `{last}`"),
    }
}

pub(super) fn list_length(given: usize, wanted: i64) -> String {
    let values = if given == 1 { "value is" } else { "values are" };
    let elements = if wanted == 1 { "element" } else { "elements" };
    format!("{given} {values} given for {wanted} {elements}")
}

/// Returns advice for a placed part that does not exist.
pub(super) fn placed_are(known: &[String]) -> String {
    match known {
        [] => DECLARE_PART.to_owned(),
        [only] => format!("only `{only}` is placed"),
        [first, .., last] => format!("`{first}` to `{last}` are placed"),
    }
}

/// Returns advice for a member that does not exist, with the first existing members.
pub(super) fn members_are<'a>(part: &str, members: impl Iterator<Item = &'a str>) -> String {
    let members = members.take(8).map(|member| format!("`{member}`")).collect::<Vec<_>>();
    match members.is_empty() {
        true => format!("the part `{part}` declares no names"),
        false => format!("the part `{part}` declares {}", members.join(", ")),
    }
}

/// Returns advice for an argument that does not exist.
pub(super) fn arguments_are(part: &str, arguments: &[&str]) -> String {
    match arguments {
        [] => format!("the part `{part}` has no arguments"),
        known => format!("its arguments are `{}`", known.join("`, `")),
    }
}
