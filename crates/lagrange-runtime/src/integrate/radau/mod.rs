//! Radau IIA of order five with adaptive steps, for stiff systems.
//!
//! The method is collocation at three nodes; the last one is the end of the step. It is stable for
//! any stiffness, and immediately damps infinitely fast motions. The stages follow from Newton's
//! method, whose Jacobian and factors are reused as long as it converges quickly. It starts from
//! the extrapolated polynomial of the last step.
//!
//! The error estimate has order three, and the method has order five. The error of a motion over a
//! given time decreases with the power 5/4 of the estimate. Estimates may therefore exceed a
//! tolerance below 1e-4, up to its power 4/5: by a factor of 2.5 at 1e-6, and of 10 at 1e-9.
//!
//! Sources: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.8; control of
//! steps: Gustafsson, "Control-theoretic techniques for stepsize selection in implicit
//! Runge–Kutta methods", *ACM Transactions on Mathematical Software* 20 (1994) 496–517.

mod control;
mod dense;
mod linear;
mod newton;
mod stepper;
mod tableau;

use crate::integrate::attempt::adaptive_steps;
use crate::integrate::method::Method;
use crate::integrate::verner::tolerance::{Tolerated, check_precision, check_settings};
use crate::scalar::Scalar;
use crate::system::{Domain, OdeSystem, SettingError};

pub use self::stepper::RadauStepper;

/// Radau IIA of order five with adaptive steps, for any system, and in particular for stiff ones.
///
/// A system is stiff if a fast motion has died away and would still limit the steps of an explicit
/// method. Examples are stiff springs with dampers, compliant contacts, friction with bristles, and
/// relaxation oscillations. The error is about `absolute + relative · |y|` in the root mean square
/// over the components of the state.
///
/// It uses the Jacobian of the system, which `emit { jacobian }` provides. Without it, difference
/// quotients replace the Jacobian, with one evaluation for each component. Fast motions without
/// damping require short steps, as with any accurate method.
///
/// ```
/// use lagrange::Simulate;
/// use lagrange::integrate::Radau5;
///
/// lagrange::system! {
///     /// A point mass on a stiff spring with a damper.
///     struct ElasticPendulum;
///     param k = 1e8, c = 2e4, g = 9.81;
///     coord r, theta;
///     kinetic = 1/2 * (dot(r)^2 + r^2 * dot(theta)^2);
///     potential = 1/2 * k * (r - 1)^2 - g * r * cos(theta);
///     dissipation = 1/2 * c * dot(r)^2;
///     emit { jacobian }
/// }
///
/// let pendulum = ElasticPendulum::default();
/// let motion = pendulum.simulate([1.0, 1.0, 0.0, 0.0]).until(10.0).method(Radau5::tolerance(1e-9)).run()?;
/// let [r, theta, ..] = motion.last();
/// assert!((theta + 0.463_255_589).abs() < 1e-7 && (r - 1.000_000_157).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Radau5<S> {
    /// Tolerated error relative to the state.
    pub relative: S,
    /// Tolerated error in the units of the state.
    pub absolute: S,
    /// Length of the first step to try; estimated by default.
    pub first_step: Option<S>,
    /// Maximum step length. The default is a twentieth of the interval from the start to the
    /// current end. While the state is at rest, it is a two-hundredth.
    pub longest_step: Option<S>,
    /// Maximum number of attempted steps, including rejected ones.
    pub max_steps: u64,
}

/// The least tolerance in numbers wider than `f64`, in which the coefficients are.
const LEAST_OF_COEFFICIENTS: f64 = 5e-16;
/// Tolerance above which the error estimate is not relaxed.
const COARSE: f64 = 1e-4;

impl<S: Scalar> Radau5<S> {
    /// Creates the method with this tolerance, relative for a state larger than one, and absolute
    /// for a smaller one.
    pub fn tolerance(tolerance: S) -> Self {
        Radau5 {
            relative: tolerance,
            absolute: tolerance,
            first_step: None,
            longest_step: None,
            max_steps: 100_000_000,
        }
    }

    /// Returns the tolerance, with rounding as the minimum.
    fn tolerated(&self, domain: &'static Domain) -> Tolerated<S> {
        Tolerated::new(self.relative, self.absolute, domain)
    }

    /// Returns the tolerance of estimates.
    fn estimated(&self, domain: &'static Domain) -> Tolerated<S> {
        let Tolerated { relative, absolute, domain } = self.tolerated(domain);
        let loosest = relative.max(absolute);
        let coarse = S::from_f64(COARSE);
        let factor = if loosest < coarse { (coarse / loosest).powf(S::from_f64(0.2)) } else { S::ONE };
        Tolerated { relative: relative * factor, absolute: absolute * factor, domain }
    }
}

impl<M: OdeSystem + ?Sized> Method<M> for Radau5<M::Scalar> {
    adaptive_steps! { "Radau IIA 5", RadauStepper }

    fn order(&self) -> u32 {
        5
    }

    fn check(&self) -> Result<(), SettingError<M::Scalar>> {
        check_precision([self.relative, self.absolute], LEAST_OF_COEFFICIENTS)?;
        check_settings([self.relative, self.absolute], &[self.first_step, self.longest_step])
    }
}
