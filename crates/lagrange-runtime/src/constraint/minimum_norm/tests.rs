//! Singular equations with known solutions, and conditions that distinguish minimum-norm solutions
//! from others.

use super::{RedundantMotion, minimum_norm, redundant_correction, redundant_motion};

type Motion<const N: usize, const D: usize> = RedundantMotion<f64, N, D>;

fn apply<const N: usize, const D: usize>(rows: &[[f64; N]; D], x: &[f64; N]) -> [f64; D] {
    rows.map(|row| row.iter().zip(x).map(|(entry, x)| entry * x).sum())
}

#[track_caller]
fn assert_near<const N: usize>(found: [f64; N], wanted: [f64; N], part: f64) {
    let size = wanted.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert!((found - wanted).abs() <= part * size, "{found} for {wanted}");
    }
}

/// Returns a generator of numbers in (−1, 1), by a linear congruential method.
fn numbers() -> impl FnMut() -> f64 {
    let mut state = 12_345_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Computes Σ ± x xᵀ.
fn of_rank<const D: usize>(rank: usize, next: &mut impl FnMut() -> f64) -> [[f64; D]; D] {
    let mut matrix = [[0.0; D]; D];
    for term in 0..rank {
        let x: [f64; D] = core::array::from_fn(|_| next());
        let sign = if term % 2 == 0 { 1.0 } else { -1.0 };
        for i in 0..D {
            for j in 0..D {
                matrix[i][j] += sign * x[i] * x[j];
            }
        }
    }
    matrix
}

#[test]
fn regular_equations_have_one_solution() {
    let matrix = [[0.0, 2.0, 1.0], [2.0, 1.0, -1.0], [1.0, -1.0, 0.0]];
    assert_near(minimum_norm(matrix, apply(&matrix, &[1.0, -2.0, 0.25])), [1.0, -2.0, 0.25], 1e-14);
}

/// Penrose's conditions: x is a combination of rows, and the remainder is orthogonal to all rows.
#[test]
fn the_shortest_of_the_closest_vectors_is_found_at_every_rank() {
    let mut next = numbers();
    for rank in 0..=5 {
        for _ in 0..20 {
            let matrix = of_rank::<5>(rank, &mut next);
            let right = core::array::from_fn(|_| next());
            let x = minimum_norm(matrix, right);
            let product = apply(&matrix, &x);
            let left = core::array::from_fn(|i| right[i] - product[i]);
            assert_near(apply(&matrix, &left).map(|rest| 1.0 + rest), [1.0; 5], 1e-10);
            // The right side from x and a vector orthogonal to the rows must lead back to x.
            assert_near(minimum_norm(matrix, product), x, 1e-9);
        }
    }
}

#[test]
fn units_of_the_rows_do_not_matter_to_the_rank() {
    let u = [1e6, 1e-3, 2.0];
    let matrix = u.map(|x| u.map(|y| x * y));
    let square: f64 = u.iter().map(|x| x * x).sum();
    let shortest = u.map(|x| 5.0 * x / square);
    assert_near(minimum_norm(matrix, u.map(|x| 5.0 * x)), shortest, 1e-14);
    let regular = [[1e12, 3e5], [3e5, 1.0]];
    assert_near(minimum_norm(regular, apply(&regular, &[1e-6, -2.0])), [1e-6, -2.0], 1e-12);
}

#[test]
fn what_is_not_finite_spoils_all_and_nothing_demands_nothing() {
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(minimum_norm([[1.0, bad], [bad, 1.0]], [1.0, 1.0]).iter().all(|x| x.is_nan()));
        assert!(minimum_norm([[1.0, 0.0], [0.0, 1.0]], [1.0, bad]).iter().all(|x| x.is_nan()));
        let motion = redundant_motion(&[[1.0]], &[bad], &[[1.0]], &[0.0]);
        assert!(motion.acceleration[0].is_nan() && motion.multipliers[0].is_nan());
        assert!(redundant_correction(&[[1.0]], &[[1.0]], &[bad])[0].is_nan());
    }
    assert_eq!(minimum_norm([[0.0; 2]; 2], [1.0, 2.0]), [0.0; 2]);
}

/// A pendulum of length l and mass m at rest in horizontal position, in the plane.
const PENDULUM: ([[f64; 2]; 2], [f64; 2], [f64; 2]) = ([[2.0, 0.0], [0.0, 2.0]], [0.0, -20.0], [0.6, -0.8]);

#[test]
fn independent_constraints_give_the_known_motion() {
    let (mass, forcing, along) = PENDULUM;
    // λ along the rod is m (v²/l − g·e) with e = (0.6, −0.8), v² = 9 and l = 1 in the drift.
    let motion = redundant_motion(&mass, &forcing, &[along], &[9.0]);
    assert_eq!(motion.rank, 1);
    assert_near(motion.multipliers, [-(18.0 + 16.0)], 1e-15);
    assert_near(motion.acceleration, [-0.6 * 17.0, -10.0 + 0.8 * 17.0], 1e-15);
}

