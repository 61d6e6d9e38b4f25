//! The equations of states with derivatives, their events and their lanes.

use super::lanes::{OfClosed, fit};
use super::stacked::Stacked;
use super::system::Sensitive;
use crate::scalar::Number;
use crate::simulate::closed_loop::ClosedLoop;
use crate::system::{
    Action, Component, DeclaredEvent, Domain, EventSource, LanesVisitor, MAX_LOCATED, OdeSystem,
    ParametricSystem, Reacted, Response, ScalarOf, StateMatrix, StateVector, StepFailure, Undefined,
    values_of_events,
};

impl<M, L, const N: usize, const R: usize> OdeSystem for Sensitive<M, L, N, R>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    L: ClosedLoop<M> + OdeSystem<Scalar = ScalarOf<M>, State = [ScalarOf<M>; N]>,
{
    type Scalar = M::Scalar;
    type State = Stacked<M::Scalar, N, R>;

    fn rhs(&self, t: M::Scalar, y: &Self::State) -> Self::State {
        let state = &y.rows[0];
        let mut rates = Stacked::new(self.closed.rhs(t, state), self.variables.len());
        if !self.linear_rates(t, y, &mut rates) {
            let pairs = self.variables.iter().zip(y.derivatives()).zip(&mut rates.rows[1..]);
            for ((variable, change), rate) in pairs {
                let found = self.along((t, state), (Number::ZERO, change), Some(variable), |closed, t, y| {
                    Some(closed.rhs(t, y))
                });
                *rate = found.unwrap_or([M::Scalar::NAN; N]);
            }
        }
        rates
    }

    fn domain(&self) -> &'static Domain {
        self.closed.domain()
    }

    fn undefined(&self, t: M::Scalar, y: &Self::State, rates: &Self::State) -> Option<Undefined<M::Scalar>> {
        let own = || Undefined::of_state(t, y.as_ref(), rates.as_ref(), Component::Index);
        self.closed.undefined(t, &y.rows[0], &rates.rows[0]).or_else(own)
    }

    /// Returns a block ∂f/∂y for the state and for each derivative. The change of ∂f/∂y with the
    /// state is omitted: Newton's method finds the state first and then the rest.
    fn jacobian(&self, t: M::Scalar, y: &Self::State) -> Option<StateMatrix<Self>> {
        let block = self.closed.jacobian(t, &y.rows[0])?;
        let mut jacobian = y.zero_square();
        for (row, whole) in jacobian.as_mut().iter_mut().enumerate() {
            whole.rows[row / N] = block[row % N];
        }
        Some(jacobian)
    }

    fn next_restart(&self, t: M::Scalar, end: M::Scalar) -> Option<M::Scalar> {
        self.closed.next_restart(t, end)
    }

    fn beyond(&self, t: M::Scalar, end: M::Scalar) -> Option<Self> {
        self.closed.beyond(t, end).map(|closed| self.around(closed))
    }

    fn tick(&self, t: M::Scalar, y: &Self::State) -> Option<Self::State> {
        let state = &y.rows[0];
        let mut after = Stacked::new(self.closed.tick(t, state)?, self.variables.len());
        let pairs = self.variables.iter().zip(y.derivatives()).zip(&mut after.rows[1..]);
        for ((variable, change), changed) in pairs {
            let found = self.along((t, state), (Number::ZERO, change), Some(variable), L::tick);
            *changed = found.unwrap_or([M::Scalar::NAN; N]);
        }
        Some(after)
    }

    fn is_tick(&self, t: M::Scalar) -> bool {
        self.closed.is_tick(t)
    }

    fn shortest_period(&self) -> Option<M::Scalar> {
        self.closed.shortest_period()
    }

    /// Derivatives of the past are not kept.
    fn has_delays(&self) -> bool {
        L::HAS_HISTORY || self.closed.has_delays()
    }

    const IS_CONSTRAINED: bool = L::IS_CONSTRAINED;

    fn is_constrained(&self) -> bool {
        self.closed.is_constrained()
    }

    fn correct(&self, t: M::Scalar, y: &mut Self::State) -> Result<(), StepFailure<M::Scalar>> {
        self.closed.correct(t, &mut y.rows[0])
    }

    fn admit(&self, t: M::Scalar, y: &mut Self::State) -> Result<(), StepFailure<M::Scalar>> {
        self.closed.admit(t, &mut y.rows[0])
    }

    fn restore(&self, t: M::Scalar, y: &mut Self::State) -> Result<(), StepFailure<M::Scalar>> {
        self.closed.restore(t, &mut y.rows[0])
    }

    const EVENTS: &'static [DeclaredEvent] = L::EVENTS;
    const MAX_EVENTS: usize = L::MAX_EVENTS;

    fn events(&self) -> &'static [DeclaredEvent] {
        self.closed.events()
    }

    fn event_values(&self, t: M::Scalar, y: &Self::State, values: &mut [M::Scalar]) {
        self.closed.event_values(t, &y.rows[0], values);
    }

    fn react(&self, event: usize, t: M::Scalar, elapsed: M::Scalar, y: &Self::State) -> Reacted<Self> {
        let Response { action, system, kind } = self.closed.react(event, t, elapsed, &y.rows[0])?;
        if !matches!(action, Action::Stop) && self.closed.events()[event].is_of_mode() {
            self.check_company(event, (t, elapsed), y)?;
        }
        let mut after = match action {
            Action::Stop => return Ok(Response { action: Action::Stop, system: None, kind }),
            Action::Continue if system.is_none() => {
                return Ok(Response { action: Action::Continue, system: None, kind });
            }
            Action::Continue => y.rows[0],
            Action::Replace(state) => state,
        };
        let system = match system {
            Some(system) => Some(system),
            None => self.closed.begin(t, &after)?,
        };
        let next = system.as_ref().unwrap_or(&self.closed);
        next.restore(t, &mut after)?;
        let value =
            |closed: &L, t: M::Scalar, y: &M::State| values_of_events::<_, MAX_LOCATED>(closed, t, y)[event];
        let is_side = self.events()[event].is_side;
        let outcome = |closed: &L, t: M::Scalar, y: &M::State| match is_side {
            true => Some(*y),
            false => Self::settled(closed, event, (t, elapsed), y).ok(),
        };
        let source = EventSource::Declared(self.events()[event].name);
        let after = self.after((t, y), source, value, outcome, (next, after))?;
        let system = system.map(|closed| self.around(closed));
        Ok(Response { action: Action::Replace(after), system, kind })
    }

    fn begin(&self, t: M::Scalar, y: &Self::State) -> Result<Option<Self>, StepFailure<M::Scalar>> {
        Ok(self.closed.begin(t, &y.rows[0])?.map(|closed| self.around(closed)))
    }

    fn on_sides(&self, t: M::Scalar, y: &Self::State) -> Option<Self> {
        self.closed.on_sides(t, &y.rows[0]).map(|closed| self.around(closed))
    }

    fn freed(&self) -> Option<Self> {
        self.closed.freed().map(|closed| self.around(closed))
    }

    fn with_lanes<V: LanesVisitor<Self>>(visitor: V) -> Result<V::Output, V> {
        if const { !fit::<N, R>(M::NUMBERS.len()) } {
            return Err(visitor);
        }
        match L::with_lanes(OfClosed::new(visitor)) {
            Ok(result) => result,
            Err(refused) => Err(refused.into_visitor()),
        }
    }
}
