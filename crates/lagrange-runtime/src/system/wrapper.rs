//! Systems that contain another system and change its equations.

use super::{
    Component, Description, Domain, EnergyFunction, MechanicalSystem, NamedSystem, OdeSystem, Reacted,
    StateMatrix, StateVector, Undefined, WhiteNoise, join, split,
};
use crate::scalar::Number;
use crate::system::{Action, DeclaredEvent, Response, StepFailure};

type InnerNumber<W> = <<W as Wrapper>::Inner as OdeSystem>::Scalar;
type InnerState<W> = <<W as Wrapper>::Inner as OdeSystem>::State;

/// A system that contains another one and has its own equations: with control, with losses, or with
/// additional unknowns.
///
/// Constraints, projection, events, contacts, friction, switches and noise are those of the inner
/// system. A type that contains a system and implements [`OdeSystem`] directly has none of them
/// unless it forwards each. Implementing this trait provides `OdeSystem`. If the state is that of
/// the inner system, it also provides [`MechanicalSystem`] and [`EnergyFunction`], provided that
/// the inner system has them. Accelerations are then those of [`outer_rhs`](Wrapper::outer_rhs),
/// and the energy is that of the inner system. Traits that describe the equations further, such as
/// [`CanonicalSystem`](super::CanonicalSystem), are not forwarded.
///
/// The state begins with that of the inner system, followed by additional components. These remain
/// unchanged when the inner system puts its state onto constraints or replaces it at events.
///
/// ```
/// use lagrange::Simulate;
/// use lagrange::system::{OdeSystem, Wrapper};
///
/// lagrange::system! {
///     /// A point mass on a rod, pushed by a force u.
///     #[derive(Clone, Debug)]
///     struct Rod;
///     coord x, y;
///     input u;
///     kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
///     potential = 9.81 * y;
///     force x = u;
///     constraint length = hypot(x, y) - 1;
///     event level = y, rising => stop;
/// }
///
/// /// The rod, pushed the way in which it moves.
/// struct Pushed(Rod);
///
/// impl Wrapper for Pushed {
///     type Inner = Rod;
///     type State = [f64; 4];
///
///     fn inner(&self) -> &Rod {
///         &self.0
///     }
///
///     fn around(&self, inner: Rod) -> Pushed {
///         Pushed(inner)
///     }
///
///     fn present<R>(&self, _: f64, y: &[f64; 4], ask: impl FnOnce(&Rod) -> R) -> R {
///         ask(&Rod { u: 2.0 * y[2].signum(), ..self.0.clone() })
///     }
///
///     fn outer_rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
///         self.present(t, y, |rod| rod.rhs(t, y))
///     }
/// }
///
/// // From rest below it swings higher and higher, on the rod all the time, and stops at the level.
/// let motion = Pushed(Rod::default()).simulate([0.0, -1.0, 1e-3, 0.0]).until(60.0).run()?;
/// let [x, y, ..] = motion.last();
/// assert!((x.hypot(y) - 1.0).abs() < 1e-14 && y.abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Wrapper: Sized {
    /// The inner system.
    type Inner: OdeSystem;
    /// The state of the inner system, or a longer vector that begins with it. If the length of the
    /// inner state is only known at run time, it must be that state.
    type State: StateVector<InnerNumber<Self>>;

    /// True if states are brought back onto the constraints of the inner system after steps.
    const IS_PROJECTED: bool = true;

    /// True if it sets the delayed signals of the inner system.
    const KEEPS_HISTORY: bool = false;

    /// Returns the inner system, in its present modes.
    fn inner(&self) -> &Self::Inner;

    /// Returns the wrapper around the inner system in other modes: with other contacts closed,
    /// other friction sticking, on other sides of its [switches](crate::event::Switches).
    #[must_use]
    fn around(&self, inner: Self::Inner) -> Self;

    /// Passes the inner system at this time and state to `ask`. The default is the result of
    /// [`inner`](Wrapper::inner). A wrapper that sets inputs sets the inputs of this time and
    /// state, and calls this method in [`outer_rhs`](Wrapper::outer_rhs). Events, contacts,
    /// friction, switches and the energy are computed through it. The argument of
    /// [`around`](Wrapper::around) may be a system obtained here, with these inputs.
    #[inline]
    fn present<R>(&self, _t: InnerNumber<Self>, _y: &Self::State, ask: impl FnOnce(&Self::Inner) -> R) -> R {
        ask(self.inner())
    }

    /// Computes the right-hand side f(t, y) of ẏ = f(t, y).
    ///
    /// If the inner system has constraints, accelerations must satisfy them; the inner system
    /// ensures this under other inputs and parameters, too.
    fn outer_rhs(&self, t: InnerNumber<Self>, y: &Self::State) -> Self::State;

    /// Computes ∂f/∂y in rows, if it is available. If the equations differ from those of the inner
    /// system, so does the Jacobian.
    #[inline]
    fn outer_jacobian(
        &self,
        _t: InnerNumber<Self>,
        _y: &Self::State,
    ) -> Option<<Self::State as StateVector<InnerNumber<Self>>>::Square> {
        None
    }

    /// Returns the first time after `t` at which a step must end because of the wrapper, in
    /// addition to those of the inner system.
    #[inline]
    fn further_restart(&self, _t: InnerNumber<Self>) -> Option<InnerNumber<Self>> {
        None
    }
}

