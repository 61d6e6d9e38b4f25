//! Taylor series on motions with known answers.

use std::f64::consts::TAU;

use lagrange::Simulate;
use lagrange::integrate::{Method, StepFailure, Stepper, Taylor, Verner98, integrate};
use lagrange::scalar::Portable;
use lagrange::system::{OdeSystem, TaylorSystem};

use super::references::{Numbers, state};

lagrange::system! {
    #[derive(Clone, Debug)]
    struct DoublePendulum;

    param m1 = 1, m2 = 1, l1 = 1, l2 = 1, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    emit { taylor }
}

lagrange::system! {
    /// A planet around a fixed sun, in polar coordinates.
    #[derive(Clone, Debug)]
    struct Kepler;

    coord r, phi;
    kinetic = 1/2 * (dot(r)^2 + (r * dot(phi))^2);
    potential = -1 / r;
    emit { taylor }
}

lagrange::system! {
    /// Every element of a formula: time, an input, damping, a state, roots, quotients and functions
    /// of velocities.
    #[derive(Clone, Debug)]
    struct Mixture<S>;

    param k = 3.0, c = 0.2, tau = 0.5;
    input push = 0.3;
    coord x, y;
    state z;
    kinetic = 1/2 * (2 + sin(x)) * dot(x)^2 + 1/2 * dot(y)^2 * (1 + x^2)^(1/2) + 1/4 * dot(x) * dot(y);
    potential = 1/2 * k * (x^2 + y^2)^(3/2) + exp(-x) + 1 / (2 + cos(y * t));
    dissipation = 1/2 * c * dot(x)^2;
    force y = push - tanh(dot(y) / 2) + z;
    dot(z) = (dot(x) - z) / tau;
    emit { taylor }
}

lagrange::system! {
    /// A heavy body with a fixed point.
    #[derive(Clone, Debug)]
    struct Top;

    param a = 1.0, c = 0.5, h = 0.7;
    quaternion r;
    kinetic = 1/2 * a * (r_wx^2 + r_wy^2) + 1/2 * c * r_wz^2;
    potential = h * (1 - 2 * (r_qx^2 + r_qy^2));
    emit { taylor }
}

lagrange::system! {
    /// A sun with five planets, whose products fill many groups.
    #[derive(Clone, Debug)]
    struct Planets<S>;

    const n = 6;
    param m[n] = [1, 1e-3, 3e-4, 4e-5, 5e-5, 7e-9];
    coord x[n], y[n], z[n];
    kinetic = sum(i in 0..n, 1/2 * m[i] * (dot(x[i])^2 + dot(y[i])^2 + dot(z[i])^2));
    potential = -sum(i in 0..n, sum(j in 0..i,
        m[i] * m[j] / sqrt((x[i] - x[j])^2 + (y[i] - y[j])^2 + (z[i] - z[j])^2)));
    emit { taylor }
}

lagrange::system! {
    /// Two rods that do not know of each other, and a coordinate alone.
    #[derive(Clone, Debug)]
    struct Rods;

    param m = 1.0, g = 9.81;
    coord x[2], y[2], s;
    kinetic = 1/2 * m * sum(i in 0..2, dot(x[i])^2 + dot(y[i])^2) + 1/2 * (1 + s^2) * dot(s)^2;
    potential = m * g * (y[0] + y[1]) + s^2;
    constraint first = x[0]^2 + y[0]^2 - 1;
    constraint second = x[1]^2 + y[1]^2 - 1;
    emit { taylor }
}

fn end<M: OdeSystem<Scalar = f64>>(system: &M, start: M::State, t: f64, method: &impl Method<M>) -> M::State {
    integrate(system, 0.0, start, t, method, |_, _| {}).expect("reaches the end")
}

fn error(found: &[f64], wanted: &[f64]) -> f64 {
    found.iter().zip(wanted).fold(0.0, |largest, (found, wanted)| (found - wanted).abs().max(largest))
}

fn of_order<S: lagrange::Scalar>(order: usize, tolerance: S) -> Taylor<S> {
    Taylor { order: Some(order), ..Taylor::tolerance(tolerance) }
}

