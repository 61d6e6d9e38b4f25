//! Common basis of features: the shape of the emitted type, methods and their arguments,
//! documentation, size limits.

pub(super) mod attributes;
pub(super) mod bindings;
pub(in crate::emit) mod callees;
pub(super) mod docs;
pub(super) mod exclusion;
pub(super) mod fields;
pub(in crate::emit) mod fingerprint;
pub(super) mod lanes_shape;
pub(super) mod lints;
pub(super) mod members;
pub(super) mod messages;
pub(super) mod method;
pub(super) mod refusal;
mod results;
pub(super) mod shape;
pub(super) mod sides;
pub(super) mod size;
pub(super) mod state;
pub(super) mod state_shape;
pub(super) mod statements;
pub(super) mod units;
pub(super) mod writer;
