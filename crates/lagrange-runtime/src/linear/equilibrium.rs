//! Equilibria and steady motions by a damped Newton method.
//!
//! Unknowns are displacements δ of the positions, first-order states z and, on request, inputs u.
//! At given velocities, accelerations and rates of states must vanish, and constraints must hold:
//!
//! ```text
//! a(q, z, v, u) = 0,    ż(q, z, v, u) = 0,    c(q) = 0.
//! ```
//!
//! Multipliers are not among the unknowns, since the accelerations satisfy A a = 0 at rest with
//! them eliminated. There are then more equations than unknowns. They are consistent at a solution,
//! so that the least-squares steps of Gauss and Newton converge quadratically. If a coordinate is
//! ignorable, like the position of a cart on a level track, there are fewer independent equations.
//! The shortest step then leads to a nearby equilibrium. Rows are scaled by their derivatives, and
//! unknowns by their magnitude or one. Sources: Nocedal, Wright, *Numerical Optimization*, 2nd ed.,
//! §10.3, §11.2; Deuflhard, *Newton Methods for Nonlinear Problems*, §4.
//!
//! Example: a pendulum with g = l = 1, θ̈ = −sin θ. From θ = 1 a step leads to 1 − tan 1 = −0.557,
//! then to 0.0659, −9.6·10⁻⁵ and 2.9·10⁻¹³, each with a smaller residual.

mod equations;

use std::borrow::ToOwned;
use std::boxed::Box;
use std::string::{String, ToString};
use std::vec::Vec;

use self::equations::{FLAT, LocalEquations};
use super::error::{EquilibriumCause, EquilibriumError, Undetermined};
use super::names::Names;
use super::tangent::Blocks;
use crate::linalg::dense::DenseMatrix;
use crate::linalg::singular_values::{SingularValues, dot, length};
use crate::scalar::{Number, Scalar};
use crate::system::{
    ControlledSystem, LinearisedSystem, OdeSystem, StateVector, displaced, join, normalised, split,
};

/// Maximum number of steps of a search.
const MAX_STEPS: u32 = 100;
/// Maximum number of halvings of a step.
const MAX_HALVINGS: u32 = 20;
/// A search for an equilibrium near a state.
#[must_use = "a search does nothing before `solve`"]
pub struct EquilibriumSearch<'a, M: LinearisedSystem> {
    system: &'a M,
    names: Names,
    time: M::Scalar,
    start: EquilibriumGuess<M>,
    held: Vec<String>,
    trimmed: Vec<String>,
    /// Returns the system with other inputs, if some are unknowns.
    with_inputs: Option<WithInputs<M>>,
}

/// A function that returns a system with other inputs.
type WithInputs<M> = fn(&M, &[<M as OdeSystem>::Scalar]) -> M;

/// An equilibrium or a steady motion.
#[derive(Clone, Debug)]
pub struct Equilibrium<M: LinearisedSystem> {
    /// The state, with the velocities of the start of the search.
    pub state: M::State,
    /// The inputs in the order of their declaration; empty if none were trimmed.
    pub inputs: Vec<M::Scalar>,
    /// Number of steps taken.
    pub iterations: u32,
    /// Number of independent directions in which equilibria adjoin this one: 0 if it is isolated.
    pub freedom: usize,
}

impl<M: LinearisedSystem + ControlledSystem> Equilibrium<M> {
    /// Returns the system with the inputs found, or with its own if none were trimmed.
    #[must_use]
    pub fn system(&self, of: &M) -> M {
        match self.inputs.is_empty() {
            true => of.with_inputs(of.inputs()),
            false => with_inputs(of, &self.inputs),
        }
    }
}

fn with_inputs<M: ControlledSystem>(system: &M, values: &[M::Scalar]) -> M {
    system.with_inputs(M::InputVector::of(values).into())
}

/// The state and the inputs tried by a search.
struct EquilibriumGuess<M: LinearisedSystem> {
    y: M::State,
    inputs: Vec<M::Scalar>,
}

