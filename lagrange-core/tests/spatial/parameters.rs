//! Models of robots with masses, centroids and inertias as parameters: they move as with numbers,
//! and cost little more.

use lagrange_core::accuracy::Accuracy;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};
use lagrange_core::program::{Labels, OperationCounts, Preparation, Program, lower, optimise};

use crate::cases::{Case, cases, read};
use crate::comparison::{assert_none, failures};
use crate::motion::assert_near;
use crate::operations::costs_of;

/// Quantities of a model that become parameters.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Masses.
    Masses,
    /// Masses, centroids and tensors of inertia.
    Inertias,
    /// These and the positions of joints.
    Everything,
}

/// Returns a model in which every nonzero number of a kind is the default of a parameter.
fn with_parameters(model: &str, kind: Kind) -> String {
    let words: &[&str] = match kind {
        Kind::Masses => &["mass: "],
        Kind::Inertias => &["mass: ", "centroid: (", "inertia: ("],
        Kind::Everything => &["mass: ", "centroid: (", "inertia: (", "at: ("],
    };
    let mut parameters = Vec::new();
    let statements = model.lines().map(|line| {
        let mut line = line.to_owned();
        for word in words {
            if let Some((before, behind)) = line.split_once(word) {
                let end = behind.find([';', ')']).expect("an end of the numbers");
                let numbers = behind[..end].split(", ").map(|number| parameter(number, &mut parameters));
                let numbers = numbers.collect::<Vec<_>>().join(", ");
                line = format!("{before}{word}{numbers}{}", &behind[end..]);
            }
        }
        line
    });
    let statements = statements.collect::<Vec<_>>().join("\n");
    format!("param {};\n{statements}\n", parameters.join(", "))
}

fn parameter(number: &str, parameters: &mut Vec<String>) -> String {
    if number.parse::<f64>().is_ok_and(|number| number == 0.0) {
        return number.to_owned();
    }
    let name = format!("p{}", parameters.len());
    parameters.push(format!("{name} = {number}"));
    name
}

fn derived(text: &str) -> Derived {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    derived.unwrap_or_else(|report| panic!("{text}\n{report}"))
}

fn model(name: &str) -> String {
    read(&format!("models/{name}.lag"))
}

#[test]
fn robots_of_parameters_move_as_pinocchio_says() {
    for (name, kind) in [
        ("ur5", Kind::Masses),
        ("ur5", Kind::Inertias),
        ("ur5", Kind::Everything),
        ("panda", Kind::Masses),
        ("panda", Kind::Inertias),
        ("panda", Kind::Everything),
        ("universal_5", Kind::Masses),
        ("ball_2", Kind::Inertias),
    ] {
        let states = cases(&format!("models/{name}.txt")).pop().expect("a system");
        let case = Case { text: with_parameters(&model(name), kind), ..states };
        for level in ["standard", "strict"] {
            assert_none(&failures(&case, level, StrategyChoice::Cheapest));
        }
    }
}

#[test]
fn robots_of_parameters_move_as_those_of_numbers_where_all_is_zero() {
    for name in ["ur5", "panda"] {
        let numbers = NumericSystem::new(&derived(&model(name)));
        let parameters = NumericSystem::new(&derived(&with_parameters(&model(name), Kind::Inertias)));
        let zeros = vec![0.0; numbers.degrees_of_freedom()];
        let expected = numbers.acceleration(0.0, &zeros, &zeros);
        let scale = expected.iter().fold(1.0_f64, |scale, a| scale.max(a.abs()));
        assert_near(&parameters.acceleration(0.0, &zeros, &zeros), &expected, 1e-12 * scale, name);
    }
}

const TWO_LINKS: &str = "param m1 = 2, m2 = 1.5, c = 0.3, i1 = 0.2, j = 0.1, i2 = 0.4, i3 = 0.25;
    gravity = (0, 0, -9.81);
    body crank { mass: m1; centroid: (0, 0, 0.2); inertia: (i1, 0.3, 0.4); }
    revolute a = ground to crank { at: (0, 0, 1); }
    body rod { mass: m2; centroid: (0.3, 0, c); inertia: (j, i2, i3); }
    revolute b = crank to rod { at: (0, 0.7, 0); turned: (0.3, 0, pi/2); }";

