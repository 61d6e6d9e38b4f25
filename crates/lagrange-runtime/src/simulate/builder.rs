//! The settings of a run.

use std::boxed::Box;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::integrate::{Method, Verner98};
use crate::scalar::Scalar;
use crate::simulate::control::{Controller, Drive, InputColumns, Undriven};
use crate::simulate::events::{Event, Watcher};
use crate::simulate::observer::{Extend, Observer, acceleration_names};
use crate::simulate::progress::{Progress, Reporter, Verdict};
use crate::simulate::sampling::Sampling;
use crate::system::{
    Action, CanonicalSystem, Direction, EnergyFunction, MechanicalSystem, StepFailure, split,
};
use crate::tolerance::DEFAULT_TOLERANCE;

/// The start of a run, which still needs an end.
#[derive(Clone, Copy, Debug)]
#[must_use = "say when the run ends: `.until(time)`"]
pub struct Start<'a, M: MechanicalSystem> {
    system: &'a M,
    time: M::Scalar,
    state: M::State,
}

impl<'a, M: MechanicalSystem> Start<'a, M> {
    pub(crate) fn of(system: &'a M, time: M::Scalar, state: M::State) -> Self {
        Start { system, time, state }
    }

    /// Starts at this time instead of 0.
    pub fn from(self, time: M::Scalar) -> Self {
        Start { time, ..self }
    }

    /// Ends at this time, which may lie before the start.
    pub fn until(self, end: M::Scalar) -> Simulation<'a, M, Verner98<M::Scalar>> {
        Simulation {
            system: self.system,
            start: (self.time, self.state),
            end,
            method: Verner98::tolerance(default_tolerance()),
            drive: Undriven,
            controllers: Vec::new(),
            inputs: None,
            fault: None,
            sampling: Sampling::EveryStep,
            is_dense: false,
            max_steps: None,
            restarts: Vec::new(),
            longest_step: None,
            observers: Vec::new(),
            watchers: Vec::new(),
            reporter: None,
        }
    }

    /// Ends when this much time has passed; backwards if it is negative.
    pub fn lasting(self, duration: M::Scalar) -> Simulation<'a, M, Verner98<M::Scalar>> {
        let end = self.time + duration;
        self.until(end)
    }
}

/// A run that can be started: what to integrate, how, and what to keep of it.
///
/// K is the method, D what drives the inputs. `.tolerance(…)` and `.absolute_tolerance(…)` exist for the default method only; other methods come
/// with settings of their own:
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
pub struct Simulation<'a, M: MechanicalSystem, K, D = Undriven> {
    pub(super) system: &'a M,
    pub(super) start: (M::Scalar, M::State),
    pub(super) end: M::Scalar,
    pub(super) method: K,
    pub(super) drive: D,
    pub(super) controllers: Vec<Controller<'a, M>>,
    /// The columns of inputs, if they are set during the run.
    pub(super) inputs: Option<InputColumns<M>>,
    /// A setting that makes no sense.
    pub(super) fault: Option<StepFailure<M::Scalar>>,
    pub(super) sampling: Sampling<M::Scalar>,
    pub(super) is_dense: bool,
    pub(super) max_steps: Option<u64>,
    pub(super) restarts: Vec<M::Scalar>,
    pub(super) longest_step: Option<M::Scalar>,
    pub(super) observers: Vec<Observer<'a, M>>,
    pub(super) watchers: Vec<Watcher<'a, M>>,
    pub(super) reporter: Option<Reporter<'a, M::Scalar>>,
}

/// The name of the column that [`Simulation::energy`] adds.
pub(super) const ENERGY: &str = "energy";
/// The tolerance of the default method if none is given, where numbers are fine enough.
const TOLERANCE: f64 = 1e-9;

fn default_tolerance<S: Scalar>() -> S {
    S::from_f64(TOLERANCE).max(DEFAULT_TOLERANCE.part::<S>())
}

impl<M: MechanicalSystem, D> Simulation<'_, M, Verner98<M::Scalar>, D> {
    /// The error that is tolerated in a step: relative to a component of the state where that is larger than one,
    /// absolute where it is smaller. 1e-9 by default for `f64`, 1.2e-6 for `f32`.
    ///
    /// The error at the end is the sum of these errors as the motion carries them on.
    pub fn tolerance(mut self, tolerance: M::Scalar) -> Self {
        self.method.relative = tolerance;
        self.method.absolute = tolerance;
        self
    }

    /// The error that is tolerated in a step in the units of the state, to be given after
    /// [`tolerance`](Self::tolerance), which then is relative only.
    pub fn absolute_tolerance(mut self, tolerance: M::Scalar) -> Self {
        self.method.absolute = tolerance;
        self
    }
}

