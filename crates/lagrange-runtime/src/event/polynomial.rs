//! The behaviour of a function along a piece of a step, as described by a polynomial through some
//! of its values.
//!
//! Values at Chebyshev points give a polynomial of degree eight. Its last Chebyshev coefficients
//! indicate its accuracy. Its Bernstein coefficients enclose it, so parts of the piece without a
//! change of sign are recognised. Other parts are halved until the sign changes once or they are
//! too small to decide. Sources: Trefethen, *Approximation Theory and Approximation Practice*, §3,
//! §8; Farouki, "The Bernstein polynomial basis: a centennial retrospective", *Computer Aided
//! Geometric Design* 29 (2012) 379–419, §5.

use crate::scalar::Scalar;
use crate::tolerance::BERNSTEIN_COEFFICIENT;

/// The degree of polynomials.
const DEGREE: usize = 8;
/// Number of values of a polynomial.
pub(super) const POINTS: usize = DEGREE + 1;
/// cos(π k/8) for k from 0 to 4.
const COSINES: [f64; 5] =
    [1.0, 0.923_879_532_511_286_7, core::f64::consts::FRAC_1_SQRT_2, 0.382_683_432_365_089_8, 0.0];
/// Bernstein coefficients of Chebyshev polynomials: row j, column k holds coefficient j of the
/// polynomial of degree k.
const BERNSTEIN: [[f64; POINTS]; POINTS] = bernstein();
/// Ratio of the estimated error to the last two Chebyshev coefficients, which represent the
/// truncated ones.
const CUT_OFF: f64 = 4.0;
/// A polynomial is trusted if its last two Chebyshev coefficients are below this fraction of its
/// largest value.
const TRUSTED: f64 = 1e-3;
/// Minimum part of a piece in the search for a change of sign; two roundings if that is larger.
const NARROWEST: f64 = 1e-12;
/// Assumed error of a polynomial that is not trusted, relative to its largest value.
const DOUBT: f64 = 0.25;
/// Factor by which noise in the values affects the slope at an end more than the last Chebyshev
/// coefficients.
const NOISE: f64 = 64.0;
/// A function counts as at rest if its values change by less than this fraction of the largest one.
const AT_REST: f64 = 1e-9;

/// Returns the points of a piece at which functions are evaluated: Chebyshev points of the second
/// kind.
pub(super) fn points<S: Scalar>() -> [S; POINTS] {
    core::array::from_fn(|j| S::from_f64(0.5 - 0.5 * cosine(j)))
}

/// A polynomial on the unit interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polynomial<S> {
    bernstein: [S; POINTS],
    scale: S,
    /// Rounding error, and truncation error below.
    rounding: S,
    cut_off: S,
}

/// The change of sign of a polynomial.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum SignChange<S> {
    /// No change.
    Nowhere,
    /// Between these points, and only once unless values are close to zero.
    Between(S, S),
    /// Undecided: the polynomial comes or ends closer to zero than its error.
    Unclear,
}

impl<S: Scalar> Polynomial<S> {
    /// Creates the polynomial with these values at [`points`].
    pub(super) fn new(values: &[S; POINTS]) -> Self {
        let chebyshev = chebyshev(values);
        let mut bernstein = [S::ZERO; POINTS];
        for (entry, row) in bernstein.iter_mut().zip(&BERNSTEIN) {
            let terms = row.iter().zip(chebyshev);
            *entry = terms.fold(S::ZERO, |sum, (weight, c)| c.multiply_add(S::from_f64(*weight), sum));
        }
        let scale = values.iter().fold(S::ZERO, |scale, value| scale.max(value.abs()));
        let rounding = BERNSTEIN_COEFFICIENT.part::<S>() * scale;
        let cut_off = S::from_f64(CUT_OFF) * (chebyshev[DEGREE - 1].abs() + chebyshev[DEGREE].abs());
        Polynomial { bernstein, scale, rounding, cut_off }
    }

    /// True if its changes of sign can be trusted.
    pub(super) fn is_trusted(&self) -> bool {
        self.cut_off <= S::from_f64(CUT_OFF * TRUSTED) * self.scale
    }

    /// True if it is as accurate as the values.
    pub(super) fn is_exact(&self) -> bool {
        self.cut_off <= self.rounding
    }

    /// Returns the rise of the function at the start of the piece towards numbers of the sign of
    /// `sign`, over the whole piece. Zero if it may be noise, or is below the gain of a motion that
    /// starts at rest.
    pub(super) fn rise(&self, sign: S) -> S {
        let rise = sign.sign() * (self.bernstein[1] - self.bernstein[0]);
        let at_rest = S::from_f64(AT_REST).max(BERNSTEIN_COEFFICIENT.part::<S>()) * self.scale;
        let noise = self.rounding + S::from_f64(NOISE) * self.cut_off + at_rest;
        if rise > noise { S::from_f64(DEGREE as f64) * rise } else { S::ZERO }
    }

    fn error(&self) -> S {
        let cut_off =
            if self.is_trusted() { self.cut_off } else { self.cut_off.max(S::from_f64(DOUBT) * self.scale) };
        self.rounding + cut_off
    }

