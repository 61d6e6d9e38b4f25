//! Taylor series of several motions in lanes.
//!
//! A step is the same as in `stepper`, with two differences. A rejected lane retries a shorter step
//! along the same coefficients, while other lanes go on. Motions that need a series of lower order
//! or a straight step are abandoned.

use super::Taylor;
use super::polynomial::{increment, largest, slope};
use super::rule::{LAST_ORDERS, LastOrders, SHORT, StepRule};
use super::stiffness::is_at_limit;
use crate::integrate::clock::{Clock, least_step};
use crate::integrate::compensated::Compensated;
use crate::integrate::lane_wise::{Counts, are_finite, chosen, is_equal, smaller};
use crate::integrate::method::{LanesMethod, LanesStepper, MAX_LANES, Work};
use crate::integrate::stiffness::{Stiffness, are_many};
use crate::scalar::{Mask, Number, Scalar};
use crate::system::{Domain, Equations, MAX_ORDER, SideBySide, StateVector};

/// Integrations by [`Taylor`] series in lanes; Y is the state.
#[derive(Clone, Copy, Debug)]
pub struct TaylorLanes<S: Number, Y> {
    rule: StepRule<S>,
    end: S,
    most_steps: u64,
    clock: Clock<S>,
    state: Compensated<Y>,
    /// Maximum lengths of the next steps; negative before the first expansion of a motion.
    length: S,
    /// The lanes in which the last step was accepted.
    is_taken: S::Mask,
    /// Numbers of expansions, and of those that led on.
    counts: Counts,
    stiffness: [Stiffness; MAX_LANES],
}

/// Series of motions in lanes; Y is the state and P the storage for products.
#[derive(Clone, Debug)]
pub struct TaylorWorkspace<Y, P> {
    products: P,
    /// The coefficients along which the last steps went.
    last: [Y; MAX_ORDER],
    /// The coefficients at their ends.
    ahead: [Y; MAX_ORDER],
}

/// The starts of the last steps.
#[derive(Clone, Copy, Debug)]
pub struct TaylorLastStep<S, Y> {
    t: S,
    y: Y,
}

/// An attempt of steps in lanes.
struct LanesAttempt<'a, S: Number, Y> {
    h: S,
    clock: Clock<S>,
    state: Compensated<Y>,
    /// The slopes of the polynomials at the ends.
    slope: Y,
    /// The coefficients at the starts, and at the ends.
    coefficients: [&'a [Y]; 2],
    /// The motions that only expand.
    is_first: S::Mask,
}

impl<T: Scalar> LanesMethod<T> for Taylor<T> {
    type Stepper<S: SideBySide<Element = T>, E: Equations<S>> = TaylorLanes<S, E::State>;

