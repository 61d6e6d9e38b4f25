//! Settings of an ensemble's runs, the same as for a single run.

use std::boxed::Box;

use super::builder::Ensemble;
use super::plan::SharedSystem;
use crate::simulate::ENERGY;
use crate::simulate::Event;
use crate::simulate::columns_of;
use crate::simulate::energy;
use crate::simulate::held;
use crate::simulate::inputs;
use crate::simulate::run_setters;
use crate::system::{Action, ControlledSystem, Direction, EnergyFunction, OutputSystem};

impl<'a, M: SharedSystem, K, D, P> Ensemble<'a, M, K, D, P> {
    run_setters!(batch.plan);

    /// Adds a column: a value computed from time and state, at the end of each motion or for each
    /// sample. The function receives the system of the motion. Parameters are columns already if
    /// motions have [separate ones](super::Motions::parameters).
    pub fn observe(
        mut self,
        name: &str,
        value: impl Fn(&M, M::Scalar, &M::State) -> M::Scalar + Send + Sync + 'a,
    ) -> Self {
        self.batch.plan.observe([name], Box::new(move |system, t, y, row| row.push(value(system, t, y))));
        self
    }

    /// Adds the column `energy`, as [in a single run](crate::simulate::Simulation::energy).
    pub fn energy(mut self) -> Self
    where
        M: EnergyFunction,
    {
        self.batch.plan.observe([ENERGY], Box::new(columns_of(energy::<M>)));
        self
    }

    /// Adds a column for each component of each output, such as `height`, `tip.x` and `tip.y`.
    pub fn outputs(mut self) -> Self
    where
        M: OutputSystem,
    {
        self.batch.plan.observe(self.batch.system.output_names(), Box::new(columns_of(M::outputs)));
        self
    }

    /// Ends a motion at the first zero of a function of time and state that is crossed in this
    /// direction. The row of the motion then holds the time and state of the zero.
    pub fn stop_at(
        self,
        name: &str,
        direction: Direction,
        value: impl Fn(&M, M::Scalar, &M::State) -> M::Scalar + Send + Sync + 'a,
    ) -> Self {
        self.event_with(name, direction, value, |_, _| Action::Stop)
    }

    /// Records each zero of a function, crossed in this direction, in the trajectory of a motion.
    /// The motion then continues, stops, or continues from another state, as after an impact.
    pub fn event_with(
        mut self,
        name: &str,
        direction: Direction,
        value: impl Fn(&M, M::Scalar, &M::State) -> M::Scalar + Send + Sync + 'a,
        react: impl Fn(&M, &Event<M::Scalar, M::State>) -> Action<M::State> + Send + Sync + 'a,
    ) -> Self {
        self.batch.plan.watch(name, direction, (Box::new(value), Box::new(react)));
        self
    }

    /// Sets the inputs by a controller that is called at the start and then every `period`, as [in
    /// a single run](crate::simulate::Simulation::sampled). Every motion has a separate controller,
    /// made for its index.
    pub fn sampled<C>(mut self, period: M::Scalar, controller: impl Fn(usize) -> C + Send + Sync + 'a) -> Self
    where
        M: ControlledSystem,
        C: FnMut(&M, M::Scalar, M::NamedState) -> M::Inputs + 'a,
    {
        self.batch.plan.control(period, Box::new(move |index| held(controller(index))));
        self.batch.plan.record_inputs(self.batch.system, Box::new(columns_of(inputs::<M>)));
        self
    }
}