    /// Returns the next change, from the place `x` on, to the sign opposite to that of `sign`.
    ///
    /// `is_zero` is true if the zero at `x` is already known; it is then ignored if the polynomial
    /// can be trusted.
    pub(super) fn next_change(&self, sign: S, mut x: S, is_zero: bool) -> SignChange<S> {
        let (error, half) = (self.error(), S::from_f64(0.5));
        // Half of two roundings of one still leads on from every place.
        let narrowest = S::from_f64(NARROWEST).max(S::epsilon() + S::epsilon());
        let is_known = is_zero || self.part(sign, x, S::ONE)[0].abs() <= self.rounding;
        let mut was_clear = !(is_known && self.is_trusted());
        let (mut width, mut is_near, mut is_unclear) = (S::ONE - x, false, false);
        let mut clear = x;
        while x < S::ONE {
            let part = self.part(sign, x, x + width);
            let is_last = part.iter().all(|b| b.abs() <= error) || width <= narrowest;
            if part.iter().all(|b| *b > error) {
                is_unclear |= was_clear && is_near;
                (was_clear, is_near, clear) = (true, false, x + width);
            } else if part[DEGREE] < -error
                && changes(&part, error) <= 1
                && (is_steady(&part) || self.is_exact())
            {
                let is_certain = !is_unclear || self.is_exact();
                return if is_certain { SignChange::Between(clear, x + width) } else { SignChange::Unclear };
            } else if is_last {
                // What turns so near to zero may hide two zeros, even behind a known one.
                is_unclear |= !is_steady(&part);
                is_near = true;
            } else {
                width = half * width;
                continue;
            }
            x = x + width;
            width = (width + width).min(S::ONE - x);
        }
        if is_unclear || is_near { SignChange::Unclear } else { SignChange::Nowhere }
    }

    /// Returns the Bernstein coefficients on a part of the unit interval, negated if `sign` is
    /// negative.
    fn part(&self, sign: S, from: S, to: S) -> [S; POINTS] {
        let mut part = if sign > S::ZERO { self.bernstein } else { self.bernstein.map(|b| -b) };
        if from == S::ZERO && to == S::ONE {
            return part;
        }
        // De Casteljau's scheme: first cut off the part before `from`, then the part after `to`.
        if from > S::ZERO {
            for round in 1..POINTS {
                for j in 0..POINTS - round {
                    part[j] = part[j] + from * (part[j + 1] - part[j]);
                }
            }
        }
        let end = (to - from) / (S::ONE - from);
        for round in 1..POINTS {
            for j in (round..POINTS).rev() {
                part[j] = part[j - 1] + end * (part[j] - part[j - 1]);
            }
        }
        part
    }
}

/// True if the coefficients, and hence the polynomial, are monotonic.
fn is_steady<S: Scalar>(part: &[S; POINTS]) -> bool {
    part.windows(2).all(|pair| pair[0] <= pair[1]) || part.windows(2).all(|pair| pair[0] >= pair[1])
}

/// Counts the changes of sign of the coefficients, ignoring those within the error.
fn changes<S: Scalar>(part: &[S; POINTS], error: S) -> u32 {
    let (mut changes, mut last) = (0, S::ZERO);
    for b in part.iter().filter(|b| b.abs() > error) {
        if last * *b < S::ZERO {
            changes += 1;
        }
        last = b.sign();
    }
    changes
}

/// Computes cos(π k/8).
const fn cosine(k: usize) -> f64 {
    match k % 16 {
        k @ 0..=4 => COSINES[k],
        k @ 5..=8 => -COSINES[8 - k],
        k @ 9..=12 => -COSINES[k - 8],
        k => COSINES[16 - k],
    }
}

/// Computes the Chebyshev coefficients of the polynomial with these values at [`points`], which are
/// −cos(π j/8) on the interval from −1 to 1.
fn chebyshev<S: Scalar>(values: &[S; POINTS]) -> [S; POINTS] {
    let mut coefficients = [S::ZERO; POINTS];
    for (k, coefficient) in coefficients.iter_mut().enumerate() {
        let mut sum = S::ZERO;
        for (j, value) in values.iter().enumerate() {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let end = if j == 0 || j == DEGREE { 0.5 } else { 1.0 };
            sum = value.multiply_add(S::from_f64(sign * end * cosine(j * k)), sum);
        }
        let share = if k == 0 || k == DEGREE { 1.0 } else { 2.0 };
        *coefficient = sum * S::from_f64(share / DEGREE as f64);
    }
    coefficients
}

/// Computes, on the unit interval, Σᵢ (−1)^(k−i) C(2k, 2i) C(n−k, j−i)/C(n, j). Source: Farouki,
/// §5.3; Rababah, "Transformation of Chebyshev–Bernstein polynomial basis", *Computational Methods
/// in Applied Mathematics* 3 (2003) 608–622.
const fn bernstein() -> [[f64; POINTS]; POINTS] {
    let mut table = [[0.0; POINTS]; POINTS];
    let mut j = 0;
    while j < POINTS {
        let mut k = 0;
        while k < POINTS {
            let mut i = 0;
            while i <= k && i <= j {
                if j - i <= DEGREE - k {
                    let sign = if (k - i) % 2 == 0 { 1.0 } else { -1.0 };
                    table[j][k] += sign * binomial(2 * k, 2 * i) * binomial(DEGREE - k, j - i);
                }
                i += 1;
            }
            table[j][k] /= binomial(DEGREE, j);
            k += 1;
        }
        j += 1;
    }
    table
}

const fn binomial(n: usize, k: usize) -> f64 {
    let (mut value, mut i) = (1.0, 0);
    while i < k {
        value = value * (n - i) as f64 / (i + 1) as f64;
        i += 1;
    }
    value
}

#[cfg(test)]
mod tests;
