//! Zeros of functions of time and state, found while a system is integrated.
//!
//! A [`Detector`] evaluates several functions within each step, on states interpolated by the
//! method itself. It returns their zeros one by one in order of time. Switches are zeros at which a
//! system is not smooth.

mod candidate;
mod clocks;
mod detector;
mod function;
mod instant;
mod locate;
mod piece;
mod polynomial;
mod rounding;
mod search;
mod switches;

pub use self::clocks::{earlier, next_tick, shortest_period, ticks};
pub use self::detector::{Detector, Occurrence};
pub(crate) use self::instant::{end_of_instant, is_at_once};
pub(crate) use self::locate::locate;
pub(crate) use self::rounding::rounded;
pub use self::switches::{
    SwitchedSystem, Switches, beyond, change_side, choose_sides, free_sides, next_switch_time, side_values,
};
pub use crate::system::{Action, DeclaredEvent, Direction, MAX_LOCATED, Response};

#[cfg(test)]
mod tests;
