//! Methods that advance a system ẏ = f(t, y) in time.
//!
//! One file per family of methods, each citing its tableau. They take anything that implements
//! [`OdeSystem`](crate::system::OdeSystem), need no heap, run forwards or backwards in time, and stop with
//! an [`IntegrationError`] instead of passing on NaN or infinity.

mod compensated;
mod error;
mod rk4;

pub use self::error::IntegrationError;
pub use self::rk4::{rk4, rk4_step};
