//! Derivatives at the points of a grid, for piecewise bicubic surfaces that are monotone where the
//! values are.
//!
//! Let values rise along x on both edges of a cell of size h × k. At any y, the surface is a cubic
//! of x. It rises if its slopes at both ends are between zero and three times its secant.
//! Source: de Boor and Swartz, "Piecewise monotone interpolation", Journal of Approximation
//! Theory 21 (1977) 411–416.
//!
//! Slopes and secants are themselves cubics of y. They satisfy this for all y if their
//! Bernstein coefficients do, with the secant Δ/h on an edge:
//!
//! ```text
//! 0 ≤ fₓ ≤ 3 Δ/h,    0 ≤ fₓ + k fₓᵧ/3 ≤ 3 (Δ + k δ/3)/h
//! ```
//!
//! Here, δ is the difference of fᵧ between the ends of the edge, and the opposite edge has −k.
//! These are the conditions of Carlson and Fritsch, "Monotone piecewise bicubic interpolation",
//! SIAM Journal on Numerical Analysis 22 (1985) 386–400, who choose derivatives differently.
//!
//! The slopes of splines along the grid satisfy the first condition. The second one admits fₓᵧ = 0
//! if k |δ| ≤ 3 Δ − h fₓ. Therefore slopes are reduced until their differences do not exceed this
//! bound, formed by the slopes before reduction. Reduced slopes along the other argument satisfy it
//! all the more. The twist fₓᵧ is then as close to the mean of the adjacent cells as all conditions
//! allow.

use std::array::from_fn;

use super::spline::{Interpolation, slopes};

/// Values at the points of a grid, those along the second axis changing fastest.
struct Grid<'a> {
    axes: [&'a [f64]; 2],
    values: Vec<f64>,
}

/// Computes values, derivatives with respect to the second argument, to the first, and to both.
pub(super) fn monotone_derivatives(axes: [&[f64]; 2], values: &[f64]) -> [Vec<f64>; 4] {
    let grid = Grid { axes, values: values.to_vec() };
    let turned = Grid { axes: [axes[1], axes[0]], values: grid.transposed(values) };
    let (by_second, by_first) = (grid.slopes(), turned.slopes());
    let second = grid.reduced(&by_second, &turned.transposed(&by_first));
    let first = turned.reduced(&by_first, &grid.transposed(&by_second));
    let [first, second_turned] = [turned.transposed(&first), grid.transposed(&second)];
    let along_first = grid.twists(&first, &second);
    let along_second = turned.twists(&second_turned, &grid.transposed(&first));
    let along_second = turned.transposed(&along_second);
    let twists = (0..values.len()).map(|index| {
        let ends = from_fn(|end| [along_first[index][end], along_second[index][end]]);
        let [lows, highs] = ends;
        grid.mean_twist(index).clamp(lows[0].max(lows[1]), highs[0].min(highs[1]))
    });
    let twists = twists.collect();
    [grid.values, second, first, twists]
}

