//! A motion followed along its Taylor series.

use super::{Taylor, widest};
use crate::integrate::clock::{Clock, least_step};
use crate::integrate::compensated::Compensated;
use crate::integrate::corrected::{admitted, check_finite, correct, corrected};
use crate::integrate::method::{Stepper, Work};
use crate::integrate::verner::tolerance::{Tolerated, longest_step};
use crate::linalg::vector::combined;
use crate::scalar::{Number, Scalar};
use crate::system::{MAX_ORDER, StateVector, StepFailure, TaylorSystem};
use crate::tolerance::LEAST_TOLERANCE;

/// The last terms of a series may be this part of what is tolerated: what follows them adds up, and
/// so do steps.
const SAFETY: f64 = 0.01;
/// Largest difference between the rate at the end of a step and the slope of its polynomial, in
/// tolerances over the length of the step.
const LARGEST_DEFECT: f64 = 1.0;
/// Orders that the length of a step follows from: coefficients may vanish in turn.
const LAST_ORDERS: usize = 4;

/// An integration by [`Taylor`] series in progress.
#[derive(Clone, Debug)]
pub struct TaylorStepper<M: TaylorSystem + ?Sized> {
    settings: Taylor<M::Scalar>,
    order: usize,
    /// From the start to the end that was in view there.
    span: M::Scalar,
    clock: Clock<M::Scalar>,
    state: Compensated<M::State>,
    /// The expansion at the present state, and the one that the last step followed.
    expansions: [Expansion<M::Scalar, M::State>; 2],
    /// Place of the expansion at the present state.
    present: usize,
    series: M::Series,
    work: Work,
}

/// The motion through a state: that, and its coefficients of order one and higher.
#[derive(Clone, Copy, Debug)]
struct Expansion<S, Y> {
    t: S,
    y: Y,
    coefficients: [Y; MAX_ORDER],
}

impl<M: TaylorSystem + ?Sized> TaylorStepper<M> {
    pub(super) fn start(
        settings: Taylor<M::Scalar>,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self, StepFailure<M::Scalar>> {
        check_finite(end, y)?;
        let expansion = Expansion { t, y: *y, coefficients: [M::State::ZERO; MAX_ORDER] };
        let mut stepper = TaylorStepper {
            settings,
            order: settings.chosen_order(),
            span: end - t,
            clock: Clock::new(t, M::Scalar::ZERO),
            state: Compensated::new(*y),
            expansions: [expansion; 2],
            present: 0,
            series: M::series(),
            work: Work::default(),
        };
        stepper.restart(system, t, y)?;
        Ok(stepper)
    }
}

impl<S: Scalar, Y: StateVector<S>> Expansion<S, Y> {
    /// The change of the state over a time `h`.
    #[inline(always)]
    fn change(&self, order: usize, h: S) -> Y {
        let mut change = self.polynomial(order, h, |_, coefficients| *coefficients);
        change.as_mut().iter_mut().for_each(|sum| *sum = *sum * h);
        change
    }

    /// The slope of the polynomial after a time `h`.
    #[inline(always)]
    fn slope(&self, order: usize, h: S) -> Y {
        self.polynomial(order, h, |k, coefficients| {
            let (mut term, factor) = (*coefficients, S::from_f64((k + 1) as f64));
            term.as_mut().iter_mut().for_each(|entry| *entry = *entry * factor);
            term
        })
    }

    /// Σ hᵏ times the term of order k + 1, as four polynomials in h⁴, so that no term waits for the
    /// one before.
    #[inline(always)]
    fn polynomial(&self, order: usize, h: S, term: impl Fn(usize, &Y) -> Y) -> Y {
        let square = h * h;
        let fourth = square * square;
        let (blocks, rest) = self.coefficients[..order].as_chunks::<4>();
        let mut sums = [Y::ZERO; 4];
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
}

impl<M: TaylorSystem + ?Sized> TaylorStepper<M> {
    /// The tolerated error of a component of this size.
    fn tolerated(&self, component: M::Scalar) -> M::Scalar {
        let Tolerated { relative, absolute } = Tolerated::new(self.settings.relative, self.settings.absolute);
        relative.multiply_add(component.abs(), absolute)
    }

    /// The longest step from the present state.
    fn longest(&self) -> M::Scalar {
        let longest = |is_at_rest| longest_step(self.settings.longest_step, self.span, is_at_rest);
        let (tolerated, ahead) =
            (Tolerated::new(self.settings.relative, self.settings.absolute), self.ahead());
        longest(tolerated.is_at_rest(longest(true), &ahead.coefficients[0], &ahead.y))
    }

    /// The expansion at the present state.
    fn ahead(&self) -> &Expansion<M::Scalar, M::State> {
        &self.expansions[self.present]
    }

    /// The expansion that the last step followed.
    fn last(&self) -> &Expansion<M::Scalar, M::State> {
        &self.expansions[1 - self.present]
    }

    /// Makes the present state that of no step.
    fn forget_last(&mut self) {
        let Expansion { t, y, .. } = *self.ahead();
        let last = &mut self.expansions[1 - self.present];
        (last.t, last.y) = (t, y);
    }

    /// Expands the motion about a state.
    fn expand(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        let present = &mut self.expansions[self.present];
        (present.t, present.y) = (t, *y);
        widest::expand(system, t, y, &mut self.series, &mut present.coefficients[..self.order]);
        self.work.evaluations += 1;
    }

