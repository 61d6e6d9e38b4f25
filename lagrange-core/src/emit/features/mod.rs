//! Features of emitted systems, one a file.

pub(super) mod constants;
pub(super) mod constrained;
pub(super) mod contacts;
pub(super) mod events;
pub(super) mod frames;
pub(super) mod indefinite;
mod items;
pub(super) mod jacobian;
pub(super) mod kernel;
pub(super) mod lanes;
pub(super) mod linearised;
pub(in crate::emit) mod missing;
pub(super) mod orientations;
pub(super) mod ports;
pub(super) mod prepared;
pub(super) mod product;
pub(super) mod ranges;
pub(super) mod reduced;
pub(super) mod redundant;
pub(super) mod scene;
pub(super) mod solvers;
pub(super) mod sparse;
pub(super) mod start;
pub(super) mod switches;
pub(in crate::emit) mod tables;
pub(super) mod taylor;
pub(in crate::emit) mod units;
