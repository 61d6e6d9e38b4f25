//! The accuracy of steps along series, for one motion or several in lanes.

use super::Taylor;
use super::stiffness::stability;
use crate::integrate::stiffness::StabilityLimit;
use crate::integrate::verner::tolerance::{Tolerated, longest_step};
use crate::scalar::{Mask, Number, Scalar};
use crate::system::{Domain, MAX_ORDER, SideBySide, StateVector};
use crate::tolerance::LEAST_TOLERANCE;

/// Largest size of the last terms of a series relative to the tolerance, as later terms and the
/// errors of steps add up.
const SAFETY: f64 = 0.01;
/// Largest difference between the rate at the end of a step and the slope of its polynomial, in
/// tolerances over the length of the step.
const LARGEST_DEFECT: f64 = 1.0;
/// The longest step of a moving state, as a part of the interval. The check at the end of a step
/// permits longer ones than pairs of Runge–Kutta methods take.
const LONGEST: f64 = 1.0 / 4.0;
/// A component below this part of what is tolerated may be led to zero.
const NEAR_ZERO: f64 = 0.25;
/// A step that changes the state by less than this part of what is tolerated leaves it at rest.
const AT_REST: f64 = 1e-3;
/// Step length, in roundings of time, below which a step makes hardly any progress.
pub(super) const SHORT: f64 = 32.0;
/// Number of orders that determine the length of a step, since alternate coefficients may vanish.
pub(super) const LAST_ORDERS: usize = 4;

/// The tolerated errors, and numbers that follow from them and from the order of the series.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepRule<S> {
    pub(super) order: usize,
    pub(super) fused: bool,
    pub(super) tolerance: S,
    pub(super) last_orders: LastOrders<S>,
    /// The longest steps of a moving state and of one at rest.
    pub(super) longest: [S; 2],
    /// The orders 1, 2, … of coefficients.
    pub(super) orders: [S; MAX_ORDER],
    /// The stability limit, if steps limited by stability are refused.
    pub(super) stability: Option<StabilityLimit<S>>,
    tolerated: Tolerated<S>,
    /// The part of a rate that is rounding.
    rounding: S,
}

/// Numbers that follow from the highest order of a series.
#[derive(Clone, Copy, Debug)]
pub(super) struct LastOrders<S> {
    /// The binary logarithm of the last terms, divided by the order.
    pub(super) last_terms: S,
    /// −1 divided by each of the last orders.
    pub(super) reciprocals: [S; LAST_ORDERS],
}

impl<S: Scalar> LastOrders<S> {
    pub(super) fn new(order: usize, tolerance: S) -> Self {
        let number = |order: usize| S::from_f64(order as f64);
        LastOrders {
            last_terms: (S::from_f64(SAFETY) * tolerance).rough_log2() / number(order),
            reciprocals: core::array::from_fn(|index| -S::ONE / number(order - LAST_ORDERS + index + 1)),
        }
    }
}

impl<S: Scalar> StepRule<S> {
    /// Returns the rule of steps along series of this order over a time of this length.
    pub(super) fn new(settings: &Taylor<S>, order: usize, span: S, domain: &'static Domain) -> StepRule<S> {
        let orders: [S; MAX_ORDER] = core::array::from_fn(|index| S::from_f64((index + 1) as f64));
        let rounding = LEAST_TOLERANCE.part::<S>();
        let tolerance = settings.loosest().max(rounding);
        StepRule {
            order,
            fused: settings.fused,
            tolerance,
            last_orders: LastOrders::new(order, tolerance),
            longest: [
                settings.longest_step.unwrap_or(span.abs() * S::from_f64(LONGEST)),
                longest_step(settings.longest_step, span, true),
            ],
            orders,
            stability: settings.refuses_stiff.then(|| stability(order)),
            tolerated: Tolerated::new(settings.relative, settings.absolute, domain),
            rounding,
        }
    }

