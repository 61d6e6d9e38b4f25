//! Tables: piecewise polynomial functions, between and beyond the points of a declaration.
//!
//! With one argument, a table is a spline. With two, it is the tensor product of two splines, since
//! splines depend linearly on the values that they interpolate. The coefficients of the splines
//! along one axis are interpolated along the other.

use crate::elementary::multiply_add;

use super::spline::{Interpolation, Outside, pieces};

/// A piecewise polynomial function.
#[derive(Clone, PartialEq, Debug)]
pub struct Table {
    /// Boundaries of pieces, for each argument.
    pub axes: Vec<Axis>,
    /// Interpolation between the points.
    pub interpolation: Interpolation,
    /// Values beyond the first and the last point.
    pub outside: Outside,
    /// Coefficients of the pieces, including those before the first knot and after the last. They
    /// belong to ascending powers of the distance from the start of a piece. With two arguments,
    /// both coefficients and pieces are in rows.
    pub coefficients: Vec<f64>,
}

/// Knots along one argument.
#[derive(Clone, PartialEq, Debug)]
pub struct Axis {
    /// At least two numbers, ascending.
    pub knots: Vec<f64>,
    /// Pieces per unit of length, if they are equally long; 0 otherwise.
    pub density: f64,
}

/// Relative error, with respect to the largest knot, up to which distances count as equal. An
/// argument assigned to an adjacent piece is then evaluated by the continuation of that piece.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Rounding error of a value, as a fraction of the largest one, for points with reasonable spacing.
const MISSED: f64 = 1e-9;

impl Axis {
    /// Creates an axis from knots, which must ascend.
    pub fn new(knots: Vec<f64>) -> Axis {
        let (first, last) = (knots[0], knots[knots.len() - 1]);
        let intervals = (knots.len() - 1) as f64;
        let step = (last - first) / intervals;
        let error = ROUNDING * first.abs().max(last.abs());
        let is_even =
            knots.iter().enumerate().all(|(i, knot)| (first + step * i as f64 - knot).abs() <= error);
        let density = intervals / (last - first);
        // The density is infinite if knots are close to the smallest normal number.
        Axis { knots, density: if is_even && density.is_finite() { density } else { 0.0 } }
    }

    /// Returns the largest magnitude of a knot.
    pub fn largest_knot(&self) -> f64 {
        self.knots.iter().fold(0.0, |largest: f64, knot| largest.max(knot.abs()))
    }

    /// Returns the number of pieces, including those beyond the ends.
    fn pieces(&self) -> usize {
        self.knots.len() + 1
    }

    /// Returns the ends of the piece that contains a number; infinite beyond the first and the last
    /// knot, NaN for NaN.
    pub fn piece(&self, x: f64) -> [f64; 2] {
        let Some((piece, _)) = self.find(x) else { return [f64::NAN; 2] };
        let before = piece.checked_sub(1).map_or(f64::NEG_INFINITY, |knot| self.knots[knot]);
        [before, self.knots.get(piece).copied().unwrap_or(f64::INFINITY)]
    }

    /// Finds the piece that contains a number, and its distance from the start of the piece; `None`
    /// for NaN.
    fn find(&self, x: f64) -> Option<(usize, f64)> {
        let (knots, count) = (&self.knots, self.knots.len());
        let piece = if x.is_nan() {
            return None;
        } else if x < knots[0] {
            0
        } else if x > knots[count - 1] {
            count
        } else if self.density > 0.0 {
            1 + (((x - knots[0]) * self.density) as usize).min(count - 2)
        } else {
            1 + knots[1..count - 1].partition_point(|knot| *knot <= x)
        };
        Some((piece, x - knots[piece.saturating_sub(1)]))
    }
}

impl Table {
    /// Creates a table of one argument through at least two points whose first components ascend.
    pub fn curve(points: &[(f64, f64)], interpolation: Interpolation, outside: Outside) -> Table {
        let (knots, values): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
        let coefficients = pieces(&knots, &values, interpolation, outside).concat();
        Table { axes: vec![Axis::new(knots)], interpolation, outside, coefficients }
    }

    /// Creates a table of two arguments with these values, in rows for each knot of the first
    /// argument. It only supports interpolations that depend linearly on the values.
    pub fn surface(
        [along_x, along_y]: [Vec<f64>; 2],
        values: &[Vec<f64>],
        interpolation: Interpolation,
        outside: Outside,
    ) -> Table {
        let rows = values.iter().map(|row| pieces(&along_y, row, interpolation, outside).concat());
        let rows = rows.collect::<Vec<_>>();
        let size = interpolation.coefficients();
        let (columns, per_row) = (rows[0].len(), along_y.len() + 1);
        // A spline along x through each coefficient of the splines along y.
        let splines = (0..columns).map(|column| {
            let values = rows.iter().map(|row| row[column]).collect::<Vec<_>>();
            pieces(&along_x, &values, interpolation, outside)
        });
        let splines = splines.collect::<Vec<_>>();
        let mut coefficients = Vec::with_capacity((along_x.len() + 1) * columns * size);
        for (i, j) in (0..=along_x.len()).flat_map(|i| (0..per_row).map(move |j| (i, j))) {
            let of_piece = &splines[j * size..][..size];
            coefficients
                .extend((0..size).flat_map(|power| of_piece.iter().map(move |along_x| along_x[i][power])));
        }
        let axes = vec![Axis::new(along_x), Axis::new(along_y)];
        Table { axes, interpolation, outside, coefficients }
    }

