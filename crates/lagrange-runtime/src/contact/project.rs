//! Projection onto closed contacts: it makes gaps zero, and the velocities held by contacts and
//! sticking friction.

use core::array;

use super::choice::Rule;
use super::initial_modes::{holds, lengths};
use super::padding::{filled, joined, own, parts};
use super::reaction_forces::Balance;
use super::{Contact, ContactSystem, Mode, Terms};
use crate::scalar::{Number, Scalar};
use crate::system::{StateVector, StepFailure, Violation, displaced, normalise_described, reach};
use crate::tolerance::{BALANCED, CLOSED_GAP, SLIT};

/// Maximum number of rounds in which gaps are made zero. Each round squares the errors.
const MOST_ROUNDS: u32 = 12;

/// Projects a state onto the closed contacts and sticking friction. Gaps become zero by the
/// smallest change of the coordinates that the mechanism allows, measured by the mass matrix. Then
/// their rates and slip velocities become zero by the smallest change of the velocities.
/// Constraints remain satisfied to first order in the change. Unit quaternions are normalised
/// first.
///
/// # Errors
/// If a gap cannot be closed; the error contains its name and the remaining gap. The state is then
/// unchanged.
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
    let (mut q, mut v) = parts::<M, N>(&unit);
    close(system, t, &mut q, &v, modes.map(|mode| mode == Mode::Contact(Contact::Closed)))?;
    halt(&system.terms(t, &q, &v), &mut v, is_held);
    if q.as_ref().iter().chain(&v).any(|entry| !entry.is_finite()) {
        return Err(StepFailure::NotFinite);
    }
    *y = joined(system, &q, &v);
    Ok(())
}

/// Makes these gaps zero.
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
    let (mut closed, size) = (*q, filled::<M, N>(&reach(system, t, q, q)));
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
    // Gaps that are coordinates have no terms to which they could be compared. They are compared to
    // the coordinates instead.
    let lengths = filled::<M, N>(&reach(system, t, q, &lengths(q)));
    if widest(&system.terms(t, &closed, v), &lengths, is_closed).is_none() {
        *q = closed;
        return Ok(());
    }
    let terms = system.terms(t, q, v);
    let k = widest(&terms, &size, is_closed).unwrap_or_default();
    Err(StepFailure::Violated(Violation::of_gap(system.reaction_name(k), terms.gaps[k])))
}

/// True if two vectors differ by no more than the rounding of a third. NaN differs from everything.
fn is_same<S: Scalar, Q: StateVector<S>>(one: &Q, other: &Q, scale: &Q) -> bool {
    let rounding = CLOSED_GAP.part::<S>();
    let differences = one.as_ref().iter().zip(other.as_ref()).zip(scale.as_ref());
    differences.into_iter().all(|((a, b), scale)| a == b || (*a - *b).abs() <= rounding * scale.abs())
}

/// Finds the widest of these gaps that is not closed up to the rounding of these coordinates. NaN
/// is not closed.
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

/// Makes these rates zero. Velocities that are only rounding become zero as well, since each change
/// of their signs would be an event.
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

/// Computes the minimum energy needed to give these contacts their present rates.
pub(super) fn energy<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    is_held: [bool; K],
) -> S {
    let rules = is_held.map(|is_held| if is_held { Rule::Holds } else { Rule::Absent });
    let shares = Balance::of_values(terms, terms.rates).reactions(&rules);
    let twice = shares.iter().zip(&terms.rates).fold(S::ZERO, |sum, (share, rate)| sum - *share * *rate);
    S::from_f64(0.5) * twice.abs()
}

/// Opens gaps that are zero up to rounding by a few roundings, so that their events do not recur at
/// once. All are opened in one step while the closed ones are held, since opening one may close
/// another.
pub(super) fn part<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    terms: &Terms<M::Scalar, N, K>,
    q: &mut M::Coordinates,
    (are_touching, are_closed): ([bool; K], [bool; K]),
) where
    M: ContactSystem<N, K>,
{
    let size = filled::<M, N>(&reach(system, t, q, q));
    let slits: [M::Scalar; K] = array::from_fn(|k| SLIT.part::<M::Scalar>() * terms.size_of(k, &size));
    let is_parted: [bool; K] = array::from_fn(|k| are_touching[k] && terms.gaps[k] < slits[k]);
    if is_parted != [false; K] {
        let values =
            array::from_fn(|k| if is_parted[k] { terms.gaps[k] - slits[k] } else { M::Scalar::ZERO });
        displace(system, t, terms, q, values, array::from_fn(|k| is_parted[k] || are_closed[k]));
    }
}

/// Displaces positions along responses so that these gaps vanish where they are held.
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
    let responses = terms.responses.each_ref().map(|response| own(system, response));
    *q = displaced(system, t, q, shares.into_iter().zip(&responses));
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
