//! Traits that emitted types implement, so that integrators and adapters accept any of them.
//!
//! The traits contain the members of a system that algorithms need; all others are inherent methods
//! of its type. Nothing here derives or integrates.

mod canonical;
mod constraint_values;
mod delayed;
mod description;
mod domain;
mod event;
mod kernel;
mod lagrangian;
mod lanes;
mod linearised;
mod mechanical;
mod message;
mod noise;
mod out_of_range;
mod parametric;
mod ports;
mod positions;
pub mod quaternion;
mod rate_name;
mod regressor;
mod setting_error;
mod step_failure;
mod taylor;
mod undefined;
mod violation;
mod wrapper;

pub use self::canonical::{CanonicalSystem, LeapfrogSystem, SeparableSystem};
pub use self::constraint_values::ConstraintValues;
pub use self::delayed::{DelayedSystem, check_delays};
pub use self::description::Description;
pub use self::domain::{Domain, EntryRange};
pub use self::event::{Action, DeclaredEvent, Direction, EventKind, Impact, MAX_LOCATED, Response};
pub(crate) use self::event::{have_modes, values_of_events};
pub use self::kernel::KernelSystem;
pub use self::lagrangian::LagrangianSystem;
pub use self::lanes::{Equations, LanesSystem, LanesVisitor, SideBySide};
pub use self::linearised::{LinearisedSystem, MatrixLayout};
#[cfg(any(feature = "ensemble", feature = "linear"))]
#[cfg(all(feature = "ensemble", any(feature = "parquet", feature = "plot")))]
pub(crate) use self::mechanical::description_of_type;
pub use self::mechanical::{Columns, EnergyFunction, MechanicalSystem, NamedSystem, Unnamed};
#[cfg(feature = "std")]
pub(crate) use self::message::{EventName, explain};
pub use self::noise::{MAX_NOISES, NoiseKind, WhiteNoise};
pub use self::out_of_range::{OutOfRange, RangedKind};
pub use self::parametric::{ParametricSystem, pick_columns};
pub use self::ports::{ControlledSystem, OutputSystem};
pub(crate) use self::positions::normalised;
pub(crate) use self::positions::{displaced, normalise_positions, reach};
pub use self::positions::{join, normalise, normalise_described, split};
#[cfg(feature = "std")]
pub(crate) use self::rate_name::{WithSuffix, split_indices};
pub use self::regressor::RegressorSystem;
pub use self::setting_error::SettingError;
pub use self::step_failure::{DelayFault, EventSource, StepFailure};
#[cfg(feature = "std")]
pub use self::taylor::StoredProducts;
pub use self::taylor::{
    MAX_ORDER, Order, Products, SeriesFactors, SeriesSolver, TaylorSystem, negative_inverse,
    negative_inverse_of_definite,
};
#[cfg(feature = "linear")]
pub(crate) use self::undefined::Acceleration;
pub use self::undefined::{Component, Undefined};
pub use self::violation::{Violated, Violation};
pub use self::wrapper::Wrapper;
pub use crate::linalg::vector::StateVector;

use crate::scalar::Scalar;

/// The scalar type of a system.
pub(crate) type ScalarOf<M> = <M as OdeSystem>::Scalar;

/// Positions of a system.
pub(crate) type Positions<M> = <M as MechanicalSystem>::Coordinates;

/// Velocities of a system, or displacements of the same length.
pub(crate) type Velocities<M> = <M as MechanicalSystem>::Velocities;

/// Coordinates of a system whose velocities are their rates, or velocities or momenta of the same
/// length.
pub(crate) type Vector<M> = <M as MechanicalSystem>::Coordinates;

/// The state of a system.
pub(crate) type State<M> = <M as OdeSystem>::State;

/// The square matrix, in rows, with the dimension of a system's state.
pub type StateMatrix<M> = <<M as OdeSystem>::State as StateVector<<M as OdeSystem>::Scalar>>::Square;

/// The square matrix, in rows, with the dimension of a system's velocities, such as its mass
/// matrix.
pub type VelocityMatrix<M> =
    <<M as MechanicalSystem>::Velocities as StateVector<<M as OdeSystem>::Scalar>>::Square;

