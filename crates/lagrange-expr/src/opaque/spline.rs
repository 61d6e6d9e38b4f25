//! Splines through points: the polynomials between points, and their continuation beyond.
//!
//! Sources: de Boor, *A Practical Guide to Splines*, chapter IV, for the natural spline; Fritsch
//! and Carlson, "Monotone piecewise cubic interpolation", SIAM Journal on Numerical Analysis 17
//! (1980) 238–246, for slopes that keep monotone data monotone.

/// Function between the points of a table.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Interpolation {
    /// Straight lines. Continuous.
    Linear,
    /// Cubics that are monotone wherever the points are. Once continuously differentiable.
    Monotone,
    /// Cubics without curvature at both ends. Twice continuously differentiable.
    Natural,
}

/// Function beyond the points of a table.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outside {
    /// No value: NaN.
    Error,
    /// The value at the end.
    Clamp,
    /// The tangent at the end.
    Extend,
}

impl Interpolation {
    /// Every interpolation, by name.
    pub const ALL: [(&'static str, Interpolation); 3] = [
        ("linear", Interpolation::Linear),
        ("monotone", Interpolation::Monotone),
        ("natural", Interpolation::Natural),
    ];

    /// Returns the name in declarations.
    pub fn name(self) -> &'static str {
        Interpolation::ALL.iter().find(|(_, way)| *way == self).map_or("", |(name, _)| name)
    }

    /// Returns the number of coefficients of each polynomial.
    pub fn coefficients(self) -> usize {
        if self == Interpolation::Linear { 2 } else { 4 }
    }
}

impl Outside {
    /// Every continuation, by name.
    pub const ALL: [(&'static str, Outside); 3] =
        [("error", Outside::Error), ("clamp", Outside::Clamp), ("extend", Outside::Extend)];

    /// Returns the name in declarations.
    pub fn name(self) -> &'static str {
        Outside::ALL.iter().find(|(_, way)| *way == self).map_or("", |(name, _)| name)
    }
}

/// Computes the slopes of a spline at its knots.
pub(super) fn slopes(knots: &[f64], values: &[f64], interpolation: Interpolation) -> Vec<f64> {
    match interpolation {
        Interpolation::Linear => end_slopes(knots, values),
        Interpolation::Monotone => monotone_slopes(knots, values),
        Interpolation::Natural => natural_slopes(knots, values),
    }
}

/// Computes coefficients of ascending powers of the distance from the start of a piece. There are
/// polynomials before the first knot, between adjacent knots, and after the last. The first one is
/// measured from the first knot.
pub(super) fn pieces(
    knots: &[f64],
    values: &[f64],
    slopes: &[f64],
    interpolation: Interpolation,
    outside: Outside,
) -> Vec<Vec<f64>> {
    let last = knots.len() - 1;
    let beyond = |end: usize| {
        let [value, slope] = match outside {
            Outside::Error => [f64::NAN, f64::NAN],
            Outside::Clamp => [values[end], 0.0],
            Outside::Extend => [values[end], slopes[end]],
        };
        let mut coefficients = vec![value, slope, 0.0, 0.0];
        coefficients.truncate(interpolation.coefficients());
        coefficients
    };
    let between = (0..last).map(|i| {
        let h = knots[i + 1] - knots[i];
        let secant = (values[i + 1] - values[i]) / h;
        match interpolation {
            Interpolation::Linear => vec![values[i], secant],
            _ => hermite(values[i], secant, [slopes[i], slopes[i + 1]], h),
        }
    });
    [beyond(0)].into_iter().chain(between).chain([beyond(last)]).collect()
}

/// Returns the cubic with these slopes at its ends.
fn hermite(value: f64, secant: f64, [left, right]: [f64; 2], h: f64) -> Vec<f64> {
    vec![value, left, (3.0 * secant - 2.0 * left - right) / h, (left + right - 2.0 * secant) / (h * h)]
}

fn secants(knots: &[f64], values: &[f64]) -> Vec<f64> {
    let rise = |i: usize| (values[i + 1] - values[i]) / (knots[i + 1] - knots[i]);
    (0..knots.len() - 1).map(rise).collect()
}

/// Returns the slopes of straight lines at both ends; the slopes in between are not used.
fn end_slopes(knots: &[f64], values: &[f64]) -> Vec<f64> {
    let secants = secants(knots, values);
    let last = secants[secants.len() - 1];
    secants.into_iter().chain([last]).collect()
}

/// Returns slopes for which the cubics between the points are monotone where the points are. They
/// are means of the secants on both sides, zero at extrema, and reduced if they are outside the
/// circle α² + β² = 9.
fn monotone_slopes(knots: &[f64], values: &[f64]) -> Vec<f64> {
    let secants = secants(knots, values);
    let last = secants.len() - 1;
    let mean = |i: usize| match (secants[i], secants[i + 1]) {
        (before, after) if before * after <= 0.0 => 0.0,
        (before, after) => 0.5 * (before + after),
    };
    let mut slopes =
        [secants[0]].into_iter().chain((0..last).map(mean)).chain([secants[last]]).collect::<Vec<_>>();
    for (i, &secant) in secants.iter().enumerate() {
        if secant == 0.0 {
            (slopes[i], slopes[i + 1]) = (0.0, 0.0);
            continue;
        }
        let (alpha, beta) = (slopes[i] / secant, slopes[i + 1] / secant);
        let radius = alpha.hypot(beta);
        if radius > 3.0 {
            (slopes[i], slopes[i + 1]) = (3.0 * alpha / radius * secant, 3.0 * beta / radius * secant);
        }
    }
    slopes
}

/// Returns slopes with continuous curvature, which is zero at both ends. The equations are
/// tridiagonal and diagonally dominant, so elimination without pivoting is stable.
fn natural_slopes(knots: &[f64], values: &[f64]) -> Vec<f64> {
    let secants = secants(knots, values);
    let last = secants.len();
    let step = |i: usize| knots[i + 1] - knots[i];
    // Rows (below, diagonal, above | right-hand side).
    let row = |i: usize| match i {
        0 => [0.0, 2.0, 1.0, 3.0 * secants[0]],
        i if i == last => [1.0, 2.0, 0.0, 3.0 * secants[last - 1]],
        i => {
            let (before, after) = (step(i - 1), step(i));
            let right = 3.0 * (after * secants[i - 1] + before * secants[i]);
            [after, 2.0 * (before + after), before, right]
        }
    };
    let mut reduced: Vec<[f64; 2]> = Vec::with_capacity(last + 1);
    for i in 0..=last {
        let [below, diagonal, above, right] = row(i);
        let [ratio, value] = reduced.last().copied().unwrap_or([0.0, 0.0]);
        let pivot = diagonal - below * ratio;
        reduced.push([above / pivot, (right - below * value) / pivot]);
    }
    let mut slopes = vec![0.0; last + 1];
    let mut behind = 0.0;
    for (slope, [ratio, value]) in slopes.iter_mut().zip(reduced).rev() {
        *slope = value - ratio * behind;
        behind = *slope;
    }
    slopes
}
