//! Accelerations, and the accelerations that reactions add, from one factorisation of the mass
//! matrix.
//!
//! Accelerations without reactions are a₀ = M⁻¹ f. A unit of reaction k acts along the gradient d_k
//! of its rate, and adds w_k = M⁻¹ d_k. With M = Lᵀ D L, each needs two triangular solutions.
//! Degrees of freedom farther from the ground come later, and are eliminated first: this preserves
//! the zeros between branches of a tree.
//!
//! Steps use the coordinates z = √D L v of velocities, in which the kinetic energy is ½ z·z. There,
//! both gradients and responses are D^−½ L^−ᵀ d_k, which needs one triangular solution. They keep
//! the zeros of d_k outside its path to the ground.
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
use core::ops::DerefMut;
use core::slice;

use super::Terms;
use crate::linalg::singular::regular;
use crate::linalg::vector::add;
use crate::scalar::Scalar;

/// Number of vectors that are solved for together.
const TOGETHER: usize = 6;

/// Terms in which generalised forces take the place of free accelerations, and the inertia under
/// which they act.
#[derive(Clone, Copy, Debug)]
pub struct ForcedTerms<T, S, const N: usize> {
    terms: T,
    /// `None` if the terms hold free accelerations and responses already.
    inertia: Option<[[S; N]; N]>,
}

impl<T, S: Scalar, const N: usize> ForcedTerms<T, S, N> {
    /// Wraps terms that hold free accelerations and responses.
    #[inline]
    pub fn complete(terms: T) -> Self {
        ForcedTerms { terms, inertia: None }
    }

    /// Wraps terms that hold generalised forces, under this mass matrix.
    #[inline]
    pub fn new(terms: T, mass: [[S; N]; N]) -> Self {
        ForcedTerms { terms, inertia: Some(mass) }
    }

    /// Wraps terms that hold generalised forces, for a step of length `h`, or for an instant if it
    /// is zero. `damping` holds the second derivatives of the dissipation function.
    #[inline]
    pub fn damped(terms: T, mass: [[S; N]; N], damping: &[[S; N]; N], h: S) -> Self {
        let mut inertia = mass;
        for (row, resistances) in inertia.iter_mut().zip(damping).filter(|_| h != S::ZERO) {
            for (entry, resistance) in row.iter_mut().zip(resistances) {
                *entry = h.multiply_add(*resistance, *entry);
            }
        }
        Self::new(terms, inertia)
    }
}

impl<T, S: Scalar, const N: usize, const K: usize> ForcedTerms<T, S, N>
where
    T: DerefMut<Target = Terms<S, N, K>>,
{
    /// Returns the terms.
    pub(super) fn terms(&self) -> &Terms<S, N, K> {
        &self.terms
    }

    /// Returns the terms with free accelerations and responses. If the inertia is singular, they
    /// are not finite.
    #[must_use]
    pub fn accelerated(mut self) -> T {
        if let Some(inertia) = self.inertia {
            accelerate(&mut self.terms, &MassFactors::new(inertia));
        }
        self.terms
    }

    /// Expresses the terms in coordinates of velocities in which the inertia is one. Without an
    /// inertia, or if it is not positive definite, they are the velocities themselves.
    pub(super) fn normalise(&mut self) -> Metric<S, N> {
        let Some(inertia) = self.inertia.take() else { return Metric { factors: None } };
        let terms = &mut *self.terms;
        match MassFactors::new(inertia) {
            MassFactors::Definite(factors) => {
                let factors = TreeFactors::new(factors);
                factors.normalise(slice::from_mut(&mut terms.free));
                factors.normalise(&mut terms.rows);
                terms.responses = terms.rows;
                Metric { factors: Some(factors) }
            }
            factors @ MassFactors::Indefinite(_) => {
                accelerate(terms, &factors);
                Metric { factors: None }
            }
        }
    }
}

fn accelerate<S: Scalar, const N: usize, const K: usize>(
    terms: &mut Terms<S, N, K>,
    factors: &MassFactors<S, N>,
) {
    [terms.free] = factors.solve(&[terms.free]);
    terms.responses = factors.solve(&terms.rows);
}

/// The coordinates of velocities in which [`ForcedTerms::normalise`] expresses terms.
pub(super) struct Metric<S, const N: usize> {
    /// `None` if they are the velocities.
    factors: Option<TreeFactors<S, N>>,
}

impl<S: Scalar, const N: usize> Metric<S, N> {
    /// Returns the velocities with these coordinates.
    pub(super) fn velocities(&self, mut coordinates: [S; N]) -> [S; N] {
        if let Some(factors) = &self.factors {
            factors.restore(&mut coordinates);
        }
        coordinates
    }
}

/// The factors of a positive definite matrix, M = Lᵀ D L.
struct TreeFactors<S, const N: usize> {
    /// L below the diagonal, and the reciprocals of D on it.
    factors: [[S; N]; N],
    /// The places of each row of L that are not zero, and their number.
    places: [([usize; N], usize); N],
    /// D^−½
    roots: [S; N],
}

impl<S: Scalar, const N: usize> TreeFactors<S, N> {
    fn new(factors: [[S; N]; N]) -> Self {
        let mut places = [([0; N], 0); N];
        for (k, (places, count)) in places.iter_mut().enumerate() {
            for i in (0..k).filter(|&i| factors[k][i] != S::ZERO) {
                places[*count] = i;
                *count += 1;
            }
        }
        TreeFactors { factors, places, roots: array::from_fn(|k| factors[k][k].sqrt()) }
    }

    /// Returns the entries of a row of L that are not zero, with their places.
    fn row(&self, k: usize) -> impl Iterator<Item = (usize, S)> {
        let (places, count) = &self.places[k];
        places[..*count].iter().map(move |&i| (i, self.factors[k][i]))
    }

    /// Computes D^−½ L^−ᵀ x for each of these vectors, in place.
    fn normalise(&self, vectors: &mut [[S; N]]) {
        for vectors in vectors.chunks_mut(TOGETHER) {
            let mut x = [[S::ZERO; TOGETHER]; N];
            for (lane, vector) in vectors.iter().enumerate() {
                for (x, entry) in x.iter_mut().zip(vector) {
                    x[lane] = *entry;
                }
            }
            for k in (0..N).rev() {
                let own = x[k];
                if own == [S::ZERO; TOGETHER] {
                    continue;
                }
                for (i, factor) in self.row(k) {
                    x[i] = array::from_fn(|lane| (-factor).multiply_add(own[lane], x[i][lane]));
                }
            }
            for (lane, vector) in vectors.iter_mut().enumerate() {
                for (entry, (x, root)) in vector.iter_mut().zip(x.iter().zip(&self.roots)) {
                    *entry = x[lane] * *root;
                }
            }
        }
    }

    /// Computes L⁻¹ D^−½ x in place.
    fn restore(&self, x: &mut [S; N]) {
        for k in 0..N {
            let own = x[k] * self.roots[k];
            x[k] = self.row(k).fold(own, |sum, (i, factor)| (-factor).multiply_add(x[i], sum));
        }
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
