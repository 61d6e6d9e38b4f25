//! Back onto closed contacts: gaps to zero, and the velocities that contacts and sticking friction hold.

use core::array;

use super::initial_modes::{holds, lengths};
use super::reaction_forces::{Balance, Rule};
use super::{Contact, ContactSystem, Mode, Terms};
use crate::scalar::Scalar;
use crate::system::{StepFailure, Violation, join, split};
use crate::tolerance::{CLOSED_GAP, SLIT};

/// Gaps are brought to zero in so many rounds or not at all. Errors are squared in each.
const MOST_ROUNDS: u32 = 12;

/// Brings a state onto the closed contacts and sticking friction: gaps to zero by the smallest change of the coordinates that the
/// mechanism allows, measured by the mass matrix, and then their rates and slip velocities by the smallest change of the
/// velocities. Constraints keep holding to first order in the change.
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
    if is_held == [false; K] {
        return Ok(());
    }
    let (mut q, mut v) = split::<M>(y);
    close(system, t, &mut q, &v, modes.map(|mode| mode == Mode::Contact(Contact::Closed)))?;
    halt(&system.terms(t, &q, &v), &mut v, is_held);
    if q.iter().chain(&v).any(|entry| !entry.is_finite()) {
        return Err(StepFailure::NotFinite);
    }
    *y = join::<M>(&q, &v);
    Ok(())
}

/// Brings these gaps to zero.
pub(super) fn close<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    q: &mut [M::Scalar; N],
    v: &[M::Scalar; N],
    is_closed: [bool; K],
) -> Result<(), StepFailure<M::Scalar>>
where
    M: ContactSystem<N, K>,
{
    if is_closed == [false; K] {
        return Ok(());
    }
    let mut closed = *q;
    for _ in 0..MOST_ROUNDS {
        let terms = system.terms(t, &closed, v);
        let before = closed;
        if widest(&terms, q, is_closed).is_some() {
            change(&terms, &mut closed, terms.gaps, is_closed);
        }
        if is_same(&before, &closed, q) {
            *q = closed;
            return Ok(());
        }
    }
    // Gaps that are coordinates have no terms beside which they could be small: what counts is then the size of the coordinates.
    if widest(&system.terms(t, &closed, v), &lengths(q), is_closed).is_none() {
        *q = closed;
        return Ok(());
    }
    let terms = system.terms(t, q, v);
    let k = widest(&terms, q, is_closed).unwrap_or_default();
    Err(StepFailure::Violated(Violation::of_gap(M::REACTIONS[k], terms.gaps[k])))
}

/// Whether two vectors differ by no more than the rounding of a third. One that is not a number differs from every other.
fn is_same<S: Scalar, const N: usize>(one: &[S; N], other: &[S; N], scale: &[S; N]) -> bool {
    let rounding = CLOSED_GAP.part::<S>();
    let differences = one.iter().zip(other).zip(scale);
    differences.into_iter().all(|((a, b), scale)| a == b || (*a - *b).abs() <= rounding * scale.abs())
}

/// The widest of these gaps that is not closed but for the rounding of these coordinates; one that is not a number is not.
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

/// Brings these rates to zero.
pub(super) fn halt<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    v: &mut [S; N],
    is_held: [bool; K],
) {
    change(terms, v, terms.rates, is_held);
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

/// Opens gaps that are zero but for rounding by a few roundings, so that they are not found closed again at once;
/// together, and with those closed that are, since to open one may close another.
pub(super) fn part<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    q: &mut [S; N],
    are_touching: [bool; K],
    are_closed: [bool; K],
) {
    let slits: [S; K] = array::from_fn(|k| SLIT.part::<S>() * terms.size_of(k, q));
    let is_parted: [bool; K] = array::from_fn(|k| are_touching[k] && terms.gaps[k] < slits[k]);
    if is_parted != [false; K] {
        let values = array::from_fn(|k| if is_parted[k] { terms.gaps[k] - slits[k] } else { S::ZERO });
        change(terms, q, values, array::from_fn(|k| is_parted[k] || are_closed[k]));
    }
}

/// Adds responses so that these values are taken away where they are held.
fn change<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    x: &mut [S; N],
    values: [S; K],
    is_held: [bool; K],
) {
    let rules = is_held.map(|is_held| if is_held { Rule::Holds } else { Rule::Absent });
    let shares = Balance::of_values(terms, values).reactions(&rules);
    *x = terms.added(x, &shares);
}
