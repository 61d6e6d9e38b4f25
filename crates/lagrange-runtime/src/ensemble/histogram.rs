//! Histograms whose bins adapt to the numbers.

use core::ops::Range;
use std::collections::BTreeMap;

use super::reduce::Reduce;

/// A histogram with bins of equal width and a maximum number of bins. The width adapts to the
/// numbers.
///
/// The width is the smallest power of two for which that many bins cover all numbers. It is not
/// below 2⁻⁴⁰ of the power of two below the largest magnitude. Edges are multiples of the width.
/// The counts therefore depend on the numbers alone and not on their order, and need no range in
/// advance. Numbers that are not finite are counted separately.
///
/// ```
/// use lagrange::ensemble::Histogram;
///
/// let mut histogram = Histogram::new(4);
/// [0.5, 1.5, 1.75, 3.0].into_iter().for_each(|value| histogram.add(value));
/// let bins: Vec<_> = histogram.bins().collect();
/// assert_eq!(bins, [(0.0..1.0, 1), (1.0..2.0, 2), (2.0..3.0, 0), (3.0..4.0, 1)]);
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct Histogram {
    pub(super) most: usize,
    /// The width is two to the power of this.
    pub(super) exponent: i32,
    /// Nonzero counts, by the lower edge of the bin in units of the width.
    pub(super) counts: BTreeMap<i64, u64>,
    pub(super) not_finite: u64,
}

/// The width is at least the power of two below the largest magnitude, times 2⁻⁴⁰, so that bin
/// indices are exact.
const DEPTH: i32 = 40;
/// Minimum exponent of the width.
const FINEST: i32 = -1000;

impl Histogram {
    /// Creates an empty histogram with at most this many bins.
    ///
    /// # Panics
    /// If the maximum is 0 or exceeds 2²⁴.
    pub fn new(bins: usize) -> Self {
        assert!((1..=1 << 24).contains(&bins), "a histogram has from 1 to 2^24 bins, not {bins}");
        Histogram { most: bins, exponent: FINEST, counts: BTreeMap::new(), not_finite: 0 }
    }

    /// Counts a number.
    pub fn add(&mut self, value: f64) {
        if !value.is_finite() {
            self.not_finite += 1;
            return;
        }
        self.widen(finest(value));
        let place = |exponent: i32| libm::floor(libm::ldexp(value, -exponent)) as i64;
        let mut here = place(self.exponent);
        while self.span(here, here) > self.most as u64 {
            self.widen(self.exponent + 1);
            here = place(self.exponent);
        }
        *self.counts.entry(here).or_default() += 1;
    }

    /// Returns the edges and counts of all bins, from the bin of the smallest number to that of the
    /// largest.
    pub fn bins(&self) -> impl Iterator<Item = (Range<f64>, u64)> + '_ {
        let ends = self.counts.first_key_value().zip(self.counts.last_key_value());
        let places = ends.map(|((first, _), (last, _))| *first..=*last);
        places.into_iter().flatten().map(|place| {
            let count = self.counts.get(&place).copied().unwrap_or(0);
            (self.edge(place)..self.edge(place + 1), count)
        })
    }

    /// Returns the count of finite numbers.
    pub fn count(&self) -> u64 {
        self.counts.values().sum()
    }

    /// Returns the count of NaN and infinite values, which are in no bin.
    pub fn not_finite(&self) -> u64 {
        self.not_finite
    }

    /// Returns an approximate quantile of the finite numbers, for a part from 0 to 1. Its error is
    /// below the width of a bin, within which numbers are assumed to be evenly distributed. `None`
    /// if there are no finite numbers, or for other parts.
    pub fn quantile(&self, part: f64) -> Option<f64> {
        if !(0.0..=1.0).contains(&part) {
            return None;
        }
        let mut rest = part * self.count() as f64;
        let width = libm::ldexp(1.0, self.exponent);
        for (place, &count) in &self.counts {
            let count = count as f64;
            if rest <= count {
                return Some(self.edge(*place) + width * (rest / count));
            }
            rest -= count;
        }
        self.counts.last_key_value().map(|(place, _)| self.edge(place + 1))
    }

    fn edge(&self, place: i64) -> f64 {
        libm::ldexp(place as f64, self.exponent)
    }

    /// Returns the number of bins needed for all counts and the bins `first` to `last`.
    fn span(&self, first: i64, last: i64) -> u64 {
        let first = self.counts.first_key_value().map_or(first, |(least, _)| first.min(*least));
        let last = self.counts.last_key_value().map_or(last, |(greatest, _)| last.max(*greatest));
        last.abs_diff(first) + 1
    }

    /// Widens bins to at least two to this power.
    fn widen(&mut self, exponent: i32) {
        if exponent <= self.exponent {
            return;
        }
        // Bin indices are less than 2⁴² in magnitude, so any longer shift leaves only their sign,
        // as 63 does.
        let shift = (exponent - self.exponent).min(63);
        self.exponent = exponent;
        for (place, count) in core::mem::take(&mut self.counts) {
            *self.counts.entry(place >> shift).or_default() += count;
        }
    }
}

/// Returns the smallest exponent of a width at which the bin index of this number is exact.
fn finest(value: f64) -> i32 {
    if value == 0.0 { FINEST } else { (libm::ilogb(value) - DEPTH).max(FINEST) }
}

impl Reduce for Histogram {
    fn merge(&mut self, mut later: Self) {
        self.most = self.most.min(later.most);
        self.widen(later.exponent);
        later.widen(self.exponent);
        let ends = [later.counts.first_key_value(), later.counts.last_key_value()];
        let mut ends = ends.map(|end| end.map(|(place, _)| *place));
        while let [Some(first), Some(last)] = ends
            && self.span(first, last) > self.most as u64
        {
            let exponent = self.exponent + 1;
            self.widen(exponent);
            later.widen(exponent);
            ends = [Some(first >> 1), Some(last >> 1)];
        }
        for (place, count) in later.counts {
            *self.counts.entry(place).or_default() += count;
        }
        self.not_finite += later.not_finite;
    }
}
