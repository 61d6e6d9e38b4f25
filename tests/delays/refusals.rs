//! Nothing runs without the history that it needs.

use lagrange::Simulate;
use lagrange::integrate::{Verner98, integrate};
use lagrange::system::DelayedSystem;

use crate::linear::{Late, LateInputs, LateState};

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Pair;
    param short = 1, long = 20;
    state x = 1;
    dot(x) = -delay(x, short) - delay(x, long);
}

#[test]
fn runs_without_a_history_are_refused() {
    let late = Late::default();
    let error = late.simulate([1.0]).until(1.0).run().unwrap_err().to_string();
    assert!(error.contains("`.with_history()`"), "{error}");
    let error = integrate(&late, 0.0, [1.0], 1.0, &Verner98::tolerance(1e-9), |_, _| ()).unwrap_err();
    assert!(error.to_string().contains("`.with_history()`"), "{error}");
    let error = late.simulate([1.0]).until(1.0).sensitivities(["k"]).run().unwrap_err().to_string();
    assert!(error.contains("`.with_history()`"), "{error}");
    let error = late.simulate([1.0]).until(1.0).with_history().sensitivities(["k"]).run().unwrap_err();
    assert!(error.to_string().contains("not kept here"), "{error}");
    let law = |_: &Late, _, _: LateState| LateInputs { delayed_1: 0.0 };
    let error = late.simulate([1.0]).until(1.0).drive(law).run().unwrap_err().to_string();
    assert!(error.contains("`.with_history()`"), "{error}");
}

#[test]
fn delays_that_are_no_times_are_refused() {
    for lag in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-18] {
        let late = Late { lag, ..Late::default() };
        let error = late.simulate([1.0]).until(1.0).with_history().run().unwrap_err();
        let message = format!("a delay is {lag:?}, but in this run it must be at least 1e-8 and finite");
        assert!(error.to_string().contains(&message), "{error}");
        assert_eq!(late.lags()[0].to_bits(), lag.to_bits());
        assert_eq!(error.trajectory.len(), 1);
        let instant = late.simulate([1.0]).from(0.0).until(0.0).with_history().run();
        assert_eq!(instant.is_ok(), lag == 1e-18, "{lag}");
    }
    let error = Late::default().simulate([1.0]).until(-1.0).with_history().run().unwrap_err().to_string();
    assert!(error.contains("forwards in time only"), "{error}");
}

/// No step is longer than the shortest delay, and the past is kept for the longest one.
#[test]
fn delays_that_take_too_many_steps_are_refused_at_once() {
    let late = Late { lag: 1e-6, ..Late::default() };
    let error = late.simulate([1.0]).until(1000.0).with_history().run().unwrap_err().to_string();
    assert!(error.contains("a delay is 1e-6, but in this run it must be at least 1e-5"), "{error}");
    let pair = Pair { short: 1e-7, ..Pair::default() };
    let error = pair.simulate([1.0]).until(9.0).with_history().run().unwrap_err().to_string();
    assert!(error.contains("a delay is 1e-7, but in this run it must be at least 9e-6"), "{error}");
    pair.simulate([1.0]).until(1e-5).with_history().run().unwrap();
}

#[test]
#[cfg(feature = "ensemble")]
fn a_delay_that_is_no_time_ends_only_its_motion() {
    use lagrange::Ensembles;
    // The values of the system itself do not matter if every motion has its own.
    for own in [1.0, f64::NAN] {
        let late = Late { lag: own, ..Late::default() };
        let lags = [1.0, -1.0, f64::NAN, 0.5, 1e-18];
        let motions = late.ensemble(5).start(|_, _| [1.0]).parameters(|index, late| late.lag = lags[index]);
        let ends = motions.until(1.0).with_history().run().unwrap();
        let failed = ends.failures().iter().map(|failure| failure.index).collect::<Vec<_>>();
        assert_eq!(failed, [1, 2, 4]);
        let message = ends.failures()[0].to_string();
        assert!(message.starts_with("motion 1: a delay is -1.0, but in this run it must be"), "{message}");
        assert!(ends.x()[0].abs() < 1e-12 && (ends.x()[3] - 0.125).abs() < 1e-12, "{:?}", ends.x());
    }
}
