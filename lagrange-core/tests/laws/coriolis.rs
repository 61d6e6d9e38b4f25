//! The Coriolis matrix beside differences of the mass matrix and of the bias.

use lagrange_core::model::Product;
use lagrange_core::pipeline::NumericSystem;

use crate::random::Random;
use crate::regressor::numeric;

/// A state of a system at a time.
type At<'a> = (f64, &'a [f64], &'a [f64]);

/// Returns states at random, with unit quaternions.
pub(crate) fn states(system: &NumericSystem, count: usize) -> Vec<(f64, Vec<f64>, Vec<f64>)> {
    let mut random = Random::new(32);
    let layout = system.programs().layout;
    let mut state = || {
        let mut q = (0..layout.positions).map(|_| random.between(-1.2, 1.2)).collect::<Vec<_>>();
        for &first in &system.programs().variables.quaternions {
            let length = q[first..first + 4].iter().map(|x| x * x).sum::<f64>().sqrt();
            q[first..first + 4].iter_mut().for_each(|x| *x /= length);
        }
        let v = (0..layout.velocities).map(|_| random.between(-1.2, 1.2)).collect();
        (random.between(0.0, 2.0), q, v)
    };
    (0..count).map(|_| state()).collect()
}

/// Returns the derivative of a vector function at zero from four of its values.
pub(crate) fn slope(function: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let step = 1e-3;
    let [far, near] = [2.0 * step, step].map(|h| {
        let (ahead, behind) = (function(h), function(-h));
        ahead.iter().zip(behind).map(|(a, b)| (a - b) / (2.0 * h)).collect::<Vec<_>>()
    });
    near.iter().zip(far).map(|(near, far)| (4.0 * near - far) / 3.0).collect()
}

fn product(system: &NumericSystem, product: Product, (t, q, v): At<'_>) -> Vec<f64> {
    system.product(product, t, q, v).expect("it is emitted")
}

pub(crate) fn moved(place: &[f64], along: &[f64], h: f64) -> Vec<f64> {
    place.iter().zip(along).map(|(x, rate)| x + h * rate).collect()
}

/// Returns the rate of the mass matrix along a motion, with time and without.
fn mass_rates(system: &NumericSystem, (t, q, v): At<'_>) -> [Vec<f64>; 2] {
    let rates = system.position_rates(t, q, v);
    [1.0, 0.0].map(|passing| {
        slope(|h| product(system, Product::MassMatrix, (t + h * passing, &moved(q, &rates, h), v)))
    })
}

#[track_caller]
pub(crate) fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < tolerance * largest, "{found:?} {expected:?}");
    }
}

/// Checks that C v is the part of the bias with velocities, and that C + Cᵀ is the rate of M.
/// Parts that depend on time or on states count twice in this sum.
fn assert_laws(text: &str, driven: &[usize]) {
    let system = numeric(text);
    let n = system.programs().layout.velocities;
    for (t, q, v) in states(&system, 6) {
        let found = product(&system, Product::CoriolisMatrix, (t, &q, &v));
        let forces = found.chunks_exact(n).map(|row| row.iter().zip(&v).map(|(c, v)| c * v).sum::<f64>());
        let [bias, rest] = [&v, &vec![0.0; n]].map(|v| product(&system, Product::Bias, (t, &q, v)));
        let expected = bias.iter().zip(rest).map(|(all, rest)| all - rest).collect::<Vec<_>>();
        assert_near(&forces.collect::<Vec<_>>(), &expected, 1e-13);
        let sums = (0..n * n).map(|k| found[k] + found[k % n * n + k / n]).collect::<Vec<_>>();
        let [mut rate, without_time] = mass_rates(&system, (t, &q, &v));
        rate.iter_mut().zip(without_time).for_each(|(all, part)| *all += *all - part);
        let mut along = vec![0.0; q.len()];
        driven.iter().for_each(|&state| along[state] = system.position_rates(t, &q, &v)[state]);
        let of_states = slope(|h| product(&system, Product::MassMatrix, (t, &moved(&q, &along, h), &v)));
        rate.iter_mut().zip(of_states).for_each(|(all, part)| *all += part);
        assert_near(&sums, &rate, 1e-10);
    }
}

