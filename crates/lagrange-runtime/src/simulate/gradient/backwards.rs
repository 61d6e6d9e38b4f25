//! The backward pass, from the end of a trace to its start.

use core::marker::PhantomData;
use std::vec::Vec;

use super::Gradient;
use super::jump::Jump;
use super::trace::{SmoothPiece, Steps};
use crate::integrate::ExplicitRungeKutta;
use crate::scalar::Number;
use crate::simulate::sensitivity::Varied;
use crate::system::{OdeSystem, ParametricSystem, ScalarOf, SettingError, StepFailure};

/// The name of the state in errors about events without derivative.
const STATE: &str = "the state";
/// Message for systems without derivatives.
const WITHOUT_JACOBIAN: &str = "a gradient needs derivatives: add `emit { jacobian }` to the declaration";

/// Workspace for the stages of a step by the method K, and the derivatives by parameters so far.
pub(super) struct Backwards<'a, M: OdeSystem, K, const N: usize> {
    system: &'a M,
    /// Parameters and inputs, their places, and slopes by them.
    variables: &'a [Varied<M::Scalar>],
    indices: Vec<usize>,
    by: Vec<M::Scalar>,
    points: Vec<[M::Scalar; N]>,
    rates: Vec<[M::Scalar; N]>,
    adjoints: Vec<[M::Scalar; N]>,
    /// Derivatives of the right-hand side by parameters and inputs.
    columns: Vec<[M::Scalar; N]>,
    method: PhantomData<K>,
}

impl<'a, M, K, const N: usize> Backwards<'a, M, K, N>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    K: ExplicitRungeKutta,
{
    pub(super) fn new(system: &'a M, variables: &'a [Varied<M::Scalar>]) -> Self {
        let (zero, stages) = ([M::Scalar::ZERO; N], K::STAGES.len());
        let indices: Vec<_> = variables.iter().filter_map(Varied::number).collect();
        Backwards {
            system,
            variables,
            by: std::vec![Number::ZERO; indices.len()],
            points: std::vec![zero; stages],
            rates: std::vec![zero; stages],
            adjoints: std::vec![zero; stages],
            columns: std::vec![zero; indices.len()],
            indices,
            method: PhantomData,
        }
    }

    /// Runs from the end of a trace to its start and sums the costs of samples.
    ///
    /// # Errors
    /// If a system does not know its derivatives, or an event has none.
    pub(super) fn along(
        mut self,
        trace: &'a [SmoothPiece<M>],
        mut cost: impl FnMut(M::Scalar, &M::State, &mut M::State) -> M::Scalar,
    ) -> Result<Gradient<M::Scalar, N>, StepFailure<M::Scalar>> {
        let (mut value, mut slope) = (M::Scalar::ZERO, [M::Scalar::ZERO; N]);
        let mut add = |t: M::Scalar, y: &M::State, slope: &mut M::State| {
            let mut own = [M::Scalar::ZERO; N];
            value = value + cost(t, y, &mut own);
            *slope = core::array::from_fn(|entry| slope[entry] + own[entry]);
        };
        let (mut steps, mut kept_states, mut most_between) = (0, 0, 0);
        for piece in trace.iter().rev() {
            self.system = &piece.system;
            most_between = most_between.max(self.through_piece(&piece.steps, &mut slope, &mut add)?);
            for jump in piece.jumps.iter().rev() {
                self.through_jump(jump, &mut slope)?;
            }
            steps += piece.steps.count();
            kept_states += piece.steps.states.len() + piece.jumps.len();
        }
        let by = self.by;
        Ok(Gradient { value, by, by_start: slope, steps, kept_states: kept_states + most_between })
    }

    /// Goes from the end of a piece to its start, and returns the largest number of states that
    /// were computed again at once.
    fn through_piece(
        &mut self,
        piece: &Steps<M::Scalar, M::State>,
        slope: &mut M::State,
        mut add: impl FnMut(M::Scalar, &M::State, &mut M::State),
    ) -> Result<usize, StepFailure<M::Scalar>> {
        let mut samples = piece.samples.iter().rev().peekable();
        let mut add_samples = |step: usize, y: &M::State, slope: &mut M::State| {
            while samples.next_if(|sample| **sample == step).is_some() {
                add(piece.times[step], y, slope);
            }
        };
        let mut most = 0;
        for (segment, start) in piece.states.iter().enumerate().rev() {
            let first = segment * piece.stride;
            let last = piece.count().min(first + piece.stride);
            let states = self.between(&piece.times, first..last, start);
            most = most.max(states.len());
            if last == piece.count() {
                add_samples(last, &states[last - first], slope);
            }
            for step in (first..last).rev() {
                let y = &states[step - first];
                self.pull_back(&piece.times[step..], y, slope)?;
                add_samples(step, y, slope);
            }
        }
        Ok(most)
    }

