//! Back onto closed contacts: gaps to zero, and the velocities that contacts and sticking friction
//! hold.

use core::array;

use super::choice::Rule;
use super::initial_modes::{holds, lengths};
use super::reaction_forces::Balance;
use super::{Contact, ContactSystem, Mode, Terms};
use crate::scalar::{Number, Scalar};
use crate::system::{
    StateVector, StepFailure, Violation, displaced, join, normalise_described, reach, split,
};
use crate::tolerance::{BALANCED, CLOSED_GAP, SLIT};

/// Gaps are brought to zero in so many rounds or not at all. Errors are squared in each.
const MOST_ROUNDS: u32 = 12;

/// Brings a state onto the closed contacts and sticking friction. Gaps become zero by the smallest
/// change of the coordinates that the mechanism allows, measured by the mass matrix. Then their
/// rates and slip velocities become zero by the smallest change of the velocities. Constraints keep
/// holding to first order in the change. Unit quaternions are normalised first.
///
/// # Errors
/// If a gap cannot be closed, with its name and what is left of it; the state is then what it was.
pub fn correct<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    y: &mut M::State,
) -> Result<(), StepFailure<M::Scalar>>
where
    M: ContactSystem<N, K>,
{
    let modes = system.modes();
    let is_held = modes.map(holds);
    let mut unit = *y;
    normalise_described::<M>(system.description(), &mut unit)?;
    if is_held == [false; K] {
        *y = unit;
        return Ok(());
    }
    let (mut q, mut v) = split::<M>(&unit);
    close(system, t, &mut q, &v, modes.map(|mode| mode == Mode::Contact(Contact::Closed)))?;
    halt(&system.terms(t, &q, &v), &mut v, is_held);
    if q.as_ref().iter().chain(&v).any(|entry| !entry.is_finite()) {
        return Err(StepFailure::NotFinite);
    }
    *y = join::<M>(&q, &v);
    Ok(())
}

/// Brings these gaps to zero.
pub(super) fn close<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    q: &mut M::Coordinates,
    v: &[M::Scalar; N],
    is_closed: [bool; K],
) -> Result<(), StepFailure<M::Scalar>>
where
    M: ContactSystem<N, K>,
{
    if is_closed == [false; K] {
        return Ok(());
    }
    let (mut closed, size) = (*q, reach(system, t, q, q));
    for _ in 0..MOST_ROUNDS {
        let terms = system.terms(t, &closed, v);
        let before = closed;
        if widest(&terms, &size, is_closed).is_some() {
            displace(system, t, &terms, &mut closed, terms.gaps, is_closed);
        }
        if is_same(&before, &closed, q) {
            *q = closed;
            return Ok(());
        }
    }
    // Gaps that are coordinates have no terms beside which they could be small: what counts is then
    // the size of the coordinates.
    let lengths = reach(system, t, q, &lengths(q));
    if widest(&system.terms(t, &closed, v), &lengths, is_closed).is_none() {
        *q = closed;
        return Ok(());
    }
    let terms = system.terms(t, q, v);
    let k = widest(&terms, &size, is_closed).unwrap_or_default();
    Err(StepFailure::Violated(Violation::of_gap(M::REACTIONS[k], terms.gaps[k])))
}

/// True if two vectors differ by no more than the rounding of a third. One that is not a number
/// differs from every other.
fn is_same<S: Scalar, Q: StateVector<S>>(one: &Q, other: &Q, scale: &Q) -> bool {
    let rounding = CLOSED_GAP.part::<S>();
    let differences = one.as_ref().iter().zip(other.as_ref()).zip(scale.as_ref());
    differences.into_iter().all(|((a, b), scale)| a == b || (*a - *b).abs() <= rounding * scale.abs())
}

/// The widest of these gaps that is not closed but for the rounding of these coordinates; one that
/// is not a number is not.
fn widest<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    scale: &[S; N],
    is_closed: [bool; K],
) -> Option<usize> {
    let rounding = CLOSED_GAP.part::<S>();
    let mut widest: Option<usize> = None;
    for k in (0..K).filter(|k| is_closed[*k]) {
        let gap = terms.gaps[k].abs();
        let is_closed = gap == S::ZERO || gap <= rounding * terms.size_of(k, scale);
        if !is_closed && widest.is_none_or(|other| gap > terms.gaps[other].abs()) {
            widest = Some(k);
        }
    }
    widest
}

/// Brings these rates to zero. What rounding leaves of a velocity becomes zero, too, since events
/// of it would otherwise happen at every change of its sign.
pub(super) fn halt<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    v: &mut [S; N],
    is_held: [bool; K],
) {
    let shares = shares(terms, terms.rates, is_held);
    let (before, rounding) = (*v, BALANCED.part::<S>());
    *v = terms.added(v, &shares);
    for (i, v) in v.iter_mut().enumerate() {
        let parts = terms.responses.iter().zip(&shares).map(|(response, share)| (response[i] * *share).abs());
        let size = parts.fold(before[i].abs(), |sum, part| sum + part);
        if v.abs() <= rounding * size {
            *v = S::ZERO;
        }
    }
}

/// The energy that it takes at least to give these contacts the rates that they have.
pub(super) fn energy<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    is_held: [bool; K],
) -> S {
    let rules = is_held.map(|is_held| if is_held { Rule::Holds } else { Rule::Absent });
    let shares = Balance::of_values(terms, terms.rates).reactions(&rules);
    let twice = shares.iter().zip(&terms.rates).fold(S::ZERO, |sum, (share, rate)| sum - *share * *rate);
    S::from_f64(0.5) * twice.abs()
}

/// Opens gaps that are zero except for rounding by a few roundings, so that they are not found
/// closed again at once. All are opened together, and with the closed ones, since opening one may
/// close another.
pub(super) fn part<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    terms: &Terms<M::Scalar, N, K>,
    q: &mut M::Coordinates,
    (are_touching, are_closed): ([bool; K], [bool; K]),
) where
    M: ContactSystem<N, K>,
{
    let size = reach(system, t, q, q);
    let slits: [M::Scalar; K] = array::from_fn(|k| SLIT.part::<M::Scalar>() * terms.size_of(k, &size));
    let is_parted: [bool; K] = array::from_fn(|k| are_touching[k] && terms.gaps[k] < slits[k]);
    if is_parted != [false; K] {
        let values =
            array::from_fn(|k| if is_parted[k] { terms.gaps[k] - slits[k] } else { M::Scalar::ZERO });
        displace(system, t, terms, q, values, array::from_fn(|k| is_parted[k] || are_closed[k]));
    }
}

/// Displaces positions by responses so that these gaps are taken away where they are held.
fn displace<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    terms: &Terms<M::Scalar, N, K>,
    q: &mut M::Coordinates,
    gaps: [M::Scalar; K],
    is_held: [bool; K],
) where
    M: ContactSystem<N, K>,
{
    let shares = shares(terms, gaps, is_held);
    *q = displaced(system, t, q, shares.into_iter().zip(&terms.responses));
}

/// Returns the multiples of the responses that remove these values where they are held.
fn shares<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    values: [S; K],
    is_held: [bool; K],
) -> [S; K] {
    let rules = is_held.map(|is_held| if is_held { Rule::Holds } else { Rule::Absent });
    Balance::of_values(terms, values).reactions(&rules)
}