#[test]
fn the_double_pendulum_is_right_to_rounding() {
    let start = state::<4>("double_pendulum", Numbers::Binary, 0.0);
    let wanted = state::<4>("double_pendulum", Numbers::Binary, 10.0);
    for (tolerance, bound) in [(1e-6, 1e-5), (1e-10, 1e-9), (1e-15, 2e-13)] {
        let found = end(&DoublePendulum::default(), start, 10.0, &Taylor::tolerance(tolerance));
        let error = error(&found, &wanted);
        assert!(error < bound, "{tolerance:e}: {error:e}");
    }
}

#[test]
fn a_hundred_orbits_lose_as_much_as_rounding_makes_of_the_period() {
    let start = state::<4>("kepler", Numbers::Binary, 0.0);
    let found = end(&Kepler, start, 100.0, &Taylor::tolerance(1e-15));
    let error = error(&found, &state::<4>("kepler", Numbers::Binary, 100.0));
    assert!(error < 2e-12, "{error:e}");
}

/// 320 starts, at most of which coefficients vanish in turn. Rules that use two coefficients take
/// far too long steps there.
#[test]
fn symmetric_starts_keep_their_tolerance_at_every_order() {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    let system = DoublePendulum::default();
    let angles = [0.0, FRAC_PI_2, -FRAC_PI_2, PI / 3.0, PI, PI - 1e-3, 1e-9, FRAC_PI_4];
    let speeds = [[0.0, 0.0], [1.0, 1.0], [1.0, -1.0], [0.0, 2.0], [-3.0, 0.0]];
    for [first, second] in angles.iter().flat_map(|first| angles.map(|second| [*first, second])) {
        for [one, other] in speeds {
            let start = [first, second, one, other];
            let wanted = end(&system, start, 1.0, &Verner98::tolerance(1e-14));
            for order in 4..=40 {
                let found = end(&system, start, 1.0, &of_order(order, 1e-9));
                let error = error(&found, &wanted);
                assert!(error < 1e-8, "{start:?} at order {order}: {error:e}");
            }
        }
    }
}

#[test]
fn all_parts_of_formulas_have_series() {
    let system = Mixture::<f64>::default();
    let start = [0.4, -0.3, 0.1, 0.2, 0.5];
    for span in [4.0, -2.0] {
        let wanted = end(&system, start, span, &Verner98::tolerance(1e-14));
        let found = end(&system, start, span, &Taylor::tolerance(1e-14));
        let error = error(&found, &wanted);
        assert!(error < 2e-12, "to {span}: {error:e}");
    }
}

#[test]
fn numbers_of_single_precision_have_series() {
    let system = Mixture::<f32>::default();
    let start = [0.4, -0.3, 0.1, 0.2, 0.5];
    let found = integrate(&system, 0.0, start, 3.0, &Taylor::tolerance(1e-6), |_, _| {}).unwrap();
    let wanted = end(&Mixture::<f64>::default(), start.map(f64::from), 3.0, &Verner98::tolerance(1e-12));
    let error = error(&found.map(f64::from), &wanted);
    assert!(error < 2e-5, "{error:e}");
}

/// Returns circular orbits in slightly inclined planes, around a sun at rest.
fn orbits() -> [f64; 36] {
    let mut state = [0.0; 36];
    for (body, radius) in [1.0_f64, 1.8, 3.5, 5.7, 7.5].into_iter().enumerate() {
        let (sine, cosine) = (2.0 * body as f64).sin_cos();
        let speed = radius.sqrt().recip();
        let entries = [radius * cosine, radius * sine, 0.1 * radius, -speed * sine, speed * cosine, 0.02];
        for (axis, entry) in entries.into_iter().enumerate() {
            state[6 * axis + body + 1] = entry;
        }
    }
    state
}

#[test]
fn many_bodies_attract_each_other() {
    let (system, start) = (Planets::<f64>::default(), orbits());
    let wanted = end(&system, start, 6.0, &Verner98::tolerance(1e-14));
    for (tolerance, bound) in [(1e-4, 1e-3), (1e-9, 1e-8), (1e-14, 2e-13)] {
        for fused in [false, true] {
            let method = Taylor { fused, ..Taylor::tolerance(tolerance) };
            let error = error(&end(&system, start, 6.0, &method), &wanted);
            assert!(error < bound, "{tolerance:e}, fused {fused}: {error:e}");
        }
    }
    let system = Planets::<f32>::default();
    let start = start.map(|entry| entry as f32);
    let found = integrate(&system, 0.0, start, 6.0, &Taylor::tolerance(1e-6), |_, _| {}).unwrap();
    let error = error(&found.map(f64::from), &wanted);
    assert!(error < 1e-4, "in single precision: {error:e}");
}

