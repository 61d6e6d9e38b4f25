//! Mechanisms in space: a loop with one constraint too many, a slider-crank in two declarations, a
//! stiff governor.

use lagrange::constraint::project;
use lagrange::integrate::{Method, PlainGaussLegendre, RungeKutta4, StepFailure, Verner98, integrate};
use lagrange::system::split;

use crate::bricard::Bricard;
use crate::governor::Governor;
use crate::mechanisms::{assert_near, run};
use crate::references::{Numbers, state};
use crate::spatial_slider_crank::{BallSliderCrank, SpatialSliderCrank};

/// Returns `N` numbers from an index on.
fn part<const N: usize>(numbers: &[f64], from: usize) -> [f64; N] {
    std::array::from_fn(|i| numbers[from + i])
}

#[test]
fn bricards_mechanism_swings_although_its_constraints_depend_on_each_other() {
    let mechanism = Bricard::default();
    for end in [1.0, 9.5, 10.0] {
        let expected = state::<16>("bricard", Numbers::Binary, end);
        let (y, seen) = run(&mechanism, [0.0; 10], end, &Verner98::tolerance(1e-12));
        let (q, v) = split::<Bricard>(&y);
        assert_near(&q, &part(&expected, 0), 1e-12);
        assert_near(&v, &part(&expected, 8), 1e-11);
        assert_near(&mechanism.p3(end, &q, &v), &part(&expected, 5), 1e-12);
        seen.assert(1e-14, 1e-14, 1e-12);
        assert!(seen.steps < 200, "{seen:?}");
        assert!(mechanism.multipliers(end, &q, &v).iter().all(|force| force.is_finite()));
    }
}

#[test]
fn bricards_mechanism_stays_closed_in_steps_of_equal_length() {
    let mechanism = Bricard::default();
    let expected = state::<16>("bricard", Numbers::Binary, 10.0);
    let (y, seen) = run(&mechanism, [0.0; 10], 10.0, &RungeKutta4 { step: 1e-3 });
    assert_near(&part(&y, 0), &part::<5>(&expected, 0), 1e-7);
    seen.assert(1e-14, 1e-13, 1e-11);
    let (_, seen) = run(&mechanism, [0.0; 10], 10.0, &PlainGaussLegendre::<f64, 3> { step: 5e-3 });
    seen.assert(1e-14, 1e-13, 1e-9);
}

/// Off the curve of closed loops all constraints are independent. On it every second angle is the
/// same.
#[test]
fn bricards_mechanism_is_closed_from_a_place_where_it_is_open() {
    let mechanism = Bricard::default();
    let expected = part::<5>(&state::<16>("bricard", Numbers::Binary, 1.0), 0);
    for size in [1e-9, 1e-6, 1e-4, 1e-2] {
        let mut q = expected;
        q.iter_mut().zip([1.0, -0.5, 0.3, 0.8, -0.9]).for_each(|(angle, by)| *angle += size * by);
        project(&mechanism, 0.0, &mut q, &mut [0.0; 5]).expect("a closed loop is near");
        assert_near(&q, &expected, size);
        assert_near(&q, &[q[0], q[1], q[0], q[1], q[0]], 1e-13);
    }
}

/// Returns the same state with the orientation of the rod in the axes of the crank: `a` about x,
/// then `b` about y.
fn with_ball([crank, x, a, b, rate, x_rate, a_rate, b_rate]: [f64; 8]) -> [f64; 11] {
    assert_eq!(crank, 0.0);
    let ((sa, ca), (sb, cb)) = ((a / 2.0).sin_cos(), (b / 2.0).sin_cos());
    let (sine, cosine) = b.sin_cos();
    let turning = a_rate - rate;
    let [qw, qx, qy, qz] = [ca * cb, sa * cb, ca * sb, sa * sb];
    let [wx, wy, wz] = [turning * cosine, b_rate, turning * sine];
    [crank, x, qw, qx, qy, qz, rate, x_rate, wx, wy, wz]
}

#[test]
fn a_slider_crank_in_space_is_where_its_loop_closes() {
    let start = state::<8>("spatial_slider_crank", Numbers::Binary, 0.0);
    let method = Verner98::tolerance(1e-13);
    for (end, tolerance) in [(1.0, 1e-12), (20.0, 1e-9)] {
        let expected = state::<8>("spatial_slider_crank", Numbers::Binary, end);
        let (y, seen) = run(&SpatialSliderCrank::default(), start, end, &method);
        assert_near(&y, &expected, tolerance);
        seen.assert(1e-14, 1e-13, 1e-12);
        let (y, seen) = run(&BallSliderCrank::default(), with_ball(start), end, &method);
        assert_near(&[y[0], y[1], y[6], y[7]], &[0, 1, 4, 5].map(|i| expected[i]), tolerance);
        seen.assert(1e-14, 1e-13, 1e-12);
    }
}

/// Returns the end of a motion, and the number of steps.
fn end_of(governor: &Governor, end: f64, method: &impl Method<Governor>) -> ([f64; 8], usize) {
    let start = state::<8>("governor", Numbers::Binary, 0.0);
    let mut steps = 0;
    let last = integrate(governor, 0.0, start, end, method, |_, _| steps += 1);
    let last = last.unwrap_or_else(|error| panic!("{}: {error}", method.name()));
    (last, steps)
}

#[test]
fn a_stiff_governor_follows_two_equations_for_two_freedoms() {
    let governor = Governor::default();
    let momentum = |y: &[f64; 8]| governor.momentum(0.0, &part(y, 0), &part(y, 4));
    let kept = momentum(&state::<8>("governor", Numbers::Binary, 0.0));
    for end in [0.1, 1.0, 10.0] {
        let expected = state::<8>("governor", Numbers::Binary, end);
        let (explicit, steps) = end_of(&governor, end, &Verner98::tolerance(1e-13));
        assert_near(&explicit, &expected, 1e-13);
        let (implicit, fewer) = end_of(&governor, end, &PlainGaussLegendre::<f64, 3> { step: 2e-3 });
        assert_near(&implicit, &expected, 1e-10);
        assert!(10 * fewer < steps, "{fewer} implicit and {steps} explicit steps");
        for last in [explicit, implicit] {
            assert!((momentum(&last) / kept - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn a_stiff_governor_is_refused_where_accuracy_allows_steps_that_are_not_stable() {
    let governor = Governor::default();
    let start = state::<8>("governor", Numbers::Binary, 0.0);
    let failed =
        integrate(&governor, 0.0, start, 10.0, &Verner98::tolerance(1e-8), |_, _| {}).expect_err("stiff");
    let StepFailure::Stiff { limit, .. } = failed.cause else { panic!("{failed}") };
    assert!((3.5e-4..4.5e-4).contains(&limit), "{limit}");
}
