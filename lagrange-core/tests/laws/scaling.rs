//! Units do not matter: accelerations of systems whose masses, forces and stiffnesses are all multiplied by a power of two are the
//! same to the last bit, at every level of accuracy and by every strategy.

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::pipeline::{NumericSystem, parse};

/// A declaration, names of parameters that are proportional to masses, and of those that are proportional to lengths.
struct Subject {
    name: &'static str,
    declaration: &'static str,
    masses: &'static [&'static str],
    lengths: &'static [&'static str],
}

const SUBJECTS: [Subject; 14] = [
    Subject {
        name: "double pendulum",
        declaration: include_str!("../../../tests/extremes/double_pendulum.lag"),
        masses: &["m1", "m2"],
        lengths: &["l1", "l2", "g"],
    },
    Subject {
        name: "triple pendulum",
        declaration: include_str!("../../../tests/extremes/triple_pendulum.lag"),
        masses: &["m1", "m2", "m3"],
        lengths: &["l1", "l2", "l3", "g"],
    },
    Subject {
        name: "branching tree",
        declaration: include_str!("../../../tests/extremes/branching_tree.lag"),
        masses: &["m1", "m2", "m3"],
        lengths: &["l1", "l2", "l3", "g"],
    },
    Subject {
        name: "relative pendulum",
        declaration: include_str!("../../../tests/extremes/relative_pendulum.lag"),
        masses: &["m1", "m2", "m3"],
        lengths: &["l1", "l2", "l3", "g"],
    },
    Subject {
        name: "written-out pendulum",
        declaration: include_str!("../../../tests/extremes/written_out_pendulum.lag"),
        masses: &["m1", "m2"],
        lengths: &["l1", "l2", "g"],
    },
    Subject {
        name: "two-link arm",
        declaration: include_str!("../../../tests/extremes/two_link_arm.lag"),
        masses: &["m1", "m2", "j1", "j2"],
        lengths: &[],
    },
    Subject {
        name: "cart-pole",
        declaration: include_str!("../../../tests/extremes/cart_pole.lag"),
        masses: &["mc", "mp"],
        lengths: &[],
    },
    Subject {
        name: "spring pendulum",
        declaration: include_str!("../../../tests/extremes/spring_pendulum.lag"),
        masses: &["m", "k"],
        lengths: &[],
    },
    Subject {
        name: "rolling ball",
        declaration: include_str!("../../../tests/extremes/rolling_ball.lag"),
        masses: &["m", "mc"],
        lengths: &["r", "R", "g"],
    },
    Subject {
        name: "arm in space",
        declaration: include_str!("../../../tests/extremes/space/arm.lag"),
        masses: &["m1", "m2", "m3", "m4"],
        lengths: &["l1", "l2", "l3", "l4", "g"],
    },
    Subject {
        name: "universal joint and hinge",
        declaration: include_str!("../../../tests/extremes/space/universal_arm.lag"),
        masses: &["m1", "m2", "m3"],
        lengths: &["l1", "l2", "l3", "g"],
    },
    Subject {
        name: "coupled line",
        declaration: "param a = 3, b = 1; coord x, y;
            kinetic = 1/2*a*dot(x)^2 + 1/2*a*dot(y)^2 + b*dot(x)*dot(y); potential = a*(y + x);",
        masses: &["a", "b"],
        lengths: &[],
    },
    Subject { name: "chain of five", declaration: CHAIN, masses: &["j"], lengths: &[] },
    Subject {
        name: "damped oscillators",
        declaration: "param m0 = 1, m1 = 2, m2 = 3, k = 5, c = 0.3, f = 2; input push = 1.5; coord x[3];
            kinetic = kinetic_energy(m0, dot(x[0])) + kinetic_energy(m1, dot(x[1])) + kinetic_energy(m2, dot(x[2]));
            kinetic = 1/2 * m0 * (dot(x[0]) + dot(x[1]) * sin(x[2]) + dot(x[2]))^2;
            potential = spring_energy(k, x[0] - x[1]) + spring_energy(k, x[1] - x[2]);
            dissipation = 1/2 * c * (dot(x[1]) - dot(x[2]))^2; force x[0] = push + f * cos(x[1]);",
        masses: &["m0", "m1", "m2", "k", "c", "f", "push"],
        lengths: &[],
    },
];

