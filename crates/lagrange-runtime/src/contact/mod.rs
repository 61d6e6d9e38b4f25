//! Contacts that open and close, impacts, and dry friction that sticks and slips.
//!
//! An event `event floor = gap, falling => impact(e);` declares a unilateral contact,
//! `friction brake = slip, limit;` dry friction along the velocity `slip`. Each has a *reaction* r.
//! It is the normal force of the contact, along the gradient of the gap, or the friction force,
//! along the gradient of the slip velocity. Friction in a plane, `friction rub = (s1, s2), limit;`,
//! has two reactions, one along each slip velocity. The *mode* determines if they act, and by what
//! rule. Modes are public fields of the emitted type that events switch during a motion:
//!
//! | mode | reaction |
//! |---|---|
//! | contact open | r = 0 |
//! | contact closed | the gap stays zero; r ≥ 0, or else it opens |
//! | friction sticks | the slip velocity stays zero; \|r\| ≤ static limit, or else it slips |
//! | friction slips forwards, backwards | r = ∓ kinetic limit |
//! | friction in a plane sticks | both slip velocities stay zero; the length of r ≤ static limit |
//! | friction in a plane gives way | r = −kinetic limit · a/\|a\|, where a is the rate of s |
//! | friction in a plane slips | r = −kinetic limit · s/\|s\| (Coulomb's cone) |
//!
//! With all reactions zero the accelerations are a₀. A unit of reaction k adds w_k to them (with
//! all constraints satisfied), so a = a₀ + Σ w_k r_k. Velocity rows d_k give the rates d_k·a +
//! drift_k of gap velocities and slip velocities. Limits may depend on reactions and multipliers,
//! and are therefore affine in r. Emitted code computes these [`Terms`]; the small system for r is
//! solved at run time.
//!
//! # Assumptions
//!
//! - **Modes are determined together.** When a mode ends, all touching contacts and all friction at
//!   rest are determined anew. Contacts stay closed or separate, and friction sticks or slips in
//!   the direction of the load. If friction is so strong that no forces are consistent (Painlevé's
//!   paradox), the contact jams: an impact without approach stops its slip. A motion that would
//!   have to start in this state, or that remains inconsistent after a jam, ends with
//!   [`StepFailure::Painleve`].
//! - **Impacts on touching bodies are simultaneous.** Two equal touching balls that are hit
//!   elastically by a third leave with 2/3 of its speed, and it rebounds with 1/3. If they are
//!   slightly apart, they are hit one after the other, and the last one leaves with the full speed,
//!   as in Newton's cradle. The event of the first contact reports an impact in several contacts,
//!   with the impulse there and the total energy loss.
//! - **Friction acts in an impact** to the extent that its limit grows with contact forces, by the
//!   same law for impulses. Without restitution, impulses that obey it always exist. In a plane the
//!   search for them is bounded, and fails for one of a thousand random wedges. Restitution is
//!   reduced where it would create energy or where no solution would remain.
//! - **Infinitely many bounces** are summed once the remaining ones would take less than 10⁻⁹ of
//!   the time. This includes the bounces of several contacts that are hit in turn. The contacts
//!   close, and [`EventKind::Closed`] gives the time of the last bounce.
//! - **Statically indeterminate forces**, such as those of a table on four legs, are those of
//!   minimum norm. If these pull or exceed a limit, the nearest forces within all limits are used.
//!   Sticking ends if there are none.
//! - **Sliding on redundant points**: the laws determine neither the forces nor the motion. The
//!   consistent forces of minimum norm are used.
//! - **Friction in a plane changes its direction** by any angle while it slips. Slipping ends when
//!   its slip velocity reaches zero. Other friction that would stop within 10⁻⁹ of the time stops
//!   with it, and their modes are determined together.
//! - **Slipping in a plane starts along its acceleration.** Friction turns a slip velocity s
//!   towards its steady direction at the rate limit/(m |s|), which no explicit method follows near
//!   rest. Up to a speed of 10⁻⁶ of the terms of s, that direction is used instead.
//! - **Slipping in a plane that remains below half of that speed stops**, unless friction is about
//!   to stop it anyway. It restarts, along its acceleration, if friction cannot hold.
//! - **Friction with a limit of zero**, as in an open contact, is in the mode
//!   [`Slips`](Friction::Slips).
//! - **Time runs forwards**: the state before an impact or before a stop does not follow from the
//!   state after it.
//! - Smooth friction has no modes. Steep smooth friction makes the motion stiff.
//!
//! Sources: Pfeiffer, Glocker, *Multibody Dynamics with Unilateral Contacts*, §5, §8; Brogliato, *Nonsmooth
//! Mechanics*, 3rd ed., §5.

mod blame;
mod choice;
mod complementarity;
mod cone;
mod flatness;
mod forces;
mod guards;
mod heading;
mod impact;
mod initial_modes;
mod law;
mod lemke;
mod limits;
mod numbers;
mod pace;
mod padding;
mod project;
mod reaction_forces;
mod responses;
mod restitution;
mod resume;
mod rules;
mod slip;
mod step;
mod stepped;
#[cfg(test)]
mod tests;
mod transition;
mod turning;

