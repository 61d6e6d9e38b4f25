//! Arrays, loops and sums: the code equals that of the declaration written out, and values equal
//! those of references.

use std::fs;
use std::path::Path;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::expand::without_arrays;
use lagrange_core::pipeline::{NumericSystem, parse, parse_with};
use lagrange_core::syntax::{parse_text, print};
use lagrange_core::tables::FileText;
use proptest::prelude::{Just, Strategy, prop, prop_assert_eq, prop_oneof, proptest};
use quote::quote;

const MASSES: &str = "[0.93, 0.86, 0.79, 0.72, 0.65, 0.58, 0.51, 0.44, 0.37, 0.30]";
const LENGTHS: &str = "[0.85, 0.80, 0.75, 0.70, 0.65, 0.60, 0.55, 0.50, 0.45, 0.40]";

/// Returns the code emitted for a correct text whose fields are not arrays.
fn emitted(text: &str) -> String {
    let derived = parse(text).and_then(|mut system| {
        system.declaration.arrays.clear();
        system.derive(StrategyChoice::Cheapest)
    });
    let tokens = derived.and_then(|derived| derived.emit(&quote!(::lagrange)));
    tokens.unwrap_or_else(|report| panic!("{text}\n{report}")).to_string()
}

/// Returns the statements without arrays as text, and those with arrays as printed.
fn written_out(text: &str) -> [String; 2] {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report).expect("tokens");
    let printed = print::statements(&declaration);
    let written_out = print::statements(&without_arrays(declaration, &mut report));
    assert!(!report.has_errors(), "{text}\n{report}");
    [written_out, printed]
}

fn numeric(text: &str) -> NumericSystem {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{text}\n{report}")))
}

fn oracle(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/oracle").join(format!("{name}.lag"));
    fs::read_to_string(path).expect("a declaration")
}

/// Returns point masses on massless rods with angles `a` of the rods.
fn chain(n: usize, angles: &str) -> String {
    let first = |list: &str| list.split(", ").take(n).collect::<Vec<_>>().join(", ").replace(']', "");
    let (masses, lengths) = (first(MASSES), first(LENGTHS));
    format!(
        "const n = {n}; param m[n] = {masses}], l[n] = {lengths}], g = 9.81; coord q[n];
         for i in 0..n {{
             {angles}
             let x[i] = if i > 0 {{ x[i-1] + l[i]*sin(a[i]) }} else {{ l[i]*sin(a[i]) }};
             let y[i] = if i > 0 {{ y[i-1] - l[i]*cos(a[i]) }} else {{ -l[i]*cos(a[i]) }};
         }}
         kinetic = sum(i in 0..n, 1/2*m[i]*(dot(x[i])^2 + dot(y[i])^2));
         potential = sum(i in 0..n, m[i]*g*y[i]);"
    )
}

const PLEIADES: &str = "
    const n = 7;
    coord x[n], y[n];
    kinetic = sum(i in 0..n, (i + 1)/2*(dot(x[i])^2 + dot(y[i])^2));
    potential = -sum(i in 0..n - 1, sum(j in i + 1..n, (i + 1)*(j + 1)/sqrt((x[i] - x[j])^2 + (y[i] - y[j])^2)));";

#[test]
fn systems_of_the_oracle_have_the_same_bits_with_arrays() {
    let [absolute, relative] = ["let a[i] = q[i];", "let a[i] = if i > 0 { a[i-1] + q[i] } else { q[i] };"];
    let systems = [
        ("chain3_absolute", chain(3, absolute)),
        ("chain5_absolute", chain(5, absolute)),
        ("chain5_absolute", chain(5, "let angle = q[i];").replace("a[i]", "angle")),
        ("chain10_absolute", chain(10, absolute)),
        ("chain4_relative", chain(4, relative)),
        ("chain6_relative", chain(6, relative)),
        ("pleiades", PLEIADES.to_owned()),
    ];
    for (name, with_arrays) in systems {
        let (known, found) = (numeric(&oracle(name)), numeric(&with_arrays));
        let n = known.degrees_of_freedom();
        assert_eq!(found.degrees_of_freedom(), n, "{name}");
        for shift in [0.0, 0.7, 1.9] {
            let q = (0..n).map(|i| shift + 0.3 * (i * i) as f64 - 0.8 * i as f64).collect::<Vec<_>>();
            let v = (0..n).map(|i| 0.5 - 0.25 * shift * i as f64).collect::<Vec<_>>();
            let bits = |system: &NumericSystem| {
                let acceleration = system.acceleration(0.25, &q, &v);
                assert!(acceleration.iter().all(|value| value.is_finite()), "{name}");
                acceleration.into_iter().map(f64::to_bits).collect::<Vec<_>>()
            };
            assert_eq!(bits(&found), bits(&known), "{name}");
        }
    }
}

#[test]
fn words_that_continue_statements_may_name_arrays() {
    let text = "param k[2] = [1, 2]; coord x[2]; param end = 3;
         kinetic = k[0] * dot(x[0])^2 + k[1] * dot(x[1])^2;
         force x[1] = end * k[1];";
    let words = text.replace("k[", "along[").replace("x[", "at[").replace("end", "inside");
    for text in [text, &words] {
        assert_eq!(numeric(text).acceleration(0.0, &[0.5, -2.0], &[1.0, 0.25]), [0.0, 1.5], "{text}");
    }
}

/// Interpolates linearly by hand, and continues beyond the last point as declared.
fn interpolated(points: &[(f64, f64)], x: f64) -> f64 {
    let piece = points.windows(2).find(|pair| x <= pair[1].0).unwrap_or(&points[points.len() - 2..]);
    let [(a, y), (b, z)] = [piece[0], piece[1]];
    y + (z - y) * (x - a) / (b - a)
}