impl<W: Wrapper> OdeSystem for W {
    type Scalar = InnerNumber<W>;
    type State = W::State;

    #[inline]
    fn rhs(&self, t: InnerNumber<W>, y: &W::State) -> W::State {
        self.outer_rhs(t, y)
    }

    fn undefined(
        &self,
        t: InnerNumber<W>,
        y: &W::State,
        rates: &W::State,
    ) -> Option<Undefined<InnerNumber<W>>> {
        let inside = part::<W>(y);
        let own = Undefined::of_state(t, y.as_ref(), rates.as_ref(), Component::Index)?;
        if let Undefined::State { component: Component::Index(index), .. } = own
            && index >= inside.as_ref().len()
        {
            return Some(own);
        }
        self.present(t, y, |inner| inner.undefined(t, &inside, &part::<W>(rates))).or(Some(own))
    }

    #[inline]
    fn domain(&self) -> &'static Domain {
        self.inner().domain()
    }

    #[inline]
    fn noise(&self) -> WhiteNoise {
        self.inner().noise()
    }

    #[inline]
    fn diffuse(&self, t: InnerNumber<W>, y: &W::State, increments: &[InnerNumber<W>]) -> W::State {
        let change = self.present(t, y, |inner| inner.diffuse(t, &part::<W>(y), increments));
        replaced::<W>(&y.zeros(), &change)
    }

    #[inline]
    fn jacobian(&self, t: InnerNumber<W>, y: &W::State) -> Option<StateMatrix<W>> {
        self.outer_jacobian(t, y)
    }

    #[inline]
    fn next_restart(&self, t: InnerNumber<W>, end: InnerNumber<W>) -> Option<InnerNumber<W>> {
        let (inner, further) = (self.inner().next_restart(t, end), self.further_restart(t));
        match (inner, further) {
            (Some(inner), Some(further)) if (further - t).abs() < (inner - t).abs() => Some(further),
            (inner, further) => inner.or(further),
        }
    }

    fn beyond(&self, t: InnerNumber<W>, end: InnerNumber<W>) -> Option<W> {
        self.inner().beyond(t, end).map(|inner| self.around(inner))
    }

    #[inline]
    fn tick(&self, t: InnerNumber<W>, y: &W::State) -> Option<W::State> {
        let after = self.present(t, y, |inner| inner.tick(t, &part::<W>(y)))?;
        Some(replaced::<W>(y, &after))
    }

    #[inline]
    fn is_tick(&self, t: InnerNumber<W>) -> bool {
        self.inner().is_tick(t)
    }

    #[inline]
    fn shortest_period(&self) -> Option<InnerNumber<W>> {
        self.inner().shortest_period()
    }

    const IS_CONSTRAINED: bool = W::IS_PROJECTED && W::Inner::IS_CONSTRAINED;

    #[inline]
    fn correct(&self, t: InnerNumber<W>, y: &mut W::State) -> Result<(), StepFailure<InnerNumber<W>>> {
        if W::IS_PROJECTED { change(self, t, y, |inner, part| inner.correct(t, part)) } else { Ok(()) }
    }

    #[inline]
    fn admit(&self, t: InnerNumber<W>, y: &mut W::State) -> Result<(), StepFailure<InnerNumber<W>>> {
        change(self, t, y, |inner, part| inner.admit(t, part))
    }

    #[inline]
    fn restore(&self, t: InnerNumber<W>, y: &mut W::State) -> Result<(), StepFailure<InnerNumber<W>>> {
        change(self, t, y, |inner, part| inner.restore(t, part))
    }

    #[inline]
    fn is_constrained(&self) -> bool {
        W::IS_PROJECTED && self.inner().is_constrained()
    }

    const HAS_DELAYS: bool = W::Inner::HAS_DELAYS && !W::KEEPS_HISTORY;

    #[inline]
    fn has_delays(&self) -> bool {
        !W::KEEPS_HISTORY && self.inner().has_delays()
    }

    const EVENTS: &'static [DeclaredEvent] = W::Inner::EVENTS;
    const MAX_EVENTS: usize = W::Inner::MAX_EVENTS;

    #[inline]
    fn events(&self) -> &'static [DeclaredEvent] {
        self.inner().events()
    }

    #[inline]
    fn event_values(&self, t: InnerNumber<W>, y: &W::State, values: &mut [InnerNumber<W>]) {
        self.present(t, y, |inner| inner.event_values(t, &part::<W>(y), values));
    }

    fn react(&self, event: usize, t: InnerNumber<W>, elapsed: InnerNumber<W>, y: &W::State) -> Reacted<W> {
        let answer = self.present(t, y, |inner| inner.react(event, t, elapsed, &part::<W>(y)));
        let Response { action, system, kind } = answer?;
        let action = match action {
            Action::Continue => Action::Continue,
            Action::Stop => Action::Stop,
            Action::Replace(part) => Action::Replace(replaced::<W>(y, &part)),
        };
        Ok(Response { action, system: system.map(|inner| self.around(inner)), kind })
    }

    fn begin(&self, t: InnerNumber<W>, y: &W::State) -> Result<Option<W>, StepFailure<InnerNumber<W>>> {
        let begun = self.present(t, y, |inner| inner.begin(t, &part::<W>(y)))?;
        Ok(begun.map(|inner| self.around(inner)))
    }

    fn on_sides(&self, t: InnerNumber<W>, y: &W::State) -> Option<W> {
        self.present(t, y, |inner| inner.on_sides(t, &part::<W>(y))).map(|inner| self.around(inner))
    }

    fn freed(&self) -> Option<W> {
        self.inner().freed().map(|inner| self.around(inner))
    }
}

