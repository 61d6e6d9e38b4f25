//! Simplified Newton iterations for the changes at the stages of a step.
//!
//! Unlike iterations of symplectic methods, they end at a fraction of the tolerance. In the basis
//! of the eigenvectors of A⁻¹, the equations for w = T⁻¹ z are one real and one complex system.
//! Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.8.

use super::linear::{ComplexShift, LinearSystem, RealShift};
use super::tableau::{BASIS, COMPLEX, INVERSE_BASIS, NODES, REAL, STAGES};
use crate::integrate::method::Work;
use crate::linalg::vector::add;
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, StateVector, StepFailure};

/// Maximum number of iterations; beyond it, shorter steps cost less.
pub(super) const MAX_ITERATIONS: u32 = 7;

/// Changes of the state at the stages.
pub(super) type StageChanges<Y> = [Y; STAGES];

/// The factors of the equations of all stages for steps of one length.
#[derive(Clone, Debug)]
pub(super) struct StageFactors<S: Scalar, Y: StateVector<S>> {
    pub(super) h: S,
    pub(super) real: RealShift<S, Y>,
    complex: ComplexShift<S, Y>,
}

impl<S: Scalar, Y: StateVector<S>> StageFactors<S, Y> {
    /// Factors the equations; `None` if a matrix is singular or not finite.
    pub(super) fn new(linearised: &LinearSystem<S, Y>, h: S) -> Option<Self> {
        let mu = |eigenvalue: f64| S::from_f64(eigenvalue) / h;
        let real = RealShift::new(linearised, mu(REAL))?;
        Some(StageFactors {
            h,
            real,
            complex: ComplexShift::new(linearised, (mu(COMPLEX.0), mu(COMPLEX.1)))?,
        })
    }
}

/// The data of a step, with the tolerances for its equations.
#[derive(Clone, Copy)]
pub(super) struct StageSystem<'a, M: OdeSystem + ?Sized> {
    pub(super) system: &'a M,
    pub(super) t: M::Scalar,
    pub(super) y: &'a M::State,
    pub(super) h: M::Scalar,
    /// Reciprocals of the tolerated error of each component.
    pub(super) weights: &'a M::State,
    /// Corrections are omitted if their expected sum is at most this fraction of the tolerance.
    pub(super) goal: M::Scalar,
}

/// The outcome of converged iterations.
#[derive(Clone, Copy, Debug)]
pub(super) struct NewtonOutcome<S> {
    pub(super) iterations: u32,
    /// The ratio of the last two corrections, if there were two.
    pub(super) rate: Option<S>,
    /// The expected sum of all further corrections, relative to the last one.
    pub(super) remainder: S,
}

