//! The division of a step into pieces in the search for zeros.

use crate::scalar::Scalar;

/// Minimum length of a piece, relative to its step.
const SHORTEST: f64 = 1.0 / 4096.0;
/// Number of inconclusive pieces, as with noise, after which pieces must be longer.
const MAX_UNCLEAR: u32 = 64;
/// Minimum length of a piece, relative to its step, after that.
const SHORTEST_IF_UNCLEAR: f64 = 1.0 / 16.0;

/// The search of a step in pieces, which are shorter if a function changes more.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search<S> {
    /// Start and end of the step.
    from: S,
    to: S,
    /// Length of the next piece, relative to the step.
    part: S,
    /// Number of inconclusive pieces of minimum length.
    unclear: u32,
}

impl<S: Scalar> Search<S> {
    /// Begins with the whole step.
    pub(super) fn new(from: S, to: S) -> Self {
        Search { from, to, part: S::ONE, unclear: 0 }
    }

    /// Returns the end of the next piece, which begins at `start`.
    pub(super) fn end(&self, start: S) -> S {
        let (end, left) = (start + self.part * (self.to - self.from), self.to - start);
        let is_last = self.part == S::ONE || (end - start).abs() >= left.abs() || end == start;
        if is_last { self.to } else { end }
    }

    /// True if this is the search of the step between these times.
    pub(super) fn is_of(&self, from: S, to: S) -> bool {
        (self.from, self.to) == (from, to)
    }

    /// True if the next piece has minimum length.
    pub(super) fn is_shortest(&self) -> bool {
        let shortest = if self.unclear < MAX_UNCLEAR { SHORTEST } else { SHORTEST_IF_UNCLEAR };
        self.part <= S::from_f64(shortest)
    }

    /// Halves the next piece.
    pub(super) fn shorten(&mut self) {
        self.part = self.part / S::from_f64(2.0);
    }

    /// Registers a piece that was searched up to an event.
    pub(super) fn pause(&mut self) {
        self.unclear += u32::from(self.is_shortest());
        if self.unclear >= MAX_UNCLEAR {
            self.part = self.part.max(S::from_f64(SHORTEST_IF_UNCLEAR));
        }
    }

    /// Registers a piece that was searched to its end; the next one may be longer.
    pub(super) fn go_on(&mut self) {
        self.pause();
        self.part = (self.part + self.part).min(S::ONE);
    }
}