    /// Returns the same rule in every lane.
    #[inline(always)]
    pub(super) fn in_lanes<L: SideBySide<Element = S>>(&self) -> StepRule<L> {
        let LastOrders { last_terms, reciprocals } = self.last_orders;
        let Tolerated { relative, absolute, domain } = self.tolerated;
        let stability = self.stability.map(|StabilityLimit { stable, near }| StabilityLimit {
            stable: L::splat(stable),
            near: L::splat(near),
        });
        StepRule {
            order: self.order,
            fused: self.fused,
            tolerance: L::splat(self.tolerance),
            last_orders: LastOrders {
                last_terms: L::splat(last_terms),
                reciprocals: reciprocals.map(L::splat),
            },
            longest: self.longest.map(L::splat),
            orders: self.orders.map(L::splat),
            stability,
            tolerated: Tolerated { relative: L::splat(relative), absolute: L::splat(absolute), domain },
            rounding: L::splat(self.rounding),
        }
    }
}

impl<S: Number> StepRule<S> {
    /// Returns, for each component, the tolerance relative to what is tolerated at this state.
    #[inline(always)]
    pub(super) fn scales<Y: StateVector<S>>(&self, y: &Y) -> Y {
        let mut scales = *y;
        for (component, scale) in scales.as_mut().iter_mut().enumerate() {
            *scale = self.tolerance / self.tolerated.of(component, scale.abs());
        }
        scales
    }

    /// Returns the length of the longest step if the largest relative rate is this one.
    #[inline(always)]
    pub(super) fn longest(&self, rate: S) -> S {
        let [longest, at_rest] = self.longest;
        let is_at_rest = (at_rest * rate).less(S::from_f64(AT_REST) * self.tolerance);
        S::select(is_at_rest, at_rest, longest)
    }

    /// True if a component with this value may be led to zero.
    #[inline(always)]
    pub(super) fn is_near_zero(&self, component: usize, value: S) -> S::Mask {
        let size = value.abs();
        size.less_equal(S::from_f64(NEAR_ZERO) * self.tolerated.of(component, size))
    }

    /// True if the slope of a polynomial after a time `h` agrees, within the tolerance, with the
    /// rate there. The states at both ends determine what is tolerated.
    #[inline(always)]
    pub(super) fn fits<Y: StateVector<S>>(&self, h: S, [slope, rate]: [&Y; 2], ends: [&Y; 2]) -> S::Mask {
        let rates = slope.as_ref().iter().zip(rate.as_ref());
        let (sizes, h) = (ends[0].as_ref().iter().zip(ends[1].as_ref()), h.abs());
        let mut fits = S::Mask::splat(true);
        for (component, ((slope, rate), (before, after))) in rates.zip(sizes).enumerate() {
            let rounding = self.rounding * rate.abs().max(slope.abs());
            let tolerated = self.tolerated.of(component, before.abs().max(after.abs()));
            let defect = ((*slope - *rate).abs() - rounding) * h;
            fits = fits & defect.less_equal(S::from_f64(LARGEST_DEFECT) * tolerated);
        }
        fits
    }

    /// True if the polynomial of a component wrongly turns away from zero within a time `h`. The
    /// arguments are the value and the rate before, and the value, the rate and the slope of the
    /// polynomial after.
    #[inline(always)]
    pub(super) fn turns(&self, component: usize, h: S, [y, rate]: [S; 2], after: [S; 3]) -> S::Mask {
        let [after, rate_after, slope] = after;
        let are_near = self.is_near_zero(component, y) & self.is_near_zero(component, after);
        let turns = leads_to_zero(y, rate, h) & leads_to_zero(after, -slope, h);
        are_near & turns & leads_to_zero(after, rate_after, h)
    }
}

/// True if a step `h` at this rate leads towards zero.
#[inline(always)]
pub(super) fn leads_to_zero<S: Number>(y: S, rate: S, h: S) -> S::Mask {
    (y.sign() * rate.sign() * h.sign()).less(S::ZERO)
}
