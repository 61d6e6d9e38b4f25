//! Elimination of accelerations and multipliers from a quadratic form.

pub(super) mod contracted;
pub(super) mod order;
pub(super) mod pivot;
mod queue;
pub(super) mod record;
pub(super) mod solution;
