//! The method of Euler and Maruyama, y⁺ = y + h f + Σ gₖ ΔWₖ.
//!
//! Source: Maruyama, *Continuous Markov processes and stochastic equations*, Rend. Circ. Mat.
//! Palermo 4 (1955); Kloeden, Platen, *Numerical Solution of Stochastic Differential Equations*,
//! §10.2.

use super::{Scheme, StepPath, stochastic_steps};
use crate::integrate::method::{Method, Work};
use crate::integrate::wiener::WienerPath;
use crate::linalg::vector::add;
use crate::scalar::Number;
use crate::system::{NoiseKind, OdeSystem, SettingError};

const MULTIPLICATIVE: &str = "noise drives a component that its diffusion depends on, where the method of Euler \
                              and Maruyama finds the solution of Itô: take `StochasticRungeKutta4`";

/// The method of Euler and Maruyama in equal steps: one evaluation of the equations and of the
/// diffusion.
///
/// Its strong and weak order is 1 for noise whose diffusion depends only on components that noise
/// does not drive. Other noise is [rejected](NoiseKind::Multiplicative). Without dissipation it
/// gains energy like the explicit Euler method;
/// [`StochasticRungeKutta4`](super::StochasticRungeKutta4) does not.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct EulerMaruyama<S> {
    /// Length of a step.
    pub step: S,
    /// Path of the noise.
    pub path: WienerPath,
}

impl<M: OdeSystem + ?Sized> Method<M> for EulerMaruyama<M::Scalar> {
    stochastic_steps! { "Euler–Maruyama", EulerMaruyamaScheme }
}

/// The formula of [`EulerMaruyama`].
#[derive(Clone, Copy, Debug)]
pub enum EulerMaruyamaScheme {}

impl<M: OdeSystem + ?Sized> Scheme<M> for EulerMaruyamaScheme {
    fn check(kind: NoiseKind) -> Result<(), SettingError<M::Scalar>> {
        match kind {
            NoiseKind::Additive | NoiseKind::Unambiguous => Ok(()),
            NoiseKind::Multiplicative => Err(SettingError::Invalid(MULTIPLICATIVE)),
        }
    }

    fn uses_area(_kind: NoiseKind) -> bool {
        false
    }

    fn increment(
        system: &M,
        t: M::Scalar,
        y: &M::State,
        h: M::Scalar,
        path: &StepPath<M::Scalar>,
        work: &mut Work,
    ) -> M::State {
        work.evaluations += 1;
        let whole = [M::Scalar::ONE, M::Scalar::ZERO];
        let mut change = path.weighted(whole, |increments| system.diffuse(t, y, increments));
        add(&mut change, h, &system.rhs(t, y));
        change
    }
}
