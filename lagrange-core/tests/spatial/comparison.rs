//! A derived system compared with its expected results.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::cases::{Case, State};

/// Relative error allowed where the equations are well conditioned.
const TOLERANCE: f64 = 1e-12;
/// Additional error per unit of the condition number: a few roundings.
const ROUNDING: f64 = 1e-15;

pub(crate) fn assert_none(wrong: &[String]) {
    assert!(wrong.is_empty(), "{}\n{} are wrong", wrong.join("\n"), wrong.len());
}

/// Returns descriptions of the differences between a system and its expected results.
pub(crate) fn failures(case: &Case, level: &str, choice: StrategyChoice) -> Vec<String> {
    let text = format!("#[accuracy({level})] struct System;\n{}", case.text);
    let derived = parse(&text).and_then(|system| system.derive(choice));
    let derived = match derived {
        Ok(derived) => derived,
        Err(report) => return vec![format!("{}: {report}\n{text}", case.name)],
    };
    let system = NumericSystem::new(&derived);
    let states = case.states.iter().enumerate();
    let wrong = states.flat_map(|(index, state)| {
        let wrong = wrong_results(&system, state).into_iter();
        wrong.map(move |what| format!("{}, {level}, {choice:?}, state {index}: {what}", case.name))
    });
    wrong.collect()
}

fn wrong_results(system: &NumericSystem, state: &State) -> Vec<String> {
    let t = state.number("state").expect("a time");
    let [q, v, wanted] = ["q", "v", "wanted"].map(|word| state.numbers(word));
    let solved = TOLERANCE.max(ROUNDING * state.number("condition").unwrap_or(0.0));
    let mut wrong = Vec::new();
    let mut compare = |what: &str, found: Option<Vec<f64>>, expected: &[f64], tolerance: f64| {
        if !expected.is_empty() {
            wrong
                .extend(difference(found.as_deref(), expected, tolerance).map(|how| format!("{what} {how}")));
        }
    };
    let results = [
        ("accelerations", Some(system.acceleration(t, q, v)), solved),
        ("multipliers", Some(system.multipliers(t, q, v)), solved),
        ("inverse_dynamics", system.inverse_dynamics(t, q, v, wanted), TOLERANCE),
        ("mass_matrix", system.product(Product::MassMatrix, t, q, v), TOLERANCE),
        ("kinetic", system.product(Product::KineticEnergy, t, q, v), TOLERANCE),
        ("potential", system.product(Product::PotentialEnergy, t, q, v), TOLERANCE),
    ];
    for (what, found, tolerance) in results {
        compare(what, found, state.numbers(what), tolerance);
    }
    for (name, expected) in state.outputs() {
        compare(name, system.output(name, t, q, v), expected, solved);
    }
    wrong
}

/// Returns the distance of numbers from their expected values, unless it is within the tolerance of
/// the largest of them or of one.
fn difference(found: Option<&[f64]>, expected: &[f64], tolerance: f64) -> Option<String> {
    let Some(found) = found else { return Some("missing".to_owned()) };
    if found.len() != expected.len() {
        return Some(format!("{found:?}, not {expected:?}"));
    }
    let largest = expected.iter().fold(1.0_f64, |largest, value| largest.max(value.abs()));
    let errors = found.iter().zip(expected).map(|(found, expected)| (found - expected).abs() / largest);
    let worst = errors.fold(0.0_f64, |worst, error| if error <= worst { worst } else { error });
    (worst.is_nan() || worst > tolerance)
        .then(|| format!("off by {worst:.1e} (allowed {tolerance:.1e}): {found:?}, not {expected:?}"))
}
