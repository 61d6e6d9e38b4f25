//! Hand-written systems with momenta, for tests of methods that require them.

pub(crate) mod checks;

use crate::linalg::pivoted::{Factors, Matrix};
use crate::scalar::{Number, Scalar};
use crate::system::{
    CanonicalSystem, EnergyFunction, MechanicalSystem, OdeSystem, StateMatrix, StateVector, join, split,
};

/// A Lagrangian ½ vᵀ M(q) v + (linear terms in v) − V(q) in N coordinates.
pub(in crate::integrate) trait Lagrangian<const N: usize> {
    type Number: Scalar;
    type State: StateVector<Self::Number>;

    fn mass(&self, q: &[Self::Number; N], v: &[Self::Number; N]) -> [[Self::Number; N]; N];

    fn momenta(&self, _t: Self::Number, q: &[Self::Number; N], v: &[Self::Number; N]) -> [Self::Number; N] {
        Matrix::<_, [Self::Number; N]>(self.mass(q, v)).apply(v)
    }

    fn rates(&self, t: Self::Number, q: &[Self::Number; N], v: &[Self::Number; N]) -> [Self::Number; N];

    /// Returns the rates of momenta at constant velocities.
    fn drift(&self, t: Self::Number, q: &[Self::Number; N], v: &[Self::Number; N]) -> [Self::Number; N];

    fn potential(&self, q: &[Self::Number; N]) -> Self::Number;
}

/// A Lagrangian as a system. The Jacobian is computed by differences or unavailable.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct System<L, const N: usize> {
    lagrangian: L,
    knows_jacobian: bool,
}

/// Creates a system that provides its Jacobian.
pub(in crate::integrate) fn smooth<L: Lagrangian<N>, const N: usize>(lagrangian: L) -> System<L, N> {
    System { lagrangian, knows_jacobian: true }
}

/// Creates a system without its Jacobian.
pub(in crate::integrate) fn opaque<L: Lagrangian<N>, const N: usize>(lagrangian: L) -> System<L, N> {
    System { lagrangian, knows_jacobian: false }
}

impl<L: Lagrangian<N>, const N: usize> OdeSystem for System<L, N> {
    type Scalar = L::Number;
    type State = L::State;

    fn rhs(&self, t: L::Number, y: &L::State) -> L::State {
        let (q, v) = split::<Self>(y);
        join::<Self>(&v, &self.acceleration(t, &q, &v))
    }

    fn jacobian(&self, t: L::Number, y: &L::State) -> Option<StateMatrix<Self>> {
        let column = |j: usize| {
            let h = (L::Number::ONE + y.as_ref()[j].abs()) * L::Number::from_f64(1e-4);
            let (mut above, mut below) = (*y, *y);
            above.as_mut()[j] = y.as_ref()[j] + h;
            below.as_mut()[j] = y.as_ref()[j] - h;
            (self.rhs(t, &above), self.rhs(t, &below), h + h)
        };
        self.knows_jacobian.then(|| {
            let mut jacobian = Matrix::<L::Number, L::State>::ZERO;
            for j in 0..jacobian.rows() {
                let (above, below, distance) = column(j);
                for i in 0..jacobian.rows() {
                    jacobian[(i, j)] = (above.as_ref()[i] - below.as_ref()[i]) / distance;
                }
            }
            jacobian.0
        })
    }
}

impl<L: Lagrangian<N>, const N: usize> MechanicalSystem for System<L, N> {
    type Coordinates = [L::Number; N];
    type Velocities = [L::Number; N];
    type Columns<C> = crate::system::Unnamed<C>;

    const COORDINATES: &'static [&'static str] = &["q"; N];

    fn acceleration(&self, t: L::Number, q: &[L::Number; N], v: &[L::Number; N]) -> [L::Number; N] {
        let (rates, drift) = (self.lagrangian.rates(t, q, v), self.lagrangian.drift(t, q, v));
        let forcing = core::array::from_fn(|i| rates[i] - drift[i]);
        let factors = Factors::new(Matrix(self.lagrangian.mass(q, v)));
        factors.map_or([L::Number::NAN; N], |factors| factors.solve(&forcing))
    }

    fn position_rates(&self, _t: L::Number, _q: &[L::Number; N], v: &[L::Number; N]) -> [L::Number; N] {
        *v
    }
}

