//! Compiler messages for runs without an end.
//!
//! The methods of [`Simulation`] that are asked of a [`Start`] are here, with a bound that nothing fulfils and that says what is
//! missing; none is ever called.

use super::builder::{Simulation, Start};
use super::control::Law;
use super::error::SimulationError;
use super::events::Event;
use super::progress::{Progress, Verdict};
use super::trajectory::Trajectory;
use crate::integrate::{Method, Verner98};
use crate::scalar::Number;
use crate::system::{Action, ControlledSystem, Direction, MechanicalSystem, ScalarOf, State};

/// A run that knows when it ends.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the run does not know when it ends",
    label = "say `.until(time)` or `.lasting(duration)` before this",
    note = "for example `system.simulate(start).until(10.0).run()`"
)]
pub trait KnowsItsEnd {}

/// The run with the default method, as it would be after `.until(…)`.
type Ended<'a, M> = Simulation<'a, M, Verner98<ScalarOf<M>>>;

#[doc(hidden)]
impl<'a, M: MechanicalSystem> Start<'a, M> {
    pub fn run(self) -> Result<Trajectory<M>, SimulationError<M>>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).run()
    }

    pub fn tolerance(self, tolerance: ScalarOf<M>) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).tolerance(tolerance)
    }

    pub fn absolute_tolerance(self, tolerance: ScalarOf<M>) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).absolute_tolerance(tolerance)
    }

    pub fn method<N: Method<M>>(self, method: N) -> Simulation<'a, M, N>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).method(method)
    }

    pub fn every_step(self) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).every_step()
    }

    pub fn every(self, interval: ScalarOf<M>) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).every(interval)
    }

    pub fn ends_only(self) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).ends_only()
    }

    pub fn dense(self) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).dense()
    }

    pub fn observe(
        self,
        name: &str,
        value: impl FnMut(&M, ScalarOf<M>, &State<M>) -> ScalarOf<M> + 'a,
    ) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).observe(name, value)
    }

    pub fn event(
        self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, ScalarOf<M>, &State<M>) -> ScalarOf<M> + 'a,
    ) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).event(name, direction, value)
    }

    pub fn stop_at(
        self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, ScalarOf<M>, &State<M>) -> ScalarOf<M> + 'a,
    ) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).stop_at(name, direction, value)
    }

    pub fn event_with(
        self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, ScalarOf<M>, &State<M>) -> ScalarOf<M> + 'a,
        react: impl FnMut(&M, &Event<ScalarOf<M>, State<M>>) -> Action<State<M>> + 'a,
    ) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).event_with(name, direction, value, react)
    }

    pub fn accelerations(self) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).accelerations()
    }

    pub fn max_steps(self, limit: u64) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).max_steps(limit)
    }

    pub fn longest_step(self, longest: ScalarOf<M>) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).longest_step(longest)
    }

    pub fn restart_at(self, times: impl IntoIterator<Item = ScalarOf<M>>) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).restart_at(times)
    }

    pub fn progress<V: Verdict>(self, callback: impl FnMut(Progress<ScalarOf<M>>) -> V + 'a) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).progress(callback)
    }

    pub fn drive<F>(self, law: F) -> Simulation<'a, M, Verner98<ScalarOf<M>>, Law<F>>
    where
        Self: KnowsItsEnd,
        M: ControlledSystem,
        F: Fn(&M, ScalarOf<M>, M::NamedState) -> M::Inputs,
    {
        self.until(M::Scalar::NAN).drive(law)
    }

    pub fn sampled<F>(self, period: ScalarOf<M>, control: F) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
        M: ControlledSystem,
        F: FnMut(&M, ScalarOf<M>, M::NamedState) -> M::Inputs + 'a,
    {
        self.until(M::Scalar::NAN).sampled(period, control)
    }

    pub fn outputs(self) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN)
    }

    pub fn record(self, _: &'static str) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN)
    }

    pub fn energy(self) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN)
    }

    pub fn momenta(self) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN)
    }

    pub fn observe_each<const N: usize>(
        self,
        names: [&str; N],
        values: impl FnMut(&M, ScalarOf<M>, &State<M>) -> [ScalarOf<M>; N] + 'a,
    ) -> Ended<'a, M>
    where
        Self: KnowsItsEnd,
    {
        self.until(M::Scalar::NAN).observe_each(names, values)
    }
}
