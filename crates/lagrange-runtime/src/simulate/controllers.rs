//! Inputs during a run that controllers set every so often, and hold in between.

use std::boxed::Box;
use std::vec::Vec;

use crate::scalar::Number;
use crate::simulate::sampling::Grid;
use crate::simulate::table::Table;
use crate::system::{ControlledSystem, MechanicalSystem, ScalarOf, SettingError, State, StepFailure};
use crate::tolerance::SAME_INSTANT;

/// The columns that hold inputs, and how a system gets these from a sample.
pub(crate) struct InputColumns<M: MechanicalSystem> {
    first: usize,
    set: fn(&M, &[M::Scalar]) -> M,
}

impl<M: MechanicalSystem> Clone for InputColumns<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: MechanicalSystem> Copy for InputColumns<M> {}

impl<M: ControlledSystem> InputColumns<M> {
    /// Returns the indices of all inputs, starting at this column.
    pub(super) fn from(first: usize) -> Self {
        let set = |system: &M, values: &[M::Scalar]| {
            let mut inputs: M::InputVector = system.inputs().into();
            inputs.as_mut().iter_mut().zip(values).for_each(|(input, value)| *input = *value);
            system.with_inputs(inputs.into())
        };
        InputColumns { first, set }
    }
}

impl<M: MechanicalSystem> InputColumns<M> {
    /// Returns the system with the inputs of this sample.
    pub(super) fn at(&self, table: &Table<M::Scalar>, index: usize, system: &M) -> Option<M> {
        let inputs = table.columns().skip(self.first).map(|column| column.get(index).copied());
        let inputs: Vec<M::Scalar> = inputs.collect::<Option<_>>()?;
        Some((self.set)(system, &inputs))
    }
}

/// A controller: returns the system with the inputs that it gives it.
pub(crate) type Act<'a, M> =
    Box<dyn FnMut(&M, ScalarOf<M>, &State<M>) -> Result<M, StepFailure<ScalarOf<M>>> + 'a>;

/// A controller that acts every so often and holds its inputs in between.
struct Controller<'a, M: MechanicalSystem> {
    act: Act<'a, M>,
    /// Its instants after the start.
    instants: Grid<M::Scalar>,
}

/// The controllers of a run.
pub(super) struct Controllers<'a, M: MechanicalSystem> {
    controllers: Vec<Controller<'a, M>>,
    end: M::Scalar,
}

impl<'a, M: MechanicalSystem> Controllers<'a, M> {
    /// Returns the controllers with these periods of a run over this span.
    ///
    /// # Errors
    /// If a period makes no sense.
    pub(super) fn new(
        span: [M::Scalar; 2],
        periods: &[M::Scalar],
        acts: Vec<Act<'a, M>>,
    ) -> Result<Self, SettingError<M::Scalar>> {
        let mut controllers = Vec::new();
        for (period, act) in periods.iter().zip(acts) {
            controllers.push(Controller { act, instants: Grid::new(span, *period)? });
        }
        Ok(Controllers { controllers, end: span[1] })
    }

    /// Returns the next instant at which one acts.
    pub(super) fn next(&self) -> Option<M::Scalar> {
        let mut next = None;
        for controller in &self.controllers {
            if let Some(time) = { controller.instants }.up_to(self.end)
                && next.is_none_or(|next: M::Scalar| (self.end - time).abs() > (self.end - next).abs())
            {
                next = Some(time);
            }
        }
        next
    }

    /// Lets all act at the start.
    ///
    /// # Errors
    /// If an input is not finite.
    pub(super) fn begin(&mut self, system: &M, start: (M::Scalar, &M::State)) -> Acted<M> {
        self.ask(|_| true, system, start)
    }

    /// Runs the controllers whose instants have been reached; instants that differ by rounding are
    /// the same.
    pub(super) fn act(&mut self, system: &M, reached: M::Scalar, (t, y): (M::Scalar, &M::State)) -> Acted<M> {
        let rounding = SAME_INSTANT.part::<M::Scalar>() * reached.abs();
        let reached = if self.end < t { reached - rounding } else { reached + rounding };
        let is_due = |grid: &mut Grid<M::Scalar>| {
            let mut is_due = false;
            while grid.up_to(reached).is_some() {
                is_due = true;
            }
            is_due
        };
        self.ask(is_due, system, (t, y))
    }

    /// Runs the controllers that are due, in the order in which they were added, each on the system
    /// that the last one left.
    fn ask(
        &mut self,
        mut is_due: impl FnMut(&mut Grid<M::Scalar>) -> bool,
        system: &M,
        (t, y): (M::Scalar, &M::State),
    ) -> Acted<M> {
        let mut acted = None;
        for controller in &mut self.controllers {
            if is_due(&mut controller.instants) {
                acted = Some((controller.act)(acted.as_ref().unwrap_or(system), t, y)?);
            }
        }
        Ok(acted)
    }
}

/// The system with the inputs that controllers gave it, if one did.
type Acted<M> = Result<Option<M>, StepFailure<ScalarOf<M>>>;
