//! Diagnostics for names and functions: declared twice, too late or not at all, or spelled as in
//! other languages.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    declared_twice(name) = "the name `{name}` is declared twice";
    unused(kind, name) = "{kind} `{name}` is never used";
    never_called(name) = "the function `{name}` is never called";
    NEVER_CALLED_HELP = "call it, or remove it";
    unused_help(name) = "remove it, or call it `_{name}` if this is intended";
    unknown_name(name) = "unknown name `{name}`";

    /// Message for the rate of a component where a velocity is needed.
    component_of_quaternion(name) =
        "`{name}` is a component of a unit quaternion, whose rate is not an independent velocity";

    /// Message for a velocity where a coordinate is needed.
    velocity_as_coordinate(name) = "`{name}` is a velocity, not a coordinate";
    QUATERNION_HELP = "write a component of the angular velocity, whose name ends in `_wx`, `_wy` or `_wz`";

    NO_RATE_TO_NAME = "this is not the rate of a coordinate, or that rate already has a name";
    VELOCITY_HELP =
        "write `velocity u = dot(x);` once for a coordinate `x`; for any other velocity write `let u = e;`";
    unknown_function(name) = "unknown function `{name}`";
    did_you_mean(nearest) = "did you mean `{nearest}`?";
    used_too_early(name) = "`{name}` is used before it is declared";
    ORDER_HELP = "a name is known only after its declaration";

    /// Message for another name that is used too early.
    also_declared_here(name) = "`{name}`, also used too early, is declared here";
    PLAIN_NAMES_HELP = "write functions and constants without a prefix: `sin(x)` and `pi`";

    /// Message for a word such as `omega` if there is a single moving coordinate.
    rate_of_single(coordinate) =
        "the rate of `{coordinate}` is `dot({coordinate})`; declare other quantities with `param`, `input` or `let`";
    RUST_CONSTANT_HELP =
        "Rust constants are not visible here: declare `param name;` and set that field when the program runs, or give the number, `const name = 9.81;`";
    DECLARED_HERE = "it is declared here";
    components_of_orientation(name) =
        "`{name}` is an orientation: its angular velocity is `{name}_wx`, `{name}_wy`, `{name}_wz`, its unit quaternion `{name}_qw`, `{name}_qx`, `{name}_qy`, `{name}_qz`";
    DECLARE_FIRST = "declare it before this line with `param`, `coord`, `input` or `let`";
    array_called(name) = "`{name}` is an array, not a function";
    element_help(name, indices) = "write `{name}{indices}`; the first element has the index 0";

    /// Message for `x(t)`.
    of_time(name) = "write `{name}`: its dependence on time is implied";
    PRODUCT_HELP = "write `*` between the factors of a product";
    has_no_value(kind, name) = "{kind} `{name}` cannot be used in an expression";
    NAME_IT_WITH_LET = "give the expression a name with `let` and use that in both places";
    function_as_value(name) = "the function `{name}` needs arguments: `{name}(…)`";
    method_as_value(name) = "the function `{name}` needs parentheses: `.{name}()`";
    write_call(usage) = "write `{usage}`";
    NAMELESS_CONSTRAINT_HELP =
        "a constraint needs its own name, which stands for its force: write x = a as `constraint name = x - (a);`";
    OTHER_EVENT_HELP = "an event needs its own name: write `event name = e, falling => stop;`";
    OTHER_CONTACT_HELP =
        "a contact needs its own name: write `contact name = wheel on ground;`, or `event name = gap, falling => impact(e);`";
    OTHER_OUTPUT_HELP = "an output needs its own name: write `output name = e;`";
}

pub(in crate::elaborate) fn first_declared(name: &str, kind: &str) -> String {
    let article = if kind.starts_with(['e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("`{name}` is first declared here, as {article} {kind}")
}

/// Returns the end of the message for a name that is undefined in several places.
pub(in crate::elaborate) fn and_elsewhere(others: usize) -> String {
    match others {
        1 => ", here and in one other place".to_owned(),
        others => format!(", here and in {others} other places"),
    }
}

/// Returns advice for a function that does not exist in the language.
pub(in crate::elaborate) fn declare_function(name: &str, count: usize) -> String {
    let parameters = match count {
        0 | 1 => "x".to_owned(),
        2 => "x, y".to_owned(),
        3 => "x, y, z".to_owned(),
        count => (1..=count).map(|i| format!("x{i}")).collect::<Vec<_>>().join(", "),
    };
    format!(
        "`function {name}({parameters});` before this line calls a function of Rust by that name; those of the language are listed in the documentation of `lagrange::system!`"
    )
}

pub(in crate::elaborate) fn not_a_function(name: &str, kind: &str) -> String {
    let article = if kind.starts_with(['e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("`{name}` is {article} {kind}, not a function")
}

pub(in crate::elaborate) fn wrong_argument_count(name: &str, expected: usize, found: usize) -> String {
    let plural = if expected == 1 { "" } else { "s" };
    let given = match found {
        0 => "none is given".to_owned(),
        1 => "1 is given".to_owned(),
        _ => format!("{found} are given"),
    };
    format!("`{name}` takes {expected} argument{plural}, but {given}")
}