/// Each table has its own points, the last one from a file, and functions use them.
#[test]
fn tables_of_an_array_have_the_values_of_their_own_points() {
    let text = r#"
        const slope[2] = [3, -1];
        coord x[3];
        for i in 0..2 { table pull[i](s) = [(0, i), (1, slope[i]), (3, 5)], interpolation: linear, outside: extend; }
        table pull[2](s) = "third.csv", interpolation: linear, outside: extend;
        for i in 0..3 {
            let twice[i](s) = 2 * pull[i](s);
            kinetic = 1/2 * dot(x[i])^2;
            force x[i] = twice[i](x[(i + 1) % 3]);
        }"#;
    let read = |path: &str| match path {
        "third.csv" => Ok(FileText { path: String::new(), text: "0, 4\n2, -2\n5, 1\n".to_owned() }),
        other => Err(other.to_owned()),
    };
    let derived = parse_with(text, &read).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let system = NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    let points: [&[(f64, f64)]; 3] = [
        &[(0.0, 0.0), (1.0, 3.0), (3.0, 5.0)],
        &[(0.0, 1.0), (1.0, -1.0), (3.0, 5.0)],
        &[(0.0, 4.0), (2.0, -2.0), (5.0, 1.0)],
    ];
    // Outside, on points and between them.
    for q in [[-1.0, 0.5, 6.0], [0.0, 1.0, 3.0], [2.5, -0.25, 1.75]] {
        let found = system.acceleration(0.0, &q, &[0.0; 3]);
        for (i, acceleration) in found.into_iter().enumerate() {
            let expected = 2.0 * interpolated(points[i], q[(i + 1) % 3]);
            assert!((acceleration - expected).abs() < 1e-13, "{i} at {q:?}: {acceleration}, not {expected}");
        }
    }
}

/// Terms for the loop over all coordinates of a random system.
const TERMS: [&str; 12] = [
    "kinetic = 1/2*m[i]*(i + 1)*dot(q[i])^2;",
    "let p[i] = (l[i]*sin(q[i]), -l[i]*cos(q[i])); kinetic = kinetic_energy(m[i], dot(p[i]) + (dot(q[0]), 0));",
    "if i > 0 { potential = spring_energy(k[i % 2][i / n * 0], q[i] - q[i-1]); } else { potential = q[i]^2; }",
    "if i % 2 == 0 && !(i > n || i == 1) { force q[i] = -dot(q[i]); }",
    "potential = sum(j in 0..=i, m[j]*cos(q[i] - q[(j + 1) % n]));",
    "dissipation = if i > 1 { dot(q[i] - q[i - 2])^2 } else { dot(q[i])^2 };",
    "event hit[i] = q[i] - i, rising => { dot(q[i]) = -dot(q[i]); }",
    "let scaled[i](z) = l[i] * z; table pull[i](s) = [(0, i), (1, 2)], interpolation: linear, outside: clamp; force q[i] = scaled[i](pull[i](q[i]));",
    "let r = q[i] - k[0][1]; let (s, c) = (sin(r), cos(q[i])); let f(z) = z * s; potential = f(r) * c;",
    "for j in i..n { const next = (j + 1) / n * 0; let d = q[j] - q[next]; force q[i] = -d; dissipation = dot(d)^2; }",
    "event all[i] = q[i] + 1, falling => { for j in 0..n { if j != i { dot(q[j]) = dot(q[i])/(j + 1); } else { q[j] = 0; } } }",
    "output place[i] = sum(j in 0..i, l[j]*q[j])*(i + 1);",
];

fn systems() -> impl Strategy<Value = String> {
    let lists = prop_oneof![Just("= 1"), Just("= 0.5"), Just("")];
    let terms = prop::collection::vec(prop::sample::select(TERMS.to_vec()), 0..6);
    (2_usize..6, lists, terms).prop_map(|(n, default, terms)| {
        let mut distinct: Vec<&str> = Vec::new();
        terms.into_iter().for_each(|term| {
            if !distinct.contains(&term) {
                distinct.push(term);
            }
        });
        format!(
            "const n = {n}; param m[n] {default}, l[n] = 2, k[2][2] = [[1, 2], 3]; coord q[n]; {} for i in 0..n {{ {} }}",
            "kinetic = sum(i in 0..n, dot(q[i])^2);
             every 2 => { for i in 1..n { if i % 2 == 1 { dot(q[i]) = q[i-1]; } } }",
            distinct.join(" ")
        )
    })
}

proptest! {
    #![proptest_config(crate::one_in(16))]

    #[test]
    fn code_is_that_of_what_is_written_out(text in systems()) {
        let [without, printed] = written_out(&text);
        let code = emitted(&text);
        prop_assert_eq!(&emitted(&without), &code);
        prop_assert_eq!(&emitted(&printed), &code);
    }
}

#[test]
fn a_chain_of_thirty_in_ten_lines_has_the_code_of_a_hundred() {
    let short = "
        const n = 30;
        param m[n] = 1, l[n] = 0.5, g = 9.81;
        coord theta[n];
        let p[0] = (0, 0);
        for i in 0..n {
            let p[i+1] = p[i] + l[i] * (sin(theta[i]), -cos(theta[i]));
            kinetic = kinetic_energy(m[i], dot(p[i+1]));
            potential = gravitational_energy(m[i], g, p[i+1].y);
        }
        output tip = p[n];";
    let [long, _] = written_out(short);
    assert!(long.lines().count() > 90);
    assert!(emitted(short) == emitted(&long));
}
