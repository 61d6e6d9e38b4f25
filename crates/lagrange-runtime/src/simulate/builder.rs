//! The settings of a run.

use core::marker::PhantomData;
use std::boxed::Box;
use std::format;

use crate::integrate::{Method, Verner98};
use crate::scalar::Scalar;
use crate::simulate::control::{Drive, Undriven};
use crate::simulate::events::Event;
use crate::simulate::observer::{acceleration_names, columns_of, energy};
use crate::simulate::plan::{Plan, RunPlan};
use crate::simulate::progress::{Callbacks, Progress, Verdict};
use crate::simulate::sampling::Sampling;
use crate::simulate::setters::{run_setters, tolerance_setters};
use crate::system::{Action, CanonicalSystem, Direction, EnergyFunction, MechanicalSystem, ScalarOf};
use crate::tolerance::DEFAULT_TOLERANCE;

/// A run to be started: the system, the method, and the results to keep.
///
/// K is the method, D drives the inputs, and E is [`Ended`] or [`Unended`], depending on whether an
/// end was specified. `.tolerance(…)` and `.absolute_tolerance(…)` exist for the default method
/// only; other methods have their own settings:
///
/// ```compile_fail,E0599
/// # lagrange::system! {
/// #     pub struct Pendulum;
/// #     param m = 1.0, l = 1.0, g = 9.81;
/// #     coord theta;
/// #     kinetic = 1/2 * m * (l * dot(theta))^2;
/// #     potential = -m * g * l * cos(theta);
/// # }
/// use lagrange::Simulate;
/// use lagrange::integrate::RungeKutta4;
///
/// let pendulum = Pendulum::default();
/// let simulation = pendulum.simulate([0.5, 0.0]).until(2.0);
/// simulation.method(RungeKutta4 { step: 1e-3 }).tolerance(1e-9).run().unwrap();
/// ```
#[must_use = "nothing happens before `.run()`"]
pub struct Simulation<'a, M: MechanicalSystem, K, D = Undriven, E = Ended> {
    pub(super) system: &'a M,
    pub(super) state: M::State,
    pub(super) plan: RunPlan<'a, M>,
    pub(super) callbacks: Callbacks<'a, M::Scalar>,
    pub(super) method: K,
    pub(super) drive: D,
    pub(super) end: PhantomData<E>,
}

/// A run with an end time.
#[derive(Clone, Copy, Debug)]
pub enum Ended {}

/// A run without an end time, which still needs [`until`](Simulation::until) or
/// [`lasting`](Simulation::lasting).
#[derive(Clone, Copy, Debug)]
pub enum Unended {}

/// A run with an end time.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the run has no end",
    label = "call `.until(time)` or `.lasting(duration)` before this",
    note = "for example `system.simulate(start).until(10.0).run()`"
)]
pub trait KnowsItsEnd {}

impl KnowsItsEnd for Ended {}

/// A run with a start, which still needs an end.
pub type Start<'a, M> = Simulation<'a, M, Verner98<ScalarOf<M>>, Undriven, Unended>;

impl<'a, M: MechanicalSystem> Start<'a, M> {
    pub(super) fn of(system: &'a M, state: M::State) -> Self {
        Simulation {
            system,
            state,
            plan: Plan::new(Sampling::EveryStep),
            callbacks: Callbacks::none(),
            method: default_method(),
            drive: Undriven,
            end: PhantomData,
        }
    }
}

#[cfg(any(feature = "ensemble", feature = "fit"))]
impl<'a, M: MechanicalSystem, K, D> Simulation<'a, M, K, D> {
    /// Returns the run of a plan from a state.
    pub(crate) fn new(system: &'a M, state: M::State, plan: RunPlan<'a, M>, (method, drive): (K, D)) -> Self {
        Simulation { system, state, plan, callbacks: Callbacks::none(), method, drive, end: PhantomData }
    }
}

impl<'a, M: MechanicalSystem, K, D> Simulation<'a, M, K, D, Unended> {
    /// Starts at this time instead of 0.
    pub fn from(mut self, time: M::Scalar) -> Self {
        self.plan.settings.span = [time; 2];
        self
    }

    /// Ends at this time, which may lie before the start.
    pub fn until(mut self, end: M::Scalar) -> Simulation<'a, M, K, D> {
        self.plan.settings.span[1] = end;
        let Simulation { system, state, plan, callbacks, method, drive, .. } = self;
        Simulation { system, state, plan, callbacks, method, drive, end: PhantomData }
    }

    /// Ends after this duration; runs backwards if it is negative.
    pub fn lasting(self, duration: M::Scalar) -> Simulation<'a, M, K, D> {
        let end = self.plan.settings.span[0] + duration;
        self.until(end)
    }
}

/// The name of the column that [`Simulation::energy`] adds.
pub(crate) const ENERGY: &str = "energy";
/// Default tolerance of the default method, if the number type is precise enough.
const TOLERANCE: f64 = 1e-9;

/// Returns the default method of runs.
pub(crate) fn default_method<S: Scalar>() -> Verner98<S> {
    Verner98::tolerance(S::from_f64(TOLERANCE).max(DEFAULT_TOLERANCE.part::<S>()))
}

impl<M: MechanicalSystem, D, E> Simulation<'_, M, Verner98<M::Scalar>, D, E> {
    tolerance_setters!();
}

impl<'a, M: MechanicalSystem, K, D, E> Simulation<'a, M, K, D, E> {
    run_setters!(plan);

