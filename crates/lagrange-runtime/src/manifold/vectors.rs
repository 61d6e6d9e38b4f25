//! Vectors in space.

use crate::scalar::Scalar;

pub(super) type Vector<S> = [S; 3];

pub(super) fn inner<S: Scalar>(a: &Vector<S>, b: &Vector<S>) -> S {
    a[0].multiply_add(b[0], a[1].multiply_add(b[1], a[2] * b[2]))
}

pub(super) fn cross<S: Scalar>(a: &Vector<S>, b: &Vector<S>) -> Vector<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn minus<S: Scalar>(a: &Vector<S>, b: &Vector<S>) -> Vector<S> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + length · b
pub(super) fn along<S: Scalar>(a: &Vector<S>, length: S, b: &Vector<S>) -> Vector<S> {
    [0, 1, 2].map(|i| length.multiply_add(b[i], a[i]))
}

pub(super) fn scaled<S: Scalar>(factor: S, a: &Vector<S>) -> Vector<S> {
    a.map(|component| factor * component)
}

pub(super) fn norm<S: Scalar>(a: &Vector<S>) -> S {
    inner(a, a).sqrt()
}

/// A number moved into [−limit, limit].
pub(super) fn clamped<S: Scalar>(value: S, limit: S) -> S {
    if value > limit {
        limit
    } else if value < -limit {
        -limit
    } else {
        value
    }
}