/// Compares C with the Christoffel symbols of M, from differences of M alone.
fn assert_christoffel(text: &str) {
    let system = numeric(text);
    let n = system.programs().layout.velocities;
    for (t, q, v) in states(&system, 6) {
        let slopes = (0..n).map(|k| {
            let along = (0..n).map(|j| f64::from(u8::from(j == k))).collect::<Vec<_>>();
            slope(|h| product(&system, Product::MassMatrix, (t, &moved(&q, &along, h), &v)))
        });
        let slopes = slopes.collect::<Vec<_>>();
        let by = |k: usize, i: usize, j: usize| slopes[k][i * n + j];
        let entry = |i: usize, j: usize| -> f64 {
            (0..n).map(|k| 0.5 * (by(k, i, j) + by(j, i, k) - by(i, j, k)) * v[k]).sum()
        };
        let expected = (0..n * n).map(|place| entry(place / n, place % n)).collect::<Vec<_>>();
        assert_near(&product(&system, Product::CoriolisMatrix, (t, &q, &v)), &expected, 1e-10);
    }
}

pub(crate) const CART: &str =
    "param m = 2, l = 0.7, g = 9.81; coord x, a, b; dissipation = dot(a)^2; force x = 3*dot(b);
    let p = (x + l*sin(a), -l*cos(a)); let r = p + l*(sin(b), -cos(b));
    kinetic = 1/2*dot(x)^2 + kinetic_energy(m, dot(p)) + kinetic_energy(m, dot(r));
    potential = m*g*(p.y + r.y);";

/// Bodies in space without a quaternion.
pub(crate) const ARM: &str = "gravity = (0, 0, -9.81);
    body base { mass: 4; inertia: (1, 2, 1.5, 0.1, 0.2, 0.3); centroid: (0.1, 0.2, 0.3); }
    revolute a = ground to base { axis: (1, 2, 2); }
    body boom { mass: 2; inertia: (0.5, 0.6, 0.4, 0.02, 0, 0.03); centroid: (0.3, 0.1, -0.2); }
    universal (b, c) = base to boom { at: (0.2, 0, 0.5); }
    body slider { mass: 3; inertia: (0.1, 0.2, 0.15); centroid: (0, 0.1, 0); }
    prismatic s = boom to slider { at: (0, 0, 1); axis: (1, 1, 0); }";

pub(crate) const FREE: &str = "gravity = (0, 0, -9.81);
    body stone { mass: 2; inertia: (1, 2, 2.5, 0.1, -0.2, 0.3); centroid: (0.3, 0, 0.1); }
    free stone;
    body boom { mass: 1.5; inertia: (0.5, 0.6, 0.4, 0.02, 0, 0.03); centroid: (0.3, 0.1, -0.2); }
    ball hip = stone to boom { at: (0.2, 0, 0.5); }";

#[test]
fn entries_are_christoffel_symbols() {
    for text in [CART, ARM] {
        assert_christoffel(&format!("struct S; {text} emit {{ coriolis_matrix, bias }}"));
        assert_christoffel(&format!("#[accuracy(strict)] struct S; {text} emit {{ coriolis_matrix, bias }}"));
    }
}

#[test]
fn velocities_times_it_are_the_bias_and_it_is_skew_beside_the_rate_of_the_mass_matrix() {
    for text in [CART, ARM, FREE] {
        assert_laws(&format!("struct S; {text} emit {{ coriolis_matrix, bias }}"), &[]);
    }
    // Magnets, a support that moves, and a mass that is lost.
    assert_laws(
        "struct S; param b = 0.4; coord x, y; state m = 2;
         lagrangian = 1/2*m*(1 + x^2)*(dot(x)^2 + (2 + sin(t))*dot(y)^2) + b*x^2*dot(y) - m*x*y;
         dot(m) = -0.1*m; emit { coriolis_matrix, bias, mass_matrix }",
        &[2],
    );
    assert_laws(
        "struct S; param g = 9.81; coord a, d; let p = (sin(a) + t^2, -cos(a)) + (sin(d), -cos(d))*(1 + t);
         kinetic = kinetic_energy(1, dot(p)) + dot(a)^2; potential = g*p.y; emit { coriolis_matrix, bias }",
        &[],
    );
}

