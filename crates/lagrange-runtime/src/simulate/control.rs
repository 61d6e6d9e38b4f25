//! Inputs during a run that follow a law at every instant.

use std::fmt::{Debug, Formatter};
use std::sync::Arc;

use crate::contact::{ContactSystem, ForcedTerms, Mode, own};
use crate::scalar::{Number, Scalar};
use crate::simulate::closed_loop::ClosedLoop;
use crate::system::{
    CanonicalSystem, ConstraintValues, ControlledSystem, MechanicalSystem, StateMatrix, StepFailure,
    VelocityMatrix, Wrapper, join,
};

/// The source of the inputs of the system M at every instant of a run: nothing, or a [`Law`].
pub trait Drive<M: MechanicalSystem>: Clone {
    /// The system that methods integrate.
    type Closed: ClosedLoop<M>;

    /// Hands over the closed loop.
    fn close<R>(&self, system: &M, run: impl FnOnce(&Self::Closed) -> R) -> R;

    /// Returns the drive for a motion of this system from this initial state.
    fn for_motion(&self, _system: &M, _start: &M::State) -> Self {
        self.clone()
    }
}

/// Inputs stay as they are, or as sampled controllers set them.
#[derive(Clone, Copy, Debug)]
pub struct Undriven;

/// A law that gives the inputs for each time and state.
pub struct Law<F>(Arc<F>);

impl<F> Law<F> {
    pub(crate) fn new(law: F) -> Self {
        Law(Arc::new(law))
    }
}

impl<F> Clone for Law<F> {
    fn clone(&self) -> Self {
        Law(Arc::clone(&self.0))
    }
}

impl<F> Debug for Law<F> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str("Law")
    }
}

impl<M: MechanicalSystem> Drive<M> for Undriven {
    type Closed = M;

    fn close<R>(&self, system: &M, run: impl FnOnce(&M) -> R) -> R {
        run(system)
    }
}

impl<M, F> Drive<M> for Law<F>
where
    M: ControlledSystem,
    F: Fn(&M, M::Scalar, M::NamedState) -> M::Inputs,
{
    type Closed = Driven<M, F>;

    fn close<R>(&self, system: &M, run: impl FnOnce(&Driven<M, F>) -> R) -> R {
        run(&Driven { plant: system.with_inputs(system.inputs()), law: Arc::clone(&self.0) })
    }
}

/// A system whose inputs follow a law.
pub struct Driven<M, F> {
    plant: M,
    law: Arc<F>,
}

impl<M, F> ClosedLoop<M> for Driven<M, F>
where
    M: ControlledSystem,
    F: Fn(&M, M::Scalar, M::NamedState) -> M::Inputs,
{
    fn plant(&self) -> &M {
        &self.plant
    }

    fn with_plant(&self, plant: M) -> Self {
        Driven { plant, law: Arc::clone(&self.law) }
    }

    fn into_plant(self) -> M {
        self.plant
    }

    #[inline]
    fn ask<R>(&self, t: M::Scalar, y: &M::State, question: impl FnOnce(&M) -> R) -> R {
        self.present(t, y, question)
    }

    #[inline]
    fn extended(&self, _t: M::Scalar, y: &M::State) -> M::State {
        *y
    }

    #[inline]
    fn state_of_plant(y: &M::State) -> M::State {
        *y
    }
}

impl<M, F> Wrapper for Driven<M, F>
where
    M: ControlledSystem,
    F: Fn(&M, M::Scalar, M::NamedState) -> M::Inputs,
{
    type Inner = M;
    type State = M::State;

    #[inline]
    fn inner(&self) -> &M {
        &self.plant
    }

    /// Wraps the plant with its own inputs, on which the law may build, and not those that it had
    /// at a time and state.
    fn around(&self, inner: M) -> Self {
        self.with_plant(inner.with_inputs(self.plant.inputs()))
    }

    #[inline]
    fn present<R>(&self, t: M::Scalar, y: &M::State, ask: impl FnOnce(&M) -> R) -> R {
        ask(&self.plant.with_inputs((self.law)(&self.plant, t, M::NamedState::from(*y))))
    }

    #[inline]
    fn outer_rhs(&self, t: M::Scalar, y: &M::State) -> M::State {
        self.present(t, y, |plant| plant.rhs(t, y))
    }

    /// Returns the Jacobian of the plant with fixed inputs, and difference quotients of the law.
    fn outer_jacobian(&self, t: M::Scalar, y: &M::State) -> Option<StateMatrix<M>> {
        self.present(t, y, |fixed| {
            let mut jacobian = fixed.jacobian(t, y)?;
            let without = fixed.rhs(t, y);
            for column in 0..y.as_ref().len() {
                let (ahead, width) = moved::<M>(y, column);
                let others = self.present(t, &ahead, M::inputs);
                let with = fixed.with_inputs(others).rhs(t, y);
                let change =
                    with.as_ref().iter().zip(without.as_ref()).map(|(with, without)| *with - *without);
                for (row, change) in jacobian.as_mut().iter_mut().zip(change) {
                    row.as_mut()[column] = row.as_ref()[column] + change / width;
                }
            }
            Some(jacobian)
        })
    }
}