/// Joints hide some masses and moments, which affect no acceleration. All others do.
#[test]
fn only_what_joints_hide_is_without_effect() {
    let mut system = NumericSystem::new(&derived(TWO_LINKS));
    let at = |system: &NumericSystem| system.acceleration(0.0, &[0.4, -1.1], &[1.3, 0.7]);
    let before = at(&system);
    for hidden in ["m1", "i1"] {
        assert!(system.set(hidden, 7.0));
        assert_near(&at(&system), &before, 1e-13, hidden);
    }
    for seen in ["m2", "c", "j", "i2", "i3"] {
        let mut changed = NumericSystem::new(&derived(TWO_LINKS));
        assert!(changed.set(seen, 0.7));
        let change = at(&changed).iter().zip(&before).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(change > 1e-3, "{seen}: {change}");
    }
}

/// Returns the operations of the accelerations at every call after preparing expressions of
/// parameters, and the number of prepared values with their operations.
fn prepared(text: &str) -> [usize; 3] {
    let derived = derived(text);
    let program = lower(&derived.model.graph, &derived.equations.accelerations, &Labels::default());
    let mut preparation = Preparation::new(derived.model.parameters.len() as u32);
    let total = |program: &Program| OperationCounts::of(&optimise(program, Accuracy::Standard)).total();
    let each = total(&preparation.prepare(&program));
    [each, preparation.len(), total(&preparation.finish())]
}

#[test]
fn prepared_robots_cost_no_more_operations_than_they_did() {
    println!("| model | accelerations of a prepared one | values | operations of these |\n|---|---|---|---|");
    for (name, most) in MAX_PREPARED {
        let found = prepared(&with_parameters(&model(name), Kind::Inertias));
        println!("| {name} | {} | {} | {} |", found[0], found[1], found[2]);
        assert!(found.iter().zip(most).all(|(cost, most)| *cost <= most), "{name}: {found:?}");
    }
}

/// Models with upper bounds on their costs: the measured costs plus 2 %.
const MAX_PREPARED: [(&str, [usize; 3]); 6] = [
    ("ur5", [528, 33, 72]),
    ("panda", [1163, 55, 235]),
    ("universal_5", [1225, 34, 46]),
    ("universal_10", [2908, 65, 87]),
    ("go2", [3235, 200, 616]),
    ("ball_5", [1397, 39, 54]),
];

/// Models with upper bounds on the cost of their accelerations, inverse dynamics and mass matrix,
/// with masses or all inertias as parameters. The bounds are the measured costs plus 2 %.
const MOST: [(&str, [[usize; 3]; 2]); 7] = [
    ("ur5", [[588, 358, 212], [600, 375, 225]]),
    ("panda", [[1340, 786, 494], [1399, 847, 551]]),
    ("universal_5", [[1251, 507, 609], [1271, 542, 606]]),
    ("universal_10", [[2939, 1099, 2563], [2995, 1169, 2555]]),
    ("go2", [[3792, 1912, 1608], [3851, 2036, 1520]]),
    ("go2_free", [[3838, 1899, 1403], [3884, 2022, 1355]]),
    ("ball_5", [[1374, 731, 1718], [1451, 767, 1739]]),
];

#[test]
fn robots_of_parameters_cost_no_more_operations_than_they_did() {
    println!(
        "| model | parameters | accelerations | inverse dynamics | mass matrix |\n|---|---|---|---|---|"
    );
    for (name, most) in MOST {
        for (kind, most) in [Kind::Masses, Kind::Inertias].into_iter().zip(most) {
            let costs = costs_of(&with_parameters(&model(name), kind));
            println!("| {name} | {kind:?} | {} | {} | {} |", costs[0], costs[1], costs[2]);
            assert!(costs.iter().zip(most).all(|(cost, most)| *cost <= most), "{name}, {kind:?}: {costs:?}");
        }
    }
}
