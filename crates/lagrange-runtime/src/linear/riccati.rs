//! Algebraic Riccati equations.
//!
//! # In continuous time
//!
//! The equation is AᵀX + XA − XGX + Q = 0. Its stabilising solution follows from the matrix sign S
//! of the Hamiltonian matrix H = [A −G; −Q −Aᵀ]: (S + I) [I; X] = 0. S is the limit of Z ← (cZ +
//! (cZ)⁻¹)/2 from H, with c = |det Z|^(−1/2n). One step of Newton's method removes rounding errors;
//! its Lyapunov equation is solved by the same iteration. Sources: Roberts, *Linear model reduction
//! and solution of the algebraic Riccati equation by use of the sign function*, Int. J. Control 32
//! (1980) 677–687; Byers, *Solving the algebraic Riccati equation with the matrix sign function*,
//! Linear Algebra Appl. 85 (1987) 267–279; Kleinman, *On an iterative technique for Riccati
//! equation computations*, IEEE Trans. Autom. Control 13 (1968) 114–115.
//!
//! Example: for ẋ = x + u with Q = 3 and G = 1, H = [1 −1; −3 −1] has the eigenvalues ±2, and its
//! sign is H/2. Then (S + I) [1; X] = [3/2 − X/2; −3/2 + X/2] vanishes for X = 3.
//!
//! # In discrete time
//!
//! The equation is X = AᵀX(I + GX)⁻¹A + Q. Its stabilising solution is the limit of H under
//! doubling, from H = Q:
//!
//! ```text
//! W = I + GH,   A ← AW⁻¹A,   G ← G + AW⁻¹GAᵀ,   H ← H + AᵀHW⁻¹A.
//! ```
//!
//! After k rounds, H is the cost of 2ᵏ steps. Policy iteration removes rounding errors: the next
//! cost is that of u = −K x with the gain K of the previous cost. Sources: Chu, Fan, Lin, Wang,
//! *Structure-preserving algorithms for periodic discrete-time algebraic Riccati equations*, Int.
//! J. Control 77 (2004) 767–788; Hewer, *An iterative technique for the computation of the steady
//! state gains for the discrete optimal regulator*, IEEE Trans. Autom. Control 16 (1971) 382–384.
//!
//! Example: for x⁺ = 2 x + u with Q = G = 1, X² − 4X − 1 = 0 has the solution 2 + √5 = 4.236. The
//! rounds give H = 1, 3, 4.2, 4.236.

use std::vec::Vec;

use crate::linalg::dense::{DenseMatrix, TriangularFactors};
use crate::linalg::singular_values::SingularValues;

/// Maximum number of iterations for a matrix sign, or of rounds of doubling; eight or nine are
/// usual.
const MAX_ITERATIONS: usize = 60;
/// Maximum number of policy iterations after doubling; one or two are usual.
const MAX_REFINEMENTS: usize = 10;
/// Relative change below which iterations end.
const ROUNDED: f64 = 1e-14;

/// Returns the stabilising solution of AᵀX + XA − XGX + Q = 0, if there is one.
pub(super) fn continuous(a: &DenseMatrix, g: &DenseMatrix, q: &DenseMatrix) -> Option<DenseMatrix> {
    let n = a.rows();
    let hamiltonian = DenseMatrix::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
        (true, true) => a[(i, j)],
        (true, false) => -g[(i, j - n)],
        (false, true) => -q[(i - n, j)],
        (false, false) => -a[(j - n, i - n)],
    });
    let (sign, _) = sign(hamiltonian, None)?;
    let shifted = sign.plus(1.0, &DenseMatrix::identity(2 * n));
    let (all, first, last) = (0..2 * n, 0..n, n..2 * n);
    let part = |columns: core::ops::Range<usize>| {
        shifted.part(&all.clone().collect::<Vec<_>>(), &columns.collect::<Vec<_>>())
    };
    let (known, unknown) = (part(first), SingularValues::of(&part(last))?);
    let columns = (0..n).map(|j| unknown.shortest(&known.column(j), f64::EPSILON)).collect::<Vec<_>>();
    let x = DenseMatrix::from_fn(n, n, |i, j| -(columns[j][i] + columns[i][j]) / 2.0);
    let residual = a.transposed().times(&x).plus(1.0, &x.times(a)).plus(1.0, q);
    let residual = residual.plus(-1.0, &x.times(g).times(&x));
    let closed = a.plus(-1.0, &g.times(&x));
    let change = lyapunov(closed, residual)?;
    let x = x.plus(1.0, &change);
    Some(x.plus(1.0, &x.transposed()).scaled(0.5)).filter(DenseMatrix::is_finite)
}

/// Returns the solution of AᵀX + XA + Q = 0 for eigenvalues of A in the left half-plane. While A
/// becomes its sign, −I, Q becomes 2 X.
fn lyapunov(a: DenseMatrix, q: DenseMatrix) -> Option<DenseMatrix> {
    let (_, doubled) = sign(a, Some(q))?;
    doubled.map(|doubled| doubled.scaled(0.5))
}

