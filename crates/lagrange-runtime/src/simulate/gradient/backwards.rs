//! The backward pass, from the end of a trace to its start.

use core::marker::PhantomData;
use std::vec::Vec;

use super::Gradient;
use super::trace::Trace;
use crate::integrate::ExplicitRungeKutta;
use crate::scalar::Number;
use crate::system::{OdeSystem, ParametricSystem, ScalarOf, SettingError, StepFailure};

/// Message for systems without derivatives.
const WITHOUT_JACOBIAN: &str = "a gradient needs derivatives: add `emit { jacobian }` to the declaration";

/// Workspace for the stages of a step by the method K, and the derivatives by parameters so far.
pub(super) struct Backwards<'a, M: OdeSystem, K, const N: usize> {
    system: &'a M,
    /// Indices of parameters and inputs.
    indices: &'a [usize],
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
    pub(super) fn new(system: &'a M, indices: &'a [usize]) -> Self {
        let (zero, stages) = ([M::Scalar::ZERO; N], K::STAGES.len());
        Backwards {
            system,
            indices,
            by: std::vec![Number::ZERO; indices.len()],
            points: std::vec![zero; stages],
            rates: std::vec![zero; stages],
            adjoints: std::vec![zero; stages],
            columns: std::vec![zero; indices.len()],
            method: PhantomData,
        }
    }

    /// Runs from the end of a trace to its start and sums the costs of samples.
    ///
    /// # Errors
    /// If the system does not provide its derivatives.
    pub(super) fn along(
        mut self,
        trace: &Trace<M::Scalar, M::State>,
        mut cost: impl FnMut(M::Scalar, &M::State, &mut M::State) -> M::Scalar,
    ) -> Result<Gradient<M::Scalar, N>, StepFailure<M::Scalar>> {
        let (mut value, mut slope) = (M::Scalar::ZERO, [M::Scalar::ZERO; N]);
        let mut samples = trace.samples.iter().rev().peekable();
        let mut add_sample = |step: usize, y: &M::State, slope: &mut M::State| {
            while samples.next_if(|sample| **sample == step).is_some() {
                let mut own = [M::Scalar::ZERO; N];
                value = value + cost(trace.times[step], y, &mut own);
                *slope = core::array::from_fn(|entry| slope[entry] + own[entry]);
            }
        };
        let mut kept_states = 0;
        for (segment, start) in trace.states.iter().enumerate().rev() {
            let first = segment * trace.stride;
            let last = trace.steps().min(first + trace.stride);
            let states = self.between(trace, first..last, start);
            kept_states = kept_states.max(states.len() + trace.states.len());
            if last == trace.steps() {
                add_sample(last, &states[last - first], &mut slope);
            }
            for step in (first..last).rev() {
                let y = &states[step - first];
                self.pull_back(&trace.times[step..], y, &mut slope)?;
                add_sample(step, y, &mut slope);
            }
        }
        Ok(Gradient { value, by: self.by, by_start: slope, steps: trace.steps(), kept_states })
    }

    /// Computes the states at the starts of these steps and at the end of the last one.
    fn between(
        &mut self,
        trace: &Trace<M::Scalar, M::State>,
        steps: core::ops::Range<usize>,
        start: &M::State,
    ) -> Vec<M::State> {
        let mut states = std::vec![*start];
        for step in steps {
            let [t, end] = [trace.times[step], trace.times[step + 1]];
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
        if !self.system.derivatives(t, point, self.indices, &mut self.columns) {
            return Err(unknown);
        }
        for (by, column) in self.by.iter_mut().zip(&self.columns) {
            *by =
                column.iter().zip(adjoint).fold(*by, |sum, (entry, weight)| weight.multiply_add(*entry, sum));
        }
        Ok(back)
    }
}