impl<'a, M: MechanicalSystem, K, D: Drive<M>> Simulation<'a, M, K, D> {
    /// Integrates by this method instead of the adaptive one.
    pub fn method<N: Method<D::Closed>>(self, method: N) -> Simulation<'a, M, N, D> {
        self.exchange(|_, drive| (method, drive))
    }

    /// The method, as it is set.
    #[cfg(feature = "ensemble")]
    pub(crate) fn into_method(self) -> K {
        self.method
    }

    /// Returns the simulation with another method and another drive.
    pub(crate) fn exchange<N, E>(self, exchange: impl FnOnce(K, D) -> (N, E)) -> Simulation<'a, M, N, E> {
        let (method, drive) = exchange(self.method, self.drive);
        Simulation {
            system: self.system,
            start: self.start,
            end: self.end,
            method,
            drive,
            controllers: self.controllers,
            inputs: self.inputs,
            fault: self.fault,
            sampling: self.sampling,
            is_dense: self.is_dense,
            max_steps: self.max_steps,
            restarts: self.restarts,
            longest_step: self.longest_step,
            observers: self.observers,
            watchers: self.watchers,
            reporter: self.reporter,
        }
    }

    /// Keeps a sample at the start, after every step, and so at the end. This is the default.
    pub fn every_step(self) -> Self {
        Simulation { sampling: Sampling::EveryStep, ..self }
    }

    /// Keeps a sample at the start, at the end, and at start + k `interval` between them.
    ///
    /// The method steps as it would without samples; what lies within a step is interpolated.
    pub fn every(self, interval: M::Scalar) -> Self {
        Simulation { sampling: Sampling::Every(interval), ..self }
    }

    /// Keeps a sample at the start and at the end only.
    pub fn ends_only(self) -> Self {
        Simulation { sampling: Sampling::Ends, ..self }
    }

    /// Keeps besides the samples what [`Trajectory::at`](super::Trajectory::at) needs to know the state at any time: order + 2 states a
    /// step, 6 at least.
    pub fn dense(self) -> Self {
        Simulation { is_dense: true, ..self }
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
        self,
        names: [&str; N],
        mut values: impl FnMut(&M, M::Scalar, &M::State) -> [M::Scalar; N] + 'a,
    ) -> Self {
        let names = names.map(ToString::to_string).to_vec();
        self.with(names, Box::new(move |system, t, y, row| row.extend(values(system, t, y))))
    }

    /// Adds the column `energy`: the energy function, which is constant if L does not depend on time and forces do no
    /// work.
    pub fn energy(self) -> Self
    where
        M: EnergyFunction,
    {
        self.observe(ENERGY, |system, t, y| {
            let (q, v) = split::<M>(y);
            system.energy(t, &q, &v)
        })
    }

    /// Adds a column for the momentum of each coordinate, such as `p_theta`.
    pub fn momenta(self) -> Self
    where
        M: CanonicalSystem,
    {
        let names = M::COORDINATES.iter().map(|name| format!("p_{name}")).collect();
        let extend = |system: &M, t, y: &M::State, row: &mut Vec<_>| {
            let (q, v) = split::<M>(y);
            row.extend_from_slice(system.momenta(t, &q, &v).as_ref());
        };
        self.with(names, Box::new(extend))
    }

    /// Adds a column for each acceleration, such as `theta_ddot` of a coordinate `theta`, and `w_dot` of a velocity that is called `w`.
    pub fn accelerations(self) -> Self {
        let extend = |system: &M, t, y: &M::State, row: &mut Vec<_>| {
            let (q, v) = split::<M>(y);
            row.extend_from_slice(system.acceleration(t, &q, &v).as_ref());
        };
        self.with(acceleration_names::<M>(), Box::new(extend))
    }

    pub(super) fn with(mut self, names: Vec<String>, extend: Extend<'a, M>) -> Self {
        if names.is_empty() {
            let empty =
                StepFailure::Setting("a list of columns to observe is empty: name at least one column");
            self.fault = self.fault.or(Some(empty));
        }
        self.observers.push(Observer { names, extend });
        self
    }

    /// Records each zero of a function of time and state that is passed in this direction, under this name in
    /// [`Trajectory::events`](super::Trajectory::events).
    ///
    /// Zeros are found as [`crate::event`] says: within a step, to 10⁻¹³ of it. Functions are given the system as it is then:
    /// with the contacts closed and the friction sticking that are so. Events that the declaration states are recorded without
    /// being asked for.
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

    /// Records each such zero and then goes on, stops, or goes on from another state, as after an impact.
    pub fn event_with(
        mut self,
        name: &str,
        direction: Direction,
        value: impl FnMut(&M, M::Scalar, &M::State) -> M::Scalar + 'a,
        react: impl FnMut(&M, &Event<M::Scalar, M::State>) -> Action<M::State> + 'a,
    ) -> Self {
        let (value, react) = (Box::new(value), Box::new(react));
        self.watchers.push(Watcher { name: name.to_string(), direction, value, react });
        self
    }

    /// Gives up with an error after this many steps, rejected ones included. The default method has a limit of its own, a
    /// hundred million; others have none.
    pub fn max_steps(self, limit: u64) -> Self {
        Simulation { max_steps: Some(limit), ..self }
    }

    /// Takes no step longer than this, so that nothing that lasts about a quarter of it is stepped over. By default steps of the
    /// adaptive method are no longer than a twentieth of the run, and a two-hundredth while the system is at rest. For methods
    /// whose steps have a length of their own it is an error.
    pub fn longest_step(self, longest: M::Scalar) -> Self {
        Simulation { longest_step: Some(longest), ..self }
    }

    /// Ends a step at each of these times and starts another one there, for a force that jumps or has a kink at times known
    /// beforehand. Times that are not between start and end do nothing; further ones may be added by asking again.
    ///
    /// No evaluation is made at such a time itself, so that it does not matter on which side of it a jump is defined to be.
    pub fn restart_at(mut self, times: impl IntoIterator<Item = M::Scalar>) -> Self {
        self.restarts.extend(times);
        self
    }

    /// Calls back about 200 times during the run, as for a progress bar.
    ///
    /// The callback returns nothing, or `ControlFlow::Break(())` to cancel the run, which then returns the trajectory
    /// so far. It is also called, ever more seldom, while a run takes many steps and gets nowhere.
    pub fn progress<V: Verdict>(self, callback: impl FnMut(Progress<M::Scalar>) -> V + 'a) -> Self {
        Simulation { reporter: Some(Reporter::new(callback)), ..self }
    }
}
