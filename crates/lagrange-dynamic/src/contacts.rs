//! Contacts and friction of interpreted systems, in arrays of the next larger size.

use std::ops::{Deref, DerefMut};

use lagrange_core::model::Product;
use lagrange_core::pipeline::TouchingPrograms;
use lagrange_core::program::Program;
use lagrange_runtime::contact::{self, Contact, ContactSystem, ForcedTerms, LimitSlope, Mode, Terms};
use lagrange_runtime::system::{Reacted, StateVector, StepFailure};

use crate::inline::Inline;
use crate::reactions::{MAX_COUNTS, in_room};
use crate::system::DynamicSystem;

/// Terms of contacts and friction with any number of slopes.
#[derive(Debug)]
pub struct DynamicTerms<const N: usize, const K: usize>(Box<Terms<f64, N, K>>);

impl<const N: usize, const K: usize> Deref for DynamicTerms<N, K> {
    type Target = Terms<f64, N, K>;

    fn deref(&self) -> &Terms<f64, N, K> {
        &self.0
    }
}

impl<const N: usize, const K: usize> DerefMut for DynamicTerms<N, K> {
    fn deref_mut(&mut self) -> &mut Terms<f64, N, K> {
        &mut self.0
    }
}

/// Values of the program of the terms, in its order.
struct Values<'a> {
    left: &'a [f64],
    /// Number of velocities.
    n: usize,
    /// Number of reactions.
    k: usize,
}

impl<'a> Values<'a> {
    fn take(&mut self, count: usize) -> &'a [f64] {
        let (taken, left) = self.left.split_at(count);
        self.left = left;
        taken
    }

    /// Takes a vector, which `fill` follows.
    fn vector<const LENGTH: usize>(&mut self, count: usize, fill: f64) -> [f64; LENGTH] {
        let mut vector = [fill; LENGTH];
        vector[..count].copy_from_slice(self.take(count));
        vector
    }

    /// Takes a matrix with a row for each reaction.
    fn rows<const N: usize, const K: usize>(&mut self) -> [[f64; N]; K] {
        let mut rows = [[0.0; N]; K];
        let n = self.n;
        rows[..self.k].iter_mut().for_each(|row| *row = self.vector(n, 0.0));
        rows
    }

    /// Takes a square matrix, with these entries on the diagonal after it.
    fn square<const N: usize>(&mut self, diagonal: f64) -> [[f64; N]; N] {
        let (mut square, n) = ([[0.0; N]; N], self.n);
        for (i, row) in square.iter_mut().enumerate() {
            match i < n {
                true => *row = self.vector(n, 0.0),
                false => row[i] = diagonal,
            }
        }
        square
    }

    /// Takes the terms except their slopes. Gaps of filling contacts are one.
    fn terms<const N: usize, const K: usize>(&mut self) -> Terms<f64, N, K, [LimitSlope<f64>; 0]> {
        let (n, k) = (self.n, self.k);
        Terms {
            free: self.vector(n, 0.0),
            responses: self.rows(),
            rows: self.rows(),
            gaps: self.vector(k, 1.0),
            rates: self.vector(k, 0.0),
            drifts: self.vector(k, 0.0),
            restitutions: self.vector(k, 0.0),
            kinetic: self.vector(k, 0.0),
            fixed: self.vector(k, 0.0),
            slopes: [],
        }
    }
}

/// Stores the terms with these slopes.
fn with_slopes<const N: usize, const K: usize>(
    terms: &Terms<f64, N, K, [LimitSlope<f64>; 0]>,
    slopes: &[LimitSlope<f64>],
) -> Box<Terms<f64, N, K>> {
    match slopes.len() {
        0..=8 => sized::<N, K, 8>(terms, slopes),
        9..=48 => sized::<N, K, 48>(terms, slopes),
        49..=512 => sized::<N, K, 512>(terms, slopes),
        _ => sized::<N, K, { MAX_COUNTS[1] * MAX_COUNTS[1] }>(terms, slopes),
    }
}

