//! Equilibria and linear models of declarations in both forms: compiled by the macro, and read as
//! text. They must be identical, bit by bit.

use lagrange::linear::{LinearModel, Linearise};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{AnalysisError, DeclaredSystem, SearchSettings};

/// Declares a system in both forms.
macro_rules! both {
    ($name:ident { $($declaration:tt)* }) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;
            $($declaration)*
        }

        impl $name {
            fn text() -> DeclaredSystem {
                declared(stringify!($($declaration)*))
            }
        }
    };
}

both!(Loop {
    param m = 0.7, r = 1.2, g = 9.81;
    coord x, y;
    input u = 0.5;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    dissipation = 0.1 * (dot(x)^2 + dot(y)^2);
    force x = u;
    constraint ring = x^2 + y^2 - r^2;
    output height = y;
    output push = ddot(x) - u;
    emit { system_matrix }
});

both!(Rotor {
    param m = 0.5, l = 0.3, a = 0.02, b = 0.03, c = 0.01, g = 9.81;
    gravity = (0, 0, g);
    body rotor { mass: m; centroid: (0, 0, l); inertia: (a, b, c); }
    ball tip = ground to rotor { damping: 0.02; }
    input u;
    state i = 1;
    force tip_wx = 0.3 * i;
    dot(i) = u - 2 * i - 0.3 * tip_wx;
    emit { system_matrix }
});

fn declared(text: &str) -> DeclaredSystem {
    let derived = parse(text).unwrap_or_else(|report| panic!("{report}")).derive(StrategyChoice::Cheapest);
    let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    DeclaredSystem::new(programs).unwrap_or_else(|refusal| panic!("{refusal}"))
}

fn near(state: &[f64]) -> SearchSettings {
    SearchSettings { time: 0.0, near: state.to_vec(), hold: Vec::new(), trim: Vec::new() }
}

/// Returns a whole model as text, with all digits of its numbers.
fn words(model: &LinearModel) -> String {
    format!("{model:?} {:?}", model.modes())
}

#[test]
fn constrained_models_are_those_of_compiled_code() {
    let (compiled, read) = (Loop::default(), Loop::text());
    let start = [0.1, -1.2, 0.0, 0.0];
    let rest = compiled.equilibrium(start).solve().expect("rest");
    let found = read.equilibrium(near(&start)).expect("rest");
    assert_eq!((&rest.state[..], rest.iterations, rest.freedom), (&found.state[..], found.iterations, 0));
    // tan of the angle from below is u / (m g).
    assert!((rest.state[0] / -rest.state[1] - 0.5 / (0.7 * 9.81)).abs() < 1e-14, "{:?}", rest.state);
    let [one, other] = [
        compiled.linearise(0.0, rest.state).expect("smooth"),
        read.linearise(0.0, &found.state).expect("smooth"),
    ];
    assert_eq!(words(&one), words(&other));
    assert_eq!((one.inputs(), one.outputs(), one.states().len()), (&["u"][..], &["height", "push"][..], 2));
}

#[test]
fn trimmed_inputs_are_those_of_compiled_code() {
    let trimmed =
        Loop::default().equilibrium([0.6, -1.0, 0.0, 0.0]).hold(&["x"]).trim(&["u"]).solve().expect("rest");
    let settings = SearchSettings {
        hold: vec!["x".to_owned()],
        trim: vec!["u".to_owned()],
        ..near(&[0.6, -1.0, 0.0, 0.0])
    };
    let found = Loop::text().equilibrium(settings).expect("rest");
    assert_eq!((&trimmed.state[..], &trimmed.inputs), (&found.state[..], &found.inputs));
    assert!((found.inputs[0] - 0.7 * 9.81 * 0.6 / (1.44_f64 - 0.36).sqrt()).abs() < 1e-12, "{found:?}");
}

#[test]
fn orientations_and_states_are_linearised_as_in_compiled_code() {
    let (compiled, read) = (Rotor::default(), Rotor::text());
    let start = [0.9, 0.3, 0.2, 0.0, 0.4, 0.0, 0.0, 0.0];
    let rest = compiled.equilibrium(start).solve().expect("rest");
    let found = read.equilibrium(near(&start)).expect("rest");
    assert_eq!(&rest.state[..], &found.state[..]);
    let [one, other] = [
        compiled.linearise(0.0, rest.state).expect("smooth"),
        read.linearise(0.0, &found.state).expect("smooth"),
    ];
    assert_eq!(words(&one), words(&other));
    assert_eq!(one.states()[..4], ["rotation(tip_wx)", "rotation(tip_wy)", "rotation(tip_wz)", "i"]);
}

#[test]
fn failed_searches_are_explained() {
    let read = Loop::text();
    let wrong =
        read.equilibrium(SearchSettings { hold: vec!["z".to_owned()], ..near(&[0.0, -1.2, 0.0, 0.0]) });
    let error = wrong.expect_err("no such name");
    assert!(error.to_string().contains("`z` is not among the unknowns: these are `x`, `y`"), "{error}");
    let off = read.linearise(0.0, &[3.0, 0.0, 0.0, 0.0]).expect_err("off the ring");
    assert!(matches!(&off, AnalysisError::Linearisation(message) if message.contains("ring")), "{off}");
    let bare = declared("coord x; kinetic = dot(x)^2;");
    assert_eq!(bare.linearise(0.0, &[0.0, 0.0]).expect_err("underived"), AnalysisError::WithoutDerivatives);
}

#[test]
fn parameters_out_of_range_are_reported() {
    let mut spring = declared(
        "param k: N/m > 0 = 4; param m: kg = 1; coord x: m; kinetic = 1/2 * m * dot(x)^2; \
         potential = 1/2 * k * x^2; emit { system_matrix }",
    );
    spring.linearise(0.0, &[0.0, 0.0]).expect("in its range");
    spring.set("k", -4.0).expect("known");
    let errors = [
        spring.linearise(0.0, &[0.0, 0.0]).expect_err("out of its range"),
        spring.equilibrium(near(&[0.0, 0.0])).expect_err("out of its range"),
    ];
    for error in errors {
        assert!(matches!(&error, AnalysisError::Parameter(message) if message.contains("`k`")), "{error}");
    }
}
