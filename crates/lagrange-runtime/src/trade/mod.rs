//! The price of every digit: comparison of methods, number types and variants of a system.
//!
//! A [`Trade`] runs each method from coarse to fine settings, and measures the error at the end and
//! the computing time. It reports the fastest method for each accuracy. `cargo run --release
//! --features trade --example trade` does this for four known systems. For your own system, write:
//!
//! ```no_run
//! lagrange::system! {
//!     pub struct Pendulum;
//!     coord theta;
//!     kinetic = 1/2 * dot(theta)^2;
//!     potential = -9.81 * cos(theta);
//!     emit { taylor }
//! }
//!
//! let pendulum = Pendulum::default();
//! let trade = lagrange::trade::Trade::new("my pendulum", &pendulum, [1.0, 0.0], 10.0);
//! let report = trade.taylor("standard", &pendulum).run();
//! print!("{}", report.recommendation());
//! report.save("trade")?;
//! # Ok::<(), lagrange::simulate::PlotError>(())
//! ```
//!
//! Times depend on the machine and its load; errors, evaluations and steps do not.

mod contestant;
mod diagram;
mod files;
mod ladder;
mod measurement;
mod report;

use std::boxed::Box;
use std::string::{String, ToString};
use std::time::Instant;
use std::vec::Vec;

use self::contestant::Contestant;
use self::ladder::climb;
use crate::integrate::{
    BlanesMoan4, GaussLegendre, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, Radau5,
    RungeKutta4, StormerVerlet, SymplecticEuler, Taylor, Variational, Verner98,
};
use crate::scalar::Number;
use crate::system::{CanonicalSystem, OdeSystem, SeparableSystem, TaylorSystem};

pub use self::contestant::Knob;
pub use self::measurement::{MeasuredRun, Measurement};
pub use self::report::Report;

/// A motion, and all contestants that compute it.
pub struct Trade<'a> {
    title: String,
    start: Vec<f64>,
    end: f64,
    reference: Option<Vec<f64>>,
    longest: f64,
    contestants: Vec<Contestant<'a>>,
}

/// Default number of seconds after which finer settings of a method are not tried.
const LONGEST: f64 = 0.2;
/// Tolerances of the reference. Methods of low order do not reach the finest ones in a reasonable
/// time.
const FINEST: [f64; 6] = [1e-8, 1e-10, 1e-12, 1e-13, 1e-14, f64::EPSILON];
/// Maximum duration of a run for the reference, relative to that of other runs; finer ones are not
/// tried.
const PATIENCE: f64 = 10.0;

