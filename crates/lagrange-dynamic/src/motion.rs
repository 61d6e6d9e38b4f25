//! Interpreted systems as systems of differential equations, with events.

use lagrange_core::derive::DiffusionKind;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{Reaction, TickingClock};
use lagrange_runtime::event::{
    Action, DeclaredEvent, MAX_LOCATED, Response, beyond, change_side, choose_sides, earlier, free_sides,
    next_switch_time, next_tick, shortest_period, side_values, ticks,
};
use lagrange_runtime::integrate::undefined;
use lagrange_runtime::system::{
    Domain, NoiseKind, OdeSystem, Reacted, StateVector, StepFailure, Undefined, WhiteNoise,
};

use crate::inline::{Inline, Rows};
use crate::system::DynamicSystem;

/// Maximum number of velocities for which the mass matrix is tested for singularity, as in emitted
/// code.
const LARGEST_MASS_MATRIX: usize = 64;

impl<const CAPACITY: usize> DynamicSystem<CAPACITY> {
    /// Computes the mass matrix, if it determines the accelerations.
    fn mass_matrix(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Option<Rows<CAPACITY>> {
        let layout = &self.programs().layout;
        let determines = layout.multipliers == 0 && layout.velocities <= LARGEST_MASS_MATRIX;
        let program = self.programs().product(Product::MassMatrix).filter(|_| determines)?;
        let entries = self.numeric.evaluate(program, t, q.as_ref(), v.as_ref());
        Some(Rows::of(&entries, layout.velocities))
    }

    /// Computes the periods of the clocks.
    fn periods(&self) -> impl Iterator<Item = f64> {
        self.programs().clocks.iter().map(|clock| self.numeric.evaluate(&clock.period, 0.0, &[], &[])[0])
    }

    /// Computes the values of algebraic unknowns, by name.
    fn unknowns(&self, t: f64, y: &Inline<CAPACITY>) -> Vec<(&'static str, f64)> {
        let values = self.evaluate(&self.programs().unknown_values, t, y);
        self.names.unknowns.iter().copied().zip(values).collect()
    }

    /// Computes the distances of centres in compliant contacts, by name.
    fn distances(&self, t: f64, y: &Inline<CAPACITY>) -> Vec<(&'static str, f64)> {
        let values = self.evaluate(&self.programs().distances, t, y);
        self.names.round_contacts.iter().copied().zip(values).collect()
    }
}

impl<const CAPACITY: usize> OdeSystem for DynamicSystem<CAPACITY> {
    type Scalar = f64;
    type State = Inline<CAPACITY>;

    fn rhs(&self, t: f64, y: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let ((q, v), mut rates) = (y.parts(0), y.zeros());
        if !self.is_touching() {
            self.numeric.rates(t, q, v, rates.as_mut());
            return rates;
        }
        Inline::joined(&self.numeric.position_rates(t, q, v), &self.accelerations(t, q, v))
    }

    fn undefined(&self, t: f64, y: &Inline<CAPACITY>, rates: &Inline<CAPACITY>) -> Option<Undefined<f64>> {
        let parameters = self.programs().layout.parameters;
        let fields = self.names.fields.iter().copied().zip(self.numeric.fields().iter().copied());
        let inputs = fields.skip(parameters).collect::<Vec<_>>();
        let found = undefined(self, (t, y, rates), &inputs, |q, v| self.mass_matrix(t, q, v))?;
        Some(found.with_unknowns(t, &self.unknowns(t, y)).with_contacts(t, &self.distances(t, y)))
    }

    fn domain(&self) -> &'static Domain {
        &self.names.domain
    }

    fn has_delays(&self) -> bool {
        !self.programs().delayed_inputs.is_empty()
    }

    fn noise(&self) -> WhiteNoise {
        let kind = match self.programs().diffusion_kind {
            DiffusionKind::Additive => NoiseKind::Additive,
            DiffusionKind::Unambiguous => NoiseKind::Unambiguous,
            DiffusionKind::Multiplicative => NoiseKind::Multiplicative,
        };
        WhiteNoise { count: self.programs().noises.len(), kind }
    }

