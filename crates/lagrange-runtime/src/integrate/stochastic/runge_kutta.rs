//! The classical Runge–Kutta method with noise in its stages.
//!
//! The stages are those of order four. Stage i has the rate h f + Σ gₖ (Wₖ + rᵢ Hₖ). Wₖ is the
//! increment of the path over the step. Hₖ is the area between the path and its chord, divided by
//! h.
//!
//! > r = (3 + √3, 3 − √3, 0, √3 − 9).
//!
//! Without noise it is the classical method. Let g depend only on time. Then the point of a stage
//! contains g (cᵢ W + vᵢ H) with v = (0, (3 + √3)/2, (3 − √3)/2, 0), and these numbers satisfy
//!
//! | condition | of | source |
//! |---|---|---|
//! | Σ bᵢ cᵢ = 1/2, Σ bᵢ vᵢ = 1 | f′ g ∫ W dt = f′ g h (W/2 + H) | strong order 3/2, Rößler, theorem 5.1 |
//! | Σ bᵢ (cᵢ² + vᵢ²/12) = 1/2 | the mean of f″ g² ∫ W² dt / 2 | the same |
//! | Σ bᵢ cᵢ rᵢ = −1 | g of first degree in t, by which ∫ t dW = h (W/2 − H) | the same |
//! | Σ bᵢ aᵢⱼ vⱼ = 1/2 | f′² g ∫∫ W dt dt, as far as W and H tell | small noise |
//! | Σ bᵢ cᵢ vᵢ = 1/2 | ∂f′/∂t g ∫ t W dt, as far as W and H tell | small noise |
//!
//! For noise of the size ε the error is therefore O(h⁴ + ε h² + ε² h^{3/2}). For linear equations
//! the errors of means and covariances are O(h⁴). `tools/stochastic_order.py` checks the
//! conditions.
//!
//! If the diffusion depends on components that noise drives, then r = 0. The noise acts as its
//! average over the step. The method then converges to the Stratonovich solution, with strong order
//! 1 if all noises commute. Source: Wong, Zakai, Ann. Math. Stat. 36 (1965).
//!
//! Sources: Rößler, *Runge–Kutta methods for the strong approximation of solutions of stochastic
//! differential equations*, SIAM J. Numer. Anal. 48 (2010), §5; Milstein, Tretyakov, *Mean-square
//! numerical methods for stochastic differential equations with small noises*, SIAM J. Sci. Comput.
//! 18 (1997).

use super::{Scheme, StepPath, stochastic_steps};
use crate::integrate::method::{Method, Work};
use crate::integrate::wiener::WienerPath;
use crate::linalg::vector::{StateVector, add, combined};
use crate::scalar::Number;
use crate::system::{NoiseKind, OdeSystem, SettingError};

const ROOT_OF_THREE: f64 = 1.732_050_807_568_877_2;
/// The factors rᵢ of the areas.
const AREAS: [f64; 4] = [3.0 + ROOT_OF_THREE, 3.0 - ROOT_OF_THREE, 0.0, ROOT_OF_THREE - 9.0];
/// The fractions cᵢ of the step at which the stages are evaluated.
const NODES: [f64; 4] = [0.0, 0.5, 0.5, 1.0];
/// The weights bᵢ, times six.
const WEIGHTS: [f64; 4] = [1.0, 2.0, 2.0, 1.0];

/// The classical Runge–Kutta method with noise, in equal steps: four evaluations of the equations
/// and of the diffusion.
///
/// | noise | strong order | small noise of the size ε |
/// |---|---|---|
/// | additive: the diffusion depends on time at most | 3/2 | h⁴ + ε h² + ε² h^{3/2} |
/// | the diffusion depends on nothing that noise drives | 1 | h⁴ + ε h² + ε² h |
/// | any other, in the sense of Stratonovich; all noises commute, or there is one | 1 | h⁴ + ε h |
/// | any other | 1/2 | h⁴ + ε h + ε² h^{1/2} |
///
/// Means and covariances of linear systems with additive noise have order 4.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StochasticRungeKutta4<S> {
    /// Length of a step.
    pub step: S,
    /// Path of the noise.
    pub path: WienerPath,
}

impl<M: OdeSystem + ?Sized> Method<M> for StochasticRungeKutta4<M::Scalar> {
    stochastic_steps! { "stochastic Runge–Kutta 4", StochasticRungeKutta4Scheme }
}

/// The formula of [`StochasticRungeKutta4`].
#[derive(Clone, Copy, Debug)]
pub enum StochasticRungeKutta4Scheme {}

impl<M: OdeSystem + ?Sized> Scheme<M> for StochasticRungeKutta4Scheme {
    fn check(_kind: NoiseKind) -> Result<(), SettingError<M::Scalar>> {
        Ok(())
    }

    fn uses_area(kind: NoiseKind) -> bool {
        kind != NoiseKind::Multiplicative
    }

    fn increment(
        system: &M,
        t: M::Scalar,
        y: &M::State,
        h: M::Scalar,
        path: &StepPath<M::Scalar>,
        work: &mut Work,
    ) -> M::State {
        work.evaluations += 4;
        let number = M::Scalar::from_f64;
        let (mut sum, mut change) = (y.zeros(), y.zeros());
        for ((area, node), weight) in AREAS.into_iter().zip(NODES).zip(WEIGHTS) {
            let (time, point) = (number(node).multiply_add(h, t), combined(y, number(node), &change));
            let weights = [M::Scalar::ONE, number(area)];
            change = path.weighted(weights, |increments| system.diffuse(time, &point, increments));
            add(&mut change, h, &system.rhs(time, &point));
            add(&mut sum, number(weight / 6.0), &change);
        }
        sum
    }
}
