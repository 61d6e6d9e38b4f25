//! Diagnostics for delayed signals.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    SIGNAL = "a delayed signal";
    SIGNAL_HELP =
        "delay a function of time, coordinates, velocities, states and inputs: accelerations and forces follow from delayed signals";
    LAG = "a delay";
    NOT_POSITIVE_HELP = "write the delay in seconds, such as `delay(x, 0.1)`";
    not_positive(number) = "a delay must be positive, but this is {number}";
    PLACE = "nothing is delayed here";
    PLACE_HELP =
        "`delay(e, tau)` is part of forces, rates, events, outputs, and names that `let` gives for them";
    RATE_HELP = "delay the rate instead, as in `delay(dot(x), tau)`";
    LINEAR_MODEL = "a linear model has no delays";
    DELAYED_HERE = "this signal is delayed";
    LINEAR_MODEL_HELP = "remove `system_matrix`, or replace each delayed signal with an `input`";
    REDUCTION = "systems with delays are not reduced";
    REDUCTION_HELP = "declare the reduced system in a separate `lagrange::system!`";
}
