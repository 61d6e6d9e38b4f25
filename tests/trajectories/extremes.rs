//! Motions whose masses differ by a factor of 10³⁰, and motions that take picoseconds or millennia.

use core::f64::consts::TAU;

use lagrange::integrate::{Method, Radau5, RungeKutta4, Taylor, Verner98, integrate};
use lagrange::scalar::Scalar;

use crate::elliptic::Elliptic;

lagrange::system! {
    /// Two bodies that attract each other.
    #[derive(Clone, Debug)]
    struct TwoBodies<S>;

    param m1 = 1.0, m2 = 1.0, g = 1.0;
    coord x1, y1, x2, y2;
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = -g * m1 * m2 / hypot(x2 - x1, y2 - y1);
    emit { taylor, jacobian }
}

lagrange::system! {
    /// A light pendulum on a heavy one.
    #[derive(Clone, Debug)]
    struct DoublePendulum<S>;

    param m1 = 1.0, m2 = 1.0, g = 1.0;
    coord theta1, theta2;
    let (x1, y1) = (sin(theta1), -cos(theta1));
    let (x2, y2) = (x1 + sin(theta2), y1 - cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = g * (m1 * y1 + m2 * y2);
    emit { taylor, jacobian }
}

lagrange::system! {
    /// A pendulum.
    #[derive(Clone, Debug)]
    struct Pendulum<S>;

    param g = 1.0;
    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -g * cos(theta);
    emit { taylor, jacobian }
}

/// The ratios of masses.
const RATIOS: [f64; 6] = [1e30, 1e15, 1e3, 1e-3, 1e-15, 1e-30];
/// The eccentricity of an orbit of semi-axis 1 whose period is 2π, and its start and fastest speed.
const ORBIT: [f64; 2] = [0.4, 2.0];

/// Asserts that two bodies return to their places after a period, each to this part of the size of
/// its own orbit.
#[track_caller]
fn assert_closes<S: Scalar>(ratio: f64, method: &impl Method<TwoBodies<S>>, tolerated: f64) {
    let whole = 1.0 + ratio;
    let numbers = [ratio, 1.0, 1.0 / whole].map(S::from_f64);
    let bodies = TwoBodies { m1: numbers[0], m2: numbers[1], g: numbers[2] };
    let sizes = [1.0 / whole, ratio / whole];
    let [distance, speed] = ORBIT;
    let start =
        [-distance * sizes[0], 0.0, distance * sizes[1], 0.0, 0.0, -speed * sizes[0], 0.0, speed * sizes[1]];
    let end = integrate(&bodies, S::ZERO, start.map(S::from_f64), S::from_f64(TAU), method, |_, _| {});
    for (entry, (found, wanted)) in end.expect("goes on").into_iter().zip(start).enumerate() {
        let error = (found - S::from_f64(wanted)).abs() / S::from_f64(sizes[entry % 4 / 2]);
        assert!(error < S::from_f64(tolerated), "{ratio:e}, entry {entry}: {error:?} by {}", method.name());
    }
}

#[test]
fn the_lighter_body_orbits_at_any_ratio_of_masses() {
    for ratio in RATIOS {
        assert_closes::<f64>(ratio, &Verner98::tolerance(1e-11), 1e-8);
        assert_closes::<f64>(ratio, &Taylor::tolerance(1e-11), 1e-8);
        assert_closes::<f64>(ratio, &Radau5::tolerance(1e-9), 1e-5);
        assert_closes::<f64>(ratio, &RungeKutta4 { step: 1e-3 }, 1e-6);
        assert_closes::<f32>(ratio, &Verner98::tolerance(1e-6), 3e-3);
        assert_closes::<f32>(ratio, &Taylor::tolerance(1e-6), 3e-3);
    }
}

/// Returns the angle of a pendulum released at rest, in periods of 2π for small ones.
fn swing(amplitude: f64, t: f64) -> f64 {
    let (sine, cosine) = (0.5 * amplitude).sin_cos();
    let [_, cn, dn] = Elliptic::new(sine * sine, cosine * cosine).functions(t);
    2.0 * (sine * cn / dn).asin()
}

/// The upper pendulum moves as if it were alone, up to the ratio of masses.
#[test]
fn a_light_pendulum_does_not_disturb_a_heavy_one() {
    let start = [1.2, -0.4, 0.0, 0.0];
    for ratio in [1e30, 1e22, 1e15] {
        for (m1, m2) in [(1.0, 1.0 / ratio), (ratio, 1.0)] {
            let pendulum = DoublePendulum { m1, m2, g: 1.0 };
            let wanted = swing(1.2, 10.0);
            let ends = [
                integrate(&pendulum, 0.0, start, 10.0, &Verner98::tolerance(1e-13), |_, _| {}),
                integrate(&pendulum, 0.0, start, 10.0, &Taylor::tolerance(1e-13), |_, _| {}),
            ];
            let ends = ends.map(|end| end.expect("goes on"));
            for [theta1, ..] in ends {
                assert!((theta1 - wanted).abs() < 1e-11, "{ratio:e}: {theta1} {wanted}");
            }
            assert!((ends[0][1] - ends[1][1]).abs() < 1e-10, "{ratio:e}: {ends:?}");
        }
    }
}

/// Asserts that a pendulum swings in time `unit` as it does in a second.
#[track_caller]
fn assert_swings<S: Scalar>(unit: f64, method: &impl Method<Pendulum<S>>, tolerated: f64) {
    let pendulum = Pendulum { g: S::from_f64(1.0 / (unit * unit)) };
    for swings in [1.0, 20.0, -7.0] {
        let end = S::from_f64(swings * unit);
        let found = integrate(&pendulum, S::ZERO, [S::from_f64(2.0), S::ZERO], end, method, |_, _| {});
        let error = (found.expect("goes on")[0] - S::from_f64(swing(2.0, swings))).abs();
        assert!(error < S::from_f64(tolerated), "{unit:e} {swings}: {error:?} by {}", method.name());
    }
}

#[test]
fn motions_may_take_picoseconds_or_millennia() {
    for unit in [1e-12, 1e-6, 1.0, 1e6, 1e12] {
        assert_swings::<f64>(unit, &Verner98::tolerance(1e-11), 1e-8);
        assert_swings::<f64>(unit, &Taylor::tolerance(1e-11), 1e-8);
        assert_swings::<f64>(unit, &Radau5::tolerance(1e-9), 1e-6);
        assert_swings::<f64>(unit, &RungeKutta4 { step: 1e-3 * unit }, 1e-9);
    }
    // Squares of accelerations of 10²⁴ would be infinite, and rates of 10⁻⁶ are within the
    // tolerance.
    for unit in [1e-6, 1e-3, 1e3] {
        assert_swings::<f32>(unit, &Verner98::tolerance(1e-6), 2e-3);
        assert_swings::<f32>(unit, &Taylor::tolerance(1e-6), 2e-3);
    }
}
