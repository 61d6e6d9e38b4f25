//! Bodies in space against independent answers. Models of robots are compared with other people's
//! algorithms, random trees with Newton–Euler equations in many digits, and some motions with
//! closed forms.

mod additions;
mod cases;
mod closed_forms;
mod comparison;
mod drawing;
mod matrices;
mod models;
mod motion;
mod operations;
mod orientations;
mod parameters;
mod regressors;
mod trees;
