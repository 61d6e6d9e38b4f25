//! Bodies in space against independent answers: other people's algorithms for models of robots,
//! Newton–Euler equations in the world with many digits for random trees, and closed-form motions.

mod additions;
mod cases;
mod closed_forms;
mod comparison;
mod drawing;
mod models;
mod motion;
mod operations;
mod orientations;
mod parameters;
mod regressors;
mod trees;
