//! Vectors, matrices and whole arrays: the code equals that of the declaration with scalars.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse};
use lagrange_core::syntax::{parse_text, print};
use quote::quote;

/// Returns the emitted code of a text whose fields are not arrays, without the numbers that
/// identify texts.
fn emitted(text: &str) -> String {
    let derived = parse(text).and_then(|mut system| {
        system.declaration.arrays.clear();
        system.declaration.placed.clear();
        system.derive(StrategyChoice::Cheapest)
    });
    let tokens = derived.and_then(|derived| derived.emit(&quote!(::lagrange)));
    let code = tokens.unwrap_or_else(|report| panic!("{text}\n{report}")).to_string();
    let parts = code.split("FINGERPRINT : :: core :: primitive :: u64 = ");
    parts.map(|part| part.trim_start_matches(|digit: char| digit.is_ascii_digit())).collect()
}

fn assert_same(vectors: &str, scalars: &str) {
    let (vectors_code, scalars_code) = (emitted(vectors), emitted(scalars));
    assert!(scalars_code.len() > 1000);
    let differs = vectors_code.bytes().zip(scalars_code.bytes()).position(|(a, b)| a != b);
    let from =
        |code: &str| code.chars().skip(differs.unwrap_or(0).saturating_sub(60)).take(160).collect::<String>();
    assert!(vectors_code == scalars_code, "{vectors}\n{}\n{}", from(&vectors_code), from(&scalars_code));
    // The printed text reads as the same declaration.
    let mut report = lagrange_core::diagnostics::Report::default();
    let declaration = parse_text(vectors, &mut report).expect("tokens");
    assert_eq!(emitted(&print::statements(&declaration)), scalars_code, "{vectors}");
}

fn numeric(text: &str) -> NumericSystem {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{text}\n{report}")))
}

#[test]
fn a_quadratic_form_is_its_terms() {
    assert_same(
        "param M[2][2] = [[2, 1], [1, 3]]; coord q[2];
         kinetic = 1/2 * inner(dot(q), M * dot(q)); potential = 1/2 * inner(q, q);",
        "param M_0_0 = 2, M_0_1 = 1, M_1_0 = 1, M_1_1 = 3; coord q_0, q_1;
         kinetic = 1/2 * (dot(q_0) * (M_0_0 * dot(q_0) + M_0_1 * dot(q_1))
           + dot(q_1) * (M_1_0 * dot(q_0) + M_1_1 * dot(q_1)));
         potential = 1/2 * (q_0^2 + q_1^2);",
    );
}

#[test]
fn a_point_is_a_vector() {
    assert_same(
        "param l = 1, m = 2, g = 9.81; coord a, b;
         let p = (l * sin(a) * cos(b), l * sin(a) * sin(b), -l * cos(a));
         kinetic = 1/2 * m * inner(dot(p), dot(p)); potential = m * g * p[2];
         output place = p;",
        "param l = 1, m = 2, g = 9.81; coord a, b;
         let p_x = l * sin(a) * cos(b); let p_y = l * sin(a) * sin(b); let p_z = -l * cos(a);
         kinetic = 1/2 * m * (dot(p_x)^2 + dot(p_y)^2 + dot(p_z)^2); potential = m * g * p_z;
         output place = (p_x, p_y, p_z);",
    );
}

#[test]
fn rates_of_whole_arrays_are_those_of_elements() {
    assert_same(
        "param A[2][2] = [[0, 1], [-4, -1]], b[2] = [0, 1]; input u; state x[2] = 1;
         dot(x) = A * x + b * u; output y = x - b; output first = (A * x)[1]; output row = A[0];",
        "param A_0_0 = 0, A_0_1 = 1, A_1_0 = -4, A_1_1 = -1, b_0 = 0, b_1 = 1; input u; state x_0 = 1, x_1 = 1;
         dot(x_0) = A_0_0 * x_0 + A_0_1 * x_1 + b_0 * u; dot(x_1) = A_1_0 * x_0 + A_1_1 * x_1 + b_1 * u;
         output y = (x_0 - b_0, x_1 - b_1); output first = A_1_0 * x_0 + A_1_1 * x_1;
         output row = (A_0_0, A_0_1);",
    );
}

