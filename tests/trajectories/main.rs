//! Long motions, whose many steps only optimised code takes in reasonable time.
//!
//! `cargo test --release --test trajectories` runs them; without optimisation there is nothing here.
#![cfg(not(debug_assertions))]

mod canonical;
mod comet;
mod drift;
mod phase;
mod stiff;
mod systems;
