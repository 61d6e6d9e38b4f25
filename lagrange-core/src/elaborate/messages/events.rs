//! Diagnostics for events, contacts, friction and stabilisation.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    PERIOD = "the period of a clock";
    period_is_not_positive(number) = "the period of a clock is {number}, but it must be positive";
    PERIOD_HELP = "write the time between two ticks, such as `every 0.01 => { … }`";
    EVENT_FUNCTION = "the function of an event";
    EVENT_FUNCTION_HELP =
        "contacts open, and friction sticks and slips, without a separate event; an `output` may use the force";
    constant_event(name) = "the function of the event `{name}` is constant, so it has no zeros to find";
    CONSTANT_EVENT_HELP =
        "write a function of time, coordinates, velocities or inputs that passes zero during the motion";

    ASSIGNED_VALUE = "the value after an event";
    NOT_ASSIGNABLE = "nothing can be assigned to this";
    ASSIGNMENT_HELP =
        "an event changes coordinates, velocities and states, `x = e;` or `dot(x) = e;`; declare other values that it changes as `discrete k = e;`";
    assigned_twice(target) = "`{target}` is assigned twice by one event";
    ASSIGNED_TWICE_HELP = "remove one of them: all values are assigned at once";
    REDUCED_HELP = "remove the `reduce`, or declare the reduced system separately";
    ASSIGNED_HERE = "first assigned here";

    REDUCED_EVENTS = "a system with events or friction cannot be reduced yet";
    EVENT_IS_HERE = "one is declared here";

    GAP = "the gap of a contact";
    HEIGHT = "the height of a terrain";
    GAP_HELP = "a gap is a function of coordinates and time";
    gap_without_coordinate(name) = "the gap of the contact `{name}` does not depend on any coordinate";
    CROSSING_IMPACT = "an impact needs the side on which the bodies are apart";
    CROSSING_IMPACT_HELP =
        "write `falling` if the function is positive where they are apart, `rising` if it is negative there";

    RESTITUTION = "a coefficient of restitution";
    RESTITUTION_OF_CONTACT = "coefficient of restitution of contact";
    restitution_out_of_range(value) = "the coefficient of restitution {value} is not between 0 and 1";
    RESTITUTION_HELP =
        "it is the ratio of the speeds after and before: 0 if bodies stay together, 1 if no energy is lost";

    SLIP = "a slip velocity";
    slip_without_velocity(name) =
        "the slip velocity of the friction `{name}` does not depend on any velocity";
    nonlinear_slip(name) = "the slip velocity of the friction `{name}` is not linear in the velocities";
    slip_of_components(name, count) = "the slip velocity of the friction `{name}` has {count} components";
    SLIP_OF_COMPONENTS_HELP =
        "write one slip velocity, or `(s1, s2)` along two axes of the plane that bodies share where they touch";
    smooth_plane(name) = "the smooth friction `{name}` has two slip velocities";
    SMOOTH_PLANE_HELP =
        "leave `smooth: …` out, or write a `force` such as `-limit * s / sqrt(norm(s)^2 + width^2)`, which has one force for both directions";
    SLIP_HELP = "write the velocity along which the force acts, such as `dot(x)` or `dot(x) - r * dot(phi)`";

    LIMIT = "a friction limit";
    LIMIT_HELP =
        "limits are functions of time, coordinates, velocities and of the forces in constraints and contacts";
    nonlinear_limit(name) =
        "the limit of the friction `{name}` is not linear in the forces on which it depends";
    NONLINEAR_LIMIT_HELP =
        "write a sum of forces times coefficients, such as `mu * normal`, without `abs`; where a constraint may pull, use a contact, which never does";
    negative_limit(value) = "the friction limit {value} is negative";
    NEGATIVE_LIMIT_HELP = "a limit is the magnitude of the force, which always opposes the slip velocity";
    square_of_friction(first, second, contact) =
        "`{first}` and `{second}` limit the friction of the contact `{contact}` in each direction separately: a diagonal slide decelerates up to √2 times too much";
    FRICTION_IS_HERE = "the other direction is declared here";
    SQUARE_HELP =
        "declare one friction with both slip velocities, such as `friction rub = (s1, s2), limit;`: its force keeps within a cone";

    STATIC_BELOW_KINETIC = "the static limit is below the kinetic one";
    STATIC_BELOW_KINETIC_HELP =
        "a body that begins to slip would stick again at once: make the static limit at least as large";

    WIDTH = "the width of smooth friction";
    width_not_positive(value) = "the width of smooth friction must be positive, but this is {value}";
    WIDTH_HELP =
        "it is the slip velocity at which tanh(slip / width) is 0.76: choose it small compared with the velocities of the motion";

    STABILISATION = "the rate of stabilisation";
    STABILISED_TWICE = "stabilisation is declared twice";
    STABILISED_TWICE_HELP = "remove one of them: there is one rate for all constraints";
    STABILISED_HERE = "first declared here";
    NOTHING_TO_STABILISE = "there is no constraint to stabilise";
    NOTHING_TO_STABILISE_HELP = "remove the statement, or write `constraint name = e;` for e = 0";
    negative_rate(value) = "the rate of stabilisation {value} is negative, so constraint errors would grow";
    NEGATIVE_RATE_HELP = "residuals decay like exp(-rate * t): choose a positive rate, in units of 1 / time";
}
