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
use crate::simulate::progress::{Progress, Reporter, Verdict};
use crate::simulate::sampling::Sampling;
use crate::system::{Action, CanonicalSystem, Direction, EnergyFunction, MechanicalSystem, ScalarOf};
use crate::tolerance::DEFAULT_TOLERANCE;

/// A run that can be started: what to integrate, how, and what to keep of it.
///
/// K is the method, D drives the inputs, and E tells if the run has an end: [`Ended`] or
/// [`Unended`]. `.tolerance(…)` and `.absolute_tolerance(…)` exist for the default method only;
/// other methods have their own settings:
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
    pub(super) reporter: Option<Reporter<'a, M::Scalar>>,
    pub(super) method: K,
    pub(super) drive: D,
    pub(super) end: PhantomData<E>,
}

/// The run ends at a time.
#[derive(Clone, Copy, Debug)]
pub enum Ended {}

/// The run has no end yet: it needs [`until`](Simulation::until) or
/// [`lasting`](Simulation::lasting).
#[derive(Clone, Copy, Debug)]
pub enum Unended {}

/// A run that knows when it ends.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the run has no end",
    label = "call `.until(time)` or `.lasting(duration)` before this",
    note = "for example `system.simulate(start).until(10.0).run()`"
)]
pub trait KnowsItsEnd {}

impl KnowsItsEnd for Ended {}

/// The start of a run, which still needs an end.
pub type Start<'a, M> = Simulation<'a, M, Verner98<ScalarOf<M>>, Undriven, Unended>;

impl<'a, M: MechanicalSystem> Start<'a, M> {
    pub(super) fn of(system: &'a M, state: M::State) -> Self {
        Simulation {
            system,
            state,
            plan: Plan::new(Sampling::EveryStep),
            reporter: None,
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
        Simulation { system, state, plan, reporter: None, method, drive, end: PhantomData }
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
        let Simulation { system, state, plan, reporter, method, drive, .. } = self;
        Simulation { system, state, plan, reporter, method, drive, end: PhantomData }
    }

    /// Ends when this much time has passed; backwards if it is negative.
    pub fn lasting(self, duration: M::Scalar) -> Simulation<'a, M, K, D> {
        let end = self.plan.settings.span[0] + duration;
        self.until(end)
    }
}

/// The name of the column that [`Simulation::energy`] adds.
pub(crate) const ENERGY: &str = "energy";
/// The tolerance of the default method if none is given, where numbers are fine enough.
const TOLERANCE: f64 = 1e-9;

/// Returns the default method of runs.
pub(crate) fn default_method<S: Scalar>() -> Verner98<S> {
    Verner98::tolerance(S::from_f64(TOLERANCE).max(DEFAULT_TOLERANCE.part::<S>()))
}

impl<M: MechanicalSystem, D, E> Simulation<'_, M, Verner98<M::Scalar>, D, E> {
    /// Sets the tolerated error of a step. It is relative for components of the state that are
    /// larger than one, and absolute for smaller ones. 1e-9 by default for `f64`, 1.2e-6 for `f32`.
    ///
    /// The error at the end is the sum of these errors as the motion carries them on.
    pub fn tolerance(mut self, tolerance: M::Scalar) -> Self {
        self.method.relative = tolerance;
        self.method.absolute = tolerance;
        self
    }

    /// Sets the tolerated error of a step in the units of the state. Call it after
    /// [`tolerance`](Self::tolerance), which then is relative only.
    pub fn absolute_tolerance(mut self, tolerance: M::Scalar) -> Self {
        self.method.absolute = tolerance;
        self
    }
}

impl<'a, M: MechanicalSystem, K, D, E> Simulation<'a, M, K, D, E> {
    /// Integrates by this method instead of the adaptive one.
    pub fn method<N>(self, method: N) -> Simulation<'a, M, N, D, E>
    where
        D: Drive<M>,
        N: Method<D::Closed>,
    {
        let Simulation { system, state, plan, reporter, drive, end, .. } = self;
        Simulation { system, state, plan, reporter, method, drive, end }
    }

