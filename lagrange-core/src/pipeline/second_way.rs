//! Motion where elimination in a fixed order fails although the equations are regular: a mass is zero that constraints make up
//! for, or a pivot of an indefinite mass matrix vanishes.
//!
//! M a = f + Aᵀλ and A a + b = 0 are solved as one system by Gaussian elimination with complete pivoting (Golub, Van Loan, *Matrix
//! Computations*, 4th ed., §3.4.8). Constraints that depend on each other are not for this: then all is NaN.

/// Number of roundings, of rows scaled to one, below which a coefficient is zero.
const ROUNDINGS: f64 = 32.0;

/// True if digits can be trusted whose rounding errors grow so: below ε^(−5/8), as emitted code has it
/// (`lagrange::constraint::are_regular`).
pub(super) fn is_regular(growth: f64) -> bool {
    growth * f64::EPSILON.powf(0.625) < 1.0
}

/// The accelerations and multipliers of `n` coordinates and `m` constraints; `values` holds M and A in rows, then f and b.
pub(super) fn motion(n: usize, m: usize, values: &[f64]) -> Vec<f64> {
    let (mass, rest) = values.split_at(n * n);
    let (jacobian, rest) = rest.split_at(m * n);
    let (forcing, drift) = rest.split_at(n);
    let of_motion = (0..n).map(|i| {
        let forces = (0..m).map(|k| -jacobian[k * n + i]);
        mass[i * n..(i + 1) * n].iter().copied().chain(forces).chain([forcing[i]]).collect()
    });
    let of_constraints = (0..m).map(|k| {
        let row = jacobian[k * n..(k + 1) * n].iter().copied();
        row.chain(std::iter::repeat_n(0.0, m)).chain([-drift[k]]).collect()
    });
    let rows: Vec<Vec<f64>> = of_motion.chain(of_constraints).collect();
    solve(rows).unwrap_or_else(|| vec![f64::NAN; n + m])
}

/// The solution of linear equations in rows, each with its right-hand side at the end; `None` if they are singular.
fn solve(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let size = rows.len();
    scale(&mut rows)?;
    let mut order = (0..size).collect::<Vec<_>>();
    let smallest = ROUNDINGS * size as f64 * f64::EPSILON;
    for k in 0..size {
        let (i, j) = largest(&rows, k);
        if rows[i][j].abs() <= smallest {
            return None;
        }
        rows.swap(k, i);
        rows.iter_mut().for_each(|row| row.swap(k, j));
        order.swap(k, j);
        let (done, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] / done[k][k];
            row.iter_mut().zip(&done[k]).skip(k).for_each(|(entry, pivot)| *entry -= factor * pivot);
        }
    }
    let mut solution = vec![0.0; size];
    for k in (0..size).rev() {
        let known = (k + 1..size).map(|l| rows[k][l] * solution[order[l]]).sum::<f64>();
        solution[order[k]] = (rows[k][size] - known) / rows[k][k];
    }
    Some(solution)
}

/// Divides each equation by its largest coefficient; `None` if one has none or is not finite.
fn scale(rows: &mut [Vec<f64>]) -> Option<()> {
    for row in rows {
        let coefficients = row.len() - 1;
        let largest = row[..coefficients].iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
        if largest == 0.0 || !row.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        row.iter_mut().for_each(|entry| *entry /= largest);
    }
    Some(())
}

/// Place of the largest coefficient, from row and column `k` on.
fn largest(rows: &[Vec<f64>], k: usize) -> (usize, usize) {
    let size = rows.len();
    let places = (k..size).flat_map(|i| (k..size).map(move |j| (i, j)));
    let larger = |best: (usize, usize), place: (usize, usize)| {
        if rows[place.0][place.1].abs() > rows[best.0][best.1].abs() { place } else { best }
    };
    places.fold((k, k), larger)
}
