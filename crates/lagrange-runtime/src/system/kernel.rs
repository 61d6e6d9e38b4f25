//! Systems that also provide their equations of motion as text, for devices that rustc does not
//! support.

use super::{MechanicalSystem, NamedSystem};

/// A system with its equations of motion as C, for graphics processors. Emitted types implement it
/// if they declare `emit { kernel }`.
/// Each text is self-contained: OpenCL C 1.2, CUDA C++ and C99 compile it unchanged. It defines the
/// numbers `REAL`, the lengths `LAGRANGE_POSITIONS`, `LAGRANGE_VELOCITIES` and
/// `LAGRANGE_PARAMETERS`, and three functions with the qualifiers `LAGRANGE_FUNCTION`:
///
/// ```c
/// void lagrange_acceleration(REAL t, const REAL *q, const REAL *v, const REAL *p, REAL *a);
/// void lagrange_position_rates(REAL t, const REAL *q, const REAL *v, const REAL *p, REAL *rates);
/// void lagrange_normalise(REAL *q);
/// ```
///
/// They compute the accelerations at time t, positions q, velocities v and parameters p. The others
/// compute the rates of the positions, and positions with quaternions of length one. Parameters are
/// those of [`parameters`](Self::parameters). Conditions of `if` and the kinks of `abs`, `sign`,
/// `min` and `max` are evaluated at the state; NaN stays NaN.
///
/// ```
/// use lagrange::system::KernelSystem;
///
/// lagrange::system! {
///     /// A pendulum with a motor.
///     struct Pendulum;
///     param l = 0.5, g = 9.81;
///     coord theta;
///     input motor = 2;
///     kinetic = 1/2 * l^2 * dot(theta)^2;
///     potential = -g * l * cos(theta);
///     force theta = motor;
///     emit { kernel }
/// }
///
/// assert_eq!(Pendulum::default().parameters(), [0.5, 9.81, 2.0]);
/// assert_eq!(<Pendulum as KernelSystem>::PARAMETERS, ["l", "g", "motor"]);
/// assert!(Pendulum::KERNEL_F32.starts_with("typedef float REAL;"));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no equations of motion for devices",
    note = "add `emit {{ kernel }}` to its declaration"
)]
pub trait KernelSystem: MechanicalSystem + NamedSystem {
    /// A number for each parameter and each input, such as `[S; P]`.
    type Parameters: AsRef<[Self::Scalar]>;

    /// The text for double precision.
    const KERNEL_F64: &'static str;

    /// The text for single precision.
    const KERNEL_F32: &'static str;

    /// The names of the parameters, then those of the inputs, in the order of the declaration.
    /// Known units are in [`MechanicalSystem::UNITS`].
    const PARAMETERS: &'static [&'static str];

    /// Returns the present parameters, then the present inputs.
    fn parameters(&self) -> Self::Parameters;
}