    fn diffuse(&self, t: f64, y: &Inline<CAPACITY>, increments: &[f64]) -> Inline<CAPACITY> {
        let (entries, mut change) = (self.evaluate(&self.programs().diffusion, t, y), y.zeros());
        for (column, increment) in entries.chunks(y.as_ref().len().max(1)).zip(increments) {
            let factors = change.as_mut().iter_mut().zip(column);
            factors.for_each(|(entry, factor)| *entry += factor * increment);
        }
        change
    }

    fn jacobian(&self, t: f64, y: &Inline<CAPACITY>) -> Option<Rows<CAPACITY>> {
        let program = self.programs().jacobian.as_ref()?;
        Some(Rows::of(&self.evaluate(program, t, y), y.as_ref().len()))
    }

    fn next_restart(&self, t: f64, end: f64) -> Option<f64> {
        earlier(next_switch_time(self, t, end), next_tick(t, end, self.periods()))
    }

    fn shortest_period(&self) -> Option<f64> {
        shortest_period(self.periods())
    }

    fn is_tick(&self, t: f64) -> bool {
        self.periods().any(|period| ticks(t, period))
    }

    fn tick(&self, t: f64, y0: &Inline<CAPACITY>) -> Option<Inline<CAPACITY>> {
        let due = self.periods().zip(&self.programs().clocks).filter(|(period, _)| ticks(t, *period));
        let after = |y: Option<Inline<CAPACITY>>, clock: &TickingClock| {
            Some(self.state(&self.evaluate(&clock.after, t, &y.unwrap_or(*y0))))
        };
        due.fold(None, |y, (_, clock)| after(y, clock))
    }

    fn beyond(&self, t: f64, end: f64) -> Option<Self> {
        beyond(self, t, end)
    }

    fn is_constrained(&self) -> bool {
        self.is_touching() || self.is_projected() || !self.names.description.quaternions.is_empty()
    }

    fn correct(&self, t: f64, y: &mut Inline<CAPACITY>) -> Result<(), StepFailure<f64>> {
        self.put_on_constraints(t, y)
    }

    fn admit(&self, t: f64, y: &mut Inline<CAPACITY>) -> Result<(), StepFailure<f64>> {
        self.admit_to_constraints(t, y)
    }

    fn restore(&self, t: f64, y: &mut Inline<CAPACITY>) -> Result<(), StepFailure<f64>> {
        self.restore_to_constraints(t, y)
    }

    const MAX_EVENTS: usize = MAX_LOCATED;

    fn events(&self) -> &'static [DeclaredEvent] {
        self.names.events
    }

    fn event_values(&self, t: f64, y: &Inline<CAPACITY>, values: &mut [f64]) {
        let found = self.evaluate(&self.programs().event_functions, t, y);
        values.iter_mut().zip(found).for_each(|(value, found)| *value = found);
        if self.is_touching() {
            self.touching_values(t, y, values);
        }
        if self.programs().layout.sides > 0 {
            side_values(self, t, y, values);
        }
    }

    fn react(&self, event: usize, t: f64, elapsed: f64, y: &Inline<CAPACITY>) -> Reacted<Self> {
        if self.is_of_touching(event) {
            return self.react_touching(event, t, elapsed, y);
        }
        match self.programs().reactions.get(event) {
            None => change_side(self, event, t, y),
            Some(Reaction::Stop) => Ok(Response::new(Action::Stop)),
            Some(Reaction::Replace(state)) => {
                Ok(Response::new(Action::Replace(self.state(&self.evaluate(state, t, y)))))
            }
            Some(Reaction::Record | Reaction::Impact) => Ok(Response::new(Action::Continue)),
        }
    }

    fn begin(&self, t: f64, y: &Inline<CAPACITY>) -> Result<Option<Self>, StepFailure<f64>> {
        self.check_parameters()?;
        let on_sides = self.on_sides(t, y);
        if !self.is_touching() {
            return Ok(on_sides);
        }
        Ok(on_sides.as_ref().unwrap_or(self).begin_touching(t, y)?.or(on_sides))
    }

    fn on_sides(&self, t: f64, y: &Inline<CAPACITY>) -> Option<Self> {
        if self.programs().layout.sides == 0 {
            return None;
        }
        choose_sides(self, t, y)
    }

    fn freed(&self) -> Option<Self> {
        (self.programs().layout.sides > 0).then(|| free_sides(self))
    }
}
