//! Bodies whose orientations are unit quaternions, with angular velocities in the axes of the body.
//! The quaternion is (1, 0, 0, 0) if body and world have the same axes.
//!
//! Quaternions have the scalar first. q turns components along the axes of the body into those in
//! the world: x ↦ q ⊗ (0, x) ⊗ q̄.

mod free;
mod held;
mod landing;

type Quaternion = [f64; 4];
type Vector = [f64; 3];

/// The velocity of an orientation, by name.
const ANGULAR_VELOCITY: &[&str] = &["w_x", "w_y", "w_z"];

fn product([a, b, c, d]: Quaternion, [e, f, g, h]: Quaternion) -> Quaternion {
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

fn conjugate([a, b, c, d]: Quaternion) -> Quaternion {
    [a, -b, -c, -d]
}

fn pure([x, y, z]: Vector) -> Quaternion {
    [0.0, x, y, z]
}

/// Converts components along the body axes into components in the world.
fn turned(q: Quaternion, x: Vector) -> Vector {
    let [_, x, y, z] = product(product(q, pure(x)), conjugate(q));
    [x, y, z]
}

/// Returns ½ q ⊗ (0, ω).
fn rates(q: Quaternion, w: Vector) -> Quaternion {
    product(q, pure(w)).map(|entry| entry / 2.0)
}

/// Returns 2 Im(q̄ ⊗ p), with the sign of the shorter rotation.
fn rotation(q: Quaternion, p: Quaternion) -> Vector {
    let [real, x, y, z] = product(conjugate(q), p);
    [x, y, z].map(|entry| 2.0 * entry * real.signum())
}

/// Returns the rotation by `angle` about a unit vector.
fn turn(angle: f64, axis: Vector) -> Quaternion {
    let (sine, cosine) = (angle / 2.0).sin_cos();
    let [x, y, z] = axis.map(|entry| sine * entry);
    [cosine, x, y, z]
}

fn length(q: &[f64]) -> f64 {
    q.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}

fn to_unit(q: &mut [f64]) {
    let length = length(q);
    q.iter_mut().for_each(|entry| *entry /= length);
}

fn cross([a, b, c]: Vector, [d, e, f]: Vector) -> Vector {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a * b).sum()
}

fn times<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i] * b[i])
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}
