//! Forces that act only for a short time, and states within the steps that meet them.

use super::{Equation, Oscillator};
use crate::integrate::{Method, Stepper, Verner98, Work};
use crate::run::{Restarts, integrate};
use crate::system::{OdeSystem, StepFailure};

/// ẍ = −x + exp(−((t − centre)/width)²)
#[derive(Clone, Copy)]
struct Struck {
    centre: f64,
    width: f64,
}

impl OdeSystem for Struck {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, self.push(t) - x]
    }
}

impl Struck {
    fn push(&self, t: f64) -> f64 {
        (-((t - self.centre) / self.width).powi(2)).exp()
    }

    /// Returns the state at `t` of the motion that begins at rest, by Simpson's rule on ∫ push(s)
    /// sin(t − s) ds.
    fn exact(&self, t: f64) -> [f64; 2] {
        const PANELS: u32 = 1000;
        let (from, to) = (self.centre - 7.0 * self.width, t.min(self.centre + 7.0 * self.width));
        if to <= from {
            return [0.0; 2];
        }
        let h = (to - from) / f64::from(PANELS);
        (0..=PANELS).fold([0.0; 2], |[x, v], k| {
            let s = from + h * f64::from(k);
            let weight = if k == 0 || k == PANELS { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
            let part = weight * h / 3.0 * self.push(s);
            [x + part * (t - s).sin(), v + part * (t - s).cos()]
        })
    }
}

/// Returns numbers in the unit interval that are unrelated to steps.
fn scattered(count: u32) -> impl Iterator<Item = f64> {
    (1..=count).map(|k| (f64::from(k) * 0.618_033_988_749_894_9).fract())
}

fn distance([x, v]: [f64; 2], [a, b]: [f64; 2]) -> f64 {
    (x - a).abs().max((v - b).abs())
}

/// Returns the largest deviation of samples at this interval from the exact motion, and the work.
fn sampled(system: &Struck, end: f64, tolerance: f64, interval: f64) -> (f64, Work) {
    let method = Verner98::tolerance(tolerance);
    let mut stepper = method.start(system, 0.0, &[0.0; 2], end).expect("starts");
    let (mut worst, mut next) = (0.0_f64, 1_u32);
    let mut restarts = Restarts::new(0.0, end, &[]);
    while stepper.time() != end {
        restarts.step(system, &mut stepper, None, |_, to| interval * f64::from(next) < to).expect("finite");
        while interval * f64::from(next) <= stepper.time() {
            let t = interval * f64::from(next);
            worst = worst.max(distance(stepper.interpolate(system, t), system.exact(t)));
            next += 1;
        }
    }
    (worst, stepper.work())
}

#[test]
fn a_push_that_lasts_a_five_hundredth_of_the_run_is_felt() {
    for (k, place) in scattered(40).enumerate() {
        let system = Struck { centre: 0.2 + 9.6 * place, width: 0.02 };
        for tolerance in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13] {
            let method = Verner98::tolerance(tolerance);
            let end = integrate(&system, 0.0, [0.0; 2], 10.0, &method, |_, _| {}).expect("finite");
            let error = distance(end, system.exact(10.0));
            assert!(error < 30.0 * tolerance, "{error:e} at {tolerance:e}, push {k} at {}", system.centre);
        }
    }
}

#[test]
fn samples_are_no_wilder_than_the_tolerance() {
    for place in scattered(8) {
        let system = Struck { centre: 0.2 + 9.6 * place, width: 0.02 };
        for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
            let (worst, _) = sampled(&system, 10.0, tolerance, 0.013);
            assert!(worst < 30.0 * tolerance, "{worst:e} at {tolerance:e}, push at {}", system.centre);
        }
    }
}

/// A step is repeated only if the interpolant detects an error that the step did not.
#[test]
fn smooth_motions_pay_two_evaluations_for_a_step_that_is_looked_into() {
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
        let method = Verner98::tolerance(tolerance);
        let run = |is_looked_into| {
            let mut stepper = method.start(&Oscillator, 0.0, &[1.0, 0.0], 50.0).expect("starts");
            let mut restarts = Restarts::new(0.0, 50.0, &[]);
            while stepper.time() != 50.0 {
                restarts.step(&Oscillator, &mut stepper, None, |_, _| is_looked_into).expect("finite");
            }
            stepper.work()
        };
        let (blind, seen) = (run(false), run(true));
        assert_eq!((seen.steps, seen.rejections), (blind.steps, blind.rejections), "{tolerance:e}");
        assert_eq!(seen.evaluations - blind.evaluations, 11 * seen.steps + 1, "{tolerance:e}");
    }
}

#[test]
fn a_step_that_is_not_confirmed_is_taken_back() {
    // The stages of a step of one second lie at other places.
    let system = Struck { centre: 0.34, width: 0.01 };
    let method = Verner98 { first_step: Some(1.0), longest_step: Some(1.0), ..Verner98::tolerance(1e-6) };
    let mut stepper = method.start(&system, 0.0, &[0.0; 2], 9.0).expect("starts");
    stepper.step(&system, 9.0).expect("finite");
    assert!(
        stepper.time() == 1.0 && distance(*stepper.state(), [0.0; 2]) < 1e-30,
        "the push is stepped over"
    );
    assert!(!stepper.confirm(&system));
    assert_eq!((stepper.time(), *stepper.state(), stepper.last_time()), (0.0, [0.0; 2], 0.0));
    assert_eq!((stepper.work().steps, stepper.work().rejections), (0, 1));
    while stepper.time() < 2.0 {
        stepper.step(&system, 2.0).expect("finite");
        while !stepper.confirm(&system) {
            stepper.step(&system, 2.0).expect("finite");
        }
    }
    assert!(distance(*stepper.state(), system.exact(2.0)) < 1e-5);
}

#[test]
fn steps_are_a_part_of_the_way() {
    let longest = |system: &Equation<f64>, method: Verner98<f64>, end: f64| {
        let (mut last, mut longest) = (0.0_f64, 0.0_f64);
        integrate(system, 0.0, [1.0], end, &method, |t, _| {
            longest = longest.max((t - last).abs());
            last = t;
        })
        .expect("finite");
        longest
    };
    let (rest, drift) = (Equation(|_: f64, _: f64| 0.0), Equation(|_: f64, _: f64| 1.0));
    let method = Verner98::tolerance(1e-6);
    for end in [1e-3_f64, 20.0, -20.0, 1e9] {
        let span = end.abs();
        assert!((longest(&drift, method, end) / span - 0.05).abs() < 1e-9, "{end}");
        assert!((longest(&rest, method, end) / span - 0.005).abs() < 1e-9, "{end}");
        let asked = Verner98 { longest_step: Some(span), ..method };
        assert!(longest(&rest, asked, end) > 0.5 * span, "{end}");
    }
}

#[test]
fn a_start_that_the_tolerance_cannot_measure_is_refused_with_the_tolerance() {
    let method = Verner98 { absolute: 0.0, ..Verner98::tolerance(1e-9) };
    for (start, method) in [([5e-324, 1.0], method), ([0.0, 1e300], Verner98::tolerance(1e-9))] {
        let error = integrate(&Oscillator, 0.0, start, 1.0, &method, |_, _| {}).expect_err("no first step");
        let (relative, absolute) = (method.relative, method.absolute);
        assert_eq!(error.cause, StepFailure::NoFirstStep { relative, absolute });
        let message = std::format!("{}", error.cause);
        assert!(message.contains("1e-9") && message.contains("tolerance"), "{message}");
    }
}
