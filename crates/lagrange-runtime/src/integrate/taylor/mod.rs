//! Taylor series with adaptive steps.
//!
//! Each step expands the motion about its state and follows the polynomial. Its length is
//! determined by the size of the last coefficients. The expansion at its end, from which the next
//! step starts, provides the exact rate there. If the slope of the polynomial differs from it by
//! more than the tolerance, the step is reverted and halved.
//!
//! Sources: Jorba and Zou, "A software package for the numerical integration of ODEs by means of
//! high-order Taylor methods", *Experimental Mathematics* 14 (2005) 99–117. They use two
//! coefficients. If coefficients vanish in turn, as for a double pendulum that starts at rest at
//! right angles, four coefficients and the check at the end are necessary.

mod expansion;
mod lanes;
mod polynomial;
mod rule;
mod stepper;
mod stiffness;
mod widest;

use crate::integrate::attempt::adaptive_steps;
use crate::integrate::method::{LanesMethodVisitor, Method};
use crate::integrate::verner::tolerance::check_settings;
use crate::scalar::Scalar;
use crate::system::{MAX_ORDER, SettingError, TaylorSystem};

pub use self::stepper::TaylorStepper;

/// Taylor series with adaptive steps, for non-stiff systems that declare `emit { taylor }`.
///
/// The last terms of the series are at most a hundredth of `absolute + relative · |y|` in each
/// component. States within a step are as accurate as its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Taylor<S> {
    /// Tolerated error of a step relative to the state.
    pub relative: S,
    /// Tolerated error of a step in the units of the state.
    pub absolute: S,
    /// Order of the series, from 4 to [`MAX_ORDER`](crate::system::MAX_ORDER). By default it is
    /// chosen according to the tolerance, and lower for systems of many products.
    pub order: Option<usize>,
    /// Maximum step length. The default is a quarter of the interval from the start to the end
    /// known there. While the state is at rest, it is a two-hundredth, since the series does not
    /// reveal later changes.
    pub longest_step: Option<S>,
    /// Maximum number of attempted steps, including rejected ones.
    pub max_steps: u64,
    /// True if the integration should fail when stability rather than the tolerance limits the
    /// steps.
    pub refuses_stiff: bool,
    /// True if products and sums are rounded once where the processor can, which is faster.
    /// Otherwise, a single motion has the same bits on all processors of a target. True by default.
    pub fused: bool,
}

/// The order for the tightest tolerance in double precision, where higher orders cost more than
/// they save.
const HIGHEST_CHOSEN: usize = 32;
/// The order for the loosest tolerance.
const LOWEST_CHOSEN: usize = 8;
/// Number of groups of products whose sums take little of the time of an order.
const SMALL: usize = 8;
/// The part of the time of an order that sums of many groups take, divided by the order.
const SUMS_OF_LARGE: f64 = 0.02;
/// The lowest permitted order: the length of steps depends on four coefficients.
const LOWEST: usize = 4;

impl<S: Scalar> Taylor<S> {
    /// Creates the method with this tolerance, relative for a state larger than one, and absolute
    /// for a smaller one.
    pub fn tolerance(tolerance: S) -> Self {
        Taylor {
            relative: tolerance,
            absolute: tolerance,
            order: None,
            longest_step: None,
            max_steps: 100_000_000,
            refuses_stiff: true,
            fused: true,
        }
    }

    /// Returns the larger tolerance.
    fn loosest(&self) -> S {
        self.relative.max(self.absolute)
    }

    /// Returns the order of the series of a system with this number of groups of products: about
    /// −ln of the tolerance plus three. This is the cheapest choice if the cost of a step grows
    /// with the order p, as in small systems.
    ///
    /// If the cost grows with p (1 + β p) instead, the cheapest p solves p + β p²/(1 + β p) = L,
    /// where L is that choice. Sums take a quarter of the time of a large system at order 16, thus
    /// β ≈ 0.02. Six planets have 35 groups: L = 24 then leads to order 20.
    fn chosen_order(&self, groups: usize) -> usize {
        let length = S::from_f64(3.0) - self.loosest().ln();
        let large = 1.0 - SMALL as f64 / groups.max(SMALL) as f64;
        let growth = S::from_f64(SUMS_OF_LARGE * large) * length;
        let rest = S::ONE - growth;
        let root = (rest * rest + S::from_f64(8.0) * growth).sqrt();
        self.order_for((length + length) / (rest + root))
    }

    /// Returns the order of the series in lanes, where the cost grows with the square of the order.
    fn order_in_lanes(&self) -> usize {
        self.order_for(S::from_f64(4.0) - S::from_f64(0.55) * self.loosest().ln())
    }

    /// Returns the order of the settings, otherwise about this one.
    fn order_for(&self, wanted: S) -> usize {
        self.order.unwrap_or_else(|| {
            let is_wide = S::epsilon() < S::from_f64(f64::EPSILON);
            let highest = if is_wide { MAX_ORDER } else { HIGHEST_CHOSEN };
            let mut order = LOWEST_CHOSEN;
            while S::from_f64(order as f64) < wanted && order < highest {
                order += 1;
            }
            order
        })
    }
}

impl<M: TaylorSystem + ?Sized> Method<M> for Taylor<M::Scalar> {
    adaptive_steps! { "Taylor series", TaylorStepper }

    fn order(&self) -> u32 {
        self.chosen_order(0) as u32
    }

    fn check(&self) -> Result<(), SettingError<M::Scalar>> {
        if self.order.is_some_and(|order| !(LOWEST..=MAX_ORDER).contains(&order)) {
            return Err(SettingError::Invalid("the order of Taylor series must be between 4 and 40"));
        }
        check_settings([self.relative, self.absolute], &[self.longest_step])
    }

    fn in_lanes<V: LanesMethodVisitor<M::Scalar>>(&self, visitor: V) -> Result<V::Output, V> {
        if M::IN_LANES { Ok(visitor.visit(*self)) } else { Err(visitor) }
    }
}
