//! Mistakes in data and settings, and their messages.

use lagrange::fit::{Data, FitSearch, Fits};
use lagrange::integrate::Verner98;

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Fall;
    param g: m/s^2 = 9.81, drag: 1/s = 0.1;
    const m: kg = 1;
    coord h: m, x: m;
    kinetic = 1/2 * m * (dot(h)^2 + dot(x)^2);
    potential = m * g * h;
    dissipation = 1/2 * drag * m * (dot(h)^2 + dot(x)^2);
    event ground = h, falling => stop;
    emit { jacobian }
}

fn data() -> Data {
    Data::new([0.0, 0.1, 0.2]).with("h", [1.0, 0.95, 0.81])
}

type Search<'a> = FitSearch<'a, Fall, Verner98<f64>>;

fn message(data: Data, set: impl for<'a> Fn(Search<'a>) -> Search<'a>) -> String {
    let fall = Fall::default();
    set(fall.fit([1.0, 0.0, 0.0, 1.0], data)).run().expect_err("a mistake").to_string()
}

fn vary(fit: Search<'_>) -> Search<'_> {
    fit.vary("g", 1.0..=20.0)
}

#[test]
fn mistakes_are_reported_by_name() {
    assert_eq!(
        message(data().with("y", [1.0; 3]), |fit| vary(fit).noise("h", 0.1).noise("y", 0.1)),
        "nothing of the system is called `y`, as a column of the data is; known are `h`, `x`, `h_dot`, `x_dot`"
    );
    assert_eq!(
        message(data().with("x", [1.0; 3]), vary),
        "column `h` needs a noise level, `.noise(\"h\", …)`, by which its residuals count beside those of other columns"
    );
    assert_eq!(
        message(data(), |fit| vary(fit).noise("h", -1.0)),
        "the noise level -1.0 of column `h` is not a positive number"
    );
    assert_eq!(message(data().with("x", [1.0; 2]), vary), "column `x` has 2 values for 3 times");
    assert_eq!(
        message(Data::new([0.0, 0.1]).with("h", [1.0, f64::NAN]), vary),
        "the value in row 1 of column `h` is not finite; leave values out that are missing"
    );
    assert!(
        message(Data::new([0.0, 0.1, 0.1]).with("h", [1.0; 3]), vary)
            .starts_with("the time in row 2 is not after")
    );
    assert!(message(data(), |fit| vary(fit).from(0.05)).starts_with("the time in row 0 is not after"));
    assert_eq!(message(data().with("h", [1.0; 3]), vary), "two columns of the data are called `h`");
    assert_eq!(message(data(), |fit| fit), "nothing varies: name a parameter by `.vary(\"m\", 0.1..=10.0)`");
    assert_eq!(
        message(data(), |fit| fit.vary("G", ..)),
        "`G` cannot vary: it is no parameter, input or state; these are g, drag, h, x, h_dot, x_dot"
    );
    assert_eq!(message(data(), |fit| vary(fit).vary("g", ..)), "`g` cannot vary: it varies already");
    assert_eq!(
        message(data(), |fit| fit.vary("g", ..5.0)),
        "`g` cannot vary: its value 9.81 is not between -inf and 5.0"
    );
    assert_eq!(
        message(Data::new([0.0]).with("h", [1.0]), |fit| vary(fit).vary("drag", 0.0..)),
        "1 values do not tell 2 variables: vary fewer, or measure more"
    );
    let in_feet = Data::parse_csv("t in s,h in cm\n0,1\n").unwrap();
    assert_eq!(message(in_feet, vary), "column `h` of the data is in cm, and `h` of the system in m");
}

#[test]
fn a_motion_that_ends_early_is_reported_with_its_values() {
    let late = Data::new([0.0, 2.0]).with("h", [1.0, 0.5]);
    let text = message(late, |fit| fit.vary("g", 1.0..));
    assert!(
        text.starts_with("no motion reaches the end of the data from g = 9.81: an event ends the motion"),
        "{text}"
    );
}

#[test]
fn a_search_that_does_not_end_keeps_its_last_values() {
    let fall = Fall::default();
    let search = fall.fit([1.0, 0.0, 0.0, 1.0], data()).vary("g", 1.0..=20.0).max_iterations(1);
    let error = search.run().unwrap_err();
    assert!(error.to_string().starts_with("no minimum was found in 1 iterations"), "{error}");
    assert!(error.fitted().unwrap().value("g").unwrap() != 9.81);
}

lagrange::system! {
    /// A state driven by noise.
    #[derive(Clone, Debug)]
    struct Driven;
    param k = 1;
    state x = 1;
    noise w, density: 1;
    dot(x) = -k * x + w;
}

lagrange::system! {
    /// A state driven by its past.
    #[derive(Clone, Debug)]
    struct Late;
    param k = 1;
    state x = 1;
    dot(x) = -k * delay(x, 0.5);
}

#[test]
fn systems_without_derivatives_are_refused_with_the_cause() {
    let data = || Data::new([0.0, 0.1, 0.2]).with("x", [1.0, 0.9, 0.8]);
    let error =
        Driven::default().fit([1.0], data()).vary("k", 0.1..=9.0).run().expect_err("has noise").to_string();
    assert!(error.contains("derivatives do not go through white noise"), "{error}");
    let error =
        Late::default().fit([1.0], data()).vary("k", 0.1..=9.0).run().expect_err("has delays").to_string();
    assert!(error.contains("delayed signals need a past"), "{error}");
}
