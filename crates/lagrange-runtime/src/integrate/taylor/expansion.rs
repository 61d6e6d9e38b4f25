//! The motion through a state as a polynomial, with its range and its accuracy.

use super::Taylor;
use super::widest::{WideTask, compute};
use crate::integrate::clock::least_step;
use crate::integrate::verner::tolerance::{Tolerated, longest_step};
use crate::linalg::vector::combined;
use crate::scalar::Scalar;
use crate::system::{Domain, MAX_ORDER, StateVector};
use crate::tolerance::LEAST_TOLERANCE;

/// Largest size of the last terms of a series relative to the tolerance, as later terms and the
/// errors of steps add up.
const SAFETY: f64 = 0.01;
/// Largest difference between the rate at the end of a step and the slope of its polynomial, in
/// tolerances over the length of the step.
const LARGEST_DEFECT: f64 = 1.0;
/// A component below this part of what is tolerated may be led to zero.
const NEAR_ZERO: f64 = 0.25;
/// The order of expansions that lead components to zero; all others are higher.
const STRAIGHT: usize = 2;
/// A step that changes the state by less than this part of what is tolerated leaves it at rest.
const AT_REST: f64 = 1e-3;
/// Step length, in roundings of time, below which a step makes hardly any progress.
const SHORT: f64 = 32.0;
/// Number of orders that determine the length of a step, since alternate coefficients may vanish.
const LAST_ORDERS: usize = 4;

/// The motion through a state: the state and its coefficients of order one and higher.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expansion<S, Y> {
    pub(super) t: S,
    pub(super) y: Y,
    /// The highest order of the coefficients in use.
    pub(super) order: usize,
    /// The length of a step along the series.
    pub(super) length: S,
    pub(super) coefficients: [Y; MAX_ORDER],
}

/// The tolerated errors, and numbers that follow from them and from the order of the series.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepRule<S> {
    pub(super) order: usize,
    tolerated: Tolerated<S>,
    tolerance: S,
    last_orders: LastOrders<S>,
    /// The longest steps of a moving state and of one at rest.
    longest: [S; 2],
    /// The orders 1, 2, … of coefficients.
    orders: [S; MAX_ORDER],
}

/// Numbers that follow from the highest order of a series.
#[derive(Clone, Copy, Debug)]
struct LastOrders<S> {
    /// The binary logarithm of the last terms, divided by the order.
    last_terms: S,
    /// −1 divided by each of the last orders.
    reciprocals: [S; LAST_ORDERS],
}

impl<S: Scalar> LastOrders<S> {
    fn new(order: usize, tolerance: S) -> Self {
        let number = |order: usize| S::from_f64(order as f64);
        LastOrders {
            last_terms: (S::from_f64(SAFETY) * tolerance).rough_log2() / number(order),
            reciprocals: core::array::from_fn(|index| -S::ONE / number(order - LAST_ORDERS + index + 1)),
        }
    }
}

impl<S: Scalar> StepRule<S> {
    /// Returns the rule of steps over a time of this length.
    pub(super) fn new(settings: &Taylor<S>, span: S, domain: &'static Domain) -> StepRule<S> {
        let order = settings.chosen_order();
        let orders: [S; MAX_ORDER] = core::array::from_fn(|index| S::from_f64((index + 1) as f64));
        let tolerance = settings.loosest().max(LEAST_TOLERANCE.part::<S>());
        StepRule {
            order,
            tolerated: Tolerated::new(settings.relative, settings.absolute, domain),
            tolerance,
            last_orders: LastOrders::new(order, tolerance),
            longest: [false, true].map(|is_at_rest| longest_step(settings.longest_step, span, is_at_rest)),
            orders,
        }
    }

    /// True if a component with this value may be led to zero.
    fn is_near_zero(&self, component: usize, value: S) -> bool {
        value.abs() <= S::from_f64(NEAR_ZERO) * self.tolerated.of(component, value.abs())
    }
}

impl<S: Scalar, Y: StateVector<S>> Expansion<S, Y> {
    /// Finds the length of a step along the series. Near a point where a root or a power vanishes,
    /// high coefficients grow beyond all numbers, although terms are small there. Steps that would
    /// hardly lead on follow the series to the order that leads farthest.
    #[inline(always)]
    pub(super) fn follow(&mut self, rule: &StepRule<S>) {
        self.order = rule.order;
        self.length = self.accurate_length(rule);
        let is_finite = self.coefficients[rule.order - 1].as_ref().iter().all(|entry| entry.is_finite());
        if !is_finite || self.length < S::from_f64(SHORT) * least_step(self.t) {
            self.follow_farthest(rule);
        }
    }

