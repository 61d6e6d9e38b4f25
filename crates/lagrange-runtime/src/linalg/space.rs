//! Vectors in space, beside the operations on those of every length in [`vector`](super::vector).

use super::vector::dot;
use crate::scalar::Scalar;

/// Three components of a vector in space.
pub(crate) type Triple<S> = [S; 3];

/// Computes a × b.
#[inline]
pub(crate) fn cross<S: Scalar>(a: &Triple<S>, b: &Triple<S>) -> Triple<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Computes factor · a.
#[inline]
pub(crate) fn multiple<S: Scalar>(factor: S, a: &Triple<S>) -> Triple<S> {
    a.map(|component| factor * component)
}

/// Computes |a|.
#[inline]
pub(crate) fn norm<S: Scalar>(a: &Triple<S>) -> S {
    dot(a, a).sqrt()
}
