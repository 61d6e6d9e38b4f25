//! Interpreted systems against reference values that an independent derivation computed with many digits;
//! see `tests/oracle/README.md`.

#[path = "../../tests/oracle/reference.rs"]
mod reference;

use std::path::Path;

use lagrange_core::mechanics::{Product, Road, RoadChoice};
use lagrange_core::pipeline::{NumericSystem, parse};

use reference::{Reference, Subject, names};

const CHOICES: [RoadChoice; 3] =
    [RoadChoice::Always(Road::Dense), RoadChoice::Always(Road::Recursive), RoadChoice::Cheapest];

#[test]
fn every_road_agrees_with_the_references() {
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

fn numeric(reference: &Reference, choice: RoadChoice) -> NumericSystem {
    let derived = parse(&reference.declaration).and_then(|system| system.derive(choice));
    let derived = derived.unwrap_or_else(|report| panic!("{report}"));
    let road = derived.equations.road;
    assert!(choice == RoadChoice::Cheapest || choice == RoadChoice::Always(road));
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
