//! Free bodies and ball joints, whose orientations are unit quaternions, against closed forms.
//!
//! Sources: Landau, Lifshitz, *Mechanics*, §§ 9, 35 and 36; Featherstone, *Rigid Body Dynamics
//! Algorithms*, § 4.5.

use std::array::from_fn;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::motion::{assert_constant, assert_near};

/// Relative error allowed for an acceleration.
const TOLERANCE: f64 = 1e-13;
/// Factor on a moment of inertia in a control, whose effect must be noticed.
const CONTROL: f64 = 1.0 + 1e-6;

/// Unit quaternions: the identity, a quarter turn about −y, a half turn about z, and two more.
const QUATERNIONS: [[f64; 4]; 5] = [
    [1.0, 0.0, 0.0, 0.0],
    [std::f64::consts::FRAC_1_SQRT_2, 0.0, -std::f64::consts::FRAC_1_SQRT_2, 0.0],
    [0.0, 0.0, 0.0, 1.0],
    [0.5, -0.5, 0.5, 0.5],
    [-0.1, 0.5, -0.7, 0.5],
];
const SPINS: [[f64; 3]; 5] =
    [[1.2, 0.4, -0.9], [0.0, 0.0, 0.0], [0.0, -2.0, 3.0], [-0.6, 0.0, 0.1], [0.75, 0.5, -0.25]];

