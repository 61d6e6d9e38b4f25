//! Taylor series of motions under constraints: unknown multipliers at every order.

use lagrange::integrate::{Taylor, Verner98, integrate};
use lagrange::system::{TaylorSystem, split};

use crate::held::{Skate, Wire};

lagrange::system! {
    /// A point mass on a rod, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    struct Bob<S>;

    param m = 1, l = 1;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = 9.81 * m * y;
    constraint rod = x^2 + y^2 - l^2;
    emit { taylor }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -9.81 * cos(theta);
    emit { taylor }
}

lagrange::system! {
    /// Two bodies connected by a rod, one on a crank and one in a slide, with damping and a
    /// first-order state.
    #[derive(Clone, Debug)]
    struct SliderCrank;

    param m = 0.7, k = 3, c = 0.2;
    coord crank, x, rod;
    state lag;
    kinetic = 1/2 * dot(crank)^2 + 1/2 * m * dot(x)^2 + 1/12 * dot(rod)^2;
    potential = 1/2 * k * (x - 2)^2;
    dissipation = 1/2 * c * dot(x)^2;
    force crank = 1 + lag;
    dot(lag) = sin(t) - lag;
    constraint along = cos(crank) + 2 * cos(rod) - x;
    constraint across = sin(crank) - 2 * sin(rod);
    emit { taylor }
}

lagrange::system! {
    /// A bob whose constraint is stabilised as well as projected.
    #[derive(Clone, Debug)]
    struct Damped;

    stabilise = 5;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 9.81 * y;
    constraint rod = hypot(x, y) - 1;
    emit { taylor }
}

fn error(found: &[f64], wanted: &[f64]) -> f64 {
    found.iter().zip(wanted).fold(0.0, |largest, (found, wanted)| (found - wanted).abs().max(largest))
}

fn end<M: TaylorSystem<Scalar = f64>>(system: &M, start: M::State, t: f64, tolerance: f64) -> M::State {
    integrate(system, 0.0, start, t, &Taylor::tolerance(tolerance), |_, _| {}).expect("reaches the end")
}

/// With masses and lengths far from one, rows of the equations have different scales.
#[test]
fn a_bob_moves_as_the_pendulum_of_its_angle() {
    for (tolerance, bound) in [(1e-6, 1e-5), (1e-9, 1e-8), (1e-14, 1e-12)] {
        let [theta, omega] = end(&Pendulum, [2.0, 1.0], 10.0, 1e-15);
        let wanted = [theta.sin(), -theta.cos(), omega * theta.cos(), omega * theta.sin()];
        for m in [1.0, 1e-9, 1e9] {
            let (sin, cos) = 2.0_f64.sin_cos();
            let found = end(&Bob { m, l: 1.0 }, [sin, -cos, cos, sin], 10.0, tolerance);
            let error = error(&found, &wanted);
            assert!(error < bound, "{m:e} at {tolerance:e}: {error:e}");
        }
    }
}

#[test]
fn a_bob_in_single_precision_stays_on_its_rod() {
    let bob = Bob::<f32>::default();
    let method = Taylor::tolerance(1e-5);
    let mut residual = 0.0_f32;
    integrate(&bob, 0.0, [0.6, -0.8, 0.8, 0.6], 20.0, &method, |t, y| {
        let (q, v) = split::<Bob<f32>>(y);
        residual = residual.max(bob.constraints(t, &q, &v)[0].abs());
    })
    .expect("reaches the end");
    assert!(residual < 1e-6, "{residual:e}");
}

/// Rates of positions and velocities agree with the equations of motion, at rest and in motion.
#[test]
fn coefficients_begin_with_the_accelerations() {
    for speed in [0.0, 1.3] {
        let y = [0.0, 3.0, 0.0, 0.1, speed, 0.0, 0.5 * speed];
        let rates = lagrange::system::OdeSystem::rhs(&SliderCrank::default(), 0.4, &y);
        let (mut series, mut coefficients) = (SliderCrank::series(), [[0.0; 7]; 2]);
        SliderCrank::default().expand::<false>(0.4, &y, &mut series, &mut coefficients);
        assert!(error(&coefficients[0], &rates) < 1e-13, "{:?} {rates:?}", coefficients[0]);
    }
}

#[test]
fn a_mechanism_with_a_loop_agrees_with_the_other_adaptive_method() {
    let system = SliderCrank::default();
    // Crank and rod aligned, where the slide reverses.
    let start = [0.0, 3.0, 0.0, 0.1, 1.0, 0.0, 0.5];
    for span in [8.0, -3.0] {
        let wanted = integrate(&system, 0.0, start, span, &Verner98::tolerance(1e-14), |_, _| {}).unwrap();
        let found = end(&system, start, span, 1e-14);
        let error = error(&found, &wanted);
        assert!(error < 1e-11, "to {span}: {error:e}");
    }
}

#[test]
fn stabilised_constraints_have_series() {
    let (sin, cos) = 2.0_f64.sin_cos();
    let found = end(&Damped, [sin, -cos, cos, sin], 10.0, 1e-14);
    let [theta, omega] = end(&Pendulum, [2.0, 1.0], 10.0, 1e-15);
    let wanted = [theta.sin(), -theta.cos(), omega * theta.cos(), omega * theta.sin()];
    let error = error(&found, &wanted);
    assert!(error < 1e-12, "{error:e}");
}

#[test]
fn a_skate_on_a_slope_follows_a_cycloid() {
    let (skate, turn, span) = (Skate::default(), 2.0, 10.0);
    let [x, y, ..] = end(&skate, [0.0, 0.0, 0.0, 0.0, 0.0, turn], span, 1e-14);
    let (radius, angle) = (skate.fall / (2.0 * turn * turn), turn * span);
    let wanted = [radius * angle.sin().powi(2), radius * (angle - 0.5 * (2.0 * angle).sin())];
    let error = error(&[x, y], &wanted);
    assert!(error < 1e-12, "{error:e}");
}

#[test]
fn a_bead_on_a_turning_wire_oscillates() {
    let wire = Wire::default();
    let (frequency, span) = ((wire.k - wire.rate * wire.rate).sqrt(), 20.0);
    let [x, y, ..] = end(&wire, [0.5, 0.0, 0.0, 0.5 * wire.rate], span, 1e-14);
    let (distance, angle) = (0.5 * (frequency * span).cos(), wire.rate * span);
    let error = error(&[x, y], &[distance * angle.cos(), distance * angle.sin()]);
    assert!(error < 1e-12, "{error:e}");
}

lagrange::system! {
    /// A bob on two rods that coincide for some lengths.
    #[derive(Clone, Debug)]
    struct Doubled;

    param l = 1;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 9.81 * y;
    constraint rod = x^2 + y^2 - 1;
    constraint wire = x^2 + l * y^2 - l;
    emit { taylor }
}

#[test]
fn constraints_that_depend_on_each_other_give_no_numbers() {
    let start = [0.6, -0.8, 0.8, 0.6];
    let result = integrate(&Doubled { l: 1.0 }, 0.0, start, 1.0, &Taylor::tolerance(1e-9), |_, _| {});
    let failed = result.expect_err("forces are not determined");
    assert_eq!(failed.state, start);
    let message = failed.to_string();
    assert!(message.contains("no Taylor series") && message.contains("`Verner98`"), "{message}");
}
