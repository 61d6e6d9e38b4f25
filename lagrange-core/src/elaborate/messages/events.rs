//! Diagnostics for events, contacts, friction and stabilisation.

// Events.

pub(in crate::elaborate) const EVENT_FUNCTION: &str = "the function of an event";
pub(in crate::elaborate) const EVENT_FUNCTION_HELP: &str =
    "contacts open, and friction sticks and slips, without a separate event; an `output` may use the force";

pub(in crate::elaborate) fn constant_event(name: &str) -> String {
    format!("the function of the event `{name}` is constant, so it has no zeros to find")
}

pub(in crate::elaborate) const CONSTANT_EVENT_HELP: &str =
    "write a function of time, coordinates, velocities or inputs that passes zero during the motion";

pub(in crate::elaborate) const ASSIGNED_VALUE: &str = "the value after an event";
pub(in crate::elaborate) const NOT_ASSIGNABLE: &str = "nothing can be assigned to this";
pub(in crate::elaborate) const ASSIGNMENT_HELP: &str = "an event changes coordinates, velocities and states: `x = e;` or `dot(x) = e;` with a coordinate `x`, `a = e;` with a state `a`";

pub(in crate::elaborate) fn assigned_twice(target: &str) -> String {
    format!("`{target}` is assigned twice by one event")
}

pub(in crate::elaborate) const ASSIGNED_TWICE_HELP: &str =
    "remove one of them: all values are assigned at once";
pub(in crate::elaborate) const REDUCED_HELP: &str =
    "remove the `reduce`, or declare the reduced system separately";
pub(in crate::elaborate) const ASSIGNED_HERE: &str = "first assigned here";

pub(in crate::elaborate) const REDUCED_EVENTS: &str =
    "a system with events or friction cannot be reduced yet";
pub(in crate::elaborate) const EVENT_IS_HERE: &str = "one is declared here";

// Contacts.

pub(in crate::elaborate) const GAP: &str = "the gap of a contact";
pub(in crate::elaborate) const GAP_HELP: &str = "a gap is a function of coordinates and time";

pub(in crate::elaborate) fn gap_without_coordinate(name: &str) -> String {
    format!("the gap of the contact `{name}` does not depend on any coordinate")
}

pub(in crate::elaborate) const CROSSING_IMPACT: &str =
    "an impact needs the side on which the bodies are apart";
pub(in crate::elaborate) const CROSSING_IMPACT_HELP: &str =
    "write `falling` if the function is positive where they are apart, `rising` if it is negative there";

pub(in crate::elaborate) const RESTITUTION: &str = "a coefficient of restitution";

pub(in crate::elaborate) fn restitution_out_of_range(value: f64) -> String {
    format!("the coefficient of restitution {value} is not between 0 and 1")
}

pub(in crate::elaborate) const RESTITUTION_HELP: &str =
    "it is the ratio of the speeds after and before: 0 if bodies stay together, 1 if no energy is lost";

// Friction.

pub(in crate::elaborate) const SLIP: &str = "a slip velocity";

pub(in crate::elaborate) fn slip_without_velocity(name: &str) -> String {
    format!("the slip velocity of the friction `{name}` does not depend on any velocity")
}

pub(in crate::elaborate) fn nonlinear_slip(name: &str) -> String {
    format!("the slip velocity of the friction `{name}` is not linear in the velocities")
}

pub(in crate::elaborate) const SLIP_HELP: &str =
    "write the velocity along which the force acts, such as `dot(x)` or `dot(x) - r * dot(phi)`";

pub(in crate::elaborate) const LIMIT: &str = "a friction limit";
pub(in crate::elaborate) const LIMIT_HELP: &str =
    "limits are functions of time, coordinates, velocities and of the forces in constraints and contacts";

pub(in crate::elaborate) fn nonlinear_limit(name: &str) -> String {
    format!("the limit of the friction `{name}` is not linear in the forces on which it depends")
}

pub(in crate::elaborate) const NONLINEAR_LIMIT_HELP: &str = "write a sum of forces times coefficients, such as `mu * normal`, without `abs`: the force of a contact never pulls; where a constraint may pull, use a contact instead";

pub(in crate::elaborate) fn negative_limit(value: f64) -> String {
    format!("the friction limit {value} is negative")
}

pub(in crate::elaborate) const NEGATIVE_LIMIT_HELP: &str =
    "a limit is the magnitude of the force, which always opposes the slip velocity";

pub(in crate::elaborate) fn square_of_friction(first: &str, second: &str, contact: &str) -> String {
    format!(
        "`{first}` and `{second}` limit the friction of the contact `{contact}` in each direction separately: a diagonal slide decelerates up to √2 times too much"
    )
}

pub(in crate::elaborate) const FRICTION_IS_HERE: &str = "the other direction is declared here";
pub(in crate::elaborate) const SQUARE_HELP: &str = "choose the first direction along the slide, or silence this warning with `#[allow(deprecated)]` on the struct";

pub(in crate::elaborate) const STATIC_BELOW_KINETIC: &str = "the static limit is below the kinetic one";
pub(in crate::elaborate) const STATIC_BELOW_KINETIC_HELP: &str =
    "a body that begins to slip would stick again at once: make the static limit at least as large";

pub(in crate::elaborate) const WIDTH: &str = "the width of smooth friction";

pub(in crate::elaborate) fn width_not_positive(value: f64) -> String {
    format!("the width of smooth friction must be positive, but this is {value}")
}

pub(in crate::elaborate) const WIDTH_HELP: &str = "it is the slip velocity at which tanh(slip / width) is 0.76: choose it small compared with the velocities of the motion";

// Stabilisation.

pub(in crate::elaborate) const STABILISATION: &str = "the rate of stabilisation";
pub(in crate::elaborate) const STABILISED_TWICE: &str = "stabilisation is declared twice";
pub(in crate::elaborate) const STABILISED_TWICE_HELP: &str =
    "remove one of them: there is one rate for all constraints";
pub(in crate::elaborate) const STABILISED_HERE: &str = "first declared here";
pub(in crate::elaborate) const NOTHING_TO_STABILISE: &str = "there is no constraint to stabilise";
pub(in crate::elaborate) const NOTHING_TO_STABILISE_HELP: &str =
    "remove the statement, or write `constraint name = e;` for e = 0";

pub(in crate::elaborate) fn negative_rate(value: f64) -> String {
    format!("the rate of stabilisation {value} is negative, so constraint errors would grow")
}

pub(in crate::elaborate) const NEGATIVE_RATE_HELP: &str =
    "residuals decay like exp(-rate * t): choose a positive rate, in units of 1 / time";