#[test]
fn equations_that_are_not_coupled_have_series() {
    let start = [0.6, 0.0, -0.8, 1.0, 0.3, 0.0, 0.5, 0.0, 0.0, 0.4];
    let wanted = end(&Rods::default(), start, 3.0, &Verner98::tolerance(1e-14));
    let error = error(&end(&Rods::default(), start, 3.0, &Taylor::tolerance(1e-14)), &wanted);
    assert!(error < 1e-12, "{error:e}");
}

#[test]
fn orientations_have_series() {
    let start = [0.8, 0.6, 0.0, 0.0, 0.3, -0.2, 4.0];
    let wanted = end(&Top::default(), start, 5.0, &Verner98::tolerance(1e-14));
    let found = end(&Top::default(), start, 5.0, &Taylor::tolerance(1e-14));
    let error = error(&found, &wanted);
    assert!(error < 1e-12, "{error:e}");
}

/// Takes steps, and compares states within each with those of a run that ends there.
#[test]
fn states_within_steps_are_as_accurate_as_their_ends() {
    let system = DoublePendulum::default();
    let start = [2.0, 1.5, 0.0, 0.0];
    let method = Taylor::tolerance(1e-12);
    let mut stepper = method.start(&system, 0.0, &start, 2.0).unwrap();
    while stepper.time() < 2.0 {
        stepper.step(&system, 2.0).unwrap();
        let (from, to) = (stepper.last_time(), stepper.time());
        assert_eq!(stepper.interpolate(&system, to), *stepper.state());
        for part in [0.1, 0.5, 0.9] {
            let t = from + part * (to - from);
            let wanted = end(&system, start, t, &Verner98::tolerance(1e-14));
            let error = error(&stepper.interpolate(&system, t), &wanted);
            assert!(error < 1e-11, "at {t}: {error:e}");
        }
    }
}

#[test]
fn coefficients_begin_with_the_rate() {
    let (system, y) = (Mixture::<f64>::default(), [0.4, -0.3, 0.1, 0.2, 0.5]);
    let (mut series, mut coefficients) = (Mixture::<f64>::series(), [[0.0; 5]; 3]);
    system.expand::<false>(0.25, &y, &mut series, &mut coefficients);
    assert!(error(&coefficients[0], &system.rhs(0.25, &y)) < 1e-14);
}

#[test]
fn fused_products_change_rounding_alone() {
    let (start, until) = ([2.0, 1.5, 0.0, 0.0], 3.0);
    for order in [4, 9, 24, 40] {
        let fused = of_order(order, 1e-10);
        let [fused, apart] = [fused, Taylor { fused: false, ..fused }]
            .map(|method| end(&DoublePendulum::default(), start, until, &method));
        assert!(error(&fused, &apart) < 1e-11, "order {order}: {fused:?} {apart:?}");
    }
}

#[test]
fn portable_numbers_fuse_nothing() {
    let start = [0.4, -0.3, 0.1, 0.2, 0.5].map(Portable);
    let expand = |fused| {
        let method = Taylor { fused, ..of_order(24, Portable(1e-10)) };
        let mut stepper =
            method.start(&Mixture::default(), Portable(0.0), &start, Portable(1.0)).expect("starts");
        stepper.step(&Mixture::default(), Portable(1.0)).expect("goes on");
        stepper.state().map(|entry: Portable<f64>| entry.0.to_bits())
    };
    assert_eq!(expand(true), expand(false));
}

#[test]
fn settings_without_sense_are_refused() {
    let refused = |method: Taylor<f64>| {
        let started = method.start(&Kepler, 0.0, &[1.0, 0.0, 0.0, 1.0], 1.0);
        assert!(matches!(started, Err(StepFailure::Setting(_))), "{method:?}");
    };
    refused(of_order(3, 1e-9));
    refused(of_order(41, 1e-9));
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused(Taylor::tolerance(tolerance));
    }
    refused(Taylor { longest_step: Some(0.0), ..Taylor::tolerance(1e-9) });
}