/// Reactions are those of the plant with the inputs that it has. Dampers of a law act by the
/// velocities at the beginning of a step.
impl<M, F, const N: usize, const K: usize> ContactSystem<N, K> for Driven<M, F>
where
    M: ControlledSystem + ContactSystem<N, K>,
    F: Fn(&M, M::Scalar, M::NamedState) -> M::Inputs,
{
    type Terms = M::Terms;

    const REACTIONS: [&'static str; K] = M::REACTIONS;
    const NEEDS_STEPS: Option<&'static str> = M::NEEDS_STEPS;
    const LIMITS_REVERSE: [bool; K] = M::LIMITS_REVERSE;
    const GRADIENTS_JUMP: [bool; K] = M::GRADIENTS_JUMP;

    fn modes(&self) -> [Mode; K] {
        self.plant.modes()
    }

    fn in_modes(&self, modes: [Mode; K]) -> Self {
        self.with_plant(self.plant.in_modes(modes))
    }

    fn check(&self) -> Result<(), StepFailure<M::Scalar>> {
        self.plant.check()
    }

    fn terms(&self, t: M::Scalar, q: &M::Coordinates, v: &[M::Scalar; N]) -> M::Terms {
        self.present(t, &join::<M>(q, &own(&self.plant, v)), |plant| plant.terms(t, q, v))
    }

    fn step_terms(
        &self,
        t: M::Scalar,
        q: &M::Coordinates,
        v: &[M::Scalar; N],
        h: M::Scalar,
    ) -> ForcedTerms<M::Terms, M::Scalar, N> {
        self.present(t, &join::<M>(q, &own(&self.plant, v)), |plant| plant.step_terms(t, q, v, h))
    }

    fn event_of(&self, k: usize) -> Option<usize> {
        self.plant.event_of(k)
    }

    #[inline]
    fn velocities(&self) -> usize {
        self.plant.velocities()
    }

    fn reaction_name(&self, k: usize) -> &'static str {
        self.plant.reaction_name(k)
    }

    fn needs_steps(&self) -> Option<&'static str> {
        self.plant.needs_steps()
    }

    fn limit_reverses(&self, k: usize) -> bool {
        self.plant.limit_reverses(k)
    }

    fn gradient_jumps(&self, k: usize) -> bool {
        self.plant.gradient_jumps(k)
    }
}

/// Returns the state with one entry moved by about half of all its digits, and by how much.
fn moved<M: MechanicalSystem>(y: &M::State, entry: usize) -> (M::State, M::Scalar) {
    let mut moved = *y;
    let value = y.as_ref()[entry];
    moved.as_mut()[entry] = value + M::Scalar::epsilon().sqrt() * M::Scalar::ONE.max(value.abs());
    let width = moved.as_ref()[entry] - value;
    (moved, width)
}

impl<M, F> CanonicalSystem for Driven<M, F>
where
    M: ControlledSystem + CanonicalSystem,
    F: Fn(&M, M::Scalar, M::NamedState) -> M::Inputs,
{
    #[inline]
    fn momenta(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Coordinates) -> M::Coordinates {
        self.present(t, &join::<M>(q, v), |plant| plant.momenta(t, q, v))
    }

    #[inline]
    fn momentum_rates(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Coordinates) -> M::Coordinates {
        self.present(t, &join::<M>(q, v), |plant| plant.momentum_rates(t, q, v))
    }

    fn mass_matrix(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Coordinates) -> VelocityMatrix<Self> {
        self.present(t, &join::<M>(q, v), |plant| plant.mass_matrix(t, q, v))
    }

    fn free_momentum_rates(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Coordinates) -> M::Coordinates {
        self.present(t, &join::<M>(q, v), |plant| plant.free_momentum_rates(t, q, v))
    }

    const SAYS_CONSTRAINTS: bool = M::SAYS_CONSTRAINTS;

    fn constraint_values(
        &self,
        t: M::Scalar,
        q: &M::Coordinates,
        v: &M::Coordinates,
    ) -> ConstraintValues<M::Scalar, M::Coordinates> {
        self.present(t, &join::<M>(q, v), |plant| plant.constraint_values(t, q, v))
    }
}
