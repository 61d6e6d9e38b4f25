//! Equilibria, linear models and modes, against closed forms and other tools.
#![cfg(feature = "linear")]

mod constrained;
mod equilibria;
mod mode_motion;
mod models;
mod modes;
mod orbits;
mod refusals;
mod regulators;
mod responses;