/// Five rods, each of which feels all that it carries.
const CHAIN: &str = "param j = 1; coord x0, x1, x2, x3, x4;
    kinetic = 1/2*5*j*dot(x0)^2 + 1/2*4*j*dot(x1)^2 + 1/2*3*j*dot(x2)^2 + 1/2*2*j*dot(x3)^2 + 1/2*1*j*dot(x4)^2
        + 4*j*cos(x0-x1)*dot(x0)*dot(x1) + 3*j*cos(x0-x2)*dot(x0)*dot(x2) + 2*j*cos(x0-x3)*dot(x0)*dot(x3)
        + 1*j*cos(x0-x4)*dot(x0)*dot(x4) + 3*j*cos(x1-x2)*dot(x1)*dot(x2) + 2*j*cos(x1-x3)*dot(x1)*dot(x3)
        + 1*j*cos(x1-x4)*dot(x1)*dot(x4) + 2*j*cos(x2-x3)*dot(x2)*dot(x3) + 1*j*cos(x2-x4)*dot(x2)*dot(x4)
        + 1*j*cos(x3-x4)*dot(x3)*dot(x4);
    potential = 0 - 5*j*9.81*cos(x0) - 4*j*9.81*cos(x1) - 3*j*9.81*cos(x2) - 2*j*9.81*cos(x3) - 1*j*9.81*cos(x4);";

/// Powers of two by which masses are multiplied.
const MASS_POWERS: [i32; 8] = [-900, -540, -300, -140, 140, 300, 540, 900];
/// Powers of two by which lengths are multiplied. Forces are quadratic in lengths, and squares of moments of inertia of the fourth degree.
const LENGTH_POWERS: [i32; 4] = [-160, -70, 70, 160];

fn systems(subject: &Subject) -> Vec<(String, NumericSystem)> {
    let mut systems = Vec::new();
    for level in ["fast", "standard", "strict"] {
        let text = format!("#[accuracy({level})] struct Subject; {}", subject.declaration);
        let always = Strategy::ALL.map(StrategyChoice::Always);
        for choice in always.into_iter().chain([StrategyChoice::Cheapest]) {
            let derived = parse(&text).and_then(|parsed| parsed.derive(choice));
            let derived = derived.unwrap_or_else(|report| panic!("{}: {report}", subject.name));
            systems.push((format!("{}, {level}, {choice:?}", subject.name), NumericSystem::new(&derived)));
        }
    }
    systems
}

/// Numbers between −1 and 1, spread evenly.
fn spread(count: usize, seed: usize) -> Vec<f64> {
    (1..=count).map(|i| 2.0 * (((i + 7 * seed) as f64) * 0.618_033_988_749_895).fract() - 1.0).collect()
}

fn scaled(system: &NumericSystem, names: &[&str], values: &[f64], power: i32) -> NumericSystem {
    let mut system = system.clone();
    for (name, value) in names.iter().zip(values) {
        assert!(system.set(name, value * 2_f64.powi(power / 2) * 2_f64.powi(power - power / 2)), "{name}");
    }
    system
}

fn violations(subject: &Subject) -> Vec<String> {
    let mut found = Vec::new();
    for (way, system) in systems(subject) {
        let n = system.degrees_of_freedom();
        for seed in 0..3 {
            let (q, v) = (spread(n, seed), spread(n, seed + 5));
            let masses = spread(subject.masses.len(), seed + 9).iter().map(|x| 1.5 + x).collect::<Vec<_>>();
            let lengths = spread(subject.lengths.len(), seed + 2).iter().map(|x| 1.5 + x).collect::<Vec<_>>();
            let of = |mass: i32, length: i32| {
                let system = scaled(&system, subject.masses, &masses, mass);
                scaled(&system, subject.lengths, &lengths, length).acceleration(0.0, &q, &v)
            };
            let expected = of(0, 0);
            assert!(expected.iter().all(|a| a.is_finite()), "{way}: {expected:?}");
            let powers = MASS_POWERS.map(|power| (power, 0)).into_iter();
            let lengths = LENGTH_POWERS.map(|power| (0, power)).into_iter();
            let lengths = lengths.filter(|_| !subject.lengths.is_empty());
            let both = [(-700, 100), (700, -100)].into_iter().filter(|_| !subject.lengths.is_empty());
            for (mass, length) in powers.chain(lengths).chain(both) {
                let found_there = of(mass, length);
                if found_there != expected {
                    found.push(format!("{way}, 2^{mass}, 2^{length}: {found_there:?} for {expected:?}"));
                }
            }
        }
    }
    found
}

#[test]
fn units_of_mass_and_length_do_not_matter() {
    let found = SUBJECTS.iter().flat_map(violations).collect::<Vec<_>>();
    assert!(found.is_empty(), "{}:\n{}", found.len(), found.join("\n"));
}
