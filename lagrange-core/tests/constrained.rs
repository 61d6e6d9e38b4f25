//! Constrained systems, interpreted, against reference values of an independent derivation with
//! many digits.

use std::fs;
use std::path::Path;

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::pipeline::{NumericSystem, parse};
use lagrange_core::program::{Labels, OperationCounts, lower, optimise};
use serde_json::Value;

const NAMES: [&str; 4] = ["andrews_squeezer", "chaplygin_sleigh", "cylinder_on_slope", "ladder_on_wall"];
const CHOICES: [StrategyChoice; 3] = [
    StrategyChoice::Always(Strategy::MassMatrix),
    StrategyChoice::Always(Strategy::ArticulatedBody),
    StrategyChoice::Cheapest,
];

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(entries) => entries.iter().flat_map(numbers).collect(),
        scalar => vec![scalar.as_str().expect("in quotes").parse().expect("a number")],
    }
}

fn read(name: &str) -> (String, Value) {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/constrained"));
    let [text, values] = ["lag", "json"].map(|extension| {
        fs::read_to_string(directory.join(name).with_extension(extension)).expect("a reference")
    });
    (text, serde_json::from_str(&values).expect("valid JSON"))
}

fn assert_near(found: &[f64], expected: &[f64], what: &str) {
    let largest = expected.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    assert_eq!(found.len(), expected.len(), "{what}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= 1e-11 * (1.0 + largest), "{what}: {found:?}, not {expected:?}");
    }
}

#[test]
fn accelerations_and_multipliers_agree_with_the_references_by_every_strategy() {
    for name in NAMES {
        let (text, reference) = read(name);
        for choice in CHOICES {
            let derived = parse(&text).and_then(|system| system.derive(choice));
            let derived = derived.unwrap_or_else(|report| panic!("{name}: {report}"));
            let system = NumericSystem::new(&derived);
            for state in reference["states"].as_array().expect("states") {
                let [t, q, v] = ["t", "q", "v"].map(|key| numbers(&state[key]));
                let what = format!("{name}, {choice:?}, t = {t:?}");
                let found = system.acceleration(t[0], &q, &v);
                assert_near(&found, &numbers(&state["acceleration"]), &what);
                let found = system.multipliers(t[0], &q, &v);
                assert_near(&found, &numbers(&state["multipliers"]), &what);
            }
        }
    }
}

/// Returns `n` rods hung from each other in maximal coordinates, with two constraints for each
/// joint.
fn hanging_rods(n: usize) -> String {
    let mut text =
        "param m = 1.0, j = 0.1, l = 1.0, g = 9.81;\nlet (ex0, ey0) = (0 * t, 0 * t);\n".to_owned();
    for k in 1..=n {
        let before = k - 1;
        text.push_str(&format!(
            "coord x{k}, y{k}, a{k};
            kinetic = kinetic_energy(m, dot(x{k})) + kinetic_energy(m, dot(y{k})) + kinetic_energy(j, dot(a{k}));
            potential = m * g * y{k};
            let (ex{k}, ey{k}) = (x{k} + l/2 * sin(a{k}), y{k} - l/2 * cos(a{k}));
            constraint jx{k} = x{k} - l/2 * sin(a{k}) - ex{before};
            constraint jy{k} = y{k} + l/2 * cos(a{k}) - ey{before};\n"
        ));
    }
    text
}

/// Returns `n` windows of four bars each, by the positions of their joints. Neighbours share a bar,
/// whose mass couples them.
fn windows(n: usize) -> String {
    let mut text =
        "param m = 1.0, g = 9.81;\nlet (x0, y0) = (0, 1);\nlet (u0, w0) = (0 * t, 0 * t);\n".to_owned();
    for k in 1..=n {
        let before = k - 1;
        text.push_str(&format!(
            "coord x{k}, y{k};
            kinetic = kinetic_energy(m / 3, dot(x{k})) + kinetic_energy(m / 3, dot(y{k}));
            let (u{k}, w{k}) = (dot(x{k}), dot(y{k}));
            kinetic = m / 6 * (u{k} * u{before} + w{k} * w{before} + u{k}^2 + w{k}^2);
            potential = m * g * y{k};
            constraint crank{k} = hypot(x{k} - {k}, y{k}) - 1;
            constraint coupler{k} = hypot(x{k} - x{before}, y{k} - y{before}) - 1;\n"
        ));
    }
    // The last joint is free to fall on.
    text.push_str(&format!("coord s; kinetic = kinetic_energy(m, dot(s - x{n}));"));
    text
}

fn operations(text: &str) -> usize {
    let system = parse(text).unwrap_or_else(|report| panic!("{report}"));
    let derived = system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}"));
    let roots = [&derived.equations.accelerations[..], &derived.equations.constraints.multipliers].concat();
    let program = lower(&derived.model.graph, &roots, &Labels::default());
    OperationCounts::of(&optimise(&program, derived.model.accuracy)).total()
}

