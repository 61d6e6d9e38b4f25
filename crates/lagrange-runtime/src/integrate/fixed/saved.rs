//! Motions in progress as numbers, from which they continue with the same bits.

use super::{FixedStepper, Formula};
use crate::integrate::compensated::Compensated;
use crate::scalar::Scalar;
use crate::system::{OdeSystem, SettingError, StepFailure};

const ANOTHER: &str =
    "the saved numbers are not those of such a motion: one is missing, too many or not finite";

/// A [`Formula`] whose variables are the state and whose memory consists of numbers.
pub trait Memory<S> {
    /// Visits, in a fixed order, the numbers at time `t` on which further steps depend, for reading
    /// or replacing them.
    fn visit(&mut self, t: S, each: &mut impl FnMut(&mut S));
}

impl<M, F> FixedStepper<M, F>
where
    M: OdeSystem + ?Sized,
    F: Formula<M> + Memory<M::Scalar> + Clone,
{
    /// Calls `note` with each number that [`restore`](Self::restore) needs: time, state, the
    /// rounding remainders of both, and the memory of the method. Their number is the same for all
    /// such motions.
    ///
    /// The settings of the method and the system with its parameters are not included.
    pub fn save(&self, mut note: impl FnMut(M::Scalar)) {
        self.clone().visit(&mut |number| note(*number));
    }

    /// Restores a motion from [saved](Self::save) numbers. It continues with the same bits as the
    /// saved motion. The method and its settings must be the same. The work done so far still
    /// counts.
    ///
    /// # Errors
    /// If the count of numbers differs, or a number is not finite. The motion is then unchanged.
    pub fn restore(
        &mut self,
        numbers: impl IntoIterator<Item = M::Scalar>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let (mut restored, mut numbers) = (self.clone(), numbers.into_iter());
        let mut are_sound = true;
        restored.visit(&mut |number| match numbers.next() {
            Some(saved) if saved.is_finite() => *number = saved,
            _ => are_sound = false,
        });
        if !are_sound || numbers.next().is_some() {
            return Err(SettingError::Invalid(ANOTHER).into());
        }
        restored.state = *restored.variables.value();
        restored.last = (restored.clock.time(), restored.state);
        *self = restored;
        Ok(())
    }

    fn visit(&mut self, each: &mut impl FnMut(&mut M::Scalar)) {
        let FixedStepper { clock, variables, formula, .. } = self;
        let ([mut time, mut late], mut state, mut rest) =
            (clock.parts(), *variables.value(), *variables.remainder());
        each(&mut time);
        state.as_mut().iter_mut().for_each(&mut *each);
        each(&mut late);
        rest.as_mut().iter_mut().for_each(&mut *each);
        (*clock, *variables) = (clock.with_parts([time, late]), Compensated::with_remainder(state, rest));
        formula.visit(time, each);
    }
}
