//! Declared ranges and nominal values of the entries of a state.

use core::ops::Bound;
#[cfg(feature = "ensemble")]
use core::ops::{Neg, Range, RangeBounds};

#[cfg(feature = "ensemble")]
use super::SideBySide;
use super::{OutOfRange, RangedKind};
use crate::scalar::Scalar;
#[cfg(feature = "ensemble")]
use crate::scalar::{Mask, Number};
use crate::tolerance::BOUNDARY;

/// Maximum number of draws of a number within bounds.
#[cfg(feature = "ensemble")]
const MAX_DRAWS: usize = 100;

/// The declared ranges and nominal values of the entries of a state.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Domain {
    /// Ranges of entries that have one.
    pub ranges: &'static [EntryRange],
    /// The size that counts as one for each entry; empty if no nominal value is declared. Entries
    /// after the last one have the size one.
    pub nominal: &'static [f64],
}

/// The range of an entry of the state.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct EntryRange {
    /// Index in the state.
    pub entry: usize,
    /// Its kind: a coordinate, a velocity or a state.
    pub kind: RangedKind,
    /// Its name in columns.
    pub name: &'static str,
    /// Unit of the bounds; empty if it is unknown.
    pub unit: &'static str,
    /// The lower and the upper bound.
    pub bounds: (Bound<f64>, Bound<f64>),
}

impl Domain {
    /// The domain of systems that declare neither ranges nor nominal values.
    pub const EVERYWHERE: Domain = Domain { ranges: &[], nominal: &[] };

    /// Returns the size that counts as one for an entry.
    #[inline(always)]
    pub fn nominal(&self, entry: usize) -> f64 {
        self.nominal.get(entry).copied().unwrap_or(1.0)
    }

    /// Checks a state. Entries may exceed included bounds by rounding, since bodies come to rest
    /// there.
    ///
    /// # Errors
    /// If an entry is out of its range, or NaN.
    #[inline]
    pub fn check<S: Scalar>(&self, state: &[S]) -> Result<(), OutOfRange<S>> {
        self.ranges.iter().try_for_each(|range| {
            let Some(value) = state.get(range.entry) else { return Ok(()) };
            let allowed = self.allowed(range);
            let outside = OutOfRange::check(range.kind, range.name, *value, allowed, range.unit);
            outside.map_err(|outside| OutOfRange { range: range.numbers(), ..outside })
        })
    }

    /// Returns the lanes whose states pass the [check](Self::check).
    #[cfg(feature = "ensemble")]
    #[inline(always)]
    pub(crate) fn contains<S: SideBySide<Element: Scalar>>(&self, state: &[S]) -> S::Mask {
        self.ranges.iter().fold(S::Mask::splat(true), |are_inside, range| {
            let Some(value) = state.get(range.entry) else { return are_inside };
            let (lower, upper) = self.allowed::<S::Element>(range);
            are_inside
                & follows(lower.map(S::splat), *value)
                & follows(upper.map(S::splat).map(Neg::neg), -*value)
        })
    }

    /// Returns the bounds of a range, beyond included ones by rounding.
    #[inline]
    fn allowed<S: Scalar>(&self, range: &EntryRange) -> (Bound<S>, Bound<S>) {
        // One also stands for nominal values that are not declared.
        let nominal = self.nominal.get(range.entry).copied().filter(|nominal| *nominal != 1.0);
        let size = nominal.unwrap_or_else(|| range.size());
        let slack = |bound: S| BOUNDARY.part::<S>() * bound.abs().max(S::from_f64(size));
        let (lower, upper) = range.numbers();
        (map_included(lower, |bound| bound - slack(bound)), map_included(upper, |bound| bound + slack(bound)))
    }

    /// Sets each entry whose range has two bounds to a number between them. The argument draws one
    /// from a range, its end excluded.
    #[cfg(feature = "ensemble")]
    pub(crate) fn draw<S: Scalar>(&self, state: &mut [S], mut uniform: impl FnMut(Range<f64>) -> f64) {
        for range in self.ranges.iter().filter(|range| range.is_bounded()) {
            let Some(entry) = state.get_mut(range.entry) else { continue };
            let (low, high) = range.ends();
            let bounds: (Bound<S>, Bound<S>) = range.numbers();
            let mut drawn = (0..MAX_DRAWS).map(|_| S::from_f64(uniform(low..high)));
            // Rounding may lead to an excluded bound.
            *entry = drawn.find(|value| bounds.contains(value)).unwrap_or(*entry);
        }
    }