#[test]
fn chains_of_constrained_bodies_cost_in_proportion_to_their_length() {
    for (name, chain) in [("rods", hanging_rods as fn(usize) -> String), ("windows", windows)] {
        let [one, two, three] = [8, 16, 24].map(|n| operations(&chain(n)));
        println!("{name}: {one} {two} {three}");
        let growth = (three - two) as f64 / (two - one) as f64;
        assert!((growth - 1.0).abs() < 0.1, "{name}: {one}, {two}, {three}");
    }
}

/// Three constraints restrict one direction, which depends on a parameter: in space along an axis,
/// with one joint or two, and as plain statements. They are tested with and without inertia, beside
/// other bodies and alone, where constraints outnumber coordinates. The motion is that under one
/// constraint, with the smallest of all possible forces.
#[test]
fn constraints_that_always_depend_on_each_other_share_their_force() {
    const BODY: &str = "mass: 1; inertia: (1, 1, 1);";
    let space = |(bodies, joints): (&str, &str)| {
        let bodies = bodies.chars().map(|name| format!("body {name} {{ {BODY} }}")).collect::<String>();
        format!("gravity = (0, 0, -9.81); param c = 0.5; {bodies} {joints}")
    };
    let plain = |kinetic: &str| {
        let y = if kinetic.contains('y') { ", y" } else { "" };
        format!(
            "param c = 0.5; coord s, x{y}; kinetic = {kinetic}; potential = s + x;
            constraint first = (s + x) * cos(c);
            constraint second = (s + x) * sin(c);
            constraint third = (s + x) * (cos(0.3) + 0.7 * sin(c));"
        )
    };
    let cylinder = "cylindrical (q, s) = ground to a { turned: (0.3, 0.4, c); } pin a.center to (0, 0, 0);";
    let sliders = "prismatic s = ground to a { axis: (c, c^2, sin(c)); } prismatic r = a to b { axis: (c, c^2, sin(c)); }
        pin b.center to (0, 0, 0);";
    let [cylinder_beside, sliders_beside] =
        [format!("{cylinder} free b; free d;"), format!("{sliders} free d;")];
    let spatial_cases =
        [("abd", &*cylinder_beside), ("abd", &*sliders_beside), ("a", cylinder), ("ab", sliders)];
    // The squared force over its vertical component is the weight that it holds.
    let rows = [0.5_f64.cos(), 0.5_f64.sin(), 0.3_f64.cos() + 0.7 * 0.5_f64.sin()];
    let square = rows.iter().map(|row| row * row).sum::<f64>();
    let shares = |force: f64| rows.map(|row| force * row / square);
    let plain_cases = [
        ("1/2 * (dot(s)^2 + dot(x)^2 + dot(y)^2)", 1.0),
        ("1/2 * (dot(s)^2 + dot(s + x)^2 + dot(y - x)^2 + dot(x)^2)", 1.0),
        ("1/2 * (dot(x)^2 + dot(y)^2)", 1.0),
        ("1/2 * (dot(s)^2 + dot(x)^2)", 1.0),
        ("1/2 * dot(x)^2", 1.0),
    ];
    for choice in [StrategyChoice::Always(Strategy::MassMatrix), StrategyChoice::Cheapest] {
        let solve = |text: &str| {
            let derived = parse(text).and_then(|system| system.derive(choice));
            let derived = derived.unwrap_or_else(|report| panic!("{text}, {choice:?}: {report}"));
            let [positions, speeds] = [derived.model.coordinates.len(), derived.model.speeds.len()];
            let (mut q, v) = (vec![0.0; positions], vec![0.0; speeds]);
            // Quaternions of free bodies, which stand last.
            (1..=(positions - speeds)).for_each(|body| q[positions - 7 * body + 3] = 1.0);
            let system = NumericSystem::new(&derived);
            (system.acceleration(0.0, &q, &v), system.multipliers(0.0, &q, &v))
        };
        for (kinetic, force) in plain_cases {
            let (accelerations, multipliers) = solve(&plain(kinetic));
            assert!((accelerations[0] + accelerations[1]).abs() < 1e-12, "{kinetic}: {accelerations:?}");
            assert_near(&multipliers, &shares(force), kinetic);
        }
        for case in spatial_cases {
            let (accelerations, multipliers) = solve(&space(case));
            assert!(accelerations.iter().all(|entry| entry.is_finite()), "{case:?}: {accelerations:?}");
            let square = multipliers.iter().map(|force| force * force).sum::<f64>();
            assert_near(&[square], &[9.81 * multipliers[2].abs()], case.1);
        }
    }
}
