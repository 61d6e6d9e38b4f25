//! Tables as piecewise polynomials in many digits.
//!
//! Sources: de Boor, *A Practical Guide to Splines*, chapter IV, for natural splines, here by their
//! second derivatives; Fritsch and Carlson, "Monotone piecewise cubic interpolation", SIAM Journal
//! on Numerical Analysis 17 (1980) 238–246.

use crate::digits::{Arithmetic, Real};
use crate::jet::{Field, Jet};
use crate::linear::solve;
use crate::tree::Table;

/// Knots, and coefficients of ascending powers from the beginning of each piece.
pub(crate) struct Spline {
    knots: Vec<Real>,
    pieces: Vec<Vec<Real>>,
    outside: &'static str,
}

impl Spline {
    pub(crate) fn new(arithmetic: &mut Arithmetic, table: &Table) -> Spline {
        let mut column = |of: fn(&(String, String)) -> &String| {
            table.points.iter().map(|point| arithmetic.decimal(of(point))).collect::<Vec<_>>()
        };
        let (knots, values) = (column(|(x, _)| x), column(|(_, y)| y));
        let points = Points::new(arithmetic, &knots, &values);
        let last = knots.len() - 2;
        let pieces = match table.interpolation {
            "linear" => (0..=last).map(|i| vec![values[i].clone(), points.secants[i].clone()]).collect(),
            "monotone" => {
                let slopes = points.monotone_slopes();
                (0..=last).map(|i| points.hermite(i, [&slopes[i], &slopes[i + 1]])).collect()
            }
            _ => {
                let bends = points.natural_bends();
                (0..=last).map(|i| points.bent(i, [&bends[i], &bends[i + 1]])).collect()
            }
        };
        Spline { knots, pieces, outside: table.outside }
    }

    /// Returns the value along a motion, or `None` where there is none.
    pub(crate) fn value(&self, field: &mut Field, x: &Jet) -> Option<Jet> {
        let is_beyond = |knot: &Real| knot.cmp(&x.value[0]).is_some_and(|order| order <= 0);
        let before = self.knots.iter().take_while(|knot| is_beyond(knot)).count();
        let count = self.pieces.len();
        let is_outside = before == 0 || before > count && x.value[0].cmp(&self.knots[count])? > 0;
        let piece = before.saturating_sub(1).min(count - 1);
        match (is_outside, self.outside) {
            (false, _) => Some(Spline::polynomial(field, &self.pieces[piece], x, &self.knots[piece])),
            (true, "error") => None,
            (true, outside) => {
                let end = if before == 0 { 0 } else { count };
                let at_end = field.series(&self.knots[end..=end]);
                let start = &self.knots[piece];
                let value = Spline::polynomial(field, &self.pieces[piece], &at_end, start);
                if outside == "clamp" {
                    return Some(value);
                }
                let slope = self.slope(field, piece, &at_end);
                let beyond = field.subtract(x, &at_end);
                let rise = field.multiply(&slope, &beyond);
                Some(field.add(&value, &rise))
            }
        }
    }

    fn slope(&self, field: &mut Field, piece: usize, at: &Jet) -> Jet {
        let powers = self.pieces[piece].iter().enumerate().skip(1);
        let derived = powers.map(|(k, c)| field.product(&field.integer(k as i32), c)).collect::<Vec<_>>();
        Spline::polynomial(field, &derived, at, &self.knots[piece])
    }

    fn polynomial(field: &mut Field, coefficients: &[Real], x: &Jet, start: &Real) -> Jet {
        let start = field.series(std::slice::from_ref(start));
        let from_start = field.subtract(x, &start);
        let zero = field.whole(0);
        coefficients.iter().rev().fold(zero, |sum, coefficient| {
            let coefficient = field.constant(coefficient.clone());
            let product = field.multiply(&sum, &from_start);
            field.add(&product, &coefficient)
        })
    }
}

/// The points of a spline.
struct Points<'a> {
    arithmetic: &'a Arithmetic,
    values: &'a [Real],
    steps: Vec<Real>,
    secants: Vec<Real>,
}