impl<'a> Trade<'a> {
    /// Creates the comparison of all methods that accept any system. The motion of `system` starts
    /// from the state `start` at time zero and lasts until the time `end`.
    pub fn new<M>(title: &str, system: &'a M, start: M::State, end: M::Scalar) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
    {
        let start = start.as_ref().iter().map(|component| (*component).into()).collect();
        Trade::without_methods(title, start, end.into()).variant("standard", system)
    }

    /// Creates the comparison of a motion from these entries of the state at time zero, without any
    /// methods yet.
    pub fn without_methods(title: &str, start: Vec<f64>, end: f64) -> Self {
        Trade {
            title: title.to_string(),
            start,
            end,
            reference: None,
            longest: LONGEST,
            contestants: Vec::new(),
        }
    }

    /// Sets the state at the end. The default is the end of the finest run of the first method with
    /// a tolerance that reaches it. Errors close to rounding are then not reliable.
    ///
    /// # Panics
    /// If its length differs from that of the state at the start.
    #[must_use]
    pub fn reference(mut self, state: &[f64]) -> Self {
        assert_eq!(state.len(), self.start.len(), "the reference is a state of another system");
        self.reference = Some(state.to_vec());
        self
    }

    /// Sets the number of seconds after which finer settings are not tried.
    #[must_use]
    pub fn longest(mut self, seconds: f64) -> Self {
        self.longest = seconds;
        self
    }

    /// Adds a variant of the system, such as other number types or accuracy levels, in all methods
    /// that accept any system.
    ///
    /// # Panics
    /// If the length of its state differs.
    #[must_use]
    pub fn variant<M>(self, name: &str, system: &'a M) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
    {
        self.by_tolerance(name, system, |tolerance| Verner98 {
            // The cost of stability should be visible.
            refuses_stiff: false,
            ..Verner98::tolerance(tolerance)
        })
        .implicit(name, system)
        .by_step(name, system, |step| RungeKutta4 { step })
        .by_step(name, system, |step| ImplicitMidpoint { step }.plain())
        .by_step(name, system, |step| GaussLegendre4 { step }.plain())
        .by_step(name, system, |step| GaussLegendre6 { step }.plain())
    }

    /// Adds a system with Radau's method, if it provides its Jacobian.
    fn implicit<M>(self, name: &str, system: &'a M) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
    {
        let start = contestant::rounded::<M>(&self.start);
        match system.jacobian(M::Scalar::ZERO, &start) {
            Some(_) => self.by_tolerance(name, system, Radau5::tolerance),
            None => self,
        }
    }

    /// Adds a system for Taylor series.
    ///
    /// # Panics
    /// As [`variant`](Self::variant).
    #[must_use]
    pub fn taylor<M>(self, name: &str, system: &'a M) -> Self
    where
        M: TaylorSystem,
        M::Scalar: Into<f64>,
    {
        self.by_tolerance(name, system, Taylor::tolerance)
    }

    /// Adds a system for the methods that take coordinates and momenta.
    ///
    /// # Panics
    /// As [`variant`](Self::variant).
    #[must_use]
    pub fn canonical<M>(self, name: &str, system: &'a M) -> Self
    where
        M: CanonicalSystem,
        M::Scalar: Into<f64>,
    {
        let name = std::format!("{name}, canonical");
        self.by_step(&name, system, |step| GaussLegendre::<_, 1> { step })
            .by_step(&name, system, |step| GaussLegendre::<_, 2> { step })
            .by_step(&name, system, |step| GaussLegendre::<_, 3> { step })
            .by_step(&name, system, |step| Variational { step })
    }

    /// Adds a reduced type of the same declaration, with a method by tolerance and a method by
    /// step.
    ///
    /// It starts from the image of the start under `restrict`, and is judged by the image of its
    /// end under `expand`. The error of the reduction is therefore included.
    #[must_use]
    pub fn reduced<M>(
        self,
        name: &str,
        system: &'a M,
        restrict: impl Fn(&[f64]) -> M::State + Copy + 'a,
        expand: impl Fn(&M::State) -> Vec<f64> + Copy + 'a,
    ) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
    {
        self.method(name, system, Knob::Tolerance, Verner98::tolerance, (restrict, expand)).method(
            name,
            system,
            Knob::Step,
            |step| RungeKutta4 { step },
            (restrict, expand),
        )
    }

    /// Adds a method with conversions of states. The first function creates states from entries of
    /// the state, the second does the reverse. Other methods are added by this one.
    #[must_use]
    pub fn method<M, K>(
        mut self,
        name: &str,
        system: &'a M,
        knob: Knob,
        method: impl Fn(M::Scalar) -> K + 'a,
        (restrict, expand): (impl Fn(&[f64]) -> M::State + 'a, impl Fn(&M::State) -> Vec<f64> + 'a),
    ) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
        K: Method<M>,
    {
        let title = method(M::Scalar::ONE).name();
        let run = contestant::run(system, method, restrict, expand);
        self.contestants.push(Contestant {
            method: title.to_string(),
            scalar: core::any::type_name::<M::Scalar>(),
            variant: name.to_string(),
            knob,
            run: Box::new(run),
        });
        self
    }

    /// Adds a system with the methods for separable systems.
    ///
    /// # Panics
    /// As [`variant`](Self::variant).
    #[must_use]
    pub fn separable<M>(self, name: &str, system: &'a M) -> Self
    where
        M: SeparableSystem,
        M::Scalar: Into<f64>,
    {
        self.by_step(name, system, |step| SymplecticEuler { step })
            .by_step(name, system, |step| StormerVerlet { step })
            .by_step(name, system, |step| BlanesMoan4 { step })
    }

    /// Adds a method with a tolerance.
    ///
    /// # Panics
    /// As [`variant`](Self::variant).
    #[must_use]
    pub fn by_tolerance<M, K>(self, name: &str, system: &'a M, method: impl Fn(M::Scalar) -> K + 'a) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
        K: Method<M>,
    {
        self.with(name, system, Knob::Tolerance, method)
    }

    /// Adds a method with a step length.
    ///
    /// # Panics
    /// As [`variant`](Self::variant).
    #[must_use]
    pub fn by_step<M, K>(self, name: &str, system: &'a M, method: impl Fn(M::Scalar) -> K + 'a) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
        K: Method<M>,
    {
        self.with(name, system, Knob::Step, method)
    }

    fn with<M, K>(self, name: &str, system: &'a M, knob: Knob, method: impl Fn(M::Scalar) -> K + 'a) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
        K: Method<M>,
    {
        assert_eq!(contestant::length::<M>(), self.start.len(), "{name} has a state of another length");
        self.method(name, system, knob, method, (contestant::rounded::<M>, contestant::components::<M>))
    }

    /// Runs all contestants, one after the other.
    pub fn run(&self) -> Report {
        let (reference, was_cut) = match &self.reference {
            Some(state) => (Some(state.clone()), false),
            None => self.finest(),
        };
        let contestants = if reference.is_some() { &self.contestants[..] } else { &[] };
        let reference = reference.unwrap_or_default();
        let climbs = contestants
            .iter()
            .map(|contestant| climb(contestant, &self.start, self.end, &reference, self.longest))
            .collect::<Vec<_>>();
        let is_cut = if climbs.is_empty() { was_cut } else { climbs.iter().any(|climb| climb.is_cut) };
        let rows = climbs.into_iter().flat_map(|climb| climb.rows).collect();
        Report { title: self.title.clone(), has_own_reference: self.reference.is_none(), rows, is_cut }
    }

    /// Returns the end of the finest run of the first method with a tolerance that reaches it. The
    /// second value is true if finer runs would take too long.
    fn finest(&self) -> (Option<Vec<f64>>, bool) {
        let mut adaptive = self.contestants.iter().filter(|contestant| contestant.knob == Knob::Tolerance);
        let mut is_cut = false;
        let finest = adaptive.find_map(|contestant| {
            let mut finest = None;
            for tolerance in FINEST {
                let began = Instant::now();
                let run = (contestant.run)(tolerance, &self.start, self.end).ok();
                finest = run.map(|run| run.state).or(finest);
                if began.elapsed().as_secs_f64() > PATIENCE * self.longest {
                    is_cut = true;
                    break;
                }
            }
            finest
        });
        (finest, is_cut)
    }
}

#[cfg(test)]
mod tests;
