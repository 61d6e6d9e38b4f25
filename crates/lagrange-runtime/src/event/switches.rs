//! Switches: surfaces in time and state on which a system is not smooth, and the sides of them on
//! which it is computed.
//!
//! They are the boundaries of `if` conditions in a declaration, and the kinks of `abs`, `sign`,
//! `min` and `max`. A step across one would lose the order of any method, and would miss a push
//! that is shorter than a step. A run therefore fixes the side of every switch: the equations are
//! then smooth, and continue smoothly beyond the surface. If a step leads beyond the surface, the
//! crossing is located like an event and the motion continues from there on the other side. Source:
//! Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., §II.6.
//!
//! At the end of a step that was computed for x > 0, let x = −10⁻⁹. The force −sign(x) was −1
//! throughout the step. The step is cut at x = 0, and the next one has the force 1. If that leads
//! back at once, as −sign(ẋ) does with ẋ = 0, the state would slide along the surface. A function
//! of time and state does not determine the force there:
//! [`StepFailure::Slides`](crate::integrate::StepFailure::Slides).

use core::array::from_fn;

use crate::system::{Action, MAX_LOCATED, OdeSystem, Reacted, Response};

use crate::scalar::{Number, Scalar};

/// The sides of its switches on which a system is computed: fixed, as during a run, or free, as its
/// state determines.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Debug)]
pub struct Switches {
    /// The switches whose sides are fixed.
    fixed: Bits,
    /// Fixed switches that are on their positive sides.
    positive: Bits,
}

/// A bit for each switch.
type Bits = [u64; MAX_LOCATED / 64];

fn has_bit(bits: &Bits, k: usize) -> bool {
    bits[k / 64] >> (k % 64) & 1 != 0
}

fn set_bit(bits: &mut Bits, k: usize, value: bool) {
    let bit = 1 << (k % 64);
    if value { bits[k / 64] |= bit } else { bits[k / 64] &= !bit }
}

impl Switches {
    /// All switches free.
    pub const FREE: Switches = Switches { fixed: [0; MAX_LOCATED / 64], positive: [0; MAX_LOCATED / 64] };

    /// Returns the side of each switch, 1 or −1: the fixed one, or the sign of its value.
    #[inline]
    pub fn signs<S: Scalar, const K: usize>(self, values: impl FnOnce() -> [S; K]) -> [S; K] {
        if (0..K).all(|k| self.is_fixed(k)) {
            return from_fn(|k| self.sign(k));
        }
        let values = values();
        from_fn(|k| if self.is_fixed(k) { self.sign(k) } else { values[k].sign() })
    }

    /// Returns the side of the k-th switch as a sign, if it is fixed.
    #[must_use]
    pub fn side<S: Scalar>(self, k: usize) -> Option<S> {
        self.is_fixed(k).then(|| self.sign(k))
    }

    fn is_fixed(&self, k: usize) -> bool {
        has_bit(&self.fixed, k)
    }

    fn sign<S: Scalar>(&self, k: usize) -> S {
        if has_bit(&self.positive, k) { S::ONE } else { -S::ONE }
    }

    /// Fixes the side of this switch.
    fn with(mut self, k: usize, is_positive: bool) -> Self {
        set_bit(&mut self.fixed, k, true);
        set_bit(&mut self.positive, k, is_positive);
        self
    }
}

/// A system with switches. Their events are the last of its declared events. Emitted types
/// implement it.
pub trait SwitchedSystem: OdeSystem + Sized {
    /// The index of the first of them among the declared events.
    const FIRST: usize;

    /// Returns the index of the first of their events in this system. It is
    /// [`FIRST`](Self::FIRST) unless the system was read at run time.
    fn first(&self) -> usize {
        Self::FIRST
    }

    /// Returns the sides on which it is computed.
    fn switches(&self) -> Switches;

    /// Returns the system on other sides.
    #[must_use]
    fn with_switches(&self, switches: Switches) -> Self;

