//! The methods on hand-written systems.

mod constrained;
mod order;
mod refusals;
mod structure;

use crate::integrate::Method;
use crate::run::integrate;
use crate::scalar::Scalar;
use crate::system::{MechanicalSystem, OdeSystem, SeparableSystem, Unnamed};

/// The system q̈ = a(t, q) with N coordinates, in any scalar type.
struct Force<S, const N: usize, const TWICE: usize> {
    acceleration: fn(S, &[S; N]) -> [S; N],
}

impl<S: Scalar, const N: usize, const TWICE: usize> OdeSystem for Force<S, N, TWICE> {
    type Scalar = S;
    type State = [S; TWICE];

    fn rhs(&self, t: S, y: &[S; TWICE]) -> [S; TWICE] {
        let q = core::array::from_fn(|i| y[i]);
        let a = (self.acceleration)(t, &q);
        core::array::from_fn(|i| if i < N { y[N + i] } else { a[i - N] })
    }
}

impl<S: Scalar, const N: usize, const TWICE: usize> MechanicalSystem for Force<S, N, TWICE> {
    type Coordinates = [S; N];
    type Velocities = [S; N];
    type Columns<C> = Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &["x", "y", "z", "u"];

    fn acceleration(&self, t: S, q: &[S; N], _v: &[S; N]) -> [S; N] {
        (self.acceleration)(t, q)
    }

    fn position_rates(&self, _t: S, _q: &[S; N], v: &[S; N]) -> [S; N] {
        *v
    }
}

impl<S: Scalar, const N: usize, const TWICE: usize> SeparableSystem for Force<S, N, TWICE> {}

const OSCILLATOR: Force<f64, 1, 2> = Force { acceleration: |_, [x]| [-x] };
const PENDULUM: Force<f64, 1, 2> = Force { acceleration: |_, [x]| [-x.sin()] };
/// A driven oscillator close to its resonance; from (0, 0) the solution is (cos t − cos 2t)/3.
const DRIVEN: Force<f64, 1, 2> = Force { acceleration: |t, [x]| [t.cos() - 4.0 * x] };
const KEPLER: Force<f64, 2, 4> = Force {
    acceleration: |_, [x, y]| {
        let cube = x.hypot(*y).powi(3);
        [-x / cube, -y / cube]
    },
};
const HENON_HEILES: Force<f64, 2, 4> =
    Force { acceleration: |_, [x, y]| [-x - 2.0 * x * y, -y - x * x + y * y] };

/// Returns the state at `end` from `start` at time zero.
fn run<M, K>(system: &M, start: M::State, end: f64, method: &K) -> M::State
where
    M: OdeSystem<Scalar = f64>,
    K: Method<M>,
{
    integrate(system, 0.0, start, end, method, |_, _| {}).expect("an ordinary motion")
}

/// Returns the largest difference of two states.
fn difference<const K: usize>(a: &[f64; K], b: &[f64; K]) -> f64 {
    a.iter().zip(b).fold(0.0, |largest, (a, b)| largest.max((a - b).abs()))
}
