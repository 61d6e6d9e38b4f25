//! The state within a step.

use super::interpolant::{
    BEND, STAGE_17, STAGE_18, STAGE_19, STAGE_20, STAGE_21, STAGE_22, STAGE_23, STAGE_24, STAGE_25,
};
use super::stage::{RATES, weighted};
use super::tableau::ADVANCE;
use crate::scalar::Scalar;
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

/// The state at the part `s` of the step, once its rates are complete: the chord and its bend.
pub(super) fn interpolate<S, Y>(span: &Span<S, Y>, s: S, rates: &[Y; RATES]) -> Y
where
    S: Scalar,
    Y: StateVector<S>,
{
    let (one, two) = (S::ONE, S::from_f64(2.0));
    let (x, both) = (two * s - one, s * (one - s));
    let bend = BEND.map(|(rate, coefficients)| {
        let value = coefficients.iter().rev().fold(S::ZERO, |sum, c| sum.multiply_add(x, S::from_f64(*c)));
        (rate, both * value)
    });
    let (bend, chord) = (weighted(rates, bend), ADVANCE.weighted(rates));
    let mut y = span.y;
    for (y, (bend, chord)) in y.as_mut().iter_mut().zip(bend.as_ref().iter().zip(chord.as_ref())) {
        *y = *y + span.h * s.multiply_add(*chord, *bend);
    }
    y
}
