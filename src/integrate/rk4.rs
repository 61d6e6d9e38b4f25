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

use crate::integrate::compensated::Compensated;
use crate::integrate::error::IntegrationError;
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

/// Integrates from `y0` at `t0` to `t_end` in `steps` equal steps of the classical Runge–Kutta method and
/// returns the state at `t_end`, which may lie before `t0`.
///
/// `observe` is called with time and state at the start and after every step, `steps + 1` times in all.
/// Time k is t₀ + k (t_end − t₀)/steps and the last one `t_end` itself, so that times do not drift. The
/// global error is O(h⁴); increments are summed with compensation, so that rounding errors do not grow with
/// the number of steps.
///
/// # Errors
///
/// [`NotFinite`](IntegrationError::NotFinite) if `y0` or a step contains NaN or infinity; `observe` never
/// sees such a state. [`NoSteps`](IntegrationError::NoSteps) if `steps` is zero and `t_end` is not `t0`.
///
/// # Example
///
/// ```
/// use lagrange::integrate::rk4;
/// use lagrange::system::OdeSystem;
///
/// /// ẍ = −x
/// struct Oscillator;
///
/// impl OdeSystem for Oscillator {
///     type Scalar = f64;
///     type State = [f64; 2];
///
///     fn rhs(&self, _t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
///         [*v, -x]
///     }
/// }
///
/// let mut largest = 0.0_f64;
/// let [x, v] = rk4(&Oscillator, 0.0, [1.0, 0.0], 2.0, 1000, |_, [_, v]| largest = largest.max(v.abs()))?;
/// assert!((x - 2.0_f64.cos()).abs() < 1e-12);
/// assert!((v + 2.0_f64.sin()).abs() < 1e-12);
/// assert!((largest - 1.0).abs() < 1e-6);
/// # Ok::<(), lagrange::integrate::IntegrationError<f64, [f64; 2]>>(())
/// ```
pub fn rk4<M>(
    system: &M,
    t0: M::Scalar,
    y0: M::State,
    t_end: M::Scalar,
    steps: usize,
    mut observe: impl FnMut(M::Scalar, &M::State),
) -> Result<M::State, IntegrationError<M::Scalar, M::State>>
where
    M: OdeSystem + ?Sized,
{
    let span = t_end - t0;
    if steps == 0 && span != M::Scalar::ZERO {
        return Err(IntegrationError::NoSteps);
    }
    if !is_finite(&y0) {
        return Err(IntegrationError::NotFinite { time: t0, state: y0 });
    }
    observe(t0, &y0);
    let count = M::Scalar::from_f64(steps as f64);
    let h = span / count;
    let mut time = t0;
    let mut sum = Compensated::new(y0);
    for step in 1..=steps {
        let state = *sum.value();
        sum.add(&increment(system, time, &state, h));
        if !is_finite(sum.value()) {
            return Err(IntegrationError::NotFinite { time, state });
        }
        // The formula need not round to the end time in the last step.
        time = if step == steps { t_end } else { t0 + M::Scalar::from_f64(step as f64) * span / count };
        observe(time, sum.value());
    }
    Ok(*sum.value())
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

fn is_finite<S: Scalar, Y: StateVector<S>>(y: &Y) -> bool {
    y.as_ref().iter().all(|component| component.is_finite())
}

#[cfg(test)]
mod tests;
