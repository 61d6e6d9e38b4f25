//! Small dense linear algebra. Arrays of fixed size need no heap allocation. Linear models and
//! fits, whose size is known at run time, use vectors.

#[cfg(any(feature = "linear", feature = "fit"))]
pub(crate) mod dense;
#[cfg(feature = "linear")]
pub(crate) mod eigenvalues;
#[cfg(feature = "fit")]
pub(crate) mod independent;
pub(crate) mod ordered;
pub(crate) mod orthogonal;
pub(crate) mod pivoted;
pub(crate) mod ranked;
pub(crate) mod singular;
#[cfg(any(feature = "linear", feature = "fit"))]
pub(crate) mod singular_values;
pub(crate) mod space;
pub(crate) mod vector;
