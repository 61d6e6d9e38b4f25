//! Mechanical systems: positions, velocities, accelerations.

use super::{Description, OdeSystem, StateVector};

/// A system described by positions q and velocities v, with accelerations a = v̇.
///
/// Its state is y = `[q…, v…]` and its right-hand side ẏ = `[N(q) v…, a…]`. There is one velocity
/// for each degree of freedom. Usually velocities are the rates of generalised coordinates, q̇ = v,
/// and accelerations a(t, q, v) solve d/dt ∂L/∂v − ∂L/∂q = Q. There may be more positions than
/// velocities. For example, the four components of a unit quaternion correspond to the three
/// components of an angular velocity ω. If these are along the axes of the body, q̇ = ½ q ⊗ (0, ω).
/// N(q) is [`position_rates`](Self::position_rates).
///
/// A small step of positions, such as that of a [projection](crate::constraint), is a displacement
/// δ, a vector like v. Positions q are displaced to q + N(q) δ, and [normalised](Self::normalise).
/// Gradients of constraints, gaps and energies are with respect to displacements, and the mass
/// matrix measures them. Methods that need q̇ = v, all symplectic ones, reject other systems at
/// compile time; [`Verner98`](crate::integrate::Verner98), [`Radau5`](crate::integrate::Radau5),
/// [`RungeKutta4`](crate::integrate::RungeKutta4) and
/// [`PlainGaussLegendre`](crate::integrate::PlainGaussLegendre) accept all systems.
///
/// Source: Featherstone, *Rigid Body Dynamics Algorithms*, §3.2, §4.5.
///
/// # First-order states
///
/// The last positions may be first-order states z, such as the current of a motor or the integral
/// of a controller. Their rates ż(t, q, v, z) are arbitrary functions, and velocities do not
/// displace them. The state is then y = `[q…, z…, v…]`, in which q and z always form one vector
/// [`Coordinates`](Self::Coordinates). [`position_rates`](Self::position_rates) returns their rates
/// after those of q. Displacements leave them unchanged, as
/// [`position_change`](Self::position_change) states.
/// [`FIRST_ORDER_STATES`](Self::FIRST_ORDER_STATES) is their number, and velocities have names,
/// [`VELOCITIES`](Self::VELOCITIES). Methods of integration that accept quaternions also accept
/// such systems.
///
/// ```
/// use lagrange::Simulate;
/// use lagrange::system::{MechanicalSystem, OdeSystem, StepFailure, Unnamed, join, normalise, split};
///
/// /// A rigid body that turns freely, with its principal moments of inertia: I ω̇ = (I ω) × ω.
/// struct FreeBody([f64; 3]);
///
/// impl MechanicalSystem for FreeBody {
///     type Coordinates = [f64; 4];
///     type Velocities = [f64; 3];
///     type Columns<C> = Unnamed<C>;
///     const COORDINATES: &'static [&'static str] = &["q_0", "q_1", "q_2", "q_3"];
///     const VELOCITIES: &'static [&'static str] = &["w_x", "w_y", "w_z"];
///
///     fn acceleration(&self, _t: f64, _q: &[f64; 4], [x, y, z]: &[f64; 3]) -> [f64; 3] {
///         let [a, b, c] = self.0;
///         [(b - c) / a * y * z, (c - a) / b * z * x, (a - b) / c * x * y]
///     }
///
///     fn position_rates(&self, _t: f64, [a, b, c, d]: &[f64; 4], [x, y, z]: &[f64; 3]) -> [f64; 4] {
///         let rates = [-b * x - c * y - d * z, a * x + c * z - d * y, a * y + d * x - b * z, a * z + b * y - c * x];
///         rates.map(|rate| rate / 2.0)
///     }
///
///     fn normalise(q: &mut [f64; 4]) {
///         let length = q.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
///         *q = q.map(|entry| entry / length);
///     }
///
///     fn displacement(&self, _t: f64, [a, b, c, d]: &[f64; 4], [e, f, g, h]: &[f64; 4]) -> [f64; 3] {
///         let real = a * e + b * f + c * g + d * h;
///         let imaginary = [
///             a * f - b * e - c * h + d * g,
///             a * g + b * h - c * e - d * f,
///             a * h - b * g + c * f - d * e,
///         ];
///         imaginary.map(|entry| 2.0 * real.signum() * entry)
///     }
/// }
///
/// impl OdeSystem for FreeBody {
///     type Scalar = f64;
///     type State = [f64; 7];
///
///     fn rhs(&self, t: f64, y: &[f64; 7]) -> [f64; 7] {
///         let (q, w) = split::<Self>(y);
///         join::<Self>(&self.position_rates(t, &q, &w), &self.acceleration(t, &q, &w))
///     }
///
///     const IS_CONSTRAINED: bool = true;
///
///     fn correct(&self, _t: f64, y: &mut [f64; 7]) -> Result<(), StepFailure<f64>> {
///         normalise::<Self>(y)
///     }
/// }
///
/// // Half a turn about the first axis.
/// let body = FreeBody([1.0, 2.0, 3.0]);
/// let trajectory = body.simulate([1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]).until(std::f64::consts::PI).run()?;
/// let [q_0, q_1, ..] = trajectory.last();
/// assert!(q_0.abs() < 1e-8 && (q_1 - 1.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Methods in coordinates and momenta require velocities that are the rates of the positions:
///
/// ```compile_fail,E0271
/// # use lagrange::system::{MechanicalSystem, OdeSystem, Unnamed};
/// # struct FreeBody;
/// # impl OdeSystem for FreeBody {
/// #     type Scalar = f64;
/// #     type State = [f64; 7];
/// #     fn rhs(&self, _t: f64, y: &[f64; 7]) -> [f64; 7] {
/// #         *y
/// #     }
/// # }
/// # impl MechanicalSystem for FreeBody {
/// #     type Coordinates = [f64; 4];
/// #     type Velocities = [f64; 3];
/// #     type Columns<C> = Unnamed<C>;
/// #     const COORDINATES: &'static [&'static str] = &["q_0", "q_1", "q_2", "q_3"];
/// #     const VELOCITIES: &'static [&'static str] = &["w_x", "w_y", "w_z"];
/// #     fn acceleration(&self, _t: f64, _q: &[f64; 4], w: &[f64; 3]) -> [f64; 3] {
/// #         *w
/// #     }
/// #     fn position_rates(&self, _t: f64, q: &[f64; 4], _w: &[f64; 3]) -> [f64; 4] {
/// #         *q
/// #     }
/// # }
/// impl lagrange::system::SeparableSystem for FreeBody {}
/// ```
///
/// ```compile_fail,E0277
/// # use lagrange::system::{MechanicalSystem, OdeSystem, Unnamed};
/// # struct FreeBody;
/// # impl OdeSystem for FreeBody {
/// #     type Scalar = f64;
/// #     type State = [f64; 7];
/// #     fn rhs(&self, _t: f64, y: &[f64; 7]) -> [f64; 7] {
/// #         *y
/// #     }
/// # }
/// # impl MechanicalSystem for FreeBody {
/// #     type Coordinates = [f64; 4];
/// #     type Velocities = [f64; 3];
/// #     type Columns<C> = Unnamed<C>;
/// #     const COORDINATES: &'static [&'static str] = &["q_0", "q_1", "q_2", "q_3"];
/// #     const VELOCITIES: &'static [&'static str] = &["w_x", "w_y", "w_z"];
/// #     fn acceleration(&self, _t: f64, _q: &[f64; 4], w: &[f64; 3]) -> [f64; 3] {
/// #         *w
/// #     }
/// #     fn position_rates(&self, _t: f64, q: &[f64; 4], _w: &[f64; 3]) -> [f64; 4] {
/// #         *q
/// #     }
/// # }
/// use lagrange::Simulate;
/// use lagrange::integrate::StormerVerlet;
///
/// let start = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0];
/// FreeBody.simulate(start).until(1.0).method(StormerVerlet { step: 1e-3 }).run();
/// ```
pub trait MechanicalSystem: OdeSystem {
    /// A vector with one entry for each position.
    type Coordinates: StateVector<Self::Scalar>;