impl<'a, M> EquilibriumSearch<'a, M>
where
    M: LinearisedSystem,
    M::Scalar: Into<f64>,
{
    pub(super) fn near(system: &'a M, near: M::State) -> Self {
        EquilibriumSearch {
            system,
            names: Names::of(system),
            time: M::Scalar::ZERO,
            start: EquilibriumGuess { y: near, inputs: Vec::new() },
            held: Vec::new(),
            trimmed: Vec::new(),
            with_inputs: None,
        }
    }

    /// Sets the time, which is 0 by default. It matters only if the equations contain it, and is
    /// constant during the search.
    pub fn at(self, time: M::Scalar) -> Self {
        EquilibriumSearch { time, ..self }
    }

    /// Holds coordinates and first-order states of these names at their values.
    pub fn hold(mut self, names: &[&str]) -> Self {
        self.held.extend(names.iter().map(|name| (*name).to_owned()));
        self
    }

    /// Makes inputs of these names unknowns, too, starting from their present values.
    pub fn trim(mut self, names: &[&str]) -> Self
    where
        M: ControlledSystem,
    {
        self.trimmed.extend(names.iter().map(|name| (*name).to_owned()));
        let inputs: M::InputVector = self.system.inputs().into();
        self.start.inputs = inputs.as_ref().to_vec();
        self.with_inputs = Some(with_inputs);
        self
    }

    /// Runs the search.
    ///
    /// # Errors
    /// If Newton's method finds no equilibrium, or a value at the result is not finite.
    pub fn solve(self) -> Result<Equilibrium<M>, EquilibriumError<M>> {
        let mut point = EquilibriumGuess {
            y: normalised::<M>(self.names.state, &self.start.y),
            inputs: self.start.inputs.clone(),
        };
        let mut iterations = 0;
        let found = self.iterate(&mut point, &mut iterations);
        let EquilibriumGuess { y: state, inputs } = point;
        match found {
            Ok(freedom) => Ok(Equilibrium { state, inputs, iterations, freedom }),
            Err(cause) => {
                Err(EquilibriumError { cause, state, inputs, iterations, names: Box::new(self.names) })
            }
        }
    }

    /// Moves the point to an equilibrium; returns the number of directions in which others adjoin
    /// it.
    fn iterate(
        &self,
        point: &mut EquilibriumGuess<M>,
        iterations: &mut u32,
    ) -> Result<usize, EquilibriumCause<M::Scalar>> {
        let unknowns = self.unknowns()?;
        self.check_start(point)?;
        let (mut here, mut is_near) = (self.linearised(point, &unknowns)?, false);
        loop {
            let target = here.weighted(&here.residuals);
            let was_near = is_near;
            is_near = target.iter().all(|entry| entry.abs() <= self.tolerance());
            let Some(values) = SingularValues::of(&here.jacobian) else {
                return Err(EquilibriumCause::Derivative(Undetermined::of(&self.names, (0, 0))));
            };
            let step = values.shortest(&target, self.rounding().sqrt());
            let next = self.shortened(point, &here, &unknowns, &step);
            let next = next.filter(|_| *iterations < MAX_STEPS);
            // Near a solution, steps continue as long as they help.
            match next {
                Some((next, is_better)) if !(is_near && was_near && !is_better) => *point = next,
                _ if is_near => {
                    self.check_end(point)?;
                    return Ok(unknowns.len() - values.rank(self.rounding().sqrt()));
                }
                _ => return Err(self.left(&here)),
            }
            *iterations += 1;
            here = self.linearised(point, &unknowns)?;
        }
    }

    /// Returns the columns of the system matrix for the unknowns.
    fn unknowns(&self) -> Result<Vec<usize>, EquilibriumCause<M::Scalar>> {
        let names = self.names.tangent();
        let positions = &names[..names.len() - self.names.freedoms()];
        let inputs = self.names.beyond.inputs.iter().map(ToString::to_string).collect::<Vec<_>>();
        for (wanted, known) in [(&self.held, positions), (&self.trimmed, &inputs)] {
            if let Some(name) = wanted.iter().find(|name| !known.contains(name)) {
                let (name, known) = (name.clone(), known.to_vec());
                return Err(EquilibriumCause::UnknownName { name, known });
            }
        }
        let free = (0..positions.len()).filter(|&index| !self.held.contains(&positions[index]));
        let trimmed = (0..inputs.len()).filter(|&index| self.trimmed.contains(&inputs[index]));
        Ok(free.chain(trimmed.map(|index| names.len() + index)).collect())
    }

    fn ask<R>(&self, point: &EquilibriumGuess<M>, ask: impl FnOnce(&M) -> R) -> R {
        match self.with_inputs {
            Some(with_inputs) => ask(&with_inputs(self.system, &point.inputs)),
            None => ask(self.system),
        }
    }

    fn check_start(&self, point: &EquilibriumGuess<M>) -> Result<(), EquilibriumCause<M::Scalar>> {
        self.check_ranges(point)?;
        let undefined = self.ask(point, |system| {
            let rates = system.rhs(self.time, &point.y);
            system.undefined(self.time, &point.y, &rates)
        });
        undefined.map_or(Ok(()), |undefined| {
            Err(EquilibriumCause::Undefined(undefined.with_names_of(self.names.state)))
        })
    }

    fn check_ranges(&self, point: &EquilibriumGuess<M>) -> Result<(), EquilibriumCause<M::Scalar>> {
        self.system.domain().check(point.y.as_ref()).map_err(EquilibriumCause::OutOfRange)
    }

    /// Returns the point beyond the step, or a part of it that brings the equations closer to zero;
    /// with true if it halves their distance.
    fn shortened(
        &self,
        point: &EquilibriumGuess<M>,
        here: &LocalEquations,
        unknowns: &[usize],
        step: &[f64],
    ) -> Option<(EquilibriumGuess<M>, bool)> {
        let before = length(&here.weighted(&here.residuals));
        // The decrease of |W r| predicted by the linear equations.
        let foreseen = here.jacobian.times(&DenseMatrix::from_fn(step.len(), 1, |i, _| step[i])).column(0);
        let slope = dot(&foreseen, &here.weighted(&here.residuals)) / before;
        let mut part = 1.0;
        for _ in 0..MAX_HALVINGS {
            let next = self.moved(point, here, unknowns, step, part);
            let after = length(&here.weighted(&self.residuals(&next)));
            if after <= before - 1e-4 * part * slope && after < before {
                return Some((next, 2.0 * after <= before));
            }
            part /= 2.0;
        }
        None
    }

    /// Returns the point minus this part of the step.
    fn moved(
        &self,
        point: &EquilibriumGuess<M>,
        here: &LocalEquations,
        unknowns: &[usize],
        step: &[f64],
        part: f64,
    ) -> EquilibriumGuess<M> {
        let (n, states) = (self.names.freedoms(), self.names.state.first_order_states);
        let (mut q, v) = split::<M>(&point.y);
        let (mut displacement, mut inputs) = (v.zeros(), point.inputs.clone());
        for ((&unknown, step), scale) in unknowns.iter().zip(step).zip(&here.scales) {
            let change = M::Scalar::from_f64(-part * step * scale);
            if unknown < n {
                displacement.as_mut()[unknown] = change;
            } else if unknown < n + states {
                let state = &mut q.as_mut()[self.names.first_state() + unknown - n];
                *state = *state + change;
            } else {
                let input = &mut inputs[unknown - 2 * n - states];
                *input = *input + change;
            }
        }
        let q = displaced(self.system, self.time, &q, [(M::Scalar::ONE, &displacement)]);
        EquilibriumGuess { y: join::<M>(&q, &v), inputs }
    }

    /// Returns the equation that is violated most.
    fn left(&self, here: &LocalEquations) -> EquilibriumCause<M::Scalar> {
        let weighted = here.weighted(&here.residuals);
        let worse =
            |best: usize, row: usize| if weighted[row].abs() > weighted[best].abs() { row } else { best };
        let row = (0..weighted.len()).fold(0, worse);
        EquilibriumCause::Left {
            equation: self.equation(row),
            residual: M::Scalar::from_f64(here.residuals[row]),
            is_changed: here.jacobian.row(row).iter().any(|slope| *slope != 0.0),
        }
    }

    /// Checks that velocities satisfy the constraints, and that with them nothing changes.
    fn check_end(&self, point: &mut EquilibriumGuess<M>) -> Result<(), EquilibriumCause<M::Scalar>> {
        let mut y = point.y;
        self.ask(point, |system| system.admit(self.time, &mut y)).map_err(EquilibriumCause::NotAdmitted)?;
        point.y = y;
        self.check_ranges(point)?;
        let (_, v) = split::<M>(&point.y);
        if v.as_ref().iter().all(|v| *v == M::Scalar::ZERO) {
            return Ok(());
        }
        let blocks = self.ask(point, |system| Blocks::of(system, self.time, &point.y));
        let (first, n) = (blocks.velocities(), blocks.freedoms);
        let rows = (first..first + n).chain(n..first).collect::<Vec<_>>();
        let slopes = blocks.matrix.part(&rows, &(0..n).collect::<Vec<_>>());
        let speeds = v.as_ref().iter().fold(0.0, |sum, v| sum + v.abs().into());
        for index in 0..rows.len() {
            let row = slopes.row(index);
            let rate = row.iter().zip(v.as_ref()).fold(0.0, |sum, (slope, &v)| sum + slope * v.into());
            let size = row.iter().fold(FLAT * slopes.largest(), |most, slope| most.max(slope.abs()));
            if rate.abs() > self.rounding().sqrt() * size * speeds {
                return Err(EquilibriumCause::Unsteady { equation: self.equation(index), rate });
            }
        }
        Ok(())
    }

    fn rounding(&self) -> f64 {
        M::Scalar::epsilon().into()
    }

    /// Returns the distance, relative to the scales of the unknowns, at which rounding may end the
    /// search.
    fn tolerance(&self) -> f64 {
        self.rounding().powf(2.0 / 3.0)
    }
}
