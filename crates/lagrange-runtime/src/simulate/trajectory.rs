//! The result of a run.

use std::fmt::{Debug, Display, Formatter};
use std::ops::Deref;
use std::string::String;
use std::sync::Arc;
use std::vec::Vec;

use crate::integrate::Work;
use crate::simulate::controllers::InputColumns;
use crate::simulate::dense::Dense;
use crate::simulate::events::Event;
use crate::simulate::table::Table;
use crate::simulate::units::unit;
#[cfg(feature = "plot")]
use crate::system::Domain;
use crate::system::{Description, MechanicalSystem, normalised};

/// The result of a run: samples in named columns, and the work of the run.
///
/// Columns are the coordinates and velocities, then the columns of observers. There is at least one
/// sample, the initial state, and the last sample is the end of the run.
///
/// For an emitted system, the columns of the state are also methods, such as `trajectory.theta()`
/// and `trajectory.theta_dot()`. If a column has the name of another method of this type, use
/// [`column`](Trajectory::column).
pub struct Trajectory<M: MechanicalSystem> {
    pub(super) columns: M::Columns<Table<M::Scalar>>,
    pub(super) dense: Option<Dense<M::Scalar, M::State>>,
    pub(super) events: Vec<Event<M::Scalar, M::State>>,
    pub(super) work: Work,
    pub(super) ending: Ending,
    pub(super) first: (M::Scalar, M::State),
    pub(super) last: (M::Scalar, M::State),
    pub(super) method: &'static str,
    pub(super) inputs: Option<InputColumns<M>>,
    /// Number of variables by which the state is differentiated, in the last columns.
    pub(super) variables: usize,
    /// The system at the end of the run, if it was switched. Shared, so that trajectories can be
    /// cloned even if systems cannot.
    pub(super) system: Option<Arc<M>>,
    /// Names and units of the system.
    pub(super) description: &'static Description,
    /// Declared ranges of the state.
    #[cfg(feature = "plot")]
    pub(super) domain: &'static Domain,
}

/// The ending of a run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Ending {
    /// It reached its end time.
    Reached,
    /// An event stopped it: the last of [`Trajectory::events`].
    Stopped,
    /// The progress callback cancelled it.
    Cancelled,
    /// It failed; only the trajectory within an error has this ending.
    Failed,
}

impl<M: MechanicalSystem> Trajectory<M> {
    /// Returns the number of samples; at least one.
    #[expect(clippy::len_without_is_empty, reason = "there is at least one sample")]
    pub fn len(&self) -> usize {
        self.table().len()
    }

    /// Returns the times of the samples, in the order of the run: descending if it ran backwards.
    pub fn times(&self) -> &[M::Scalar] {
        self.table().times()
    }

    /// Returns the names of the columns, in order; time has no name.
    pub fn names(&self) -> &[String] {
        self.table().names()
    }

    /// Returns the column of this name: a coordinate, a velocity such as `theta_dot`, or an
    /// observed quantity.
    pub fn column(&self, name: &str) -> Option<&[M::Scalar]> {
        self.table().column(name)
    }

