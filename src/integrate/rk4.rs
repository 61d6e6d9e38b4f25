//! The classical Runge–Kutta method of order four.
//!
//! ```text
//!  0  |
//! 1/2 | 1/2
//! 1/2 |  0   1/2
//!  1  |  0    0    1
//! ----+--------------------
//!     | 1/6  1/3  1/3  1/6
//! ```
//!
//! Sources: Kutta 1901; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, §II.1,
//! table 1.2.

use crate::integrate::error::Cause;
use crate::integrate::fixed::{FixedStepper, Formula};
use crate::integrate::interpolation::cubic;
use crate::integrate::method::{Method, Work};
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StateVector};

/// The state after one step of length `h` from `y` at time `t`, by the classical Runge–Kutta method.
///
/// Evaluates the right-hand side four times; the error of a step is O(h⁵). A negative `h` steps backwards
/// in time. Nothing is checked: what is not finite is returned as it is.
#[inline]
pub fn rk4_step<M>(system: &M, t: M::Scalar, y: &M::State, h: M::Scalar) -> M::State
where
    M: OdeSystem + ?Sized,
{
    shifted(y, M::Scalar::ONE, &increment(system, t, y, h))
}

/// The classical Runge–Kutta method of order four in equal steps, for any system.
///
/// Four evaluations a step; not symplectic: the energy drifts in proportion to time and h⁵.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RungeKutta4<S> {
    /// Length of a step.
    pub step: S,
}

impl<M: OdeSystem + ?Sized> Method<M> for RungeKutta4<M::Scalar> {
    type Stepper = FixedStepper<M, Classical>;

    fn name(&self) -> &'static str {
        "Runge–Kutta 4"
    }

    fn order(&self) -> u32 {
        4
    }

    fn start(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self::Stepper, Cause<M::Scalar>> {
        FixedStepper::start(Classical, self.step, system, t, y, end)
    }
}

/// The formula of [`RungeKutta4`].
#[derive(Clone, Copy, Debug)]
pub struct Classical;

impl<M: OdeSystem + ?Sized> Formula<M> for Classical {
    #[inline]
    fn increment(
        &mut self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        h: M::Scalar,
        work: &mut Work,
    ) -> Result<M::State, Cause<M::Scalar>> {
        work.evaluations += 4;
        Ok(increment(system, t, y, h))
    }

    fn interpolate(
        &self,
        system: &M,
        from: (M::Scalar, &M::State),
        to: (M::Scalar, &M::State),
        t: M::Scalar,
    ) -> M::State {
        cubic(system, from, to, t)
    }
}

/// h (k₁ + 2 k₂ + 2 k₃ + k₄)/6
#[inline]
fn increment<M>(system: &M, t: M::Scalar, y: &M::State, h: M::Scalar) -> M::State
where
    M: OdeSystem + ?Sized,
{
    let two = M::Scalar::from_f64(2.0);
    let half = h / two;
    let k1 = system.rhs(t, y);
    let k2 = system.rhs(t + half, &shifted(y, half, &k1));
    let k3 = system.rhs(t + half, &shifted(y, half, &k2));
    let k4 = system.rhs(t + h, &shifted(y, h, &k3));
    let sixth = h / M::Scalar::from_f64(6.0);
    let mut increment = k1;
    let middle = k2.as_ref().iter().zip(k3.as_ref());
    for ((sum, (k2, k3)), k4) in increment.as_mut().iter_mut().zip(middle).zip(k4.as_ref()) {
        *sum = sixth * (*sum + two * (*k2 + *k3) + *k4);
    }
    increment
}

/// y + c k
#[inline]
fn shifted<S: Scalar, Y: StateVector<S>>(y: &Y, c: S, k: &Y) -> Y {
    let mut result = *y;
    for (y, k) in result.as_mut().iter_mut().zip(k.as_ref()) {
        *y = k.multiply_add(c, *y);
    }
    result
}

#[cfg(test)]
mod tests;