    /// Returns the largest magnitude of a value at the start of a piece.
    pub fn largest_value(&self) -> f64 {
        let size = self.interpolation.coefficients().pow(self.axes.len() as u32);
        let values = self.coefficients.iter().step_by(size).filter(|value| value.is_finite());
        values.fold(0.0, |largest: f64, value| largest.max(value.abs()))
    }

    /// Returns the order up to which derivatives are continuous wherever the table is defined.
    pub fn continuous_orders(&self) -> u8 {
        match (self.interpolation, self.outside) {
            (Interpolation::Linear, _) | (_, Outside::Clamp) => 0,
            (Interpolation::Monotone, _) => 1,
            (Interpolation::Natural, _) => 2,
        }
    }

    /// True if a derivative vanishes on every piece.
    pub fn vanishes(&self, orders: &[u8]) -> bool {
        orders.iter().any(|order| usize::from(*order) >= self.interpolation.coefficients())
    }

    /// True if second derivatives are continuous.
    pub fn is_twice_differentiable(&self) -> bool {
        self.interpolation == Interpolation::Natural && self.outside != Outside::Clamp
    }

    /// True if all polynomials have finite coefficients, including those beyond the points unless
    /// the table is undefined there.
    pub fn is_finite(&self) -> bool {
        let per_row = self.axes.last().map_or(1, Axis::pieces);
        let is_between = |axis: &Axis, piece: usize| (1..axis.knots.len()).contains(&piece);
        let are_between = |piece: usize| match &self.axes[..] {
            [along_x, along_y] => {
                is_between(along_x, piece / per_row) && is_between(along_y, piece % per_row)
            }
            axes => axes.iter().all(|axis| is_between(axis, piece)),
        };
        let size = self.interpolation.coefficients().pow(self.axes.len() as u32);
        let mut pieces = self.coefficients.chunks(size).enumerate();
        let has_end = self.outside == Outside::Error;
        pieces
            .all(|(piece, of_piece)| has_end && !are_between(piece) || of_piece.iter().all(|c| c.is_finite()))
    }

    /// True if each polynomial ends at the value where the next one starts. Values are in rows, as
    /// in [`Table::surface`].
    ///
    /// If distances between points differ by many orders of magnitude, a spline oscillates so
    /// strongly that rounding errors exceed the values.
    pub fn goes_through(&self, values: &[f64]) -> bool {
        let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let is_met = |found: f64, value: f64| (found - value).abs() <= MISSED * largest;
        let ends = |axis: &Axis| 1..axis.knots.len();
        let end = |axis: &Axis, piece: usize| (piece, axis.knots[piece] - axis.knots[piece - 1]);
        match &self.axes[..] {
            [axis] => ends(axis).all(|i| is_met(self.piece_value(&[0], &[end(axis, i)]), values[i])),
            [along_x, along_y] => ends(along_x).all(|i| {
                let row = &values[i * along_y.knots.len()..];
                ends(along_y)
                    .all(|j| is_met(self.piece_value(&[0, 0], &[end(along_x, i), end(along_y, j)]), row[j]))
            }),
            _ => false,
        }
    }

    /// Computes a value or a derivative like emitted code; NaN for NaN.
    pub fn value(&self, orders: &[u8], arguments: &[f64]) -> f64 {
        let places = self.axes.iter().zip(arguments).map(|(axis, x)| axis.find(*x));
        let places = places.collect::<Option<Vec<_>>>();
        places.map_or(f64::NAN, |places| self.piece_value(orders, &places))
    }

    /// Computes a value or a derivative of a polynomial at distances from its start.
    fn piece_value(&self, orders: &[u8], places: &[(usize, f64)]) -> f64 {
        let size = self.interpolation.coefficients();
        match (&self.axes[..], orders, places) {
            ([_], [order], [(piece, s)]) => {
                polynomial(&self.coefficients[piece * size..][..size], usize::from(*order), *s)
            }
            ([_, along_y], [by_x, by_y], [(i, s), (j, r)]) => {
                let piece = (i * along_y.pieces() + j) * size * size;
                let rows = self.coefficients[piece..][..size * size].chunks(size);
                let along_x = rows.map(|row| polynomial(row, usize::from(*by_y), *r)).collect::<Vec<_>>();
                polynomial(&along_x, usize::from(*by_x), *s)
            }
            _ => f64::NAN,
        }
    }
}

/// Computes a derivative of this order of Σ cᵢ sⁱ, by Horner's rule.
fn polynomial(coefficients: &[f64], order: usize, s: f64) -> f64 {
    let terms = coefficients.iter().enumerate().skip(order).rev();
    let mut terms = terms.map(|(power, coefficient)| coefficient * falling(power, order));
    let Some(highest) = terms.next() else { return 0.0 };
    terms.fold(highest, |sum, term| multiply_add(sum, s, term))
}

/// Returns n (n − 1) … (n − k + 1).
fn falling(n: usize, k: usize) -> f64 {
    (0..k).map(|i| (n - i) as f64).product()
}