/// Computes the sign of a matrix without eigenvalues on the imaginary axis, and the limit of Q
/// under Q ← (cQ + Z⁻ᵀQZ⁻¹/c)/2.
fn sign(mut z: DenseMatrix, mut q: Option<DenseMatrix>) -> Option<(DenseMatrix, Option<DenseMatrix>)> {
    let identity = DenseMatrix::identity(z.rows());
    let mut is_last = false;
    for _ in 0..MAX_ITERATIONS {
        let factors = TriangularFactors::new(z.clone(), 0.0)?;
        let inverse = factors.solve_columns(&identity);
        // Near the limit, scaling would slow convergence.
        let c = if is_last { 1.0 } else { (-factors.mean_log()).exp() };
        let next = z.scaled(c / 2.0).plus(0.5 / c, &inverse);
        q = q.map(|q| q.scaled(c / 2.0).plus(0.5 / c, &inverse.transposed().times(&q).times(&inverse)));
        let (change, size) = (next.plus(-1.0, &z).largest(), next.largest());
        z = next;
        if !size.is_finite() {
            return None;
        }
        if is_last && change <= f64::EPSILON.sqrt() * size {
            return Some((z, q));
        }
        is_last = change <= 1e-3 * size;
    }
    None
}

/// Returns the stabilising solution of X = AᵀX(I + GX)⁻¹A + Q with G = BR⁻¹Bᵀ, and the gain K = (R +
/// BᵀXB)⁻¹BᵀXA, if there are any.
pub(super) fn discrete(
    (a, b): (&DenseMatrix, &DenseMatrix),
    (g, q, r): (&DenseMatrix, &DenseMatrix, &DenseMatrix),
) -> Option<(DenseMatrix, DenseMatrix)> {
    let gain = |x: &DenseMatrix| {
        let of_inputs = b.transposed().times(x);
        let factors = TriangularFactors::new(r.plus(1.0, &of_inputs.times(b)), 0.0)?;
        Some(factors.solve_columns(&of_inputs.times(a)))
    };
    let mut x = doubled(a, g, q)?;
    let mut k = gain(&x)?;
    // If modes grow strongly in a step, doubling loses digits. The cost of a feedback is a sum of
    // positive terms and loses none.
    for _ in 0..MAX_REFINEMENTS {
        let of_inputs = k.transposed().times(r).times(&k);
        let next = stein(a.plus(-1.0, &b.times(&k)), q.plus(1.0, &of_inputs))?;
        let change = next.plus(-1.0, &x).largest();
        x = next;
        k = gain(&x)?;
        if change <= ROUNDED * x.largest() {
            break;
        }
    }
    Some((x, k))
}

fn doubled(a: &DenseMatrix, g: &DenseMatrix, q: &DenseMatrix) -> Option<DenseMatrix> {
    let (mut a, mut g, mut h) = (a.clone(), g.clone(), q.clone());
    let identity = DenseMatrix::identity(a.rows());
    for _ in 0..MAX_ITERATIONS {
        let factors = TriangularFactors::new(identity.plus(1.0, &g.times(&h)), 0.0)?;
        let (to_a, to_g) = (factors.solve_columns(&a), factors.solve_columns(&g));
        let change = a.transposed().times(&h).times(&to_a);
        g = g.plus(1.0, &a.times(&to_g).times(&a.transposed()));
        h = h.plus(0.5, &change).plus(0.5, &change.transposed());
        a = a.times(&to_a);
        if !h.is_finite() || !g.is_finite() {
            return None;
        }
        if change.largest() <= f64::EPSILON * h.largest() {
            return Some(h);
        }
    }
    None
}

/// Returns the solution of X = FᵀXF + E for eigenvalues of F inside the unit circle. It is the sum
/// of (Fᵀ)ᵏEFᵏ, and each round doubles the number of its terms.
fn stein(mut f: DenseMatrix, mut e: DenseMatrix) -> Option<DenseMatrix> {
    for _ in 0..MAX_ITERATIONS {
        let more = f.transposed().times(&e).times(&f);
        e = e.plus(1.0, &more);
        f = f.times(&f);
        if !e.is_finite() || !f.is_finite() {
            return None;
        }
        if more.largest() <= f64::EPSILON * e.largest() {
            return Some(e);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{DenseMatrix, continuous, discrete};

    #[test]
    fn the_worked_examples_hold() {
        let [one, two, three] = [1.0, 2.0, 3.0].map(|entry| DenseMatrix::from_rows(&[[entry]]));
        let in_continuous_time = continuous(&one, &one, &three).expect("a solution")[(0, 0)];
        assert!((in_continuous_time - 3.0).abs() < 1e-14, "{in_continuous_time}");
        let (cost, _) = discrete((&two, &one), (&one, &one, &one)).expect("a solution");
        let in_discrete_time = cost[(0, 0)];
        assert!((in_discrete_time - (2.0 + 5.0_f64.sqrt())).abs() < 1e-14, "{in_discrete_time}");
    }
}
