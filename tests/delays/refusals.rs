//! Nothing runs without the history that it needs.

use lagrange::Simulate;
use lagrange::integrate::{Verner98, integrate};
use lagrange::system::DelayedSystem;

use crate::linear::{Late, LateInputs, LateState};

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
        let error = late.simulate([1.0]).until(1.0).with_history().run().unwrap_err().to_string();
        assert!(error.contains("delays must be positive"), "{error}");
        assert_eq!(late.lags()[0].to_bits(), lag.to_bits());
    }
    let error = Late::default().simulate([1.0]).until(-1.0).with_history().run().unwrap_err().to_string();
    assert!(error.contains("forwards in time only"), "{error}");
}
