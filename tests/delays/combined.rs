//! Delays in parts and arrays, under reserved names, and beside other features of runs.

use lagrange::Simulate;
use lagrange::integrate::{Method, Verner98};
use lagrange::system::DelayedSystem;

use crate::linear::Late;

lagrange::system! {
    /// Two carts, each with a delayed spring; the second one is slower.
    #[derive(Clone, Debug)]
    struct Carts;
    part Cart(lag, k = 4) {
        coord x = 1;
        kinetic = 1/2 * dot(x)^2;
        let seen = delay(x, lag);
        force x = -k * seen - delay(dot(x), lag);
    }
    cart[i in 0..2]: Cart { lag: 0.1 * (i + 1); }
}

lagrange::system! {
    /// The carts without parts.
    #[derive(Clone, Debug)]
    struct Flat;
    coord x[2] = 1;
    kinetic = 1/2 * (dot(x[0])^2 + dot(x[1])^2);
    for i in 0..2 {
        force x[i] = -4 * delay(x[i], 0.1 * (i + 1)) - delay(dot(x[i]), 0.1 * (i + 1));
    }
}

lagrange::system! {
    /// A parameter and a signal named like elements of the language.
    #[derive(Clone, Debug)]
    struct Named;
    param delay = 1, delayed_1 = 2;
    state x = 1;
    dot(x) = -delay(x, delay) * delayed_1 / 2;
    emit { tests, jacobian }
}

#[test]
fn parts_and_arrays_delay_each_signal_of_theirs() {
    let (carts, flat) = (Carts::default(), Flat::default());
    assert_eq!(carts.lags(), [0.1, 0.1, 0.2, 0.2]);
    assert_eq!(flat.lags(), carts.lags());
    let whole = carts.simulate(carts.start()).until(2.0).with_history().run().expect("runs");
    let same = flat.simulate(flat.start()).until(2.0).with_history().run().expect("runs");
    assert_eq!(whole.last(), same.last());
    assert_ne!(whole.last()[0], whole.last()[1]);
}

#[test]
fn names_of_the_user_keep_their_meaning() {
    let named = Named::default();
    let run = named.simulate([1.0]).until(2.0).with_history().run().expect("runs");
    assert!((run.last()[0] + 0.5).abs() < 1e-12);
    assert_eq!(run.column("delayed_2").expect("a column").len(), run.len());
}

/// Rates called by hand take delayed signals from the fields, as they take inputs.
#[test]
fn rates_by_hand_are_those_of_the_fields() {
    let late = Late::default();
    assert_eq!(late.rhs(0.0, &[1.0]), [0.0]);
    assert_eq!(late.with_delayed(&[1.0]).rhs(0.0, &[1.0]), [-1.0]);
}

#[test]
fn methods_without_history_refuse() {
    let named = Named::default();
    let error = named.simulate([1.0]).until(1.0).gradient(["delay"], |_, [x], _| *x).unwrap_err().to_string();
    assert!(error.contains("`.with_history()`"), "{error}");
    let error = Verner98::tolerance(1e-9).start(&named, 0.0, &[1.0], 1.0).map(drop).unwrap_err().to_string();
    assert!(error.contains("`.with_history()`"), "{error}");
}