/// Stores the terms with these slopes, followed by some of no reaction.
#[inline(never)]
fn sized<const N: usize, const K: usize, const L: usize>(
    terms: &Terms<f64, N, K, [LimitSlope<f64>; 0]>,
    slopes: &[LimitSlope<f64>],
) -> Box<Terms<f64, N, K>> {
    let none = LimitSlope { limited: usize::MAX, reaction: 0, kinetic: 0.0, fixed: 0.0 };
    let Terms { free, responses, rows, gaps, rates, drifts, restitutions, kinetic, fixed, .. } = *terms;
    let slopes_of_none = [none; L];
    let mut terms = Box::new(Terms {
        free,
        responses,
        rows,
        gaps,
        rates,
        drifts,
        restitutions,
        kinetic,
        fixed,
        slopes: slopes_of_none,
    });
    terms.slopes[..slopes.len()].copy_from_slice(slopes);
    terms
}

impl<const CAPACITY: usize> DynamicSystem<CAPACITY> {
    /// Runs a program at a state.
    pub(crate) fn evaluate(&self, program: &Program, t: f64, y: &Inline<CAPACITY>) -> Vec<f64> {
        let (q, v) = y.parts(0);
        self.evaluate_at(program, t, q, v)
    }

    /// Runs a program with the accelerations, multipliers and reactions of the motion.
    pub(crate) fn evaluate_at(&self, program: &Program, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        match self.is_touching() {
            true => {
                self.numeric.evaluate_under(program, (t, q, v), || self.accelerations_and_reactions(t, q, v))
            }
            false => self.numeric.evaluate(program, t, q, v),
        }
    }

    /// Computes a product at a state; `None` if it was not derived.
    pub(crate) fn product(
        &self,
        product: Product,
        t: f64,
        q: &Inline<CAPACITY>,
        v: &Inline<CAPACITY>,
    ) -> Option<Vec<f64>> {
        Some(self.evaluate_at(self.programs().product(product)?, t, q.as_ref(), v.as_ref()))
    }

    /// True if no reaction acts: all are those of open contacts.
    fn is_open(&self) -> bool {
        self.modes.iter().all(|mode| *mode == Mode::Contact(Contact::Open))
    }

    /// Computes the accelerations.
    pub(crate) fn accelerations(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        if self.is_open() {
            return self.numeric.acceleration(t, q, v);
        }
        let [accelerations, _] = self.forces(t, q, v);
        accelerations
    }

    /// Computes the accelerations and the reactions.
    pub(crate) fn accelerations_and_reactions(&self, t: f64, q: &[f64], v: &[f64]) -> [Vec<f64>; 2] {
        let [accelerations, reactions] = self.forces(t, q, v);
        let accelerations = if self.is_open() { self.numeric.acceleration(t, q, v) } else { accelerations };
        [accelerations, reactions]
    }

    #[inline(never)]
    fn forces(&self, t: f64, q: &[f64], v: &[f64]) -> [Vec<f64>; 2] {
        in_room!(self, N, K, self.forces_in::<N, K>(t, q, v))
    }

    fn forces_in<const N: usize, const K: usize>(&self, t: f64, q: &[f64], v: &[f64]) -> [Vec<f64>; 2] {
        let terms = self.terms_at::<N, K>((t, q, v), 0.0).accelerated();
        let forces = contact::reactions(&terms, &ContactSystem::<N, K>::modes(self));
        let accelerations = terms.acceleration(&forces);
        [accelerations[..v.len()].to_vec(), forces[..self.modes.len()].to_vec()]
    }

    #[inline(never)]
    fn terms_at<const N: usize, const K: usize>(
        &self,
        (t, q, v): (f64, &[f64], &[f64]),
        h: f64,
    ) -> ForcedTerms<DynamicTerms<N, K>, f64, N> {
        let (found, slopes, matrices) = match &self.programs().touching {
            Some(TouchingPrograms { terms, slopes, matrices }) => {
                (self.numeric.evaluate(terms, t, q, v), &slopes[..], *matrices)
            }
            None => (self.numeric.acceleration(t, q, v), &[][..], 0),
        };
        let mut values = Values { left: &found, n: v.len(), k: self.modes.len() };
        let terms = values.terms::<N, K>();
        let slope = |&[limited, reaction]: &[usize; 2]| {
            let [kinetic, fixed] = values.vector(2, 0.0);
            LimitSlope { limited, reaction, kinetic, fixed }
        };
        let slopes = slopes.iter().map(slope).collect::<Vec<_>>();
        let terms = DynamicTerms(with_slopes(&terms, &slopes));
        match matrices {
            0 => ForcedTerms::complete(terms),
            1 => ForcedTerms::new(terms, values.square(1.0)),
            _ => ForcedTerms::damped(terms, values.square(1.0), &values.square(0.0), h),
        }
    }

