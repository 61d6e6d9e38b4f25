//! Regressors of public robots against Pinocchio, column by column, written by
//! `tools/regressors.py`.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::cases::{Case, State, cases, read};

/// Error relative to the largest entry of a state's regressor.
const TOLERANCE: f64 = 2e-15;

fn numeric(name: &str, level: &str) -> NumericSystem {
    let declared = read(&format!("models/{name}.lag"));
    let text = format!("#[accuracy({level})] struct Robot; {declared} emit {{ regressor }}");
    let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{name}: {report}")))
}

/// Files omit columns of zeros, and structural zeros have no columns.
fn assert_columns(system: &NumericSystem, state: &State, expected: &[(String, Vec<f64>)]) {
    let [q, v, wanted] = ["q", "v", "wanted"].map(|word| state.numbers(word));
    let names = &system.programs().variables.regressor;
    let regressor = system.regressor(0.0, q, v, wanted).expect("it is requested");
    let column = |k: usize| regressor.iter().skip(k).step_by(names.len()).copied().collect::<Vec<_>>();
    let largest = expected.iter().flat_map(|(_, column)| column).fold(1.0, |a: f64, b| a.max(b.abs()));
    for (name, expected) in expected {
        let found = names.iter().position(|known| known == name).map(column);
        let found = found.unwrap_or_else(|| panic!("no column {name} in {names:?}"));
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < TOLERANCE * largest, "{name}: {found} {expected}");
        }
    }
    let parameters = system.regressor_parameters();
    let torques = system.inverse_dynamics(0.0, q, v, wanted).expect("it is emitted");
    for (torque, row) in torques.iter().zip(regressor.chunks_exact(names.len())) {
        let product = row.iter().zip(&parameters).map(|(y, p)| y * p).sum::<f64>();
        assert!((torque - product).abs() < 1e-14 * largest.max(torque.abs()), "{torque} {product}");
    }
}

fn assert_agreement(case: &Case, level: &str) {
    let system = numeric(&case.name, level);
    assert!(!case.states.is_empty());
    for state in &case.states {
        let expected = state.columns().map(|(name, column)| (name.to_owned(), column.to_vec()));
        let expected = expected.collect::<Vec<_>>();
        assert!(expected.len() > 10, "{}", case.name);
        assert_columns(&system, state, &expected);
    }
}

#[test]
fn regressors_are_those_of_pinocchio() {
    for case in cases("regressors.txt") {
        assert_agreement(&case, "standard");
    }
}

#[test]
fn under_strict_regressors_are_the_same() {
    for case in cases("regressors.txt").iter().filter(|case| case.name != "go2_free") {
        assert_agreement(case, "strict");
    }
}
