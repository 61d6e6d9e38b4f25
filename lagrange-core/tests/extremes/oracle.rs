//! The reference against another derivation: the values of `tests/oracle`, which have 32 digits.

use std::fs;
use std::path::Path;

use lagrange_core::symbol::Role;
use serde_json::Value;

use crate::digits::{Arithmetic, Real, approximate};
use crate::reference::Reference;

/// The last digits of the files are rounded, and energies are computed as differences.
const PRINTED: f64 = 1e-28;

#[test]
fn the_reference_agrees_with_another_derivation() {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/oracle"));
    let entries = fs::read_dir(directory).expect("the directory of references");
    let paths = entries.map(|entry| entry.expect("a readable entry").path());
    let mut compared = 0;
    for path in paths.filter(|path| path.extension().is_some_and(|extension| extension == "lag")) {
        let text = |path: &Path| fs::read_to_string(path).expect("readable text");
        let values: Value = serde_json::from_str(&text(&path.with_extension("json"))).expect("valid JSON");
        let reference = Reference::new(&text(&path));
        for state in values["states"].as_array().expect("a list of states") {
            let truth = reference
                .at(|role, arithmetic| arithmetic.decimal(printed(&reference, &values, state, role)));
            let truth = truth.expect("a regular state");
            check(&truth.accelerations, &state["acceleration"]);
            check(&[truth.energy], &Value::Array(vec![state["energy"].clone()]));
            compared += 1;
        }
    }
    assert!(compared > 0, "there are states");
}

fn printed<'a>(reference: &Reference, values: &'a Value, state: &'a Value, role: Role) -> &'a str {
    let model = &reference.model;
    let value = match role {
        Role::Parameter(i) => &values["params"][&model.parameters[i as usize].name],
        Role::Input(i) => &values["inputs"][&model.inputs[i as usize].name],
        Role::Time => &state["t"],
        Role::Coordinate(i) => &state["q"][i as usize],
        Role::Velocity(i) => &state["v"][i as usize],
        Role::Acceleration(_)
        | Role::Multiplier(_)
        | Role::Reaction(_)
        | Role::Noise(_)
        | Role::Side(_)
        | Role::State(_)
        | Role::Discrete(_)
        | Role::Operand(_)
        | Role::Placeholder(_) => &Value::Null,
    };
    value.as_str().expect("a number in quotes")
}

/// Compares a vector relative to its largest entry.
fn check(found: &[Real], printed: &Value) {
    let mut arithmetic = Arithmetic::new(256);
    let printed = printed.as_array().expect("a vector");
    assert_eq!(found.len(), printed.len());
    let exact = printed.iter().map(|value| arithmetic.decimal(value.as_str().expect("a number in quotes")));
    let exact = exact.collect::<Vec<_>>();
    let largest = exact.iter().fold(0.0, |largest: f64, value| largest.max(approximate(value).abs()));
    for (found, exact) in found.iter().zip(&exact) {
        let error = approximate(&arithmetic.subtract(found, exact)).abs();
        assert!(error <= PRINTED * largest, "off by {error:e} of {largest:e}");
    }
}
