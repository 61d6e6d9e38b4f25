//! Hand-written systems with constraints, for tests of methods that enforce them.

pub(crate) mod checks;
mod mechanisms;

use crate::linalg::pivoted::Matrix;
use crate::linalg::ranked::RankedFactors;
use crate::system::{
    CanonicalSystem, ConstraintValues, EnergyFunction, LeapfrogSystem, MechanicalSystem, OdeSystem,
    StateVector, join, split,
};

pub(in crate::integrate) use self::mechanisms::{
    Dragged, DrivenSlide, PlanePendulum, Sleigh, SphericalPendulum, ThreeCranks, TurningWire, TwoRods,
    on_sphere,
};

/// A Lagrangian ½ vᵀ M(q) v − V(q) with constraints.
pub(in crate::integrate) trait Mechanism<const N: usize> {
    type State: StateVector<f64>;

    fn mass(&self, q: &[f64; N]) -> [[f64; N]; N];

    /// Computes ∂L/∂q.
    fn rates(&self, q: &[f64; N], v: &[f64; N]) -> [f64; N];

    /// Computes dM/dt v.
    fn drift(&self, _q: &[f64; N], _v: &[f64; N]) -> [f64; N] {
        [0.0; N]
    }

    fn potential(&self, q: &[f64; N]) -> f64;

    fn constraints(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> ConstraintValues<f64, [f64; N]>;

    /// Returns the terms of the differentiated constraints other than A a.
    fn bend(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N];
}

/// A mechanism as a system.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct Pinned<L, const N: usize>(pub(in crate::integrate) L);

impl<L: Mechanism<N>, const N: usize> Pinned<L, N> {
    /// Computes x with M x = f + Aᵀμ and A x = d.
    fn solve(
        &self,
        q: &[f64; N],
        values: &ConstraintValues<f64, [f64; N]>,
        f: &[f64; N],
        d: &[f64; N],
    ) -> [f64; N] {
        let (mass, count) = (self.0.mass(q), values.count());
        let mut matrix = Matrix::<f64, [f64; 16]>::ZERO;
        let mut right = [0.0; 16];
        for i in 0..N {
            right[i] = f[i];
            for j in 0..N {
                matrix[(i, j)] = mass[i][j];
            }
        }
        for k in 0..count {
            right[N + k] = d[k];
            for j in 0..N {
                matrix[(N + k, j)] = values.row(k)[j];
                matrix[(j, N + k)] = values.row(k)[j];
            }
        }
        let factors = RankedFactors::new(matrix, N + count);
        factors.map_or([f64::NAN; N], |factors| {
            let solution = factors.solve(&right);
            core::array::from_fn(|i| solution[i])
        })
    }
}

impl<L: Mechanism<N>, const N: usize> OdeSystem for Pinned<L, N> {
    type Scalar = f64;
    type State = L::State;

    const IS_CONSTRAINED: bool = true;

    fn rhs(&self, t: f64, y: &L::State) -> L::State {
        let (q, v) = split::<Self>(y);
        join::<Self>(&v, &self.acceleration(t, &q, &v))
    }
}

impl<L: Mechanism<N>, const N: usize> MechanicalSystem for Pinned<L, N> {
    type Coordinates = [f64; N];
    type Velocities = [f64; N];
    type Columns<C> = crate::system::Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &["q"; N];

    fn acceleration(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        let (rates, drift, bend) = (self.0.rates(q, v), self.0.drift(q, v), self.0.bend(t, q, v));
        let values = self.0.constraints(t, q, v);
        self.solve(q, &values, &core::array::from_fn(|i| rates[i] - drift[i]), &bend.map(|bend| -bend))
    }

    fn position_rates(&self, _t: f64, _q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        *v
    }
}

impl<L: Mechanism<N>, const N: usize> CanonicalSystem for Pinned<L, N> {
    fn momenta(&self, _t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        Matrix::<_, [f64; N]>(self.0.mass(q)).apply(v)
    }

    fn momentum_rates(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        let (drift, a) = (self.0.drift(q, v), self.acceleration(t, q, v));
        let inertia = Matrix::<_, [f64; N]>(self.0.mass(q)).apply(&a);
        core::array::from_fn(|i| inertia[i] + drift[i])
    }

    fn mass_matrix(&self, _t: f64, q: &[f64; N], _v: &[f64; N]) -> [[f64; N]; N] {
        self.0.mass(q)
    }

    const SAYS_CONSTRAINTS: bool = true;

    fn free_momentum_rates(&self, _t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        self.0.rates(q, v)
    }

    fn constraint_values(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> ConstraintValues<f64, [f64; N]> {
        self.0.constraints(t, q, v)
    }
}

impl<L: Mechanism<N>, const N: usize> EnergyFunction for Pinned<L, N> {
    fn energy(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> f64 {
        let momenta = self.momenta(t, q, v);
        momenta.iter().zip(v).fold(0.0, |sum, (p, v)| sum + 0.5 * p * v) + self.0.potential(q)
    }
}

/// For mechanisms with a constant mass matrix.
impl<L: Mechanism<N>, const N: usize> LeapfrogSystem for Pinned<L, N> {
    const IS_HELD: bool = true;

    fn position_correction(&self, t: f64, q: &[f64; N], later: f64, to: &[f64; N]) -> [f64; N] {
        let residuals = self.0.constraints(later, to, &[0.0; N]).positions;
        let values = self.0.constraints(t, q, &[0.0; N]);
        self.solve(q, &values, &[0.0; N], &residuals.map(|residual| -residual))
    }

    fn velocity_correction(&self, t: f64, q: &[f64; N], v: &[f64; N]) -> [f64; N] {
        let values = self.0.constraints(t, q, v);
        self.solve(q, &values, &[0.0; N], &values.velocities.map(|residual| -residual))
    }
}
