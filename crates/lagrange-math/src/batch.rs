//! Several angles at a time.

use crate::angle;
use crate::fused::HAS_FUSED;
use crate::precise;

/// Angles up to this magnitude are reduced together, in radians; larger ones one by one, in
/// integers.
pub const LARGEST_ANGLE: f64 = 1e5;

/// Computes the sine and the cosine of each angle, in radians.
///
/// The error is below 0.9 units in the last place for angles of any size, whether or not products
/// are fused. The result for an angle does not depend on the other angles. It is the same on every
/// platform that fuses products, and on every platform that does not. Zeros keep their sign; the
/// result for infinity and NaN is NaN.
///
/// ```
/// use lagrange_math::sin_cos_each;
///
/// let [(sin_a, cos_a), (sin_b, _)] = sin_cos_each([0.0, 0.5]);
/// assert_eq!((sin_a, cos_a), (0.0, 1.0));
/// assert!((sin_b - 0.5_f64.sin()).abs() < 1e-15);
/// ```
#[inline(always)]
#[must_use]
pub fn sin_cos_each<const N: usize>(angles: [f64; N]) -> [(f64, f64); N] {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    formulas(angle::sin_cos::<HAS_FUSED>, &angles, &mut sines, &mut cosines);
    if !are_small(&angles) {
        replace_large(angle::sin_cos_large, &angles, &mut sines, &mut cosines);
    }
    zipped(sines, cosines)
}

/// Computes the sines and the cosines of all angles, with or without fused products, regardless of
/// the target. It serves callers that detect the processor's instructions at run time and compile
/// this function for them. Results and errors are those of [`sin_cos_each`], which chooses
/// according to the target.
///
/// ```
/// use lagrange_math::sines_and_cosines;
///
/// let ([sine, _], [_, cosine]) = sines_and_cosines::<true, 2>([0.5, 0.0]);
/// assert_eq!(cosine, 1.0);
/// assert!((sine - 0.5_f64.sin()).abs() < 1e-15);
/// ```
#[inline(always)]
#[must_use]
pub fn sines_and_cosines<const FUSED: bool, const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    sine_and_cosine_of_each(angle::sin_cos::<FUSED>, angle::sin_cos_large, angles)
}

/// Computes the sines and the cosines of all angles without fused products. The error is below 0.55
/// units in the last place for angles of any size.
///
/// The result for an angle has the same bits on every platform and does not depend on the other
/// angles. Zeros keep their sign; the result for infinity and NaN is NaN.
///
/// ```
/// use lagrange_math::precise_sines_and_cosines;
///
/// let ([sine], [cosine]) = precise_sines_and_cosines([1e22]);
/// assert!((sine + 0.852_200_849_767_188_8).abs() < 1e-15);
/// assert!((cosine - 0.523_214_785_395_138_9).abs() < 1e-15);
/// ```
#[inline(always)]
#[must_use]
pub fn precise_sines_and_cosines<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    sine_and_cosine_of_each(precise::sin_cos, precise::sin_cos_large, angles)
}

#[inline(always)]
fn sine_and_cosine_of_each<const N: usize>(
    formula: impl Fn(f64) -> (f64, f64),
    of_large: fn(f64) -> (f64, f64),
    angles: [f64; N],
) -> ([f64; N], [f64; N]) {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    formulas(formula, &angles, &mut sines, &mut cosines);
    if !are_small(&angles) {
        // Copies are passed, so that the originals stay out of memory if no call is needed.
        let (lent, mut lent_sines, mut lent_cosines) = (angles, sines, cosines);
        replace_large(of_large, &lent, &mut lent_sines, &mut lent_cosines);
        return (lent_sines, lent_cosines);
    }
    (sines, cosines)
}

/// Computes sines and cosines of small angles; results for others are meaningless. Separate arrays
/// keep all sines, and all cosines, contiguous for vector instructions.
#[inline(always)]
fn formulas<const N: usize>(
    formula: impl Fn(f64) -> (f64, f64),
    angles: &[f64; N],
    sines: &mut [f64; N],
    cosines: &mut [f64; N],
) {
    let [eights, twos] = const { cuts(N) };
    for range in [0..eights, eights..twos, twos..N] {
        for i in range {
            (sines[i], cosines[i]) = formula(angles[i]);
        }
    }
}

#[inline(always)]
fn are_small(angles: &[f64]) -> bool {
    angles.iter().fold(true, |all, angle| all & is_small(*angle))
}

/// Combines both arrays by value. Compilers can then prove that the result does not alias arrays
/// passed to a call, and keep it out of memory.
#[inline(always)]
fn zipped<const N: usize>(sines: [f64; N], cosines: [f64; N]) -> [(f64, f64); N] {
    core::array::from_fn(|i| (sines[i], cosines[i]))
}

/// Computes sines and cosines in single precision, as rounded results of double precision. The
/// error is below 0.5000001 units in the last place for angles of any size.
#[inline(always)]
#[must_use]
pub fn sin_cos_each_f32<const N: usize>(angles: [f32; N]) -> [(f32, f32); N] {
    sin_cos_each(angles.map(f64::from)).map(|(sine, cosine)| (sine as f32, cosine as f32))
}

/// Computes [`sines_and_cosines`] in single precision, with results and errors of
/// [`sin_cos_each_f32`].
#[inline(always)]
#[must_use]
pub fn sines_and_cosines_f32<const FUSED: bool, const N: usize>(angles: [f32; N]) -> ([f32; N], [f32; N]) {
    let mut doubles = [0.0; N];
    for i in 0..N {
        doubles[i] = f64::from(angles[i]);
    }
    let (sines, cosines) = sines_and_cosines::<FUSED, N>(doubles);
    let mut singles = ([0.0; N], [0.0; N]);
    for i in 0..N {
        (singles.0[i], singles.1[i]) = (sines[i] as f32, cosines[i] as f32);
    }
    singles
}

/// Returns the boundaries between loops, so that compilers unroll short ones and vectorise long
/// ones. Without them, an odd number of angles costs up to 50 % more.
const fn cuts(count: usize) -> [usize; 2] {
    if count < 4 { [0, count] } else { [count - count % 8, count - count % 2] }
}

/// True for magnitudes up to [`LARGEST_ANGLE`]; false for NaN.
#[inline(always)]
fn is_small(angle: f64) -> bool {
    angle.abs() <= LARGEST_ANGLE
}

/// Replaces results for large angles. A single call for all angles needs a single branch in the
/// common case.
#[cold]
#[inline(never)]
fn replace_large(of_large: fn(f64) -> (f64, f64), angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    for ((angle, sine), cosine) in angles.iter().zip(sines).zip(cosines) {
        if !is_small(*angle) {
            (*sine, *cosine) = of_large(*angle);
        }
    }
}