impl<W, M> MechanicalSystem for W
where
    W: Wrapper<Inner = M, State = <M as OdeSystem>::State>,
    M: MechanicalSystem,
{
    type Coordinates = M::Coordinates;
    type Velocities = M::Velocities;
    type Columns<C> = M::Columns<C>;

    const COORDINATES: &'static [&'static str] = M::COORDINATES;
    const VELOCITIES: &'static [&'static str] = M::VELOCITIES;
    const RATES_OF: &'static [&'static str] = M::RATES_OF;
    const FIRST_ORDER_STATES: usize = M::FIRST_ORDER_STATES;
    const UNITS: &'static [(&'static str, &'static str)] = M::UNITS;
    const FINGERPRINT: u64 = M::FINGERPRINT;

    #[inline]
    fn description(&self) -> &'static Description {
        self.inner().description()
    }

    #[inline]
    fn acceleration(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Velocities {
        let (_, accelerations) = split::<M>(&self.outer_rhs(t, &join::<M>(q, v)));
        accelerations
    }

    #[inline]
    fn position_rates(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Coordinates {
        let (rates, _) = split::<M>(&self.outer_rhs(t, &join::<M>(q, v)));
        rates
    }

    #[inline]
    fn position_change(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Coordinates {
        self.inner().position_change(t, q, v)
    }

    #[inline]
    fn normalise(q: &mut M::Coordinates) {
        M::normalise(q);
    }

    #[inline]
    fn displacement(&self, t: M::Scalar, from: &M::Coordinates, to: &M::Coordinates) -> M::Velocities {
        self.inner().displacement(t, from, to)
    }

    fn parameter(&self, index: usize) -> Option<(&'static str, M::Scalar)> {
        self.inner().parameter(index)
    }
}

impl<W, M> EnergyFunction for W
where
    W: Wrapper<Inner = M, State = <M as OdeSystem>::State>,
    M: EnergyFunction,
{
    #[inline]
    fn energy(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Scalar {
        self.present(t, &join::<M>(q, v), |inner| inner.energy(t, q, v))
    }
}

/// A wrapper has the same state as its inner system.
impl<W, M> NamedSystem for W
where
    W: Wrapper<Inner = M, State = <M as OdeSystem>::State>,
    M: NamedSystem,
{
    type NamedState = M::NamedState;
}

/// Returns the state of the inner system.
#[inline]
fn part<W: Wrapper>(y: &W::State) -> InnerState<W> {
    const { assert!(size_of::<InnerState<W>>() <= size_of::<W::State>(), "the state is shorter than that inside") };
    // Two parts if the vector stores its division; otherwise the first one is empty.
    let (first, others) = y.parts(0);
    let count = InnerState::<W>::ZERO.as_ref().len().min(y.as_ref().len());
    InnerState::<W>::joined(first, &others[..count - first.len()])
}

/// Returns the state with this part for the inner system.
#[inline]
fn replaced<W: Wrapper>(y: &W::State, part: &InnerState<W>) -> W::State {
    let mut y = *y;
    let part = part.as_ref();
    y.as_mut()[..part.len()].copy_from_slice(part);
    y
}

/// Changes the state of the inner system, if this succeeds.
#[inline]
fn change<W: Wrapper>(
    wrapper: &W,
    t: InnerNumber<W>,
    y: &mut W::State,
    change: impl FnOnce(&W::Inner, &mut InnerState<W>) -> Result<(), StepFailure<InnerNumber<W>>>,
) -> Result<(), StepFailure<InnerNumber<W>>> {
    let mut part = part::<W>(y);
    wrapper.present(t, y, |inner| change(inner, &mut part))?;
    *y = replaced::<W>(y, &part);
    Ok(())
}
