//! Zeros of functions without a closed form: the algebraic unknowns of declarations.

mod coupled;

pub use coupled::{CoupledEquations, coupled};

use crate::scalar::{Mask, Number, spacing_at_one};

/// Residuals up to this many times the bound on their rounding error count as zero.
const TOLERANCE: f64 = 4.0;
/// Minimum length of the last step, in units of the distance hidden by rounding, for a slope to be
/// trusted.
const MIN_SPAN: f64 = 4.0;
/// Slopes whose relative difference is at most this belong to the same zero.
const SAME_SLOPE: f64 = 0.25;
/// If slopes on the two sides of a zero differ by more than this factor, no digit of the zero is
/// reliable.
const MAX_BEND: f64 = 65_536.0;
/// Minimum ratio of the difference to the sum of noisy residuals on the two sides of a zero.
const CENTRAL: f64 = 4.0;
/// Distance of the two sides at which signs are compared, in units of the distance hidden by
/// rounding.
const ASIDE: f64 = 32.0;

/// Returns the zero found by Newton's method from a start within a number of steps; NaN if none is
/// found. Numbers in lanes iterate until each has its own zero, which does not depend on the
/// others.
///
/// At y, `equation` computes the residual r, its slope ∂r/∂y, and a bound on the rounding error of
/// r. The bound sums the effects of one relative rounding error in y and in each intermediate
/// value. A candidate is a point where r is within four times the bound, or where steps of rounding
/// size stop shrinking. It is a zero if r changes its sign around it. It is also one if the last
/// two slopes agree over a distance that rounding does not hide. A residual that is merely small
/// relative to its terms, such as √(y² + 1) − y, has no zero. One more step is taken from a zero.
///
/// ```
/// use lagrange::root::newton;
///
/// let cube_root_of_two = newton(1.0_f64, 30, |y| [y.powi(3) - 2.0, 3.0 * y * y, 4.0 * y.powi(3).abs()]);
/// assert!((cube_root_of_two - 2.0_f64.cbrt()).abs() < 1e-15);
/// assert!(newton(1.0_f64, 30, |y| [y * y + 1.0, 2.0 * y, 3.0 * y * y]).is_nan());
/// ```
#[inline(always)]
pub fn newton<S: Number>(start: S, iterations: u32, equation: impl Fn(S) -> [S; 3]) -> S {
    let mut search = RootSearch::new(start, iterations);
    while !search.is_over().all() {
        search.advance(equation(search.point));
    }
    search.root
}

/// A search for a zero, between two evaluations of the equation.
struct RootSearch<S: Number> {
    /// Next point of evaluation.
    point: S,
    /// The zero; NaN before it is found.
    root: S,
    /// Number of remaining steps.
    left: S,
    /// Length and slope of the last step.
    last: [S; 2],
    candidate: RootCandidate<S>,
    epsilon: S,
    /// Steps below this relative size are dominated by the noise of the equation: ε^(3/4).
    noise: S,
}

/// A point that is a zero if the residual has different signs on its two sides.
struct RootCandidate<S: Number> {
    value: S,
    /// Distance of each side from the point.
    width: S,
    /// Residual and slope on the upper side.
    above: [S; 2],
    /// Slope.
    slope: S,
    /// True if rounding alone does not explain the residual.
    is_noisy: S::Mask,
    /// True if the upper side is evaluated next.
    awaits_above: S::Mask,
    /// True if the lower side is evaluated next.
    awaits_below: S::Mask,
}

impl<S: Number> RootSearch<S> {
    #[inline(always)]
    fn new(start: S, iterations: u32) -> RootSearch<S> {
        let no = S::Mask::splat(false);
        let candidate = RootCandidate {
            value: start,
            width: S::ZERO,
            above: [S::NAN; 2],
            slope: S::NAN,
            is_noisy: no,
            awaits_above: no,
            awaits_below: no,
        };
        let epsilon: S = spacing_at_one();
        let (root, left) = (epsilon.sqrt(), S::from_f64(f64::from(iterations)));
        let noise = root * root.sqrt();
        RootSearch { point: start, root: S::NAN, left, last: [S::ZERO; 2], candidate, epsilon, noise }
    }

    /// True if the zero is found or no further step is possible.
    #[inline(always)]
    fn is_over(&self) -> S::Mask {
        let is_aside = self.candidate.awaits_above | self.candidate.awaits_below;
        let is_exhausted = self.left.less_equal(S::ZERO) & !is_aside;
        is_number(self.root) | !is_number(self.point) | is_exhausted
    }