    /// A vector with one entry for each degree of freedom: velocities, accelerations or
    /// displacements. The same as [`Coordinates`](Self::Coordinates) if velocities are the rates of
    /// positions.
    type Velocities: StateVector<Self::Scalar>;

    /// Columns of a table of states under the names of the positions and velocities. [`Unnamed`]
    /// suffices for a handwritten system.
    type Columns<C>: From<C> + AsRef<C>;

    /// Names of the positions, in the order of the state.
    const COORDINATES: &'static [&'static str];

    /// Names of the velocities, in the order of the state. Empty if velocities are the rates of the
    /// positions, q̇ = v: their names are then those of the positions, followed by `_dot`.
    const VELOCITIES: &'static [&'static str] = &[];

    /// Names of the coordinates whose rates are velocities with separate names, one for each of
    /// [`VELOCITIES`](Self::VELOCITIES). The name is empty for a velocity that is not the rate of a
    /// coordinate.
    const RATES_OF: &'static [&'static str] = &[];

    /// Number of [first-order states](MechanicalSystem#first-order-states), which come last among
    /// the positions. Plots show them separately.
    const FIRST_ORDER_STATES: usize = 0;

    /// Units of columns and parameters, `(name, unit)` such as `("theta_dot", "rad/s")`: of the
    /// state, of accelerations, momenta, inputs and outputs. The name of an array applies to its
    /// elements, and a column observed under one of the names has its unit. Names that are not
    /// listed have an unknown unit, and plain numbers have `1`. Units appear on axes of plots and
    /// in files, and do not affect computations. If there are any, times are in `s` and the energy
    /// is in `J`.
    const UNITS: &'static [(&'static str, &'static str)] = &[];

    /// A number that distinguishes declarations: their equations, defaults, constants, events,
    /// tables with their numbers, and the level of accuracy. It does not depend on comments, layout
    /// and pictures, nor on the code of functions in the user's crate. Zero for handwritten
    /// systems. Files of ensembles store it, so that files of different declarations are not mixed.
    const FINGERPRINT: u64 = 0;

    /// Returns the names and units of the variables of this system. They are the constants above
    /// unless the system was read at run time.
    #[inline]
    fn description(&self) -> &'static Description {
        description_of_type::<Self>()
    }

    /// Computes the accelerations at time `t`, positions `q` and velocities `v`. If the mass matrix
    /// is singular only in some states, they are not finite there. Masses of emitted types must not
    /// be zero. Common factors of all terms of an equation are cancelled, so a massless pendulum
    /// would move like one with mass.
    fn acceleration(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Velocities) -> Self::Velocities;

    /// Computes the rates of the positions, q̇ = N(q) v. They are the velocities, `*v`, if
    /// velocities are the rates of the positions.
    ///
    /// Linear and homogeneous in `v` except for [first-order
    /// states](MechanicalSystem#first-order-states).
    fn position_rates(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
    ) -> Self::Coordinates;

    /// Computes the change N(q) δ of positions for a displacement δ. It equals
    /// [`position_rates`](Self::position_rates) for δ, with zeros for [first-order
    /// states](MechanicalSystem#first-order-states). A system with such states must define it.
    #[inline]
    fn position_change(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        displacement: &Self::Velocities,
    ) -> Self::Coordinates {
        self.position_rates(t, q, displacement)
    }

    /// Normalises unit quaternions among the positions, and leaves other positions unchanged.
    ///
    /// It is called after positions were displaced, by [`OdeSystem::correct`] after every step, and
    /// before states within a step are returned.
    #[inline]
    fn normalise(_q: &mut Self::Coordinates) {}

    /// Returns the displacement δ from positions to others nearby. The result of
    /// [`position_change`](Self::position_change) for it at `from` is `to − from` to first order.
    /// From a unit quaternion q to p it is 2 Im(q̄ ⊗ p), if velocities are along the axes of the
    /// body. The sign of p is chosen so that the real part is not negative.
    ///
    /// By default `to − from`; systems with [`VELOCITIES`](Self::VELOCITIES) must define it, which
    /// the compiler enforces.
    #[inline]
    fn displacement(
        &self,
        _t: Self::Scalar,
        from: &Self::Coordinates,
        to: &Self::Coordinates,
    ) -> Self::Velocities {
        const {
            assert!(
                Self::VELOCITIES.is_empty() && Self::FIRST_ORDER_STATES == 0,
                "a system whose velocities are not the rates of its positions must implement `displacement`"
            );
        }
        let mut displacement = Self::Velocities::of(to.as_ref());
        for (entry, from) in displacement.as_mut().iter_mut().zip(from.as_ref()) {
            *entry = *entry - *from;
        }
        displacement
    }

    /// Returns the parameter at this zero-based index among the declared ones, with its name.
    /// Messages about rates that are not finite name it, and ensembles store it for each motion. By
    /// default there is none; emitted types with parameters define it.
    ///
    /// ```
    /// use lagrange::system::MechanicalSystem;
    ///
    /// lagrange::system! {
    ///     struct Particle;
    ///     param m = 2.0;
    ///     coord x;
    ///     kinetic = 1/2 * m * dot(x)^2;
    /// }
    ///
    /// let particle = Particle::default();
    /// assert_eq!((particle.parameter(0), particle.parameter(1)), (Some(("m", 2.0)), None));
    /// ```
    fn parameter(&self, _index: usize) -> Option<(&'static str, Self::Scalar)> {
        None
    }
}

