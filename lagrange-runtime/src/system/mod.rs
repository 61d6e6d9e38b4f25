//! Traits that emitted types implement, so that integrators and adapters take any of them.
//!
//! The traits hold what an algorithm needs of a system; everything else that is known about it stays an
//! inherent method of its type. Nothing here derives or integrates.

mod constraint_values;
mod event;
mod message;
mod ports;
mod step_failure;
mod undefined;
mod violation;
mod wrapper;

pub use self::constraint_values::ConstraintValues;
pub(crate) use self::event::MOST_LOCATED;
pub use self::event::{Action, DeclaredEvent, Direction, EventKind, Impact, MOST_DECLARED, Response};
#[cfg(feature = "std")]
pub(crate) use self::message::explain;
pub use self::ports::{ControlledSystem, OutputSystem};
pub use self::step_failure::{EventSource, StepFailure};
pub use self::undefined::{Component, Undefined};
pub use self::violation::{Violated, Violation};
pub use self::wrapper::Wrapper;
pub use crate::linalg::vector::StateVector;

use crate::scalar::Scalar;

/// The scalar of a system.
pub(crate) type Number<M> = <M as OdeSystem>::Scalar;

/// Positions of a system, or as many velocities.
pub(crate) type Vector<M> = <M as MechanicalSystem>::Coordinates;

/// The state of a system.
pub(crate) type State<M> = <M as OdeSystem>::State;

/// The square matrix, in rows, that belongs to a system's state.
pub type StateMatrix<M> = <<M as OdeSystem>::State as StateVector<<M as OdeSystem>::Scalar>>::Square;

/// The square matrix, in rows, that belongs to a system's coordinates.
pub type CoordinateMatrix<M> =
    <<M as MechanicalSystem>::Coordinates as StateVector<<M as OdeSystem>::Scalar>>::Square;

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
/// The members beside [`rhs`](Self::rhs) stand for a system that has nothing but its equations. A type that contains another system
/// implements [`Wrapper`] instead, which keeps the constraints and events of that.
pub trait OdeSystem {
    /// The number type.
    type Scalar: Scalar;
    /// The state y; for a mechanical system `[q…, v…]`, coordinates first.
    type State: StateVector<Self::Scalar>;

    /// The right-hand side f(t, y): the time derivative of the state `y` at time `t`.
    ///
    /// Where f is undefined, the result is not finite.
    fn rhs(&self, t: Self::Scalar, y: &Self::State) -> Self::State;

    /// The first of the components of the state `y` and of its `rates` at time `t` that is not finite, or what makes it so, by name:
    /// runs ask when they cannot go on. Systems written by hand know no names but of their components' places.
    #[inline]
    fn undefined(
        &self,
        t: Self::Scalar,
        y: &Self::State,
        rates: &Self::State,
    ) -> Option<Undefined<Self::Scalar>> {
        Undefined::of_state(t, y.as_ref(), rates.as_ref(), Component::Index)
    }

    /// ∂f/∂y in rows, entry i, j being ∂fᵢ/∂yⱼ, if it is known: emitted types know it if the declaration says
    /// `emit { jacobian }`. Implicit methods iterate by Newton's method where it is and by fixed points elsewhere.
    #[inline]
    fn jacobian(&self, _t: Self::Scalar, _y: &Self::State) -> Option<StateMatrix<Self>> {
        None
    }

    /// The first time after `t` on the way to `end` at which the right-hand side jumps or is not smooth, if that is known
    /// beforehand: runs end a step there and start another one, none of whose evaluations is made at that very time. `end` may
    /// lie before `t`; only a time between the two counts.
    #[inline]
    fn next_restart(&self, _t: Self::Scalar, _end: Self::Scalar) -> Option<Self::Scalar> {
        None
    }

    /// The system as it goes on towards `end` from a time that [`next_restart`](Self::next_restart) named; `None` if it is the same.
    #[inline]
    fn beyond(&self, _t: Self::Scalar, _end: Self::Scalar) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Whether states must satisfy something beside the equations, to which [`correct`](Self::correct) brings them.
    const IS_CONSTRAINED: bool = false;

    /// Brings a state onto the constraints; methods ask for this after every accepted step.
    ///
    /// # Errors
    /// If that is not possible; the state is then what it was.
    #[inline]
    fn correct(&self, _t: Self::Scalar, _y: &mut Self::State) -> Result<(), StepFailure<Self::Scalar>> {
        Ok(())
    }

    /// Brings a state from which a motion starts, or goes on after it was replaced, onto the constraints if it nearly satisfies
    /// them; methods ask for this before their first step from there.
    ///
    /// # Errors
    /// If it does not satisfy them; the state is then what it was.
    #[inline]
    fn admit(&self, t: Self::Scalar, y: &mut Self::State) -> Result<(), StepFailure<Self::Scalar>> {
        self.correct(t, y)
    }