    /// Returns the length of a step whose last terms are small enough. It is the largest h with |cₖ|
    /// hᵏ ≤ tolerance for the last four orders k, each extrapolated to the order of the whole
    /// series.
    fn length(&self) -> M::Scalar {
        let order = M::Scalar::from_f64(self.order as f64);
        let tolerance = self.settings.loosest().max(LEAST_TOLERANCE.part::<M::Scalar>());
        let wanted = (M::Scalar::from_f64(SAFETY) * tolerance).rough_log2() / order;
        let mut shortest = None;
        let mut scales = self.ahead().y;
        scales.as_mut().iter_mut().for_each(|scale| *scale = tolerance / self.tolerated(*scale));
        for k in self.order - LAST_ORDERS..self.order {
            let coefficients = self.ahead().coefficients[k].as_ref().iter().zip(scales.as_ref());
            let relative = coefficients.fold(M::Scalar::ZERO, |largest, (coefficient, scale)| {
                largest.max(coefficient.abs() * *scale)
            });
            if relative > M::Scalar::ZERO {
                let radius = -relative.rough_log2() / M::Scalar::from_f64((k + 1) as f64);
                shortest = Some(shortest.map_or(radius, |shortest: M::Scalar| shortest.min(radius)));
            }
        }
        let longest = self.longest();
        shortest.map_or(longest, |radius| (radius + wanted).rough_exp2().min(longest))
    }

    /// True if the polynomial of the last step has the slope that the motion has at its end, as far
    /// as is tolerated.
    fn fits(&self, h: M::Scalar) -> bool {
        let slope = self.last().slope(self.order, h);
        let rates = slope.as_ref().iter().zip(self.ahead().coefficients[0].as_ref());
        let sizes = self.last().y.as_ref().iter().zip(self.ahead().y.as_ref());
        rates.zip(sizes).all(|((slope, rate), (before, after))| {
            let rounding = LEAST_TOLERANCE.part::<M::Scalar>() * rate.abs().max(slope.abs());
            let size = before.abs().max(after.abs());
            let tolerated = M::Scalar::from_f64(LARGEST_DEFECT) * self.tolerated(size);
            ((*slope - *rate).abs() - rounding) * h.abs() <= tolerated
        })
    }

    /// Tries a step of this length; true if it was taken.
    fn attempt(
        &mut self,
        system: &M,
        length: M::Scalar,
        limit: M::Scalar,
    ) -> Result<bool, StepFailure<M::Scalar>> {
        let mut clock = self.clock.with_step(length);
        let h = clock.advance(limit);
        if self.clock.is_stopped(&clock) {
            return Err(StepFailure::StepUnderflow { step: length });
        }
        let mut state = self.state;
        state.add(&self.ahead().change(self.order, h));
        check_finite(clock.time(), state.value())?;
        correct(system, clock.time(), &mut state)?;
        let y = *state.value();
        self.present = 1 - self.present;
        self.expand(system, clock.time(), &y);
        if self.fits(h) {
            (self.clock, self.state) = (clock, state);
            self.work.steps += 1;
            return Ok(true);
        }
        self.present = 1 - self.present;
        self.forget_last();
        Ok(false)
    }
}

impl<M: TaylorSystem + ?Sized> Stepper<M> for TaylorStepper<M> {
    fn time(&self) -> M::Scalar {
        self.clock.time()
    }

    fn state(&self) -> &M::State {
        self.state.value()
    }

    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        let mut length = self.length().max(least_step(self.clock.time()));
        let mut lost = None;
        loop {
            if self.work.steps + self.work.rejections >= self.settings.max_steps {
                return Err(StepFailure::TooManySteps { limit: self.settings.max_steps });
            }
            let is_step = length > M::Scalar::ZERO && length >= least_step(self.clock.time());
            if !is_step {
                return Err(lost.unwrap_or(StepFailure::StepUnderflow { step: length }));
            }
            match self.attempt(system, length, limit) {
                Ok(true) => return Ok(()),
                Ok(false) => lost = None,
                Err(cause @ StepFailure::StepUnderflow { .. }) => return Err(lost.unwrap_or(cause)),
                Err(cause) => lost = Some(cause),
            }
            self.work.rejections += 1;
            let left = (limit - self.clock.time()).abs();
            length = length.min(left) * M::Scalar::from_f64(0.5);
        }
    }

    fn last_time(&self) -> M::Scalar {
        self.last().t
    }

    fn interpolate(&mut self, system: &M, t: M::Scalar) -> M::State {
        if t == self.clock.time() {
            return *self.state.value();
        }
        if t == self.last().t {
            return self.last().y;
        }
        let change = self.last().change(self.order, t - self.last().t);
        let mut y = self.last().y;
        for (component, change) in y.as_mut().iter_mut().zip(change.as_ref()) {
            *component = *component + *change;
        }
        corrected(system, t, y)
    }

    fn limit_steps(&mut self, most: u64) {
        self.settings.max_steps = self.settings.max_steps.min(most);
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>> {
        let y = &admitted(system, t, y)?;
        self.expand(system, t, y);
        check_finite(t, &self.ahead().coefficients[0])?;
        self.clock = Clock::new(t, M::Scalar::ZERO);
        self.state = Compensated::new(*y);
        self.forget_last();
        Ok(())
    }

    fn work(&self) -> Work {
        self.work
    }
}
