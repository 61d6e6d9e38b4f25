//! Restarts at specified times.

use std::vec::Vec;

use super::START;
use crate::integrate::RungeKutta4;
use crate::simulate::Simulate;
use crate::system::{MechanicalSystem, OdeSystem, SettingError, StepFailure, Unnamed};

/// ẍ = 6 t until one second, −2 afterwards.
struct Switched;

impl OdeSystem for Switched {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, self.acceleration(t, &[*x], &[*v])[0]]
    }
}

impl MechanicalSystem for Switched {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x"];

    fn acceleration(&self, t: f64, _q: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [if t <= 1.0 { 6.0 * t } else { -2.0 }]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }
}

/// Returns the state of [`Switched`], started from rest at the origin.
fn exact(t: f64) -> [f64; 2] {
    let after = t - 1.0;
    if t < 1.0 { [t.powi(3), 3.0 * t * t] } else { [1.0 + after * (3.0 - after), 3.0 - 2.0 * after] }
}

#[test]
fn samples_on_both_sides_of_a_jump_are_exact() {
    let start = || Switched.simulate([0.0; 2]).until(2.0).every(0.125);
    let fixed = start().method(RungeKutta4 { step: 0.3 }).restart_at([1.0]).run().expect("runs");
    for trajectory in [start().restart_at([1.0]).run().expect("runs"), fixed] {
        assert_eq!(trajectory.len(), 17);
        for (t, y) in trajectory.iter() {
            let error = (y[0] - exact(t)[0]).abs().max((y[1] - exact(t)[1]).abs());
            assert!(error < 1e-13, "{} at {t}: {error:e}", trajectory.method());
        }
    }
}

#[test]
fn every_time_of_restart_is_the_end_of_a_step() {
    let wanted = [0.0, 0.25, 1.0, 1.75, 2.0];
    let method = RungeKutta4 { step: 5.0 };
    let start = || Switched.simulate(START).until(2.0).method(method);
    let run =
        start().restart_at([1.75, 0.25, 7.0]).restart_at([1.0, 0.25, -1.0]).dense().run().expect("runs");
    assert_eq!(run.times(), wanted);
    assert!(run.at(1.0).is_ok() && run.at(0.5).is_ok());
    let back = Switched.simulate(START).from(2.0).until(0.0).method(method).restart_at([0.25, 1.75, 1.0]);
    let times: Vec<f64> = back.run().expect("runs").times().iter().rev().copied().collect();
    assert_eq!(times, wanted);
}

#[test]
fn times_of_restart_that_are_not_finite_are_refused() {
    for time in [f64::NAN, f64::INFINITY] {
        let refused = Switched.simulate(START).until(2.0).restart_at([1.0, time]).run();
        assert!(
            matches!(refused.expect_err("no time").cause, StepFailure::Setting(SettingError::Invalid(what)) if what.contains("restart"))
        );
    }
}
