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

use super::{LimitSlope, Terms};
use crate::linalg::singular::regular;
use crate::linalg::vector::{UNROLLED, add, add_scaled};
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

    /// Returns the terms and the mass matrix, to which emitted code adds that of dampers, times the
    /// length of the step. Complete terms then count as forced ones, with a mass matrix of zeros.
    #[inline(always)]
    pub fn parts(&mut self) -> (&mut T, &mut [[S; N]; N]) {
        (&mut self.terms, self.inertia.get_or_insert([[S::ZERO; N]; N]))
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

impl<S: Scalar, const N: usize, const K: usize, const L: usize> Terms<S, N, K, [LimitSlope<S>; L]> {
    /// Returns terms of zeros, which emitted code fills.
    #[inline(always)]
    #[must_use]
    pub fn zeros() -> Self {
        let (zeros, matrix) = ([S::ZERO; K], [[S::ZERO; N]; K]);
        let none = LimitSlope { limited: 0, reaction: 0, kinetic: S::ZERO, fixed: S::ZERO };
        Terms {
            free: [S::ZERO; N],
            responses: matrix,
            rows: matrix,
            gaps: zeros,
            rates: zeros,
            drifts: zeros,
            restitutions: zeros,
            kinetic: zeros,
            fixed: zeros,
            slopes: [none; L],
        }
    }
}

impl<S: Scalar, const N: usize, const K: usize, const L: usize>
    ForcedTerms<Terms<S, N, K, [LimitSlope<S>; L]>, S, N>
{
    /// Returns terms and a mass matrix of zeros, whose [`parts`](Self::parts) emitted code fills.
    #[inline(always)]
    #[must_use]
    pub fn zeros() -> Self {
        ForcedTerms { terms: Terms::zeros(), inertia: Some([[S::ZERO; N]; N]) }
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
            accelerate(&mut self.terms, &MassFactors::new(&inertia));
        }
        self.terms
    }

    /// Computes free accelerations, and the coordinates of velocities in which the inertia is one.
    /// Responses follow from [`Metric::respond`]. Without an inertia, or if it is not positive
    /// definite, the coordinates are the velocities, and responses are complete.
    pub(super) fn normalise(&mut self) -> (&mut Terms<S, N, K>, Metric<S, N>) {
        let terms = &mut *self.terms;
        let factors = match self.inertia.as_ref().map(MassFactors::new) {
            Some(MassFactors::Definite(factors)) => {
                [terms.free] = factors.solve(&[terms.free]);
                Some(factors)
            }
            Some(factors) => {
                accelerate(terms, &factors);
                None
            }
            None => None,
        };
        (terms, Metric { factors })
    }
}

fn accelerate<S: Scalar, const N: usize, const K: usize>(
    terms: &mut Terms<S, N, K>,
    factors: &MassFactors<S, N>,
) {
    [terms.free] = factors.solve(&[terms.free]);
    terms.responses = factors.solve(&terms.rows);
}

/// Coordinates of velocities.
pub(super) struct Metric<S, const N: usize> {
    /// `None` if they are the velocities.
    factors: Option<TreeFactors<S, N>>,
}

impl<S: Scalar, const N: usize> Metric<S, N> {
    /// True if the inertia is one in these coordinates: responses are then also the gradients of
    /// rates.
    pub(super) fn is_normal(&self) -> bool {
        self.factors.is_some()
    }

    /// Computes the responses to these reactions, if they are not complete.
    pub(super) fn respond<const K: usize>(&self, terms: &mut Terms<S, N, K>, acts: &[bool; K]) {
        let Some(factors) = &self.factors else { return };
        let mut next = (0..K).filter(|&k| acts[k]);
        loop {
            let together: [Option<usize>; TOGETHER] = array::from_fn(|_| next.next());
            if together[0].is_none() {
                break;
            }
            let mut x = [[S::ZERO; TOGETHER]; N];
            for (lane, k) in together.iter().enumerate() {
                let Some(k) = k else { break };
                x.iter_mut().zip(&terms.rows[*k]).for_each(|(x, entry)| x[lane] = *entry);
            }
            factors.normalise(&mut x);
            for (lane, k) in together.iter().enumerate() {
                let Some(k) = k else { break };
                terms.responses[*k].iter_mut().zip(&x).for_each(|(entry, x)| *entry = x[lane]);
            }
        }
    }

    /// Returns the velocities with these coordinates.
    pub(super) fn velocities(&self, coordinates: [S; N]) -> [S; N] {
        match &self.factors {
            Some(factors) => factors.restored(coordinates),
            None => coordinates,
        }
    }
}

