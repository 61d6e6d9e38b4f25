//! Motions that are determined although a pivot vanishes: zero masses under constraints, disabled
//! inertia, and indefinite Lagrangians.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse};
use proptest::prelude::{prop, prop_assert, prop_assume, proptest};

fn numeric(text: &str) -> NumericSystem {
    let derived = parse(text).and_then(|parsed| parsed.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}{text}")))
}

fn assert_near(found: &[f64], expected: &[f64], what: &str) {
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-12;
    assert!(found.len() == expected.len() && found.iter().zip(expected).all(is_near), "{what}: {found:?}");
}

/// x and y have the same acceleration, and only y has a mass.
#[test]
fn constraints_make_up_for_masses_that_are_zero() {
    for mass in ["m0", "(if x < 1 { 1 } else { 0 })"] {
        let text = format!(
            "param m0 = 0, f = 3; coord x, y; kinetic = 1/2*{mass}*dot(x)^2 + 1/2*dot(y)^2;
             potential = y; constraint c = x - y; force x = f;"
        );
        let system = numeric(&text);
        assert_near(&system.acceleration(0.0, &[2.0; 2], &[0.5; 2]), &[2.0, 2.0], &text);
        assert_near(&system.multipliers(0.0, &[2.0; 2], &[0.5; 2]), &[-3.0], &text);
    }
}

/// The equations are sin x ẍ + ½ cos x ẋ² + ÿ + 1 = 0 and ẍ + y = 0.
#[test]
fn a_zero_pivot_of_a_regular_matrix_is_no_singularity() {
    let system = numeric("coord x, y; lagrangian = 1/2*sin(x)*dot(x)^2 + dot(x)*dot(y) - 1/2*y^2 - x;");
    for x in [0.0, 0.4, -1.3] {
        let [y, v] = [0.2, 0.3];
        let expected = [-y, -1.0 - 0.5 * f64::cos(x) * v * v + f64::sin(x) * y];
        assert_near(&system.acceleration(0.0, &[x, y], &[v, 0.7]), &expected, &format!("at {x}"));
    }
}

/// In body axes, squares occur in sums with products, where their signs are not apparent.
#[test]
fn kinetic_energies_need_no_second_way() {
    for (declared, needs_second_way) in [("kinetic", false), ("lagrangian", true)] {
        let text = format!(
            "coord a, b, c; let (w1, w2, w3) = (cos(b)*dot(a), dot(b), sin(b)*dot(a));
             let (u1, u2, u3) = (w1 + dot(c), cos(c)*w2 + sin(c)*w3, cos(c)*w3 - sin(c)*w2);
             {declared} = (u1 + 0.2*u2)^2 + (u1 + 0.3*u3)*u1 + 3*(u2 + 0.1*u3)^2 + 2*u3^2;"
        );
        let derived = parse(&text).and_then(|parsed| parsed.derive(StrategyChoice::Cheapest));
        let equations = derived.unwrap_or_else(|report| panic!("{report}")).equations;
        assert_eq!(equations.pivot_growth.is_some(), needs_second_way, "{text}");
    }
}

#[test]
fn undetermined_accelerations_are_nan() {
    for text in [
        "param m = 0; coord x, y; kinetic = 1/2*m*dot(x)^2 + 1/2*dot(y)^2; force x = 1;",
        "coord x, y; lagrangian = 1/2*sin(x)*dot(x)^2 + sin(x)*dot(x)*dot(y) + 1/2*dot(y)^2*x;",
        "param m = 0; coord x, y, z;
         kinetic = 1/2*m*dot(x)^2 + 1/2*dot(y)^2 + 1/2*m*dot(z)^2; constraint c = x - y; force z = 1;",
    ] {
        let system = numeric(text);
        let zeros = vec![0.0; system.degrees_of_freedom()];
        let found = system.acceleration(0.0, &zeros, &zeros);
        assert!(found.iter().any(|a| !a.is_finite()), "{text}: {found:?}");
    }
}

