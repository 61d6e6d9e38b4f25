//! States within a step, from what is known at its ends.
//!
//! Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, §II.6.

use crate::scalar::Scalar;
use crate::system::{OdeSystem, StateVector};

/// Cubic Hermite interpolation: states and rates at both ends. The error is O(h⁴).
pub(super) fn cubic<M: OdeSystem + ?Sized>(
    system: &M,
    (t0, y0): (M::Scalar, &M::State),
    (t1, y1): (M::Scalar, &M::State),
    t: M::Scalar,
) -> M::State {
    let (one, two) = (M::Scalar::ONE, M::Scalar::from_f64(2.0));
    let h = t1 - t0;
    let s = (t - t0) / h;
    let (f0, f1) = (system.rhs(t0, y0), system.rhs(t1, y1));
    let mut y = M::State::ZERO;
    let ends = y0.as_ref().iter().zip(y1.as_ref());
    let rates = f0.as_ref().iter().zip(f1.as_ref());
    for ((y, (y0, y1)), (f0, f1)) in y.as_mut().iter_mut().zip(ends).zip(rates) {
        let change = *y1 - *y0;
        let bend = (one - two * s) * change + (s - one) * h * *f0 + s * h * *f1;
        *y = *y0 + s * change + s * (s - one) * bend;
    }
    y
}