    /// Continues with the residual, its slope and its rounding error at the point.
    #[inline(always)]
    fn advance(&mut self, [residual, slope, rounding]: [S; 3]) {
        let (is_above, is_below) = (self.candidate.awaits_above, self.candidate.awaits_below);
        let is_step = !(is_above | is_below);
        let proven = is_below & self.candidate.is_crossed(residual, slope);
        let step = NewtonStep::new(self, [residual, slope, rounding]);
        let awaits_above = is_step & step.is_candidate & !step.is_certain;
        let found = S::select(proven, self.candidate.value, S::select(step.is_certain, step.next, S::NAN));
        self.root = S::select((proven | is_step) & !self.is_over(), found, self.root);
        let [residual_above, slope_above] = self.candidate.above;
        self.candidate.above =
            [S::select(is_above, residual, residual_above), S::select(is_above, slope, slope_above)];
        self.candidate.slope = S::select(awaits_above, slope, self.candidate.slope);
        self.candidate.is_noisy = (awaits_above & !step.is_small) | (self.candidate.is_noisy & !awaits_above);
        self.candidate.value = S::select(awaits_above, step.next, self.candidate.value);
        self.candidate.width = S::select(awaits_above, step.width, self.candidate.width);
        self.candidate.awaits_above = awaits_above;
        self.candidate.awaits_below = is_above;
        let RootCandidate { value, width, .. } = self.candidate;
        let aside = S::select(awaits_above, value + width, S::select(is_above, value - width, value));
        self.point = S::select(is_step & !awaits_above, step.next, aside);
        self.left = S::select(is_step, self.left - S::ONE, self.left);
        let [length, last_slope] = self.last;
        self.last = [S::select(is_step, step.length, length), S::select(is_step, slope, last_slope)];
    }
}

impl<S: Number> RootCandidate<S> {
    /// True if the residual passes zero between the two sides, with similar slopes throughout.
    #[inline(always)]
    fn is_crossed(&self, residual: S, slope: S) -> S::Mask {
        let [residual_above, slope_above] = self.above;
        let bend = S::from_f64(MAX_BEND);
        let is_similar = |a: S, b: S| {
            a.sign().less_equal(b.sign())
                & b.sign().less_equal(a.sign())
                & a.abs().less(bend * b.abs())
                & b.abs().less(bend * a.abs())
        };
        let are_opposite = (residual.less(S::ZERO) & S::ZERO.less(residual_above))
            | (residual_above.less(S::ZERO) & S::ZERO.less(residual));
        let (sum, difference) = ((residual_above + residual).abs(), (residual_above - residual).abs());
        let is_central = (S::from_f64(CENTRAL) * sum).less_equal(difference);
        are_opposite
            & (is_central | !self.is_noisy)
            & is_similar(slope, slope_above)
            & is_similar(slope, self.slope)
    }
}

/// A step of Newton's method.
struct NewtonStep<S: Number> {
    next: S,
    length: S,
    /// Half the width of the interval that must contain the zero.
    width: S,
    is_small: S::Mask,
    is_candidate: S::Mask,
    is_certain: S::Mask,
}

impl<S: Number> NewtonStep<S> {
    #[inline(always)]
    fn new(search: &RootSearch<S>, [residual, slope, rounding]: [S; 3]) -> NewtonStep<S> {
        let [last_length, last_slope] = search.last;
        let (zero, infinity) = (S::ZERO, S::from_f64(f64::INFINITY));
        let change = residual / slope;
        let (next, length, steepness) = (search.point - change, change.abs(), slope.abs());
        let bound = S::from_f64(TOLERANCE) * search.epsilon * rounding;
        let hidden = bound / steepness;
        let is_small = residual.abs().less_equal(bound) & bound.less(infinity) & steepness.less(infinity);
        let no_longer_shrinks = zero.less(last_length) & last_length.less_equal(length);
        let is_noise = length.less(search.noise * next.abs()) & no_longer_shrinks;
        let agrees = (slope - last_slope).abs().less_equal(S::from_f64(SAME_SLOPE) * steepness);
        let spans = (S::from_f64(MIN_SPAN) * hidden).less_equal(last_length);
        // If all terms are zero, there is no cancellation.
        let is_plain = bound.less_equal(zero);
        let noise = S::select(is_small, zero, larger(length, last_length));
        NewtonStep {
            next,
            length,
            width: S::from_f64(ASIDE) * larger(hidden, noise),
            is_small,
            is_candidate: is_small | is_noise,
            is_certain: is_small & (is_plain | (spans & agrees)),
        }
    }
}

#[inline(always)]
fn is_number<S: Number>(value: S) -> S::Mask {
    value.less_equal(value)
}

/// Returns the larger of two numbers; the first if one of them is NaN.
#[inline(always)]
fn larger<S: Number>(a: S, b: S) -> S {
    S::select(a.less(b), b, a)
}

#[cfg(test)]
mod tests;
