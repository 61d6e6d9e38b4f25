//! Differences that count as rounding, tested from both sides: each test fails if a tolerance is 64
//! times smaller or larger.

use core::cell::Cell;

use crate::integrate::verner::Verner98;
use crate::integrate::verner::stepper::CHECKED;
use crate::integrate::verner::stiffness::is_at_limit;
use crate::integrate::{Method, Stepper};
use crate::system::OdeSystem;
use crate::tolerance::SAME_STATE;

/// ẏ = 1, and slightly more near one time.
struct Bump {
    time: Cell<f64>,
    height: f64,
}

impl OdeSystem for Bump {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, t: f64, _y: &[f64; 1]) -> [f64; 1] {
        let is_near = (t - self.time.get()).abs() < 1e-9;
        [if is_near { 1.0 + self.height } else { 1.0 }]
    }
}

#[test]
fn a_defect_that_is_rounding_of_the_rates_is_none() {
    let is_confirmed = |roundings: f64| {
        let bump = Bump { time: Cell::new(f64::NAN), height: roundings * f64::EPSILON };
        let mut stepper = Verner98::tolerance(1e-20).start(&bump, 0.0, &[0.0], 10.0).expect("starts");
        stepper.step(&bump, 10.0).expect("steps");
        let (from, to) = (stepper.last_time(), stepper.time());
        bump.time.set(from + CHECKED[0] * (to - from));
        stepper.confirm(&bump)
    };
    assert_eq!([100.0, 2048.0].map(is_confirmed), [true, false]);
}

#[test]
fn states_that_differ_by_rounding_do_not_tell_of_stiffness() {
    let looks_stiff = |roundings: f64| {
        let y = 1.0 + roundings * f64::EPSILON;
        is_at_limit((1.0, 1e6), (&[1.0], &[0.0]), (&[y], &[1.0]), SAME_STATE.part::<f64>())
    };
    assert_eq!([125.0, 8000.0].map(looks_stiff), [false, true]);
}
