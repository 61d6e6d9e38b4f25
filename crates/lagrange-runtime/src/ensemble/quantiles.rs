//! Quantiles of motions over time.

use std::vec::Vec;

use super::samples::Samples;
use crate::scalar::Scalar;
use crate::simulate::Table;
use crate::system::MechanicalSystem;

impl<M: MechanicalSystem> Samples<M> {
    /// Returns quantiles of a column over time, for parts from 0 to 1. For each part there is a
    /// list with an entry for each of the [`times`](Self::times): the value below which this part
    /// of the motions lies. `None` if there is no such column.
    ///
    /// Quantiles between the values of two motions are interpolated linearly (definition 7 of
    /// Hyndman and Fan, *The American Statistician* 50 (1996) 361–365). Failed motions are omitted,
    /// as are motions after they stopped, and NaN values. If no motion remains, quantiles are NaN.
    ///
    /// ```
    /// use lagrange::Ensembles;
    ///
    /// lagrange::system! {
    ///     #[derive(Clone)]
    ///     pub struct Body;
    ///     coord x;
    ///     kinetic = 1/2 * dot(x)^2;
    /// }
    ///
    /// let samples = Body::default().ensemble(101).start(|i, _| [0.0, 0.01 * i as f64]).until(2.0).every(1.0).run()?;
    /// let spread = samples.quantiles("x", &[0.25, 0.5]).unwrap_or_default();
    /// assert!((spread[0][2] - 0.5).abs() < 1e-12 && (spread[1][2] - 1.0).abs() < 1e-12);
    /// # Ok::<(), lagrange::ensemble::EnsembleError>(())
    /// ```
    pub fn quantiles(&self, column: &str, parts: &[f64]) -> Option<Vec<Vec<f64>>>
    where
        M::Scalar: Into<f64>,
    {
        let motions: Vec<_> = self.tables().collect();
        let columns: Vec<&[M::Scalar]> =
            motions.iter().map(|table| table.column(column)).collect::<Option<_>>()?;
        let mut quantiles: Vec<Vec<f64>> = parts.iter().map(|_| Vec::new()).collect();
        for (index, time) in self.times().iter().enumerate() {
            let is_there = |table: &Table<M::Scalar>| table.times().get(index) == Some(time);
            let there = motions.iter().zip(&columns).filter(|(table, _)| is_there(table));
            let mut values: Vec<f64> = there.map(|(_, column)| column[index].into()).collect();
            values.retain(|value| !value.is_nan());
            values.sort_by(f64::total_cmp);
            quantiles.iter_mut().zip(parts).for_each(|(list, part)| list.push(quantile(&values, *part)));
        }
        Some(quantiles)
    }

    /// Returns the times of the samples of the longest motion, which equal those of every motion
    /// that was not stopped.
    pub fn times(&self) -> &[M::Scalar] {
        let farther = |kept: &'_ [M::Scalar], next: &'_ [M::Scalar]| span(next) > span(kept);
        let all = self.tables().map(Table::times);
        all.reduce(|kept, next| if farther(kept, next) { next } else { kept }).unwrap_or_default()
    }

    /// Returns the samples of all motions that did not fail.
    fn tables(&self) -> impl Iterator<Item = &Table<M::Scalar>> {
        self.iter().map(|(_, motion)| motion.table())
    }
}

/// Returns the time from the first to the last of these times.
fn span<S: Scalar>(times: &[S]) -> S {
    times.first().zip(times.last()).map_or(S::ZERO, |(first, last)| (*last - *first).abs())
}

/// Returns the value below which this part of sorted values lies.
///
/// For 10, 20, 40, half lies below 20. Three quarters lie below 30, halfway between the second and
/// the third.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = part.clamp(0.0, 1.0) * last as f64;
    // Conversions saturate, and a NaN part yields NaN.
    let below = (place as usize).min(last);
    let above = (below + 1).min(last);
    let share = place - below as f64;
    if share == 0.0 { sorted[below] } else { sorted[below] + share * (sorted[above] - sorted[below]) }
}
