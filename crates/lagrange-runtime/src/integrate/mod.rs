//! Methods that advance a system ẏ = f(t, y) in time.
//!
//! Each family of methods has its own file, which cites its source. A [`Method`] holds settings and
//! starts a [`Stepper`], which needs no heap. Steps end with a [`StepFailure`] instead of returning
//! NaN or infinity. States and times are summed with compensation, so rounding errors do not grow
//! with the number of steps unless the method itself amplifies them.

mod attempt;
mod canonical;
mod clock;
mod compensated;
mod corrected;
#[cfg(test)]
mod doubles;
mod error;
mod explicit;
mod fixed;
mod gauss_legendre;
mod interpolation;
mod jacobian;
mod lane_wise;
mod method;
mod newton;
mod prediction;
mod radau;
mod rk4;
mod splitting;
mod stability;
mod step_derivatives;
mod stiffness;
mod stochastic;
mod taylor;
mod undefined;
mod variational;
mod verner;
mod wiener;

pub use self::canonical::Hamiltonian;
pub use self::error::{IntegrationError, Outcome};
pub use self::explicit::ExplicitRungeKutta;
pub use self::fixed::{
    FixedLanes, FixedLastStep, FixedStepper, FixedSteps, Formula, LanesFormula, Memory, Step, WithinStep,
};
pub use self::gauss_legendre::{
    GaussLegendre, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, PlainGaussLegendre,
};
pub use self::method::{
    LanesMethod, LanesMethodVisitor, LanesStepper, MAX_LANES, Method, Stepper, SuspectStep, Work,
};
pub use self::radau::{Radau5, RadauStepper};
pub use self::rk4::{ClassicalLanes, RungeKutta4, rk4_step};
pub use self::splitting::{BlanesMoan4, SplittingLanes, StormerVerlet, SymplecticEuler};
pub use self::step_derivatives::{DifferentiableStep, StepDerivatives};
pub use self::stochastic::{EulerMaruyama, StochasticRungeKutta4};
pub use self::taylor::{Taylor, TaylorStepper};
pub use self::undefined::{explained, undefined};
pub use self::variational::Variational;
pub use self::verner::{Verner98, VernerLanes, VernerLastStep, VernerStepper};
pub use self::wiener::WienerPath;
pub use crate::system::{EventSource, SettingError, StepFailure};
