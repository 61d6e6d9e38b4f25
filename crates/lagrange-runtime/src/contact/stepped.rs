//! Steps of equal length over which contacts and friction act by impulses.

use core::array;

use super::padding::{filled, joined, own, parts};
use super::step::{ContactStep, Impulses, directed};
use super::{Contact, ContactSystem, Friction, Mode, Terms};
use crate::integrate::{FixedStepper, Formula, Memory, Method, Step, Stepper, WithinStep, Work};
use crate::linalg::vector::{combined, difference};
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, SettingError, StepFailure, displaced, reach};
use crate::tolerance::CLOSED_GAP;

/// Residual of the law from which steps are rejected, relative to the rates.
const LARGEST_RESIDUAL: f64 = 1e-3;
const FORWARDS: &str = "contacts and dry friction run forwards in time only";
const POSITIVE: &str = "the step size must be positive and finite";
const RESIDUAL: &str = "the largest residual must be positive and finite";

/// Steps of equal length in which contacts and friction act by impulses, for systems with many
/// contacts and for real time.
///
/// There is no search for events within the steps. All contacts that touch or are hit within a step
/// form one problem with the friction, by Coulomb's law. Its solution gives the velocities at the
/// end of the step. The error is proportional to the step, and contacts change their modes only at
/// the ends of steps. N velocities and K reactions follow from the system.
///
/// ```
/// use lagrange::Simulate;
/// use lagrange::contact::Stepped;
///
/// lagrange::system! {
///     #[derive(Clone, Debug)]
///     struct Ball;
///     coord y;
///     kinetic = 1/2 * dot(y)^2;
///     potential = 9.81 * y;
///     event floor = y, falling => impact(0.5);
/// }
///
/// let run = Ball::default().simulate([1.0, 0.0]).until(3.0).method(Stepped::every(1e-3)).run()?;
/// assert!(run.last()[0].abs() < 1e-9, "it lies on the floor");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stepped<S, const N: usize, const K: usize> {
    /// Length of a step.
    pub step: S,
    /// The largest rate by which impulses may miss the law; a larger one ends the run with an
    /// error.
    pub largest_residual: S,
}

impl<S: Scalar, const N: usize, const K: usize> Stepped<S, N, K> {
    /// Takes steps of this length, with residuals up to 10⁻³.
    pub fn every(step: S) -> Self {
        Stepped { step, largest_residual: S::from_f64(LARGEST_RESIDUAL) }
    }

    /// Ends a run with an error if impulses miss the law by a larger rate.
    #[must_use]
    pub fn largest_residual(self, largest_residual: S) -> Self {
        Stepped { largest_residual, ..self }
    }
}

impl<M, const N: usize, const K: usize> Method<M> for Stepped<M::Scalar, N, K>
where
    M: ContactSystem<N, K>,
{
    type Stepper = SteppedStepper<M, N, K>;

    fn name(&self) -> &'static str {
        "stepped contacts"
    }

    fn order(&self) -> u32 {
        1
    }

    fn check(&self) -> Result<(), SettingError<M::Scalar>> {
        let is_valid = |value: M::Scalar| value > M::Scalar::ZERO && value.is_finite();
        match (is_valid(self.step), is_valid(self.largest_residual)) {
            (true, true) => Ok(()),
            (false, _) => Err(SettingError::Invalid(POSITIVE)),
            _ => Err(SettingError::Invalid(RESIDUAL)),
        }
    }

    fn start(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self::Stepper, StepFailure<M::Scalar>> {
        Method::<M>::check(self)?;
        ContactSystem::check(system)?;
        if end < t {
            return Err(SettingError::Invalid(FORWARDS).into());
        }
        let formula = ImpulseFormula::new(self.largest_residual);
        let fixed = FixedStepper::start(formula, self.step, &freed(system), t, y, end)?;
        Ok(SteppedStepper { fixed })
    }
}

/// An integration by [`Stepped`].
#[derive(Debug)]
pub struct SteppedStepper<M: OdeSystem, const N: usize, const K: usize> {
    fixed: FixedStepper<M, ImpulseFormula<M::Scalar, N, K>>,
}

impl<M: OdeSystem, const N: usize, const K: usize> Clone for SteppedStepper<M, N, K> {
    fn clone(&self) -> Self {
        SteppedStepper { fixed: self.fixed.clone() }
    }
}

