//! Hand-written constrained systems with known motions.

use super::{ConstrainedSystem, admit, correct, redundant_correction, redundant_motion, weighed};
use crate::system::{
    CanonicalSystem, EnergyFunction, MechanicalSystem, OdeSystem, StateVector, StepFailure, Unnamed, join,
    split,
};

/// A system of masses under forces and constraints: N coordinates, D constraints.
pub(crate) trait Mechanism<const N: usize, const D: usize> {
    type State: StateVector<f64>;

    const NAMES: &'static [&'static str];

    /// Returns the diagonal of the mass matrix.
    fn masses(&self) -> [f64; N];

    fn potential(&self, _q: &[f64; N]) -> f64 {
        0.0
    }

    fn forces(&self, _q: &[f64; N]) -> [f64; N] {
        [0.0; N]
    }

    /// Computes c of holonomic constraints; zero for the others.
    fn positions(&self, t: f64, q: &[f64; N]) -> [f64; D];

    /// Computes A in rows.
    fn jacobian(&self, t: f64, q: &[f64; N]) -> [[f64; N]; D];

    /// Computes ∂c/∂t.
    fn rates(&self, _t: f64, _q: &[f64; N]) -> [f64; D] {
        [0.0; D]
    }

    /// Computes b in A a + b = 0.
    fn drift(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; D];
}

/// A mechanism as a system.
#[derive(Clone, Copy, Debug)]
pub(crate) struct System<L, const N: usize, const D: usize>(pub(crate) L);

impl<L: Mechanism<N, D>, const N: usize, const D: usize> System<L, N, D> {
    fn mass(&self) -> [[f64; N]; N] {
        let mut rows = [[0.0; N]; N];
        for (i, mass) in self.0.masses().into_iter().enumerate() {
            rows[i][i] = mass;
        }
        rows
    }

    fn motion(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> super::RedundantMotion<f64, N, D> {
        let (forces, rows) = (self.0.forces(q), self.0.jacobian(t, q));
        redundant_motion(&self.mass(), &forces, &rows, &self.0.drift(t, q, v))
    }

    /// Returns the largest residual of positions and velocities.
    pub(crate) fn residual(&self, t: f64, y: &L::State) -> f64 {
        let (q, v) = split::<Self>(y);
        let residuals = [self.position_residuals(t, &q), self.velocity_residuals(t, &q, &v)];
        residuals.as_flattened().iter().fold(0.0, |most, residual| most.max(residual.abs()))
    }

    pub(crate) fn energy_of(&self, y: &L::State) -> f64 {
        let (q, v) = split::<Self>(y);
        self.energy(0.0, &q, &v)
    }
}

impl<L: Mechanism<N, D>, const N: usize, const D: usize> OdeSystem for System<L, N, D> {
    type Scalar = f64;
    type State = L::State;

    fn rhs(&self, t: f64, y: &L::State) -> L::State {
        let (q, v) = split::<Self>(y);
        join::<Self>(&v, &self.acceleration(t, &q, &v))
    }

    const IS_CONSTRAINED: bool = true;

    fn correct(&self, t: f64, y: &mut L::State) -> Result<(), StepFailure<f64>> {
        correct(self, t, y)
    }

    fn admit(&self, t: f64, y: &mut L::State) -> Result<(), StepFailure<f64>> {
        admit(self, t, y)
    }
}

impl<L: Mechanism<N, D>, const N: usize, const D: usize> MechanicalSystem for System<L, N, D> {
    type Coordinates = [f64; N];
    type Velocities = [f64; N];
    type Columns<C> = Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &["q"; N];

    fn acceleration(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        self.motion(t, q, v).acceleration
    }

    fn position_rates(&self, _t: f64, _q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        *v
    }
}

impl<L: Mechanism<N, D>, const N: usize, const D: usize> EnergyFunction for System<L, N, D> {
    fn energy(&self, _t: f64, q: &[f64; N], v: &[f64; N]) -> f64 {
        let double: f64 = self.0.masses().iter().zip(v).map(|(mass, v)| mass * v * v).sum();
        double / 2.0 + self.0.potential(q)
    }
}

impl<L: Mechanism<N, D>, const N: usize, const D: usize> CanonicalSystem for System<L, N, D> {
    fn momenta(&self, _t: f64, _q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        let masses = self.0.masses();
        core::array::from_fn(|i| masses[i] * v[i])
    }

    fn momentum_rates(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        self.momenta(t, q, &self.acceleration(t, q, v))
    }

    fn mass_matrix(&self, _t: f64, _q: &[f64; N], _v: &[f64; N]) -> [[f64; N]; N] {
        self.mass()
    }
}

impl<L: Mechanism<N, D>, const N: usize, const D: usize> ConstrainedSystem for System<L, N, D> {
    type Multipliers = [f64; D];