    /// Brings a state that an event put in the place of another onto the constraints, from however far.
    ///
    /// # Errors
    /// If that is not possible; the state is then what it was.
    #[inline]
    fn restore(&self, t: Self::Scalar, y: &mut Self::State) -> Result<(), StepFailure<Self::Scalar>> {
        self.correct(t, y)
    }

    /// The events of the declaration, at most [`MOST_DECLARED`]. Runs look for them without
    /// being asked.
    const EVENTS: &'static [DeclaredEvent] = &[];

    /// The values of the functions of all declared events, to be written to as many `values`.
    #[inline]
    fn event_values(&self, _t: Self::Scalar, _y: &Self::State, _values: &mut [Self::Scalar]) {}

    /// What the declared event of this index does to the state `y` at which it happened.
    ///
    /// # Errors
    /// If the motion cannot go on.
    #[inline]
    fn react(&self, _event: usize, _t: Self::Scalar, _y: &Self::State) -> Reacted<Self>
    where
        Self: Sized,
    {
        Ok(Response::new(Action::Continue))
    }

    /// The system as a motion from this state starts: contacts closed and friction sticking where that fits the state, and on the
    /// sides of its [switches](crate::event::Switches) on which the state is.
    /// `None` if it is the same.
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

    /// The same system on the sides of its [switches](crate::event::Switches) on which this state is, as after inputs jumped; `None` if
    /// it has none.
    #[inline]
    fn on_sides(&self, _t: Self::Scalar, _y: &Self::State) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// The same system with its [switches](crate::event::Switches) free, as it is for whoever looks at it; `None` if it has none.
    #[inline]
    fn freed(&self) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }
}

/// What a declared event of the system M does.
pub type Reacted<M> = Result<
    Response<M, <M as OdeSystem>::Scalar, <M as OdeSystem>::State>,
    StepFailure<<M as OdeSystem>::Scalar>,
>;

/// A system described by generalised coordinates q and their velocities v = q̇.
///
/// Its state is y = `[q…, v…]` and its right-hand side ẏ = `[v…, a…]`, with the accelerations a(t, q, v)
/// that solve d/dt ∂L/∂v − ∂L/∂q = Q.
pub trait MechanicalSystem: OdeSystem {
    /// A vector with one entry for each coordinate: coordinates, velocities or accelerations.
    type Coordinates: StateVector<Self::Scalar>;

    /// Columns of a table of states under the names of the coordinates and velocities. [`Unnamed`] will do for a
    /// system that is written by hand.
    type Columns<C>: From<C> + AsRef<C>;

    /// Names of the coordinates, in the order of the state.
    const COORDINATES: &'static [&'static str];

    /// The accelerations at time `t`, coordinates `q` and velocities `v`; not finite where the mass matrix
    /// is singular in some states only. Masses of emitted types must not be zero: what all terms of an equation share is
    /// divided out, and a pendulum without mass would move as one with it.
    fn acceleration(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> Self::Coordinates;
}

/// A table of states that is kept in columns, one for each entry of the state.
pub trait Columns {
    /// The number type.
    type Scalar;

    /// The values of the state's entry `index`, coordinates first; as many as there are states.
    ///
    /// # Panics
    /// If the state has no such entry.
    fn column(&self, index: usize) -> &[Self::Scalar];
}

/// Columns without names, for systems that are written by hand.
#[derive(Clone, Copy, Debug)]
pub struct Unnamed<C>(C);

impl<C> From<C> for Unnamed<C> {
    #[inline]
    fn from(columns: C) -> Self {
        Unnamed(columns)
    }
}

impl<C> AsRef<C> for Unnamed<C> {
    #[inline]
    fn as_ref(&self) -> &C {
        &self.0
    }
}

/// A mechanical system that knows its energy function h(q, v, t) = v · ∂L/∂v − L.
///
/// It changes by dh/dt = v · Q − ∂L/∂t, so that it is constant if L does not depend on time and the forces
/// Q do no work. It is the total energy T + V if T is homogeneous of degree two in v and V does not depend
/// on v; under moving constraints the two differ. Source: Goldstein, Poole, Safko, *Classical Mechanics*,
/// 3rd ed., §2.7.
pub trait EnergyFunction: MechanicalSystem {
    /// The energy function at time `t`, coordinates `q` and velocities `v`.
    fn energy(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Coordinates) -> Self::Scalar;
}

/// A system whose accelerations do not depend on its velocities and whose mass matrix is constant.
///
/// This makes the Hamiltonian a sum of a function of momenta and one of coordinates, which explicit symplectic
/// methods ask for. Source: Hairer, Lubich, Wanner, *Geometric Numerical Integration*, 2nd ed., §VI.3.
#[diagnostic::on_unimplemented(
    message = "the accelerations of `{Self}` depend on velocities or constraints, or its mass matrix is not constant",
    note = "compositions of kicks and drifts take separable systems without constraints only",
    note = "`StormerVerlet` takes constraints on positions, too",
    note = "`GaussLegendre` and `Variational` are symplectic for any mass matrix"
)]
pub trait SeparableSystem: MechanicalSystem {}

