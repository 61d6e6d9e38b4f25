//! Inertial parameters from measured forces, and which combinations of them forces determine.
//!
//! The inverse dynamics τ = Y π + τ₀ is linear in the parameters π of [`RegressorSystem`]. States
//! with measured generalised forces therefore give linear equations. Some parameters have no
//! effect, and others act only in combinations, the *base parameters*. Forces tell these and
//! nothing else.
//!
//! ```
//! use lagrange::identification::Identifies;
//!
//! lagrange::system! {
//!     /// Two rods in a vertical plane.
//!     struct Arm;
//!     param m2 = 3.0, c = 0.2;
//!     gravity = (0, -10);
//!     body upper { mass: 2; inertia: 0.1; centroid: (0.5, 0); }
//!     revolute a = ground to upper { damping: c; }
//!     body lower { mass: m2; inertia: 0.2; centroid: (0.4, 0); }
//!     revolute b = upper to lower { at: (1, 0); }
//!     emit { regressor }
//! }
//!
//! // The mass of the lower rod acts as one at the joint, at the end of the upper rod.
//! let base = Arm::default().base_parameters()?;
//! let names: Vec<String> = base.parameters().iter().map(ToString::to_string).collect();
//! assert_eq!(names, ["upper.mx + lower.mass", "upper.my", "upper.zz + lower.mass", "lower.mx", "lower.my", "lower.zz", "c"]);
//!
//! // Forces of a heavier arm are measured, and estimated is what makes them.
//! let (arm, heavier) = (Arm::default(), Arm { m2: 4.0, c: 0.3 });
//! let mut regression = arm.regression();
//! for step in 0..20 {
//!     let t = 0.1 * f64::from(step);
//!     let (q, v, a) = ([t.sin(), (2.0 * t).cos()], [t.cos(), -2.0 * (2.0 * t).sin()], [-t.sin(), -4.0 * (2.0 * t).cos()]);
//!     regression.add(t, &q, &v, &a, &heavier.inverse_dynamics(t, &q, &v, &a));
//! }
//! let estimate = regression.estimate()?;
//! let found = estimate.value("c").unwrap();
//! assert!((found - 0.3).abs() < 1e-13);
//! println!("{estimate}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Base parameters
//!
//! Columns of the regressors of many states are factored, which tells the independent ones. Each
//! dependent column adds a multiple of its parameter to combinations. Columns in front are taken as
//! independent if they can, those of masses last. Parameters of a body therefore join those of the
//! body that carries it.
//!
//! # Noise
//!
//! Forces of joints have noise of different levels and units. Those of each velocity are weighed by
//! the noise that their residuals show, in repeated estimates until it no longer changes. Standard
//! errors follow from these levels. They hold if the noise of forces is independent, and that of
//! states is much smaller. The estimate is not forced to belong to positive masses.
//!
//! Sources: Gautier, "Numerical calculation of the base inertial parameters of robots", J. Robotic
//! Systems 8 (1991); Khalil, Dombre, *Modeling, Identification and Control of Robots*, §12.5,
//! §12.6.

mod base;
mod error;
mod estimate;
mod regression;

pub use self::base::{BaseParameter, BaseParameters};
pub use self::error::IdentificationError;
pub use self::estimate::{Estimate, EstimatedValue};
pub use self::regression::Regression;

use crate::system::RegressorSystem;

/// Identifies parameters of systems in `f64` from forces.
pub trait Identifies: RegressorSystem<Scalar = f64> + Sized {
    /// Finds the combinations of parameters that forces determine in any motion, from states that
    /// look random. Positions, velocities, accelerations and times are within ±3 in units of the
    /// declaration. States in which the system is not defined are left out. Inputs keep the values
    /// that they have: what an input multiplies has no effect while it is zero.
    ///
    /// # Errors
    /// If a parameter is not finite, or the system is defined in none of these states.
    fn base_parameters(&self) -> Result<BaseParameters, IdentificationError> {
        let mut regression = self.regression();
        regression.add_spread_states()?;
        regression.base_parameters()
    }

    /// Starts a regression of measured forces. Continue with [`add`](Regression::add) and
    /// [`estimate`](Regression::estimate).
    fn regression(&self) -> Regression<'_, Self> {
        Regression::new(self)
    }
}

impl<M: RegressorSystem<Scalar = f64>> Identifies for M {}