const TOP: &str = "gravity = (0, 0, -9.81);
    body top { mass: 2; inertia: (1, 2, 2.5, 0.1, -0.2, 0.3); centroid: (0.3, 0, 0.1); }";

/// Returns the derivatives of the angular velocity in body axes by the rates of three angles about
/// the axes x, y and z, in rows.
fn turning([_, b, c]: [f64; 3]) -> [[f64; 3]; 3] {
    let ((sb, cb), (sc, cc)) = (b.sin_cos(), c.sin_cos());
    [[cb * cc, sc, 0.0], [-cb * sc, cc, 0.0], [sb, 0.0, 1.0]]
}

/// Angular velocities ω = B θ̇ and angles describe one motion. From ω̇ = B θ̈ + Ḃ θ̇ follows
/// C = Bᵀ (C_ω B + M_ω Ḃ) for the angles, whose C consists of Christoffel symbols.
#[test]
fn orientations_have_the_connection_of_angles() {
    let ball = numeric(&format!("struct S; {TOP} ball hip = ground to top; emit {{ coriolis_matrix }}"));
    let gimbal = numeric(&format!(
        "struct S; {TOP} frame f; frame e; revolute a = ground to f {{ axis: (1, 0, 0); }}
         revolute b = f to e {{ axis: (0, 1, 0); }} revolute c = e to top; emit {{ coriolis_matrix }}"
    ));
    for (t, angles, rates) in states(&gimbal, 6) {
        let angles = [angles[0], angles[1], angles[2]];
        let half = angles.map(|angle| (0.5 * angle).sin_cos());
        let [(sa, ca), (sb, cb), (sc, cc)] = half;
        let quaternion = [
            ca * cb * cc - sa * sb * sc,
            sa * cb * cc + ca * sb * sc,
            ca * sb * cc - sa * cb * sc,
            ca * cb * sc + sa * sb * cc,
        ];
        let own = turning(angles);
        let omega = own.map(|row| row.iter().zip(&rates).map(|(b, rate)| b * rate).sum::<f64>());
        let change = slope(|h| turning([0, 1, 2].map(|k| angles[k] + h * rates[k])).concat());
        let [mass, matrix] = [Product::MassMatrix, Product::CoriolisMatrix]
            .map(|wanted| product(&ball, wanted, (t, &quaternion, &omega)));
        let inner = |i: usize, j: usize| -> f64 {
            (0..3).map(|k| matrix[3 * i + k] * own[k][j] + mass[3 * i + k] * change[3 * k + j]).sum()
        };
        let entry = |i: usize, j: usize| -> f64 { (0..3).map(|k| own[k][i] * inner(k, j)).sum() };
        let expected = (0..9).map(|place| entry(place / 3, place % 3)).collect::<Vec<_>>();
        assert_near(&product(&gimbal, Product::CoriolisMatrix, (t, &angles, &rates)), &expected, 1e-11);
    }
}

#[test]
fn an_inertia_that_moves_with_velocities_has_none() {
    for text in [
        "coord x; lagrangian = -sqrt(1 - dot(x)^2);",
        "coord x; state m = 1; lagrangian = 1/2*m*dot(x)^2; dot(m) = -0.1*dot(x)^2;",
    ] {
        let report = lagrange_core::pipeline::parse(&format!("struct S; {text} emit {{ coriolis_matrix }}"));
        let report = report.expect_err("a mistake").to_string();
        assert!(report.contains("mass matrix depends on velocities"), "{report}");
    }
}
