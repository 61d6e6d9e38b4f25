//! A variational integrator: the discrete Euler–Lagrange equations of a discrete Lagrangian.
//!
//! Between ends q₀ and q₁, coordinates follow the parabola for which the action, evaluated by
//! Simpson's rule, is stationary:
//!
//! ```text
//! L_d(q₀, q₁) = ext h/6 (L(q₀, v₀) + 4 L(qₘ, vₘ) + L(q₁, v₁))   over the middle qₘ,
//! p₀ = −∂L_d/∂q₀,    p₁ = ∂L_d/∂q₁.
//! ```
//!
//! Let P = ∂L/∂v and R = ∂L/∂q + Q at the three places. Forces enter by the discrete
//! Lagrange–d'Alembert principle with the same quadrature. The equations are then
//!
//! ```text
//! P₁ = P₀ + h Rₘ,    p₀ = (P₀ + 2 Pₘ)/3 − h/6 (R₀ + Rₘ),    p₁ = p₀ + h/6 (R₀ + 4 Rₘ + R₁),
//! ```
//!
//! which are solved for v₀ and v₁. The method is the Lobatto IIIA–IIIB pair with three stages. The
//! related method of degree one with the midpoint instead of Simpson's rule is the implicit
//! midpoint rule.
//!
//! Sources: Marsden, West, *Discrete mechanics and variational integrators*, Acta Numerica 10
//! (2001), §1.5, §2.2, §2.6 and §3.2; Hairer, Lubich, Wanner, *Geometric Numerical Integration*,
//! §VI.6.

mod constrained;
mod coupled;
mod linearised;

use crate::integrate::canonical::{CanonicalStep, Derivatives, Reached, factors, magnitude};
use crate::integrate::fixed::{Formula, Step, WithinStep, fixed_steps};
use crate::integrate::interpolation::cubic;
use crate::integrate::jacobian::Source;
use crate::integrate::method::{Method, Work};
use crate::integrate::newton::{self, Equations};
use crate::integrate::prediction::Prediction;
use crate::integrate::variational::constrained::{ConstrainedEquations, Solved};
use crate::integrate::variational::linearised::Linearised;
use crate::linalg::vector::add;
use crate::scalar::{Number, Scalar};
use crate::system::{CanonicalSystem, ScalarOf, StateVector, StepFailure, Vector, join, split};

/// A variational integrator of order four in equal steps, for any Lagrangian and any force.
///
/// It is derived from a discrete Lagrangian and therefore conserves the invariants of a Lagrangian
/// system. The step is symplectic in coordinates and momenta for any mass matrix. By the discrete
/// theorem of Noether, every momentum map of a symmetry that is linear in the coordinates is
/// conserved. Momenta of cyclic coordinates are conserved to rounding, since momenta are advanced
/// and not recomputed from velocities. The energy of a conservative system oscillates without
/// drift. The method is symmetric in time.
///
/// Constraints hold at the ends of all steps to rounding, for positions and velocities alike,
/// without projection: constraint forces are part of the principle. With holonomic constraints,
/// moving or not, the method is symplectic on the admissible states. Momenta are conserved if
/// constraints have the same symmetry. Nonholonomic constraints enter by the discrete
/// Lagrange–d'Alembert principle, also symmetric in time and of order four. The mass matrix may be
/// singular if constraints compensate for it, and equivalent constraints count as one. A step then
/// also iterates over multipliers, with about two additional iterations.
///
/// An iteration evaluates momenta and their rates three times. A step takes four to seven
/// iterations with the Jacobian that `emit { jacobian }` provides, and few more without it if the
/// step is short. On a double pendulum it costs as much as 23 to 30 evaluations of the right-hand
/// side. Steps must resolve vibrations, h ω < √8, also with a Jacobian. For stiff springs use
/// [`GaussLegendre`](crate::integrate::GaussLegendre).
///
/// States within a step are cubics through states and rates at its ends, with an error O(h⁴).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Variational<S> {
    /// Length of a step.
    pub step: S,
}

impl<M: CanonicalSystem + ?Sized> Method<M> for Variational<M::Scalar> {
    fixed_steps! { "variational 4", 4, Discrete<M> = Discrete::new() }
}

/// The formula of [`Variational`].
#[derive(Debug)]
pub struct Discrete<M: CanonicalSystem + ?Sized> {
    rounding: ScalarOf<M>,
    /// Predicts velocities at both ends of the next step from those at the start and in the middle
    /// of the last one.
    prediction: Prediction<ScalarOf<M>, Vector<M>, 2>,
    /// Differences between the velocities of the parabola and of the motion, for a step of length
    /// one.
    excess: [Vector<M>; 2],
    reached: Reached<M>,
    /// Velocities of the parabola of the step in progress, and its length.
    ends: ([Vector<M>; 2], ScalarOf<M>),
    /// Multipliers of constraints at the start and in the middle of the step in progress.
    multipliers: [Vector<M>; 2],
}

