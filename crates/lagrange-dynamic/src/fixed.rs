//! Interpreted systems whose states are arrays, as required by motions with derivatives.

use lagrange_runtime::event::{Action, DeclaredEvent, Response};
use lagrange_runtime::system::{
    Description, Domain, MechanicalSystem, OdeSystem, ParametricSystem, Reacted, StepFailure, Undefined,
    Unnamed, WhiteNoise,
};

use crate::inline::Inline;
use crate::system::DynamicSystem;

type Outcome<T> = Result<T, StepFailure<f64>>;

/// An interpreted system with an array as state. Entries after the system's own are always zero.
#[derive(Clone, Debug)]
pub(crate) struct FixedSystem<const N: usize>(pub(crate) DynamicSystem<N>);

impl<const N: usize> FixedSystem<N> {
    /// Returns the system's own entries.
    pub(crate) fn own(&self, y: &[f64; N]) -> Inline<N> {
        let layout = &self.0.programs().layout;
        self.0.state(&y[..layout.positions + layout.velocities])
    }

    /// Applies a change to a state if it succeeds.
    fn change(
        y: &mut [f64; N],
        own: Inline<N>,
        by: impl FnOnce(&mut Inline<N>) -> Outcome<()>,
    ) -> Outcome<()> {
        let mut changed = own;
        by(&mut changed)?;
        *y = filled(&changed);
        Ok(())
    }
}

/// Returns entries, followed by zeros.
pub(crate) fn filled<const N: usize>(entries: &Inline<N>) -> [f64; N] {
    let mut state = [0.0; N];
    let entries = entries.as_ref();
    state[..entries.len()].copy_from_slice(entries);
    state
}

impl<const N: usize> OdeSystem for FixedSystem<N> {
    type Scalar = f64;
    type State = [f64; N];

    fn rhs(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        filled(&self.0.rhs(t, &self.own(y)))
    }

    fn undefined(&self, t: f64, y: &[f64; N], rates: &[f64; N]) -> Option<Undefined<f64>> {
        self.0.undefined(t, &self.own(y), &self.own(rates))
    }

    fn domain(&self) -> &'static Domain {
        self.0.domain()
    }

    fn has_delays(&self) -> bool {
        self.0.has_delays()
    }

    fn noise(&self) -> WhiteNoise {
        self.0.noise()
    }

    fn diffuse(&self, t: f64, y: &[f64; N], increments: &[f64]) -> [f64; N] {
        filled(&self.0.diffuse(t, &self.own(y), increments))
    }

    fn next_restart(&self, t: f64, end: f64) -> Option<f64> {
        self.0.next_restart(t, end)
    }

    fn beyond(&self, t: f64, end: f64) -> Option<Self> {
        self.0.beyond(t, end).map(FixedSystem)
    }

    fn tick(&self, t: f64, y: &[f64; N]) -> Option<[f64; N]> {
        self.0.tick(t, &self.own(y)).as_ref().map(filled)
    }

    fn is_tick(&self, t: f64) -> bool {
        self.0.is_tick(t)
    }

    fn shortest_period(&self) -> Option<f64> {
        self.0.shortest_period()
    }

    fn is_constrained(&self) -> bool {
        self.0.is_constrained()
    }

    fn correct(&self, t: f64, y: &mut [f64; N]) -> Outcome<()> {
        let own = self.own(y);
        Self::change(y, own, |own| self.0.correct(t, own))
    }

    fn admit(&self, t: f64, y: &mut [f64; N]) -> Outcome<()> {
        let own = self.own(y);
        Self::change(y, own, |own| self.0.admit(t, own))
    }

    fn restore(&self, t: f64, y: &mut [f64; N]) -> Outcome<()> {
        let own = self.own(y);
        Self::change(y, own, |own| self.0.restore(t, own))
    }

    const MAX_EVENTS: usize = DynamicSystem::<N>::MAX_EVENTS;

    fn events(&self) -> &'static [DeclaredEvent] {
        self.0.events()
    }

    fn event_values(&self, t: f64, y: &[f64; N], values: &mut [f64]) {
        self.0.event_values(t, &self.own(y), values);
    }

    fn react(&self, event: usize, t: f64, elapsed: f64, y: &[f64; N]) -> Reacted<Self> {
        let Response { action, system, kind } = self.0.react(event, t, elapsed, &self.own(y))?;
        let action = match action {
            Action::Continue => Action::Continue,
            Action::Stop => Action::Stop,
            Action::Replace(state) => Action::Replace(filled(&state)),
        };
        Ok(Response { action, system: system.map(FixedSystem), kind })
    }

    fn begin(&self, t: f64, y: &[f64; N]) -> Outcome<Option<Self>> {
        Ok(self.0.begin(t, &self.own(y))?.map(FixedSystem))
    }

    fn on_sides(&self, t: f64, y: &[f64; N]) -> Option<Self> {
        self.0.on_sides(t, &self.own(y)).map(FixedSystem)
    }

    fn freed(&self) -> Option<Self> {
        self.0.freed().map(FixedSystem)
    }
}

/// Positions and velocities keep their lengths; only states are padded with zeros.
impl<const N: usize> MechanicalSystem for FixedSystem<N> {
    type Coordinates = Inline<N>;
    type Velocities = Inline<N>;
    type Columns<C> = Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &[];

    fn description(&self) -> &'static Description {
        self.0.names.filled(N)
    }

    fn acceleration(&self, t: f64, q: &Inline<N>, v: &Inline<N>) -> Inline<N> {
        self.0.acceleration(t, q, v)
    }

    fn position_rates(&self, t: f64, q: &Inline<N>, v: &Inline<N>) -> Inline<N> {
        self.0.position_rates(t, q, v)
    }

    fn displacement(&self, t: f64, from: &Inline<N>, to: &Inline<N>) -> Inline<N> {
        self.0.displacement(t, from, to)
    }

    fn parameter(&self, index: usize) -> Option<(&'static str, f64)> {
        self.0.parameter(index)
    }
}

impl<const N: usize> ParametricSystem for FixedSystem<N> {
    const NUMBERS: &'static [&'static str] = &[];

    fn numbers(&self) -> &'static [&'static str] {
        self.0.names.fields
    }

    fn number(&self, index: usize) -> Option<f64> {
        self.0.numeric.fields().get(index).copied()
    }

    fn with_number(&self, index: usize, value: f64) -> Self {
        let mut system = self.clone();
        system.0.numeric.set_field(index, value);
        system
    }
}
