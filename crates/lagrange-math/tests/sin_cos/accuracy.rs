//! Dense sweeps: every scale, and every neighbourhood where errors are likely.

use std::f64::consts::FRAC_PI_4;

use lagrange_math::{LARGEST_ANGLE, precise_sines_and_cosines, sin_cos_each, sin_cos_each_f32};

use crate::double_double::{DoubleDouble, error_in_ulps, sin_cos};

/// Sine and cosine of an angle.
type SineAndCosine = fn(f64) -> (f64, f64);

/// The functions of one angle, with bounds on their errors in units in the last place.
pub(crate) const FUNCTIONS: [(SineAndCosine, f64); 2] = [(fast, 0.9), (precise, 0.55)];

pub(crate) fn fast(angle: f64) -> (f64, f64) {
    sin_cos_each([angle])[0]
}

pub(crate) fn precise(angle: f64) -> (f64, f64) {
    let ([sine], [cosine]) = precise_sines_and_cosines([angle]);
    (sine, cosine)
}

/// Returns the larger of both errors, in units in the last place.
pub(crate) fn error((sine, cosine): (f64, f64), exact: (DoubleDouble, DoubleDouble)) -> f64 {
    error_in_ulps(sine, exact.0).max(error_in_ulps(cosine, exact.1))
}

const SAMPLES: usize = 100_000;

/// A fixed sequence of 64-bit numbers (S. Vigna's SplitMix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Draws a number between 0 and 1.
    pub(crate) fn fraction(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2.0_f64.powi(-53)
    }
}

#[track_caller]
fn assert_bounded(angles: impl Iterator<Item = f64>) {
    let mut largest = [(0.0, 0.0); FUNCTIONS.len()];
    for angle in angles.filter(|angle| angle.abs() <= LARGEST_ANGLE) {
        let exact = sin_cos(angle);
        for ((function, _), largest) in FUNCTIONS.iter().zip(&mut largest) {
            let error = error(function(angle), exact);
            if error > largest.0 {
                *largest = (error, angle);
            }
        }
    }
    println!("{largest:?}");
    for ((_, bound), (error, angle)) in FUNCTIONS.iter().zip(largest) {
        assert!(error > 0.0 && error <= *bound, "{error} at {angle:e}");
    }
}

#[test]
fn uniform_angles_are_within_the_bound() {
    let mut random = Random(1);
    for scale in [1.0, 10.0, 1e3, LARGEST_ANGLE] {
        assert_bounded((0..SAMPLES / 4).map(|_| scale * (2.0 * random.fraction() - 1.0)));
    }
}

#[test]
fn angles_of_every_magnitude_are_within_the_bound() {
    let mut random = Random(2);
    let largest = LARGEST_ANGLE.to_bits();
    assert_bounded((0..SAMPLES).map(|_| f64::from_bits(random.bits() % (largest + 1))));
}

#[test]
fn angles_at_all_multiples_of_a_quarter_turn_and_between_are_within_the_bound() {
    let eighths = (LARGEST_ANGLE / FRAC_PI_4) as u32;
    for neighbour in [-2_i64, -1, 0, 1, 2] {
        let at = |k: u32| f64::from_bits((f64::from(k) * FRAC_PI_4).to_bits().wrapping_add_signed(neighbour));
        assert_bounded((1..=eighths).map(at));
    }
}

#[test]
fn angles_up_to_the_largest_are_within_the_bound() {
    let largest = LARGEST_ANGLE.to_bits();
    assert_bounded((0..1000).map(|k| f64::from_bits(largest - k)));
}

#[test]
fn single_precision_is_rounded_once() {
    let mut random = Random(3);
    let (mut largest, limit) = (0.0_f64, (LARGEST_ANGLE as f32).to_bits());
    for _ in 0..SAMPLES {
        let angle = f32::from_bits((random.bits() % u64::from(limit + 1)) as u32);
        let ([(sine, cosine)], exact) = (sin_cos_each_f32([angle]), sin_cos(f64::from(angle)));
        for (found, exact) in [(sine, exact.0), (cosine, exact.1)] {
            let error = (f64::from(found) - exact.0).abs() / single_unit_in_last_place(exact.0);
            largest = largest.max(error);
        }
    }
    assert!(largest > 0.49 && largest <= 0.500_000_1, "{largest}");
}

fn single_unit_in_last_place(x: f64) -> f64 {
    let exponent = ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023;
    2.0_f64.powi(exponent.max(-126) - 23)
}
