//! Systems that provide all derivatives needed for a linear model.

use super::MechanicalSystem;
use crate::scalar::Number;

/// A system with the derivatives from which equilibria and linear models are computed. Emitted
/// types implement it if the declaration has `emit { system_matrix }`.
///
/// A deviation of the state is a vector x = `[δ…, z…, ε…]`. It begins with a displacement δ of the
/// positions, followed by changes of the first-order states and of the velocities. Changes of the
/// inputs are u. To first order, ẋ = A x + B u. Outputs change by C x + D u, and constraint
/// velocities by G x. The system matrix is `[A B; C D; G 0]`. The columns of G for ε are the
/// constraint Jacobian. Source: Rosenbrock, *State-space and Multivariable Theory*, 1970, §2.
///
/// ```
/// use lagrange::system::LinearisedSystem;
///
/// lagrange::system! {
///     /// A mass on a spring, pushed by a force u.
///     struct Oscillator;
///     param m = 2.0, k = 8.0;
///     coord x;
///     input u;
///     kinetic = 1/2 * m * dot(x)^2;
///     potential = 1/2 * k * x^2;
///     force x = u;
///     output shaking = ddot(x);
///     emit { system_matrix }
/// }
///
/// let matrix = Oscillator::default().system_matrix(0.0, &[0.0, 0.0]);
/// assert_eq!(matrix, [[0.0, 1.0, 0.0], [-4.0, 0.0, 0.5], [-4.0, 0.0, 0.5]]);
/// assert_eq!(Oscillator::LAYOUT.outputs, ["shaking"]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not know the derivatives of its equations",
    note = "add `emit {{ system_matrix }}` to the declaration"
)]
pub trait LinearisedSystem: MechanicalSystem {
    /// A row of the system matrix, such as `[S; K]`.
    type Row: AsRef<[Self::Scalar]>;
    /// The system matrix in rows, such as `[[S; K]; R]`.
    type SystemMatrix: AsRef<[Self::Row]>;

    /// Names of the rows and columns beyond those of the state.
    const LAYOUT: MatrixLayout;

    /// Returns the names of the rows and columns beyond those of the state. They are
    /// [`LAYOUT`](Self::LAYOUT) unless the system was read at run time.
    #[inline]
    fn layout(&self) -> MatrixLayout {
        Self::LAYOUT
    }

    /// Computes the system matrix at time `t` and state `y`. It is not finite where a derivative is
    /// undefined.
    fn system_matrix(&self, t: Self::Scalar, y: &Self::State) -> Self::SystemMatrix;

    /// Computes the residuals of the constraints at the level of positions, zero for constraints on
    /// velocities alone, and at the level of velocities.
    fn residuals(
        &self,
        _t: Self::Scalar,
        _q: &Self::Coordinates,
        _v: &Self::Velocities,
    ) -> [impl AsRef<[Self::Scalar]>; 2] {
        [[Self::Scalar::ZERO; 0]; 2]
    }
}

/// The rows and columns of a system matrix beyond those of the state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MatrixLayout {
    /// Names of the inputs.
    pub inputs: &'static [&'static str],
    /// Names of the components of the outputs.
    pub outputs: &'static [&'static str],
    /// Names of the constraints.
    pub constraints: &'static [&'static str],
    /// True for each constraint that contains positions.
    pub are_holonomic: &'static [bool],
}
