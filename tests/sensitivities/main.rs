//! Are derivatives of motions by parameters those of differences and closed forms?

mod closed_forms;
mod differences;
mod gradient;
mod jumps;
mod refusals;