    #[inline(always)]
    fn empty_lanes<S, E>(&self, [t, end]: [T; 2], domain: &'static Domain) -> Self::Stepper<S, E>
    where
        S: SideBySide<Element = T>,
        E: Equations<S>,
    {
        TaylorLanes {
            rule: StepRule::new(self, self.order_in_lanes(), end - t, domain).in_lanes(),
            end: S::splat(end),
            most_steps: self.max_steps,
            clock: Clock::new(S::splat(t), S::ZERO),
            state: Compensated::new(E::State::ZERO),
            length: -S::ONE,
            is_taken: S::Mask::splat(false),
            counts: Counts::new(),
            stiffness: [Stiffness::default(); MAX_LANES],
        }
    }

    #[inline(always)]
    fn take<S, E, O, F>(
        stepper: &mut Self::Stepper<S, E>,
        lane: usize,
        other: &Self::Stepper<O, F>,
        from: usize,
    ) where
        S: SideBySide<Element = T>,
        E: Equations<S>,
        O: SideBySide<Element = T>,
        F: Equations<O>,
    {
        stepper.clock.take(lane, &other.clock, from);
        stepper.state.take(lane, &other.state, from);
        stepper.counts.take(lane, &other.counts, from);
        stepper.stiffness[lane] = other.stiffness[from];
        // Coefficients are not copied, so the motion is expanded again.
        stepper.length.set_lane(lane, -T::ONE);
    }
}

impl<Y, P: Default> TaylorWorkspace<Y, P> {
    /// Continues from the ends of the steps that were accepted.
    #[inline(always)]
    fn go_on<S: Number>(&mut self, order: usize, is_taken: S::Mask)
    where
        Y: StateVector<S>,
    {
        for (last, ahead) in self.last[..order].iter_mut().zip(&self.ahead) {
            *last = chosen(is_taken, ahead, last);
        }
    }
}

impl<S: SideBySide<Element: Scalar>> StepRule<S> {
    /// Returns the lengths of steps from these states whose last terms are small enough, as for one
    /// motion.
    #[inline(always)]
    fn accurate_length<Y: StateVector<S>>(&self, y: &Y, coefficients: &[Y]) -> S {
        let scales = self.scales(y);
        let LastOrders { last_terms, reciprocals } = self.last_orders;
        let mut length = self.longest(largest(&coefficients[0], &scales));
        for (index, reciprocal) in reciprocals.into_iter().enumerate() {
            let largest = largest(&coefficients[self.order - LAST_ORDERS + index], &scales);
            let of_order = largest.each(Scalar::rough_log2).multiply_add(reciprocal, last_terms);
            let of_order = of_order.each(Scalar::rough_exp2);
            length = S::select(S::ZERO.less(largest), smaller(of_order, length), length);
        }
        length
    }
}

impl<S, Y> TaylorLanes<S, Y>
where
    S: SideBySide<Element: Scalar>,
    Y: StateVector<S>,
{
    /// Returns the lanes in which an attempt led to an accurate end.
    #[inline(always)]
    fn fits(&self, attempt: &LanesAttempt<'_, S, Y>) -> S::Mask {
        let LanesAttempt { h, slope, coefficients: [_, ahead], is_first, .. } = attempt;
        let y = attempt.state.value();
        let fits = self.rule.fits(*h, [slope, &ahead[0]], [self.state.value(), y]);
        (fits | *is_first) & are_finite(y) & are_finite(&ahead[0])
    }

    /// Returns the lanes in which a single run is needed after an attempt. There the series turns
    /// away from zero, has infinite coefficients, or hardly leads on.
    #[inline(always)]
    fn needs_run(&self, attempt: &LanesAttempt<'_, S, Y>, length: S) -> S::Mask {
        let LanesAttempt { h, clock, state, slope, coefficients: [last, ahead], is_first } = attempt;
        let mut turns = S::Mask::splat(false);
        for (component, after) in state.value().as_ref().iter().enumerate() {
            let [y, rate] = [self.state.value(), &last[0]].map(|of| of.as_ref()[component]);
            let [rate_after, slope] = [&ahead[0], slope].map(|of| of.as_ref()[component]);
            turns = turns | self.rule.turns(component, *h, [y, rate], [*after, rate_after, slope]);
        }
        let short = S::from_f64(SHORT) * least_step(clock.time());
        let leads_on = short.less_equal(length) & are_finite(&ahead[self.rule.order - 1]);
        (turns & !*is_first) | (!leads_on & !is_equal(clock.time(), self.end))
    }

    /// Returns the lanes whose motions appear stiff from the coefficients ahead.
    #[cold]
    #[inline(never)]
    fn look_stiff(&mut self, ahead: &[Y]) -> [bool; MAX_LANES] {
        let mut look_stiff = [false; MAX_LANES];
        let Some(stability) = self.rule.stability else { return look_stiff };
        let lengths = (self.length, self.end - self.clock.time());
        let are_at_limit = is_at_limit(&stability, lengths, self.state.value(), ahead);
        for (lane, looks_stiff) in look_stiff.iter_mut().enumerate().take(S::LANES) {
            let stiffness = &mut self.stiffness[lane];
            if self.is_taken.lane(lane) && stiffness.is_due(self.counts.taken(lane)) {
                *looks_stiff = stiffness.count(are_at_limit.lane(lane));
            }
        }
        look_stiff
    }

    /// Abandons motions.
    #[cold]
    fn give_up(&mut self, which: impl Fn(usize) -> bool) {
        for lane in 0..S::LANES {
            if which(lane) || self.counts.tried(lane) > self.most_expansions() {
                self.clock.set_time(lane, S::Element::NAN);
            }
        }
    }

    /// Returns the maximum number of expansions: one at the start, and one for each step.
    #[inline(always)]
    fn most_expansions(&self) -> u64 {
        self.most_steps.saturating_add(1)
    }
}

impl<S, E> LanesStepper<S, E> for TaylorLanes<S, E::State>
where
    S: SideBySide<Element: Scalar>,
    E: Equations<S>,
{
    type LastStep = TaylorLastStep<S, E::State>;
    type Workspace = TaylorWorkspace<E::State, E::Series>;

    #[inline(always)]
    fn workspace() -> Self::Workspace {
        let none = [E::State::ZERO; MAX_ORDER];
        TaylorWorkspace { products: E::Series::default(), last: none, ahead: none }
    }

    #[inline(always)]
    fn start(&mut self, _equations: &E, y: &E::State) {
        self.state = Compensated::new(*y);
    }

    #[inline(always)]
    fn last_step(&self) -> Self::LastStep {
        TaylorLastStep { t: self.clock.time(), y: *self.state.value() }
    }

    #[inline(always)]
    fn begin(&self, last: &mut Self::LastStep) {
        *last = LanesStepper::<S, E>::last_step(self);
    }

    #[inline(always)]
    fn step(&mut self, equations: &E, workspace: &mut Self::Workspace) {
        let (order, t) = (self.rule.order, self.clock.time());
        workspace.go_on(order, self.is_taken);
        let TaylorWorkspace { products, last, ahead } = workspace;
        let (last, ahead) = (&last[..order], &mut ahead[..order]);

        let is_first = self.length.less(S::ZERO);
        let mut clock = self.clock.with_step(self.length);
        let h = clock.advance(self.end);
        let is_stopped = self.length.less(least_step(t)) | self.clock.is_stopped(&clock);
        let is_lost = (is_stopped & !is_equal(t, self.end)) | !S::ZERO.less(self.length);
        let mut state = self.state;
        state.add(&increment::<false, S, _>(last, h));
        let slope = slope::<false, S, _>(last, &self.rule.orders, h);
        let clock = Clock::select(is_first, &self.clock, &clock);
        let state = Compensated::select(is_first, &self.state, &state);
        equations.expand::<false>(clock.time(), state.value(), products, ahead);

        let attempt = LanesAttempt { h, clock, state, slope, coefficients: [last, ahead], is_first };
        let is_taken = self.fits(&attempt);
        let length = self.rule.accurate_length(state.value(), ahead);
        let needs_run = is_taken & self.needs_run(&attempt, length);
        let needs_run = needs_run | (is_lost & !is_first) | (is_first & !is_taken);
        self.length = S::select(is_taken, length, h.abs() * S::from_f64(0.5));
        self.clock = Clock::select(is_taken, &clock, &self.clock);
        self.state = Compensated::select(is_taken, &state, &self.state);
        self.is_taken = is_taken;
        let are_spent = self.counts.count::<S>(is_taken, self.most_expansions());
        if are_spent || needs_run.any() {
            self.give_up(|lane| needs_run.lane(lane));
        }
        if (is_taken & are_many((self.length, self.end - self.clock.time()))).any() {
            let look_stiff = self.look_stiff(ahead);
            self.give_up(|lane| look_stiff[lane]);
        }
    }

    #[inline(always)]
    fn interpolate(&self, workspace: &Self::Workspace, last: &Self::LastStep, t: S) -> E::State {
        let mut within = last.y;
        let change = increment::<false, S, _>(&workspace.last[..self.rule.order], t - last.t);
        for (component, change) in within.as_mut().iter_mut().zip(change.as_ref()) {
            *component = *component + *change;
        }
        chosen(is_equal(t, self.clock.time()), self.state.value(), &within)
    }

    #[inline(always)]
    fn time(&self) -> S {
        self.clock.time()
    }

    #[inline(always)]
    fn state(&self) -> &E::State {
        self.state.value()
    }

    fn limit_steps(&mut self, most: u64) {
        self.most_steps = self.most_steps.min(most);
    }

    fn work(&self, lane: usize) -> Work {
        let (led_on, expansions) = (self.counts.taken(lane), self.counts.tried(lane));
        let steps = led_on.saturating_sub(1);
        Work { steps, rejections: expansions - led_on, evaluations: expansions, ..Work::default() }
    }
}