impl Grid<'_> {
    /// Returns the number of points along the second axis.
    fn columns(&self) -> usize {
        self.axes[1].len()
    }

    /// Returns what belongs to the points of this grid in the order of the grid with both axes
    /// exchanged.
    fn transposed<T: Copy>(&self, items: &[T]) -> Vec<T> {
        let (rows, columns) = (self.axes[0].len(), self.columns());
        (0..items.len()).map(|index| items[index % rows * columns + index / rows]).collect()
    }

    /// Returns the slopes of monotone splines along the second axis.
    fn slopes(&self) -> Vec<f64> {
        let rows = self.values.chunks(self.columns());
        rows.flat_map(|row| slopes(self.axes[1], row, Interpolation::Monotone)).collect()
    }

    /// Returns the indices of the ends of the interval after a point along the first axis.
    fn ends(&self, index: usize) -> [usize; 2] {
        [index, index + self.columns()]
    }

    /// Returns how much values change along the first axis, up to the point after this one.
    fn rise(&self, index: usize) -> f64 {
        let [start, end] = self.ends(index);
        self.values[end] - self.values[start]
    }

    /// Returns the cells beside an interval along the first axis, once for each sign with which
    /// their values do not fall along it. Items are the direction in which the cell lies, its
    /// length along the second axis, and the sign.
    fn cells(&self, index: usize) -> impl Iterator<Item = (f64, f64, f64)> {
        let (column, knots, rise) = (index % self.columns(), self.axes[1], self.rise(index));
        let before = (column > 0).then(|| (-1.0, knots[column] - knots[column - 1], self.rise(index - 1)));
        let after = (column + 1 < knots.len())
            .then(|| (1.0, knots[column + 1] - knots[column], self.rise(index + 1)));
        let cells = before.into_iter().chain(after);
        cells.flat_map(move |(direction, length, opposite)| {
            let signs = [1.0, -1.0].into_iter();
            let signs = signs.filter(move |sign| sign * rise >= 0.0 && sign * opposite >= 0.0);
            signs.map(move |sign| (direction, length, sign))
        })
    }

    /// Reduces slopes along the second axis, such that their differences along the first axis leave
    /// room for these slopes along the first axis.
    fn reduced(&self, slopes: &[f64], first: &[f64]) -> Vec<f64> {
        let mut slopes = slopes.to_vec();
        let intervals = (0..slopes.len() - self.columns()).collect::<Vec<_>>();
        for index in intervals.iter().chain(intervals.iter().rev()) {
            let ends = self.ends(*index);
            let bounds = self.difference_bounds(*index, ends.map(|end| first[end]));
            for (end, slope) in ends.into_iter().zip(drawn_together(ends.map(|end| slopes[end]), bounds)) {
                slopes[end] = slope;
            }
        }
        slopes
    }

    /// Returns bounds of the difference of slopes along the second axis between the ends of an
    /// interval along the first axis. They contain zero.
    fn difference_bounds(&self, index: usize, first: [f64; 2]) -> [f64; 2] {
        let length = self.length(index);
        let steepest = first[0].abs().max(first[1].abs());
        let room = (3.0 * self.rise(index).abs() - length * steepest).max(0.0);
        self.cells(index).fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], (direction, width, sign)| {
            match direction * sign > 0.0 {
                true => [low.max(-room / width), high],
                false => [low, high.min(room / width)],
            }
        })
    }

    /// Returns the length of the interval along the first axis after a point.
    fn length(&self, index: usize) -> f64 {
        let row = index / self.columns();
        self.axes[0][row + 1] - self.axes[0][row]
    }

    /// Returns the least and the greatest twist at each point with which the surface is monotone
    /// along the first axis. They contain zero.
    fn twists(&self, first: &[f64], second: &[f64]) -> Vec<[f64; 2]> {
        let mut bounds = vec![[f64::NEG_INFINITY, f64::INFINITY]; first.len()];
        for index in 0..first.len() - self.columns() {
            let (length, ends) = (self.length(index), self.ends(index));
            let difference = second[ends[1]] - second[ends[0]];
            for (direction, width, sign) in self.cells(index) {
                let secant = (3.0 * self.rise(index) + direction * width * difference) / length;
                for end in ends {
                    let slopes = [-sign * first[end], sign * (secant - first[end])];
                    // Rounding errors must not exclude zero.
                    let [low, high] = slopes.map(|slope| 3.0 * slope / width);
                    let [low, high] = [low.min(0.0), high.max(0.0)];
                    let ends = if direction * sign > 0.0 { [low, high] } else { [-high, -low] };
                    bounds[end] = [bounds[end][0].max(ends[0]), bounds[end][1].min(ends[1])];
                }
            }
        }
        bounds
    }

    /// Returns the mean twist of the bilinear surfaces around a point.
    fn mean_twist(&self, index: usize) -> f64 {
        let place = [index / self.columns(), index % self.columns()];
        let intervals = [0, 1].map(|axis| {
            let last = self.axes[axis].len() - 1;
            place[axis].saturating_sub(1)..(place[axis] + 1).min(last)
        });
        let [rows, columns] = intervals;
        let count = (rows.len() * columns.len()) as f64;
        let cells = rows.flat_map(|row| columns.clone().map(move |column| (row, column)));
        let twist = |(row, column): (usize, usize)| {
            let (index, knots) = (row * self.columns() + column, self.axes[1]);
            let area = self.length(index) * (knots[column + 1] - knots[column]);
            (self.rise(index + 1) - self.rise(index)) / area
        };
        cells.map(twist).sum::<f64>() / count
    }
}

/// Reduces the magnitudes of two slopes as little as their difference requires, whose bounds
/// contain zero. Slopes of opposite signs are reduced to one half of the difference each.
///
/// One pass along a line and one pass back satisfy all bounds, as for shortest paths: a slope is
/// never reduced below the next one.
fn drawn_together([start, end]: [f64; 2], [low, high]: [f64; 2]) -> [f64; 2] {
    let bound = if end < start { low } else { high };
    let is_within = (end - start).abs() <= bound.abs();
    let are_opposite = start != 0.0 && end != 0.0 && (start < 0.0) != (end < 0.0);
    match (is_within, are_opposite) {
        (true, _) => [start, end],
        (false, true) => [start, end].map(|slope| slope.signum() * slope.abs().min(0.5 * bound.abs())),
        (false, false) if start.abs() < end.abs() => [start, start + bound],
        (false, false) => [end - bound, end],
    }
}
