//! Unit quaternions with the scalar part first, as the tests use them.

use core::array::from_fn;

pub(crate) type Quaternion = [f64; 4];

/// Returns a rotation about a unit axis.
pub(crate) fn turn(axis: [f64; 3], angle: f64) -> Quaternion {
    let (sin, cos) = (0.5 * angle).sin_cos();
    [cos, sin * axis[0], sin * axis[1], sin * axis[2]]
}

/// Returns Hamilton's product: the second rotation, then the first.
pub(crate) fn product(a: Quaternion, b: Quaternion) -> Quaternion {
    let ([s, u @ ..], [t, v @ ..]) = (a, b);
    let w = cross(u, v);
    let [x, y, z] = from_fn(|k| s * v[k] + t * u[k] + w[k]);
    [s * t - dot(u, v), x, y, z]
}

/// Returns a vector of rotated axes in the world.
pub(crate) fn turned(q: Quaternion, vector: [f64; 3]) -> [f64; 3] {
    let [s, u @ ..] = q;
    let once = cross(u, vector);
    let twice = cross(u, once);
    from_fn(|k| vector[k] + 2.0 * (s * once[k] + twice[k]))
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

/// Returns the largest difference of components, up to a common sign.
pub(crate) fn distance(a: Quaternion, b: Quaternion) -> f64 {
    let largest = |sign: f64| a.iter().zip(b).fold(0.0_f64, |most, (x, y)| most.max((x - sign * y).abs()));
    largest(1.0).min(largest(-1.0))
}
