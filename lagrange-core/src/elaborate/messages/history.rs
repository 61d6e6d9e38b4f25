//! Diagnostics for histories of entries of the state.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    HISTORY = "a history";
    HISTORY_HELP =
        "write `history x = cos(t);` with a coordinate or a state `x`, and a formula of numbers, parameters and t";
    no_history(target) = "`{target}` has no history of its own";
    NO_HISTORY_HELP =
        "give the history of coordinates and states: velocities follow as their rates, and orientations keep their start";
    two_histories(target) = "`{target}` has two histories";
    HISTORY_HERE = "the other one is here";
    TWO_HISTORIES_HELP = "remove one of them";
    NO_DELAYS = "nothing looks back at this history";
    NO_DELAYS_HELP = "delay a signal, as in `delay(x, 0.1)`, or remove the history";
}