/// Steps have the same length on the way to a far end as to a near one.
#[test]
fn steps_do_not_depend_on_the_end() {
    let (system, start, method) = (DoublePendulum::default(), [2.0, 1.5, 0.0, 0.0], Taylor::tolerance(1e-9));
    let [near, far] = [10.0, 1e10].map(|end| {
        let mut stepper = method.start(&system, 0.0, &start, end).unwrap();
        for _ in 0..50 {
            stepper.step(&system, end).unwrap();
        }
        stepper.time()
    });
    assert!(near < 9.0);
    assert_eq!(near, far);
}

/// A planet without angular momentum falls into the sun; the run ends before the collision with a
/// finite state.
#[test]
fn a_collision_ends_the_run_with_its_last_good_state() {
    let result = integrate(&Kepler, 0.0, [1.0, 0.0, 0.0, 0.0], 2.0, &Taylor::tolerance(1e-9), |_, _| {});
    let failed = result.expect_err("nothing leads through the sun");
    // The fall takes π/(2 √2).
    assert!((failed.time - 1.110_720_734_539_591_6).abs() < 1e-6, "{}", failed.time);
    assert!(failed.state.iter().all(|component| component.is_finite()));
}

lagrange::system! {
    /// A planet around a fixed sun, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    struct Planet;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = -1 / hypot(x, y);
    emit { taylor }
}

/// Without bias, rounding makes the energy walk at random, and 800,000 steps change it by some
/// 900 rounding errors. A bias of a hundredth of a rounding error would add 8000.
#[test]
fn the_energy_of_an_orbit_walks_without_bias() {
    let start = [0.8, 0.0, 0.0, 1.5_f64.sqrt()];
    let energy = |[x, y, u, v]: &[f64; 4]| Planet.energy(0.0, &[*x, *y], &[*u, *v]);
    let mut steps = 0;
    let end = integrate(&Planet, 0.0, start, 80_000.0 * TAU, &Taylor::tolerance(1e-16), |_, _| steps += 1)
        .expect("reaches the end");
    let roundings = (energy(&end) / energy(&start) - 1.0).abs() / (0.5 * f64::EPSILON);
    assert!(steps > 800_000 && roundings < 4000.0, "{roundings} roundings after {steps} steps");
}

lagrange::system! {
    /// A pendulum reflected by a stop, with events on the way.
    #[derive(Clone, Debug)]
    struct Stopped;

    param k = 40.0;
    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -9.81 * cos(theta);
    force theta = if theta > 0.3 { -k * (theta - 0.3) } else { 0 } - 0.1 * abs(dot(theta)) * dot(theta);
    event lowest = theta, crossing => record;
    event turning = dot(theta), falling => record;
    emit { taylor }
}

#[test]
fn events_and_switches_are_met_as_by_other_methods() {
    let run = |tolerance: f64, is_series: bool| {
        let system = Stopped::default();
        let simulation = system.simulate([-1.2, 0.0]).until(12.0).tolerance(tolerance);
        let run =
            if is_series { simulation.method(Taylor::tolerance(tolerance)).run() } else { simulation.run() };
        let run = run.expect("reaches the end");
        run.events().iter().map(|event| (event.name.to_string(), event.time)).collect::<Vec<_>>()
    };
    let (found, wanted) = (run(1e-12, true), run(1e-13, false));
    assert!(wanted.len() > 20, "{}", wanted.len());
    assert_eq!(found.len(), wanted.len());
    for ((name, time), (of, wanted)) in found.iter().zip(&wanted) {
        assert_eq!(name, of);
        assert!((time - wanted).abs() < 1e-9, "{name} at {time} for {wanted}");
    }
}

lagrange::system! {
    /// A mass at rest, pushed for a short time. Its series contain no trace of the later push.
    #[derive(Clone, Debug)]
    struct Pushed;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = exp(-400 * (t - 5)^2);
    emit { taylor }
}

#[test]
fn a_push_after_a_rest_is_not_stepped_over() {
    let [_, speed] = end(&Pushed, [0.0, 0.0], 10.0, &Taylor::tolerance(1e-9));
    let impulse = (std::f64::consts::PI / 400.0).sqrt();
    assert!((speed - impulse).abs() < 1e-8, "{speed} for {impulse}");
}
