//! Diagnostics for names and functions: declared twice, too late, not at all, or spelt as they are elsewhere.

pub(in crate::elaborate) fn declared_twice(name: &str) -> String {
    format!("the name `{name}` is declared twice")
}

pub(in crate::elaborate) fn first_declared(name: &str, kind: &str) -> String {
    let article = if kind.starts_with(['e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("`{name}` is first declared here, as {article} {kind}")
}

pub(in crate::elaborate) fn unused(kind: &str, name: &str) -> String {
    format!("{kind} `{name}` is never used")
}

pub(in crate::elaborate) fn never_called(name: &str) -> String {
    format!("the function `{name}` is never called")
}

pub(in crate::elaborate) const NEVER_CALLED_HELP: &str = "call it, or remove it";

pub(in crate::elaborate) fn unused_help(name: &str) -> String {
    format!("remove it, or call it `_{name}` if this is intended")
}

pub(in crate::elaborate) fn unknown_name(name: &str) -> String {
    format!("unknown name `{name}`")
}

/// Message for the rate of a component where a velocity is needed.
pub(in crate::elaborate) fn component_of_quaternion(name: &str) -> String {
    format!("`{name}` is a component of a unit quaternion, whose rate is not an independent velocity")
}

/// Message for a velocity where a coordinate is needed.
pub(in crate::elaborate) fn velocity_as_coordinate(name: &str) -> String {
    format!("`{name}` is a velocity, not a coordinate")
}

pub(in crate::elaborate) const QUATERNION_HELP: &str =
    "write a component of the angular velocity, whose name ends in `_wx`, `_wy` or `_wz`";

pub(in crate::elaborate) const NO_RATE_TO_NAME: &str =
    "this is not the rate of a coordinate, or that rate already has a name";
pub(in crate::elaborate) const VELOCITY_HELP: &str =
    "write `velocity u = dot(x);` once for a coordinate `x`; for any other velocity write `let u = e;`";

/// Behind what is said of a name that has no meaning in several places.
pub(in crate::elaborate) fn and_elsewhere(others: usize) -> String {
    match others {
        1 => ", here and in one other place".to_owned(),
        others => format!(", here and in {others} other places"),
    }
}

pub(in crate::elaborate) fn unknown_function(name: &str) -> String {
    format!("unknown function `{name}`")
}

pub(in crate::elaborate) fn did_you_mean(nearest: &str) -> String {
    format!("did you mean `{nearest}`?")
}

pub(in crate::elaborate) fn used_too_early(name: &str) -> String {
    format!("`{name}` is used before it is declared")
}

pub(in crate::elaborate) const ORDER_HELP: &str = "a name is known only after its declaration";

/// Message for another name that is used too early.
pub(in crate::elaborate) fn also_declared_here(name: &str) -> String {
    format!("`{name}`, also used too early, is declared here")
}

pub(in crate::elaborate) const PLAIN_NAMES_HELP: &str =
    "functions and constants go by their plain names, `sin(x)` and `pi`";

/// Message for a word such as `omega` where a single coordinate moves.
pub(in crate::elaborate) fn rate_of_single(coordinate: &str) -> String {
    format!(
        "the rate of `{coordinate}` is `dot({coordinate})`; declare other quantities with `param`, `input` or `let`"
    )
}

pub(in crate::elaborate) const RUST_CONSTANT_HELP: &str = "constants of Rust are not seen here: declare `param name;` and set that field when the program runs, or give the number, `const name = 9.81;`";
pub(in crate::elaborate) const DECLARED_HERE: &str = "it is declared here";
pub(in crate::elaborate) const DECLARE_FIRST: &str =
    "declare it before this line with `param`, `coord`, `input` or `let`";
pub(in crate::elaborate) fn array_called(name: &str) -> String {
    format!("`{name}` is an array, not a function")
}

pub(in crate::elaborate) fn element_help(name: &str, indices: &str) -> String {
    format!("write `{name}{indices}`; the first element has the index 0")
}

/// Advice for a function that the language does not have.
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

/// Message for `x(t)`.
pub(in crate::elaborate) fn of_time(name: &str) -> String {
    format!("write `{name}`: its dependence on time is implied")
}

pub(in crate::elaborate) const PRODUCT_HELP: &str = "write `*` between the factors of a product";

pub(in crate::elaborate) fn has_no_value(kind: &str, name: &str) -> String {
    format!("{kind} `{name}` cannot be used in an expression")
}

pub(in crate::elaborate) const NAME_IT_WITH_LET: &str =
    "give the expression a name with `let` and use that in both places";

pub(in crate::elaborate) fn function_as_value(name: &str) -> String {
    format!("the function `{name}` needs arguments: `{name}(…)`")
}

pub(in crate::elaborate) fn method_as_value(name: &str) -> String {
    format!("the function `{name}` needs parentheses: `.{name}()`")
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

pub(in crate::elaborate) fn write_call(usage: &str) -> String {
    format!("write `{usage}`")
}

pub(in crate::elaborate) const NAMELESS_CONSTRAINT_HELP: &str = "a constraint needs its own name, which stands for its force: write x = a as `constraint name = x - (a);`";
pub(in crate::elaborate) const OTHER_EVENT_HELP: &str =
    "an event needs its own name: write `event name = e, falling => stop;`";
pub(in crate::elaborate) const OTHER_OUTPUT_HELP: &str =
    "an output needs its own name: write `output name = e;`";
