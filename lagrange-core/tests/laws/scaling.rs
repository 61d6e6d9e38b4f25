//! Units do not matter: if all masses are multiplied by one power of two and all lengths by
//! another, only exponents change.
//!
//! This holds for accelerations, multipliers and all products, each with the powers of mass and
//! length in its own unit. It holds at every level of accuracy and by every strategy, bit by bit.
//! It ends where the range of numbers does. Where m l² overflows, the mass matrix is not
//! representable, and derivatives contain up to the fifth power of a length beside a mass. So
//! masses are multiplied by 2^a and lengths by 2^b with |a| + 5 |b| ≤ 900. Subnormal numbers have
//! fewer digits, so results below the least normal one are ignored.

mod subjects;

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::model::{Extent, Product};
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::ProptestConfig;

use self::subjects::{Subject, constrained, dependent, free};
use super::random::Random;

/// The largest power of two in any unit.
const LARGEST: i32 = 900;

/// Products whose components have units.
const PRODUCTS: [Product; 19] = [
    Product::MassMatrix,
    Product::InverseMassMatrix,
    Product::CoriolisMatrix,
    Product::Forcing,
    Product::Bias,
    Product::Momenta,
    Product::MomentumRates,
    Product::KineticEnergy,
    Product::PotentialEnergy,
    Product::Energy,
    Product::InverseDynamics,
    Product::InverseDynamicsJacobian,
    Product::Constraints,
    Product::ConstraintVelocity,
    Product::ConstraintJacobian,
    Product::ConstraintForces,
    Product::Jacobian,
    Product::TangentJacobian,
    Product::ParameterJacobian,
];

/// Powers of two that multiply masses and lengths.
#[derive(Clone, Copy, Debug)]
struct Scale {
    mass: i32,
    length: i32,
}

impl Scale {
    const ONE: Scale = Scale { mass: 0, length: 0 };

    fn random(random: &mut Random) -> Scale {
        let mut power = |most: i32| random.below(2 * most as usize + 1) as i32 - most;
        let length = power(1) * power(1) * power(LARGEST / 5);
        let room = LARGEST - 5 * length.abs();
        let mass = if power(1) == 0 { power(1) * room } else { power(room) };
        Scale { mass, length }
    }

    /// Returns a number scaled by these powers of mass and length in its unit.
    fn of(self, value: f64, [mass, length]: [i32; 2]) -> f64 {
        let power = self.mass * mass + self.length * length;
        value * 2_f64.powi(power / 2) * 2_f64.powi(power - power / 2)
    }
}

/// A system derived in one way.
struct Way {
    name: String,
    system: NumericSystem,
}

fn ways(subject: &Subject) -> Vec<Way> {
    let mut ways = Vec::new();
    for level in ["fast", "standard", "strict"] {
        let names = PRODUCTS.iter().filter(|product| subject.has(**product)).map(|product| product.name());
        let names = names.collect::<Vec<_>>().join(", ");
        let text = format!("#[accuracy({level})] struct Subject; {} emit {{ {names} }}", subject.declaration);
        for choice in Strategy::ALL.map(StrategyChoice::Always).into_iter().chain([StrategyChoice::Cheapest])
        {
            let name = format!("{}, {level}, {choice:?}", subject.name);
            match (parse(&text).and_then(|parsed| parsed.derive(choice)), choice) {
                (Ok(derived), _) => ways.push(Way { name, system: NumericSystem::new(&derived) }),
                // Some strategies refuse coordinates without inertia.
                (Err(_), StrategyChoice::Always(_)) => {}
                (Err(report), StrategyChoice::Cheapest) => panic!("{name}: {report}"),
            }
        }
    }
    ways
}

/// A state and parameters before they are multiplied.
struct Motion {
    parameters: Vec<f64>,
    /// Positions, velocities and accelerations.
    vectors: [Vec<f64>; 3],
}