/// At x = 0 the pivot of the first multiplier, 1/3 − 2/3·1/2, is a rounding error, and the
/// accelerations are (2, 10, −4)/9.
#[test]
fn pivots_of_multipliers_may_vanish_where_mass_is_indefinite() {
    let system = numeric(
        "coord x, y, z;
         lagrangian = 1/2*sin(x)*dot(x)^2 + 1/2*dot(y)^2 + 1/2*dot(z)^2
             + 2*dot(x)*dot(y) + sin(x)*dot(x)*dot(z) + 2*dot(y)*dot(z);
         force z = -1; constraint a = 2*x + z; constraint b = -x + y + 2*z;",
    );
    let found = system.acceleration(0.0, &[0.0; 3], &[0.0; 3]);
    let expected = [2.0, 10.0, -4.0].map(|ninths| ninths / 9.0);
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
}

/// Expands the determinant along the first row.
fn determinant(m: &[Vec<f64>]) -> f64 {
    if m.is_empty() {
        return 1.0;
    }
    let minor = |j: usize| m[1..].iter().map(|row| [&row[..j], &row[j + 1..]].concat()).collect::<Vec<_>>();
    let sign = |j: usize| if j.is_multiple_of(2) { 1.0 } else { -1.0 };
    (0..m.len()).map(|j| sign(j) * m[0][j] * determinant(&minor(j))).sum()
}

/// Solves by Cramer's rule.
fn cramer(m: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let with = |j: usize| {
        let mut changed = m.to_vec();
        changed.iter_mut().zip(right).for_each(|(row, r)| row[j] = *r);
        determinant(&changed)
    };
    (0..right.len()).map(|j| with(j) / determinant(m)).collect()
}

proptest! {
    #![proptest_config(crate::one_in(2))]

    /// Entries of M vanish where the coordinates do, and parameters are zero by default. There are
    /// up to two constraints.
    #[test]
    fn regular_equations_have_a_solution(
        entries in prop::collection::vec(0..4_usize, 6),
        slopes in prop::collection::vec(-2..3_i32, 6),
        forces in prop::collection::vec(-3..4_i32, 3),
        m in 0..3_usize,
    ) {
        const VALUES: [(&str, f64); 4] = [("sin(x)", 0.0), ("none", 0.0), ("1", 1.0), ("2", 2.0)];
        let places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        let names = ["x", "y", "z"];
        let mut text = "param none = 0; coord x, y, z; lagrangian = 0*dot(x)^2".to_owned();
        let mut matrix = vec![vec![0.0; 3 + m]; 3 + m];
        for (&(i, j), &entry) in places.iter().zip(&entries) {
            let (weight, value) = VALUES[entry];
            let half = if i == j { "1/2*" } else { "" };
            text.push_str(&format!(" + {half}{weight}*dot({})*dot({})", names[i], names[j]));
            matrix[i][j] = value;
            matrix[j][i] = value;
        }
        text.push(';');
        let mut right = forces.iter().map(|&f| f64::from(f)).collect::<Vec<_>>();
        for (name, force) in names.iter().zip(&forces) {
            text.push_str(&format!("force {name} = {force};"));
        }
        for k in 0..m {
            let row = &slopes[3 * k..3 * k + 3];
            prop_assume!(row.iter().any(|&slope| slope != 0));
            let terms = row.iter().zip(names).map(|(slope, name)| format!("({slope})*{name}"));
            text.push_str(&format!("constraint c{k} = {};", terms.collect::<Vec<_>>().join(" + ")));
            for (i, &slope) in row.iter().enumerate() {
                matrix[3 + k][i] = f64::from(slope);
                matrix[i][3 + k] = -f64::from(slope);
            }
            right.push(0.0);
        }
        prop_assume!(determinant(&matrix).abs() > 0.5);
        let Ok(derived) = parse(&text).and_then(|parsed| parsed.derive(StrategyChoice::Cheapest)) else {
            // Refused, because some coordinate has no inertia.
            return Ok(());
        };
        let system = NumericSystem::new(&derived);
        let expected = cramer(&matrix, &right);
        let mut found = system.acceleration(0.0, &[0.0; 3], &[0.0; 3]);
        found.extend(system.multipliers(0.0, &[0.0; 3], &[0.0; 3]));
        let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-10 * (1.0 + b.abs());
        prop_assert!(found.iter().zip(&expected).all(is_near), "{found:?}, not {expected:?}: {text}");
    }
}