    /// Computes the functions that vanish on the switches and writes them to `values`, which has an
    /// entry for each switch.
    fn switch_values(&self, t: Self::Scalar, y: &Self::State, values: &mut [Self::Scalar]);

    /// Returns the time at which each switch is passed from its negative to its positive side, or
    /// `None` if it is unknown in advance. Switches after the last known time may be left out.
    fn switch_times(&self) -> impl Iterator<Item = Option<Self::Scalar>> {
        core::iter::empty()
    }
}

/// Returns the system on the sides on which a motion from this state starts. Switches whose values
/// are not finite stay free.
pub fn choose_sides<M: SwitchedSystem>(system: &M, t: M::Scalar, y: &M::State) -> Option<M> {
    let mut room = [M::Scalar::ZERO; MAX_LOCATED];
    let values = &mut room[..switch_count(system)];
    system.switch_values(t, y, values);
    let fix = |switches: Switches, (k, value): (usize, &M::Scalar)| match value.is_finite() {
        true => switches.with(k, *value >= M::Scalar::ZERO),
        false => switches,
    };
    Some(system.with_switches(values.iter().enumerate().fold(Switches::FREE, fix)))
}

/// Returns the system with its switches free.
pub fn free_sides<M: SwitchedSystem>(system: &M) -> M {
    system.with_switches(Switches::FREE)
}

/// Writes the values of the events by which sides change, positive on the present sides.
pub fn side_values<M: SwitchedSystem>(system: &M, t: M::Scalar, y: &M::State, values: &mut [M::Scalar]) {
    let (one, switches) = (M::Scalar::ONE, system.switches());
    let values = &mut values[system.first()..][..switch_count(system)];
    system.switch_values(t, y, values);
    for (k, value) in values.iter_mut().enumerate() {
        *value = match (value.is_finite(), switches.is_fixed(k)) {
            (true, true) => switches.sign::<M::Scalar>(k) * *value,
            // It now has a side.
            (true, false) => -one,
            // An undefined value either does not matter or makes the rates undefined.
            (false, _) => one,
        };
    }
}

/// Responds to a declared event that belongs to no reaction: a side changes, or the motion
/// continues.
///
/// # Errors
/// Never.
pub fn change_side<M: SwitchedSystem>(system: &M, event: usize, t: M::Scalar, y: &M::State) -> Reacted<M> {
    let Some(k) = event.checked_sub(system.first()) else { return Ok(Response::new(Action::Continue)) };
    let switches = system.switches();
    let is_positive = match switches.is_fixed(k) {
        true => !has_bit(&switches.positive, k),
        false => {
            let mut values = [M::Scalar::ZERO; MAX_LOCATED];
            system.switch_values(t, y, &mut values[..switch_count(system)]);
            values[k] >= M::Scalar::ZERO
        }
    };
    let system = Some(system.with_switches(switches.with(k, is_positive)));
    Ok(Response { system, ..Response::new(Action::Continue) })
}

/// Returns the system on the sides from `t` towards `end`, if a switch is passed at the time `t`.
pub fn beyond<M: SwitchedSystem>(system: &M, t: M::Scalar, end: M::Scalar) -> Option<M> {
    let passed = system.switch_times().enumerate().filter(|(_, time)| *time == Some(t));
    let before = system.switches();
    let after = passed.fold(before, |switches, (k, _)| switches.with(k, end > t));
    (after != before).then(|| system.with_switches(after))
}

/// Returns the next time after `t` and before `end`, which may lie before it, at which a switch is
/// known to be passed.
pub fn next_switch_time<M: SwitchedSystem>(system: &M, t: M::Scalar, end: M::Scalar) -> Option<M::Scalar> {
    let is_ahead =
        |time: &M::Scalar| if end < t { *time < t && *time > end } else { *time > t && *time < end };
    let ahead = system.switch_times().flatten().filter(is_ahead);
    ahead.reduce(|one, other| if (other - t).abs() < (one - t).abs() { other } else { one })
}

fn switch_count<M: SwitchedSystem>(system: &M) -> usize {
    system.events().len().saturating_sub(system.first()).min(MAX_LOCATED)
}
