//! Systems that methods are tested on, and what they are tested for.

pub(in crate::integrate) mod canonical;
pub(in crate::integrate) mod constrained;
