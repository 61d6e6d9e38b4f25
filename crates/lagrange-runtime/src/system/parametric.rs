//! Parameters and inputs of systems by index.

use super::MechanicalSystem;

/// A system whose parameters and inputs are accessible by index. Emitted types implement it.
///
/// [`sensitivities`](crate::simulate::Simulation::sensitivities) and fits require it.
///
/// ```
/// use lagrange::system::ParametricSystem;
///
/// lagrange::system! {
///     struct Cart;
///     param m = 2.0;
///     coord x;
///     input push;
///     kinetic = 1/2 * m * dot(x)^2;
///     force x = push;
///     emit { parameter_jacobian }
/// }
///
/// let cart = Cart::default().with_number(1, 6.0);
/// assert_eq!((Cart::NUMBERS, cart.push, cart.number(0)), (&["m", "push"][..], 6.0, Some(2.0)));
///
/// // The derivative of a = push/m by m.
/// let mut columns = [[0.0; 2]];
/// assert!(cart.derivatives(0.0, &[0.0, 0.0], &[0], &mut columns));
/// assert_eq!(columns, [[0.0, -1.5]]);
/// ```
#[diagnostic::on_unimplemented(
    message = "the parameters of `{Self}` are not known by their places",
    note = "emitted types implement `ParametricSystem`; implement it for a handwritten system"
)]
pub trait ParametricSystem: MechanicalSystem + Sized {
    /// Names of the parameters, followed by those of the inputs.
    const NUMBERS: &'static [&'static str];

    /// Returns the names of the parameters and inputs of this system. They are
    /// [`NUMBERS`](Self::NUMBERS) unless the system was read at run time.
    #[inline]
    fn numbers(&self) -> &'static [&'static str] {
        Self::NUMBERS
    }

    /// Returns the value of the parameter or input at this index.
    fn number(&self, index: usize) -> Option<Self::Scalar>;

    /// Returns the system with another value at this index; a copy if there is no such index.
    #[must_use]
    fn with_number(&self, index: usize, value: Self::Scalar) -> Self;

    /// Sets the parameter or input of this name. Returns false, and changes nothing, if there is
    /// none.
    ///
    /// ```
    /// use lagrange::system::ParametricSystem;
    ///
    /// lagrange::system! {
    ///     struct Spring;
    ///     param k = 4.0;
    ///     coord x;
    ///     kinetic = 1/2 * dot(x)^2;
    ///     potential = 1/2 * k * x^2;
    /// }
    ///
    /// let mut spring = Spring::default();
    /// assert!(spring.set_parameter("k", 9.0) && spring.k == 9.0);
    /// assert!(!spring.set_parameter("m", 1.0));
    /// ```
    #[must_use = "there may be no parameter of this name"]
    fn set_parameter(&mut self, name: &str, value: Self::Scalar) -> bool {
        let Some(index) = self.numbers().iter().position(|known| *known == name) else { return false };
        *self = self.with_number(index, value);
        true
    }

    /// Writes ∂f/∂p of the right-hand side to one column for each of the parameters and inputs at
    /// these indices. Returns false if the derivatives are not available. Emitted types provide
    /// them with `emit { parameter_jacobian }`, which is part of `emit { jacobian }`.
    #[inline]
    fn derivatives(
        &self,
        _t: Self::Scalar,
        _y: &Self::State,
        _indices: &[usize],
        _columns: &mut [Self::State],
    ) -> bool {
        false
    }

    /// Multiplies derivatives of a cost by a projected state, `slope`, by the transposed derivative
    /// of [`correct`](crate::system::OdeSystem::correct) at the state `y` before. Writes the
    /// products with derivatives with respect to the parameters and inputs at these indices to
    /// `by`. Returns false, with the slope unchanged, if the derivative is not available. Emitted
    /// types with constraints provide it.
    #[inline]
    fn correct_adjoint(
        &self,
        _t: Self::Scalar,
        _y: &Self::State,
        _slope: &mut Self::State,
        _indices: &[usize],
        _by: &mut [Self::Scalar],
    ) -> bool {
        false
    }

    /// True if rates have kinks or jumps that are not [events](crate::system::OdeSystem::events),
    /// such as those between pieces of tables.
    #[inline]
    fn has_kinks(&self) -> bool {
        false
    }
}

/// Writes columns of a matrix, given in rows, to as many vectors.
///
/// # Panics
/// If there is no such column.
#[inline]
pub fn pick_columns<S: Copy, const N: usize, const P: usize>(
    rows: &[[S; P]; N],
    indices: &[usize],
    columns: &mut [[S; N]],
) {
    for (column, &index) in columns.iter_mut().zip(indices) {
        *column = core::array::from_fn(|row| rows[row][index]);
    }
}
