//! Periodic orbits, their stability, and chaos.
//!
//! ```
//! use lagrange::orbits::Orbits;
//!
//! lagrange::system! {
//!     /// Duffing's oscillator.
//!     struct Duffing;
//!     param c = 0.2, f = 0.3;
//!     coord x;
//!     kinetic = 1/2 * dot(x)^2;
//!     potential = 1/2 * x^2 + 1/4 * x^4;
//!     dissipation = 1/2 * c * dot(x)^2;
//!     force x = f * cos(t);
//!     emit { jacobian }
//! }
//!
//! let duffing = Duffing::default();
//! let orbit = duffing.orbit([0.5, 0.5], std::f64::consts::TAU).solve()?;
//! assert!(orbit.is_stable());
//! // Areas shrink by exp(−c T) in a period.
//! let [(re, im), _] = orbit.multipliers[..] else { panic!() };
//! assert!((re * re + im * im - (-0.2 * orbit.period).exp()).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod exponents;
mod flow;
mod periodic;

pub use error::OrbitError;
pub use exponents::LyapunovSearch;
pub use periodic::{OrbitSearch, PeriodicOrbit};

use crate::simulate::InitialState;
use crate::system::{OdeSystem, ParametricSystem};

/// Orbits of systems in `f64`.
pub trait Orbits<const N: usize>: ParametricSystem + OdeSystem<Scalar = f64, State = [f64; N]> {
    /// Searches for a periodic orbit near a state, with this period or one near it. Continue with
    /// [`solve`](OrbitSearch::solve).
    fn orbit(&self, near: impl InitialState<Self::State>, period: f64) -> OrbitSearch<'_, Self, N> {
        OrbitSearch::new(self, near.into_state(), period)
    }

    /// Prepares Lyapunov exponents of the motion from a state. Continue with
    /// [`run`](LyapunovSearch::run).
    fn lyapunov(&self, start: impl InitialState<Self::State>) -> LyapunovSearch<'_, Self, N> {
        LyapunovSearch::new(self, start.into_state())
    }
}

impl<M, const N: usize> Orbits<N> for M where M: ParametricSystem + OdeSystem<Scalar = f64, State = [f64; N]> {}
