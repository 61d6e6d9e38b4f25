//! Linear analysis: equilibria and steady motions, linear models, modes, responses, regulators,
//! observers.
//!
//! All derivatives are emitted, by `emit { system_matrix }`; nothing is approximated by differences
//! of functions. Computations on matrices are in double precision.
//!
//! ```
//! use lagrange::linear::{Linearise, Stability};
//!
//! lagrange::system! {
//!     /// A pendulum with friction in its pivot.
//!     #[derive(Debug)]
//!     struct Pendulum;
//!     param l = 0.5, g = 9.81, c = 0.1;
//!     coord theta;
//!     input u;
//!     kinetic = 1/2 * (l * dot(theta))^2;
//!     potential = -g * l * cos(theta);
//!     dissipation = 1/2 * c * dot(theta)^2;
//!     force theta = u;
//!     output height = -l * cos(theta);
//!     emit { system_matrix }
//! }
//!
//! let pendulum = Pendulum::default();
//! let upright = pendulum.equilibrium([3.0, 0.0]).solve()?;
//! assert!((upright.state[0] - std::f64::consts::PI).abs() < 1e-15);
//!
//! let model = pendulum.linearise(0.0, upright.state)?;
//! assert_eq!((model.states(), model.inputs()), (&["theta".into(), "theta_dot".into()][..], &["u"][..]));
//! assert!((model.a()[(1, 0)] - 9.81 / 0.5).abs() < 1e-13);
//! assert_eq!(model.modes()?.stability(), Stability::Unstable);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Constrained systems
//!
//! The states of a linear model are coordinates of the tangent space. They are positions and
//! velocities that the constraints leave free, chosen by pivots of the constraint Jacobian. The
//! other positions and velocities depend on them, and shapes of modes name them, too.
//!
//! # Orientations
//!
//! The displacements of a quaternion are small rotations about the body axes. They are named after
//! the angular velocities: `rotation(body.w_x)`.
//!
//! Sources: Golub, Van Loan, *Matrix Computations*, 4th ed.; Meirovitch, *Methods of Analytical
//! Dynamics*, §6; Hairer, Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., §VII.1.

mod corner;
mod equilibrium;
mod error;
mod frequency;
mod mode_motion;
mod model;
mod modes;
mod names;
#[cfg(feature = "plot")]
mod plots;
mod regulator;
mod response;
mod riccati;
mod sampled;
mod tables;
mod tangent;
mod transfer;
mod weakest;

pub use self::equilibrium::{Equilibrium, EquilibriumSearch};
pub use self::error::{
    Equation, EquilibriumCause, EquilibriumError, LinearisationError, ModeMotionError, NotConverged,
};
pub use self::frequency::{FrequencyResponse, StabilityMargins};
pub use self::mode_motion::ModeMotion;
pub use self::model::LinearModel;
pub use self::modes::{Eigenmode, Modes, Stability};
pub use self::regulator::{DesignError, DesignMatrix, Observer, Regulator};
pub use self::response::TimeResponse;
pub use self::sampled::SampledModel;
pub use self::transfer::{NoSuchChannel, Transfer};
pub use self::weakest::{Channel, WeakestDirection};
pub use crate::linalg::dense::DenseMatrix;

use crate::simulate::InitialState;
use crate::system::{LinearisedSystem, MechanicalSystem};

/// Lets every system with a [system matrix](LinearisedSystem) be analysed near an equilibrium.
pub trait Linearise: MechanicalSystem + Sized {
    /// Searches for an equilibrium near a state, or for a steady motion if its velocities are not
    /// zero: they are kept. Continue with [`solve`](EquilibriumSearch::solve).
    fn equilibrium(&self, near: impl InitialState<Self::State>) -> EquilibriumSearch<'_, Self>
    where
        Self: LinearisedSystem,
        Self::Scalar: Into<f64>,
    {
        EquilibriumSearch::near(self, near.into_state())
    }

    /// Linearises the equations of motion and the outputs at time `t` and a state.
    ///
    /// # Errors
    /// If the state violates the constraints, if a derivative is not finite there, or if the
    /// equations have a corner or a jump there.
    fn linearise(
        &self,
        t: Self::Scalar,
        state: impl InitialState<Self::State>,
    ) -> Result<LinearModel, LinearisationError<Self::Scalar>>
    where
        Self: LinearisedSystem,
        Self::Scalar: Into<f64>,
    {
        LinearModel::of(self, t, state.into_state())
    }

    /// Turns a mode of the linear model at time `t` and a state into a motion about that state. The
    /// amplitude is the peak of its largest displacement, in the unit of that coordinate. Continue
    /// with [`moments`](ModeMotion::moments) for a film, or [`extremes`](ModeMotion::extremes) for
    /// a picture.
    ///
    /// ```
    /// use lagrange::linear::Linearise;
    ///
    /// lagrange::system! {
    ///     /// A mass on a spring.
    ///     struct Oscillator;
    ///     coord x;
    ///     kinetic = 1/2 * dot(x)^2;
    ///     potential = 2 * x^2;
    ///     emit { system_matrix }
    /// }
    ///
    /// let modes = Oscillator.linearise(0.0, [0.0; 2])?.modes()?;
    /// let swinging = Oscillator.mode_motion(0.0, [0.0; 2], &modes.modes()[0], 0.3).level();
    /// for (second, (_, [x, _])) in swinging.moments(25.0)? {
    ///     assert!((x - 0.3 * (2.0 * second).cos()).abs() < 1e-15);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn mode_motion<'a>(
        &'a self,
        t: Self::Scalar,
        state: impl InitialState<Self::State>,
        mode: &'a Eigenmode,
        amplitude: f64,
    ) -> ModeMotion<'a, Self>
    where
        Self: LinearisedSystem,
    {
        ModeMotion::new(self, (t, state.into_state()), mode, amplitude)
    }
}

impl<M: MechanicalSystem> Linearise for M {}