impl<'a> Points<'a> {
    fn new(arithmetic: &'a Arithmetic, knots: &[Real], values: &'a [Real]) -> Points<'a> {
        let steps = knots.windows(2).map(|pair| arithmetic.subtract(&pair[1], &pair[0])).collect::<Vec<_>>();
        let rises = values.windows(2).map(|pair| arithmetic.subtract(&pair[1], &pair[0]));
        let secants = rises.zip(&steps).map(|(rise, step)| arithmetic.divide(&rise, step)).collect();
        Points { arithmetic, values, steps, secants }
    }

    fn times(&self, factor: i32, of: &Real) -> Real {
        self.arithmetic.multiply(&self.arithmetic.integer(factor), of)
    }

    /// Returns means of the secants on both sides, 0 at turning points, within the circle α² + β² = 9.
    fn monotone_slopes(&self) -> Vec<Real> {
        let (a, secants) = (self.arithmetic, &self.secants);
        let mut slopes = vec![secants[0].clone()];
        for pair in secants.windows(2) {
            let turns = !a.multiply(&pair[0], &pair[1]).is_positive() || pair.iter().any(Real::is_zero);
            let sum = a.add(&pair[0], &pair[1]);
            slopes.push(if turns { a.integer(0) } else { a.divide(&sum, &a.integer(2)) });
        }
        slopes.push(secants[secants.len() - 1].clone());
        for (i, secant) in secants.iter().enumerate() {
            if secant.is_zero() {
                (slopes[i], slopes[i + 1]) = (a.integer(0), a.integer(0));
                continue;
            }
            let shares = [a.divide(&slopes[i], secant), a.divide(&slopes[i + 1], secant)];
            let radius = a.sqrt(&a.dot(&shares, &shares));
            if a.subtract(&radius, &a.integer(3)).is_positive() {
                let factor = a.divide(&self.times(3, secant), &radius);
                let [left, right] = shares.map(|share| a.multiply(&factor, &share));
                (slopes[i], slopes[i + 1]) = (left, right);
            }
        }
        slopes
    }

    /// Returns the cubic with these slopes at the ends of an interval.
    fn hermite(&self, i: usize, [left, right]: [&Real; 2]) -> Vec<Real> {
        let (a, h, secant) = (self.arithmetic, &self.steps[i], &self.secants[i]);
        let sum = a.add(left, right);
        let second = a.subtract(&self.times(3, secant), &a.add(&sum, left));
        let third = a.subtract(&sum, &self.times(2, secant));
        let square = a.multiply(h, h);
        vec![self.values[i].clone(), left.clone(), a.divide(&second, h), a.divide(&third, &square)]
    }

    /// Returns second derivatives m with hᵢ₋₁ mᵢ₋₁ + 2 (hᵢ₋₁ + hᵢ) mᵢ + hᵢ mᵢ₊₁ = 6 (sᵢ − sᵢ₋₁),
    /// zero at both ends.
    fn natural_bends(&self) -> Vec<Real> {
        let (a, h) = (self.arithmetic, &self.steps);
        let inner = h.len() - 1;
        let entry = |row: usize, column: usize| match column + 1 {
            next if next == row => h[row].clone(),
            next if next == row + 1 => self.times(2, &a.add(&h[row], &h[row + 1])),
            next if next == row + 2 => h[row + 1].clone(),
            _ => a.integer(0),
        };
        let matrix = (0..inner * inner).map(|k| entry(k / inner, k % inner)).collect::<Vec<_>>();
        let right = self.secants.windows(2).map(|pair| self.times(6, &a.subtract(&pair[1], &pair[0])));
        let bends = solve(a, &matrix, &right.collect::<Vec<_>>()).expect("the matrix is diagonally dominant");
        let end = || std::iter::once(a.integer(0));
        end().chain(bends).chain(end()).collect()
    }

    /// Returns the cubic with these second derivatives at the ends of an interval.
    fn bent(&self, i: usize, [left, right]: [&Real; 2]) -> Vec<Real> {
        let (a, h) = (self.arithmetic, &self.steps[i]);
        let sum = a.add(&self.times(2, left), right);
        let drop = a.divide(&a.multiply(h, &sum), &a.integer(6));
        let slope = a.subtract(&self.secants[i], &drop);
        let third = a.divide(&a.subtract(right, left), &self.times(6, h));
        vec![self.values[i].clone(), slope, a.divide(left, &a.integer(2)), third]
    }
}