    /// Turns the slope by the state after a jump into that by the state before it.
    fn through_jump(&mut self, jump: &Jump<M>, slope: &mut M::State) -> Result<(), StepFailure<M::Scalar>> {
        let along = |derivative: &M::State, slope: &M::State| {
            derivative
                .iter()
                .zip(slope)
                .fold(M::Scalar::ZERO, |sum, (entry, weight)| weight.multiply_add(*entry, sum))
        };
        let after = *slope;
        for (variable, by) in self.variables.iter().zip(&mut self.by) {
            let derivative = jump.derivative(*variable, [M::Scalar::ZERO; N])?;
            *by = *by + along(&derivative, &after) / variable.scale();
        }
        for (entry, slope) in slope.iter_mut().enumerate() {
            let variable = Varied::initial(STATE, entry, &jump.system, &jump.state);
            let mut change = [M::Scalar::ZERO; N];
            change[entry] = variable.scale();
            *slope = along(&jump.derivative(variable, change)?, &after) / variable.scale();
        }
        Ok(())
    }

    /// Computes the states at the starts of these steps and at the end of the last one.
    fn between(
        &mut self,
        times: &[M::Scalar],
        steps: core::ops::Range<usize>,
        start: &M::State,
    ) -> Vec<M::State> {
        let mut states = std::vec![*start];
        for step in steps {
            let [t, end] = [times[step], times[step + 1]];
            let y = states[states.len() - 1];
            self.evaluate(t, end - t, &y);
            states.push(K::ADVANCE.point(&y, end - t, &self.rates));
        }
        states
    }

    /// Evaluates the stages of a step.
    fn evaluate(&mut self, t: M::Scalar, h: M::Scalar, y: &M::State) {
        for (stage, row) in K::STAGES.iter().enumerate() {
            self.points[stage] = row.point(y, h, &self.rates);
            self.rates[stage] = self.system.rhs(row.time(t, h), &self.points[stage]);
        }
    }

    /// Converts the derivative by the state at the end of a step into the derivative by the state
    /// at its start.
    fn pull_back(
        &mut self,
        times: &[M::Scalar],
        y: &M::State,
        slope: &mut M::State,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let (t, h) = (times[0], times[1] - times[0]);
        self.evaluate(t, h, y);
        self.adjoints.fill([M::Scalar::ZERO; N]);
        K::ADVANCE.spread(h, slope, &mut self.adjoints);
        for (stage, row) in K::STAGES.iter().enumerate().rev() {
            let (time, adjoint) = (row.time(t, h), self.adjoints[stage]);
            if adjoint.iter().all(|entry| *entry == Number::ZERO) {
                continue;
            }
            let back = self.through(time, stage, &adjoint)?;
            row.spread(h, &back, &mut self.adjoints);
            *slope = core::array::from_fn(|entry| slope[entry] + back[entry]);
        }
        Ok(())
    }

    /// Adds to the derivatives by parameters, and returns (∂f/∂y)ᵀ times the adjoint of a rate.
    fn through(
        &mut self,
        t: M::Scalar,
        stage: usize,
        adjoint: &M::State,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let point = &self.points[stage];
        let unknown = StepFailure::Setting(SettingError::Invalid(WITHOUT_JACOBIAN));
        let jacobian = self.system.jacobian(t, point).ok_or(unknown)?;
        let mut back = [M::Scalar::ZERO; N];
        for (row, weight) in jacobian.iter().zip(adjoint) {
            for (sum, entry) in back.iter_mut().zip(row) {
                *sum = weight.multiply_add(*entry, *sum);
            }
        }
        if self.indices.is_empty() {
            return Ok(back);
        }
        if !self.system.derivatives(t, point, &self.indices, &mut self.columns) {
            return Err(unknown);
        }
        for (by, column) in self.by.iter_mut().zip(&self.columns) {
            *by =
                column.iter().zip(adjoint).fold(*by, |sum, (entry, weight)| weight.multiply_add(*entry, sum));
        }
        Ok(back)
    }
}