impl<M: OdeSystem + ?Sized> StageSystem<'_, M> {
    /// Solves the equations from the starting values in `stages`, given the remainder of the last
    /// step.
    ///
    /// # Errors
    /// If iterations do not converge, or lead to a state where the system is undefined.
    #[inline]
    pub(super) fn solve(
        &self,
        linearised: &LinearSystem<M::Scalar, M::State>,
        factors: &StageFactors<M::Scalar, M::State>,
        stages: &mut StageChanges<M::State>,
        remainder: M::Scalar,
        work: &mut Work,
    ) -> Result<NewtonOutcome<M::Scalar>, StepFailure<M::Scalar>> {
        let mut modes = product(&INVERSE_BASIS, stages);
        let mut progress = NewtonOutcome { iterations: 0, rate: None, remainder };
        let mut before = M::Scalar::ZERO;
        while progress.iterations < MAX_ITERATIONS {
            progress.iterations += 1;
            work.iterations += 1;
            let correction = self.correction(linearised, factors, (stages, &modes), work);
            let size = self.size(&correction);
            if !size.is_finite() {
                return Err(StepFailure::NotFinite);
            }
            if progress.iterations > 1 {
                let rate = size / before;
                progress.rate = Some(rate);
                progress.remainder = rate / (M::Scalar::ONE - rate);
                let left = MAX_ITERATIONS - progress.iterations;
                let expected = (0..left).fold(progress.remainder * size, |size, _| size * rate);
                if size > M::Scalar::ZERO && !(rate < M::Scalar::ONE && expected <= self.goal) {
                    break;
                }
            }
            for (mode, correction) in modes.iter_mut().zip(&correction) {
                add(mode, M::Scalar::ONE, correction);
            }
            *stages = product(&BASIS, &modes);
            if size == M::Scalar::ZERO || progress.remainder * size <= self.goal {
                return Ok(progress);
            }
            before = size;
        }
        Err(StepFailure::NotConverged { iterations: progress.iterations })
    }

    /// Computes the correction of the stages in the basis of eigenvectors.
    #[inline(always)]
    fn correction(
        &self,
        linearised: &LinearSystem<M::Scalar, M::State>,
        factors: &StageFactors<M::Scalar, M::State>,
        (stages, modes): (&StageChanges<M::State>, &StageChanges<M::State>),
        work: &mut Work,
    ) -> StageChanges<M::State> {
        let mut rates = *stages;
        for (rate, node) in rates.iter_mut().zip(NODES) {
            let mut y = *self.y;
            add(&mut y, M::Scalar::ONE, rate);
            *rate = self.system.rhs(M::Scalar::from_f64(node).multiply_add(self.h, self.t), &y);
        }
        work.evaluations += STAGES as u64;
        let mut residual = product(&INVERSE_BASIS, &rates);
        let [mu, alpha, beta] = numbers::<M::Scalar>(&[REAL, COMPLEX.0, COMPLEX.1]);
        let (mu, alpha, beta) = (mu / self.h, alpha / self.h, beta / self.h);
        add(&mut residual[0], -mu, &modes[0]);
        add(&mut residual[1], -alpha, &modes[1]);
        add(&mut residual[1], beta, &modes[2]);
        add(&mut residual[2], -alpha, &modes[2]);
        add(&mut residual[2], -beta, &modes[1]);
        let real = factors.real.solve(linearised, &residual[0]);
        let complex = factors.complex.solve(linearised, (&residual[1], &residual[2]));
        [real, complex.0, complex.1]
    }

    /// Computes the root mean square of a correction relative to the tolerance.
    #[inline(always)]
    fn size(&self, correction: &StageChanges<M::State>) -> M::Scalar {
        let mut sum = M::Scalar::ZERO;
        for mode in correction {
            for (entry, weight) in mode.as_ref().iter().zip(self.weights.as_ref()) {
                let part = *entry * *weight;
                // Zero if nothing moves and nothing is tolerated.
                if *entry != M::Scalar::ZERO {
                    sum = part.multiply_add(part, sum);
                }
            }
        }
        let count = STAGES * self.y.as_ref().len();
        (sum / M::Scalar::from_f64(count as f64)).sqrt()
    }
}

/// Returns the product of a matrix with vectors as entries.
#[inline(always)]
fn product<S: Scalar, Y: StateVector<S>>(
    matrix: &[[f64; STAGES]; STAGES],
    vectors: &StageChanges<Y>,
) -> StageChanges<Y> {
    let [one, two, three] = matrix;
    [weighted(&numbers(one), vectors), weighted(&numbers(two), vectors), weighted(&numbers(three), vectors)]
}

/// Converts coefficients to numbers, without closures, which are not always inlined.
#[inline(always)]
pub(super) fn numbers<S: Number>([one, two, three]: &[f64; STAGES]) -> [S; STAGES] {
    [S::from_f64(*one), S::from_f64(*two), S::from_f64(*three)]
}

/// Computes Σ weight vector.
#[inline(always)]
pub(super) fn weighted<S: Scalar, Y: StateVector<S>>(
    [a, b, c]: &[S; STAGES],
    [one, two, three]: &StageChanges<Y>,
) -> Y {
    let mut sum = *one;
    let others = two.as_ref().iter().zip(three.as_ref());
    for (sum, (two, three)) in sum.as_mut().iter_mut().zip(others) {
        *sum = c.multiply_add(*three, b.multiply_add(*two, *a * *sum));
    }
    sum
}