/// A system that is [separable](SeparableSystem), or would be without its constraints, all of which hold positions.
///
/// All separable systems are. Emitted types with constraints implement it if their mass matrix is constant and no force but
/// those of the constraints depends on velocities. Explicit steps then end on the constraints by corrections in the space of
/// constraint forces. Source: Hairer, Lubich, Wanner, *Geometric Numerical Integration*, 2nd ed., §VII.1.3.
#[diagnostic::on_unimplemented(
    message = "the accelerations of `{Self}` depend on velocities, or its mass matrix is not constant",
    note = "symplectic Euler and Störmer–Verlet take separable systems only; constraints on positions may restrain them",
    note = "`GaussLegendre` and `Variational` are symplectic for any mass matrix"
)]
pub trait LeapfrogSystem: MechanicalSystem {
    /// Whether constraints hold it, and the corrections below are known.
    const IS_HELD: bool = false;

    /// The change δ of coordinates by constraint forces at `q` that takes the residuals at the coordinates `to` of the time
    /// `later` away to first order: M δ = A(t, q)ᵀμ and A(t, q) δ = −c(later, to).
    #[inline]
    fn position_correction(
        &self,
        _t: Self::Scalar,
        _q: &Self::Coordinates,
        _later: Self::Scalar,
        _to: &Self::Coordinates,
    ) -> Self::Coordinates {
        Self::Coordinates::ZERO
    }

    /// The change δ of velocities by constraint forces that leaves no residual: M δ = Aᵀμ and A δ = −ċ(t, q, v).
    #[inline]
    fn velocity_correction(
        &self,
        _t: Self::Scalar,
        _q: &Self::Coordinates,
        _v: &Self::Coordinates,
    ) -> Self::Coordinates {
        Self::Coordinates::ZERO
    }
}

impl<M: SeparableSystem + ?Sized> LeapfrogSystem for M {}

/// A mechanical system that knows its momenta p = ∂L/∂v and how fast they change, ṗ = ∂L/∂q + Q.
///
/// These are Hamilton's equations with velocities in the place of momenta; methods that are symplectic for any
/// mass matrix integrate (q, p). Emitted types implement it if the declaration says `emit { momentum_rates }`.
#[diagnostic::on_unimplemented(
    message = "the momenta of `{Self}` and their rates are not known",
    note = "declare it with `emit {{ momentum_rates }}`"
)]
pub trait CanonicalSystem: MechanicalSystem {
    /// The momenta p = ∂L/∂v.
    fn momenta(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Coordinates) -> Self::Coordinates;

    /// The rates ∂L/∂q + Q of the momenta.
    fn momentum_rates(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> Self::Coordinates;

    /// The mass matrix ∂p/∂v, in rows.
    fn mass_matrix(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> CoordinateMatrix<Self>;

    /// The rates of the momenta without the forces Aᵀλ of constraints. A method that finds these forces itself does not mind
    /// combinations of the rows of A, so that the rates with them will do.
    #[inline]
    fn free_momentum_rates(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> Self::Coordinates {
        self.momentum_rates(t, q, v)
    }

    /// Whether [`constraint_values`](Self::constraint_values) says all that holds the system. Methods that enforce constraints
    /// by themselves do so then; elsewhere states are corrected after steps.
    const SAYS_CONSTRAINTS: bool = false;

    /// The constraints that act, always in the same order.
    #[inline]
    fn constraint_values(
        &self,
        _t: Self::Scalar,
        _q: &Self::Coordinates,
        _v: &Self::Coordinates,
    ) -> ConstraintValues<Self::Scalar, Self::Coordinates> {
        ConstraintValues::NONE
    }
}

/// Coordinates and velocities of a state.
#[inline]
pub fn split<M: MechanicalSystem + ?Sized>(y: &M::State) -> (M::Coordinates, M::Coordinates) {
    let (mut q, mut v) = (M::Coordinates::ZERO, M::Coordinates::ZERO);
    let (coordinates, velocities) = y.as_ref().split_at(q.as_ref().len());
    q.as_mut().copy_from_slice(coordinates);
    v.as_mut().copy_from_slice(velocities);
    (q, v)
}

/// The state made of coordinates and velocities.
#[inline]
pub fn join<M: MechanicalSystem + ?Sized>(q: &M::Coordinates, v: &M::Coordinates) -> M::State {
    let mut y = M::State::ZERO;
    let (coordinates, velocities) = y.as_mut().split_at_mut(q.as_ref().len());
    coordinates.copy_from_slice(q.as_ref());
    velocities.copy_from_slice(v.as_ref());
    y
}
