//! Events: zeros of functions of time and state, found while a system is integrated.
//!
//! A [`Detector`] evaluates several functions within each step, on the dense output of the method.
//! It returns their zeros one by one in the order of time. The loop decides how to respond:
//! continue, stop, or restart the method from another state, as after an impact.
//! [`integrate_with_events`] is such a loop without heap allocation; `simulate` has another. Both,
//! and [`integrate()`](crate::integrate::integrate), always detect the declared events of a system
//! in addition to the given ones. They own the copy of the system whose contact and friction modes
//! change.
//!
//! A function that is exactly zero at the start fires only after it has left zero and crosses it
//! again. A function that touches zero without a change of sign never fires. A function that is
//! exactly zero at the end of a run, where it would cross zero, fires there.
//!
//! Within a step, functions are interpolated by polynomials through nine values, on subintervals as
//! short as necessary. All zeros of a smooth function are found, however close to each other. Zeros
//! of a rapidly varying function are found if they are farther apart than 1/4096 of a step. A
//! narrow dip between two of the nine values is missed if the function is smooth elsewhere; shorter
//! steps detect it. Jumps and kinks at zero, up to 64 per step, are found in the same way. A smooth
//! function without zeros costs eight evaluations per step.
//!
//! An event may replace the state and leave its function at zero. The function is then treated as
//! being on the side from which it came, unless it immediately continues through zero. A ball whose
//! velocity is reversed therefore cannot fall through the ground, however low it bounces.
//! Infinitely many events are an error.
//!
//! Functions of contacts and friction differ: they are positive while a mode lasts. A body that
//! touches the ground at the start and moves down therefore has an impact immediately. Simultaneous
//! events are processed in the order in which they were given, declared ones first.

#[doc(inline)]
pub use lagrange_runtime::event::{
    Action, DeclaredEvent, Detector, Direction, MAX_LOCATED, Occurrence, Response, SwitchedSystem, Switches,
    beyond, change_side, choose_sides, earlier, free_sides, next_switch_time, next_tick, shortest_period,
    side_values, ticks,
};
#[doc(inline)]
pub use lagrange_runtime::run::integrate_with_events;