    #[cold]
    fn follow_farthest(&mut self, rule: &StepRule<S>) {
        let is_finite = |y: &Y| y.as_ref().iter().all(|entry| entry.is_finite());
        let finite = self.coefficients[..rule.order].iter().position(|y| !is_finite(y)).unwrap_or(rule.order);
        let (mut best, mut farthest) = (rule.order, S::ZERO);
        for order in LAST_ORDERS..=finite {
            self.order = order;
            let length = self.accurate_length(rule);
            if length > farthest {
                (best, farthest) = (order, length);
            }
        }
        (self.order, self.length) = (best, farthest);
    }

    /// Returns the change of the state over a time `h`.
    #[inline]
    pub(super) fn change(&self, h: S) -> Y {
        compute(Increment { expansion: self, h })
    }

    /// Returns the change of the state over a time `h`, and the slope of the polynomial there.
    #[inline]
    pub(super) fn advance(&self, rule: &StepRule<S>, h: S) -> [Y; 2] {
        compute(Advance { expansion: self, rule, h })
    }

    /// True if the slope of the polynomial after a time `h` agrees, within the tolerance, with the
    /// rate of `ahead`.
    #[inline]
    pub(super) fn fits(&self, rule: &StepRule<S>, h: S, slope: &Y, ahead: &Self) -> bool {
        let rates = slope.as_ref().iter().zip(ahead.coefficients[0].as_ref());
        let sizes = self.y.as_ref().iter().zip(ahead.y.as_ref());
        let (least, h) = (LEAST_TOLERANCE.part::<S>(), h.abs());
        rates.zip(sizes).enumerate().fold(true, |fits, (component, ((slope, rate), (before, after)))| {
            let rounding = least * rate.abs().max(slope.abs());
            let tolerated = rule.tolerated.of(component, before.abs().max(after.abs()));
            fits & (((*slope - *rate).abs() - rounding) * h <= S::from_f64(LARGEST_DEFECT) * tolerated)
        })
    }

    /// Returns the length of a straight step that leads a component to zero, if the polynomial
    /// wrongly turns away from zero within a time `h`.
    ///
    /// A tank that drains by ẋ = −√x is empty at a time τ, when x = (τ − t)²/4, and remains so. The
    /// polynomial refills it. If that much is tolerated, such steps would follow each other for
    /// ever.
    pub(super) fn landing(&self, rule: &StepRule<S>, h: S, slope: &Y, ahead: &Self) -> Option<S> {
        let starts = self.y.as_ref().iter().zip(self.coefficients[0].as_ref());
        let ends = ahead.y.as_ref().iter().zip(ahead.coefficients[0].as_ref()).zip(slope.as_ref());
        let lengths = starts.zip(ends).enumerate().filter_map(|(component, (start, end))| {
            let ((y, rate), ((after, rate_after), slope)) = (start, end);
            let is_near = [*y, *after].into_iter().all(|value| rule.is_near_zero(component, value));
            let turns = || leads_to_zero(*y, *rate, h) && leads_to_zero(*after, -*slope, h);
            let is_wrong = is_near && turns() && leads_to_zero(*after, *rate_after, h);
            is_wrong.then(|| (*y / *rate).abs())
        });
        lengths.reduce(S::min)
    }

    /// Follows a parabola that has, after a time `h`, about the rate `ahead`. Components near zero
    /// follow straight lines, which end at zero if they come so far.
    pub(super) fn straighten(&mut self, rule: &StepRule<S>, h: S, ahead: &Y) {
        let [rates, bends, ..] = &mut self.coefficients;
        let coefficients = rates.as_mut().iter_mut().zip(bends.as_mut());
        let ends = ahead.as_ref().iter().zip(self.y.as_ref()).enumerate();
        for ((rate, bend), (component, (ahead, y))) in coefficients.zip(ends) {
            *bend = (*ahead - *rate) / (h + h);
            if rule.is_near_zero(component, *y) {
                *bend = S::ZERO;
                let is_far = (*rate * (h + h)).abs() < y.abs();
                *rate = if is_far || !leads_to_zero(*y, *rate, h) { *rate } else { -*y / h };
            }
        }
        self.order = STRAIGHT;
    }