    /// Returns the value of an entry that is nearest to another one, bounds included.
    #[cfg(feature = "std")]
    pub(crate) fn nearest<S: Scalar>(&self, entry: usize, value: S) -> S {
        let Some(range) = self.ranges.iter().find(|range| range.entry == entry) else { return value };
        let (lower, upper) = range.ends();
        value.max(lower).min(upper)
    }
}

impl EntryRange {
    /// True if it has two bounds, and numbers between them.
    #[cfg(feature = "ensemble")]
    pub(crate) fn is_bounded(&self) -> bool {
        let (low, high) = self.ends::<f64>();
        low < high && (high - low).is_finite()
    }

    /// Returns the size of the larger bound, or one if no bound differs from zero.
    fn size(&self) -> f64 {
        let size_of = |bound: Bound<f64>| match bound {
            Bound::Included(bound) | Bound::Excluded(bound) => bound.max(-bound),
            Bound::Unbounded => 0.0,
        };
        let largest = size_of(self.bounds.0).max(size_of(self.bounds.1));
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// Returns the bounds as numbers of a system.
    fn numbers<S: Scalar>(&self) -> (Bound<S>, Bound<S>) {
        (self.bounds.0.map(S::from_f64), self.bounds.1.map(S::from_f64))
    }

    /// Returns the smallest and the largest value; they are infinite where there is no bound.
    pub(crate) fn ends<S: Scalar>(&self) -> (S, S) {
        let end = |bound: Bound<f64>, otherwise: f64| match bound {
            Bound::Included(bound) | Bound::Excluded(bound) => S::from_f64(bound),
            Bound::Unbounded => S::from_f64(otherwise),
        };
        (end(self.bounds.0, f64::NEG_INFINITY), end(self.bounds.1, f64::INFINITY))
    }
}

/// Changes a bound that belongs to its range.
fn map_included<S>(bound: Bound<S>, change: impl FnOnce(S) -> S) -> Bound<S> {
    match bound {
        Bound::Included(bound) => Bound::Included(change(bound)),
        other => other,
    }
}

/// True where a value satisfies a lower bound; NaN satisfies none.
#[cfg(feature = "ensemble")]
#[inline(always)]
fn follows<S: Number>(lower: Bound<S>, value: S) -> S::Mask {
    match lower {
        Bound::Included(lower) => lower.less_equal(value),
        Bound::Excluded(lower) => lower.less(value),
        Bound::Unbounded => value.less_equal(value),
    }
}

#[cfg(test)]
mod tests {
    use core::ops::Bound;

    use super::{Domain, EntryRange};
    use crate::scalar::Scalar;
    use crate::system::RangedKind;

    const HEIGHT: EntryRange = EntryRange {
        entry: 0,
        kind: RangedKind::Coordinate,
        name: "height",
        unit: "m",
        bounds: (Bound::Included(0.0), Bound::Excluded(8.0)),
    };

    /// True if a state passes at this many roundings below its lower bound.
    fn passes<S: Scalar>(nominal: &'static [f64], roundings: f64) -> bool {
        let domain = Domain { ranges: &[HEIGHT], nominal };
        domain.check(&[S::from_f64(-roundings) * S::epsilon()]).is_ok()
    }

    fn bounds_are_exceeded_by_rounding_only_in<S: Scalar>() {
        // The largest bound is the size of the entry, otherwise the nominal value.
        assert!(passes::<S>(&[], 8.0 * 1000.0));
        assert!(!passes::<S>(&[], 8.0 * 65_536.0));
        assert!(passes::<S>(&[0.5], 0.5 * 1000.0));
        assert!(!passes::<S>(&[0.5], 0.5 * 65_536.0));
        assert!(!passes::<S>(&[], f64::NAN));
        // An excluded bound is not reached at all.
        let domain = Domain { ranges: &[HEIGHT], nominal: &[] };
        assert!(domain.check(&[S::from_f64(8.0)]).is_err());
        assert!(domain.check(&[S::from_f64(8.0) * (S::ONE - S::epsilon())]).is_ok());
    }

    #[test]
    fn bounds_are_exceeded_by_rounding_only() {
        bounds_are_exceeded_by_rounding_only_in::<f64>();
        bounds_are_exceeded_by_rounding_only_in::<f32>();
    }
}
