//! Diagnostics for first-order states.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    carried(state) = "a velocity in an energy contains the rate of the state `{state}`, which depends on the motion";
    CARRIED_HELP =
        "virtual displacements leave states unchanged: declare the quantity as a `coord`, and its rate as a `constraint`";
    RATE = "the rate of a state";
    RATE_HELP =
        "rates are functions of time, coordinates, velocities, states and inputs, not of accelerations and forces";
    stated_twice(name) = "the rate of `{name}` is stated twice";
    STATED_HERE = "first stated here";
    STATED_TWICE_HELP = "add both in one equation, or remove one";
    NO_RATE_LEFT = "this equation contains no rate of a state that still needs one";
    NO_RATE_LEFT_HELP =
        "each state has one equation; to name an expression write `let name = e;`, to evaluate one `output name = e;`";
    nonlinear(rates) = "this equation is not linear in {rates}";
    NONLINEAR_HELP = "solve it for the rate: `solve rate: 0 = …;`, then `dot(a) = rate;`";
    singular(rates) = "these equations do not determine {rates}: their determinant is zero";
    SINGULAR_HELP = "replace one of them: it follows from the others, or contradicts them";
    too_coupled(count, limit) = "{count} rates are coupled by equations, more than {limit}";
    TOO_COUPLED_HELP = "solve some of them for their rates by hand, `dot(a) = …;`";
    undetermined_by_one(rates) = "1 equation does not determine {rates}";
    undetermined(count, rates) = "{count} equations do not determine {rates}";
    UNDETERMINED_HELP = "write one equation for each rate, such as `dot(a) = …;`";
    frozen_coupled(name) = "the state `{name}` cannot be frozen: equations couple its rate with others";
    FROZEN_COUPLED_HELP = "declare the system without this state in a separate `lagrange::system!`";
    declare(name) = "`dot(…) = e;` is the equation of a state: declare it with `state {name};`";
    rate_of_coordinate(name) =
        "`{name}` is a coordinate: its velocity is part of the state and has no equation";
    RATE_OF_COORDINATE_HELP =
        "for an initial velocity write `start dot(x) = e;`, for a condition on velocities `constraint name = e;`; accelerations follow from energies and forces";
    no_state(kind, name) = "the {kind} `{name}` is not a state";
    without_equation(name) = "the state `{name}` has no equation";
    equation_of(name) = "write `dot({name}) = e;`, with its rate after the equals sign";
    rate_too_early(name) = "the rate of the state `{name}` is used before its equation";
    rate_too_early_help(name) = "move `dot({name}) = e;` before this; a rate cannot depend on itself";
    second_rate(name) = "the rate of the state `{name}` depends on an input, whose rate is unknown";
    SECOND_RATE_HELP = "remove the second rate, or make the input a `state` with its own equation";
    PLACE_HELP =
        "virtual work and constraints displace coordinates, not states: make this one a `coord`, or write its effect as a `force`";
    ignored(name) = "the state `{name}` cannot be ignored";
    IGNORED_HELP = "a state has no momentum; only coordinates can be ignored";
    SMALL_HELP = "a state can be frozen at a value, but its equation cannot be expanded";
    small(name) = "the state `{name}` cannot be small";
    assigned_rate(name) = "the rate of the state `{name}` follows from its equation";
    assigned_rate_help(name) = "give the state itself a value, `{name} = e;`";
    CONSTRAINT = "a constraint";
    discrete_rate(name) = "the discrete state `{name}` has no rate: only events change it";
    discrete_rate_help(name) =
        "declare `state {name};` for a rate, or assign to it in an event, `=> {{ {name} = e; }}`";
    other_number(name) = "another mode lists the value `{name}` at a different position";
    FIRST_NUMBER = "here it has another place in the list";
    OTHER_NUMBER_HELP = "modes share a value if it has the same place in both lists; write another name here";
    never_assigned(name) = "nothing changes the discrete state `{name}`";
    never_assigned_help(name) =
        "assign to it at an event or a clock, `=> {{ {name} = e; }}`, or declare `param {name};`";
}
