//! The backward pass, from the end of a trace to its start.

use core::marker::PhantomData;
use std::sync::Arc;
use std::vec::Vec;

use super::Gradient;
use super::jump::Jump;
use super::trace::{SmoothPiece, Steps};
use crate::integrate::ExplicitRungeKutta;
use crate::scalar::{Number, Scalar};
use crate::simulate::sensitivity::{Sensitive, Varied, copy};
use crate::system::{OdeSystem, ParametricSystem, ScalarOf, StepFailure};

/// The name of the state in errors about events without derivative.
const STATE: &str = "the state";
/// Message for equations and projections that are undefined on both sides of a state.
const NOT_SMOOTH: &str =
    "the equations or the projection onto constraints have no derivative here, so that there is no gradient";

/// A function that brings a state of the system M onto its constraints.
type Projection<M> =
    fn(&M, ScalarOf<M>, &mut <M as OdeSystem>::State) -> Result<(), StepFailure<ScalarOf<M>>>;

/// Workspace for the stages of a step by the method K, and the derivatives with respect to
/// parameters so far.
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

    /// Runs from the end of a trace to the given start and sums the costs of samples.
    ///
    /// # Errors
    /// If an event, the equations or a projection have no derivative.
    pub(super) fn along(
        mut self,
        trace: &'a [SmoothPiece<M>],
        (t, start): (M::Scalar, &M::State),
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
        if self.system.is_constrained() {
            self.through_projection((t, start), &mut slope, M::restore)?;
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
            let states = self.between(&piece.times, first..last, start)?;
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

    /// Turns the slope by the state after a jump into that by the state before it. Reactions are
    /// differentiated along the constraints only, on which the state before it remains. Off a
    /// closed contact, an impact would have another outcome.
    fn through_jump(&mut self, jump: &Jump<M>, slope: &mut M::State) -> Result<(), StepFailure<M::Scalar>> {
        let sensitive = Sensitive::new(copy(&jump.system), Arc::default());
        self.through((&jump.system, &jump.state), slope, |variable, change| {
            let change = if jump.system.is_constrained() {
                projected(&sensitive, (jump.time, &jump.state), M::correct, variable, &change)?
            } else {
                change
            };
            jump.derivative(variable, change)
        })
    }

    /// Turns the slope by a projected state into that by the state before.
    fn through_projection(
        &mut self,
        (t, y): (M::Scalar, &M::State),
        slope: &mut M::State,
        project: Projection<M>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let mut products = std::vec![M::Scalar::ZERO; self.by.len()];
        if self.system.correct_adjoint(t, y, slope, &self.indices, &mut products) {
            for (by, product) in self.by.iter_mut().zip(products) {
                *by = *by + product;
            }
            return Ok(());
        }
        let sensitive = Sensitive::new(copy(self.system), Arc::default());
        self.through((self.system, y), slope, |variable, change| {
            projected(&sensitive, (t, y), project, variable, &change)
        })
    }

    /// Multiplies the slope by the transposed derivative of a function of a system and this state.
    /// `derivative` returns that with respect to a variable and to a change of the state, both per
    /// scale of the variable.
    fn through(
        &mut self,
        (system, state): (&M, &M::State),
        slope: &mut M::State,
        derivative: impl Fn(Varied<M::Scalar>, M::State) -> Result<M::State, StepFailure<M::Scalar>>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let after = *slope;
        for (variable, by) in self.variables.iter().zip(&mut self.by) {
            let derivative = derivative(*variable, [M::Scalar::ZERO; N])?;
            *by = *by + product(&derivative, &after) / variable.scale();
        }
        for (entry, slope) in slope.iter_mut().enumerate() {
            let variable = Varied::initial(STATE, entry, system, state);
            let mut change = [M::Scalar::ZERO; N];
            change[entry] = variable.scale();
            *slope = product(&derivative(variable, change)?, &after) / variable.scale();
        }
        Ok(())
    }

    /// Computes the states at the starts of these steps and at the end of the last one.
    fn between(
        &mut self,
        times: &[M::Scalar],
        steps: core::ops::Range<usize>,
        start: &M::State,
    ) -> Result<Vec<M::State>, StepFailure<M::Scalar>> {
        let mut states = std::vec![*start];
        for step in steps {
            let mut y = self.advance([times[step], times[step + 1]], &states[states.len() - 1]);
            if self.system.is_constrained() {
                self.system.correct(times[step + 1], &mut y)?;
            }
            states.push(y);
        }
        Ok(states)
    }

    /// Evaluates the stages of a step, and returns its end before the projection.
    fn advance(&mut self, [t, end]: [M::Scalar; 2], y: &M::State) -> M::State {
        let h = end - t;
        for (stage, row) in K::STAGES.iter().enumerate() {
            self.points[stage] = row.point(y, h, &self.rates);
            self.rates[stage] = self.system.rhs(row.time(t, h), &self.points[stage]);
        }
        K::ADVANCE.point(y, h, &self.rates)
    }

    /// Converts the derivative with respect to the state at the end of a step into the derivative
    /// with respect to the state at its start.
    fn pull_back(
        &mut self,
        times: &[M::Scalar],
        y: &M::State,
        slope: &mut M::State,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let (t, h) = (times[0], times[1] - times[0]);
        let end = self.advance([t, times[1]], y);
        if self.system.is_constrained() {
            self.through_projection((times[1], &end), slope, M::correct)?;
        }
        self.adjoints.fill([M::Scalar::ZERO; N]);
        K::ADVANCE.spread(h, slope, &mut self.adjoints);
        for (stage, row) in K::STAGES.iter().enumerate().rev() {
            let (time, adjoint) = (row.time(t, h), self.adjoints[stage]);
            if adjoint.iter().all(|entry| *entry == Number::ZERO) {
                continue;
            }
            let back = self.through_rates(time, stage, &adjoint)?;
            row.spread(h, &back, &mut self.adjoints);
            *slope = core::array::from_fn(|entry| slope[entry] + back[entry]);
        }
        Ok(())
    }

    /// Adds to the derivatives with respect to parameters, and returns (∂f/∂y)ᵀ times the adjoint
    /// of a rate.
    fn through_rates(
        &mut self,
        t: M::Scalar,
        stage: usize,
        adjoint: &M::State,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        if let Some(back) = self.through_jacobians(t, stage, adjoint) {
            return Ok(back);
        }
        let sensitive = Sensitive::<M, M, N, 2>::new(copy(self.system), Arc::default());
        let (point, mut back) = (self.points[stage], *adjoint);
        self.through((self.system, &point), &mut back, |variable, change| {
            let rates =
                sensitive.along((t, &point), (Number::ZERO, &change), Some(&variable), |system, t, y| {
                    Some(system.rhs(t, y)).filter(|rates| rates.iter().all(|rate| rate.is_finite()))
                });
            rates.ok_or(StepFailure::Stuck(NOT_SMOOTH))
        })?;
        Ok(back)
    }

    /// Does the same with emitted derivatives; `None` if there are none.
    fn through_jacobians(&mut self, t: M::Scalar, stage: usize, adjoint: &M::State) -> Option<M::State> {
        let point = &self.points[stage];
        let jacobian = self.system.jacobian(t, point)?;
        if !self.indices.is_empty() && !self.system.derivatives(t, point, &self.indices, &mut self.columns) {
            return None;
        }
        for (by, column) in self.by.iter_mut().zip(&self.columns) {
            *by = *by + product(column, adjoint);
        }
        let mut back = [M::Scalar::ZERO; N];
        for (row, weight) in jacobian.iter().zip(adjoint) {
            for (sum, entry) in back.iter_mut().zip(row) {
                *sum = weight.multiply_add(*entry, *sum);
            }
        }
        Some(back)
    }
}

/// Returns the derivative of a projected state per scale of a variable, if the state before changes
/// along. Projections within a motion refuse states that are far away; those from afar then serve.
fn projected<M, const N: usize>(
    sensitive: &Sensitive<M, M, N, 2>,
    at: (M::Scalar, &M::State),
    project: Projection<M>,
    variable: Varied<M::Scalar>,
    change: &M::State,
) -> Result<M::State, StepFailure<M::Scalar>>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
{
    // Differences of corrections, which vanish exactly where nothing is corrected.
    let along = |project: Projection<M>| {
        sensitive.along(at, (Number::ZERO, change), Some(&variable), |system, t, y| {
            let mut projected = *y;
            project(system, t, &mut projected).ok()?;
            Some(core::array::from_fn(|entry| projected[entry] - y[entry]))
        })
    };
    let correction: Option<M::State> = along(project).or_else(|| along(M::restore));
    let correction = correction.ok_or(StepFailure::Stuck(NOT_SMOOTH))?;
    Ok(core::array::from_fn(|entry| change[entry] + correction[entry]))
}

/// Returns the scalar product.
fn product<S: Number, const N: usize>(a: &[S; N], b: &[S; N]) -> S {
    a.iter().zip(b).fold(S::ZERO, |sum, (a, b)| b.multiply_add(*a, sum))
}
