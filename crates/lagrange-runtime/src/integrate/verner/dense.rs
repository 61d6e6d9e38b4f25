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

/// Computes the rates that the interpolant needs in addition to those of the step and of its end.
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

/// Computes the state at the fraction `s` of the step, once its rates are complete.
pub(super) fn interpolate<S: Number, Y: StateVector<S>>(span: &Span<S, Y>, s: S, rates: &[Y; RATES]) -> Y {
    interpolated(span, s, rates)
}

/// Interpolates the state; always inlined.
#[inline(always)]
pub(super) fn interpolated<S: Number, Y: StateVector<S>>(span: &Span<S, Y>, s: S, rates: &[Y; RATES]) -> Y {
    let (both, mut bend) = (s * (S::ONE - s), span.y.zeros());
    // Loops instead of closures, which are not inlined into functions with different target
    // features.
    for (rate, coefficients) in &BEND {
        let (value, _) = polynomial(coefficients, s);
        bend = combined(&bend, both * value, &rates[*rate]);
    }
    bent(span, s, &bend, rates)
}

/// Computes the state at the fraction `s` of the step from the chord and this bend.
#[inline(always)]
fn bent<S: Number, Y: StateVector<S>>(span: &Span<S, Y>, s: S, bend: &Y, rates: &[Y; RATES]) -> Y {
    let (chord, mut y) = (ADVANCE.weighted(rates), span.y);
    for (y, (bend, chord)) in y.as_mut().iter_mut().zip(bend.as_ref().iter().zip(chord.as_ref())) {
        *y = *y + span.h * s.multiply_add(*chord, *bend);
    }
    y
}

/// Returns the difference between the rate of the interpolant at the fraction `s` of the step and
/// the rate of the system there.
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

/// Returns the same difference for a given rate of the system.
fn defect_of<S: Number, Y: StateVector<S>>(rate: Y, s: S, rates: &[Y; RATES]) -> Y {
    let (one, two) = (S::ONE, S::from_f64(2.0));
    let mut slope = rate.zeros();
    for (rate, coefficients) in &BEND {
        let (value, rise) = polynomial(coefficients, s);
        slope = combined(&slope, (one - two * s) * value + s * (one - s) * rise, &rates[*rate]);
    }
    beside(rate, &slope, rates)
}

/// Returns the differences between this rate and the slopes of the chord and of the bend.
#[inline(always)]
fn beside<S: Number, Y: StateVector<S>>(rate: Y, slope: &Y, rates: &[Y; RATES]) -> Y {
    let (chord, mut defect) = (ADVANCE.weighted(rates), rate);
    for (defect, (bend, chord)) in defect.as_mut().iter_mut().zip(slope.as_ref().iter().zip(chord.as_ref())) {
        *defect = *chord + *bend - *defect;
    }
    defect
}

/// A fixed fraction of every step, with precomputed weights of rates in the bend and in its slope.
/// It requires no polynomials at run time.
pub(super) struct FixedPart {
    pub(super) s: f64,
    bend: [f64; BEND.len()],
    slope: [f64; BEND.len()],
}

impl FixedPart {
    pub(super) const fn new(s: f64) -> Self {
        let (mut bend, mut slope) = ([0.0; BEND.len()], [0.0; BEND.len()]);
        let (x, mut index) = (2.0 * s - 1.0, 0);
        while index < BEND.len() {
            let (_, coefficients) = &BEND[index];
            let (mut value, mut rise, mut power) = (0.0, 0.0, coefficients.len());
            while power > 0 {
                power -= 1;
                rise = rise * x + value;
                value = value * x + coefficients[power];
            }
            bend[index] = s * (1.0 - s) * value;
            slope[index] = (1.0 - 2.0 * s) * value + s * (1.0 - s) * 2.0 * rise;
            index += 1;
        }
        FixedPart { s, bend, slope }
    }

    /// Returns the state there.
    #[inline(always)]
    pub(super) fn state<S: Number, Y: StateVector<S>>(&self, span: &Span<S, Y>, rates: &[Y; RATES]) -> Y {
        bent(span, S::from_f64(self.s), &weighted_bend(&self.bend, rates), rates)
    }

    /// Returns the difference between the rate of the interpolant and that of the system there.
    #[inline(always)]
    pub(super) fn defect<S: Number, Y: StateVector<S>>(&self, rate: Y, rates: &[Y; RATES]) -> Y {
        beside(rate, &weighted_bend(&self.slope, rates), rates)
    }
}

/// Computes a weighted sum of the rates in the bend.
#[inline(always)]
fn weighted_bend<S: Number, Y: StateVector<S>>(weights: &[f64; BEND.len()], rates: &[Y; RATES]) -> Y {
    let mut sum = rates[0].zeros();
    for ((rate, _), weight) in BEND.iter().zip(weights) {
        sum = combined(&sum, S::from_f64(*weight), &rates[*rate]);
    }
    sum
}

/// Evaluates a polynomial about the middle of the step and its derivative, at the fraction `s` of
/// the step.
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

#[cfg(test)]
mod tests {
    use super::{FixedPart, RATES, Span, defect_of, interpolated};

    #[test]
    fn weights_of_a_fixed_part_are_those_of_the_polynomials() {
        let span = Span { t: 0.0, y: [1.0_f64], h: 0.5 };
        let rates: [[f64; 1]; RATES] = core::array::from_fn(|rate| [libm::sin(rate as f64)]);
        for s in [0.1, 0.34, 0.94] {
            let part = FixedPart::new(s);
            let [state, defect] =
                [part.state(&span, &rates), part.defect([2.0], &rates)].map(|[value]| value);
            let [expected] = interpolated(&span, s, &rates);
            assert!((state - expected).abs() < 1e-13, "{s}: {state} {expected}");
            let [expected] = defect_of([2.0], s, &rates);
            assert!((defect - expected).abs() < 1e-12, "{s}: {defect} {expected}");
        }
    }
}
