//! Constrained systems, interpreted, against reference values that an independent derivation computed with many digits.

use std::fs;
use std::path::Path;

use lagrange_core::mechanics::{Road, RoadChoice};
use lagrange_core::pipeline::{NumericSystem, parse};
use serde_json::Value;

const NAMES: [&str; 4] = ["andrews_squeezer", "chaplygin_sleigh", "cylinder_on_slope", "ladder_on_wall"];
const CHOICES: [RoadChoice; 3] =
    [RoadChoice::Always(Road::Dense), RoadChoice::Always(Road::Recursive), RoadChoice::Cheapest];

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
fn accelerations_and_multipliers_agree_with_the_references_on_every_road() {
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
