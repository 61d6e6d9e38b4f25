//! Events: zeros of functions of time and state, found while a system is integrated.
//!
//! A [`Watch`] looks at several functions within each step, on the state that the method itself gives there, and returns
//! their zeros one by one in the order of time. What happens then is up to the loop: go on, stop, or restart the method
//! from another state, as after an impact. [`integrate_with_events`] is such a loop without heap; the front door
//! `simulate` has another.
//!
//! A function that is exactly zero at the start fires only once it has left zero and crossed it again; one that touches
//! zero without changing its sign never does. Zeros are seen if the function has different signs at two of the nine
//! places, evenly spread over a step, at which it is looked at; one that is exactly zero at the end of a run is not known to
//! cross it. Events at the same time follow each other in the order in which they were given.

mod declared;
mod direction;
mod locate;
mod run;
mod watch;

pub use self::declared::{Answer, DeclaredEvent, MOST_DECLARED};
pub use self::direction::Direction;
pub use self::run::{Reaction, integrate_with_events};
pub(crate) use self::watch::is_at_once;
pub use self::watch::{Occurrence, Watch};

#[cfg(test)]
mod tests;