#[test]
fn products_of_matrices_are_sums_of_products() {
    assert_same(
        "param F[2][2] = [[0, 1], [-1, -0.2]], Q[2][2] = [[0.1, 0], [0, 0.2]]; state P[2][2] = 1;
         dot(P) = F * P + P * transpose(F) - 2 * Q;",
        "param F_0_0 = 0, F_0_1 = 1, F_1_0 = -1, F_1_1 = -0.2, Q_0_0 = 0.1, Q_0_1 = 0, Q_1_0 = 0, Q_1_1 = 0.2;
         state P_0_0 = 1, P_0_1 = 1, P_1_0 = 1, P_1_1 = 1;
         dot(P_0_0) = (F_0_0 * P_0_0 + F_0_1 * P_1_0) + (P_0_0 * F_0_0 + P_0_1 * F_0_1) - 2 * Q_0_0;
         dot(P_0_1) = (F_0_0 * P_0_1 + F_0_1 * P_1_1) + (P_0_0 * F_1_0 + P_0_1 * F_1_1) - 2 * Q_0_1;
         dot(P_1_0) = (F_1_0 * P_0_0 + F_1_1 * P_1_0) + (P_1_0 * F_0_0 + P_1_1 * F_0_1) - 2 * Q_1_0;
         dot(P_1_1) = (F_1_0 * P_0_1 + F_1_1 * P_1_1) + (P_1_0 * F_1_0 + P_1_1 * F_1_1) - 2 * Q_1_1;",
    );
}

#[test]
fn functions_take_vectors_and_matrices() {
    assert_same(
        "param K[2][2] = [[2, -1], [-1, 2]]; coord q[2];
         let form(A, v) = 1/2 * inner(v, A * v); let last(v) = v[1];
         kinetic = 1/2 * inner(dot(q), dot(q)); potential = form(K, q) + last(q)^4;",
        "param K_0_0 = 2, K_0_1 = -1, K_1_0 = -1, K_1_1 = 2; coord q_0, q_1;
         kinetic = 1/2 * (dot(q_0)^2 + dot(q_1)^2);
         potential = 1/2 * (q_0 * (K_0_0 * q_0 + K_0_1 * q_1) + q_1 * (K_1_0 * q_0 + K_1_1 * q_1)) + q_1^4;",
    );
}

#[test]
fn parts_take_whole_arrays() {
    assert_same(
        "coord q[2], s; kinetic = 1/2 * (inner(dot(q), dot(q)) + dot(s)^2);
         part Spring(ends, k = 1) { potential = 1/2 * k * (ends[1] - ends[0])^2; }
         left: Spring { ends: q; k: 3; } right: Spring { ends: (s, q[1]); }",
        "coord q_0, q_1, s; kinetic = 1/2 * (dot(q_0)^2 + dot(q_1)^2 + dot(s)^2);
         potential = 1/2 * 3 * (q_1 - q_0)^2; potential = 1/2 * (q_1 - s)^2;",
    );
}

#[test]
fn forces_starts_and_assignments_take_whole_arrays() {
    assert_same(
        "coord q[2]; kinetic = 1/2 * inner(dot(q), dot(q)); force q = -2 * q - (dot(q[1]), dot(q[0]));
         start q = (1, 2), dot(q) = (3, 4); discrete held[2] = 0;
         event low = q[0], falling => { dot(q) = -dot(q); held = q; } output kept = held;",
        "coord q_0, q_1; kinetic = 1/2 * (dot(q_0)^2 + dot(q_1)^2);
         force q_0 = -2 * q_0 - dot(q_1); force q_1 = -2 * q_1 - dot(q_0);
         start q_0 = 1, q_1 = 2, dot(q_0) = 3, dot(q_1) = 4; discrete held_0 = 0, held_1 = 0;
         event low = q_0, falling => { dot(q_0) = -dot(q_0); dot(q_1) = -dot(q_1); held_0 = q_0; held_1 = q_1; }
         output kept = (held_0, held_1);",
    );
}

#[test]
fn whole_arrays_are_frozen() {
    assert_same(
        "coord q[2], x; kinetic = 1/2 * (inner(dot(q), dot(q)) + dot(x)^2 + (dot(q[0]) + dot(x))^2);
         potential = inner(q, q) * cos(x); reduce Held { freeze q = (1, 2); }",
        "coord q_0, q_1, x; kinetic = 1/2 * (dot(q_0)^2 + dot(q_1)^2 + dot(x)^2 + (dot(q_0) + dot(x))^2);
         potential = (q_0^2 + q_1^2) * cos(x); reduce Held { freeze q_0 = 1, q_1 = 2; }",
    );
}

#[test]
fn functions_of_ranges_and_of_several() {
    assert_same(
        "coord x[3]; kinetic = 1/2 * inner(dot(x), dot(x)); potential = product(i in 0..3, x[i]);
         output least = min(i in 0..3, x[i]); output most = max(x[0], x[1], x[2], 1);
         output none = product(i in 0..0, x[i]); output one = min(i in 1..2, x[i]);",
        "coord x_0, x_1, x_2; kinetic = 1/2 * (dot(x_0)^2 + dot(x_1)^2 + dot(x_2)^2); potential = x_0 * x_1 * x_2;
         output least = min(min(x_0, x_1), x_2); output most = max(max(max(x_0, x_1), x_2), 1);
         output none = 1; output one = x_1;",
    );
}

