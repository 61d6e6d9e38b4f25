//! Pieces of steps: values of functions, and the first event that they indicate.

use super::function::{Claim, EventFunction};
use super::polynomial::{POINTS, Polynomial, SignChange};
use crate::scalar::Scalar;

/// A function that has risen since its start at this fraction of its present rate or more did not
/// start at rest.
const STEADY: f64 = 0.8;

/// The values of all functions at a time within a step; if the second argument is true, at a state
/// changed by rounding. A trait object, so that the search is compiled only once for all systems
/// and methods.
pub(super) type EventValues<'a, S, const K: usize> = dyn FnMut(S, bool) -> [S; K] + 'a;

/// Times in a piece, and the values of all functions at these times.
pub(super) struct Piece<S, const K: usize> {
    pub(super) times: [S; POINTS],
    pub(super) values: [[S; K]; POINTS],
}

/// The place of an event in a piece.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Sight<S> {
    /// Nowhere.
    Nothing,
    /// At the start of the piece.
    AtOnce,
    /// Between two times, according to the polynomial, from this sign to the other.
    Between { from: S, to: S, sign: S },
    /// Nowhere: a function that was at zero when the state was replaced continues to the side that
    /// it had reached.
    Passing,
    /// Undecided; a shorter piece is needed.
    Unclear,
}

impl<S: Scalar, const K: usize> Piece<S, K> {
    /// Evaluates the values of function `k`. In a piece that cannot be shortened, signs decide even
    /// if they are unclear. `passable` is where the functions were last started, if what was at
    /// zero there may go on through it.
    pub(super) fn sight(
        &self,
        k: usize,
        function: &EventFunction<S>,
        passable: Option<S>,
        is_shortest: bool,
    ) -> Sight<S> {
        // What was turned round left at its zero, as well as that was located.
        let zero = if function.claim == Claim::Turned { function.start } else { S::ZERO };
        let values: [S; POINTS] = core::array::from_fn(|j| self.values[j][k] - zero);
        let Some((first, mut sign)) = beginning(&values, function) else { return Sight::Nothing };
        if !function.is_armed() && function.direction.counts(sign, values[0]) {
            return Sight::AtOnce;
        }
        if values.iter().all(|value| *value == values[0]) {
            return Sight::Nothing;
        }
        let polynomial = Polynomial::new(&values);
        if function.claim == Claim::Turned
            && passable.is_some_and(|started| self.passes(&polynomial, function, started))
        {
            return Sight::Passing;
        }
        let mut x = self.part(first);
        loop {
            match polynomial.next_change(sign, x, x == S::ZERO && function.has_fired_at(self.times[0])) {
                SignChange::Nowhere => return self.at_its_end(&values, sign, function),
                SignChange::Between(from, to) if polynomial.is_trusted() => {
                    if function.direction.counts(sign, -sign) {
                        return Sight::Between { from: self.time(from), to: self.time(to), sign };
                    }
                    (sign, x) = (-sign, to);
                }
                SignChange::Unclear if polynomial.is_exact() => {
                    return self.at_its_end(&values, sign, function);
                }
                _ if !is_shortest => return Sight::Unclear,
                _ => return self.by_signs(&values, (first, sign), function),
            }
        }
    }

    /// Returns the largest change of each function under rounding of the state, at three times: at
    /// one of them the change may vanish.
    pub(super) fn roundings(&self, at: &mut EventValues<'_, S, K>) -> [S; K] {
        [0, POINTS / 2, POINTS - 1].into_iter().fold([S::ZERO; K], |largest, j| {
            let (rounded, values) = (at(self.times[j], true), self.values[j]);
            core::array::from_fn(|k| largest[k].max((rounded[k] - values[k]).abs()))
        })
    }

    /// True if a function that was at zero at its start continues in the direction in which it
    /// passed zero, and was not turned round. It must do so at once, and then have gained no more
    /// than a part of its rate since.
    fn passes(&self, polynomial: &Polynomial<S>, function: &EventFunction<S>, started: S) -> bool {
        let [from, to] = [self.times[0], self.times[POINTS - 1]];
        let rise = polynomial.rise(-function.sign);
        let since = (from - started) / (to - from);
        let risen = (function.here - function.start) * -function.sign.sign();
        rise > S::ZERO && risen >= S::from_f64(STEADY) * rise * since
    }

    /// Finds an event just before the end of the piece, where the change of sign may be lost in
    /// rounding.
    fn at_its_end(&self, values: &[S; POINTS], sign: S, function: &EventFunction<S>) -> Sight<S> {
        if function.claim == Claim::Switch {
            return Sight::Nothing;
        }
        self.by_signs(values, (POINTS - 1, sign), function)
    }

    /// Finds an event between the first two adjacent values that indicate one.
    fn by_signs(
        &self,
        values: &[S; POINTS],
        (first, mut sign): (usize, S),
        function: &EventFunction<S>,
    ) -> Sight<S> {
        for (j, value) in values.iter().enumerate().skip(first.max(1)) {
            if function.direction.counts(sign, *value) {
                return Sight::Between { from: self.times[j - 1], to: self.times[j], sign };
            }
            sign = if *value == S::ZERO { sign } else { *value };
        }
        Sight::Nothing
    }

    /// Returns the time at a part of the piece.
    fn time(&self, part: S) -> S {
        let [from, to] = [self.times[0], self.times[POINTS - 1]];
        if part == S::ONE { to } else { from + part * (to - from) }
    }

    /// Returns the part of the piece that ends at the time of this index.
    fn part(&self, index: usize) -> S {
        let [from, to] = [self.times[0], self.times[POINTS - 1]];
        (self.times[index] - from) / (to - from)
    }
}

/// Returns the index from which a sign counts, and the sign; `None` if all values are zero.
fn beginning<S: Scalar>(values: &[S; POINTS], function: &EventFunction<S>) -> Option<(usize, S)> {
    if function.sign != S::ZERO {
        return Some((0, function.sign));
    }
    values.iter().position(|value| *value != S::ZERO).map(|first| (first, values[first]))
}