    const CONSTRAINTS: &'static [&'static str] = L::NAMES;

    fn multipliers(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; D] {
        self.motion(t, q, v).multipliers
    }

    fn position_residuals(&self, t: f64, q: &[f64; N]) -> [f64; D] {
        self.0.positions(t, q)
    }

    fn velocity_residuals(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; D] {
        let (rows, rates) = (self.0.jacobian(t, q), self.0.rates(t, q));
        core::array::from_fn(|i| rates[i] + rows[i].iter().zip(v).map(|(entry, v)| entry * v).sum::<f64>())
    }

    fn residual_scales(&self, t: f64, q: &[f64; N], by: &[f64; N]) -> [f64; D] {
        weighed(&self.0.jacobian(t, q), by)
    }

    fn correction(&self, t: f64, q: &[f64; N], _v: &[f64; N], residuals: &[f64; D]) -> [f64; N] {
        redundant_correction(&self.mass(), &self.0.jacobian(t, q), residuals)
    }

    fn mass_times(&self, _t: f64, _q: &[f64; N], _v: &[f64; N], change: &[f64; N]) -> [f64; N] {
        let masses = self.0.masses();
        core::array::from_fn(|i| masses[i] * change[i])
    }
}

/// A point mass on a massless rod of length one, in Cartesian coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pendulum;

impl Mechanism<2, 1> for Pendulum {
    type State = [f64; 4];

    const NAMES: &'static [&'static str] = &["rod"];

    fn masses(&self) -> [f64; 2] {
        [1.0, 1.0]
    }

    fn potential(&self, [_, y]: &[f64; 2]) -> f64 {
        9.81 * y
    }

    fn forces(&self, _q: &[f64; 2]) -> [f64; 2] {
        [0.0, -9.81]
    }

    fn positions(&self, _t: f64, [x, y]: &[f64; 2]) -> [f64; 1] {
        [x * x + y * y - 1.0]
    }

    fn jacobian(&self, _t: f64, [x, y]: &[f64; 2]) -> [[f64; 2]; 1] {
        [[2.0 * x, 2.0 * y]]
    }

    fn drift(&self, _t: f64, _q: &[f64; 2], [u, v]: &[f64; 2]) -> [f64; 1] {
        [2.0 * (u * u + v * v)]
    }
}

/// A bead on a straight wire that turns at this rate: r = r₀ cosh ωt from rest on the wire.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bead {
    pub(crate) rate: f64,
}

impl Mechanism<2, 1> for Bead {
    type State = [f64; 4];

    const NAMES: &'static [&'static str] = &["wire"];

    fn masses(&self) -> [f64; 2] {
        [0.3, 0.3]
    }

    fn positions(&self, t: f64, [x, y]: &[f64; 2]) -> [f64; 1] {
        let (sine, cosine) = (self.rate * t).sin_cos();
        [x * sine - y * cosine]
    }

    fn jacobian(&self, t: f64, _q: &[f64; 2]) -> [[f64; 2]; 1] {
        let (sine, cosine) = (self.rate * t).sin_cos();
        [[sine, -cosine]]
    }

    fn rates(&self, t: f64, [x, y]: &[f64; 2]) -> [f64; 1] {
        let (sine, cosine) = (self.rate * t).sin_cos();
        [self.rate * (x * cosine + y * sine)]
    }

    fn drift(&self, t: f64, [x, y]: &[f64; 2], [u, v]: &[f64; 2]) -> [f64; 1] {
        let (sine, cosine) = (self.rate * t).sin_cos();
        let turned = 2.0 * (u * cosine + v * sine);
        [self.rate * (turned - self.rate * (x * sine - y * cosine))]
    }
}

/// A skate on ice that turns at a constant rate and moves on a circle at constant speed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Skate;

impl Mechanism<3, 1> for Skate {
    type State = [f64; 6];

    const NAMES: &'static [&'static str] = &["blade"];

    fn masses(&self) -> [f64; 3] {
        [70.0, 70.0, 2.0]
    }

    fn positions(&self, _t: f64, _q: &[f64; 3]) -> [f64; 1] {
        [0.0]
    }

    fn jacobian(&self, _t: f64, [_, _, angle]: &[f64; 3]) -> [[f64; 3]; 1] {
        let (sine, cosine) = angle.sin_cos();
        [[sine, -cosine, 0.0]]
    }

    fn drift(&self, _t: f64, [_, _, angle]: &[f64; 3], [u, v, w]: &[f64; 3]) -> [f64; 1] {
        let (sine, cosine) = angle.sin_cos();
        [w * (u * cosine + v * sine)]
    }
}