impl<M: ContactSystem<N, K>, const N: usize, const K: usize> SteppedStepper<M, N, K> {
    /// Calls `note` with each number that [`restore`](Self::restore) needs: those of
    /// [`FixedStepper::save`], with the impulses and modes of the last step.
    pub fn save(&self, note: impl FnMut(M::Scalar)) {
        self.fixed.save(note);
    }

    /// Restores a motion from [saved](Self::save) numbers. It continues bit for bit as the saved
    /// one. Method and settings must be the same.
    ///
    /// # Errors
    /// If there are more or fewer numbers, or one is not finite. The motion is then unchanged.
    pub fn restore(
        &mut self,
        numbers: impl IntoIterator<Item = M::Scalar>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        self.fixed.restore(numbers)
    }

    /// Returns the impulses of all reactions over the last step, in the order of declaration.
    pub fn impulses(&self) -> &[M::Scalar; K] {
        &self.fixed.formula().impulses
    }

    /// Returns the largest rate by which an impulse missed the law since the first start.
    pub fn worst_residual(&self) -> M::Scalar {
        self.fixed.formula().worst
    }
}

impl<M: ContactSystem<N, K>, const N: usize, const K: usize> Stepper<M> for SteppedStepper<M, N, K> {
    const FINDS_MODES: bool = true;

    #[inline]
    fn time(&self) -> M::Scalar {
        Stepper::<M>::time(&self.fixed)
    }

    #[inline]
    fn state(&self) -> &M::State {
        self.fixed.state()
    }

    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        self.fixed.step(&freed(system), limit)
    }

    fn last_time(&self) -> M::Scalar {
        self.fixed.last_time()
    }

    fn interpolate(&mut self, system: &M, t: M::Scalar) -> M::State {
        self.fixed.interpolate(&freed(system), t)
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>> {
        self.fixed.restart(&freed(system), t, y)
    }

    fn in_modes(&self, system: &M) -> Option<M> {
        Some(system.in_modes(self.fixed.formula().modes().unwrap_or(free(system.modes()))))
    }

    fn work(&self) -> Work {
        self.fixed.work()
    }
}

/// Returns the system in which nothing touches, sticks or slips in a known direction, as the method
/// needs no modes between its steps.
fn freed<M: ContactSystem<N, K>, const N: usize, const K: usize>(system: &M) -> M {
    system.in_modes(free(system.modes()))
}

/// Returns the modes of these reactions in which none acts.
fn free<const K: usize>(modes: [Mode; K]) -> [Mode; K] {
    modes.map(|mode| match mode {
        Mode::Contact(_) => Mode::Contact(Contact::Open),
        Mode::Friction(_) => Mode::Friction(Friction::Slips),
        Mode::Across(_) => Mode::Across(Friction::Slips),
        Mode::Smooth => Mode::Smooth,
    })
}

/// The formula of [`Stepped`].
#[derive(Clone, Copy, Debug)]
pub struct ImpulseFormula<S, const N: usize, const K: usize> {
    largest_residual: S,
    worst: S,
    /// Impulses over the last step, its length, and the modes at its end.
    impulses: [S; K],
    length: S,
    modes: Option<[Mode; K]>,
    /// Directions in which friction slips in planes, which modes do not contain yet.
    directions: [S; K],
}

impl<S: Scalar, const N: usize, const K: usize> ImpulseFormula<S, N, K> {
    fn new(largest_residual: S) -> Self {
        let (zero, zeros) = (S::ZERO, [S::ZERO; K]);
        ImpulseFormula {
            largest_residual,
            worst: zero,
            impulses: zeros,
            length: zero,
            modes: None,
            directions: zeros,
        }
    }

    /// Returns the modes at the end of the last step, if there was one.
    fn modes(&self) -> Option<[Mode; K]> {
        Some(directed(&self.modes?, &self.directions))
    }

    /// Returns the impulses over a step of length h, if the forces do not change.
    fn expected(&self, h: S) -> [S; K] {
        match self.length > S::ZERO {
            true => self.impulses.map(|impulse| impulse * (h / self.length)),
            false => self.impulses,
        }
    }

    /// Keeps impulses that satisfy the law accurately enough.
    fn keep(
        &mut self,
        found: &Impulses<S, N, K>,
        h: S,
        name: impl Fn(usize) -> &'static str,
    ) -> Result<(), StepFailure<S>> {
        let (residual, k) = found.residual;
        if residual > self.largest_residual || !residual.is_finite() {
            return Err(StepFailure::Residual { reaction: name(k), value: residual });
        }
        self.worst = self.worst.max(residual);
        (self.impulses, self.length) = (found.impulses, h);
        (self.modes, self.directions) = (Some(found.modes), found.directions);
        Ok(())
    }
}

