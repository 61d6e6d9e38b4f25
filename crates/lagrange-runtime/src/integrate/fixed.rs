//! Steps of equal length.

mod lanes;
mod saved;
mod step;

use crate::integrate::clock::{Clock, check_step};
use crate::integrate::compensated::Compensated;
use crate::integrate::corrected::{admitted, check_finite, corrected, is_same};
use crate::integrate::method::{Stepper, Work};
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, SettingError, StepFailure};

pub use self::lanes::{FixedLanes, FixedLastStep, FixedSteps, LanesFormula};
pub use self::saved::Memory;
pub use self::step::{Step, WithinStep};

/// A formula that advances the state by a step of given length.
///
/// The variables that it advances may differ from the state, such as coordinates and momenta. They
/// are summed with compensation, so that conserved quantities of the formula are conserved to
/// rounding.
pub trait Formula<M: OdeSystem + ?Sized> {
    /// True if steps end on the constraints of the system without a correction of states.
    const KEEPS_CONSTRAINTS: bool = false;

    /// Returns the variables of the state `y`, from which the integration starts or continues.
    /// Earlier results become invalid.
    fn variables(&mut self, _system: &M, _t: M::Scalar, y: &M::State) -> M::State {
        *y
    }

    /// Returns the state of these variables.
    ///
    /// # Errors
    /// If it could not be computed.
    fn state(
        &mut self,
        _system: &M,
        _t: M::Scalar,
        variables: &M::State,
        _work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        Ok(*variables)
    }

    /// Returns the change of the variables over a step. Values that are not finite are returned
    /// unchanged.
    ///
    /// # Errors
    /// If the step could not be taken.
    fn increment(&mut self, step: &Step<'_, M>, work: &mut Work) -> Result<M::State, StepFailure<M::Scalar>>;

    /// Follows a correction of the state onto constraints at time `t`. Here `from` is the state at
    /// the end of the last increment, and `to` the corrected one.
    fn follow(
        &mut self,
        _system: &M,
        _t: M::Scalar,
        (_from, to): (&M::State, &M::State),
        variables: &mut M::State,
    ) {
        *variables = *to;
    }

    /// Accepts the step of the last increment. It ended at time `t`, which may differ from the sum
    /// of its start and its length by rounding. Results at its end may be reused by the next step.
    fn accept(&mut self, _t: M::Scalar) {}

    /// Returns the approximate length of the longest stable step from here. `None` if the method
    /// cannot estimate it, or if no component is fast.
    fn longest_stable(
        &self,
        _system: &M,
        _t: M::Scalar,
        _variables: &M::State,
        _work: &mut Work,
    ) -> Option<M::Scalar> {
        None
    }

    /// Returns the state at a time within the last accepted step.
    fn interpolate(&mut self, within: &WithinStep<'_, M>, work: &mut Work) -> M::State;
}

/// Implements [`Method`](super::Method) for a method whose steps have the length of its field
/// `step`. The arguments are its name, its order, its formula and an expression that creates one,
/// and `lanes` if it can advance several motions at once.
macro_rules! fixed_steps {
    ($name:expr, $order:expr, $Formula:ty = $formula:expr $(, $lanes:ident)?) => {
        type Stepper = $crate::integrate::FixedStepper<M, $Formula>;

        fn name(&self) -> &'static str {
            $name
        }

        fn order(&self) -> u32 {
            $order
        }

        fn check(&self) -> Result<(), $crate::system::SettingError<M::Scalar>> {
            $crate::integrate::fixed::check_length(self.step)
        }

        fn start(
            &self,
            system: &M,
            t: M::Scalar,
            y: &M::State,
            end: M::Scalar,
        ) -> Result<Self::Stepper, $crate::system::StepFailure<M::Scalar>> {
            $crate::integrate::FixedStepper::start($formula, self.step, system, t, y, end)
        }

        $($crate::integrate::fixed::fixed_steps! { $lanes })?
    };
    (lanes) => {
        fn in_lanes<V: $crate::integrate::LanesMethodVisitor<M::Scalar>>(
            &self,
            visitor: V,
        ) -> Result<V::Output, V> {
            Ok(visitor.visit(*self))
        }
    };
}
pub(super) use fixed_steps;

/// Checks the length of steps.
///
/// # Errors
/// If it is not positive and finite.
pub(super) fn check_length<S: Scalar>(step: S) -> Result<(), SettingError<S>> {
    if step > S::ZERO && step.is_finite() {
        return Ok(());
    }
    Err(SettingError::Invalid("the step size must be positive and finite"))
}

/// An integration in steps of equal length; only a step to its limit may be shorter.
#[derive(Debug)]
pub struct FixedStepper<M: OdeSystem + ?Sized, F> {
    formula: F,
    clock: Clock<M::Scalar>,
    variables: Compensated<M::State>,
    state: M::State,
    last: (M::Scalar, M::State),
    work: Work,
}

impl<M: OdeSystem + ?Sized, F: Clone> Clone for FixedStepper<M, F> {
    fn clone(&self) -> Self {
        FixedStepper { formula: self.formula.clone(), ..*self }
    }
}

impl<M: OdeSystem + ?Sized, F: Formula<M>> FixedStepper<M, F> {
    /// Starts at `y` at time `t`, with steps of length `h` towards `end`.
    ///
    /// # Errors
    /// If `h` is not positive and finite or is lost in the rounding of time. Also if another
    /// argument is not finite, or the state violates constraints.
    pub fn start(
        mut formula: F,
        h: M::Scalar,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self, StepFailure<M::Scalar>> {
        check_length(h)?;
        check_finite(end, y)?;
        check_step(h, t, end)?;
        let state = admitted(system, t, y)?;
        let variables = Compensated::new(formula.variables(system, t, &state));
        let clock = Clock::new(t, if end < t { -h } else { h });
        Ok(FixedStepper { formula, clock, variables, state, last: (t, state), work: Work::default() })
    }

    /// Returns the formula in its state after the last step.
    pub fn formula(&self) -> &F {
        &self.formula
    }
}

impl<M: OdeSystem + ?Sized, F: Formula<M>> Stepper<M> for FixedStepper<M, F> {
    #[inline]
    fn time(&self) -> M::Scalar {
        self.clock.time()
    }