/// Three equal cranks carry a coupler; one of the cranks is redundant. The coupler at (x, y, φ) is
/// pinned to cranks at the angles θ₁, θ₂, θ₃ about (−1, 0), (0, 0), (1, 0). The cranks swing
/// together like a pendulum. When they are aligned with the coupler, their motions may branch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parallelogram;

impl Parallelogram {
    pub(crate) const CRANK: f64 = 0.2;
    pub(crate) const COUPLER: f64 = 1.5;

    /// Returns the state in which all cranks have this angle and rate.
    pub(crate) fn state(angle: f64, rate: f64) -> [f64; 12] {
        let (sine, cosine) = angle.sin_cos();
        let (u, v) = (-rate * sine, rate * cosine);
        [angle, angle, angle, cosine, sine, 0.0, rate, rate, rate, u, v, 0.0]
    }
}

impl Mechanism<6, 6> for Parallelogram {
    type State = [f64; 12];

    const NAMES: &'static [&'static str] = &["x1", "y1", "x2", "y2", "x3", "y3"];

    fn masses(&self) -> [f64; 6] {
        [Self::CRANK, Self::CRANK, Self::CRANK, Self::COUPLER, Self::COUPLER, 0.4]
    }

    fn potential(&self, q: &[f64; 6]) -> f64 {
        9.81 * Self::COUPLER * q[4]
    }

    fn forces(&self, _q: &[f64; 6]) -> [f64; 6] {
        [0.0, 0.0, 0.0, 0.0, -9.81 * Self::COUPLER, 0.0]
    }

    fn positions(&self, _t: f64, [a, b, c, x, y, phi]: &[f64; 6]) -> [f64; 6] {
        let pin =
            |at: f64, angle: &f64| [x + at * phi.cos() - at - angle.cos(), y + at * phi.sin() - angle.sin()];
        let [[x1, y1], [x2, y2], [x3, y3]] = [pin(-1.0, a), pin(0.0, b), pin(1.0, c)];
        [x1, y1, x2, y2, x3, y3]
    }

    fn jacobian(&self, _t: f64, q: &[f64; 6]) -> [[f64; 6]; 6] {
        let mut rows = [[0.0; 6]; 6];
        for (k, at) in [-1.0, 0.0, 1.0].into_iter().enumerate() {
            let ((sine, cosine), (sine_phi, cosine_phi)) = (q[k].sin_cos(), q[5].sin_cos());
            (rows[2 * k][k], rows[2 * k][3], rows[2 * k][5]) = (sine, 1.0, -at * sine_phi);
            (rows[2 * k + 1][k], rows[2 * k + 1][4], rows[2 * k + 1][5]) = (-cosine, 1.0, at * cosine_phi);
        }
        rows
    }

    fn drift(&self, _t: f64, q: &[f64; 6], v: &[f64; 6]) -> [f64; 6] {
        let mut drift = [0.0; 6];
        for (k, at) in [-1.0, 0.0, 1.0].into_iter().enumerate() {
            let ((sine, cosine), (sine_phi, cosine_phi)) = (q[k].sin_cos(), q[5].sin_cos());
            let (square, square_phi) = (v[k] * v[k], v[5] * v[5]);
            drift[2 * k] = square * cosine - at * square_phi * cosine_phi;
            drift[2 * k + 1] = square * sine - at * square_phi * sine_phi;
        }
        drift
    }
}

/// A spherical pendulum of length one in Cartesian coordinates; its angular momentum about the
/// vertical is constant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spherical;

impl Spherical {
    pub(crate) fn angular_momentum(y: &[f64; 6]) -> f64 {
        y[0] * y[4] - y[1] * y[3]
    }
}

impl Mechanism<3, 1> for Spherical {
    type State = [f64; 6];

    const NAMES: &'static [&'static str] = &["rod"];

    fn masses(&self) -> [f64; 3] {
        [1.0; 3]
    }

    fn potential(&self, [_, _, z]: &[f64; 3]) -> f64 {
        9.81 * z
    }

    fn forces(&self, _q: &[f64; 3]) -> [f64; 3] {
        [0.0, 0.0, -9.81]
    }

    fn positions(&self, _t: f64, [x, y, z]: &[f64; 3]) -> [f64; 1] {
        [x * x + y * y + z * z - 1.0]
    }

    fn jacobian(&self, _t: f64, q: &[f64; 3]) -> [[f64; 3]; 1] {
        [q.map(|x| 2.0 * x)]
    }

    fn drift(&self, _t: f64, _q: &[f64; 3], [u, v, w]: &[f64; 3]) -> [f64; 1] {
        [2.0 * (u * u + v * v + w * w)]
    }
}
