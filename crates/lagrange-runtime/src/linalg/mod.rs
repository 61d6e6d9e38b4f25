//! Small dense linear algebra in arrays of fixed size, without heap.

pub(crate) mod orthogonal;
pub(crate) mod pivoted;
pub(crate) mod ranked;
pub(crate) mod singular;
pub(crate) mod vector;
