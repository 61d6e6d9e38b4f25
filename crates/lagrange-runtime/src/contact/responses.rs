//! Accelerations, and the accelerations that reactions add, from one factorisation of the mass
//! matrix.
//!
//! Accelerations without reactions are a₀ = M⁻¹ f. A unit of reaction k acts along the gradient d_k
//! of its rate, and adds w_k = M⁻¹ d_k. With M = Lᵀ D L, each needs two triangular solutions.
//! Degrees of freedom farther from the ground come later, and are eliminated first: this preserves
//! the zeros between branches of a tree.
//!
//! In a step of length h, dampers act by the velocities at its end. With f at its beginning, M Δv =
//! h (f − C Δv) + Σ d_k r_k. This equals a step with M + h C in place of M, and is stable for any
//! damper. Sources: Featherstone, *Rigid Body Dynamics Algorithms*, §6.5; Baraff, Witkin, "Large
//! steps in cloth simulation", *SIGGRAPH* (1998) 43–54.
//!
//! # A damped mass in numbers
//!
//! m = 2, c = 6, v = 4 and no other force: f = −24 and a₀ = −12. In a step of h = 1 it would end
//! with −8. With m + h c = 8 the velocity changes by −24/8 = −3 instead, to 1.

use core::array;

use super::Terms;
use crate::linalg::singular::regular;
use crate::linalg::vector::add;
use crate::scalar::Scalar;

impl<S: Scalar, const N: usize, const K: usize, L> Terms<S, N, K, L> {
    /// Returns the terms under this mass matrix. They contain the generalised forces in place of
    /// the free accelerations. If the matrix is singular, the result is not finite.
    #[must_use]
    pub fn accelerated(mut self, mass: &[[S; N]; N]) -> Self {
        let factors = MassFactors::new(*mass);
        [self.free] = factors.solve(&[self.free]);
        self.responses = factors.solve(&self.rows);
        self
    }

    /// Returns the terms for a step of length `h`, or for an instant if it is zero. `damping` holds
    /// the second derivatives of the dissipation function.
    #[must_use]
    pub fn damped(self, mass: &[[S; N]; N], damping: &[[S; N]; N], h: S) -> Self {
        let mut inertia = *mass;
        for (row, resistances) in inertia.iter_mut().zip(damping).filter(|_| h != S::ZERO) {
            for (entry, resistance) in row.iter_mut().zip(resistances) {
                *entry = h.multiply_add(*resistance, *entry);
            }
        }
        self.accelerated(&inertia)
    }
}

/// The factors of a symmetric matrix.
enum MassFactors<S, const N: usize> {
    /// L below the diagonal, and the reciprocals of D on it, all positive.
    Definite([[S; N]; N]),
    /// The matrix itself, if not all pivots are positive.
    Indefinite([[S; N]; N]),
}

impl<S: Scalar, const N: usize> MassFactors<S, N> {
    fn new(matrix: [[S; N]; N]) -> Self {
        let mut factors = matrix;
        for k in (0..N).rev() {
            let (above, own) = factors.split_at_mut(k);
            let (own, pivot) = own[0].split_at_mut(k);
            if !(pivot[0] > S::ZERO && pivot[0].is_finite()) {
                return MassFactors::Indefinite(matrix);
            }
            pivot[0] = S::ONE / pivot[0];
            for (i, row) in above.iter_mut().enumerate().filter(|(i, _)| own[*i] != S::ZERO) {
                let multiple = -(own[i] * pivot[0]);
                for (entry, factor) in row[..=i].iter_mut().zip(&*own) {
                    *entry = multiple.multiply_add(*factor, *entry);
                }
            }
            own.iter_mut().for_each(|entry| *entry = *entry * pivot[0]);
        }
        MassFactors::Definite(factors)
    }

    /// Returns the solutions for these right-hand sides.
    fn solve<const C: usize>(&self, rights: &[[S; N]; C]) -> [[S; N]; C] {
        let factors = match self {
            MassFactors::Definite(factors) => factors,
            MassFactors::Indefinite(matrix) => return rights.map(|right| regular(matrix, &right, N)),
        };
        // All sides are solved in one pass over the factors.
        let mut x: [[S; C]; N] = transposed(rights);
        for k in (0..N).rev() {
            let (before, own) = x.split_at_mut(k);
            for (entries, factor) in before.iter_mut().zip(&factors[k]).filter(|(_, l)| **l != S::ZERO) {
                add(entries, -*factor, &own[0]);
            }
        }
        for (k, row) in factors.iter().enumerate() {
            let (before, own) = x.split_at_mut(k);
            own[0] = own[0].map(|entry| entry * row[k]);
            for (entries, factor) in before.iter().zip(row).filter(|(_, l)| **l != S::ZERO) {
                add(&mut own[0], -*factor, entries);
            }
        }
        transposed(&x)
    }
}

fn transposed<S: Scalar, const N: usize, const C: usize>(matrix: &[[S; N]; C]) -> [[S; C]; N] {
    array::from_fn(|i| array::from_fn(|j| matrix[j][i]))
}
