//! Derivatives of motions by parameters agree with differences and closed forms.

mod closed_forms;
mod differences;
mod gradient;
mod jumps;
mod refusals;
