//! Test systems for methods, and common checks.

pub(in crate::integrate) mod canonical;
pub(in crate::integrate) mod constrained;
