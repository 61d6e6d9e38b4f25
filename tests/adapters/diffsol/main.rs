//! Stiff systems for the crate `diffsol`, by backward differentiation: files to copy.
//!
//! [`integrate_stiff`] integrates any system with that crate. Nothing is projected: constraints and
//! the length of unit quaternions are kept as accurately as `diffsol` integrates.

mod drive;
mod jacobian;
mod problem;
mod stiff;

use std::cell::Cell;

use lagrange::system::{OdeSystem, StepFailure};

use stiff::{Stiff, integrate_stiff};

/// ẏ = −10⁶ (y − cos t) − sin t, with the solution cos t.
#[derive(Default)]
struct Relaxation {
    knows_jacobian: bool,
    evaluations: Cell<u32>,
    jacobians: Cell<u32>,
}

const RATE: f64 = 1e6;

impl OdeSystem for Relaxation {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, t: f64, y: &[f64; 1]) -> [f64; 1] {
        self.evaluations.set(self.evaluations.get() + 1);
        [-RATE * (y[0] - t.cos()) - t.sin()]
    }

    fn jacobian(&self, _t: f64, _y: &[f64; 1]) -> Option<[[f64; 1]; 1]> {
        self.jacobians.set(self.jacobians.get() + 1);
        self.knows_jacobian.then_some([[-RATE]])
    }
}

/// ẍ = −x, undefined after a given time.
struct Oscillator {
    until: f64,
}

impl OdeSystem for Oscillator {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
        if t > self.until { [f64::NAN; 2] } else { [y[1], -y[0]] }
    }
}

lagrange::system! {
    /// A pendulum on a stiff, damped spring.
    pub struct Elastic;
    const k = 1000000, c = 1000, g = 9.81;
    coord r, theta;
    kinetic = 1/2 * (dot(r)^2 + r^2 * dot(theta)^2);
    potential = 1/2 * k * (r - 1)^2 - g * r * cos(theta);
    dissipation = 1/2 * c * dot(r)^2;
}

const ENDLESS: Oscillator = Oscillator { until: f64::INFINITY };

#[test]
fn a_stiff_spring_hardly_stretches() {
    let mut steps = 0;
    let method = Stiff::tolerance(1e-8);
    let start = [1.0, 1.0, 0.0, 0.0];
    let end = integrate_stiff(&Elastic, 0.0, start, 10.0, &method, |_, _| steps += 1);
    let [length, ..] = end.expect("nothing is singular");
    // The spring oscillates about 1600 times; steps that resolved this would be many times as many.
    assert!((length - 1.0).abs() < 1e-4 && steps < 5_000, "{length} after {steps} steps");
}

#[test]
fn steps_are_longer_than_stability_of_explicit_methods_allows() {
    let method = Stiff::tolerance(1e-7);
    let mut steps = 0_u32;
    let end = integrate_stiff(&Relaxation::default(), 0.0, [1.0], 2.0, &method, |_, _| steps += 1);
    let [y] = end.expect("nothing is singular");
    assert!((y - 2.0_f64.cos()).abs() < 1e-6, "{y}");
    assert!(f64::from(steps) < 2.0 * RATE / 100.0, "{steps} steps");
}

#[test]
fn a_known_jacobian_saves_evaluations() {
    let run = |knows_jacobian| {
        let system = Relaxation { knows_jacobian, ..Relaxation::default() };
        integrate_stiff(&system, 0.0, [1.0], 2.0, &Stiff::tolerance(1e-7), |_, _| {})
            .expect("nothing is singular");
        (system.evaluations.get(), system.jacobians.get())
    };
    let ((with, jacobians), (without, _)) = (run(true), run(false));
    assert!(jacobians > 0 && with < without, "{with} evaluations with, {without} without");
}

#[test]
fn time_may_run_backwards() {
    let method = Stiff::tolerance(1e-8);
    let mut last = 5.0;
    let end = integrate_stiff(&ENDLESS, 5.0, [5.0_f64.cos(), -5.0_f64.sin()], -1.0, &method, |t, _| {
        assert!(t <= last);
        last = t;
    });
    let [x, v] = end.expect("nothing is singular");
    assert_eq!(last, -1.0);
    assert!((x - 1.0_f64.cos()).abs() < 1e-4 && (v - 1.0_f64.sin()).abs() < 1e-4, "{x} {v}");
}

#[test]
fn failures_report_the_last_good_state() {
    let method = Stiff::tolerance(1e-8);
    let error = integrate_stiff(&Oscillator { until: 1.0 }, 0.0, [1.0, 0.0], 2.0, &method, |_, y| {
        assert!(y[0].is_finite() && y[1].is_finite());
    });
    let error = error.expect_err("the system is undefined after one second");
    assert!(error.time <= 1.0, "{error:?}");
    assert!((error.state[0] - error.time.cos()).abs() < 1e-4, "{error:?}");
}

#[test]
fn a_run_of_no_length_returns_the_start() {
    let end = integrate_stiff(&ENDLESS, 3.0, [1.0, 2.0], 3.0, &Stiff::tolerance(1e-8), |_, _| {});
    assert_eq!(end, Ok([1.0, 2.0]));
}

#[test]
fn no_more_steps_are_taken_than_allowed() {
    let method = Stiff { max_steps: 5, ..Stiff::tolerance(1e-8) };
    let error = integrate_stiff(&ENDLESS, 0.0, [1.0, 0.0], 100.0, &method, |_, _| {})
        .expect_err("five steps are few");
    assert_eq!(error.cause, StepFailure::TooManySteps { limit: 5 });
    assert!(error.time > 0.0 && error.time < 100.0);
}

#[test]
fn settings_and_starts_without_sense_are_refused() {
    let run = |tolerance, start| {
        integrate_stiff(&ENDLESS, 0.0, start, 1.0, &Stiff::tolerance(tolerance), |_, _| {})
    };
    assert!(matches!(run(0.0, [1.0, 0.0]).map_err(|error| error.cause), Err(StepFailure::Setting(_))));
    assert!(matches!(run(f64::NAN, [1.0, 0.0]).map_err(|error| error.cause), Err(StepFailure::Setting(_))));
    let cause = run(1e-8, [f64::INFINITY, 0.0]).map_err(|error| error.cause);
    assert_eq!(cause, Err(StepFailure::NotFinite));
}