    /// Integrates by this method instead of the adaptive one.
    pub fn method<N>(self, method: N) -> Simulation<'a, M, N, D, E>
    where
        D: Drive<M>,
        N: Method<D::Closed>,
    {
        let Simulation { system, state, plan, callbacks, drive, end, .. } = self;
        Simulation { system, state, plan, callbacks, method, drive, end }
    }

    /// Keeps a sample at the start, after every step, and so at the end. This is the default.
    pub fn every_step(mut self) -> Self {
        self.plan.settings.sampling = Sampling::EveryStep;
        self
    }

    /// Keeps a sample at the start, at the end, and at start + k `interval` between them.
    ///
    /// Samples do not affect the steps of the method; states within a step are interpolated.
    pub fn every(mut self, interval: M::Scalar) -> Self {
        self.plan.settings.sampling = Sampling::Every(interval);
        self
    }

    /// Keeps a sample at the start, at the end, and at each of these times between them, such as
    /// the times of a measurement. Times must be in the order of the run.
    pub fn at_times(mut self, times: impl IntoIterator<Item = M::Scalar>) -> Self {
        self.plan.settings.sampling = Sampling::Times;
        self.plan.settings.times = times.into_iter().collect();
        self
    }

    /// Keeps samples only at the start and at the end.
    pub fn ends_only(mut self) -> Self {
        self.plan.settings.sampling = Sampling::Ends;
        self
    }

    /// Keeps, in addition to the samples, the data for [`Trajectory::at`](super::Trajectory::at) at
    /// any time: order + 2 states per step, at least 6.
    pub fn dense(mut self) -> Self {
        self.plan.settings.is_dense = true;
        self
    }

    /// Adds a column: a value computed from time and state for each sample.
    pub fn observe(
        self,
        name: &str,
        mut value: impl FnMut(&M, M::Scalar, &M::State) -> M::Scalar + 'a,
    ) -> Self {
        self.observe_each([name], move |system, t, y| [value(system, t, y)])
    }

    /// Adds several columns that are computed together, such as the components of an output.
    pub fn observe_each<const N: usize>(
        mut self,
        names: [&str; N],
        mut values: impl FnMut(&M, M::Scalar, &M::State) -> [M::Scalar; N] + 'a,
    ) -> Self {
        self.plan.observe(names, Box::new(move |system, t, y, row| row.extend(values(system, t, y))));
        self
    }

    /// Adds the column `energy`: the energy function, which is constant if L does not depend on
    /// time and forces do no work.
    pub fn energy(mut self) -> Self
    where
        M: EnergyFunction,
    {
        self.plan.observe([ENERGY], Box::new(columns_of(energy::<M>)));
        self
    }

    /// Adds a column for the momentum of each coordinate, such as `p_theta`.
    pub fn momenta(mut self) -> Self
    where
        M: CanonicalSystem,
    {
        let names = self.system.description().coordinates.iter().map(|name| format!("p_{name}"));
        self.plan.observe(names, Box::new(columns_of(M::momenta)));
        self
    }

    /// Adds a column for each acceleration, such as `theta_ddot` for a coordinate `theta`, or
    /// `w_dot` for a velocity named `w`.
    pub fn accelerations(mut self) -> Self {
        self.plan
            .observe(acceleration_names(self.system.description()), Box::new(columns_of(M::acceleration)));
        self
    }

    /// Records each zero of a function of time and state that is crossed in this direction, under
    /// this name in [`Trajectory::events`](super::Trajectory::events).
    ///
    /// Zeros are located as in [`crate::event`]: within a step, to 10⁻¹³ of its length. Functions
    /// receive the system of that time, with its closed contacts and sticking friction. Events of
    /// the declaration are always recorded.
    pub fn event(
        self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, M::Scalar, &M::State) -> M::Scalar + 'a,
    ) -> Self {
        self.event_with(name, direction, value, |_, _| Action::Continue)
    }

    /// Ends the run at the first zero crossed in this direction, which is also recorded.
    pub fn stop_at(
        self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, M::Scalar, &M::State) -> M::Scalar + 'a,
    ) -> Self {
        self.event_with(name, direction, value, |_, _| Action::Stop)
    }

    /// Records each zero crossed in this direction. The run then continues, stops, or continues
    /// from another state, as after an impact.
    pub fn event_with(
        mut self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, M::Scalar, &M::State) -> M::Scalar + 'a,
        react: impl FnMut(&M, &Event<M::Scalar, M::State>) -> Action<M::State> + 'a,
    ) -> Self {
        self.plan.watch(name, direction, (Box::new(value), Box::new(react)));
        self
    }

    /// Calls back about 200 times during the run, as for a progress bar.
    ///
    /// The callback returns nothing, or `ControlFlow::Break(())` to cancel the run, which then
    /// returns the trajectory so far. It is also called, at growing intervals, while a run takes
    /// many steps without progress.
    pub fn progress<V: Verdict>(mut self, callback: impl FnMut(Progress<M::Scalar>) -> V + 'a) -> Self {
        self.callbacks.report_to(callback);
        self
    }

    /// Cancels the run soon after this function returns true, such as one that reads an atomic
    /// flag. The run then returns the trajectory so far. It is called every few dozen steps.
    pub fn cancel_when(mut self, is_cancelled: impl Fn() -> bool + 'a) -> Self {
        self.callbacks.cancel_when(is_cancelled);
        self
    }
}