fn system(text: &str) -> NumericSystem {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{text}\n{report}")))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

/// Returns a vector of rotated axes in the world: v + 2 w u × v + 2 u × (u × v).
fn turned([w, u @ ..]: [f64; 4], vector: [f64; 3]) -> [f64; 3] {
    let once = cross(u, vector);
    let twice = cross(u, once);
    from_fn(|k| vector[k] + 2.0 * (w * once[k] + twice[k]))
}

/// Returns ω̇ from J₁ ω̇₁ = (J₂ − J₃) ω₂ ω₃ and so on.
fn euler(inertia: [f64; 3], w: [f64; 3]) -> [f64; 3] {
    from_fn(|k| {
        let (next, last) = ((k + 1) % 3, (k + 2) % 3);
        (inertia[next] - inertia[last]) / inertia[k] * w[next] * w[last]
    })
}

#[test]
fn quaternions_change_at_half_their_product_with_the_angular_velocity() {
    let system = system("gravity = (0, 0, 0); body top { mass: 2; inertia: (0.3, 0.5, 0.7); } free top;");
    for (q, spin) in QUATERNIONS.into_iter().zip(SPINS) {
        let [w, u @ ..] = q;
        let state = [&[0.3, -0.2, 0.1], &q[..], &[0.7, 0.0, -1.1], &spin].concat();
        let scalar = -0.5 * u.iter().zip(spin).map(|(u, spin)| u * spin).sum::<f64>();
        let product = cross(u, spin);
        let [x, y, z] = from_fn(|k| 0.5 * (w * spin[k] + product[k]));
        assert_near(&system.rhs(0.0, &state)[..7], &[0.7, 0.0, -1.1, scalar, x, y, z], TOLERANCE, "rates");
    }
}

#[test]
fn a_free_top_on_a_ball_turns_as_euler_says() {
    let on_ball = |third: f64| {
        system(&format!(
            "body top {{ mass: 2; inertia: (0.3, 0.5, {third}); }} ball tip = ground to top {{ at: (0.1, 0, 2); turned: (1, -0.4, pi/2); }}
            output momentum = angular_momentum(top, (0.1, 0, 2));"
        ))
    };
    let (exact, other) = (on_ball(0.7), on_ball(0.7 * CONTROL));
    for (q, w) in QUATERNIONS.into_iter().zip(SPINS) {
        let known = euler([0.3, 0.5, 0.7], w);
        assert_near(&exact.acceleration(0.0, &q, &w), &known, TOLERANCE, "accelerations");
        let momentum = |q: &[f64], v: &[f64]| exact.output("momentum", 0.0, q, v).expect("declared");
        assert_constant(&exact, [&q, &w], momentum, "angular momentum");
    }
    let [q, w] = [&QUATERNIONS[4][..], &SPINS[0][..]];
    let (known, found) = (exact.acceleration(0.0, q, w), other.acceleration(0.0, q, w));
    assert!(known.iter().zip(found).all(|(known, found)| (known - found).abs() > 1e-8));
}

/// Under gravity the centre of mass falls, and the origin turns about it.
#[test]
fn a_thrown_body_falls_and_turns_as_euler_says() {
    let center = [0.2, -0.1, 0.4];
    let system = system(
        "gravity = (0, 0, -9.81);
        body stick { mass: 2; inertia: (0.3, 0.5, 0.7); centroid: (0.2, -0.1, 0.4); } free stick;",
    );
    for (q, w) in QUATERNIONS.into_iter().zip(SPINS) {
        let change = euler([0.3, 0.5, 0.7], w);
        let (tangential, radial) = (cross(change, center), cross(w, cross(w, center)));
        let arm = turned(q, from_fn(|k| tangential[k] + radial[k]));
        let known = [&[-arm[0], -arm[1], -9.81 - arm[2]], &change[..]].concat();
        let place = [&[0.3, -0.2, 0.1], &q[..]].concat();
        let velocities = [&[0.7, 0.0, -1.1], &w[..]].concat();
        assert_near(&system.acceleration(0.0, &place, &velocities), &known, TOLERANCE, "accelerations");
    }
}

/// A symmetrical top with the spin ω₃ about its axis precesses steadily at the angle θ where
/// `A cos θ ψ̇² − C ω₃ ψ̇ + m g l = 0`. In the axes of the body, the vertical then turns by −φ̇
/// about the axis.
#[test]
fn a_gyroscope_on_a_ball_precesses_steadily_at_both_of_its_rates() {
    let (mass, length, across, along) = (1.25, 0.4, 0.05, 0.02);
    let gyroscope = |along: f64| {
        system(&format!(
            "gravity = (0, 0, -9.81);
            body wheel {{ mass: {mass}; inertia: ({across}, {across}, {along}); centroid: (0, 0, {length}); }} ball tip = ground to wheel;"
        ))
    };
    let (exact, other) = (gyroscope(along), gyroscope(along * CONTROL));
    let about_tip = across + mass * length * length;
    for (theta, spin) in [(0.4_f64, 150.0), (1.2, 75.0), (2.0, 40.0), (2.75, -90.0)] {
        let (a, b, c) = (about_tip * theta.cos(), -along * spin, mass * 9.81 * length);
        let larger = -0.5 * (b + b.signum() * (b * b - 4.0 * a * c).sqrt());
        for rate in [larger / a, c / larger] {
            let (own, phi) = (spin - rate * theta.cos(), -0.2_f64);
            let across = rate * theta.sin();
            // ψ = 0: a rotation by θ about x, then one by φ about z.
            let ((s, c), (sin, cos)) = ((0.5 * theta).sin_cos(), (0.5 * phi).sin_cos());
            let q = [c * cos, s * cos, -s * sin, c * sin];
            let w = [across * phi.sin(), across * phi.cos(), spin];
            let known = [own * across * phi.cos(), -own * across * phi.sin(), 0.0];
            let size = rate.abs() * spin.abs().max(rate.abs());
            let error = |system: &NumericSystem| {
                let found = system.acceleration(0.0, &q, &w);
                found.iter().zip(known).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / size
            };
            assert!(error(&exact) < TOLERANCE, "{theta}, {spin}, {rate}: {:e}", error(&exact));
            assert!(error(&other) > 1e-8, "{theta}, {spin}, {rate}: {:e}", error(&other));
        }
    }
}

/// Without gravity all forces act between bodies.
#[test]
fn forces_between_free_bodies_conserve_momentum_and_angular_momentum() {
    let system = system(
        "gravity = (0, 0, 0);
        body hull { mass: 3; centroid: (0.1, -0.2, 0.05); inertia: (0.5, 0.6, 0.4, 0.02, -0.05, 0.1); }
        body arm { mass: 1.5; centroid: (0.3, 0, 0.1); inertia: (0.1, 0.2, 0.15, 0.01, 0.02, -0.03); }
        body moon { mass: 0.5; inertia: (0.1, 0.2, 0.15); }
        free hull; free moon;
        ball shoulder = hull to arm { at: (0.4, 0.1, -0.3); turned: (0.3, -0.4, 0.5); damping: 0.3; }
        spring { from: hull.point(0.1, 0.9, 0); to: arm.point(0.5, 0, 0.5); stiffness: 12; rest: 0.3; }
        damper { from: moon.point(-0.2, 0, 0.4); to: arm.point(0, 1, 0); damping: 3; }
        spring { from: moon; to: hull; stiffness: 2; }
        output p = linear_momentum(hull) + linear_momentum(arm) + linear_momentum(moon);
        output l = angular_momentum(hull) + angular_momentum(arm) + angular_momentum(moon);",
    );
    for index in 0..QUATERNIONS.len() {
        let [first, second, third] = from_fn(|k| (index + 2 * k) % QUATERNIONS.len());
        let place = |q: usize, at: [f64; 3]| [&at[..], &QUATERNIONS[q]].concat();
        let q =
            [place(first, [0.1, -0.3, 0.8]), place(second, [1.0, 2.0, -0.5]), QUATERNIONS[third].to_vec()]
                .concat();
        let v =
            [&[0.5, -0.7, 0.9], &SPINS[second][..], &[-1.1, 0.3, 0.2], &SPINS[third], &SPINS[first]].concat();
        for name in ["p", "l"] {
            let output = |q: &[f64], v: &[f64]| system.output(name, 0.0, q, v).expect("declared");
            assert_constant(&system, [&q, &v], output, name);
        }
    }
}