    /// True after [`straighten`](Self::straighten).
    pub(super) fn is_straight(&self) -> bool {
        self.order == STRAIGHT
    }

    /// Returns the length of a step whose last terms are small enough. It is the largest h with |cₖ|
    /// hᵏ ≤ tolerance for the last four orders k, each extrapolated to the order of the whole
    /// series.
    #[inline(always)]
    fn accurate_length(&self, rule: &StepRule<S>) -> S {
        let mut scales = self.y;
        for (component, scale) in scales.as_mut().iter_mut().enumerate() {
            *scale = rule.tolerance / rule.tolerated.of(component, scale.abs());
        }
        let LastOrders { last_terms, reciprocals } = match self.order == rule.order {
            true => rule.last_orders,
            false => LastOrders::new(self.order, rule.tolerance),
        };
        // The minimum of −log₂ |cₖ| / k.
        let mut radius = None;
        for (index, reciprocal) in reciprocals.iter().enumerate() {
            let largest = self.largest(self.order - LAST_ORDERS + index, &scales);
            if largest > S::ZERO {
                let of_order = largest.rough_log2() * *reciprocal;
                radius = Some(radius.map_or(of_order, |radius: S| radius.min(of_order)));
            }
        }
        let [longest, at_rest] = rule.longest;
        let is_at_rest = at_rest * self.largest(0, &scales) < S::from_f64(AT_REST) * rule.tolerance;
        let longest = if is_at_rest { at_rest } else { longest };
        radius.map_or(longest, |radius| (radius + last_terms).rough_exp2().min(longest))
    }

    #[inline(always)]
    fn increment(&self, h: S) -> Y {
        let mut change = self.polynomial(h, |_, coefficients| *coefficients);
        change.padded_mut().iter_mut().for_each(|sum| *sum = *sum * h);
        change
    }

    /// Computes Σ hᵏ times the term of order k + 1, as four polynomials in h⁴. Successive terms can
    /// then be computed independently.
    #[inline(always)]
    fn polynomial(&self, h: S, term: impl Fn(usize, &Y) -> Y) -> Y {
        let square = h * h;
        let fourth = square * square;
        let (blocks, rest) = self.coefficients[..self.order].as_chunks::<4>();
        let mut sums = [self.y.zeros(); 4];
        for (place, (sum, coefficients)) in sums.iter_mut().zip(rest).enumerate() {
            *sum = term(4 * blocks.len() + place, coefficients);
        }
        for (block, coefficients) in blocks.iter().enumerate().rev() {
            for place in 0..4 {
                sums[place] = combined(&term(4 * block + place, &coefficients[place]), fourth, &sums[place]);
            }
        }
        let [total, first, second, third] = sums;
        combined(&combined(&total, square, &second), h, &combined(&first, square, &third))
    }

    /// Returns the largest coefficient of the order `index` + 1 among all components, relative to
    /// their tolerances.
    #[inline(always)]
    fn largest(&self, index: usize, scales: &Y) -> S {
        let coefficients = self.coefficients[index].as_ref().iter().zip(scales.as_ref());
        coefficients.fold(S::ZERO, |largest, (coefficient, scale)| largest.max(coefficient.abs() * *scale))
    }
}

/// True if a step `h` at this rate leads towards zero.
fn leads_to_zero<S: Scalar>(y: S, rate: S, h: S) -> bool {
    y.sign() * rate.sign() * h.sign() < S::ZERO
}

/// The motion after a time `h`, as a polynomial tells.
struct Advance<'a, S, Y> {
    expansion: &'a Expansion<S, Y>,
    rule: &'a StepRule<S>,
    h: S,
}

impl<S: Scalar, Y: StateVector<S>> WideTask for Advance<'_, S, Y> {
    type Output = [Y; 2];

    #[inline(always)]
    fn compute(self) -> [Y; 2] {
        let Advance { expansion, rule, h } = self;
        let slope = expansion.polynomial(h, |index, coefficients| {
            let (mut term, order) = (*coefficients, rule.orders[index]);
            term.padded_mut().iter_mut().for_each(|entry| *entry = *entry * order);
            term
        });
        [expansion.increment(h), slope]
    }
}

struct Increment<'a, S, Y> {
    expansion: &'a Expansion<S, Y>,
    h: S,
}

impl<S: Scalar, Y: StateVector<S>> WideTask for Increment<'_, S, Y> {
    type Output = Y;

    #[inline(always)]
    fn compute(self) -> Y {
        self.expansion.increment(self.h)
    }
}
