//! Explicit methods and a pendulum on a stiff spring.

use lagrange::integrate::{BlanesMoan4, Method, RungeKutta4, StepFailure, Stepper, StormerVerlet, integrate};
use lagrange::system::MechanicalSystem;

use crate::systems::Planet;

lagrange::system! {
    /// A point mass on a very stiff spring, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    struct ElasticPendulum;

    param m = 1.0, l = 1.0, k = 1e9, g = 9.81;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y + spring_energy(k, hypot(x, y) - l);
}

/// Returns the state after a second, or the longest stable step.
fn swing<K: Method<ElasticPendulum>>(method: &K) -> Result<[f64; 4], f64> {
    let outcome = integrate(&ElasticPendulum::default(), 0.0, [0.6, -0.8, 0.0, 0.0], 1.0, method, |_, y| {
        assert!((y[0].hypot(y[1]) - 1.0).abs() < 0.1, "an unstable state was shown: {y:?}");
    });
    outcome.map_err(|error| match error.cause {
        StepFailure::StepTooLong { limit, .. } => limit,
        cause => panic!("{cause}"),
    })
}

/// Asserts that long steps are refused, and that the suggested step succeeds.
#[track_caller]
fn assert_refuses<K: Method<ElasticPendulum>>(method: fn(f64) -> K, stable: f64) {
    let limit = swing(&method(1e-3)).expect_err("the step is thirty times too long");
    assert!((limit * 1e9_f64.sqrt() / stable - 1.0).abs() < 0.02, "{limit}");
    let [x, y, ..] = swing(&method(0.9 * limit)).expect("a stable step");
    assert!((x.hypot(y) - 1.0).abs() < 1e-6);
}

#[test]
fn stiff_springs_are_refused_with_the_step_that_would_do() {
    assert_refuses(|step| StormerVerlet { step }, 2.0);
    assert_refuses(|step| BlanesMoan4 { step }, 3.16);
    assert_refuses(|step| RungeKutta4 { step }, 2.785);
}

lagrange::system! {
    /// Two point masses on massless rods.
    #[derive(Clone, Debug)]
    struct DoublePendulum;

    param g = 9.81;
    coord a, b;
    let (xa, ya) = (sin(a), -cos(a));
    let (xb, yb) = (xa + sin(b), ya - cos(b));
    kinetic = 1/2 * (dot(xa)^2 + dot(ya)^2 + dot(xb)^2 + dot(yb)^2);
    potential = g * (ya + yb);
}

/// Counts evaluations beyond those of the formula, over a thousand seconds.
fn looks<M, K>(system: &M, start: M::State, method: &K, each: u64) -> u64
where
    M: MechanicalSystem<Scalar = f64>,
    K: Method<M>,
{
    let mut stepper = method.start(system, 0.0, &start, 1000.0).expect("valid");
    while stepper.time() < 1000.0 {
        stepper.step(system, 1000.0).expect("no motion for which stability limits the step");
    }
    let work = stepper.work();
    println!("{}: {} evaluations in {} steps", method.name(), work.evaluations, work.steps);
    work.evaluations - each * work.steps
}

#[test]
fn ordinary_motions_are_neither_refused_nor_slowed() {
    let (chaos, comet) = ([2.0, 1.5, 0.0, 0.0], [1.9, 0.0, 0.0, (0.1_f64 / 1.9).sqrt()]);
    for step in [1e-3, 1e-2, 5e-2] {
        let total = [
            looks(&DoublePendulum::default(), chaos, &RungeKutta4 { step }, 4),
            looks(&Planet::default(), comet, &RungeKutta4 { step }, 4),
            looks(&Planet::default(), comet, &StormerVerlet { step }, 1),
            looks(&Planet::default(), comet, &BlanesMoan4 { step }, 6),
        ];
        assert!(total.iter().all(|evaluations| *evaluations < 20), "{total:?}");
    }
}
