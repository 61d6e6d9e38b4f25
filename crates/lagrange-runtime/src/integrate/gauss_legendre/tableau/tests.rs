//! The tables satisfy the equations that define them.

use super::{Coefficients, Tableau};

fn close(one: f64, other: f64) {
    assert!((one - other).abs() < 4e-15, "{one} {other}");
}

/// Checks Σ b c^(k−1) = 1/k up to twice the number of stages, and Σ a c^(k−1) = c^k/k up to that
/// number.
fn check_collocation<const K: usize>(tableau: Tableau<f64, K>) {
    let moment = |weights: [f64; K], k: usize| -> f64 {
        weights.iter().zip(tableau.c).map(|(weight, c)| weight * c.powi(k as i32 - 1)).sum()
    };
    for k in 1..=2 * K {
        close(moment(tableau.b, k), 1.0 / k as f64);
    }
    for k in 1..=K {
        for (row, c) in tableau.a.into_iter().zip(tableau.c) {
            close(moment(row, k), c.powi(k as i32) / k as f64);
        }
    }
}

/// Checks Σ column value row = a, with the complex pair counted as twice its real part.
fn check_modes<const K: usize>(tableau: Tableau<f64, K>) {
    for i in 0..K {
        for j in 0..K {
            let real = tableau.real.map_or(0.0, |mode| mode.column[i] * mode.value * mode.row[j]);
            let complex = tableau.complex.map_or(0.0, |mode| {
                let ((x, y), (u, v)) = (mode.column[i], mode.value);
                let (re, im) = (x * u - y * v, x * v + y * u);
                2.0 * (re * mode.row[j].0 - im * mode.row[j].1)
            });
            close(real + complex, tableau.a[i][j]);
        }
    }
}

#[test]
fn stages_and_weights_integrate_polynomials() {
    check_collocation(Tableau::<f64, 1>::coefficients());
    check_collocation(Tableau::<f64, 2>::coefficients());
    check_collocation(Tableau::<f64, 3>::coefficients());
}

#[test]
fn eigenvectors_belong_to_the_matrix() {
    check_modes(Tableau::<f64, 1>::coefficients());
    check_modes(Tableau::<f64, 2>::coefficients());
    check_modes(Tableau::<f64, 3>::coefficients());
}

/// Checks the condition for symplecticity, which is equivalent to the conservation of quadratic
/// invariants, HLW theorem IV.2.2.
fn check_symplectic<const K: usize>(tableau: Tableau<f64, K>) {
    let Tableau { a, b, .. } = tableau;
    for i in 0..K {
        for j in 0..K {
            close(b[i] * a[i][j] + b[j] * a[j][i], b[i] * b[j]);
        }
    }
}

#[test]
fn quadratic_invariants_are_conserved() {
    check_symplectic(Tableau::<f64, 1>::coefficients());
    check_symplectic(Tableau::<f64, 2>::coefficients());
    check_symplectic(Tableau::<f64, 3>::coefficients());
}
