//! The plan of a run: all settings except system, start, method and drive.

use std::cmp::Ordering;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::integrate::Method;
use crate::run::check_direction;
use crate::scalar::{Number, Scalar};
use crate::simulate::controllers::{Act, InputColumns};
use crate::simulate::events::Watch;
use crate::simulate::observer::{Extend, state_names};
use crate::simulate::sampling::{Grid, Sampling};
use crate::simulate::table::{TIME, repeated};
use crate::system::{ControlledSystem, Description, Direction, MechanicalSystem, OdeSystem, SettingError};

/// The plan of a run, or of all motions of an ensemble: data, and functions of columns X, events W
/// and controllers A.
pub(crate) struct Plan<M: MechanicalSystem, X, W, A> {
    pub(crate) settings: RunSettings<M::Scalar>,
    pub(crate) columns: Vec<X>,
    pub(crate) watches: Vec<W>,
    pub(crate) controllers: Vec<A>,
    /// The columns of inputs, if the run sets them.
    pub(crate) inputs: Option<InputColumns<M>>,
}

/// The plan of a single run.
pub(crate) type RunPlan<'a, M> = Plan<M, Extend<'a, M>, Watch<'a, M>, Act<'a, M>>;

/// The data of a plan.
#[derive(Clone, Debug)]
pub(crate) struct RunSettings<S> {
    /// The times of start and end.
    pub(crate) span: [S; 2],
    pub(crate) sampling: Sampling<S>,
    /// Times of samples, if specified, in the order of the run.
    pub(crate) times: Vec<S>,
    pub(crate) is_dense: bool,
    pub(crate) max_steps: Option<u64>,
    pub(crate) longest_step: Option<S>,
    pub(crate) restarts: Vec<S>,
    /// Names of the columns after the state.
    pub(crate) columns: Vec<String>,
    pub(crate) events: Vec<(String, Direction)>,
    /// The periods of controllers.
    pub(crate) periods: Vec<S>,
    /// The first setting that is invalid regardless of the others.
    pub(crate) fault: Option<SettingError<S>>,
}

impl<M: MechanicalSystem, X, W, A> Plan<M, X, W, A> {
    /// Returns the plan of a run of zero duration with this sampling.
    pub(crate) fn new(sampling: Sampling<M::Scalar>) -> Self {
        let settings = RunSettings {
            span: [M::Scalar::ZERO; 2],
            sampling,
            times: Vec::new(),
            is_dense: false,
            max_steps: None,
            longest_step: None,
            restarts: Vec::new(),
            columns: Vec::new(),
            events: Vec::new(),
            periods: Vec::new(),
            fault: None,
        };
        Plan { settings, columns: Vec::new(), watches: Vec::new(), controllers: Vec::new(), inputs: None }
    }

    /// Adds columns computed by one function.
    pub(crate) fn observe(&mut self, names: impl IntoIterator<Item = impl ToString>, extend: X) {
        let before = self.settings.columns.len();
        self.settings.columns.extend(names.into_iter().map(|name| name.to_string()));
        if self.settings.columns.len() == before {
            let empty = "a list of columns to observe is empty: name at least one column";
            self.settings.refuse(SettingError::Invalid(empty));
        }
        self.columns.push(extend);
    }

    /// Adds an event.
    pub(crate) fn watch(&mut self, name: &str, direction: Direction, watch: W) {
        self.settings.events.push((name.to_string(), direction));
        self.watches.push(watch);
    }

    /// Adds a controller.
    pub(crate) fn control(&mut self, period: M::Scalar, controller: A) {
        self.settings.periods.push(period);
        self.controllers.push(controller);
    }

    /// Adds columns for the inputs, if there are none yet.
    pub(crate) fn record_inputs(&mut self, system: &M, extend: X)
    where
        M: ControlledSystem,
    {
        if self.inputs.is_none() {
            let state = state_names(system.description()).count();
            let first = state + self.settings.columns.len();
            self.inputs = Some(InputColumns::from(first));
            self.observe(system.input_names(), extend);
        }
    }
}