/// Points of a chain as rows of a matrix, elements that are vectors, rows of arrays.
#[test]
fn vectors_of_vectors_are_matrices() {
    assert_same(
        "coord a, b; let p[0] = (cos(a), sin(a)); let p[1] = p[0] + (cos(b), sin(b));
         kinetic = 1/2 * (inner(dot(p[0]), dot(p[0])) + inner(dot(p[1]), dot(p[1])));
         potential = p[0][1] + (p * (1, 2))[1]; let (e, f, g, h) = (a, b, a * b, 1);
         output four = (e, f, g, h);",
        "coord a, b; let p_0_x = cos(a); let p_0_y = sin(a); let p_1_x = p_0_x + cos(b); let p_1_y = p_0_y + sin(b);
         kinetic = 1/2 * (dot(p_0_x)^2 + dot(p_0_y)^2 + (dot(p_1_x)^2 + dot(p_1_y)^2));
         potential = p_0_y + (p_1_x * 1 + p_1_y * 2); let e = a; let f = b; let g = a * b; let h = 1;
         output four = (e, f, g, h);",
    );
}

/// Every dimension of a spring with units is checked entry by entry.
#[test]
fn units_are_those_of_entries() {
    let text = |stiffness: &str| {
        format!(
            "param K[2][2]: {stiffness} = [[2, 1], [1, 2]], m: kg = 1; coord q[2]: m;
             kinetic = 1/2 * m * inner(dot(q), dot(q)); potential = 1/2 * inner(q, transpose(K) * q);
             output pull = K * q; output first: N = (K * q)[0];"
        )
    };
    assert!(parse(&text("N/m")).and_then(|system| system.derive(StrategyChoice::Cheapest)).is_ok());
    let report = parse(&text("N")).and_then(|system| system.derive(StrategyChoice::Cheapest)).map(|_| ());
    let report = report.expect_err("a stiffness is no force").to_string();
    assert_eq!(report.matches("error at").count(), 1, "{report}");
}

/// The accelerations of a spherical pendulum by vectors agree with `ä = sin a cos a ḃ² − g/l sin a`
/// and `b̈ = −2 cot a ȧ ḃ`.
#[test]
fn a_spherical_pendulum_is_that_of_textbooks() {
    let pendulum = numeric(
        "param l = 0.7, m = 2, g = 9.81; coord a, b;
         let p = l * (sin(a) * cos(b), sin(a) * sin(b), -cos(a));
         kinetic = kinetic_energy(m, dot(p)); potential = m * g * inner(p, (0, 0, 1));",
    );
    for (a, b, va, vb) in [(0.3, 1.1, 0.4, -2.0), (2.5, -3.0, 1.0, 0.1), (1.0, 0.0, 0.0, 0.0)] {
        let (a, b, va, vb): (f64, f64, f64, f64) = (a, b, va, vb);
        let found = pendulum.acceleration(0.0, &[a, b], &[va, vb]);
        let expected =
            [a.sin() * a.cos() * vb * vb - 9.81 / 0.7 * a.sin(), -2.0 * va * vb * a.cos() / a.sin()];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{found} {expected}");
        }
    }
}

/// The Riccati equation of a Kalman filter in matrices rests at the covariance of SciPy's
/// `linalg.solve_continuous_are`, and reaches it from any start.
#[test]
fn a_kalman_filter_rests_at_the_covariance_of_scipy() {
    let filter = numeric(
        "param A[2][2] = [[0, 1], [-4, -0.4]], Q[2][2] = [[0.1, 0.02], [0.02, 0.3]];
         param C[1][2] = [[1, 0.5]], r = 0.2;
         state P[2][2];
         dot(P) = A * P + P * transpose(A) + Q - P * transpose(C) * C * P / r;",
    );
    let mut covariance = vec![0.5, 0.1, 0.1, 0.7];
    // The classical Runge-Kutta method, until rest.
    let step = 0.02;
    for _ in 0..3000 {
        let ahead = |by: f64, slope: &[f64]| {
            covariance.iter().zip(slope).map(|(value, slope)| value + by * slope).collect::<Vec<_>>()
        };
        let first = filter.rhs(0.0, &covariance);
        let second = filter.rhs(0.0, &ahead(step / 2.0, &first));
        let third = filter.rhs(0.0, &ahead(step / 2.0, &second));
        let fourth = filter.rhs(0.0, &ahead(step, &third));
        let slope = (0..4).map(|i| (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]) / 6.0);
        covariance = ahead(step, &slope.collect::<Vec<_>>());
    }
    let scipy = [0.10108131948743483, -0.031876683315797946, -0.031876683315797946, 0.4548149804013771];
    for (found, expected) in covariance.iter().zip(scipy) {
        assert!((found - expected).abs() < 1e-12, "{covariance:?}");
    }
}