pub use self::forces::reactions;
pub use self::guards::{event_values, switch_values};
pub use self::heading::Heading;
pub use self::initial_modes::begin;
pub use self::pace::Pace;
#[cfg(feature = "std")]
pub(crate) use self::padding::own;
pub use self::project::correct;
pub use self::responses::ForcedTerms;
pub use self::stepped::{ImpulseFormula, Stepped, SteppedStepper};
pub use self::transition::react;
pub use crate::system::{EventKind, Impact};

use core::ops::{Deref, DerefMut};

use crate::linalg::vector::add_scaled;
use crate::scalar::Scalar;
use crate::system::{MechanicalSystem, StepFailure};

/// The state of a unilateral contact: open or closed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub enum Contact {
    /// Bodies are apart: no force.
    #[default]
    Open,
    /// Bodies touch and stay in touch while the force presses them together.
    Closed,
}

/// The state of dry friction.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub enum Friction {
    /// Slips in the direction of the current slip velocity, without a force where it is zero. Runs
    /// replace it by another mode at their start, unless there is no friction because its limit is
    /// zero.
    #[default]
    Slips,
    /// Slips with positive slip velocity: the force is negative. In a plane, about the direction of
    /// the first slip velocity.
    SlipsForwards,
    /// Slips with negative slip velocity: the force is positive.
    SlipsBackwards,
    /// Slips in a plane, about this direction: the force is opposite to the slip velocity. Below
    /// half of this speed the slip velocity no longer has a direction, and slipping stops.
    SlipsTowards(Heading, Pace),
    /// Starts to slip in a plane. Below this speed the slip velocity has no direction yet: the
    /// force is opposite to the slip acceleration.
    GivesWay(Pace),
    /// Does not slip.
    Sticks,
}

/// The mode of a reaction.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Mode {
    /// A contact.
    Contact(Contact),
    /// A dry friction.
    Friction(Friction),
    /// The second component of the friction before it, which acts in a plane.
    Across(Friction),
    /// A smooth function of the slip velocity, r = −tanh(slip/width)·limit: its kinetic limit
    /// contains the hyperbolic tangent. It never changes its mode and has no event.
    Smooth,
}

/// The reaction terms of an emitted type with contacts or friction at one state, for N velocities
/// and K reactions in the order of declaration. References need not state the
/// number of slopes, as with arrays and slices.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Terms<S, const N: usize, const K: usize, L: ?Sized = [LimitSlope<S>]> {
    /// Accelerations with all reactions zero.
    pub free: [S; N],
    /// In row k the accelerations added by a unit of reaction k.
    pub responses: [[S; N]; K],
    /// In row k the gradient d_k of the rate of gap k, or of slip velocity k, with respect to the
    /// velocities.
    pub rows: [[S; N]; K],
    /// Gaps, positive where bodies are apart; zero for friction.
    pub gaps: [S; K],
    /// Rates of gaps; slip velocities.
    pub rates: [S; K],
    /// Rates of `rates` at zero acceleration.
    pub drifts: [S; K],
    /// Coefficients of restitution, for contacts.
    pub restitutions: [S; K],
    /// Kinetic limits with all reactions zero, for friction; in a plane for each component.
    pub kinetic: [S; K],
    /// Static limits with all reactions zero, for friction.
    pub fixed: [S; K],
    /// The growth of limits with reactions, in the order of the limits.
    pub slopes: L,
}

/// The growth of the limits of a friction with a reaction.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LimitSlope<S> {
    /// The reaction that is limited.
    pub limited: usize,
    /// The reaction that the limits depend on.
    pub reaction: usize,
    /// Slope of the kinetic limit.
    pub kinetic: S,
    /// Slope of the static limit.
    pub fixed: S,
}

/// A system with N velocities and K reactions: contacts and dry friction. Emitted types implement
/// it.
///
/// If these numbers are known at run time only, N and K are larger. Velocities and rows then end
/// with zeros, and further reactions are open contacts without rows and events, at a gap of one.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has neither rigid contacts nor dry friction",
    label = "this system has nothing for `Stepped` to solve",
    note = "declare a `contact` without stiffness, a `friction` or an event with `impact`; without them, `RungeKutta4` takes equal steps"
)]
pub trait ContactSystem<const N: usize, const K: usize>: MechanicalSystem + Sized {
    /// [`Terms`] with the number of slopes that the system has.
    type Terms: DerefMut<Target = Terms<Self::Scalar, N, K>>;

