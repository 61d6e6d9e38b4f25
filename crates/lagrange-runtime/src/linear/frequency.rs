//! Responses to oscillations, and stability margins.
//!
//! Source: Åström, Murray, *Feedback Systems*, 2nd ed., §10.

use core::f64::consts::{PI, TAU};
use std::vec::Vec;

use super::transfer::Transfer;

/// Number of bisections, after which a frequency is exact up to rounding.
const BISECTIONS: usize = 60;
/// Less than zero by more than rounding, so that a phase of half a turn is a lag.
const START: f64 = 1e-6;

/// The response G(iω) of an output to oscillations of an input.
#[derive(Clone, PartialEq, Debug)]
pub struct FrequencyResponse {
    pub(super) transfer: Transfer,
    /// Frequencies ω in radians per unit of time.
    pub frequencies: Vec<f64>,
    /// Real and imaginary part of G(iω) for each.
    pub values: Vec<(f64, f64)>,
}

/// Distances of a loop with the transfer function G and negative feedback from instability.
///
/// They are valid for a loop that is stable by Nyquist's criterion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StabilityMargins {
    /// The smallest factor above one of G, and its frequency, at which G = −1; `None` without one.
    pub gain: Option<(f64, f64)>,
    /// The largest factor below one of G, and its frequency, at which G = −1; `None` without one.
    /// It limits loops that are unstable without feedback.
    pub reduction: Option<(f64, f64)>,
    /// The smallest lag of G, in radians, and its frequency, at which G = −1; `None` without one.
    pub phase: Option<(f64, f64)>,
}

impl Transfer {
    /// Computes the response to oscillations of the input with these frequencies, in radians per
    /// unit of time.
    #[must_use]
    pub fn frequency_response(&self, frequencies: &[f64]) -> FrequencyResponse {
        let values = frequencies.iter().map(|&frequency| self.at(frequency)).collect();
        FrequencyResponse { transfer: self.clone(), frequencies: frequencies.to_vec(), values }
    }
}

impl FrequencyResponse {
    /// Returns the magnitudes |G| in decibels, 20 log₁₀ |G|.
    #[must_use]
    pub fn decibels(&self) -> Vec<f64> {
        self.values.iter().map(|(real, imaginary)| 20.0 * real.hypot(*imaginary).log10()).collect()
    }

    /// Returns the phases of G in radians. They begin between −π and π, with −π for the sign minus,
    /// and continue without jumps of a whole turn.
    #[must_use]
    pub fn phases(&self) -> Vec<f64> {
        let mut last = -START;
        let unwrapped = self.values.iter().map(|(real, imaginary)| {
            let phase = imaginary.atan2(*real);
            let phase = phase + TAU * ((last - phase) / TAU).round();
            if phase.is_finite() {
                last = phase;
            }
            phase
        });
        unwrapped.collect()
    }

    /// Returns the largest magnitude |G| among the frequencies, and its frequency; `None` without
    /// finite values.
    #[must_use]
    pub fn peak(&self) -> Option<(f64, f64)> {
        let sizes = self.values.iter().map(|(real, imaginary)| real.hypot(*imaginary));
        let finite = sizes.zip(self.frequencies.iter().copied()).filter(|(size, _)| size.is_finite());
        finite.max_by(|(a, _), (b, _)| a.total_cmp(b))
    }

    /// Computes the margins of the loop that G closes with negative feedback. Crossings are found
    /// between neighbouring frequencies and located exactly.
    #[must_use]
    pub fn margins(&self) -> StabilityMargins {
        // −180° is crossed where the imaginary part vanishes left of zero.
        let behind = self.crossings(|(_, imaginary)| imaginary).into_iter().filter_map(|frequency| {
            let (real, _) = self.transfer.at(frequency);
            (real < 0.0).then(|| (-1.0 / real, frequency))
        });
        let (above, below): (Vec<_>, Vec<_>) = behind.partition(|(factor, _)| *factor > 1.0);
        let lags = self.crossings(|(real, imaginary)| real.hypot(imaginary) - 1.0).into_iter();
        let lags = lags.map(|frequency| {
            let (real, imaginary) = self.transfer.at(frequency);
            ((imaginary.atan2(real) + PI).rem_euclid(TAU), frequency)
        });
        let smaller = |(a, _): &(f64, f64), (b, _): &(f64, f64)| a.total_cmp(b);
        StabilityMargins {
            gain: above.into_iter().min_by(smaller),
            reduction: below.into_iter().max_by(smaller),
            phase: lags.min_by(smaller),
        }
    }

    /// Finds frequencies at which a function of G changes its sign.
    fn crossings(&self, of: impl Fn((f64, f64)) -> f64) -> Vec<f64> {
        let signs = self.values.iter().map(|&value| of(value)).collect::<Vec<_>>();
        let changes = signs.windows(2).enumerate().filter(|(_, pair)| pair[0] * pair[1] < 0.0);
        let located = changes.map(|(index, pair)| {
            let (mut from, mut to) = (self.frequencies[index], self.frequencies[index + 1]);
            for _ in 0..BISECTIONS {
                let middle = (from * to).sqrt();
                match of(self.transfer.at(middle)) * pair[0] > 0.0 {
                    true => from = middle,
                    false => to = middle,
                }
            }
            to
        });
        // Through a pole the sign changes, too, without a zero.
        located.filter(|&frequency| of(self.transfer.at(frequency)).abs() < 1e-6).collect()
    }
}