impl<L: Lagrangian<N>, const N: usize> CanonicalSystem for System<L, N> {
    fn momenta(&self, t: L::Number, q: &[L::Number; N], v: &[L::Number; N]) -> [L::Number; N] {
        self.lagrangian.momenta(t, q, v)
    }

    fn momentum_rates(&self, t: L::Number, q: &[L::Number; N], v: &[L::Number; N]) -> [L::Number; N] {
        self.lagrangian.rates(t, q, v)
    }

    fn mass_matrix(&self, _t: L::Number, q: &[L::Number; N], v: &[L::Number; N]) -> [[L::Number; N]; N] {
        self.lagrangian.mass(q, v)
    }
}

impl<L: Lagrangian<N>, const N: usize> EnergyFunction for System<L, N> {
    fn energy(&self, _t: L::Number, q: &[L::Number; N], v: &[L::Number; N]) -> L::Number {
        let momenta = Matrix::<_, [L::Number; N]>(self.lagrangian.mass(q, v)).apply(v);
        let double = momenta.iter().zip(v).fold(L::Number::ZERO, |sum, (p, v)| sum + *p * *v);
        double / L::Number::from_f64(2.0) + self.lagrangian.potential(q)
    }
}

/// Two unit masses on unit rods, with absolute angles from the rest position and g = 9.81.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct DoublePendulum;

impl Lagrangian<2> for DoublePendulum {
    type Number = f64;
    type State = [f64; 4];

    fn mass(&self, [a, b]: &[f64; 2], _v: &[f64; 2]) -> [[f64; 2]; 2] {
        let c = (a - b).cos();
        [[2.0, c], [c, 1.0]]
    }

    fn rates(&self, _t: f64, [a, b]: &[f64; 2], [u, w]: &[f64; 2]) -> [f64; 2] {
        let twist = (a - b).sin() * u * w;
        [-twist - 2.0 * 9.81 * a.sin(), twist - 9.81 * b.sin()]
    }

    fn drift(&self, _t: f64, [a, b]: &[f64; 2], [u, w]: &[f64; 2]) -> [f64; 2] {
        let rate = -(a - b).sin() * (u - w);
        [rate * w, rate * u]
    }

    fn potential(&self, [a, b]: &[f64; 2]) -> f64 {
        -9.81 * (2.0 * a.cos() + b.cos())
    }
}

/// A symmetric top about a fixed point; angles of precession, nutation and spin.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct HeavyTop;

impl HeavyTop {
    const ACROSS: f64 = 0.12;
    const AXIAL: f64 = 0.05;
    const WEIGHT: f64 = 1.1 * 9.81 * 0.25;
}

impl Lagrangian<3> for HeavyTop {
    type Number = f64;
    type State = [f64; 6];

    fn mass(&self, [_, theta, _]: &[f64; 3], _v: &[f64; 3]) -> [[f64; 3]; 3] {
        let (s, c) = theta.sin_cos();
        let coupled = Self::AXIAL * c;
        [
            [Self::ACROSS * s * s + coupled * c, 0.0, coupled],
            [0.0, Self::ACROSS, 0.0],
            [coupled, 0.0, Self::AXIAL],
        ]
    }

    fn rates(&self, _t: f64, [_, theta, _]: &[f64; 3], [phi, _, psi]: &[f64; 3]) -> [f64; 3] {
        let (s, c) = theta.sin_cos();
        let gyroscopic = Self::ACROSS * phi * c - Self::AXIAL * (psi + phi * c);
        [0.0, s * (gyroscopic * phi + Self::WEIGHT), 0.0]
    }

    fn drift(&self, _t: f64, [_, theta, _]: &[f64; 3], [phi, nutation, psi]: &[f64; 3]) -> [f64; 3] {
        let (s, c) = theta.sin_cos();
        let (axial, spin) = (Self::AXIAL * (psi + phi * c), -Self::AXIAL * phi * s * nutation);
        [s * nutation * (2.0 * Self::ACROSS * c * phi - axial) + c * spin, 0.0, spin]
    }

