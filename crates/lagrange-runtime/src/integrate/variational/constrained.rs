//! The equations of a step with constraints.
//!
//! Constraint forces Aᵀλ are added to the rates of the momenta at all three places. With c on
//! positions and g on velocities alone,
//!
//! ```text
//! c(tₘ, qₘ) = 0,    c(t₁, q₁) = 0,
//! 5/24 g₀ + 1/3 gₘ − 1/24 g₁ = 0,    1/6 g₀ + 2/3 gₘ + 1/6 g₁ = 0
//! ```
//!
//! determine the multipliers at the start and in the middle. The parabola ends every half step on
//! admissible positions, and the contributions of a constraint on velocities cancel. The
//! multipliers at the end make the momenta there admissible, A v₁ + c_t = 0. Constraints therefore
//! hold at the ends of all steps, and the step is symmetric in time. With constraints on positions
//! alone it is symplectic on the admissible states; with constraints on velocities it is a discrete
//! Lagrange–d'Alembert principle.
//!
//! Sources: Jay, *Symplectic partitioned Runge–Kutta methods for constrained Hamiltonian systems*,
//! SIAM Journal on Numerical Analysis 33 (1996), 368–387; Hairer, Lubich, Wanner, *Geometric
//! Numerical Integration*, 2nd ed., §VII.1.4; Marsden, West, Acta Numerica 10 (2001), §3.5; for
//! constraints on velocities Cortés, Martínez, *Non-holonomic integrators*, Nonlinearity 14 (2001),
//! 1365–1392, and Jay, *Lagrange–d'Alembert SPARK integrators for nonholonomic Lagrangian systems*,
//! whose integrated constraints these are.

use crate::integrate::canonical::{CanonicalStep, Derivatives, magnitude};
use crate::integrate::method::Work;
use crate::integrate::newton::{self, Equations};
use crate::integrate::variational::coupled::{AtPlace, Coupled, FORCES, PARTS, combined};
use crate::integrate::variational::{Configuration, balance, places};
use crate::linalg::vector::add;
use crate::scalar::Number;
use crate::system::{
    CanonicalSystem, MechanicalSystem, ScalarOf, StateVector, StepFailure, Vector, join, split,
};

/// The equations for the velocities at both ends of a step, with the multipliers at the start and
/// in the middle.
pub(super) struct ConstrainedEquations<'a, M: CanonicalSystem + ?Sized> {
    step: &'a CanonicalStep<'a, M>,
    derivatives: Derivatives<M>,
    coupled: Coupled<M>,
    /// The constraints at the start, with the velocities there.
    start: (AtPlace<M>, Vector<M>),
    /// Values in the middle and at the end, for the first evaluation.
    known: Option<[AtPlace<M>; 2]>,
    /// The change of the momenta at the last evaluation, without the last multipliers.
    change: Vector<M>,
}

impl<'a, M: CanonicalSystem + ?Sized> ConstrainedEquations<'a, M> {
    /// Creates the equations, linearised at velocities from which an iteration starts.
    pub(super) fn new(
        step: &'a CanonicalStep<'a, M>,
        derivatives: Derivatives<M>,
        ends: &[M::Coordinates; 2],
    ) -> Result<Self, StepFailure<M::Scalar>> {
        let values = places(step, ends).map(|(t, q, v)| step.system.constraint_values(t, &q, &v));
        let coupled = Coupled::new(&derivatives, values.clone(), step.h)?;
        let [first, middle, last] = values;
        let (start, known) = ((first, ends[0]), Some([middle, last]));
        Ok(ConstrainedEquations { step, derivatives, coupled, start, known, change: Vector::<M>::ZERO })
    }