#[test]
fn copies_of_a_constraint_share_its_force_by_least_squares() {
    let (mass, forcing, along) = PENDULUM;
    let single = redundant_motion(&mass, &forcing, &[along], &[9.0]);
    let copies = [along, along.map(|x| -3.0 * x), along];
    let motion = redundant_motion(&mass, &forcing, &copies, &[9.0, -27.0, 9.0]);
    assert_eq!(motion.rank, 1);
    assert_near(motion.acceleration, single.acceleration, 1e-14);
    let share = single.multipliers[0] / 11.0;
    assert_near(motion.multipliers, [share, -3.0 * share, share], 1e-14);
}

#[test]
fn constraints_in_other_units_give_the_same_motion() {
    let (mass, forcing, along) = PENDULUM;
    let (other, third) = ([0.8, 0.6], [1.4, -0.2]);
    let plain: Motion<2, 3> = redundant_motion(&mass, &forcing, &[along, other, third], &[9.0, 1.0, 10.0]);
    assert_eq!(plain.rank, 2);
    let scaled = [along.map(|x| 1e9 * x), other, third.map(|x| 1e-9 * x)];
    let motion = redundant_motion(&mass, &forcing, &scaled, &[9e9, 1.0, 10e-9]);
    assert_eq!(motion.rank, 2);
    assert_near(motion.acceleration, plain.acceleration, 1e-14);
    // Both satisfy M a = f + Aᵀλ.
    for (rows, found) in [([along, other, third], plain), (scaled, motion)] {
        for i in 0..2 {
            let force: f64 = rows.iter().zip(found.multipliers).map(|(row, share)| row[i] * share).sum();
            let inertia = apply(&mass, &found.acceleration)[i];
            assert!((inertia - forcing[i] - force).abs() < 1e-12, "{inertia} {force}");
        }
    }
}

#[test]
fn constraints_determine_what_has_no_mass() {
    let mass = [[2.0, 0.0], [0.0, 0.0]];
    let motion = redundant_motion(&mass, &[0.5, 0.0], &[[0.0, 3.0], [1.0, -1.0]], &[-12.0, 0.0]);
    assert_near(motion.acceleration, [4.0, 4.0], 1e-15);
    assert_near(motion.multipliers, [2.5, 7.5], 1e-14);
    assert_eq!(motion.rank, 2);
}

#[test]
fn undetermined_and_contradictory_systems_are_refused() {
    let free: Motion<2, 1> = redundant_motion(&[[2.0, 0.0], [0.0, 0.0]], &[0.0, 0.0], &[[1.0, 0.0]], &[1.0]);
    assert!(free.acceleration.iter().chain(&free.multipliers).all(|x| x.is_nan()));
    let (mass, forcing, along) = PENDULUM;
    let torn: Motion<2, 2> =
        redundant_motion(&mass, &forcing, &[along, along.map(|x| 2.0 * x)], &[9.0, 18.1]);
    assert!(torn.acceleration.iter().chain(&torn.multipliers).all(|x| x.is_nan()));
    let rounded = redundant_motion(&mass, &forcing, &[along, along.map(|x| 2.0 * x)], &[9.0, 18.0 + 1e-13]);
    assert!(rounded.acceleration.iter().all(|x| x.is_finite()));
}

#[test]
fn a_correction_is_the_smallest_by_mass_and_serves_copies_too() {
    let (mass, rows) = ([[4.0, 0.0], [0.0, 1.0]], [[1.0, 1.0], [2.0, 2.0]]);
    let change = redundant_correction(&mass, &rows, &[1e-3, 2e-3]);
    // The lighter coordinate moves four times as far.
    assert_near(change, [-0.2e-3, -0.8e-3], 1e-14);
}

/// Between dependent and independent constraints, errors of the multipliers grow as the angle
/// falls, and every motion is accepted.
#[test]
fn nearly_dependent_constraints_never_give_nonsense() {
    let (mass, forcing) = ([[1.0, 0.0], [0.0, 1.0]], [3.0, -4.0]);
    for exponent in 1..=16 {
        let angle = 10.0_f64.powi(-exponent);
        let rows = [[1.0, 0.0], [angle.cos(), angle.sin()]];
        // At rest in equilibrium, both hold.
        let motion = redundant_motion(&mass, &forcing, &rows, &[0.0, 0.0]);
        assert_eq!(motion.rank, if exponent <= 4 { 2 } else { 1 }, "{exponent}");
        let wanted = if motion.rank == 2 { [0.0, 0.0] } else { [0.0, -4.0] };
        for (found, wanted) in motion.acceleration.into_iter().zip(wanted) {
            assert!(
                (found - wanted).abs() < 1e-10 + 5.0 * if motion.rank == 2 { 0.0 } else { angle },
                "{exponent}: {found}"
            );
        }
    }
}