    fn potential(&self, [_, theta, _]: &[f64; 3]) -> f64 {
        Self::WEIGHT * theta.cos()
    }
}

/// The Kepler problem in polar coordinates with unit constants.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct Kepler;

impl Lagrangian<2> for Kepler {
    type Number = f64;
    type State = [f64; 4];

    fn mass(&self, [r, _]: &[f64; 2], _v: &[f64; 2]) -> [[f64; 2]; 2] {
        [[1.0, 0.0], [0.0, r * r]]
    }

    fn rates(&self, _t: f64, [r, _]: &[f64; 2], [_, w]: &[f64; 2]) -> [f64; 2] {
        [r * w * w - 1.0 / (r * r), 0.0]
    }

    fn drift(&self, _t: f64, [r, _]: &[f64; 2], [u, w]: &[f64; 2]) -> [f64; 2] {
        [0.0, 2.0 * r * u * w]
    }

    fn potential(&self, [r, _]: &[f64; 2]) -> f64 {
        -1.0 / r
    }
}

/// A unit mass on a spring of unit length and stiffness k, in polar coordinates with the angle from
/// the downward vertical and g = 9.81.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct SpringPendulum<S> {
    pub(in crate::integrate) stiffness: S,
}

macro_rules! spring_pendulum {
    ($number:ident) => {
        impl Lagrangian<2> for SpringPendulum<$number> {
            type Number = $number;
            type State = [$number; 4];

            fn mass(&self, [r, _]: &[$number; 2], _v: &[$number; 2]) -> [[$number; 2]; 2] {
                [[1.0, 0.0], [0.0, r * r]]
            }

            fn rates(&self, _t: $number, [r, angle]: &[$number; 2], [_, w]: &[$number; 2]) -> [$number; 2] {
                let (s, c) = angle.sin_cos();
                [r * w * w + 9.81 * c - self.stiffness * (r - 1.0), -9.81 * r * s]
            }

            fn drift(&self, _t: $number, [r, _]: &[$number; 2], [u, w]: &[$number; 2]) -> [$number; 2] {
                [0.0, 2.0 * r * u * w]
            }

            fn potential(&self, [r, angle]: &[$number; 2]) -> $number {
                self.stiffness * (r - 1.0) * (r - 1.0) / 2.0 - 9.81 * r * angle.cos()
            }
        }
    };
}

spring_pendulum!(f64);
spring_pendulum!(f32);

/// A pendulum of unit length and mass with g = 1, whose pivot oscillates vertically as `amplitude`
/// cos(`frequency` t).
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct ShakenPendulum {
    pub(in crate::integrate) amplitude: f64,
    pub(in crate::integrate) frequency: f64,
}

impl ShakenPendulum {
    fn pivot_rate(&self, t: f64) -> f64 {
        -self.amplitude * self.frequency * (self.frequency * t).sin()
    }
}

impl Lagrangian<1> for ShakenPendulum {
    type Number = f64;
    type State = [f64; 2];

    fn mass(&self, _q: &[f64; 1], _v: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }

    fn momenta(&self, t: f64, [angle]: &[f64; 1], [w]: &[f64; 1]) -> [f64; 1] {
        [w + self.pivot_rate(t) * angle.sin()]
    }

    fn rates(&self, t: f64, [angle]: &[f64; 1], [w]: &[f64; 1]) -> [f64; 1] {
        [w * self.pivot_rate(t) * angle.cos() - angle.sin()]
    }

    fn drift(&self, t: f64, [angle]: &[f64; 1], [w]: &[f64; 1]) -> [f64; 1] {
        let bend = -self.amplitude * self.frequency * self.frequency * (self.frequency * t).cos();
        [bend * angle.sin() + w * self.pivot_rate(t) * angle.cos()]
    }

    fn potential(&self, [angle]: &[f64; 1]) -> f64 {
        -angle.cos()
    }
}