/// The factors of a positive definite matrix, M = Lᵀ D L.
struct TreeFactors<S, const N: usize> {
    /// L below the diagonal, and the reciprocals of D on it.
    factors: [[S; N]; N],
    /// The place of the first entry of each row of L that is not zero.
    starts: [usize; N],
    /// D^−½
    roots: [S; N],
}

impl<S: Scalar, const N: usize> TreeFactors<S, N> {
    fn new(factors: [[S; N]; N]) -> Self {
        let start = |k: usize| (0..k).find(|&i| factors[k][i] != S::ZERO).unwrap_or(k);
        TreeFactors {
            starts: array::from_fn(start),
            roots: array::from_fn(|k| factors[k][k].sqrt()),
            factors,
        }
    }

    /// Returns the entries of a row of L that are not zero, with their places.
    fn row(&self, k: usize) -> impl Iterator<Item = (usize, S)> {
        let entries = self.factors[k][..k].iter().copied().enumerate().skip(self.starts[k]);
        entries.filter(|(_, entry)| *entry != S::ZERO)
    }

    /// Computes L^−ᵀ x in place, for several vectors at once.
    fn descend<const C: usize>(&self, x: &mut [[S; C]; N]) {
        for k in (0..N).rev() {
            let own = x[k];
            if own != [S::ZERO; C] {
                self.row(k).for_each(|(i, factor)| add(&mut x[i], -factor, &own));
            }
        }
    }

    /// Computes L⁻¹ x in place, for several vectors at once.
    fn ascend<const C: usize>(&self, x: &mut [[S; C]; N]) {
        for k in 0..N {
            let mut own = x[k];
            self.row(k).for_each(|(i, factor)| add(&mut own, -factor, &x[i]));
            x[k] = own;
        }
    }

    /// Computes D^−½ L^−ᵀ x in place, for several vectors at once.
    fn normalise<const C: usize>(&self, x: &mut [[S; C]; N]) {
        self.descend(x);
        x.iter_mut().zip(&self.roots).for_each(|(x, root)| *x = x.map(|entry| entry * *root));
    }

    /// Computes L⁻¹ D^−½ x.
    fn restored(&self, x: [S; N]) -> [S; N] {
        let mut x = array::from_fn(|k| [x[k] * self.roots[k]]);
        self.ascend(&mut x);
        x.map(|[entry]| entry)
    }

    /// Computes M⁻¹ x for several vectors at once.
    fn solve<const C: usize>(&self, vectors: &[[S; N]; C]) -> [[S; N]; C] {
        let mut x = transposed(vectors);
        self.descend(&mut x);
        for (k, x) in x.iter_mut().enumerate() {
            *x = x.map(|entry| entry * self.factors[k][k]);
        }
        self.ascend(&mut x);
        transposed(&x)
    }
}

/// The factors of a symmetric matrix.
enum MassFactors<S, const N: usize> {
    /// The factors, if all pivots are positive.
    Definite(TreeFactors<S, N>),
    /// The matrix itself.
    Indefinite([[S; N]; N]),
}

impl<S: Scalar, const N: usize> MassFactors<S, N> {
    fn new(matrix: &[[S; N]; N]) -> Self {
        let mut factors = *matrix;
        for k in (0..N).rev() {
            // A copy is known to be apart from the rows above.
            let own = factors[k];
            if !(own[k] > S::ZERO && own[k].is_finite()) {
                return MassFactors::Indefinite(*matrix);
            }
            let reciprocal = S::ONE / own[k];
            for (i, row) in factors[..k].iter_mut().enumerate().filter(|(i, _)| own[*i] != S::ZERO) {
                let end = if const { N <= UNROLLED } { N } else { i + 1 };
                add_scaled(&mut row[..end], -(own[i] * reciprocal), &own[..end]);
            }
            factors[k] = own.map(|entry| entry * reciprocal);
            factors[k][k] = reciprocal;
        }
        MassFactors::Definite(TreeFactors::new(factors))
    }

    /// Returns the solutions for these right-hand sides.
    fn solve<const C: usize>(&self, rights: &[[S; N]; C]) -> [[S; N]; C] {
        match self {
            MassFactors::Definite(factors) => factors.solve(rights),
            MassFactors::Indefinite(matrix) => rights.map(|right| regular(matrix, &right, N)),
        }
    }
}

fn transposed<S: Scalar, const N: usize, const C: usize>(matrix: &[[S; N]; C]) -> [[S; C]; N] {
    array::from_fn(|i| array::from_fn(|j| matrix[j][i]))
}