    #[inline]
    fn state(&self) -> &M::State {
        &self.state
    }

    #[inline]
    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        let (t, before) = (self.clock.time(), self.clock);
        let h = self.clock.advance(limit);
        let stepped = if before.is_stopped(&self.clock) {
            Err(StepFailure::StepLost { step: h.abs(), time: t })
        } else {
            self.advance(system, t, h)
        };
        if stepped.is_err() {
            self.clock = before;
        }
        stepped
    }

    fn last_time(&self) -> M::Scalar {
        self.last.0
    }

    fn interpolate(&mut self, system: &M, t: M::Scalar) -> M::State {
        let (from, to) = (self.last.0, self.clock.time());
        if t == to {
            return self.state;
        }
        let within = WithinStep { system, from: (from, &self.last.1), to: (to, &self.state), t };
        corrected(system, t, self.formula.interpolate(&within, &mut self.work))
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>> {
        let y = admitted(system, t, y)?;
        self.clock = self.clock.at(t);
        self.variables = Compensated::new(self.formula.variables(system, t, &y));
        self.state = y;
        self.last = (t, y);
        Ok(())
    }

    fn work(&self) -> Work {
        self.work
    }
}

impl<M: OdeSystem + ?Sized, F: Formula<M>> FixedStepper<M, F> {
    #[inline]
    fn advance(&mut self, system: &M, t: M::Scalar, h: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        let step = Step { system, t, y: self.variables.value(), h };
        let increment = self.formula.increment(&step, &mut self.work)?;
        let mut variables = self.variables;
        variables.add(&increment);
        let mut state = self.formula.state(system, self.clock.time(), variables.value(), &mut self.work)?;
        check_finite(self.clock.time(), &state)
            .map_err(|cause| self.too_long(system, t, h).unwrap_or(cause))?;
        if system.is_constrained() && !F::KEEPS_CONSTRAINTS {
            self.correct(system, &mut state, &mut variables)?;
        }
        self.last = (t, core::mem::replace(&mut self.state, state));
        self.variables = variables;
        self.formula.accept(self.clock.time());
        self.work.steps += 1;
        Ok(())
    }

    /// Returns the stability failure of a step of length `h` from here, if it is longer than
    /// stability allows.
    #[cold]
    fn too_long(&mut self, system: &M, t: M::Scalar, h: M::Scalar) -> Option<StepFailure<M::Scalar>> {
        let limit = self.formula.longest_stable(system, t, self.variables.value(), &mut self.work)?;
        (h.abs() > limit).then_some(StepFailure::StepTooLong { step: h.abs(), limit })
    }

    /// Brings the state at the end of a step and its variables onto the constraints.
    fn correct(
        &mut self,
        system: &M,
        state: &mut M::State,
        variables: &mut Compensated<M::State>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let (t, from) = (self.clock.time(), *state);
        system.correct(t, state)?;
        if is_same(&from, state) {
            return Ok(());
        }
        let mut followed = *variables.value();
        self.formula.follow(system, t, (&from, state), &mut followed);
        variables.replace(followed);
        check_finite(t, variables.value())
    }
}
