//! The methods that a trade compares.

use std::boxed::Box;
use std::vec::Vec;

use super::Trade;
use super::contestant::{self, Contestant, Knob};
use crate::integrate::{
    BlanesMoan4, GaussLegendre, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, Radau5,
    RungeKutta4, StormerVerlet, SymplecticEuler, Taylor, Variational, Verner98,
};
use crate::scalar::Number;
use crate::system::{CanonicalSystem, OdeSystem, SeparableSystem, TaylorSystem};

impl<'a> Trade<'a> {
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
        self.explicit(name, system)
            .by_tolerance(name, system, Radau5::tolerance)
            .by_step(name, system, |step| ImplicitMidpoint { step }.plain())
            .by_step(name, system, |step| GaussLegendre4 { step }.plain())
            .by_step(name, system, |step| GaussLegendre6 { step }.plain())
    }

    /// Adds a variant of the system in the explicit methods that accept any system.
    ///
    /// # Panics
    /// As [`variant`](Self::variant).
    #[must_use]
    pub fn explicit<M>(self, name: &str, system: &'a M) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
    {
        self.by_tolerance(name, system, Verner98::tolerance)
            .by_step(name, system, |step| RungeKutta4 { step })
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
        expand: impl Fn(&M::State) -> Vec<M::Scalar> + Copy + 'a,
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
        (restrict, expand): (impl Fn(&[f64]) -> M::State + 'a, impl Fn(&M::State) -> Vec<M::Scalar> + 'a),
    ) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
        K: Method<M>,
    {
        let title = method(M::Scalar::ONE).name();
        let run = Box::new(contestant::run(system, method, restrict, expand));
        self.contestants.push(Contestant::new::<M, K>(name, knob, 1, run, title));
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
}
