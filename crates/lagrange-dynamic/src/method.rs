//! Methods of integration by name.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use lagrange_core::model::Product;
use lagrange_runtime::contact::Stepped;
use lagrange_runtime::integrate::{
    EulerMaruyama, Method, PlainGaussLegendre, Radau5, RungeKutta4, SettingError, StepFailure,
    StochasticRungeKutta4, Taylor, Verner98, WienerPath,
};
use lagrange_runtime::simulate::{Drive, Law, Simulation, SimulationError, Trajectory};
use lagrange_runtime::system::OdeSystem;

use crate::inline::Inline;
use crate::reactions::in_room;
use crate::system::DynamicSystem;

/// Default error tolerance of a step.
const TOLERANCE: f64 = 1e-9;
/// Names of the methods; the first three have tolerances, the last two are for noise.
pub(crate) const NAMES: [&str; 8] =
    ["verner", "radau", "taylor", "rk4", "gauss", "stepped", "maruyama", "stochastic"];
/// The reason why systems without contacts are not stepped.
pub(crate) const NO_CONTACTS: &str = "the method `stepped` needs contacts without a stiffness, or dry friction: take `verner`, or `radau` for stiff contacts";
/// The reason why runs with delayed signals are not stepped.
pub(crate) const STEPPED_DELAY: &str = "the method `stepped` has no delayed signals: take `verner`";
/// The reason why runs with a law have no series.
pub(crate) const LAW: &str = "the method `taylor` has no series of inputs that change: take `verner`";

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
    /// Taylor series for systems with `emit { taylor }`, `taylor`.
    Taylor {
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
    /// Steps over which contacts and friction act by impulses, `stepped`.
    Stepped {
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
            Some(index) => index > 2,
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
            ("taylor", _) => MethodChoice::Taylor { tolerance },
            ("rk4", Some(step)) => MethodChoice::RungeKutta4 { step },
            ("gauss", Some(step)) => MethodChoice::GaussLegendre { step },
            ("stepped", Some(step)) => MethodChoice::Stepped { step },
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

    /// True if a seed chooses the noise of the method.
    #[must_use]
    pub fn has_seed(self) -> bool {
        matches!(self, MethodChoice::EulerMaruyama { .. } | MethodChoice::StochasticRungeKutta4 { .. })
    }

    /// Returns the product that the method needs beyond the equations of motion, if it needs one.
    #[must_use]
    pub fn product(self) -> Option<Product> {
        matches!(self, MethodChoice::Taylor { .. }).then_some(Product::Taylor)
    }

    /// Runs a simulation of a system by this method. Its inputs are constant.
    ///
    /// # Errors
    /// If the run fails, as in [`Simulation::run`], or the method is [`Taylor`] and the system has
    /// no series.
    pub fn run_freely<const CAPACITY: usize, K>(
        self,
        simulation: Simulation<'_, DynamicSystem<CAPACITY>, K>,
        system: &DynamicSystem<CAPACITY>,
    ) -> Result<Trajectory<DynamicSystem<CAPACITY>>, SimulationError<DynamicSystem<CAPACITY>>> {
        match (self, system.names.without_series) {
            (MethodChoice::Taylor { tolerance }, None) => {
                simulation.method(Taylor::tolerance(tolerance)).run()
            }
            (MethodChoice::Taylor { .. }, Some(reason)) => simulation.method(Refused(reason)).run(),
            (MethodChoice::Stepped { step }, _) if system.is_touching() => {
                in_room!(system, V, R, simulation.method(Stepped::<f64, V, R>::every(step)).run())
            }
            (MethodChoice::Stepped { .. }, _) => simulation.method(Refused(NO_CONTACTS)).run(),
            _ => self.run(simulation),
        }
    }

    /// Runs a simulation of a system by this method. Its inputs follow a law, which [`Taylor`]
    /// refuses.
    ///
    /// # Errors
    /// If the run fails, as in [`Simulation::run`].
    pub fn run_driven<const CAPACITY: usize, K, F>(
        self,
        simulation: Simulation<'_, DynamicSystem<CAPACITY>, K, Law<F>>,
        system: &DynamicSystem<CAPACITY>,
    ) -> Result<Trajectory<DynamicSystem<CAPACITY>>, SimulationError<DynamicSystem<CAPACITY>>>
    where
        F: Fn(&DynamicSystem<CAPACITY>, f64, Inline<CAPACITY>) -> Inline<CAPACITY>,
    {
        match self {
            MethodChoice::Stepped { step } if system.is_touching() => {
                in_room!(system, V, R, simulation.method(Stepped::<f64, V, R>::every(step)).run())
            }
            MethodChoice::Stepped { .. } => simulation.method(Refused(NO_CONTACTS)).run(),
            _ => self.run(simulation),
        }
    }

    /// Runs a simulation by this method. Its inputs may follow a law, and its signals may be
    /// delayed, so that [`Taylor`] and [`Stepped`] refuse it.
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
            MethodChoice::Taylor { .. } => simulation.method(Refused(LAW)).run(),
            MethodChoice::Stepped { .. } => simulation.method(Refused(STEPPED_DELAY)).run(),
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

/// A method in place of one that a system does not have. It refuses every system, with the reason.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Refused(pub(crate) &'static str);

impl<M> Method<M> for Refused
where
    M: OdeSystem<Scalar = f64> + ?Sized,
    RungeKutta4<f64>: Method<M>,
{
    type Stepper = <RungeKutta4<f64> as Method<M>>::Stepper;

    fn name(&self) -> &'static str {
        "none"
    }

    fn order(&self) -> u32 {
        0
    }

    fn check(&self) -> Result<(), SettingError<f64>> {
        Err(SettingError::Invalid(self.0))
    }

    fn start(&self, _: &M, _: f64, _: &M::State, _: f64) -> Result<Self::Stepper, StepFailure<f64>> {
        Err(SettingError::Invalid(self.0).into())
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
