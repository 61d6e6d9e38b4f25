//! Stiff motions by Taylor series, which name the method to take instead.

use lagrange::Simulate;
use lagrange::integrate::{IntegrationError, Method, StepFailure, Stepper, Taylor, integrate};
use lagrange::system::{OdeSystem, TaylorSystem};

lagrange::system! {
    /// A point mass on a spring with a damper.
    #[derive(Clone, Debug)]
    struct ElasticPendulum<S>;

    param k = 1e8, c = 2e4, g = 9.81;
    coord r, theta;
    kinetic = 1/2 * (dot(r)^2 + r^2 * dot(theta)^2);
    potential = 1/2 * k * (r - 1)^2 - g * r * cos(theta);
    dissipation = 1/2 * c * dot(r)^2;
    emit { taylor }
}

lagrange::system! {
    /// Two point masses on massless rods, the second with a drag of its own.
    #[derive(Clone, Debug)]
    struct DoublePendulum;

    param g = 9.81, drag = 0.0;
    coord a, b;
    let (xa, ya) = (sin(a), -cos(a));
    let (xb, yb) = (xa + sin(b), ya - cos(b));
    kinetic = 1/2 * (dot(xa)^2 + dot(ya)^2 + dot(xb)^2 + dot(yb)^2);
    potential = g * (ya + yb);
    force b = -drag * dot(b);
    emit { taylor }
}

lagrange::system! {
    /// A planet around a fixed sun.
    #[derive(Clone, Debug)]
    struct Kepler;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = -1 / hypot(x, y);
    emit { taylor }
}

const START: [f64; 4] = [1.0, 1.0, 0.0, 0.0];

/// Returns the longest stable step that a refusal names, and its time.
#[track_caller]
fn refused<M: OdeSystem>(
    outcome: Result<M::State, IntegrationError<M::Scalar, M::State>>,
) -> (M::Scalar, M::Scalar) {
    let error = outcome.expect_err("stiff");
    match error.cause {
        StepFailure::Stiff { limit, .. } => (limit, error.time),
        cause => panic!("{cause}"),
    }
}

/// Both eigenvalues of the spring are −10⁴. The polynomial of the order p is at most one up to
/// |h λ| ≈ ᵖ√p!. At tighter tolerances, the rounding errors of the force of 10⁸ N/m shorten steps.
#[test]
fn stiffness_is_reported_with_the_longest_stable_step() {
    for order in [8, 12, 17, 24, 32, 40] {
        for tolerance in [1e-4, 1e-6, 1e-9] {
            let method = Taylor { order: Some(order), ..Taylor::tolerance(tolerance) };
            let pendulum = ElasticPendulum::<f64>::default();
            let outcome = integrate(&pendulum, 0.0, START, 100.0, &method, |_, _| {});
            let (limit, time) = refused::<ElasticPendulum<f64>>(outcome);
            let factorial = (1..=order).fold(0.0, |sum, k| sum + (k as f64).ln());
            let stable = (factorial / order as f64).exp() / 1e4;
            assert!((limit / stable - 1.0).abs() < 0.1, "{order} {tolerance:e}: {limit:e} {stable:e}");
            assert!(time < 2.0, "{order} {tolerance:e}: {time}");
        }
    }
}

#[test]
fn the_message_names_the_method_to_take() {
    let pendulum = ElasticPendulum::<f64>::default();
    let run = pendulum.simulate(START).until(1000.0).method(Taylor::tolerance(1e-8));
    let message = run.run().expect_err("stiff").to_string();
    assert!(message.contains("`.method(Radau5::tolerance(1e-8))`"), "{message}");
    assert!(message.contains("`radau`") && message.contains("`emit { jacobian }`"), "{message}");
}

/// A spring of 10⁸ N/m would hide changes of length in rounding.
#[test]
fn single_precision_reports_stiffness() {
    let pendulum = ElasticPendulum { k: 1e4_f32, c: 250.0, ..ElasticPendulum::default() };
    let start = START.map(|entry| entry as f32);
    for tolerance in [1e-3, 1e-5] {
        let outcome = integrate(&pendulum, 0.0, start, 5000.0, &Taylor::tolerance(tolerance), |_, _| {});
        let (limit, _) = refused::<ElasticPendulum<f32>>(outcome);
        assert!((2e-2..5e-2).contains(&limit), "{limit}");
    }
}

#[test]
fn few_steps_are_borne_and_stiffness_may_be_accepted() {
    let pendulum = ElasticPendulum::<f64>::default();
    let short = integrate(&pendulum, 0.0, START, 4.0, &Taylor::tolerance(1e-9), |_, _| {});
    let [_, theta, ..] = short.expect("5000 steps");
    assert!((theta - 0.692_166_962_627_622_7).abs() < 1e-8, "{theta}");
    let patient = Taylor { refuses_stiff: false, ..Taylor::tolerance(1e-9) };
    assert!(integrate(&pendulum, 0.0, START, 30.0, &patient, |_, _| {}).is_ok());
}

#[test]
fn a_pendulum_at_rest_goes_on() {
    let pendulum = ElasticPendulum { g: 0.0, ..ElasticPendulum::<f64>::default() };
    let rest = [1.0, 0.5, 0.0, 0.0];
    assert_eq!(integrate(&pendulum, 0.0, rest, 1e6, &Taylor::tolerance(1e-9), |_, _| {}), Ok(rest));
}

/// Returns the number of evaluations other than expansions, over many steps.
fn looks<M: TaylorSystem<Scalar = f64>>(system: &M, start: M::State, tolerance: f64) -> u64 {
    let end = 1e7;
    let mut stepper = Taylor::tolerance(tolerance).start(system, 0.0, &start, end).expect("starts");
    for _ in 0..20_000 {
        stepper.step(system, end).expect("no motion for which stability limits the step");
    }
    let work = stepper.work();
    work.evaluations - work.steps - work.rejections - 1
}

#[test]
fn ordinary_motions_are_neither_refused_nor_slowed() {
    let (pendulum, chaos) = (DoublePendulum::default(), [2.0, 1.5, 0.0, 0.0]);
    let damped = DoublePendulum { drag: 0.2, ..DoublePendulum::default() };
    // Near the end of its motion, stability may limit steps that are borne.
    looks(&damped, chaos, 1e-6);
    let comet = [1.9, 0.0, 0.0, (0.1_f64 / 1.9).sqrt()];
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-13] {
        let total = [
            looks(&pendulum, chaos, tolerance),
            looks(&pendulum, [1e-3, 0.0, 0.0, 0.0], tolerance),
            looks(&Kepler, comet, tolerance),
        ];
        assert!(total.iter().all(|evaluations| *evaluations < 50), "{tolerance:e}: {total:?}");
    }
}
