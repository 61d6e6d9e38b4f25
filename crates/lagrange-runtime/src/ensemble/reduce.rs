//! Reductions of a whole ensemble, which keep no motion.

use std::vec::Vec;

/// A summary of motions that can be merged from the summaries of parts.
///
/// An ensemble is accumulated in blocks of 64 motions, each from a clone of the argument of
/// [`reduce`](crate::ensemble::Ensemble::reduce). The blocks of a
/// [part](crate::ensemble::Ensemble::motions_per_part) are merged from left to right, and so are
/// the parts, whichever thread or process computed them. The result has the same bits for any
/// number of threads or processes. It equals the result of a single block if
///
/// - merging with the argument of `reduce` changes nothing, and
/// - adding motions to a part and then merging the part is the same as adding them one after the
///   other, up to rounding.
///
/// Integers (counts), tuples, arrays and vectors (concatenated, so memory grows) are reductions, in
/// addition to [`Moments`](crate::ensemble::Moments) and [`Histogram`](crate::ensemble::Histogram).
///
/// ```
/// use lagrange::ensemble::Reduce;
///
/// /// The largest number.
/// #[derive(Clone)]
/// struct Largest(f64);
///
/// impl Reduce for Largest {
///     fn merge(&mut self, later: Self) {
///         self.0 = self.0.max(later.0);
///     }
/// }
///
/// let mut largest = Largest(1.0);
/// largest.merge(Largest(2.0));
/// assert_eq!(largest.0, 2.0);
/// ```
pub trait Reduce: Clone + Send + Sync {
    /// Merges the summary of the motions that follow the motions summarised here.
    fn merge(&mut self, later: Self);
}

impl Reduce for u64 {
    fn merge(&mut self, later: Self) {
        *self += later;
    }
}

impl Reduce for usize {
    fn merge(&mut self, later: Self) {
        *self += later;
    }
}

impl<T: Clone + Send + Sync> Reduce for Vec<T> {
    fn merge(&mut self, later: Self) {
        self.extend(later);
    }
}

impl<R: Reduce, const N: usize> Reduce for [R; N] {
    fn merge(&mut self, later: Self) {
        self.iter_mut().zip(later).for_each(|(reduction, later)| reduction.merge(later));
    }
}

impl<A: Reduce, B: Reduce> Reduce for (A, B) {
    fn merge(&mut self, later: Self) {
        self.0.merge(later.0);
        self.1.merge(later.1);
    }
}

impl<A: Reduce, B: Reduce, C: Reduce> Reduce for (A, B, C) {
    fn merge(&mut self, later: Self) {
        self.0.merge(later.0);
        self.1.merge(later.1);
        self.2.merge(later.2);
    }
}