    /// Names of the reactions.
    const REACTIONS: [&'static str; K];

    /// The reason why the system is simulated by [`Stepped`] only: contacts of faces and edges,
    /// whose points jump. `None` for other systems.
    const NEEDS_STEPS: Option<&'static str> = None;

    /// True for each friction whose limit contains constraint forces, which press from either side:
    /// such a limit counts by its magnitude. Other limits must not be negative.
    const LIMITS_REVERSE: [bool; K] = [false; K];

    /// True for each contact whose gradient jumps, as the lowest point of a rim does where it lies
    /// flat. Steps also use the gradients at their ends.
    const GRADIENTS_JUMP: [bool; K] = [false; K];

    /// The modes, in the order of declaration.
    fn modes(&self) -> [Mode; K];

    /// Returns the system in other modes.
    #[must_use]
    fn in_modes(&self, modes: [Mode; K]) -> Self;

    /// Checks parameters with a declared range, and quantities of contacts that depend on
    /// parameters.
    ///
    /// # Errors
    /// If one is out of range.
    fn check(&self) -> Result<(), StepFailure<Self::Scalar>> {
        Ok(())
    }

    /// Returns the reaction terms at a state.
    fn terms(&self, t: Self::Scalar, q: &Self::Coordinates, v: &[Self::Scalar; N]) -> Self::Terms;

    /// Returns the reaction terms for a step of the length `h` by which velocities change, before
    /// they are divided by the inertia. Forces of the dissipation function are evaluated with the
    /// velocities at its end, so free accelerations and responses are means over the step. The
    /// default is [`terms`](Self::terms), which evaluates these forces with the velocities at the
    /// beginning.
    fn step_terms(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &[Self::Scalar; N],
        _h: Self::Scalar,
    ) -> ForcedTerms<Self::Terms, Self::Scalar, N> {
        ForcedTerms::complete(self.terms(t, q, v))
    }

    /// Returns the declared event at which reaction `k` changes its mode. There is none for smooth
    /// friction, nor for second components.
    fn event_of(&self, k: usize) -> Option<usize>;

    /// Returns the number of velocities.
    #[inline]
    fn velocities(&self) -> usize {
        N
    }

    /// Returns the name of reaction `k`, for systems without constant names.
    fn reaction_name(&self, k: usize) -> &'static str {
        Self::REACTIONS[k]
    }

    /// Returns [`NEEDS_STEPS`](Self::NEEDS_STEPS), for systems in which it is no constant.
    fn needs_steps(&self) -> Option<&'static str> {
        Self::NEEDS_STEPS
    }

    /// Returns an entry of [`LIMITS_REVERSE`](Self::LIMITS_REVERSE), for systems in which it is no
    /// constant.
    fn limit_reverses(&self, k: usize) -> bool {
        Self::LIMITS_REVERSE[k]
    }

    /// Returns an entry of [`GRADIENTS_JUMP`](Self::GRADIENTS_JUMP), for systems in which it is no
    /// constant.
    fn gradient_jumps(&self, k: usize) -> bool {
        Self::GRADIENTS_JUMP[k]
    }
}

impl<S: Scalar> LimitSlope<S> {
    /// True if a limit depends on the reaction.
    fn is_present(&self) -> bool {
        self.kinetic != S::ZERO || self.fixed != S::ZERO
    }
}

impl<S, const N: usize, const K: usize, const L: usize> Deref for Terms<S, N, K, [LimitSlope<S>; L]> {
    type Target = Terms<S, N, K>;

    #[inline]
    fn deref(&self) -> &Self::Target {
        self
    }
}

impl<S, const N: usize, const K: usize, const L: usize> DerefMut for Terms<S, N, K, [LimitSlope<S>; L]> {
    #[inline]
    fn deref_mut(&mut self) -> &mut Self::Target {
        self
    }
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Returns the slopes of the limits of friction k, in any order.
    fn slopes_of(&self, k: usize) -> impl Iterator<Item = &LimitSlope<S>> {
        self.slopes.iter().filter(move |slope| slope.limited == k)
    }

    /// Returns where the slopes of each limit begin and end.
    fn ranges_of_slopes(&self) -> [(usize, usize); K] {
        let (mut ranges, mut from) = ([(0, 0); K], 0);
        for (k, range) in ranges.iter_mut().enumerate() {
            let count = self.slopes[from..].iter().take_while(|slope| slope.limited == k).count();
            *range = (from, from + count);
            from += count;
        }
        ranges
    }

    /// Returns the accelerations with these reactions.
    pub fn acceleration(&self, reactions: &[S; K]) -> [S; N] {
        self.added(&self.free, reactions)
    }

    /// Returns the accelerations that these reactions add.
    fn change(&self, reactions: &[S; K]) -> [S; N] {
        self.added(&[S::ZERO; N], reactions)
    }

    /// Adds the responses to these reactions to a vector.
    fn added(&self, to: &[S; N], reactions: &[S; K]) -> [S; N] {
        let mut sum = *to;
        let acting = self.responses.iter().zip(reactions).filter(|(_, reaction)| **reaction != S::ZERO);
        acting.for_each(|(response, reaction)| add_scaled(&mut sum, *reaction, response));
        sum
    }
}
