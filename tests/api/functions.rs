//! Every elementary function has a name in emitted code and stands in the description of the language.

use std::collections::BTreeSet;

use lagrange_core::functions::{ROWS, Row};

const CALLABLE: &str = include_str!("../../src/private.rs");
const LANGUAGE: &str = include_str!("../../src/language.md");

fn of_rows(name: fn(&Row) -> &'static str) -> BTreeSet<&'static str> {
    ROWS.iter().map(name).collect()
}

#[test]
fn emitted_code_can_call_every_function() {
    let callable = CALLABLE.lines().filter_map(|line| line.trim_start().split_once(['(', '<']));
    let callable = callable.map(|(name, _)| name.trim_start_matches("pub fn ")).collect::<BTreeSet<_>>();
    let missing = of_rows(|row| row.rust).into_iter().filter(|name| !callable.contains(name));
    assert_eq!(missing.collect::<Vec<_>>(), [""; 0]);
}

#[test]
fn the_description_of_the_language_lists_every_function() {
    let (_, list) = LANGUAGE.split_once("- Functions: `").expect("a list of functions");
    let (list, _) = list.split_once('`').expect("its end");
    assert_eq!(list.split_whitespace().collect::<BTreeSet<_>>(), of_rows(|row| row.name));
}

lagrange::system! {
    /// The tip of a rod of constant curvature hangs on a spring.
    struct Tip<S>;
    param m = 1.0, k = 2.0;
    coord x;
    kinetic = 1/2 * m * (dot(x) * sinc(x))^2;
    potential = k * sinc(x);
    output height = sinc(x);
    emit { jacobian }
}

#[test]
fn sinc_is_emitted_for_every_number_type() {
    let tip = Tip::<f64>::default();
    let ([a], [narrow]) =
        (tip.acceleration(0.0, &[0.0], &[0.5]), Tip::<f32>::default().acceleration(0.0, &[0.0], &[0.5]));
    assert_eq!((a, narrow), (0.0, 0.0));
    for x in [-3.0_f64, -0.4, 1e-9, 0.3, 1.9, 2.1, 7.0] {
        let (s, slope) = (x.sin() / x, (x * x.cos() - x.sin()) / (x * x));
        let [a] = tip.acceleration(0.0, &[x], &[0.5]);
        let expected = (-2.0 * slope - 0.25 * s * slope) / (s * s);
        assert!((a - expected).abs() < 1e-6 * (1.0 + expected.abs()), "{x}: {a} instead of {expected}");
    }
    let jacobian = tip.jacobian(0.0, &[0.0, 0.5]);
    assert!((jacobian[1][0] - (2.0 / 3.0 + 0.25 / 3.0)).abs() < 1e-14, "{jacobian:?}");
}