/// Returns the names and units that the constants of a type specify.
#[inline]
pub(crate) const fn description_of_type<M: MechanicalSystem + ?Sized>() -> &'static Description {
    const {
        &Description {
            coordinates: M::COORDINATES,
            velocities: M::VELOCITIES,
            rates_of: M::RATES_OF,
            first_order_states: M::FIRST_ORDER_STATES,
            units: M::UNITS,
            quaternions: &[],
        }
    }
}

/// A system with a state type that has a field for each position and velocity. Emitted types
/// implement it.
///
/// ```
/// use lagrange::system::NamedSystem;
///
/// lagrange::system! {
///     struct Particle;
///     coord x;
///     kinetic = 1/2 * dot(x)^2;
/// }
///
/// let state: <Particle as NamedSystem>::NamedState = [1.0, 2.0].into();
/// assert_eq!(state.x_dot, 2.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "the state of `{Self}` has no names",
    note = "emitted types have them; for a handwritten system implement `NamedSystem`, or read the state as an array"
)]
pub trait NamedSystem: MechanicalSystem {
    /// The state under the names of positions and velocities.
    type NamedState: From<Self::State>;
}

/// A table of states, stored in columns, one for each entry of the state.
pub trait Columns {
    /// The number type.
    type Scalar;

    /// Returns the values of entry `index` of the state, positions first, one for each state of the
    /// table.
    ///
    /// # Panics
    /// If the state has no such entry.
    fn column(&self, index: usize) -> &[Self::Scalar];
}

/// Columns without names, for handwritten systems.
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

/// A mechanical system that provides its energy function h(q, v, t) = v · ∂L/∂v − L.
///
/// It changes by dh/dt = v · Q − ∂L/∂t. It is therefore constant if L does not depend on time and
/// the forces Q do no work. It is the total energy T + V if T is homogeneous of degree two in v and
/// V does not depend on v. Under moving constraints the two differ. Source: Goldstein, Poole,
/// Safko, *Classical Mechanics*, 3rd ed., §2.7.
pub trait EnergyFunction: MechanicalSystem {
    /// Computes the energy function at time `t`, positions `q` and velocities `v`.
    fn energy(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Velocities) -> Self::Scalar;
}
