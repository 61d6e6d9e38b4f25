//! Derivatives of motions by parameters agree with differences and closed forms.

#[macro_use]
mod beside;

mod closed_forms;
mod contacts;
mod differences;
mod gradient;
mod jumps;
mod projections;
mod refusals;
mod steps;
