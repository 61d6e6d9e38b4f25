//! Functions of the crate and tables keep their meaning when printed and read. Tables have the
//! derivatives that differences show.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::{Just, Strategy, any, prop_assert, prop_assert_eq, prop_oneof, proptest};

use crate::printing::{emitted, printed_and_read, read};

/// Options of a table that is smooth enough for energies, and of any table.
const SMOOTH: [&str; 2] =
    ["interpolation: natural, outside: extend", "outside: error, interpolation: natural"];
const ANY: [&str; 4] = [
    "interpolation: linear, outside: clamp",
    "interpolation: monotone, outside: extend",
    "interpolation: natural, outside: clamp",
    "interpolation: linear, outside: extend",
];

/// Returns points of a table from −2 to 2 at least, in text.
fn points() -> impl Strategy<Value = String> {
    let steps = proptest::collection::vec((1_u32..8, -30_i32..30), 2..8);
    steps.prop_map(|steps| {
        let total = f64::from(steps.iter().map(|(step, _)| *step).sum::<u32>());
        let mut x = -2.5;
        let first = format!("(-5/2, {})", f64::from(steps[0].1) / 10.0);
        let others = steps.iter().map(|(step, y)| {
            x += 5.0 * f64::from(*step) / total;
            format!("({x:.3}, {y} / 10)")
        });
        [first].into_iter().chain(others).collect::<Vec<_>>().join(", ")
    })
}

/// Returns a function of the crate with some of its derivatives listed, or with all of them by
/// default.
fn external() -> impl Strategy<Value = &'static str> {
    prop_oneof![
        Just("function push(u);"),
        Just("function push(u) { derivative: slope; second_derivative: bend; }"),
        Just("function push(u) { by u: slope; by u, u, u: third; second_derivative: bend; }"),
    ]
}

/// Returns a system with tables in its energy and in a force, and with functions of the crate.
fn systems() -> impl Strategy<Value = String> {
    let surface = (any::<bool>(), -20_i32..20);
    (points(), points(), 0..SMOOTH.len(), 0..ANY.len(), external(), surface).prop_map(
        |(hill, motor, smooth, rough, push, (is_natural, corner))| {
            let (smooth, rough) = (SMOOTH[smooth], ANY[rough]);
            let way = if is_natural { "natural" } else { "linear" };
            format!(
                "table hill(x) = [{hill}], {smooth};
                 table motor(v) = [{motor}], {rough};
                 table map(x, v) = [(-3, -3, 1), (-3, 3, 2), (0, -3, {corner}/7), (0, 3, 0.1), (4, -3, -1), (4, 3, 1)],
                    interpolation: {way}, outside: extend;
                 {push}
                 function pull(a, b) {{ by a: pull_a; by b: pull_b; }}
                 param m = 2;
                 coord x;
                 kinetic = kinetic_energy(m, dot((x, hill(x))));
                 potential = hill(x) * m;
                 force x = motor(dot(x)) + map(x, dot(x)) + push(x) * pull(x, dot(x));
                 emit {{ jacobian }}"
            )
        },
    )
}

proptest! {
    #![proptest_config(crate::one_in(32))]

    #[test]
    fn random_functions_and_tables_are_printed_as_what_they_say(text in systems()) {
        let declaration = read(&text);
        prop_assert_eq!(emitted(printed_and_read(&declaration)), emitted(declaration));
    }

    #[test]
    fn jacobians_go_through_random_tables_and_functions(text in systems(), x in -2.0..2.0_f64, v in -2.0..2.0_f64) {
        let system = parse(&text).expect("a correct declaration");
        let derived = system.derive(StrategyChoice::Cheapest).expect("a regular mass matrix");
        let mut numeric = NumericSystem::new(&derived);
        let push: [fn(f64) -> f64; 2] = [|u| (u - 0.3).sin(), |u| (u - 0.3).cos()];
        prop_assert!(numeric.define("push", move |u| push[0](u[0])));
        numeric.define("push_derivative", move |u| push[1](u[0]));
        numeric.define("slope", move |u| push[1](u[0]));
        numeric.define("pull", |arguments| arguments[0] * arguments[1] + arguments[1].powi(2));
        numeric.define("pull_a", |arguments| arguments[1]);
        numeric.define("pull_b", |arguments| arguments[0] + 2.0 * arguments[1]);
        let at = |x: f64, v: f64| numeric.acceleration(0.0, &[x], &[v])[0];
        let jacobian = numeric.product(Product::Jacobian, 0.0, &[x], &[v]).expect("it was asked for");
        let h = 1e-5;
        let differences = [(at(x + h, v) - at(x - h, v)) / (2.0 * h), (at(x, v + h) - at(x, v - h)) / (2.0 * h)];
        let one_sided = [(at(x + h, v) - at(x, v)) / h, (at(x, v + h) - at(x, v)) / h];
        for ((found, central), forward) in jacobian.into_iter().zip(differences).zip(one_sided) {
            let scale = found.abs().max(at(x, v).abs()).max(1.0);
            // A point of a table between the states gives both differences the same error.
            let bound = 2.0 * (central - forward).abs() + 1e-6 * scale;
            prop_assert!((found - central).abs() < bound, "{found} or {central}\n{text}");
        }
    }
}