impl<S: Scalar, const N: usize, const K: usize> Memory<S> for ImpulseFormula<S, N, K> {
    fn visit(&mut self, _t: S, each: &mut impl FnMut(&mut S)) {
        let present = self.modes();
        let mut has_modes = if present.is_some() { S::ONE } else { S::ZERO };
        each(&mut has_modes);
        each(&mut self.length);
        self.impulses.iter_mut().for_each(&mut *each);
        let modes = present.unwrap_or([Mode::Smooth; K]).map(|mode| {
            let mut numbers = mode.numbers();
            numbers.iter_mut().for_each(&mut *each);
            Mode::of_numbers(numbers)
        });
        (self.modes, self.directions) = ((has_modes != S::ZERO).then_some(modes), [S::ZERO; K]);
    }
}

/// Returns the depths up to which overlaps are rounding, at least this one, if there are deeper
/// overlaps.
fn slits<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    q: &M::Coordinates,
    terms: &Terms<M::Scalar, N, K>,
    least: M::Scalar,
) -> Option<[M::Scalar; K]>
where
    M: ContactSystem<N, K>,
{
    let overlaps = |k: &usize| terms.gaps[*k] < -least;
    if !(0..K).any(|k| overlaps(&k)) {
        return None;
    }
    let (lengths, root) = (filled::<M, N>(&reach(system, t, q, q)), M::Scalar::epsilon().sqrt());
    let slit = |k: usize| (root * terms.size_of(k, &lengths)).max(least);
    (0..K).filter(overlaps).any(|k| terms.gaps[k] < -slit(k)).then(|| array::from_fn(slit))
}

impl<M, const N: usize, const K: usize> Formula<M> for ImpulseFormula<M::Scalar, N, K>
where
    M: ContactSystem<N, K>,
{
    fn variables(&mut self, _system: &M, _t: M::Scalar, y: &M::State) -> M::State {
        (self.impulses, self.length, self.modes) = ([M::Scalar::ZERO; K], M::Scalar::ZERO, None);
        *y
    }

    fn increment(
        &mut self,
        &Step { system, t, y, h }: &Step<'_, M>,
        work: &mut Work,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let (q, v) = parts::<M, N>(y);
        let (mut forced, modes) = (system.step_terms(t, &q, &v, h), system.modes());
        let largest = q.as_ref().iter().fold(M::Scalar::ZERO, |largest, q| largest.max(q.abs()));
        let closed = CLOSED_GAP.part::<M::Scalar>() * largest;
        let slits = slits(system, t, &q, forced.terms(), closed);
        let (terms, metric) = forced.normalise();
        work.evaluations += 1;
        let jumps = array::from_fn(|k| system.gradient_jumps(k));
        if jumps.contains(&true) {
            terms.remove_curvatures(&jumps);
        }
        let mut step = ContactStep::new(terms, &metric, &modes, [h, closed]);
        if !step.is_finite() {
            return Err(step.terms.not_finite(system, t, &q));
        }
        let restitutions = step.terms.restitutions(system, &modes, |_| true)?;
        if step.terms.may_have_negative_limits(&modes) {
            step.check_limits(system)?;
        }
        let mut found = step.solve(&restitutions, &self.expected(h));
        if jumps.contains(&true) {
            found = step.follow(system, (t, &q, &v), &jumps, (&restitutions, found));
        }
        work.iterations += u64::from(found.iterations);
        work.inexact += u64::from(!found.is_exact);
        self.keep(&found, h, |k| system.reaction_name(k))?;
        let displacement = slits.map(|slits| step.separation(&slits));
        let to = combined(&combined(&v, h, &step.terms.free), M::Scalar::ONE, &found.change);
        let rates = system.position_rates(t, &q, &own(system, &to));
        let mut moved = combined(&q, h, &rates);
        if let Some(displacement) = displacement {
            moved = displaced(system, t, &moved, [(M::Scalar::ONE, &own(system, &displacement))]);
        }
        let end = joined(system, &moved, &to);
        Ok(difference(&end, y))
    }

    fn interpolate(&mut self, within: &WithinStep<'_, M>, _work: &mut Work) -> M::State {
        let [start, end] = within.states();
        combined(start, within.fraction(), &difference(end, start))
    }
}
