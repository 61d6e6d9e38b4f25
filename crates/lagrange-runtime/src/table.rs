//! Tables that declarations hold: splines, evaluated in any number type.
//!
//! `lagrange::system!` computes the coefficients of the polynomials; here they are looked up and
//! evaluated. If all pieces are equally long, that takes `f64` and `f32` the same time for tables
//! of any size. Otherwise a binary search finds the piece. Numbers in lanes are evaluated in
//! groups, one for each piece that contains some of them.

use crate::scalar::{Mask, Number};

/// Places along an axis where pieces of a table meet.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Axis {
    /// At least two numbers, ascending.
    pub knots: &'static [f64],
    /// Pieces in a unit of length, if they are equally long; 0 if not.
    pub density: f64,
}

impl Axis {
    /// Returns the ends of the piece that a number is in; infinite beyond the first and the last
    /// knot, NaN for NaN.
    pub fn piece<S: Number>(&self, x: S) -> [S; 2] {
        let Some((piece, _)) = self.find(&mut Group { mask: S::Mask::splat(true) }, x) else {
            return [S::NAN; 2];
        };
        let knot = |index: Option<usize>, beyond: f64| {
            let knot = index.and_then(|index| self.knots.get(index));
            S::from_f64(knot.copied().unwrap_or(beyond))
        };
        [knot(piece.checked_sub(1), f64::NEG_INFINITY), knot(Some(piece), f64::INFINITY)]
    }

    /// The piece that the numbers of a group are in, and their distances from where that begins;
    /// `None` for NaN. Piece 0 is the one before the first knot, whose distance counts from there.
    /// Numbers in other pieces leave the group.
    fn find<S: Number>(&self, group: &mut Group<S::Mask>, x: S) -> Option<(usize, S)> {
        let (knot, count) = (|i: usize| S::from_f64(self.knots[i]), self.knots.len());
        let piece = if group.agree_on(x.less(knot(0))) {
            0
        } else if group.agree_on(knot(count - 1).less(x)) {
            count
        } else if group.agree_on(!x.less_equal(x)) {
            return None;
        } else {
            1 + self.interval(group, x)
        };
        Some((piece, x - knot(piece.saturating_sub(1))))
    }

    /// The interval between two knots, counted from zero.
    fn interval<S: Number>(&self, group: &mut Group<S::Mask>, x: S) -> usize {
        let intervals = self.knots.len() - 1;
        if self.density > 0.0 {
            let passed = (x - S::from_f64(self.knots[0])) * S::from_f64(self.density);
            if let Some(known) = passed.floor_below(intervals) {
                return known;
            }
        }
        let (mut low, mut high) = (0, intervals);
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            match group.agree_on(S::from_f64(self.knots[middle]).less_equal(x)) {
                true => low = middle,
                false => high = middle,
            }
        }
        low
    }
}

/// Numbers side by side that have given the same answers so far.
struct Group<M> {
    mask: M,
}

impl<M: Mask> Group<M> {
    /// True if the answer is yes; those for whom it is not leave the group, if anybody stays.
    fn agree_on(&mut self, answer: M) -> bool {
        let yes = self.mask & answer;
        let is_yes = yes.any();
        if is_yes {
            self.mask = yes;
        }
        is_yes
    }
}

/// The values for all numbers side by side, of which `evaluate` computes those of one group after
/// another.
#[inline]
fn in_groups<S: Number>(evaluate: impl Fn(&mut Group<S::Mask>) -> S) -> S {
    let (mut rest, mut values) = (S::Mask::splat(true), S::NAN);
    while rest.any() {
        let mut group = Group { mask: rest };
        let found = evaluate(&mut group);
        values = S::select(group.mask, found, values);
        rest = rest & !group.mask;
    }
    values
}

/// Function of one argument: polynomials with N coefficients, piece by piece.
///
/// ```
/// use lagrange::table::{Axis, Curve};
///
/// // 1 + 2 x from 0 to 3, and the values at the ends beyond.
/// let curve = Curve { axis: Axis { knots: &[0.0, 3.0], density: 1.0 / 3.0 }, pieces: &[[1.0, 0.0], [1.0, 2.0], [7.0, 0.0]] };
/// assert_eq!([curve.value(-1.0), curve.value(2.0), curve.value(5.0)], [1.0, 5.0, 7.0]);
/// assert_eq!(curve.derivative(1, 2.0_f32), 2.0);
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Curve<const N: usize> {
    /// Places where pieces meet.
    pub axis: Axis,
    /// Coefficients of each piece, one piece more than there are knots: the first lies before the
    /// first knot, the last behind the last one. They belong to ascending powers of the distance
    /// from the start of the piece, of the first one from the first knot.
    pub pieces: &'static [[f64; N]],
}

impl<const N: usize> Curve<N> {
    /// Computes the value; NaN for NaN.
    #[inline]
    pub fn value<S: Number>(&self, x: S) -> S {
        self.derivative(0, x)
    }

    /// Computes the derivative of an order; NaN for NaN.
    #[inline]
    pub fn derivative<S: Number>(&self, order: usize, x: S) -> S {
        in_groups(|group| match self.axis.find(group, x) {
            Some((piece, s)) => polynomial(order, s, |power| S::from_f64(self.pieces[piece][power]), N),
            None => S::NAN,
        })
    }
}

/// Function of two arguments: products of polynomials with N coefficients each, piece by piece.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Surface<const N: usize> {
    /// Places where pieces meet, along the first and along the second argument.
    pub axes: [Axis; 2],
    /// Coefficients of each piece, in rows of ascending powers of the first distance, with
    /// ascending powers of the second one in each. The pieces are in rows along the second
    /// argument, as many as in a [`Curve`].
    pub pieces: &'static [[[f64; N]; N]],
}

impl<const N: usize> Surface<N> {
    /// Computes the value; NaN where an argument is.
    #[inline]
    pub fn value<S: Number>(&self, x: S, y: S) -> S {
        self.derivative([0, 0], [x, y])
    }

    /// Computes the derivative of an order by each argument; NaN where an argument is.
    #[inline]
    pub fn derivative<S: Number>(&self, [by_x, by_y]: [usize; 2], [x, y]: [S; 2]) -> S {
        let [along_x, along_y] = &self.axes;
        in_groups(|group| {
            let Some((i, s)) = along_x.find(group, x) else { return S::NAN };
            let Some((j, r)) = along_y.find(group, y) else { return S::NAN };
            let rows = &self.pieces[i * (along_y.knots.len() + 1) + j];
            let row = |power: usize| polynomial(by_y, r, |k| S::from_f64(rows[power][k]), N);
            polynomial(by_x, s, row, N)
        })
    }
}

/// The derivative of an order of Σ cᵢ sⁱ with so many coefficients, by Horner's rule.
#[inline]
fn polynomial<S: Number>(order: usize, s: S, coefficient: impl Fn(usize) -> S, count: usize) -> S {
    let term = |power: usize| coefficient(power) * S::from_f64(falling(power, order));
    let mut powers = (order..count).rev();
    let Some(highest) = powers.next() else { return S::ZERO };
    powers.fold(term(highest), |sum, power| sum.multiply_add(s, term(power)))
}

/// n (n − 1) … (n − k + 1)
#[inline]
fn falling(n: usize, k: usize) -> f64 {
    (0..k).map(|i| (n - i) as f64).product()
}

#[cfg(test)]
mod tests;