impl<S: Scalar> RunSettings<S> {
    /// Checks everything that can be checked before the run, including the names of its columns.
    /// Returns the method with its longest step.
    ///
    /// # Errors
    /// If a setting is invalid.
    pub(crate) fn check<C, K>(
        &self,
        system: &impl OdeSystem<Scalar = S>,
        names: &[String],
        method: K,
    ) -> Result<K, SettingError<S>>
    where
        C: OdeSystem<Scalar = S>,
        K: Method<C>,
    {
        self.fault.map_or(Ok(()), Err)?;
        check_direction(system, self.span)?;
        check_names(names)?;
        self.check_times()?;
        let method = match self.longest_step {
            Some(longest) => method.with_longest_step(longest)?,
            None => method,
        };
        method.check().map(|()| method)
    }

    /// Checks the times of samples, controllers and restarts.
    fn check_times(&self) -> Result<(), SettingError<S>> {
        self.grid()?;
        check_times(&self.times, self.span)?;
        self.periods.iter().try_for_each(|period| Grid::new(self.span, *period).map(drop))?;
        if !self.restarts.iter().all(|time| time.is_finite()) {
            return Err(SettingError::Invalid("times of restart must be finite"));
        }
        Ok(())
    }

    /// Returns the message for an error of [`check`](Self::check), with the name of the column
    /// concerned.
    #[cfg(feature = "ensemble")]
    pub(crate) fn explain(names: &[String], error: SettingError<S>) -> String {
        let name = repeated(names).filter(|_| error == SettingError::RepeatedColumn);
        name.map_or_else(|| error.to_string(), |name| std::format!("two columns are called `{name}`"))
    }

    /// Returns the names of the events that were added.
    pub(crate) fn event_names(&self) -> Vec<String> {
        self.events.iter().map(|(name, _)| name.clone()).collect()
    }

    /// Records an invalid setting, unless an earlier one was recorded.
    pub(crate) fn refuse(&mut self, error: SettingError<S>) {
        self.fault = self.fault.or(Some(error));
    }

    /// Returns the names of all columns: coordinates, velocities, and added columns.
    pub(crate) fn names(&self, system: &Description) -> Vec<String> {
        state_names(system).chain(self.columns.iter().cloned()).collect()
    }

    /// Returns the times of samples between start and end, if an interval was specified.
    ///
    /// # Errors
    /// If the interval is invalid.
    pub(crate) fn grid(&self) -> Result<Option<Grid<S>>, SettingError<S>> {
        self.interval().map(|interval| Grid::new(self.span, interval)?.checked()).transpose()
    }

    /// Returns the interval between samples, if there is one.
    pub(crate) fn interval(&self) -> Option<S> {
        if let Sampling::Every(interval) = self.sampling { Some(interval) } else { None }
    }

    /// Returns the times of restart in the order of the run.
    pub(crate) fn restarts_in_order(&self) -> Vec<S> {
        let mut times = self.restarts.clone();
        times.sort_by(|one, other| one.partial_cmp(other).unwrap_or(Ordering::Equal));
        if self.span[1] < self.span[0] {
            times.reverse();
        }
        times
    }
}

/// Checks that times of samples are in the order of a run and within it.
fn check_times<S: Scalar>(times: &[S], [start, end]: [S; 2]) -> Result<(), SettingError<S>> {
    let is_before = |one: S, other: S| if end < start { one > other } else { one < other };
    let are_ordered = times.windows(2).all(|pair| is_before(pair[0], pair[1]));
    let is_within = |time: &S| !is_before(*time, start) && !is_before(end, *time) && time.is_finite();
    if are_ordered && times.iter().all(is_within) {
        return Ok(());
    }
    Err(SettingError::Invalid("times of samples must follow each other and lie between start and end"))
}

fn check_names<S>(names: &[String]) -> Result<(), SettingError<S>> {
    if repeated(names).is_some() {
        return Err(SettingError::RepeatedColumn);
    }
    match names.iter().find(|name| name.is_empty() || *name == TIME) {
        Some(name) if name.is_empty() => Err(SettingError::Invalid("a column has an empty name")),
        Some(_) => Err(SettingError::Invalid("a column has the name of the time, `t`")),
        None => Ok(()),
    }
}
