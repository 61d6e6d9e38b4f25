//! Events: zeros of functions of time and state, found while a system is integrated.
//!
//! A [`Detector`] evaluates several functions within each step, on the states that the method
//! itself gives there. It returns their zeros one by one in the order of time. The loop decides how
//! to respond: continue, stop, or restart the method from another state, as after an impact.
//! [`integrate_with_events`] is such a loop without heap; `simulate` has another. Both, and
//! [`integrate()`](crate::integrate::integrate), always look for the declared events of a system,
//! together with the given ones. They keep the system that contacts and friction switch.
//!
//! A function that is exactly zero at the start fires only once it has left zero and crossed it
//! again. One that touches zero without changing its sign never fires. One that is exactly zero at
//! the end of a run, where it would pass it, fires there.
//!
//! Within a step, functions are resolved by polynomials through nine values, in pieces as short as
//! necessary. All zeros of a smooth function are found, however close to each other. Those of a
//! fast function are found if they are farther apart than 1/4096 of a step. A dip between two of
//! the nine values is not seen if the function is smooth elsewhere; shorter steps see it. Jumps and
//! kinks at zero, up to 64 a step, are found in the same way. A smooth function without zeros costs
//! eight evaluations a step.
//!
//! An event may replace the state and leave its function at zero. The function then counts as being
//! on the side from which it came, unless it continues through zero at once. A ball that is turned
//! round therefore cannot fall through the ground, however low it bounces. Infinitely many events
//! are an error.
//!
//! Functions of contacts and friction differ: they are positive while a mode lasts. A body that
//! touches at the start and goes down therefore hits the ground at once. Simultaneous events follow
//! each other in the order in which they were given, declared ones first.

#[doc(inline)]
pub use lagrange_runtime::event::{
    Action, DeclaredEvent, Detector, Direction, MOST_DECLARED, Occurrence, Response, SwitchedSystem,
    Switches, beyond, change_side, choose_sides, earlier, free_sides, next_switch_time, next_tick,
    shortest_period, side_values, ticks,
};
#[doc(inline)]
pub use lagrange_runtime::run::integrate_with_events;