impl Motion {
    fn random(subject: &Subject, random: &mut Random) -> Motion {
        let parameters = subject.parameters.iter().map(|_| random.between(0.5, 2.5)).collect();
        let mut vector = |size: f64| {
            let entry = |_: &i32| size * random.between(-1.0, 1.0);
            subject.coordinates.iter().map(entry).collect::<Vec<_>>()
        };
        Motion { parameters, vectors: [vector(subject.spread), vector(subject.spread), vector(1.0)] }
    }
}

/// Numbers with the powers of mass and length in their units.
struct Results {
    name: &'static str,
    values: Vec<f64>,
    units: Vec<[i32; 2]>,
}

fn results(subject: &Subject, system: &NumericSystem, motion: &Motion, scale: Scale) -> Vec<Results> {
    let mut system = system.clone();
    for ((name, unit), value) in subject.parameters.iter().zip(&motion.parameters) {
        assert!(system.set(name, scale.of(*value, *unit)), "{}: {name}", subject.name);
    }
    let lengths = subject.units(Extent::Velocities);
    let [q, v, a] = motion
        .vectors
        .each_ref()
        .map(|vector| vector.iter().zip(&lengths).map(|(x, unit)| scale.of(*x, *unit)).collect::<Vec<_>>());
    let mut results = vec![
        Results { name: "acceleration", values: system.acceleration(0.0, &q, &v), units: lengths },
        Results {
            name: "multipliers",
            values: system.multipliers(0.0, &q, &v),
            units: subject.multipliers(),
        },
    ];
    for product in PRODUCTS {
        let values = match product {
            Product::InverseDynamics => system.inverse_dynamics(0.0, &q, &v, &a),
            Product::InverseDynamicsJacobian => system.inverse_dynamics_jacobian(0.0, &q, &v, &a),
            _ => system.product(product, 0.0, &q, &v),
        };
        let found =
            values.map(|values| Results { name: product.name(), values, units: subject.units_of(product) });
        results.extend(found);
    }
    results
}

/// Asserts the law for a system in one way at a random state.
fn assert_units_do_not_matter(subject: &Subject, way: &Way, seed: u64) {
    let mut random = Random::of_case(seed);
    let motion = Motion::random(subject, &mut random);
    let expected = results(subject, &way.system, &motion, Scale::ONE);
    for _ in 0..3 {
        let scale = Scale::random(&mut random);
        let found = results(subject, &way.system, &motion, scale);
        for (Results { name, values, units }, found) in expected.iter().zip(&found) {
            assert_eq!(values.len(), units.len(), "{}: {name}", way.name);
            for (i, (value, unit)) in values.iter().zip(units).enumerate() {
                let (scaled, found) = (scale.of(*value, *unit), found.values[i]);
                let is_out_of_range = value.is_normal() && !scaled.is_normal();
                // Derivatives are undefined where constraints become dependent in a single
                // configuration.
                let is_undefined = name.ends_with("jacobian") && value.is_nan() && found.is_nan();
                assert!(
                    scaled == found || is_out_of_range || is_undefined,
                    "{}, seed {seed}, {scale:?}: {name}[{i}] is {found:e} for {scaled:e}",
                    way.name
                );
            }
        }
    }
}

/// Asserts the law for random states, whose number `PROPTEST_CASES` scales.
fn assert_units_do_not_matter_to(subjects: Vec<Subject>) {
    let states = u64::from(ProptestConfig::default().cases / 256).max(1);
    for subject in subjects {
        for way in ways(&subject) {
            (0..states).for_each(|seed| assert_units_do_not_matter(&subject, &way, seed));
        }
    }
}

#[test]
fn units_do_not_matter_to_free_systems() {
    assert_units_do_not_matter_to(free());
}

#[test]
fn units_do_not_matter_to_constrained_systems() {
    assert_units_do_not_matter_to(constrained());
}

#[test]
fn units_do_not_matter_to_dependent_constraints() {
    assert_units_do_not_matter_to(dependent());
}
