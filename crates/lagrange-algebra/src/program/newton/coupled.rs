//! Newton's method for several equations, by the operations of `root::coupled` in the runtime
//! library. The reasons are explained there.

use super::{MAX_BEND, TOLERANCE};

/// Limits of `root::coupled`.
const LEAST_DECREASE: f64 = 0.5;
const SHORTEST: f64 = 1.0 / 1_073_741_824.0;
const CERTAIN: f64 = 1024.0;
const ASIDE: f64 = 4.0;

const NOISE: f64 = TOLERANCE * f64::EPSILON;

type Vector = Vec<f64>;
type Matrix = Vec<Vector>;

/// A point from which a step is taken.
struct Base {
    point: Vector,
    step: Vector,
    inverse: Matrix,
    scales: Vector,
    weights: Vector,
    rounds: Vector,
    size: f64,
}

/// The values of the equations at a point.
struct Equations {
    residuals: Vector,
    jacobian: Matrix,
    rounding: Vector,
}

impl Equations {
    fn new(values: &[f64], count: usize) -> Equations {
        let (residuals, rest) = values.split_at(count);
        let (jacobian, rounding) = rest.split_at(count * count);
        let jacobian = jacobian.chunks(count).map(<[f64]>::to_vec).collect();
        Equations { residuals: residuals.to_vec(), jacobian, rounding: rounding.to_vec() }
    }
}

/// Returns the common zero that `root::coupled` finds, by the same operations.
pub(super) fn coupled(start: Vector, iterations: u32, equations: impl Fn(&[f64]) -> Vector) -> Vector {
    let count = start.len();
    let unsolved = vec![f64::NAN; count];
    let at = |point: &[f64]| Equations::new(&equations(point), count);
    let mut base = Base {
        step: vec![0.0; count],
        inverse: vec![vec![0.0; count]; count],
        scales: vec![1.0; count],
        weights: vec![0.0; count],
        rounds: vec![1.0; count],
        point: start,
        size: 0.0,
    };
    let (mut left, mut part) = (iterations, 1.0);
    loop {
        let point = after(&base.point, part, &base.step);
        let Equations { residuals, jacobian, rounding } = at(&point);
        let is_small = residuals.iter().zip(&rounding).all(|(r, rounding)| r.abs() <= NOISE * rounding);
        let is_finite = rounding.iter().all(|rounding| *rounding < f64::INFINITY);
        let wanted = base.size * (1.0 - LEAST_DECREASE * part);
        let next = image(&base.inverse, &quotients(&residuals, &base.scales));
        let is_better = squares(&next, &base.weights) <= wanted || is_small;
        if !(is_better && is_finite) {
            if part < SHORTEST {
                return unsolved;
            }
            part *= 0.5;
            continue;
        }
        part = 1.0;
        let scales = rounding.iter().map(|&rounding| if 0.0 < rounding { rounding } else { 1.0 });
        let scales = scales.collect::<Vector>();
        let (inverse, _) = inverted(&scaled(&jacobian, &scales));
        let step = image(&inverse, &quotients(&residuals, &scales));
        let ones = vec![1.0; count];
        let is_regular =
            inverse.iter().zip(&step).all(|(row, s)| magnitude(row, &ones) + s.abs() < f64::INFINITY);
        left -= 1;
        let rounds = rounding.iter().map(|&rounding| if 0.0 < rounding { 1.0 } else { 0.0 }).collect();
        let unit = |(x, step): (&f64, &f64)| x.abs() + step.abs();
        let weight = |unit: f64| if 0.0 < unit { 1.0 / unit } else { 0.0 };
        let weights = point.iter().zip(&step).map(unit).map(weight).collect::<Vector>();
        let size = squares(&step, &weights);
        base = Base { point, step, inverse, scales, weights, rounds, size };
        match (is_small, is_regular) {
            (true, true) => return certified(&base, |point| at(point).jacobian).unwrap_or(unsolved),
            (false, true) if left > 0 => {}
            _ => return unsolved,
        }
    }
}

/// Returns the point after one more step; `None` if it is not a zero.
fn certified(base: &Base, jacobian: impl Fn(&[f64]) -> Matrix) -> Option<Vector> {
    let root = after(&base.point, 1.0, &base.step);
    for (row, value) in base.inverse.iter().zip(&root) {
        let hidden = NOISE * magnitude(row, &base.rounds);
        if hidden <= CERTAIN * f64::EPSILON * value.abs() {
            continue;
        }
        let signs = row.iter().zip(&base.rounds).map(|(&entry, &r)| if entry < 0.0 { -r } else { r });
        let aside = image(&base.inverse, &signs.collect::<Vector>());
        let width = ASIDE * NOISE;
        let keeps = |width| is_oriented_alike(base, &jacobian(&after(&root, width, &aside)));
        if !(keeps(width) && keeps(-width)) {
            return None;
        }
    }
    Some(root)
}

fn is_oriented_alike(base: &Base, jacobian: &Matrix) -> bool {
    let beside = scaled(jacobian, &base.scales);
    let column = |j: usize| image(&base.inverse, &beside.iter().map(|row| row[j]).collect::<Vector>());
    let (_, orientation) = inverted(&(0..beside.len()).map(column).collect::<Matrix>());
    orientation < MAX_BEND && 1.0 < MAX_BEND * orientation
}

fn squares(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + (a * b) * (a * b))
}

fn quotients(a: &[f64], b: &[f64]) -> Vector {
    a.iter().zip(b).map(|(a, b)| a / b).collect()
}

fn magnitude(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + (a * b).abs())
}

fn image(rows: &[Vector], vector: &[f64]) -> Vector {
    let value = |row: &Vector| row.iter().zip(vector).fold(0.0, |sum, (entry, value)| sum + entry * value);
    rows.iter().map(value).collect()
}

fn scaled(rows: &[Vector], scales: &[f64]) -> Matrix {
    let divided = |(row, scale): (&Vector, &f64)| row.iter().map(|entry| entry / scale).collect();
    rows.iter().zip(scales).map(divided).collect()
}

fn after(x: &[f64], part: f64, step: &[f64]) -> Vector {
    x.iter().zip(step).map(|(x, step)| x - part * step).collect()
}

/// Returns the inverse of a matrix, and its determinant.
fn inverted(matrix: &[Vector]) -> (Matrix, f64) {
    let unit = |i: usize| (0..matrix.len()).map(move |j| if i == j { 1.0 } else { 0.0 });
    let rows = matrix.iter().enumerate().map(|(i, row)| row.iter().copied().chain(unit(i)).collect());
    let mut rows = rows.collect::<Matrix>();
    let mut determinant = 1.0;
    for k in 0..rows.len() {
        for i in k + 1..rows.len() {
            if rows[k][k].abs() < rows[i][k].abs() {
                rows.swap(k, i);
                determinant = -determinant;
            }
        }
        let pivot = rows[k][k];
        determinant *= pivot;
        let of_pivot = rows[k].iter().map(|entry| entry / pivot).collect::<Vector>();
        for (i, row) in rows.iter_mut().enumerate() {
            *row = if i == k { of_pivot.clone() } else { after(row, row[k], &of_pivot) };
        }
    }
    (rows.into_iter().map(|row| row[matrix.len()..].to_vec()).collect(), determinant)
}
