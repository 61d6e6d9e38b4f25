//! Mean and variance.

use super::reduce::Reduce;

/// Count, mean, variance, minimum and maximum of numbers. A NaN makes all but the count NaN.
///
/// Sources: Welford, Technometrics 4 (1962), for adding a number; Chan, Golub, LeVeque, *Algorithms
/// for computing the sample variance*, The American Statistician 37 (1983), eq. 2.1, for merging
/// two parts.
///
/// ```
/// use lagrange::ensemble::Moments;
///
/// let mut moments = Moments::new();
/// [1.0, 2.0, 6.0].into_iter().for_each(|value| moments.add(value));
/// assert_eq!((moments.mean(), moments.variance(), moments.max()), (3.0, 7.0, 6.0));
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Moments {
    pub(super) count: u64,
    pub(super) mean: f64,
    /// The sum of squares of deviations from the mean.
    pub(super) squares: f64,
    pub(super) min: f64,
    pub(super) max: f64,
}

impl Moments {
    /// Creates empty moments.
    pub fn new() -> Self {
        Moments { count: 0, mean: 0.0, squares: 0.0, min: f64::INFINITY, max: f64::NEG_INFINITY }
    }

    /// Adds a number.
    pub fn add(&mut self, value: f64) {
        self.count += 1;
        let deviation = value - self.mean;
        self.mean += deviation / self.count as f64;
        self.squares += deviation * (value - self.mean);
        self.min = least(self.min, value);
        self.max = -least(-self.max, -value);
    }

    /// Returns the number of values added.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Returns the mean; NaN if no number was added.
    pub fn mean(&self) -> f64 {
        if self.count == 0 { f64::NAN } else { self.mean }
    }

    /// Returns the sample variance, an estimate of the variance of the distribution: the sum of
    /// squares is divided by the count minus one. NaN for fewer than two numbers.
    pub fn variance(&self) -> f64 {
        if self.count < 2 { f64::NAN } else { self.squares / (self.count - 1) as f64 }
    }

    /// Returns the square root of the variance.
    pub fn standard_deviation(&self) -> f64 {
        libm::sqrt(self.variance())
    }

    /// Returns the minimum; infinity if no number was added.
    pub fn min(&self) -> f64 {
        self.min
    }

    /// Returns the maximum; minus infinity if no number was added.
    pub fn max(&self) -> f64 {
        self.max
    }
}

impl Default for Moments {
    fn default() -> Self {
        Moments::new()
    }
}

impl Reduce for Moments {
    fn merge(&mut self, later: Self) {
        if self.count == 0 || later.count == 0 {
            *self = if self.count == 0 { later } else { *self };
            return;
        }
        let count = self.count + later.count;
        let (part, deviation) = (later.count as f64 / count as f64, later.mean - self.mean);
        self.squares += later.squares + deviation * deviation * part * self.count as f64;
        self.mean += deviation * part;
        self.min = least(self.min, later.min);
        self.max = -least(-self.max, -later.max);
        self.count = count;
    }
}

/// Returns the smaller number, or NaN if either is NaN.
fn least(one: f64, other: f64) -> f64 {
    if one.is_nan() || one < other { one } else { other }
}