impl<M: CanonicalSystem + ?Sized> Discrete<M> {
    fn new() -> Self {
        let half = ScalarOf::<M>::from_f64(0.5);
        Discrete {
            rounding: Scalar::epsilon(),
            prediction: Prediction::new(
                [ScalarOf::<M>::ZERO, half],
                [ScalarOf::<M>::ZERO, ScalarOf::<M>::ONE],
            ),
            excess: [Vector::<M>::ZERO; 2],
            reached: Reached::NOTHING,
            ends: ([Vector::<M>::ZERO; 2], ScalarOf::<M>::ONE),
            multipliers: [Vector::<M>::ZERO; 2],
        }
    }

    /// Predicts the velocities at both ends of the parabola of a step of length `h`.
    fn predict(&mut self, h: ScalarOf<M>) -> [Vector<M>; 2] {
        let mut ends = self.prediction.slopes(&self.reached.velocities, h);
        for (end, excess) in ends.iter_mut().zip(&self.excess) {
            add(end, h * h, excess);
        }
        ends
    }

    /// Computes the change of coordinates and momenta, iterating from these velocities at the ends.
    fn solve(
        &mut self,
        step: &CanonicalStep<'_, M>,
        mut ends: [Vector<M>; 2],
        source: Source,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<ScalarOf<M>>> {
        let derivatives = self.reached.derivatives(step, &mean(&ends), source, work)?;
        if M::SAYS_CONSTRAINTS {
            return self.solve_held(step, derivatives, &ends, work);
        }
        let Some(linearised) = Linearised::new(&derivatives) else {
            return Err(factors(&derivatives.constant).err().unwrap_or(StepFailure::NotFinite));
        };
        let mut equations = StepEquations { step, derivatives, linearised, change: Vector::<M>::ZERO };
        newton::solve(&mut equations, &mut ends, self.rounding, work)?;
        self.ends = (ends, step.h);
        let mut q = Vector::<M>::ZERO;
        add(&mut q, step.h, &mean(&ends));
        Ok(join::<M>(&q, &equations.change))
    }

    /// Solves with constraints, with consistent momenta at the end.
    fn solve_held(
        &mut self,
        step: &CanonicalStep<'_, M>,
        derivatives: Derivatives<M>,
        ends: &[Vector<M>; 2],
        work: &mut Work,
    ) -> Result<M::State, StepFailure<ScalarOf<M>>> {
        let equations = ConstrainedEquations::new(step, derivatives, ends)?;
        let Solved { ends, multipliers, mut change } =
            equations.solve(ends, &self.multipliers, self.rounding, work)?;
        let (one, (t, q, v)) = (ScalarOf::<M>::ONE, places(step, &ends)[2]);
        let mut p = step.p;
        add(&mut p, one, &change);
        let reaction = self.reached.hold(step.system, t, (&q, &p), v, step.h, work)?;
        add(&mut change, one, &reaction);
        self.ends = (ends, step.h);
        self.multipliers = multipliers;
        let mut moved = Vector::<M>::ZERO;
        add(&mut moved, step.h, &mean(&ends));
        Ok(join::<M>(&moved, &change))
    }
}

impl<M: CanonicalSystem + ?Sized> Clone for Discrete<M> {
    fn clone(&self) -> Self {
        Discrete { reached: self.reached.clone(), ..*self }
    }
}

impl<M: CanonicalSystem + ?Sized> Formula<M> for Discrete<M> {
    const KEEPS_CONSTRAINTS: bool = M::SAYS_CONSTRAINTS;

    fn variables(&mut self, system: &M, t: M::Scalar, y: &M::State) -> M::State {
        self.prediction.forget();
        self.multipliers = [Vector::<M>::ZERO; 2];
        self.excess = [Vector::<M>::ZERO; 2];
        self.reached.start(system, t, y)
    }

    fn increment(&mut self, step: &Step<'_, M>, work: &mut Work) -> Result<M::State, StepFailure<M::Scalar>> {
        let (start, predicted) = ([self.reached.velocities; 2], self.predict(step.h));
        let step = CanonicalStep::of(step);
        let first = self.solve(&step, predicted, Source::System, work);
        first.or_else(|_| self.solve(&step, start, Source::Differences, work))
    }

    fn state(
        &mut self,
        system: &M,
        t: M::Scalar,
        variables: &M::State,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let (ends, h) = self.ends;
        if M::SAYS_CONSTRAINTS {
            return Ok(join::<M>(&split::<M>(variables).0, &self.reached.held()));
        }
        self.reached.finish(system, (t, variables), ends[1], h, work)
    }

    fn follow(&mut self, system: &M, t: M::Scalar, ends: (&M::State, &M::State), variables: &mut M::State) {
        self.reached.follow(system, t, ends, variables);
    }

