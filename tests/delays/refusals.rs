//! Nothing runs without the history that it needs.

use lagrange::Simulate;
use lagrange::integrate::{Verner98, integrate};
use lagrange::system::{DelayedSystem, Direction, StepFailure};

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
        let reason =
            if lag == 1e-18 { "at least 1e-8 for a run of this length" } else { "positive and finite" };
        let message = format!("the delay of `delayed_1` is {lag:?}, but it must be {reason}");
        assert!(error.to_string().contains(&message), "{error}");
        assert!(error.cause.is_refusal());
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
    assert!(
        error.contains("the delay of `delayed_1` is 1e-6, but it must be at least 1e-5 for a run"),
        "{error}"
    );
    let pair = Pair { short: 1e-7, ..Pair::default() };
    let error = pair.simulate([1.0]).until(9.0).with_history().run().unwrap_err().to_string();
    assert!(
        error.contains("the delay of `delayed_1` is 1e-7, but it must be at least 9e-6, since the past"),
        "{error}"
    );
    pair.simulate([1.0]).until(1e-5).with_history().run().unwrap();
    // The second delay is named by its own input, beside an undelayed one.
    let one = Named { own: f64::NAN, ..Named::default() };
    let error = one.simulate([1.0]).until(1.0).with_history().run().unwrap_err().to_string();
    assert!(error.contains("the delay of `late` is -1.0"), "{error}");
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Named;
    param lag = -1;
    input own;
    state x = 1;
    let late = delay(x, lag);
    dot(x) = -delay(x, 1) - late - own;
}

#[test]
fn a_run_that_something_else_ends_may_be_of_any_length() {
    let late = Late::default();
    let far = || late.simulate([1.0]).until(1e9).with_history();
    assert!(far().run().unwrap_err().to_string().contains("at least 10.0 for a run of this length"));
    // x = 1 − t reaches one half.
    let stopped = far().stop_at("half", Direction::Falling, |_, _, [x]| x - 0.5).run().unwrap();
    assert!((stopped.end_time() - 0.5).abs() < 1e-9, "{}", stopped.end_time());
    let limited = far().max_steps(5).run().unwrap_err();
    assert_eq!(limited.cause, StepFailure::TooManySteps { limit: 5 });
    let coarse = late.simulate([1.0]).until(1e14).with_history().max_steps(5).run().unwrap_err().to_string();
    assert!(coarse.contains("a thousand spacings of the times of this run"), "{coarse}");
    let declared = Stops::default();
    let stopped = declared.simulate([1.0]).until(1e9).with_history().run().unwrap();
    assert!((stopped.end_time() - 0.5).abs() < 1e-9, "{}", stopped.end_time());
}

lagrange::system! {
    struct Stops;
    state x = 1;
    dot(x) = -delay(x, 1);
    event half = x - 1/2, falling => stop;
}

lagrange::system! {
    #[scalar(f32)]
    struct LateSingle;
    param lag = 1;
    state x = 1;
    dot(x) = -delay(x, lag);
}

/// Times near 20000 are 1/512 apart in single precision; the relative spacing is 2⁻²³.
#[test]
fn delays_are_a_thousand_spacings_of_time_at_least() {
    let run = |lag| {
        LateSingle { lag, ..LateSingle::default() }
            .simulate([1.0])
            .from(2e4)
            .until(2e4 + 1.0)
            .with_history()
            .run()
    };
    assert!(run(2.5).is_ok());
    let error = run(2.0).unwrap_err().to_string();
    assert!(error.contains("is 2.0, but it must be at least 2.38"), "{error}");
}

#[test]
fn ends_that_are_not_finite_are_named() {
    let late = Late::default();
    for end in [f64::NAN, f64::INFINITY] {
        let error = late.simulate([1.0]).until(end).with_history().run().unwrap_err();
        assert_eq!(error.to_string(), format!("the time of the end is {end:?} (at time 0.0)"));
        let error = late.simulate([1.0]).from(end).until(1.0).with_history().run().unwrap_err().to_string();
        let is_named = error.starts_with(&format!("the time of the start is {end:?}"));
        assert!(is_named || error.contains("forwards in time only"), "{error}");
    }
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
        assert!(
            message.starts_with("motion 1: the delay of `delayed_1` is -1.0, but it must be"),
            "{message}"
        );
        assert!(ends.x()[0].abs() < 1e-12 && (ends.x()[3] - 0.125).abs() < 1e-12, "{:?}", ends.x());
    }
}