/// A system of ordinary differential equations of first order, ẏ = f(t, y).
///
/// ```
/// use lagrange::system::OdeSystem;
///
/// /// ẏ = −λ y
/// struct Decay {
///     rate: f64,
/// }
///
/// impl OdeSystem for Decay {
///     type Scalar = f64;
///     type State = [f64; 1];
///
///     fn rhs(&self, _t: f64, y: &[f64; 1]) -> [f64; 1] {
///         [-self.rate * y[0]]
///     }
/// }
///
/// assert_eq!(Decay { rate: 2.0 }.rhs(0.0, &[3.0]), [-6.0]);
/// ```
///
/// All members but [`rhs`](Self::rhs) have defaults for a system that consists of its equations
/// alone. A type that contains another system implements [`Wrapper`] instead, which keeps the
/// constraints and events of the inner system.
pub trait OdeSystem {
    /// The number type.
    type Scalar: Scalar;
    /// The state y; for a mechanical system `[q…, v…]`, positions first.
    type State: StateVector<Self::Scalar>;

    /// Computes the right-hand side f(t, y): the time derivative of the state `y` at time `t`.
    ///
    /// The result is not finite where f is undefined.
    fn rhs(&self, t: Self::Scalar, y: &Self::State) -> Self::State;

    /// Returns the first component of the state `y` and of its `rates` at time `t` that is not
    /// finite, or its cause, by name. Runs call this when they cannot continue. Handwritten systems
    /// identify components by index only.
    #[inline]
    fn undefined(
        &self,
        t: Self::Scalar,
        y: &Self::State,
        rates: &Self::State,
    ) -> Option<Undefined<Self::Scalar>> {
        Undefined::of_state(t, y.as_ref(), rates.as_ref(), Component::Index)
    }

