//! Long motions, whose many steps only optimised code takes in reasonable time.
//!
//! `cargo test --release --test trajectories` runs them; without optimisation there is nothing here.
#![cfg(not(debug_assertions))]

mod adaptive;
mod canonical;
mod comet;
mod drift;
mod ends;
mod held;
mod phase;
mod projected;
#[path = "../references/mod.rs"]
mod references;
mod stiff;
mod systems;
