//! Interpreted systems against reference values of an independent derivation with many digits; see
//! `tests/oracle/README.md`.

#[cfg(unix)]
#[path = "oracle/kernels.rs"]
mod kernels;
#[path = "../../tests/oracle/reference.rs"]
mod reference;

use std::path::Path;

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::expr::ExprId;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};
use lagrange_core::program::{Labels, OperationCounts, lower, optimise};

use reference::{Reference, Subject, names};

const CHOICES: [StrategyChoice; 4] = [
    StrategyChoice::Always(Strategy::MassMatrix),
    StrategyChoice::Always(Strategy::ArticulatedBody),
    StrategyChoice::Always(Strategy::SumOfSquares),
    StrategyChoice::Cheapest,
];

#[test]
fn every_strategy_agrees_with_the_references() {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/oracle"));
    let mut failures = Vec::new();
    for name in names(directory) {
        let reference = Reference::read(directory, &name);
        for choice in CHOICES {
            let found = reference.failures(&numeric(&reference, choice));
            failures.extend(found.iter().map(|failure| format!("{name}, {choice:?}, {failure}")));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// The equations must not divide by a sine or a cosine that vanishes. The reference is inverse
/// dynamics, which never divides.
#[test]
fn right_angles_are_no_singularities() {
    const REGULAR: [&str; 9] = [
        "bead_on_rotating_hoop",
        "cart_pole",
        "cart_two_pendulums",
        "chain10_absolute",
        "chain4_relative",
        "double_pendulum",
        "furuta_pendulum",
        "pendulum",
        "vibrating_pivot",
    ];
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/oracle"));
    for name in REGULAR {
        let reference = Reference::read(directory, name);
        for choice in CHOICES {
            let system = numeric(&reference, choice);
            let n = system.degrees_of_freedom();
            for (first, step) in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0), (2.0, 3.0), (3.0, 0.0)] {
                let quarter_turns = (0..n).map(|i| first + step * i as f64);
                let q = quarter_turns.map(|turns| turns * std::f64::consts::FRAC_PI_2).collect::<Vec<_>>();
                let v = (0..n).map(|i| 0.5 - 0.25 * i as f64).collect::<Vec<_>>();
                let a = system.acceleration(0.25, &q, &v);
                let residual = system.inverse_dynamics(0.25, &q, &v, &a).expect("derived by default");
                let scale = a.iter().fold(1.0_f64, |largest, value| largest.max(value.abs()));
                let worst = residual.iter().fold(0.0_f64, |worst, value| worst.max(value.abs() / scale));
                assert!(worst < 1e-12 && scale.is_finite(), "{name}, {choice:?}, {q:?}: {residual:?}");
            }
        }
    }
}

/// The momenta, which agree with the references, change along the motion at their declared rates.
#[test]
fn momenta_change_at_their_rates() {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/oracle"));
    for name in names(directory) {
        let reference = Reference::read(directory, &name);
        let system = numeric(&reference, StrategyChoice::Cheapest);
        for state in reference.states() {
            let product = |product, q: &[f64], v: &[f64], t| {
                system.product(product, t, q, v).unwrap_or_else(|| panic!("{name} has {product:?}"))
            };
            let acceleration = system.acceleration(state.t, &state.q, &state.v);
            let momenta = |h: f64| {
                let moved = |x: &[f64], rate: &[f64]| {
                    x.iter().zip(rate).map(|(x, rate)| x + h * rate).collect::<Vec<_>>()
                };
                let (q, v) = (moved(&state.q, &state.v), moved(&state.v, &acceleration));
                product(Product::Momenta, &q, &v, state.t + h)
            };
            let h = 1e-3 / state.v.iter().chain(&acceleration).fold(1.0, |a: f64, b| a.max(b.abs()));
            let [before, near, after, far] = [-2.0, -1.0, 1.0, 2.0].map(|steps| momenta(steps * h));
            let rates = product(Product::MomentumRates, &state.q, &state.v, state.t);
            let scale = rates.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
            for (i, rate) in rates.iter().enumerate() {
                let slope = (8.0 * (after[i] - near[i]) - (far[i] - before[i])) / (12.0 * h);
                assert!((rate - slope).abs() < 1e-7 * scale, "{name}, t = {}: {rate} or {slope}", state.t);
            }
        }
    }
}

/// Otherwise implicit methods would do better with differences of the right-hand side. These cost
/// an evaluation for each entry of the state, beside the one needed anyway.
#[test]
fn jacobians_cost_less_than_differences() {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/oracle"));
    for name in names(directory) {
        let text = format!("{} emit {{ jacobian }}", Reference::read(directory, &name).declaration);
        let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        let derived = derived.unwrap_or_else(|report| panic!("{report}"));
        let (model, equations) = (&derived.model, &derived.equations);
        let operations = |roots: &[ExprId]| {
            let program = lower(&model.graph, roots, &Labels::default());
            OperationCounts::of(&optimise(&program, model.accuracy)).total()
        };
        let jacobian = equations.product(Product::Jacobian, model).expect("it is asked for");
        let (found, differences) =
            (operations(&jacobian), 2 * model.coordinates.len() * operations(&equations.accelerations));
        println!("{name}: {found} operations beside {differences}");
        assert!(found < differences, "{name}: {found} operations, {differences} for differences");
    }
}

fn numeric(reference: &Reference, choice: StrategyChoice) -> NumericSystem {
    let text = format!("{} emit {{ momentum_rates }}", reference.declaration);
    let derived = parse(&text).and_then(|system| system.derive(choice));
    let derived = derived.unwrap_or_else(|report| panic!("{report}"));
    if let StrategyChoice::Always(strategy) = choice {
        let is_without_squares =
            strategy == Strategy::SumOfSquares && derived.equations.strategy == Strategy::MassMatrix;
        assert!(derived.equations.strategy == strategy || is_without_squares);
    }
    let mut system = NumericSystem::new(&derived);
    for (name, value) in reference.settings() {
        assert!(system.set(name, value), "{name} is declared");
    }
    system
}

impl Subject for NumericSystem {
    fn acceleration(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        self.acceleration(t, q, v)
    }

    fn quantity(&self, key: &str, t: f64, q: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        let product = match key {
            "forcing" => Product::Forcing,
            "mass_matrix" => Product::MassMatrix,
            "momenta" => Product::Momenta,
            "energy" => Product::Energy,
            "kinetic" => Product::KineticEnergy,
            "potential" => Product::PotentialEnergy,
            _ => return None,
        };
        self.product(product, t, q, v)
    }

    fn inverse_dynamics(&self, t: f64, q: &[f64], v: &[f64], a: &[f64]) -> Vec<f64> {
        self.inverse_dynamics(t, q, v, a).expect("inverse dynamics are derived by default")
    }
}
