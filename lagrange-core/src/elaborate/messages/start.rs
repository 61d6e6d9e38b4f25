//! Diagnostics for initial values.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    INITIAL_VALUE = "an initial value";
    START_HELP =
        "write `start x = e;` or `start dot(x) = e;` with a coordinate `x`, `start a = e;` with a state `a`";
    started_twice(target) = "`{target}` has two initial values";
    STARTED_HERE = "the other one is here";
    STARTED_TWICE_HELP = "remove one of them";
    declare_entry(name) =
        "declare it before this line, with `coord {name};`, `state {name};` or `discrete {name};`";
    whole_orientation(name) =
        "the orientation `{name}` is assigned by the components of its unit quaternion";
    start_outside(name, range) = "this start of `{name}` is outside of its range, `{range}`";
    zero_outside(name, range) = "`{name}` starts at zero, which is outside of its range, `{range}`";
    START_OUTSIDE_HELP = "change the range, or give an initial value within it with `start`";
    PART_OF_QUATERNION = "an initial orientation needs all components of its unit quaternion";
}

/// Returns advice that lists the components of a quaternion.
pub(in crate::elaborate) fn whole_quaternion(components: [&str; 4]) -> String {
    let values = ["cos(a/2)", "x*sin(a/2)", "y*sin(a/2)", "z*sin(a/2)"];
    let starts = components.iter().zip(values).map(|(name, value)| format!("{name} = {value}"));
    let starts = starts.collect::<Vec<_>>().join(", ");
    format!("for a turn by a about the unit vector (x, y, z) write `start {starts};`")
}
