//! Long motions, whose many steps take optimised code.
//!
//! `cargo motions` runs them. Without optimisation this file is only linted.
#![cfg(any(not(debug_assertions), clippy))]

mod adaptive;
#[path = "../mechanisms/bricard.rs"]
mod bricard;
mod canonical;
mod comet;
mod constrained_series;
mod damped;
mod damped_runs;
mod drift;
mod elliptic;
mod ends;
mod extinction;
mod extremes;
#[path = "../mechanisms/four_bar.rs"]
mod four_bar;
mod free_bodies;
#[path = "../mechanisms/governor.rs"]
mod governor;
mod held;
mod mechanisms;
#[path = "../mechanisms/n_four_bar.rs"]
mod n_four_bar;
mod phase;
mod projected;
mod quaternions;
#[path = "../references/mod.rs"]
mod references;
mod series_of_functions;
mod slider_crank;
mod spatial;
#[path = "../mechanisms/spatial_slider_crank.rs"]
mod spatial_slider_crank;
mod stiff;
mod stiff_series;
mod systems;
mod taylor;
mod throws;
mod tops;