    /// Computes the velocities at both ends and the multipliers from a guess, and the change of the
    /// momenta.
    pub(super) fn solve(
        mut self,
        ends: &[M::Coordinates; 2],
        multipliers: &[M::Coordinates; 2],
        rounding: M::Scalar,
        work: &mut Work,
    ) -> Result<Solved<M>, StepFailure<M::Scalar>> {
        let mut unknowns = [join::<M>(&ends[0], &multipliers[0]), join::<M>(&ends[1], &multipliers[1])];
        newton::solve(&mut self, &mut unknowns, rounding, work)?;
        let [(first, start), (last, middle)] = unknowns.each_ref().map(split::<M>);
        Ok(Solved { ends: [first, last], multipliers: [start, middle], change: self.change })
    }

    /// Returns the constraint residuals in the first half and in the whole of the step, divided by
    /// its length.
    fn violations(
        &self,
        places: &[Configuration<M>; 3],
        middle: &AtPlace<M>,
        last: &AtPlace<M>,
    ) -> [M::Coordinates; 2] {
        let (start, reference) = &self.start;
        let mut change = places[0].2;
        add(&mut change, -M::Scalar::ONE, reference);
        let mut first = start.applied(&change);
        add(&mut first, M::Scalar::ONE, &start.velocities);
        let rates = [first, middle.velocities, last.velocities];
        let mut violations = PARTS.map(|parts| combined(&parts, &rates));
        for (violation, place) in violations.iter_mut().zip([middle, last]) {
            for i in (0..start.count()).filter(|i| start.is_holonomic(*i)) {
                violation.as_mut()[i] = place.positions.as_ref()[i] / self.step.h;
            }
        }
        violations
    }
}

/// The solution of a step.
pub(super) struct Solved<M: MechanicalSystem + ?Sized> {
    /// Velocities of the parabola at both ends.
    pub(super) ends: [Vector<M>; 2],
    /// Multipliers at the start and in the middle.
    pub(super) multipliers: [Vector<M>; 2],
    /// The change of the momenta without the force of constraints at the end.
    pub(super) change: Vector<M>,
}

impl<M: CanonicalSystem + ?Sized> Equations<M::Scalar, M::State, 2> for ConstrainedEquations<'_, M> {
    #[inline]
    fn residual(&mut self, unknowns: &[M::State; 2], work: &mut Work) -> [M::State; 2] {
        let [(v0, first), (v1, second)] = unknowns.each_ref().map(split::<M>);
        let (system, places) = (self.step.system, places(self.step, &[v0, v1]));
        let [middle, last] = self
            .known
            .take()
            .unwrap_or_else(|| [&places[1], &places[2]].map(|(t, q, v)| system.constraint_values(*t, q, v)));
        let momenta = places.map(|(t, q, v)| system.momenta(t, &q, &v));
        let mut rates = places.map(|(t, q, v)| system.free_momentum_rates(t, &q, &v));
        work.evaluations += 3;
        add(&mut rates[0], M::Scalar::ONE, &self.start.0.force(&first));
        add(&mut rates[1], M::Scalar::ONE, &middle.force(&second));
        let (residual, change) = balance(self.step, &momenta, &rates);
        self.change = change;
        let violations = self.violations(&places, &middle, &last);
        let [half, whole] = violations.map(|violation| combined(&[-1.0], &[violation]));
        [join::<M>(&residual[0], &half), join::<M>(&residual[1], &whole)]
    }

    fn correction(&self, residual: &[M::State; 2]) -> [M::State; 2] {
        self.coupled.solve(residual)
    }

    fn magnitude(&self, unknowns: &[M::State; 2]) -> M::State {
        let (velocities, multipliers) = split::<M>(&newton::largest(unknowns));
        let terms = magnitude(velocities, &self.step.q, self.step.h);
        let mut momenta = self.derivatives.magnitude(&terms);
        let loads = self.start.0.load(&multipliers);
        add(&mut momenta, self.step.h.abs() * ScalarOf::<M>::from_f64(FORCES[1][1]), &loads);
        join::<M>(&momenta, &self.start.0.sizes(&terms))
    }
}
