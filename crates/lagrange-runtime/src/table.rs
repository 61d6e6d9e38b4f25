//! Tables of declarations: splines, evaluated for any number type.
//!
//! `lagrange::system!` computes the coefficients of the polynomials; this module selects and
//! evaluates them. If all pieces have equal lengths, this takes the same time for tables of any
//! size with `f64` and `f32`. Otherwise a binary search finds the piece. Numbers in lanes are
//! evaluated in groups, one for each piece that contains some of them.

use crate::scalar::{Mask, Number};

/// The knots along an axis, at which pieces of a table meet.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Axis {
    /// At least two numbers, ascending.
    pub knots: &'static [f64],
    /// Number of pieces per unit of length if they have equal lengths; 0 otherwise.
    pub density: f64,
}

impl Axis {
    /// Returns the ends of the piece that contains a number; infinite beyond the first and the last
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

    /// Returns the piece that contains the numbers of a group, and their distances from its start;
    /// `None` for NaN. Piece 0 precedes the first knot, and its distances are measured from this
    /// knot. Numbers in other pieces leave the group.
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

    /// Returns the index of the interval between two knots, counted from zero.
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

/// Numbers in lanes that have had the same results in all comparisons so far.
struct Group<M> {
    mask: M,
}

impl<M: Mask> Group<M> {
    /// True if the answer is true for any member. Members with a different answer leave the group.
    fn agree_on(&mut self, answer: M) -> bool {
        let yes = self.mask & answer;
        let is_yes = yes.any();
        if is_yes {
            self.mask = yes;
        }
        is_yes
    }
}

/// Computes the values for all lanes, by calling `evaluate` for one group after another.
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

/// A function of one to three arguments, D, given by piecewise products of polynomials with N
/// coefficients each.
///
/// ```
/// use lagrange::table::{Axis, Table};
///
/// // 1 + 2 x from 0 to 3, and the values at the ends beyond.
/// let axis = Axis { knots: &[0.0, 3.0], density: 1.0 / 3.0 };
/// let table = Table { axes: [axis], rows: &[[1.0, 0.0], [1.0, 2.0], [7.0, 0.0]] };
/// assert_eq!([-1.0, 2.0, 5.0].map(|x| table.value([x])), [1.0, 5.0, 7.0]);
/// assert_eq!(table.derivative([1], [2.0_f32]), 2.0);
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Table<const D: usize, const N: usize> {
    /// The knots at which pieces meet, along each argument.
    pub axes: [Axis; D],
    /// Coefficients of the pieces, in rows of ascending powers of the distance along the last
    /// argument from the start of the piece. The other powers change from row to row, the last
    /// fastest. An axis has one piece more than it has knots. The first piece precedes the first
    /// knot and is measured from it; the last follows the last knot. Pieces along the last argument
    /// are adjacent.
    pub rows: &'static [[f64; N]],
}

impl<const D: usize, const N: usize> Table<D, N> {
    /// Computes the value; NaN if an argument is NaN.
    #[inline]
    pub fn value<S: Number>(&self, arguments: [S; D]) -> S {
        self.derivative([0; D], arguments)
    }

    /// Computes the derivative of these orders with respect to the arguments; NaN if an argument is
    /// NaN.
    #[inline]
    pub fn derivative<S: Number>(&self, orders: [usize; D], arguments: [S; D]) -> S {
        const { assert!(1 <= D && D <= 3, "a table has one to three arguments") };
        in_groups(|group| {
            let (mut piece, mut distances) = (0, arguments);
            for (axis, distance) in self.axes.iter().zip(&mut distances) {
                let Some((along, from_start)) = axis.find(group, *distance) else { return S::NAN };
                piece = piece * (axis.knots.len() + 1) + along;
                *distance = from_start;
            }
            // Loops over arguments would not be unrolled. Their number is known, so only one of
            // these products is compiled.
            let row = |row: usize| {
                let coefficient = |power: usize| S::from_f64(self.rows[row][power]);
                polynomial(orders[D - 1], distances[D - 1], coefficient, N)
            };
            let rows =
                |block: usize| polynomial(orders[D - 2], distances[D - 2], |power| row(block * N + power), N);
            match D {
                1 => row(piece),
                2 => rows(piece),
                _ => polynomial(orders[0], distances[0], |power| rows(piece * N + power), N),
            }
        })
    }
}

/// Computes a derivative of Σ cᵢ sⁱ with this number of coefficients, by Horner's rule.
#[inline]
fn polynomial<S: Number>(order: usize, s: S, coefficient: impl Fn(usize) -> S, count: usize) -> S {
    let term = |power: usize| coefficient(power) * S::from_f64(falling(power, order));
    let mut powers = (order..count).rev();
    let Some(highest) = powers.next() else { return S::ZERO };
    powers.fold(term(highest), |sum, power| sum.multiply_add(s, term(power)))
}

/// Computes n (n − 1) … (n − k + 1).
#[inline]
fn falling(n: usize, k: usize) -> f64 {
    (0..k).map(|i| (n - i) as f64).product()
}

#[cfg(test)]
mod tests;
