//! Responses in time to a step or an impulse.

use std::vec::Vec;

/// An output after an input has jumped or given an impulse.
#[derive(Clone, PartialEq, Debug)]
pub struct TimeResponse {
    /// Names of the input and of the output.
    pub names: (&'static str, &'static str),
    /// Unit of the output, if it is declared.
    pub unit: Option<&'static str>,
    /// Times from zero on.
    pub times: Vec<f64>,
    /// Values of the output.
    pub values: Vec<f64>,
    /// The value that the output approaches; `None` if it does not settle.
    pub limit: Option<f64>,
}

impl TimeResponse {
    /// Returns the time in which the output rises from a tenth to nine tenths of its limit. `None`
    /// if it has no limit, or never reaches it.
    #[must_use]
    pub fn rise_time(&self) -> Option<f64> {
        let limit = self.limit?;
        Some(self.first_at(0.9 * limit)? - self.first_at(0.1 * limit)?)
    }

    /// Returns the largest excess over the limit, as a fraction of it; zero if there is none.
    #[must_use]
    pub fn overshoot(&self) -> Option<f64> {
        let limit = self.limit.filter(|limit| *limit != 0.0)?;
        Some(self.values.iter().map(|value| value / limit - 1.0).fold(0.0, f64::max))
    }

    /// Returns the time after which the output stays within this fraction of its limit, such as
    /// 0.02. `None` if there is no limit, or the output is still outside at the end.
    #[must_use]
    pub fn settling_time(&self, part: f64) -> Option<f64> {
        let limit = self.limit?;
        let is_outside = |value: &f64| (value - limit).abs() > part * limit.abs();
        match self.values.iter().rposition(is_outside) {
            None => Some(0.0),
            Some(last) => self.times.get(last + 1).copied(),
        }
    }

    /// Returns the time at which the output first reaches a value, by linear interpolation.
    fn first_at(&self, level: f64) -> Option<f64> {
        let reaches = |value: f64| if level >= 0.0 { value >= level } else { value <= level };
        let after = self.values.iter().position(|&value| reaches(value))?;
        let Some(before) = after.checked_sub(1) else { return self.times.first().copied() };
        let part = (level - self.values[before]) / (self.values[after] - self.values[before]);
        Some(self.times[before] + part * (self.times[after] - self.times[before]))
    }
}
