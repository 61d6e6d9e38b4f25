//! Events: zeros of functions of time and state, found while a system is integrated.
//!
//! A [`Detector`] looks at several functions within each step, on the state that the method itself
//! gives there, and returns their zeros one by one in the order of time. What happens then is up to
//! the loop: go on, stop, or restart the method from another state, as after an impact.
//! [`integrate_with_events`] is such a loop without heap; the front door `simulate` has another.
//! Both, and [`integrate()`](crate::integrate::integrate), look for the events that the declaration
//! of a system states without being asked, together with those that are given, and keep the system
//! that contacts and friction switch.
//!
//! A function that is exactly zero at the start fires only once it has left zero and crossed it
//! again; one that touches zero without changing its sign never does. One that is exactly zero at
//! the end of a run, where it would pass it, fires there.
//!
//! Within a step functions are resolved by polynomials through nine values, in pieces as short as
//! it takes, so that all zeros of a smooth function are found, however close to each other, and
//! those of one that changes fast as long as they are farther apart than 1/4096 of a step. A dip
//! between two of the nine values is not seen if the function is smooth elsewhere; shorter steps
//! see it. Jumps and kinks at zero, up to 64 a step, are found alike. A smooth function without
//! zeros costs eight evaluations a step.
//!
//! Where an event replaces the state and leaves its function at zero, the function counts as being
//! on the side from which it came, unless it goes on through zero at once: so a ball that is turned
//! round cannot fall through the ground, however low it bounces. Infinitely many events are an
//! error.
//!
//! Functions of contacts and friction are another matter: they are positive while a mode lasts, so
//! that a body that touches at the start and goes down hits the ground at once. Events at the same
//! time follow each other in the order in which they were given, declared ones first.

#[doc(inline)]
pub use lagrange_runtime::event::{
    Action, DeclaredEvent, Detector, Direction, MOST_DECLARED, Occurrence, Response, SwitchedSystem,
    Switches, beyond, change_side, choose_sides, free_sides, next_switch_time, side_values,
};
#[doc(inline)]
pub use lagrange_runtime::run::integrate_with_events;