    /// Keeps a sample at the start, after every step, and so at the end. This is the default.
    pub fn every_step(mut self) -> Self {
        self.plan.settings.sampling = Sampling::EveryStep;
        self
    }

    /// Keeps a sample at the start, at the end, and at start + k `interval` between them.
    ///
    /// The method steps as it would without samples; what lies within a step is interpolated.
    pub fn every(mut self, interval: M::Scalar) -> Self {
        self.plan.settings.sampling = Sampling::Every(interval);
        self
    }

    /// Keeps a sample at the start, at the end, and at each of these times between them, as those
    /// of a measurement. They must be in the order of the run.
    pub fn at_times(mut self, times: impl IntoIterator<Item = M::Scalar>) -> Self {
        self.plan.settings.sampling = Sampling::Times;
        self.plan.settings.times = times.into_iter().collect();
        self
    }

    /// Keeps a sample at the start and at the end only.
    pub fn ends_only(mut self) -> Self {
        self.plan.settings.sampling = Sampling::Ends;
        self
    }

    /// Keeps besides the samples what [`Trajectory::at`](super::Trajectory::at) needs to know the
    /// state at any time: order + 2 states a step, 6 at least.
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

    /// Adds a column for each acceleration, such as `theta_ddot` of a coordinate `theta`, and
    /// `w_dot` of a velocity that is called `w`.
    pub fn accelerations(mut self) -> Self {
        self.plan
            .observe(acceleration_names(self.system.description()), Box::new(columns_of(M::acceleration)));
        self
    }

    /// Records each zero of a function of time and state that is passed in this direction, under
    /// this name in [`Trajectory::events`](super::Trajectory::events).
    ///
    /// Zeros are found as in [`crate::event`]: within a step, to 10⁻¹³ of it. Functions receive the
    /// system of that time, with its closed contacts and sticking friction. Events of the
    /// declaration are always recorded.
    pub fn event(
        self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, M::Scalar, &M::State) -> M::Scalar + 'a,
    ) -> Self {
        self.event_with(name, direction, value, |_, _| Action::Continue)
    }

    /// Ends the run at the first such zero, which is recorded, too.
    pub fn stop_at(
        self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, M::Scalar, &M::State) -> M::Scalar + 'a,
    ) -> Self {
        self.event_with(name, direction, value, |_, _| Action::Stop)
    }

    /// Records each such zero. The run then continues, stops, or continues from another state, as
    /// after an impact.
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

    /// Gives up with an error after this many steps, rejected ones included. The default method is
    /// limited to a hundred million steps; others have no limit.
    pub fn max_steps(mut self, limit: u64) -> Self {
        self.plan.settings.max_steps = Some(limit);
        self
    }

    /// Takes no step longer than this, so that nothing that lasts about a quarter of it is stepped
    /// over. By default, steps of the adaptive method are no longer than a twentieth of the run,
    /// and a two-hundredth while the system is at rest. For methods with a fixed step length it is
    /// an error.
    pub fn longest_step(mut self, longest: M::Scalar) -> Self {
        self.plan.settings.longest_step = Some(longest);
        self
    }

    /// Ends a step at each of these times and starts another one there, for a force that jumps or
    /// has a kink at known times. Times that are not between start and end have no effect; further
    /// calls add times.
    ///
    /// Nothing is evaluated at such a time itself. The side of the time to which a jump belongs
    /// therefore has no effect.
    pub fn restart_at(mut self, times: impl IntoIterator<Item = M::Scalar>) -> Self {
        self.plan.settings.restarts.extend(times);
        self
    }

    /// Calls back about 200 times during the run, as for a progress bar.
    ///
    /// The callback returns nothing, or `ControlFlow::Break(())` to cancel the run, which then
    /// returns the trajectory so far. It is also called, ever more seldom, while a run takes many
    /// steps and gets nowhere.
    pub fn progress<V: Verdict>(self, callback: impl FnMut(Progress<M::Scalar>) -> V + 'a) -> Self {
        Simulation { reporter: Some(Reporter::new(callback)), ..self }
    }
}
