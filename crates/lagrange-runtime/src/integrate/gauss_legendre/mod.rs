//! Gauss methods: implicit midpoint and its relatives of order four and six.
//!
//! Collocation at the zeros of Legendre polynomials, with order 2K for K stages. The methods are
//! symmetric and, for any Lagrangian, symplectic in coordinates and momenta. They conserve
//! quadratic invariants, and have no numerical damping for any stiffness. Sources: Butcher 1964;
//! Hairer, Lubich, Wanner, *Geometric Numerical Integration*, §II.1.3, §VI.4, §VIII.6.

mod canonical;
mod dense;
mod derivatives;
mod linearised;
mod plain;
mod tableau;

use crate::integrate::fixed::fixed_steps;
use crate::integrate::gauss_legendre::canonical::Canonical;
use crate::integrate::gauss_legendre::plain::Plain;
use crate::integrate::gauss_legendre::tableau::{Coefficients, Tableau};
use crate::integrate::method::Method;
use crate::system::{CanonicalSystem, OdeSystem};

/// The implicit midpoint rule, the Gauss method of order two. See [`GaussLegendre`].
pub type ImplicitMidpoint<S> = GaussLegendre<S, 1>;

/// The Gauss method of order four. See [`GaussLegendre`].
pub type GaussLegendre4<S> = GaussLegendre<S, 2>;

/// The Gauss method of order six. See [`GaussLegendre`].
pub type GaussLegendre6<S> = GaussLegendre<S, 3>;

/// The Gauss method with K = 1, 2 or 3 stages, of order 2K, in equal steps, for any Lagrangian.
///
/// It advances coordinates and momenta p = ∂L/∂v, in which it is symplectic for any mass matrix.
/// The energy of a conservative system therefore oscillates without drift. Momenta of cyclic
/// coordinates are conserved to rounding, and so are quantities that are quadratic in (q, p), such
/// as angular momenta in Cartesian coordinates. The method is symmetric in time and stable for any
/// stiffness; vibrations faster than the step neither grow nor decay.
///
/// An iteration evaluates momenta and their rates K times. With the Jacobian that `emit { jacobian
/// }` provides, a step evaluates it once and takes four to seven Newton iterations, for any
/// stiffness. Without it, the step uses fixed-point iterations, about as many if the step is short.
/// If these do not converge, it uses difference quotients. On a double pendulum a step costs as
/// much as 15 (K = 1) to 30 (K = 3) evaluations of the right-hand side.
///
/// States within a step have the order of the method for K = 1 (a straight line) and K = 2 (a
/// cubic). For K = 3, velocities have order five. The interpolation requires steps that resolve the
/// motion, unlike states at ends of steps.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GaussLegendre<S, const K: usize> {
    /// Length of a step.
    pub step: S,
}

impl<M: CanonicalSystem + ?Sized, const K: usize> Method<M> for GaussLegendre<M::Scalar, K>
where
    Tableau<M::Scalar, K>: Coefficients,
{
    fixed_steps! { name::<K>(), 2 * K as u32, Canonical<M, K> = Canonical::new() }
}

impl<S, const K: usize> GaussLegendre<S, K> {
    /// Returns the method for systems without momenta.
    pub fn plain(self) -> PlainGaussLegendre<S, K> {
        PlainGaussLegendre { step: self.step }
    }
}

/// The Gauss method with K = 1, 2 or 3 stages, of order 2K, in equal steps, for any system of
/// differential equations.
///
/// It advances the state itself, and conserves quantities quadratic in the state. It is symplectic
/// only if the mass matrix is constant and forces do not depend on velocities; otherwise use
/// [`GaussLegendre`]. It is symmetric in time and stable for any stiffness (A-stable), without
/// numerical damping.
///
/// An iteration evaluates the right-hand side K times. Iterations and states within a step are as
/// for [`GaussLegendre`], the latter with an error O(h⁵) for K = 3.
///
/// ```
/// use lagrange::integrate::{GaussLegendre4, integrate};
/// use lagrange::system::OdeSystem;
///
/// /// ẏ = −1000 (y − cos t)
/// struct Stiff;
///
/// impl OdeSystem for Stiff {
///     type Scalar = f64;
///     type State = [f64; 1];
///
///     fn rhs(&self, t: f64, [y]: &[f64; 1]) -> [f64; 1] {
///         [-1000.0 * (y - t.cos())]
///     }
///
///     fn jacobian(&self, _t: f64, _y: &[f64; 1]) -> Option<[[f64; 1]; 1]> {
///         Some([[-1000.0]])
///     }
/// }
///
/// let method = GaussLegendre4 { step: 0.05 }.plain();
/// let [y] = integrate(&Stiff, 0.0, [1.0], 2.0, &method, |_, _| {})?;
/// assert!((y - (2.0_f64.cos() + 1e-3 * 2.0_f64.sin())).abs() < 1e-4);
/// # Ok::<(), lagrange::integrate::IntegrationError<f64, [f64; 1]>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlainGaussLegendre<S, const K: usize> {
    /// Length of a step.
    pub step: S,
}

impl<M: OdeSystem + ?Sized, const K: usize> Method<M> for PlainGaussLegendre<M::Scalar, K>
where
    Tableau<M::Scalar, K>: Coefficients,
{
    fixed_steps! { name::<K>(), 2 * K as u32, Plain<M, K> = Plain::new() }
}

fn name<const K: usize>() -> &'static str {
    match K {
        1 => "implicit midpoint",
        2 => "Gauss–Legendre 4",
        _ => "Gauss–Legendre 6",
    }
}

#[cfg(test)]
mod tests;
