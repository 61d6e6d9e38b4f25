//! Runs: a method's steps from a start to an end, and the events within them.
//!
//! [`Run`] is the only loop. [`integrate()`] and [`integrate_with_events`] drive it without heap
//! and keep nothing; `simulate` keeps the requested data. It is driven turn by turn, so that
//! callers can act between turns.

mod current;
mod declared;
mod drive;
mod events;
mod integrate;
mod margins;
mod outcome;
mod pending;
mod restarts;
pub(crate) mod room;
mod steps;
#[cfg(test)]
mod tests;
mod with_events;

pub use self::current::{Current, check_direction};
pub use self::declared::DeclaredEvents;
pub use self::drive::RunEnd;
pub use self::events::{AllEvents, Events, Found, Next, NoEvents, Origin, Replacement};
pub use self::integrate::{arrive, integrate};
pub use self::pending::Pending;
pub use self::restarts::Restarts;
pub use self::steps::{Run, Sink, Turn};
pub use self::with_events::integrate_with_events;
