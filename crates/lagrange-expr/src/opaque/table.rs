//! Tables: piecewise polynomial functions, between and beyond the points of a declaration.
//!
//! With one argument, a table is a spline. With several, it is a tensor product of splines: the
//! coefficients of the splines along the last axes are interpolated along the first. Linear and
//! natural splines depend linearly on values, so their products need no more than these. Monotone
//! tables of two arguments have slopes and twists from [`surface`](super::surface).

use crate::elementary::multiply_add;

use super::spline::{Interpolation, Outside, pieces, slopes};
use super::surface::monotone_derivatives;

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
    /// belong to ascending powers of the distance from the start of a piece. The piece along the
    /// last argument changes fastest, and so does the power of its distance within a piece.
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
    /// Creates a table with these values at the points of a grid, those along the last axis
    /// changing fastest. Each axis has at least two knots, which ascend. Tables of more than two
    /// arguments cannot be monotone.
    pub fn new(axes: Vec<Vec<f64>>, values: &[f64], interpolation: Interpolation, outside: Outside) -> Table {
        let coefficients = match (interpolation, &axes[..]) {
            (Interpolation::Monotone, [rows, columns]) => {
                products(&axes, &monotone_derivatives([rows, columns], values), interpolation, outside)
            }
            _ => products(&axes, &[values.to_vec()], interpolation, outside),
        };
        Table { axes: axes.into_iter().map(Axis::new).collect(), interpolation, outside, coefficients }
    }

    /// Returns the largest magnitude of a value at the start of a piece.
    pub fn largest_value(&self) -> f64 {
        let values = self.coefficients.iter().step_by(self.piece_size()).filter(|value| value.is_finite());
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
        let are_between = |mut piece: usize| {
            self.axes.iter().rev().all(|axis| {
                let along = piece % axis.pieces();
                piece /= axis.pieces();
                (1..axis.knots.len()).contains(&along)
            })
        };
        let mut pieces = self.coefficients.chunks(self.piece_size()).enumerate();
        let has_end = self.outside == Outside::Error;
        pieces
            .all(|(piece, of_piece)| has_end && !are_between(piece) || of_piece.iter().all(|c| c.is_finite()))
    }

    /// True if each polynomial ends at the value where the next one starts. Values are in the order
    /// of [`Table::new`].
    ///
    /// If distances between points differ by many orders of magnitude, a spline oscillates so
    /// strongly that rounding errors exceed the values.
    pub fn goes_through(&self, values: &[f64]) -> bool {
        let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let orders = vec![0; self.axes.len()];
        values.iter().enumerate().all(|(mut index, value)| {
            let ends = self.axes.iter().rev().map(|axis| {
                let knot = index % axis.knots.len();
                index /= axis.knots.len();
                (knot, axis.knots[knot] - axis.knots[knot.saturating_sub(1)])
            });
            let mut ends = ends.collect::<Vec<_>>();
            ends.reverse();
            // No polynomial ends at a first knot.
            ends.iter().any(|(piece, _)| *piece == 0)
                || (self.piece_value(&orders, &ends) - value).abs() <= MISSED * largest
        })
    }

    /// Computes a value or a derivative like emitted code; NaN for NaN.
    pub fn value(&self, orders: &[u8], arguments: &[f64]) -> f64 {
        let places = self.axes.iter().zip(arguments).map(|(axis, x)| axis.find(*x));
        let places = places.collect::<Option<Vec<_>>>();
        places.map_or(f64::NAN, |places| self.piece_value(orders, &places))
    }

    /// Computes a value or a derivative of a polynomial at distances from its start.
    fn piece_value(&self, orders: &[u8], places: &[(usize, f64)]) -> f64 {
        let piece = self.axes.iter().zip(places).fold(0, |index, (axis, (i, _))| index * axis.pieces() + i);
        let size = self.piece_size();
        product(&self.coefficients[piece * size..][..size], self.interpolation.coefficients(), orders, places)
    }

    /// Returns the number of coefficients of each piece.
    fn piece_size(&self) -> usize {
        self.interpolation.coefficients().pow(self.axes.len() as u32)
    }
}

/// Returns the coefficients of a table: splines along the first axis through each coefficient of
/// the splines along the others.
///
/// The values at the grid may be followed by their derivatives with respect to the last argument,
/// to the first, and to both.
fn products(
    axes: &[Vec<f64>],
    derivatives: &[Vec<f64>],
    interpolation: Interpolation,
    outside: Outside,
) -> Vec<f64> {
    let Some((first, others)) = axes.split_first() else { return derivatives[0].clone() };
    // Each column holds one coefficient of the others at all knots.
    let columns = |derivatives: &[Vec<f64>]| {
        let at_knot = |knot: usize| {
            let row = |values: &Vec<f64>| {
                let size = values.len() / first.len();
                values[knot * size..][..size].to_vec()
            };
            products(others, &derivatives.iter().map(row).collect::<Vec<_>>(), interpolation, outside)
        };
        let at_knots = (0..first.len()).map(at_knot).collect::<Vec<_>>();
        let column = |index: usize| at_knots.iter().map(|coefficients| coefficients[index]).collect();
        (0..at_knots[0].len()).map(column).collect::<Vec<Vec<f64>>>()
    };
    let (values, along_first) = derivatives.split_at(derivatives.len().div_ceil(2));
    let values = columns(values);
    let slopes = match along_first {
        [] => values.iter().map(|values| slopes(first, values, interpolation)).collect(),
        _ => columns(along_first),
    };
    let splines = values.iter().zip(&slopes);
    let splines = splines.map(|(values, slopes)| pieces(first, values, slopes, interpolation, outside));
    let splines = splines.collect::<Vec<_>>();
    let size = interpolation.coefficients();
    let of_pieces = (0..=first.len())
        .flat_map(|i| splines.chunks(size.pow(others.len() as u32)).map(move |of_piece| (i, of_piece)));
    of_pieces
        .flat_map(|(i, of_piece)| {
            (0..size).flat_map(move |power| of_piece.iter().map(move |spline| spline[i][power]))
        })
        .collect()
}

/// Computes a derivative of a product of polynomials with this number of coefficients each.
fn product(coefficients: &[f64], count: usize, orders: &[u8], places: &[(usize, f64)]) -> f64 {
    let ([order, orders @ ..], [(_, s), places @ ..]) = (orders, places) else { return coefficients[0] };
    let size = coefficients.len() / count;
    let coefficient = |power: usize| product(&coefficients[power * size..][..size], count, orders, places);
    polynomial(coefficient, count, usize::from(*order), *s)
}

/// Computes a derivative of this order of Σ cᵢ sⁱ with this number of coefficients, by Horner's
/// rule.
fn polynomial(coefficient: impl Fn(usize) -> f64, count: usize, order: usize, s: f64) -> f64 {
    let mut terms = (order..count).rev().map(|power| coefficient(power) * falling(power, order));
    let Some(highest) = terms.next() else { return 0.0 };
    terms.fold(highest, |sum, term| multiply_add(sum, s, term))
}

/// Returns n (n − 1) … (n − k + 1).
fn falling(n: usize, k: usize) -> f64 {
    (0..k).map(|i| (n - i) as f64).product()
}
