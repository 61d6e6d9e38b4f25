//! Parallel runs of a system read at run time.

use std::error::Error;
use std::fmt::{self, Display, Formatter};
use std::ops::ControlFlow;

use lagrange_runtime::contact::Stepped;
use lagrange_runtime::ensemble::{self, Ends, Ensemble, Ensembles, Failure};
use lagrange_runtime::integrate::{
    EulerMaruyama, Method, PlainGaussLegendre, Radau5, RungeKutta4, StochasticRungeKutta4, Taylor, Verner98,
    WienerPath,
};
use lagrange_runtime::simulate::Drive;
use lagrange_runtime::system::OdeSystem;

use crate::declared::{DeclaredSystem, Visitor};
use crate::method::{LAW, MethodChoice, NO_CONTACTS, Refused, STEPPED_DELAY};
use crate::reactions::in_room;
use crate::refusal::NoSuchName;
use crate::system::DynamicSystem;
use crate::watch::Watch;

/// The motions of an ensemble. Each is bit-identical to a separate run.
#[derive(Clone, PartialEq, Debug)]
pub struct EnsembleSettings {
    /// Initial states, one for each motion.
    pub starts: Vec<Vec<f64>>,
    /// Constant parameters and inputs that differ between motions, by name, with a value for each
    /// motion.
    pub varied: Vec<(String, Vec<f64>)>,
    /// Initial time.
    pub from: f64,
    /// Final time.
    pub until: f64,
    /// The method.
    pub method: MethodChoice,
    /// Number of threads; one per processor if it is `None`. Results do not depend on it.
    pub threads: Option<usize>,
}

/// The final states of motions, a row for each. Rows of failed motions are NaN except for
/// parameters.
#[derive(Clone, PartialEq, Debug)]
pub struct EnsembleEnds {
    /// Final times: the requested one, or earlier ones if events stopped motions.
    pub times: Vec<f64>,
    /// Names of the columns: the state, outputs and, if anything varies, parameters and varied
    /// inputs.
    pub names: Vec<String>,
    /// Columns, in the order of their names.
    pub columns: Vec<Vec<f64>>,
    /// Failed motions, in order.
    pub failures: Vec<FailedMotion>,
}

/// A motion that failed.
#[derive(Clone, PartialEq, Debug)]
pub struct FailedMotion {
    /// Zero-based index of the motion.
    pub index: usize,
    /// Time of the last valid state.
    pub time: f64,
    /// Last valid state.
    pub state: Vec<f64>,
    /// Index of the motion, and reason and place of the failure.
    pub message: String,
}

/// The reason why no ensemble was computed.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum EnsembleError {
    /// The system has no parameter or input of this name.
    Unknown(NoSuchName),
    /// A name varies twice.
    Repeated(String),
    /// A list differs in length from the initial states.
    Length {
        /// Name of the parameter or input.
        name: String,
        /// Number of its values.
        values: usize,
        /// Number of motions.
        motions: usize,
    },
    /// An initial state has the wrong number of entries.
    Start {
        /// Zero-based index of the motion.
        motion: usize,
        /// Number of its entries.
        entries: usize,
        /// Names of the entries of a state.
        state: Vec<String>,
    },
    /// Another setting is invalid, for this reason.
    Setting(String),
}

impl Display for EnsembleError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            EnsembleError::Unknown(name) => name.fmt(f),
            EnsembleError::Repeated(name) => write!(f, "`{name}` varies twice"),
            EnsembleError::Length { name, values, motions } => {
                write!(f, "`{name}` has {values} values for {motions} motions")
            }
            EnsembleError::Start { motion, entries, state } => write!(
                f,
                "a state has {} entries, {}, but the start of motion {motion} has {entries}",
                state.len(),
                state.join(", ")
            ),
            EnsembleError::Setting(message) => f.write_str(message),
        }
    }
}

impl Error for EnsembleError {}

impl DeclaredSystem {
    /// Computes motions in parallel, and keeps their final states.
    ///
    /// # Errors
    /// If settings are invalid. A failed motion is listed in [`failures`](EnsembleEnds::failures),
    /// and the others continue.
    pub fn ensemble(&self, settings: &EnsembleSettings) -> Result<EnsembleEnds, EnsembleError> {
        self.ensemble_watched(settings, &|_| false)
    }

    /// Computes motions as [`ensemble`](Self::ensemble) does, until they end or are cancelled.
    ///
    /// # Errors
    /// If settings are invalid, or the computation is cancelled.
    pub fn ensemble_watched(
        &self,
        settings: &EnsembleSettings,
        watch: Watch<'_>,
    ) -> Result<EnsembleEnds, EnsembleError> {
        let names = self.state_names();
        let wrong = settings.starts.iter().position(|start| start.len() != names.len());
        if let Some(motion) = wrong {
            let entries = settings.starts[motion].len();
            return Err(EnsembleError::Start { motion, entries, state: names });
        }
        self.visit(Motions { settings, varied: self.places(settings)?, watch })
    }

    /// Returns the indices of varied parameters and inputs, with their values.
    fn places<'a>(&self, settings: &'a EnsembleSettings) -> Result<Vec<(usize, &'a [f64])>, EnsembleError> {
        let (known, motions) = (&self.variables().fields, settings.starts.len());
        let mut places: Vec<(usize, &[f64])> = Vec::new();
        for (name, values) in &settings.varied {
            let unknown = || NoSuchName { name: name.clone(), known: known.clone() };
            let place = known.iter().position(|known| known == name);
            let place = place.ok_or_else(|| EnsembleError::Unknown(unknown()))?;
            if values.len() != motions {
                let (name, values) = (name.clone(), values.len());
                return Err(EnsembleError::Length { name, values, motions });
            }
            if places.iter().any(|(other, _)| *other == place) {
                return Err(EnsembleError::Repeated(name.clone()));
            }
            places.push((place, values));
        }
        Ok(places)
    }
}

