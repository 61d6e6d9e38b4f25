//! Parameters from data: nonlinear least squares along motions.
//!
//! Parameters, inputs of constant value and initial values vary until a motion is closest to
//! measured columns. The sum of squares of residuals, each divided by its noise level, is then
//! smallest. Derivatives are those of
//! [`sensitivities`](crate::simulate::Simulation::sensitivities).
//!
//! ```
//! use lagrange::fit::{Data, Fits};
//!
//! lagrange::system! {
//!     #[derive(Clone, Debug)]
//!     struct Oscillator;
//!     param m = 1.0, k = 1.0, c = 0.0;
//!     coord x;
//!     kinetic = 1/2 * m * dot(x)^2;
//!     potential = 1/2 * k * x^2;
//!     dissipation = 1/2 * c * dot(x)^2;
//!     emit { jacobian }
//! }
//!
//! // x = exp(−t/10) cos(2 t), which belongs to k = 4.01 and c = 0.2.
//! let times: Vec<f64> = (0..50).map(|i| 0.1 * f64::from(i)).collect();
//! let x: Vec<f64> = times.iter().map(|t| (-0.1 * t).exp() * (2.0 * t).cos()).collect();
//! let data = Data::new(times).with("x", x);
//!
//! let oscillator = Oscillator::default();
//! let fitted = oscillator.fit([1.0, -0.1], data).vary("k", 0.1..=10.0).vary("c", 0.0..).run()?;
//! assert!((fitted.value("k").unwrap() - 4.01).abs() < 1e-7);
//! assert!((fitted.value("c").unwrap() - 0.2).abs() < 1e-7);
//! println!("{fitted}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What data do not tell
//!
//! Masses and stiffnesses of an oscillator may all be doubled without a change of its motion. A fit
//! that varies both ends with [`FitError::Undetermined`], which names the combination. If data
//! determine all combinations, the report names the least determined one.
//!
//! # Noise
//!
//! With a [noise level](FitSearch::noise) for every column, standard errors follow from the levels.
//! χ² per degree of freedom is about one if model and levels are correct. A single column needs no
//! level: it is then estimated from the residuals.
//!
//! Sources: Nocedal, Wright, *Numerical Optimization*, 2nd ed., §10.3; Moré, "The
//! Levenberg–Marquardt algorithm", 1978; Madsen, Nielsen, Tingleff, *Methods for Non-Linear Least
//! Squares Problems*, 2nd ed., 2004, §3.2; Seber, Wild, *Nonlinear Regression*, §2.1, §3.3.

mod builder;
mod csv;
mod data;
mod error;
mod fitted;
mod least_squares;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(feature = "plot")]
mod plots;
mod problem;
mod progress;
mod starts;

pub use self::builder::FitSearch;
pub use self::data::{Data, DataError};
pub use self::error::FitError;
pub use self::fitted::{Fitted, FittedValue};
pub use self::progress::FitProgress;
pub use crate::linalg::dense::DenseMatrix;

use crate::integrate::Verner98;
use crate::simulate::{InitialState, Undriven};
use crate::system::ParametricSystem;

/// Fits of systems to data.
pub trait Fits: ParametricSystem<Scalar = f64> {
    /// Starts a fit to data, of motions that start from a state at the first time of the data.
    /// Continue with [`vary`](FitSearch::vary) and [`run`](FitSearch::run).
    fn fit(
        &self,
        start: impl InitialState<Self::State>,
        data: Data,
    ) -> FitSearch<'_, Self, Verner98<f64>, Undriven> {
        FitSearch::new(self, start.into_state(), data)
    }
}

impl<M: ParametricSystem<Scalar = f64>> Fits for M {}
