//! Methods of integration by name.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use lagrange_runtime::integrate::{
    EulerMaruyama, Method, PlainGaussLegendre, Radau5, RungeKutta4, StochasticRungeKutta4, Verner98,
    WienerPath,
};
use lagrange_runtime::simulate::{Drive, Simulation, SimulationError, Trajectory};

use crate::system::DynamicSystem;

/// Default error tolerance of a step.
const TOLERANCE: f64 = 1e-9;
/// Names of the methods; the last two are for noise.
pub(crate) const NAMES: [&str; 6] = ["verner", "radau", "rk4", "gauss", "maruyama", "stochastic"];

/// A method of integration with its settings.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum MethodChoice {
    /// Verner's pair of orders 9 and 8, `verner`.
    Verner {
        /// Error tolerance of a step.
        tolerance: f64,
    },
    /// The Radau IIA method of order 5 for stiff systems, `radau`.
    Radau {
        /// Error tolerance of a step.
        tolerance: f64,
    },
    /// The classical Runge–Kutta method of order 4, `rk4`.
    RungeKutta4 {
        /// Length of a step.
        step: f64,
    },
    /// The Gauss–Legendre method of order 6, `gauss`.
    GaussLegendre {
        /// Length of a step.
        step: f64,
    },
    /// The method of Euler and Maruyama for systems with noise, `maruyama`.
    EulerMaruyama {
        /// Length of a step.
        step: f64,
        /// Seed of the noise.
        seed: u64,
    },
    /// The Runge–Kutta method for systems with noise, `stochastic`.
    StochasticRungeKutta4 {
        /// Length of a step.
        step: f64,
        /// Seed of the noise.
        seed: u64,
    },
}

impl MethodChoice {
    /// Returns the method with a name, `verner` by default. Methods with constant steps need a
    /// step; others accept a tolerance. The seed of noise is zero.
    ///
    /// # Errors
    /// If there is no such method, or it needs other settings.
    pub fn new(
        name: Option<&str>,
        tolerance: Option<f64>,
        step: Option<f64>,
    ) -> Result<MethodChoice, MethodError> {
        let method = name.unwrap_or(NAMES[0]).to_owned();
        let takes_steps = match NAMES.iter().position(|known| *known == method) {
            Some(index) => index > 1,
            None => return Err(MethodError::Unknown(method)),
        };
        let (useless, has_useless) =
            if takes_steps { ("tolerance", tolerance.is_some()) } else { ("step", step.is_some()) };
        if has_useless {
            return Err(MethodError::Useless { method, setting: useless });
        }
        let tolerance = tolerance.unwrap_or(TOLERANCE);
        Ok(match (method.as_str(), step) {
            ("verner", _) => MethodChoice::Verner { tolerance },
            ("radau", _) => MethodChoice::Radau { tolerance },
            ("rk4", Some(step)) => MethodChoice::RungeKutta4 { step },
            ("gauss", Some(step)) => MethodChoice::GaussLegendre { step },
            ("maruyama", Some(step)) => MethodChoice::EulerMaruyama { step, seed: 0 },
            (_, Some(step)) => MethodChoice::StochasticRungeKutta4 { step, seed: 0 },
            (_, None) => return Err(MethodError::WithoutStep(method)),
        })
    }
}

impl MethodChoice {
    /// Returns the method with this seed of the noise; methods without noise are unchanged.
    #[must_use]
    pub fn with_seed(self, seed: u64) -> MethodChoice {
        match self {
            MethodChoice::EulerMaruyama { step, .. } => MethodChoice::EulerMaruyama { step, seed },
            MethodChoice::StochasticRungeKutta4 { step, .. } => {
                MethodChoice::StochasticRungeKutta4 { step, seed }
            }
            other => other,
        }
    }

    /// Runs a simulation by this method.
    ///
    /// # Errors
    /// If the run fails, as in [`Simulation::run`].
    pub fn run<const CAPACITY: usize, K, D>(
        self,
        simulation: Simulation<'_, DynamicSystem<CAPACITY>, K, D>,
    ) -> Result<Trajectory<DynamicSystem<CAPACITY>>, SimulationError<DynamicSystem<CAPACITY>>>
    where
        D: Drive<DynamicSystem<CAPACITY>>,
        Verner98<f64>: Method<D::Closed>,
        Radau5<f64>: Method<D::Closed>,
        RungeKutta4<f64>: Method<D::Closed>,
        PlainGaussLegendre<f64, 3>: Method<D::Closed>,
        EulerMaruyama<f64>: Method<D::Closed>,
        StochasticRungeKutta4<f64>: Method<D::Closed>,
    {
        match self {
            MethodChoice::Verner { tolerance } => simulation.method(Verner98::tolerance(tolerance)).run(),
            MethodChoice::Radau { tolerance } => simulation.method(Radau5::tolerance(tolerance)).run(),
            MethodChoice::RungeKutta4 { step } => simulation.method(RungeKutta4 { step }).run(),
            MethodChoice::GaussLegendre { step } => {
                simulation.method(PlainGaussLegendre::<f64, 3> { step }).run()
            }
            MethodChoice::EulerMaruyama { step, seed } => {
                simulation.method(EulerMaruyama { step, path: WienerPath::of_seed(seed) }).run()
            }
            MethodChoice::StochasticRungeKutta4 { step, seed } => {
                simulation.method(StochasticRungeKutta4 { step, path: WienerPath::of_seed(seed) }).run()
            }
        }
    }
}

/// The reason why a name and settings do not specify a method.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum MethodError {
    /// There is no method of this name.
    Unknown(String),
    /// The method does not have this setting.
    Useless {
        /// Name of the method.
        method: String,
        /// `tolerance` or `step`.
        setting: &'static str,
    },
    /// The method of this name needs a step.
    WithoutStep(String),
}

impl Display for MethodError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            MethodError::Unknown(name) if name == "taylor" => {
                write!(
                    f,
                    "the method `taylor` takes compiled systems with `emit {{ taylor }}`: take `verner`"
                )
            }
            MethodError::Unknown(name) => {
                let names = NAMES.map(|known| format!("`{known}`")).join(", ");
                write!(f, "unknown method `{name}`: there are {names}")
            }
            MethodError::Useless { method, setting } => write!(f, "the method `{method}` has no `{setting}`"),
            MethodError::WithoutStep(method) => write!(f, "the method `{method}` needs a `step`"),
        }
    }
}

impl Error for MethodError {}