/// Validated settings.
struct Motions<'a> {
    settings: &'a EnsembleSettings,
    /// Indices of parameters and inputs, with a value for each motion.
    varied: Vec<(usize, &'a [f64])>,
    watch: Watch<'a>,
}

impl Visitor for Motions<'_> {
    type Output = Result<EnsembleEnds, EnsembleError>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        let EnsembleSettings { starts, from, until, method, threads, .. } = self.settings;
        let states = starts.iter().map(|start| system.state(start)).collect::<Vec<_>>();
        let mut motions = system.ensemble(states).from(*from);
        if !self.varied.is_empty() {
            motions = motions.parameters(|index, system: &mut DynamicSystem<CAPACITY>| {
                for (place, values) in &self.varied {
                    system.numeric.set_field(*place, values[index]);
                }
            });
        }
        let mut ensemble = motions.until(*until).one_by_one();
        ensemble = ensemble.progress(|done| match (self.watch)(done.motions as f64 / done.of as f64) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        });
        if system.has_outputs() {
            ensemble = ensemble.outputs();
        }
        if let Some(threads) = threads {
            ensemble = ensemble.threads(*threads);
        }
        let ends = match (*method, system.names.without_series) {
            (MethodChoice::Taylor { tolerance }, None) => ensemble.method(Taylor::tolerance(tolerance)).run(),
            (MethodChoice::Taylor { .. }, Some(reason)) => ensemble.method(Refused(reason)).run(),
            (MethodChoice::Stepped { step }, _) if system.is_touching() && !system.has_delays() => {
                in_room!(system, V, R, ensemble.method(Stepped::<f64, V, R>::every(step)).run())
            }
            (MethodChoice::Stepped { .. }, _) if !system.is_touching() => {
                ensemble.method(Refused(NO_CONTACTS)).run()
            }
            _ if system.has_delays() => ends_by(*method, ensemble.with_history()),
            _ => ends_by(*method, ensemble),
        };
        let ends = ends.map_err(|error| EnsembleError::Setting(error.to_string()))?;
        Ok(EnsembleEnds::of(&ends).with(&self.settings.varied))
    }
}

type Found<const CAPACITY: usize> = Result<Ends<DynamicSystem<CAPACITY>>, ensemble::EnsembleError>;

fn ends_by<const CAPACITY: usize, D>(
    method: MethodChoice,
    ensemble: Ensemble<'_, DynamicSystem<CAPACITY>, Verner98<f64>, D>,
) -> Found<CAPACITY>
where
    D: Drive<DynamicSystem<CAPACITY>> + Sync,
    Verner98<f64>: Method<D::Closed>,
    Radau5<f64>: Method<D::Closed>,
    RungeKutta4<f64>: Method<D::Closed>,
    PlainGaussLegendre<f64, 3>: Method<D::Closed>,
    EulerMaruyama<f64>: Method<D::Closed>,
    StochasticRungeKutta4<f64>: Method<D::Closed>,
{
    match method {
        MethodChoice::Verner { tolerance } => ensemble.tolerance(tolerance).run(),
        MethodChoice::Radau { tolerance } => ensemble.method(Radau5::tolerance(tolerance)).run(),
        MethodChoice::Taylor { .. } => ensemble.method(Refused(LAW)).run(),
        MethodChoice::Stepped { .. } => ensemble.method(Refused(STEPPED_DELAY)).run(),
        MethodChoice::RungeKutta4 { step } => ensemble.method(RungeKutta4 { step }).run(),
        MethodChoice::GaussLegendre { step } => ensemble.method(PlainGaussLegendre::<f64, 3> { step }).run(),
        MethodChoice::EulerMaruyama { step, seed } => {
            ensemble.method(EulerMaruyama { step, path: WienerPath::of_seed(seed) }).run()
        }
        MethodChoice::StochasticRungeKutta4 { step, seed } => {
            ensemble.method(StochasticRungeKutta4 { step, path: WienerPath::of_seed(seed) }).run()
        }
    }
}

impl EnsembleEnds {
    fn of<const CAPACITY: usize>(ends: &Ends<DynamicSystem<CAPACITY>>) -> Self {
        EnsembleEnds {
            times: ends.times().to_vec(),
            names: ends.names().to_vec(),
            columns: ends.table().columns().map(<[f64]>::to_vec).collect(),
            failures: ends.failures().iter().map(FailedMotion::of).collect(),
        }
    }

    /// Adds columns for varied inputs; parameters already have columns.
    fn with(mut self, varied: &[(String, Vec<f64>)]) -> Self {
        for (name, values) in varied {
            if !self.names.contains(name) {
                self.names.push(name.clone());
                self.columns.push(values.clone());
            }
        }
        self
    }
}

impl FailedMotion {
    fn of<const CAPACITY: usize>(failure: &Failure<DynamicSystem<CAPACITY>>) -> Self {
        FailedMotion {
            index: failure.index,
            time: failure.time,
            state: failure.state.as_ref().to_vec(),
            message: failure.to_string(),
        }
    }
}
