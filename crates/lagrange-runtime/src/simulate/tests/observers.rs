//! Columns in addition to the state.

use std::string::ToString;
use std::vec::Vec;

use super::{Oscillator, START};
use crate::simulate::Simulate;
use crate::system::{CanonicalSystem, OdeSystem, SettingError, StepFailure};

impl CanonicalSystem for Oscillator {
    fn momenta(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }

    fn momentum_rates(&self, _t: f64, [x]: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [-x]
    }

    fn mass_matrix(&self, _t: f64, _q: &[f64; 1], _v: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
}

#[test]
fn every_observer_has_a_column_at_every_sample() {
    let mut calls = 0;
    let trajectory = Oscillator
        .simulate(START)
        .from(1.0)
        .until(3.0)
        .every(0.25)
        .energy()
        .momenta()
        .accelerations()
        .observe("time squared", |_, t, _| t * t)
        .observe_each(["a", "b"], OdeSystem::rhs)
        .observe("calls", |_, _, _| {
            calls += 1;
            f64::from(calls)
        })
        .run()
        .expect("runs");
    assert_eq!(
        trajectory.names(),
        ["x", "x_dot", "energy", "p_x", "x_ddot", "time squared", "a", "b", "calls"]
    );
    let column = |name| trajectory.column(name).expect("known").iter();
    for ((t, [x, v]), energy) in trajectory.iter().zip(column("energy")) {
        assert_eq!(*energy, 0.5 * (x * x + v * v));
        assert!((energy - 0.5).abs() < 1e-8, "at {t}");
    }
    assert!(column("p_x").eq(column("x_dot")) && column("a").eq(column("x_dot")));
    assert!(column("x_ddot").eq(column("b")));
    assert!(column("time squared").eq(trajectory.times().iter().map(|t| t * t).collect::<Vec<_>>().iter()));
    assert_eq!(calls, 9);
}

#[test]
fn two_columns_of_one_name_are_refused() {
    let error = Oscillator.simulate(START).until(1.0).energy().energy().run().expect_err("refused");
    assert_eq!(error.cause, StepFailure::Setting(SettingError::RepeatedColumn));
    assert_eq!(error.to_string(), "two columns are called `energy` (at time 0.0)");
    let error = Oscillator.simulate(START).until(1.0).observe("x", |_, t, _| t).run().expect_err("refused");
    assert_eq!(error.to_string(), "two columns are called `x` (at time 0.0)");
}

#[test]
fn no_columns_and_columns_without_names_are_refused() {
    let none =
        Oscillator.simulate(START).until(1.0).observe_each([], |_, _, _| []).run().expect_err("refused");
    assert!(none.to_string().starts_with("a list of columns to observe is empty"), "{none}");
    let unnamed = Oscillator.simulate(START).until(1.0).observe("", |_, t, _| t).run().expect_err("refused");
    assert!(unnamed.to_string().starts_with("a column has an empty name"), "{unnamed}");
}

#[test]
fn a_column_of_the_name_of_time_is_refused() {
    let error = Oscillator.simulate(START).until(1.0).observe("t", |_, t, _| t).run().expect_err("refused");
    assert!(
        matches!(error.cause, StepFailure::Setting(SettingError::Invalid(what)) if what.contains("time"))
    );
}