    fn accept(&mut self, _t: M::Scalar) {
        let (ends, h) = self.ends;
        let start = self.reached.velocities;
        self.reached.accept(h);
        let end = self.reached.velocities;
        let square = M::Scalar::ONE / (h * h);
        self.excess = [(ends[0], start), (ends[1], end)].map(|(parabola, motion)| {
            let mut excess = Vector::<M>::ZERO;
            add(&mut excess, square, &parabola);
            add(&mut excess, -square, &motion);
            excess
        });
        // The velocity in the middle follows from the mean one by Simpson's rule.
        let mut middle = Vector::<M>::ZERO;
        add(&mut middle, M::Scalar::from_f64(1.5), &mean(&ends));
        add(&mut middle, M::Scalar::from_f64(-0.25), &start);
        add(&mut middle, M::Scalar::from_f64(-0.25), &end);
        self.prediction.learn([start, middle], h);
    }

    fn interpolate(&mut self, within: &WithinStep<'_, M>, work: &mut Work) -> M::State {
        work.evaluations += 2;
        let [f0, f1] = within.rates();
        cubic(within.place(), within.states(), [&f0, &f1])
    }
}

/// Computes the mean of two vectors.
#[inline]
fn mean<S: Scalar, Y: StateVector<S>>(ends: &[Y; 2]) -> Y {
    let (mut mean, half) = (Y::ZERO, S::from_f64(0.5));
    add(&mut mean, half, &ends[0]);
    add(&mut mean, half, &ends[1]);
    mean
}

/// A time with coordinates and velocities.
type Configuration<M> = (ScalarOf<M>, Vector<M>, Vector<M>);

/// Returns the start, the middle and the end of the parabola with these velocities at its ends.
#[inline]
fn places<M: CanonicalSystem + ?Sized>(
    step: &CanonicalStep<'_, M>,
    ends: &[Vector<M>; 2],
) -> [Configuration<M>; 3] {
    let CanonicalStep { t, q, h, .. } = *step;
    let n = M::Scalar::from_f64;
    let (mut middle, mut last) = (q, q);
    add(&mut middle, h * n(0.375), &ends[0]);
    add(&mut middle, h * n(0.125), &ends[1]);
    add(&mut last, h, &mean(ends));
    [(t, q, ends[0]), (t + h * n(0.5), middle, mean(ends)), (t + h, last, ends[1])]
}

/// Computes the residuals of the equations for these momenta and rates at the three places, and the
/// change of the momenta.
#[inline]
fn balance<M: CanonicalSystem + ?Sized>(
    step: &CanonicalStep<'_, M>,
    momenta: &[Vector<M>; 3],
    rates: &[Vector<M>; 3],
) -> ([Vector<M>; 2], Vector<M>) {
    let (n, h) = (M::Scalar::from_f64, step.h);
    let sixth = h / n(6.0);
    let (mut start, mut whole) = (step.p, momenta[0]);
    for (factor, vector) in [(n(1.0) / n(-3.0), &momenta[0]), (n(2.0) / n(-3.0), &momenta[1])] {
        add(&mut start, factor, vector);
    }
    add(&mut start, sixth, &rates[0]);
    add(&mut start, sixth, &rates[1]);
    add(&mut whole, h, &rates[1]);
    add(&mut whole, -M::Scalar::ONE, &momenta[2]);
    let mut change = Vector::<M>::ZERO;
    for (weight, rates) in [1.0, 4.0, 1.0].into_iter().zip(rates) {
        add(&mut change, n(weight) * sixth, rates);
    }
    ([start, whole], change)
}

/// The equations for the velocities at both ends of a step.
struct StepEquations<'a, M: CanonicalSystem + ?Sized> {
    step: &'a CanonicalStep<'a, M>,
    derivatives: Derivatives<M>,
    linearised: Linearised<M::Scalar, M::Coordinates>,
    /// The change of the momenta at the last evaluation.
    change: M::Coordinates,
}

impl<M: CanonicalSystem + ?Sized> Equations<M::Scalar, M::Coordinates, 2> for StepEquations<'_, M> {
    #[inline]
    fn residual(&mut self, ends: &[M::Coordinates; 2], work: &mut Work) -> [M::Coordinates; 2] {
        let (system, places) = (self.step.system, places(self.step, ends));
        let momenta = places.map(|(t, q, v)| system.momenta(t, &q, &v));
        let rates = places.map(|(t, q, v)| system.momentum_rates(t, &q, &v));
        work.evaluations += 3;
        let (residual, change) = balance(self.step, &momenta, &rates);
        self.change = change;
        residual
    }

    fn correction(&self, residual: &[M::Coordinates; 2]) -> [M::Coordinates; 2] {
        self.linearised.solve(residual)
    }

    fn magnitude(&self, ends: &[M::Coordinates; 2]) -> M::Coordinates {
        self.derivatives.magnitude(&magnitude(newton::largest(ends), &self.step.q, self.step.h))
    }
}

#[cfg(test)]
mod tests;