    /// Returns the unit of the column of this name, such as `rad/s`; `s` for `t` and `1` for plain
    /// numbers. `None` if the unit is not known: the declaration has no units, or an observer added
    /// the column under a new name.
    pub fn unit(&self, name: &str) -> Option<&'static str> {
        unit(self.description, name)
    }

    /// Returns all columns.
    pub fn table(&self) -> &Table<M::Scalar> {
        self.columns.as_ref()
    }

    /// Returns the state of a sample, counted from zero.
    pub fn state(&self, index: usize) -> Option<M::State> {
        let mut state = self.first();
        for (component, column) in state.as_mut().iter_mut().zip(self.table().columns()) {
            *component = *column.get(index)?;
        }
        Some(state)
    }

    /// Returns the derivatives of the state of a sample, counted from zero: one vector per variable
    /// of [`sensitivities`](crate::simulate::Simulation::sensitivities), in order. `None` if there
    /// is no such sample.
    pub fn sensitivities(&self, index: usize) -> Option<Vec<M::State>> {
        let length = self.first().as_ref().len();
        let before = self.names().len() - self.variables * length;
        let mut entries = self.table().columns().skip(before).map(|column| column.get(index).copied());
        let mut vector = || {
            let mut vector = self.first();
            vector.as_mut().iter_mut().try_for_each(|entry| entries.next()?.map(|value| *entry = value))?;
            Some(vector)
        };
        (index < self.len()).then(|| (0..self.variables).map_while(|_| vector()).collect())
    }

    /// Returns the states of the samples.
    pub fn states(&self) -> impl Iterator<Item = M::State> + '_ {
        (0..self.len()).filter_map(|index| self.state(index))
    }

    /// Returns the times and states of the samples.
    pub fn iter(&self) -> impl Iterator<Item = (M::Scalar, M::State)> + '_ {
        self.times().iter().copied().zip(self.states())
    }

    /// Returns the state where the run started.
    pub fn first(&self) -> M::State {
        self.first.1
    }

    /// Returns the time at which the run started.
    pub fn start_time(&self) -> M::Scalar {
        self.first.0
    }

    /// Returns the state where the run ended.
    pub fn last(&self) -> M::State {
        self.last.1
    }

    /// Returns the system at the end of the run, if contacts or friction switched it or controllers
    /// set its inputs. `None` if it is still the original one. To continue a run, start from this
    /// system and from [`last`](Trajectory::last). A law of inputs is not part of the system, and
    /// must be specified again.
    pub fn system_at_end(&self) -> Option<&M> {
        self.system.as_deref()
    }

    /// Returns a system with the inputs of this sample, counted from zero; `None` if the run set no
    /// inputs. Inputs set by a law vary between samples.
    pub fn with_inputs_at(&self, index: usize, system: &M) -> Option<M> {
        self.inputs.and_then(|inputs| inputs.at(self.table(), index, system))
    }

    /// Returns the time at which the run ended.
    pub fn end_time(&self) -> M::Scalar {
        self.last.0
    }

    /// Returns the state at any time of a run that was
    /// [`dense`](crate::simulate::Simulation::dense); at the time of an impact, the state after it.
    ///
    /// The error is that of the method's own interpolation, plus a few roundings. Quaternions are
    /// normalised to unit length.
    ///
    /// # Errors
    /// If the run was not dense, or did not pass this time.
    pub fn at(&self, t: M::Scalar) -> Result<M::State, NotKept<M::Scalar>> {
        let dense = self.dense.as_ref().ok_or(NotKept::NotDense)?;
        if t == self.end_time() {
            return Ok(self.last());
        }
        let outside = NotKept::Outside { time: t, start: self.start_time(), end: self.end_time() };
        dense.at(t).map(|state| normalised::<M>(self.description, &state)).ok_or(outside)
    }

    /// Returns the events in the order of the run: those of the declaration, and those that were
    /// requested.
    pub fn events(&self) -> &[Event<M::Scalar, M::State>] {
        &self.events
    }

    /// Returns the work of the run.
    pub fn work(&self) -> Work {
        self.work
    }

    /// Returns the ending of the run.
    pub fn ending(&self) -> Ending {
        self.ending
    }

    /// Returns the name of the method.
    pub fn method(&self) -> &'static str {
        self.method
    }
}

impl<M: MechanicalSystem> Deref for Trajectory<M> {
    type Target = M::Columns<Table<M::Scalar>>;

    fn deref(&self) -> &Self::Target {
        &self.columns
    }
}

impl<M: MechanicalSystem> Clone for Trajectory<M> {
    fn clone(&self) -> Self {
        Trajectory {
            columns: self.table().clone().into(),
            dense: self.dense.clone(),
            events: self.events.clone(),
            system: self.system.clone(),
            ..*self
        }
    }
}

/// Omits the samples, of which there may be millions.
impl<M: MechanicalSystem> Debug for Trajectory<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Trajectory")
            .field("method", &self.method)
            .field("ending", &self.ending)
            .field("samples", &self.len())
            .field("columns", &self.names())
            .field("first", &self.first)
            .field("last", &self.last)
            .field("work", &self.work)
            .finish_non_exhaustive()
    }
}

/// The reason why a state between samples is not available.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum NotKept<S> {
    /// The run kept only its samples.
    NotDense,
    /// The run did not pass this time.
    Outside {
        /// The requested time.
        time: S,
        /// Start of the run.
        start: S,
        /// End of the run.
        end: S,
    },
}

impl<S: Debug> Display for NotKept<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            NotKept::NotDense => f.write_str("only a run that is `.dense()` stores states between samples"),
            NotKept::Outside { time, start, end } => {
                write!(f, "time {time:?} is not between {start:?} and {end:?}, the ends of the run")
            }
        }
    }
}

impl<S: Debug> std::error::Error for NotKept<S> {}
