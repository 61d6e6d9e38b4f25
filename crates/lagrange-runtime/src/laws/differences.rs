//! Derivatives of a system, computed from differences of its Lagrangian alone.

use crate::linalg::vector::add;
use crate::scalar::{Number, Scalar};
use crate::system::{
    LagrangianSystem, Positions, StateVector, Velocities, displaced, normalise_positions, split,
};

/// Weights of central differences of order six (Fornberg, "Generation of finite difference formulas
/// on arbitrarily spaced grids", Math. Comp. 51 (1988), 699–706).
const WEIGHTS: [f64; 3] = [3.0 / 4.0, -3.0 / 20.0, 1.0 / 60.0];

/// Computes the derivative of a function at zero, from values at three steps on both sides.
pub(super) fn derivative<S: Scalar>(step: S, value: impl Fn(S) -> S) -> S {
    let mut sum = S::ZERO;
    for (index, weight) in WEIGHTS.into_iter().enumerate() {
        let at = S::from_f64((index + 1) as f64) * step;
        sum = S::from_f64(weight).multiply_add(value(at) - value(-at), sum);
    }
    sum / step
}

/// A system in one state, whose Lagrangian is evaluated nearby.
pub(super) struct Nearby<'a, M: LagrangianSystem> {
    pub(super) system: &'a M,
    pub(super) t: M::Scalar,
    pub(super) q: Positions<M>,
    pub(super) v: Velocities<M>,
    /// Accelerations.
    pub(super) a: Velocities<M>,
    /// Rates of the positions.
    pub(super) rates: Positions<M>,
    /// Length of a step of positions and velocities.
    pub(super) step: M::Scalar,
    /// Length of a time step, in which no entry changes by more than in a step of the state.
    moment: M::Scalar,
}

impl<'a, M: LagrangianSystem> Nearby<'a, M> {
    pub(super) fn new(system: &'a M, t: M::Scalar, y: &M::State, step: M::Scalar) -> Self {
        let (q, v) = split::<M>(y);
        let (a, rates) = (system.acceleration(t, &q, &v), system.position_rates(t, &q, &v));
        let (entries, changes) =
            (q.as_ref().iter().chain(v.as_ref()), rates.as_ref().iter().chain(a.as_ref()));
        let speed = entries.zip(changes).fold(M::Scalar::ONE, |speed, (entry, change)| {
            speed.max(change.abs() / entry.abs().max(M::Scalar::ONE))
        });
        Nearby { system, t, q, v, a, rates, step, moment: step / speed }
    }

    /// Returns the number of velocities.
    fn freedoms(&self) -> usize {
        self.v.as_ref().len()
    }

    /// Returns the rounding error of a value in a second difference.
    pub(super) fn noise(&self, value: M::Scalar) -> M::Scalar {
        value.abs() * M::Scalar::epsilon() / (self.step * self.moment)
    }

    /// Returns the unit displacement of one degree of freedom.
    fn unit(&self, index: usize) -> Velocities<M> {
        let mut unit = self.v.zeros();
        unit.as_mut()[index] = M::Scalar::ONE;
        unit
    }

    /// Computes ∂L/∂v of one velocity, after a time that may be negative.
    fn momentum_after(&self, after: M::Scalar, index: usize) -> M::Scalar {
        let (t, q, v) = self.after(after);
        let moved = |by: M::Scalar| {
            let mut moved = v;
            moved.as_mut()[index] = moved.as_ref()[index] + by;
            self.system.lagrangian(t, &q, &moved)
        };
        derivative(self.step, moved)
    }

    /// Returns time, positions and velocities after a time, to first order.
    fn after(&self, after: M::Scalar) -> (M::Scalar, Positions<M>, Velocities<M>) {
        let (mut q, mut v) = (self.q, self.v);
        add(&mut q, after, &self.rates);
        add(&mut v, after, &self.a);
        normalise_positions::<M>(self.system.description(), &mut q);
        (self.t + after, q, v)
    }

    /// Computes ∂L/∂v of one velocity.
    pub(super) fn momentum(&self, index: usize) -> M::Scalar {
        self.momentum_after(M::Scalar::ZERO, index)
    }

    /// Computes d/dt ∂L/∂v along the motion.
    pub(super) fn momentum_rate(&self, index: usize) -> M::Scalar {
        derivative(self.moment, |after| self.momentum_after(after, index))
    }

    /// Computes ∂L/∂q along the displacement of one degree of freedom.
    pub(super) fn slope(&self, index: usize) -> M::Scalar {
        let unit = self.unit(index);
        derivative(self.step, |by| {
            let q = displaced(self.system, self.t, &self.q, [(by, &unit)]);
            self.system.lagrangian(self.t, &q, &self.v)
        })
    }

    /// Computes p·δv, where δv is the change of the velocities by a constant displacement δ along
    /// one degree of freedom. With q̇ = N v, N δv = (d/dt N) δ − ∂(N v)/∂q N δ. It is zero if
    /// velocities are rates (Lurie, *Analytical Mechanics*, §10.1).
    pub(super) fn turning(&self, index: usize) -> M::Scalar {
        if self.system.description().velocities_are_rates() {
            return M::Scalar::ZERO;
        }
        let (system, t, unit) = (self.system, self.t, self.unit(index));
        let change = |along: &Velocities<M>, by, of: &Velocities<M>| {
            let q = displaced(system, t, &self.q, [(by, along)]);
            system.position_change(t, &q, of)
        };
        let mut to = self.q;
        for (place, entry) in to.as_mut().iter_mut().enumerate() {
            let first = derivative(self.step, |by| change(&self.v, by, &unit).as_ref()[place]);
            let second = derivative(self.step, |by| change(&unit, by, &self.v).as_ref()[place]);
            *entry = self.step.multiply_add(first - second, *entry);
        }
        let added = system.displacement(t, &self.q, &to);
        let momenta = (0..self.freedoms()).map(|index| self.momentum(index));
        let products = momenta.zip(added.as_ref()).map(|(momentum, &by)| momentum * by);
        products.fold(M::Scalar::ZERO, |sum, product| sum + product) / self.step
    }

    /// Computes ∂L/∂t, with what first-order states change.
    pub(super) fn explicit_rate(&self) -> M::Scalar {
        let states = self.system.description().first_order_states;
        let first = self.q.as_ref().len() - states;
        derivative(self.moment, |after| {
            let mut q = self.q;
            for (entry, &rate) in q.as_mut().iter_mut().zip(self.rates.as_ref()).skip(first) {
                *entry = after.multiply_add(rate, *entry);
            }
            self.system.lagrangian(self.t + after, &q, &self.v)
        })
    }

    /// Computes the rate of the energy along the motion.
    pub(super) fn energy_rate(&self) -> M::Scalar {
        derivative(self.moment, |after| {
            let (t, q, v) = self.after(after);
            self.system.energy(t, &q, &v)
        })
    }
}
