//! The motion through a state as a polynomial, with its range and its accuracy.

use super::polynomial::{increment, largest, slope};
use super::rule::{LAST_ORDERS, LastOrders, SHORT, StepRule, leads_to_zero};
use super::widest::{WideTask, compute};
use crate::integrate::clock::least_step;
use crate::scalar::Scalar;
use crate::system::{MAX_ORDER, StateVector};

/// The order of expansions that lead components to zero; all others are higher.
const STRAIGHT: usize = 2;

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
    pub(super) fn change(&self, rule: &StepRule<S>, h: S) -> Y {
        compute(Increment { expansion: self, h }, rule.fused)
    }

    /// Returns the change of the state over a time `h`, and the slope of the polynomial there.
    #[inline]
    pub(super) fn advance(&self, rule: &StepRule<S>, h: S) -> [Y; 2] {
        compute(Advance { expansion: self, rule, h }, rule.fused)
    }

    /// True if the slope of the polynomial after a time `h` agrees, within the tolerance, with the
    /// rate of `ahead`.
    #[inline]
    pub(super) fn fits(&self, rule: &StepRule<S>, h: S, slope: &Y, ahead: &Self) -> bool {
        rule.fits(h, [slope, &ahead.coefficients[0]], [&self.y, &ahead.y])
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
        let near = starts
            .zip(ends)
            .enumerate()
            .filter(|(component, ((y, _), _))| rule.is_near_zero(*component, **y));
        let lengths = near.filter_map(|(component, (start, end))| {
            let ((y, rate), ((after, rate_after), slope)) = (start, end);
            let is_wrong = rule.turns(component, h, [*y, *rate], [*after, *rate_after, *slope]);
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
        let scales = rule.scales(&self.y);
        let LastOrders { last_terms, reciprocals } = match self.order == rule.order {
            true => rule.last_orders,
            false => LastOrders::new(self.order, rule.tolerance),
        };
        // The minimum of −log₂ |cₖ| / k.
        let mut radius = None;
        for (index, reciprocal) in reciprocals.iter().enumerate() {
            let largest = largest(&self.coefficients[self.order - LAST_ORDERS + index], &scales);
            if largest > S::ZERO {
                let of_order = largest.rough_log2() * *reciprocal;
                radius = Some(radius.map_or(of_order, |radius: S| radius.min(of_order)));
            }
        }
        let longest = rule.longest(largest(&self.coefficients[0], &scales));
        radius.map_or(longest, |radius| (radius + last_terms).rough_exp2().min(longest))
    }
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
    fn compute<const FUSED: bool>(self) -> [Y; 2] {
        let Advance { expansion, rule, h } = self;
        let coefficients = &expansion.coefficients[..expansion.order];
        [increment::<FUSED, S, Y>(coefficients, h), slope::<FUSED, S, Y>(coefficients, &rule.orders, h)]
    }
}

struct Increment<'a, S, Y> {
    expansion: &'a Expansion<S, Y>,
    h: S,
}

impl<S: Scalar, Y: StateVector<S>> WideTask for Increment<'_, S, Y> {
    type Output = Y;

    #[inline(always)]
    fn compute<const FUSED: bool>(self) -> Y {
        increment::<FUSED, S, Y>(&self.expansion.coefficients[..self.expansion.order], self.h)
    }
}
