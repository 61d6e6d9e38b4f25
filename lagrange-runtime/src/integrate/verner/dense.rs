//! The state within a step.

use super::interpolant::{
    BEND, STAGE_17, STAGE_18, STAGE_19, STAGE_20, STAGE_21, STAGE_22, STAGE_23, STAGE_24, STAGE_25,
};
use super::stage::RATES;
use super::tableau::ADVANCE;
use crate::linalg::vector::combined;
use crate::scalar::Number;
use crate::system::{OdeSystem, StateVector};

/// A step of length `h` from `y` at `t`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span<S, Y> {
    pub(super) t: S,
    pub(super) y: Y,
    pub(super) h: S,
}

/// The rates that the interpolant needs besides those of the step itself and the one at its end.
pub(super) fn complete<M>(system: &M, span: &Span<M::Scalar, M::State>, rates: &mut [M::State; RATES])
where
    M: OdeSystem + ?Sized,
{
    let Span { t, y, h } = span;
    macro_rules! rate {
        ($($index:literal: $stage:ident),*) => {
            $( rates[$index] = system.rhs($stage.time(*t, *h), &$stage.point(y, *h, rates)); )*
        };
    }
    rate!(
        17: STAGE_17, 18: STAGE_18, 19: STAGE_19, 20: STAGE_20, 21: STAGE_21, 22: STAGE_22, 23: STAGE_23,
        24: STAGE_24, 25: STAGE_25
    );
}

/// The state at the part `s` of the step, once its rates are complete.
pub(super) fn interpolate<S: Number, Y: StateVector<S>>(span: &Span<S, Y>, s: S, rates: &[Y; RATES]) -> Y {
    interpolated(span, s, rates)
}

/// The chord of the step at its part `s`, and its bend.
#[inline(always)]
pub(super) fn interpolated<S: Number, Y: StateVector<S>>(span: &Span<S, Y>, s: S, rates: &[Y; RATES]) -> Y {
    let (both, mut bend) = (s * (S::ONE - s), Y::ZERO);
    // Loops and no closures, which are not inlined into functions of other instructions than their own.
    for (rate, coefficients) in &BEND {
        let (value, _) = polynomial(coefficients, s);
        bend = combined(&bend, both * value, &rates[*rate]);
    }
    let chord = ADVANCE.weighted(rates);
    let mut y = span.y;
    for (y, (bend, chord)) in y.as_mut().iter_mut().zip(bend.as_ref().iter().zip(chord.as_ref())) {
        *y = *y + span.h * s.multiply_add(*chord, *bend);
    }
    y
}

/// By how much the rate of the interpolant at the part `s` of the step differs from that of the system at the state there.
pub(super) fn defect<M>(
    system: &M,
    span: &Span<M::Scalar, M::State>,
    s: M::Scalar,
    rates: &[M::State; RATES],
) -> M::State
where
    M: OdeSystem + ?Sized,
{
    defect_of(system.rhs(s.multiply_add(span.h, span.t), &interpolate(span, s, rates)), s, rates)
}

/// The same, given the rate of the system there.
#[inline(always)]
pub(super) fn defect_of<S: Number, Y: StateVector<S>>(rate: Y, s: S, rates: &[Y; RATES]) -> Y {
    let (one, two) = (S::ONE, S::from_f64(2.0));
    let mut bend = Y::ZERO;
    for (rate, coefficients) in &BEND {
        let (value, slope) = polynomial(coefficients, s);
        let weight = (one - two * s) * value + s * (one - s) * slope;
        bend = combined(&bend, weight, &rates[*rate]);
    }
    let chord = ADVANCE.weighted(rates);
    let mut defect = rate;
    for (defect, (bend, chord)) in defect.as_mut().iter_mut().zip(bend.as_ref().iter().zip(chord.as_ref())) {
        *defect = *chord + *bend - *defect;
    }
    defect
}

/// A polynomial about the middle of the step, at the part `s` of it, and its derivative there.
#[inline(always)]
fn polynomial<S: Number, const N: usize>(coefficients: &[f64; N], s: S) -> (S, S) {
    let two = S::from_f64(2.0);
    let x = two * s - S::ONE;
    let (mut value, mut slope) = (S::ZERO, S::ZERO);
    for coefficient in coefficients.iter().rev() {
        slope = slope.multiply_add(x, value);
        value = value.multiply_add(x, S::from_f64(*coefficient));
    }
    (value, two * slope)
}