    #[inline(never)]
    pub(crate) fn begin_touching(
        &self,
        t: f64,
        y: &Inline<CAPACITY>,
    ) -> Result<Option<Self>, StepFailure<f64>> {
        in_room!(self, N, K, contact::begin::<Self, N, K>(self, t, y))
    }

    #[inline(never)]
    pub(crate) fn react_touching(
        &self,
        event: usize,
        t: f64,
        elapsed: f64,
        y: &Inline<CAPACITY>,
    ) -> Reacted<Self> {
        in_room!(self, N, K, contact::react::<Self, N, K>(self, event, t, elapsed, y))
    }

    #[inline(never)]
    pub(crate) fn touching_values(&self, t: f64, y: &Inline<CAPACITY>, values: &mut [f64]) {
        in_room!(self, N, K, contact::event_values::<Self, N, K>(self, t, y, values));
    }

    #[inline(never)]
    pub(crate) fn correct_touching(&self, t: f64, y: &mut Inline<CAPACITY>) -> Result<(), StepFailure<f64>> {
        in_room!(self, N, K, contact::correct::<Self, N, K>(self, t, y))
    }

    /// True if the event changes a mode of contacts or friction.
    pub(crate) fn is_of_touching(&self, event: usize) -> bool {
        self.names.reactions.iter().any(|reaction| reaction.event == Some(event))
    }
}

/// N and K must be at least the numbers of velocities and reactions of the system. Results have the
/// bits of emitted code if K exceeds N exactly where there are more reactions than velocities.
impl<const CAPACITY: usize, const N: usize, const K: usize> ContactSystem<N, K> for DynamicSystem<CAPACITY> {
    type Terms = DynamicTerms<N, K>;

    const REACTIONS: [&'static str; K] = [""; K];

    fn modes(&self) -> [Mode; K] {
        let mut modes = [Mode::Contact(Contact::Open); K];
        modes[..self.modes.len()].copy_from_slice(&self.modes);
        modes
    }

    fn in_modes(&self, modes: [Mode; K]) -> Self {
        let mut system = self.clone();
        for (k, mode) in modes.into_iter().take(self.modes.len()).enumerate() {
            // Both components of friction in a plane have the mode of the first.
            system.modes[k] = match (mode, system.modes.get(k.wrapping_sub(1))) {
                (Mode::Across(_), Some(Mode::Friction(first))) => Mode::Across(*first),
                _ => mode,
            };
        }
        system
    }

    fn check(&self) -> Result<(), StepFailure<f64>> {
        Ok(self.check_parameters()?)
    }

    fn terms(&self, t: f64, q: &Inline<CAPACITY>, v: &[f64; N]) -> DynamicTerms<N, K> {
        self.step_terms(t, q, v, 0.0).accelerated()
    }

    fn step_terms(
        &self,
        t: f64,
        q: &Inline<CAPACITY>,
        v: &[f64; N],
        h: f64,
    ) -> ForcedTerms<DynamicTerms<N, K>, f64, N> {
        let v = &v[..ContactSystem::<N, K>::velocities(self)];
        self.terms_at((t, q.as_ref(), v), h)
    }

    fn event_of(&self, k: usize) -> Option<usize> {
        self.names.reactions.get(k)?.event
    }

    fn velocities(&self) -> usize {
        self.programs().layout.velocities
    }

    fn reaction_name(&self, k: usize) -> &'static str {
        self.names.reactions.get(k).map_or("", |reaction| reaction.name)
    }

    fn needs_steps(&self) -> Option<&'static str> {
        self.names.needs_steps
    }

    fn limit_reverses(&self, k: usize) -> bool {
        self.names.reactions.get(k).is_some_and(|reaction| reaction.limit_reverses)
    }

    fn gradient_jumps(&self, k: usize) -> bool {
        self.names.reactions.get(k).is_some_and(|reaction| reaction.gradient_jumps)
    }
}
