//! Equilibria and linear models of systems read at run time.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use lagrange_runtime::linear::{Equilibrium, EquilibriumError, LinearModel, Linearise};

use crate::declared::{DeclaredSystem, Visitor};
use crate::system::DynamicSystem;

/// A search for an equilibrium, or for a steady motion if velocities are not zero.
#[derive(Clone, Debug)]
pub struct SearchSettings {
    /// Constant time.
    pub time: f64,
    /// State near which to search; its velocities are kept.
    pub near: Vec<f64>,
    /// Coordinates and first-order states that keep their values.
    pub hold: Vec<String>,
    /// Inputs that are additional unknowns.
    pub trim: Vec<String>,
}

/// A state in which only positions may change, at constant velocities.
#[derive(Clone, PartialEq, Debug)]
pub struct FoundEquilibrium {
    /// The state.
    pub state: Vec<f64>,
    /// Values of all inputs; empty if none were trimmed.
    pub inputs: Vec<f64>,
    /// Number of steps of Newton's method.
    pub iterations: u32,
    /// Number of independent directions in which other equilibria adjoin this one.
    pub freedom: usize,
}

/// The reason why no equilibrium or linear model was found.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum AnalysisError {
    /// The declaration has no `emit { system_matrix }`.
    WithoutDerivatives,
    /// A parameter is out of its declared range, with its name, value and range.
    Parameter(String),
    /// The search did not converge.
    Search {
        /// Name of the unsatisfied equation, and the point where the search stopped.
        message: String,
        /// State at which the search stopped.
        state: Vec<f64>,
    },
    /// The equations have no derivatives at the state, or no motions pass through it.
    Linearisation(String),
}

impl Display for AnalysisError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            AnalysisError::WithoutDerivatives => f.write_str("`emit { system_matrix }` is missing"),
            AnalysisError::Parameter(message)
            | AnalysisError::Search { message, .. }
            | AnalysisError::Linearisation(message) => f.write_str(message),
        }
    }
}

impl Error for AnalysisError {}

impl DeclaredSystem {
    /// Searches for an equilibrium.
    ///
    /// # Errors
    /// If there are no derivatives, a parameter is out of its range, a name is unknown, or Newton's
    /// method finds no equilibrium.
    pub fn equilibrium(&self, settings: SearchSettings) -> Result<FoundEquilibrium, AnalysisError> {
        self.check_derivatives()?;
        self.visit(settings)
    }

    /// Linearises the equations of motion and the outputs at a time and a state.
    ///
    /// # Errors
    /// If there are no derivatives, in the declaration or at the state, a parameter is out of its
    /// range, or the state violates constraints.
    pub fn linearise(&self, time: f64, state: &[f64]) -> Result<LinearModel, AnalysisError> {
        self.check_derivatives()?;
        self.visit(Point { time, state })
    }

    fn check_derivatives(&self) -> Result<(), AnalysisError> {
        match self.programs().system_matrix {
            Some(_) => Ok(()),
            None => Err(AnalysisError::WithoutDerivatives),
        }
    }
}

impl Visitor for SearchSettings {
    type Output = Result<FoundEquilibrium, AnalysisError>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        check_parameters(system)?;
        let [hold, trim] = [&self.hold, &self.trim].map(|names| names.iter().map(String::as_str));
        let (hold, trim) = (hold.collect::<Vec<_>>(), trim.collect::<Vec<_>>());
        let search = system.equilibrium(system.state(&self.near)).at(self.time).hold(&hold);
        let search = if trim.is_empty() { search } else { search.trim(&trim) };
        let Equilibrium { state, inputs, iterations, freedom } =
            search.solve().map_err(|error| stopped(&error))?;
        Ok(FoundEquilibrium { state: state.as_ref().to_vec(), inputs, iterations, freedom })
    }
}

fn check_parameters<const CAPACITY: usize>(system: &DynamicSystem<CAPACITY>) -> Result<(), AnalysisError> {
    system.check_parameters().map_err(|error| AnalysisError::Parameter(error.to_string()))
}

fn stopped<const CAPACITY: usize>(error: &EquilibriumError<DynamicSystem<CAPACITY>>) -> AnalysisError {
    AnalysisError::Search { message: error.to_string(), state: error.state.as_ref().to_vec() }
}

/// A time and a state at which to linearise.
struct Point<'a> {
    time: f64,
    state: &'a [f64],
}

impl Visitor for Point<'_> {
    type Output = Result<LinearModel, AnalysisError>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        check_parameters(system)?;
        let model = system.linearise(self.time, system.state(self.state));
        model.map_err(|error| AnalysisError::Linearisation(error.to_string()))
    }
}