    /// Returns the declared ranges and nominal values of the entries of the state. Runs end where
    /// an entry leaves its range. Adaptive methods scale the absolute tolerance of an entry by its
    /// nominal value.
    #[inline]
    fn domain(&self) -> &'static Domain {
        &Domain::EVERYWHERE
    }

    /// Returns the number of white noises that act on the system, and the kind of their action.
    /// Without noise, the default, every method of integration accepts it. With noise, only
    /// [stochastic methods](crate::integrate::EulerMaruyama) do.
    #[inline]
    fn noise(&self) -> WhiteNoise {
        WhiteNoise::NONE
    }

    /// Computes Σ gₖ(t, y) ΔWₖ for increments ΔWₖ of independent Wiener processes, one for each
    /// noise. The equations are dy = f(t, y) dt + Σ gₖ(t, y) ∘ dWₖ, in the sense of Stratonovich.
    /// Without noise, [`rhs`](Self::rhs), f, remains.
    #[inline]
    fn diffuse(&self, _t: Self::Scalar, y: &Self::State, _increments: &[Self::Scalar]) -> Self::State {
        y.zeros()
    }

    /// Computes ∂f/∂y in rows, with ∂fᵢ/∂yⱼ as entry i, j, if it is available. Emitted types
    /// provide it if the declaration has `emit { jacobian }`. Implicit methods use it in Newton's
    /// method. If it is not available, difference quotients replace it; methods with equal steps
    /// try fixed-point iteration first.
    #[inline]
    fn jacobian(&self, _t: Self::Scalar, _y: &Self::State) -> Option<StateMatrix<Self>> {
        None
    }

    /// Calls a visitor if the equations of the system can be evaluated in lanes, as for a
    /// [`LanesSystem`].
    ///
    /// # Errors
    /// Returns the visitor if they cannot.
    #[inline]
    fn with_lanes<V: LanesVisitor<Self>>(visitor: V) -> Result<V::Output, V>
    where
        Self: Sized,
    {
        Err(visitor)
    }

    /// Returns the first time after `t` on the way to `end` at which the right-hand side is known
    /// to jump or not to be smooth. Runs end a step there and start another one; neither evaluates
    /// at exactly that time. `end` may precede `t`; only a time between the two counts.
    #[inline]
    fn next_restart(&self, _t: Self::Scalar, _end: Self::Scalar) -> Option<Self::Scalar> {
        None
    }

    /// Returns the system that continues from a time returned by
    /// [`next_restart`](Self::next_restart) towards `end`; `None` if it is the same.
    #[inline]
    fn beyond(&self, _t: Self::Scalar, _end: Self::Scalar) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Returns the state after the clocks of the declaration that tick at this time; `None` if none
    /// of them does. Such times are among those of [`next_restart`](Self::next_restart).
    #[inline]
    fn tick(&self, _t: Self::Scalar, _y: &Self::State) -> Option<Self::State> {
        None
    }

    /// True if a clock of the declaration ticks at this time.
    #[inline]
    fn is_tick(&self, _t: Self::Scalar) -> bool {
        false
    }

    /// Returns the shortest period of its clocks, if there are any.
    #[inline]
    fn shortest_period(&self) -> Option<Self::Scalar> {
        None
    }

    /// True if inputs are delayed signals, whose values only [`DelayedSystem`] provides. Runs
    /// without a history reject such a system.
    const HAS_DELAYS: bool = false;

    /// True if inputs of this system are delayed signals. The default is
    /// [`HAS_DELAYS`](Self::HAS_DELAYS); systems that were read at run time may differ.
    #[inline]
    fn has_delays(&self) -> bool {
        Self::HAS_DELAYS
    }

    /// True if states must satisfy conditions in addition to the equations, which
    /// [`correct`](Self::correct) enforces: constraints, or the unit length of quaternions.
    const IS_CONSTRAINED: bool = false;

    /// True if states of this system must satisfy conditions in addition to the equations. The
    /// default is [`IS_CONSTRAINED`](Self::IS_CONSTRAINED); systems that were read at run time may
    /// differ.
    #[inline]
    fn is_constrained(&self) -> bool {
        Self::IS_CONSTRAINED
    }

    /// Brings a state onto the constraints. Methods call this after every accepted step, and before
    /// they return a state within a step.
    ///
    /// # Errors
    /// If that is not possible; the state is then unchanged.
    #[inline]
    fn correct(&self, _t: Self::Scalar, _y: &mut Self::State) -> Result<(), StepFailure<Self::Scalar>> {
        Ok(())
    }

    /// Brings a state onto the constraints if it nearly satisfies them. Motions start from this
    /// state, or continue from it after a replacement: methods call this before their first step.
    ///
    /// # Errors
    /// If it does not satisfy them; the state is then unchanged.
    #[inline]
    fn admit(&self, t: Self::Scalar, y: &mut Self::State) -> Result<(), StepFailure<Self::Scalar>> {
        self.correct(t, y)
    }

    /// Brings a state that an event set onto the constraints, from any distance.
    ///
    /// # Errors
    /// If that is not possible; the state is then unchanged.
    #[inline]
    fn restore(&self, t: Self::Scalar, y: &mut Self::State) -> Result<(), StepFailure<Self::Scalar>> {
        self.correct(t, y)
    }

    /// The events of the declaration, at most [`MAX_LOCATED`]. Runs locate them by default.
    const EVENTS: &'static [DeclaredEvent] = &[];

    /// The number of events for which runs reserve memory. A type that overrides
    /// [`events`](Self::events) states it; runs refuse systems with more events.
    const MAX_EVENTS: usize = Self::EVENTS.len();

    /// Returns the events of this system. They are [`EVENTS`](Self::EVENTS) unless the system was
    /// read at run time.
    #[inline]
    fn events(&self) -> &'static [DeclaredEvent] {
        Self::EVENTS
    }

    /// Computes the functions of all declared events and writes them to `values`, which has the
    /// same length.
    #[inline]
    fn event_values(&self, _t: Self::Scalar, _y: &Self::State, _values: &mut [Self::Scalar]) {}

    /// Responds to the declared event of this index at the state `y` and the time `t`. The run
    /// started a duration of `elapsed` earlier. Durations that are negligible relative to `elapsed`
    /// need not be resolved, independent of the origin of time.
    ///
    /// # Errors
    /// If the motion cannot continue.
    #[inline]
    fn react(
        &self,
        _event: usize,
        _t: Self::Scalar,
        _elapsed: Self::Scalar,
        _y: &Self::State,
    ) -> Reacted<Self>
    where
        Self: Sized,
    {
        Ok(Response::new(Action::Continue))
    }

    /// Returns the system for a motion that starts from this state. Contacts are closed and
    /// friction sticks if the state permits it, and its [switches](crate::event::Switches) are on
    /// the sides of the state. `None` if it is the same.
    ///
    /// # Errors
    /// If no motion can start there.
    #[inline]
    fn begin(&self, _t: Self::Scalar, _y: &Self::State) -> Result<Option<Self>, StepFailure<Self::Scalar>>
    where
        Self: Sized,
    {
        Ok(None)
    }

    /// Returns the system on the sides of its [switches](crate::event::Switches) for this state, as
    /// after a jump of inputs; `None` without switches.
    #[inline]
    fn on_sides(&self, _t: Self::Scalar, _y: &Self::State) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Returns the system with its [switches](crate::event::Switches) free, as presented to
    /// observers; `None` without switches.
    #[inline]
    fn freed(&self) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }
}

/// The response of a system M to a declared event.
pub type Reacted<M> = Result<
    Response<M, <M as OdeSystem>::Scalar, <M as OdeSystem>::State>,
    StepFailure<<M as OdeSystem>::Scalar>,
>;
