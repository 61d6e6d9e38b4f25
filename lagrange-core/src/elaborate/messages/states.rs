//! Diagnostics for first-order states.

pub(in crate::elaborate) const RATE: &str = "the rate of a state";
pub(in crate::elaborate) const RATE_HELP: &str = "rates are functions of time, coordinates, velocities, states and inputs, not of accelerations and forces";

pub(in crate::elaborate) fn stated_twice(name: &str) -> String {
    format!("the rate of `{name}` is stated twice")
}

pub(in crate::elaborate) const STATED_HERE: &str = "first stated here";
pub(in crate::elaborate) const STATED_TWICE_HELP: &str = "add both in one equation, or remove one";

pub(in crate::elaborate) fn declare(name: &str) -> String {
    format!("`dot(…) = e;` is the equation of a state: declare it with `state {name};`")
}

pub(in crate::elaborate) fn rate_of_coordinate(name: &str) -> String {
    format!("`{name}` is a coordinate: its velocity is part of the state and has no equation")
}

pub(in crate::elaborate) const RATE_OF_COORDINATE_HELP: &str = "initial velocities belong to the state from which a simulation starts, accelerations follow from energies and forces; for a condition on velocities write `constraint name = e;`";

pub(in crate::elaborate) fn no_state(kind: &str, name: &str) -> String {
    format!("the {kind} `{name}` is not a state")
}

pub(in crate::elaborate) fn without_equation(name: &str) -> String {
    format!("the state `{name}` has no equation")
}

pub(in crate::elaborate) fn equation_of(name: &str) -> String {
    format!("write `dot({name}) = e;`, with its rate after the equals sign")
}

pub(in crate::elaborate) fn rate_too_early(name: &str) -> String {
    format!("the rate of the state `{name}` is used before its equation")
}

pub(in crate::elaborate) fn rate_too_early_help(name: &str) -> String {
    format!("move `dot({name}) = e;` before this; a rate cannot depend on itself")
}

pub(in crate::elaborate) fn second_rate(name: &str) -> String {
    format!("the rate of the state `{name}` depends on an input, whose rate is unknown")
}

pub(in crate::elaborate) const SECOND_RATE_HELP: &str =
    "remove the second rate, or make the input a `state` with its own equation";

pub(in crate::elaborate) fn in_kinetic(name: &str) -> String {
    format!("momenta must not depend on the state `{name}`, which multiplies a velocity here")
}

pub(in crate::elaborate) const IN_KINETIC_HELP: &str = "Lagrange's equations apply to coordinates, not to states: use states in a `force`, `potential` or `dissipation`, or make this one a `coord`";
pub(in crate::elaborate) const PLACE_HELP: &str = "virtual work and constraints displace coordinates, not states: make this one a `coord`, or write its effect as a `force`";
pub(in crate::elaborate) const TANGENT_JACOBIAN: &str = "`tangent_jacobian` cannot be combined with states";
pub(in crate::elaborate) const TANGENT_JACOBIAN_HELP: &str =
    "it has rows for displacements and velocities only; `jacobian` also has one for each state";
pub(in crate::elaborate) const STATE_IS_HERE: &str = "this is a state";
pub(in crate::elaborate) const SMALL_HELP: &str =
    "a state can be frozen at a value, but its equation cannot be expanded";

pub(in crate::elaborate) fn small(name: &str) -> String {
    format!("the state `{name}` cannot be small")
}

pub(in crate::elaborate) fn assigned_rate(name: &str) -> String {
    format!("the rate of the state `{name}` follows from its equation")
}

pub(in crate::elaborate) fn assigned_rate_help(name: &str) -> String {
    format!("give the state itself a value, `{name} = e;`")
}

pub(in crate::elaborate) const CONSTRAINT: &str = "a constraint";
