//! Systems with the derivatives of the state as additional unknowns.
//!
//! Along a motion ẏ = f(t, y, p), the derivatives s = ∂y/∂p at fixed times obey the variational
//! equations ṡ = ∂f/∂y s + ∂f/∂p. At an event g(t, y, p) = 0 the motion continues from R(t, y, p),
//! with the rates f⁺ in place of f⁻. The event moves by τ = −(∂g/∂y s + ∂g/∂p)/(dg/dt), with
//! dg/dt = ∂g/∂t + ∂g/∂y f⁻, and
//!
//! ```text
//! s⁺ = ∂R/∂y (s + f⁻ τ) + ∂R/∂t τ + ∂R/∂p − f⁺ τ.
//! ```
//!
//! Sources: Hiskens, Pai, "Trajectory sensitivity analysis of hybrid systems", *IEEE Transactions
//! on Circuits and Systems I* 47 (2000) 204–220; Leine, Nijmeijer, *Dynamics and Bifurcations of
//! Non-Smooth Mechanical Systems*, 2004, §7.

use std::sync::Arc;

use super::company::Company;
use super::stacked::{Stacked, variational_rates};
use super::variable::{Varied, VariedPlace};
use crate::differences::slope;
use crate::scalar::{Number, Scalar};
use crate::simulate::closed_loop::ClosedLoop;
use crate::system::{
    Action, EventSource, MAX_LOCATED, OdeSystem, ParametricSystem, Response, ScalarOf, StepFailure,
    values_of_events,
};

/// A state that changes by more than this factor times a variable, both relatively, is moved
/// without it. A common step, which suits the state, would be lost in the rounding of the variable.
const FAR: f64 = 100.0;

/// A loop L around the plant M, with a state of N entries and their derivatives, R rows in all.
pub struct Sensitive<M: ParametricSystem, L, const N: usize, const R: usize> {
    pub(super) closed: L,
    pub(super) variables: Arc<[Varied<M::Scalar>]>,
}

impl<M, L, const N: usize, const R: usize> Sensitive<M, L, N, R>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    L: ClosedLoop<M> + OdeSystem<Scalar = ScalarOf<M>, State = [ScalarOf<M>; N]>,
{
    /// Returns the loop with derivatives with respect to these variables.
    pub(in crate::simulate) fn new(closed: L, variables: Arc<[Varied<M::Scalar>]>) -> Self {
        Sensitive { closed, variables }
    }

    /// Returns this around a loop in other modes.
    pub(super) fn around(&self, closed: L) -> Self {
        Sensitive { closed, variables: Arc::clone(&self.variables) }
    }

    /// Evaluates a function of the loop with a variable changed by this multiple of its scale.
    pub(super) fn moved<T>(
        &self,
        variable: &Varied<M::Scalar>,
        by: M::Scalar,
        ask: impl FnOnce(&L) -> T,
    ) -> T {
        match variable.place {
            VariedPlace::Initial(_) => ask(&self.closed),
            VariedPlace::Number(index) => {
                let plant = self.closed.plant();
                let value = plant.number(index).unwrap_or(Number::ZERO) + by * variable.scale;
                ask(&self.closed.with_plant(plant.with_number(index, value)))
            }
        }
    }

    /// Computes the derivative of a function of the loop, time and state along a change of the
    /// time, the state and a variable.
    pub(in crate::simulate) fn along<const C: usize>(
        &self,
        (t, y): (M::Scalar, &M::State),
        (dt, dy): (M::Scalar, &M::State),
        variable: Option<&Varied<M::Scalar>>,
        mut function: impl FnMut(&L, M::Scalar, &M::State) -> Option<[M::Scalar; C]>,
    ) -> Option<[M::Scalar; C]> {
        let part = relative(dy, y);
        let is_number = |variable: &&Varied<M::Scalar>| matches!(variable.place, VariedPlace::Number(_));
        let number = variable.filter(is_number);
        let weight = number.map_or(Number::ZERO, |variable| variable.weight);
        if weight > Number::ZERO && part > M::Scalar::from_f64(FAR) * weight {
            let state = self.moving((t, y), (dt, dy), (part, None), &mut function)?;
            let still = (Number::ZERO, &[Number::ZERO; N]);
            let number = self.moving((t, y), still, (weight, number), &mut function)?;
            return Some(core::array::from_fn(|entry| state[entry] + number[entry]));
        }
        let rate = part.max(weight);
        let rate = if rate == Number::ZERO { dt.abs() } else { rate };
        self.moving((t, y), (dt, dy), (rate, number), &mut function)
    }

    /// Does the same by differences for a function that changes at this rate.
    fn moving<const C: usize>(
        &self,
        (t, y): (M::Scalar, &M::State),
        (dt, dy): (M::Scalar, &M::State),
        (rate, number): (M::Scalar, Option<&Varied<M::Scalar>>),
        function: &mut impl FnMut(&L, M::Scalar, &M::State) -> Option<[M::Scalar; C]>,
    ) -> Option<[M::Scalar; C]> {
        slope(rate, |by| {
            let there = core::array::from_fn(|i| y[i] + by * dy[i]);
            let mut ask = |closed: &L| function(closed, t + by * dt, &there);
            match number {
                Some(number) => self.moved(number, by, ask),
                None => ask(&self.closed),
            }
        })
    }

