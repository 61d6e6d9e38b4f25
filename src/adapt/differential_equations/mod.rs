//! Systems as those of the crate `differential-equations`.

use ::differential_equations::linalg::Matrix;
use ::differential_equations::ode::ODE;
use ::differential_equations::traits::{Real, State};

use super::jacobian::jacobian;
use crate::system::OdeSystem;

/// A borrowed system that the solvers of `differential-equations` take.
///
/// Implicit ones get the Jacobian that is emitted for `emit { jacobian }`, and central differences without it.
///
/// ```
/// use differential_equations::ivp::IVP;
/// use differential_equations::methods::ExplicitRungeKutta;
/// use lagrange::adapt::differential_equations::Adapter;
///
/// lagrange::system! {
///     pub struct Pendulum;
///     coord theta;
///     kinetic = 1/2 * dot(theta)^2;
///     potential = -9.81 * cos(theta);
/// }
///
/// let pendulum = Pendulum::default();
/// let method = ExplicitRungeKutta::dop853().rtol(1e-10).atol(1e-10);
/// let solution = IVP::ode(&Adapter(&pendulum), 0.0, 10.0, [1.0, 0.0]).method(method).solve().unwrap();
/// let end = solution.y.last().unwrap();
/// assert!((pendulum.energy(10.0, &[end[0]], &[end[1]]) + 9.81 * 1.0_f64.cos()).abs() < 1e-8);
/// ```
#[derive(Debug)]
pub struct Adapter<'a, M: ?Sized>(pub &'a M);

impl<M: ?Sized> Clone for Adapter<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ?Sized> Copy for Adapter<'_, M> {}

impl<M> ODE<M::Scalar, M::State> for Adapter<'_, M>
where
    M: OdeSystem + ?Sized,
    M::Scalar: Real,
    M::State: State<M::Scalar>,
{
    #[inline]
    fn diff(&self, t: M::Scalar, y: &M::State, rate: &mut M::State) {
        *rate = self.0.rhs(t, y);
    }

    fn jacobian(&self, t: M::Scalar, y: &M::State, matrix: &mut Matrix<M::Scalar>) {
        let rows = jacobian(self.0, t, y);
        for (i, row) in rows.as_ref().iter().enumerate() {
            for (j, entry) in row.as_ref().iter().enumerate() {
                matrix[(i, j)] = *entry;
            }
        }
    }
}
