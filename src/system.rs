//! Traits that emitted types implement, so that integrators and adapters take any of them.
//!
//! The traits hold what an algorithm needs of a system; everything else that is known about it stays an
//! inherent method of its type. Nothing here derives or integrates.

use core::fmt::Debug;

use crate::scalar::Scalar;

/// A vector whose length is part of its type, such as `[S; K]`.
pub trait StateVector<S>: Copy + Debug + AsRef<[S]> + AsMut<[S]> {}

impl<S: Scalar, const K: usize> StateVector<S> for [S; K] {}

/// A system of ordinary differential equations of first order, ẏ = f(t, y).
///
/// ```
/// use lagrange::system::OdeSystem;
///
/// /// ẏ = −λ y
/// struct Decay {
///     rate: f64,
/// }
///
/// impl OdeSystem for Decay {
///     type Scalar = f64;
///     type State = [f64; 1];
///
///     fn rhs(&self, _t: f64, y: &[f64; 1]) -> [f64; 1] {
///         [-self.rate * y[0]]
///     }
/// }
///
/// assert_eq!(Decay { rate: 2.0 }.rhs(0.0, &[3.0]), [-6.0]);
/// ```
pub trait OdeSystem {
    /// The number type.
    type Scalar: Scalar;
    /// The state y; for a mechanical system `[q…, v…]`, coordinates first.
    type State: StateVector<Self::Scalar>;

    /// The right-hand side f(t, y): the time derivative of the state `y` at time `t`.
    ///
    /// Where f is undefined, the result is not finite.
    fn rhs(&self, t: Self::Scalar, y: &Self::State) -> Self::State;
}

/// A system described by generalised coordinates q and their velocities v = q̇.
///
/// Its state is y = `[q…, v…]` and its right-hand side ẏ = `[v…, a…]`, with the accelerations a(t, q, v)
/// that solve d/dt ∂L/∂v − ∂L/∂q = Q.
pub trait MechanicalSystem: OdeSystem {
    /// A vector with one entry for each coordinate: coordinates, velocities or accelerations.
    type Coordinates: StateVector<Self::Scalar>;

    /// Names of the coordinates, in the order of the state.
    const COORDINATES: &'static [&'static str];

    /// The accelerations at time `t`, coordinates `q` and velocities `v`; not finite where the mass matrix
    /// is singular.
    fn acceleration(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> Self::Coordinates;
}

/// A mechanical system that knows its energy function h(q, v, t) = v · ∂L/∂v − L.
///
/// It changes by dh/dt = v · Q − ∂L/∂t, so that it is constant if L does not depend on time and the forces
/// Q do no work. It is the total energy T + V if T is homogeneous of degree two in v and V does not depend
/// on v; under moving constraints the two differ. Source: Goldstein, Poole, Safko, *Classical Mechanics*,
/// 3rd ed., §2.7.
pub trait EnergyFunction: MechanicalSystem {
    /// The energy function at time `t`, coordinates `q` and velocities `v`.
    fn energy(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Coordinates) -> Self::Scalar;
}