    /// Computes the rates of derivatives from the Jacobians of the plant; false if it provides
    /// none.
    pub(super) fn linear_rates(
        &self,
        t: M::Scalar,
        y: &Stacked<M::Scalar, N, R>,
        rates: &mut Stacked<M::Scalar, N, R>,
    ) -> bool {
        let state = &y.rows[0];
        let Some(jacobian) = self.closed.jacobian(t, state).filter(|_| L::IS_PLANT) else { return false };
        let (mut indices, mut columns, mut count) = ([0; R], [[M::Scalar::ZERO; N]; R], 0);
        for variable in self.variables.iter() {
            if let VariedPlace::Number(index) = variable.place {
                indices[count] = index;
                count += 1;
            }
        }
        if count > 0 && !self.closed.plant().derivatives(t, state, &indices[..count], &mut columns[..count]) {
            return false;
        }
        let mut columns = columns.iter();
        for ((variable, changes), rates) in
            self.variables.iter().zip(y.derivatives()).zip(&mut rates.rows[1..])
        {
            let column = match variable.place {
                VariedPlace::Number(_) => columns.next(),
                VariedPlace::Initial(_) => None,
            };
            let direct = column.map(|column| (variable.scale, column.as_slice()));
            variational_rates(jacobian.as_ref(), changes, direct, rates);
        }
        true
    }

    /// Returns the state after an event. Arguments are the function that vanishes at the event, the
    /// outcome for a loop at a time and state, and the subsequent loop and state.
    pub(super) fn after(
        &self,
        (t, y): (M::Scalar, &Stacked<M::Scalar, N, R>),
        source: EventSource,
        mut value: impl FnMut(&L, M::Scalar, &M::State) -> M::Scalar,
        mut outcome: impl FnMut(&L, M::Scalar, &M::State) -> Option<M::State>,
        (next, after): (&L, M::State),
    ) -> Result<Stacked<M::Scalar, N, R>, StepFailure<M::Scalar>> {
        let state = &y.rows[0];
        let (rates, rates_after) = (self.closed.rhs(t, state), next.rhs(t, &after));
        let mut value = |closed: &L, t: M::Scalar, y: &M::State| Some([value(closed, t, y)]);
        let passing = self.along((t, state), (Number::ONE, &rates), None, &mut value);
        let mut stacked = Stacked::new(after, self.variables.len());
        let pairs = self.variables.iter().zip(y.derivatives()).zip(&mut stacked.rows[1..]);
        for ((variable, change), changed) in pairs {
            let shift = self.along((t, state), (Number::ZERO, change), Some(variable), &mut value);
            let shift = passing.zip(shift).map(|([passing], [shift])| -shift / passing);
            let moved = shift.filter(|shift| shift.is_finite()).and_then(|shift| {
                let change = core::array::from_fn(|i| rates[i].multiply_add(shift, change[i]));
                let outcome = self.along((t, state), (shift, &change), Some(variable), &mut outcome)?;
                Some(core::array::from_fn(|i| rates_after[i].multiply_add(-shift, outcome[i])))
            });
            *changed =
                moved.ok_or(StepFailure::NotDifferentiable { event: source, variable: variable.name })?;
        }
        Ok(stacked)
    }

    /// Checks that modes which change at the same time as an event do so for all values of the
    /// variables.
    ///
    /// # Errors
    /// If they do not.
    pub(super) fn check_company(
        &self,
        event: usize,
        (t, elapsed): (M::Scalar, M::Scalar),
        y: &Stacked<M::Scalar, N, R>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let state = &y.rows[0];
        let forwards = (Number::ONE, &self.closed.rhs(t, state));
        let values = |closed: &_, t, y: &_| Some(values_of_events::<_, MAX_LOCATED>(closed, t, y));
        let rates = self.along((t, state), forwards, None, values);
        let company = rates.and_then(|rates| Company::of(&self.closed, event, (t, elapsed, state), rates));
        let Some(company) = company else { return Ok(()) };
        let mut pairs = self.variables.iter().zip(y.derivatives());
        pairs.try_for_each(|(variable, change)| {
            let slopes = self.along((t, state), (Number::ZERO, change), Some(variable), values);
            company.check(slopes, elapsed * variable.part(change, state))
        })
    }

    /// Returns the state after a declared event, in the modes in which the motion continues.
    pub(super) fn settled(
        closed: &L,
        event: usize,
        (t, elapsed): (M::Scalar, M::Scalar),
        y: &M::State,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let Response { action, system, .. } = closed.react(event, t, elapsed, y)?;
        let mut state = if let Action::Replace(state) = action { state } else { *y };
        system.as_ref().unwrap_or(closed).restore(t, &mut state)?;
        Ok(state)
    }
}

/// Returns the largest relative change of an entry. Entries count as no smaller than one, or than
/// the largest if that is below one. An entry that does not change, such as a large pressure beside
/// a small angle, has no effect.
fn relative<S: Scalar>(change: &[S], state: &[S]) -> S {
    let size = state.iter().fold(S::ZERO, |most, entry| most.max(entry.abs()));
    let least = if size > S::ZERO { size.min(S::ONE) } else { S::ONE };
    let parts = change.iter().zip(state).map(|(change, entry)| change.abs() / entry.abs().max(least));
    parts.fold(S::ZERO, S::max)
}
