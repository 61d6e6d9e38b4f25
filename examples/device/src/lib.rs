//! Many motions of one system on a graphics processor, a motion a thread.
//!
//! ```no_run
//! use lagrange_device::{Device, RungeKutta4};
//!
//! lagrange::system! {
//!     /// A pendulum.
//!     #[derive(Clone)]
//!     pub struct Pendulum;
//!     param l = 1.0, g = 9.81;
//!     coord theta;
//!     kinetic = 1/2 * (l * dot(theta))^2;
//!     potential = -g * l * cos(theta);
//!     emit { kernel }
//! }
//!
//! let device = Device::open()?;
//! let pendulum = Pendulum::default();
//! let starts = (0..100_000).map(|i| [1e-5 * f64::from(i), 0.0]);
//! let ends = device
//!     .ensemble(&pendulum, starts)
//!     .parameters(|i, pendulum| pendulum.l = 1.0 + 1e-6 * i as f64)
//!     .until(10.0)
//!     .tolerance(1e-9) // or .method(RungeKutta4 { step: 1e-3 })
//!     .run()?;
//! assert_eq!((ends.theta().len(), ends.failures().len()), (100_000, 0));
//! # Ok::<(), lagrange_device::DeviceError>(())
//! ```
//!
//! Systems must declare `emit { kernel }`, which is possible without constraints, contacts,
//! friction and events. Inputs keep their values for a motion. Non-smooth terms, such as `if`, are
//! decided by the state, which lowers the order of methods there. Equal steps pass over such
//! places, and the adaptive pair makes small steps.
//!
//! By default motions are computed in the numbers of the system;
//! [`single_precision`](Ensemble::single_precision) is faster. A device without `f64` causes an
//! error.
//!
//! # What must be installed
//!
//! This crate compiles without further software. At run time a device of NVIDIA needs its driver
//! and NVRTC of the CUDA toolkit (feature `cuda`). Any other device needs the OpenCL driver of its
//! maker (feature `opencl`); `pocl-opencl-icd` computes on processors. [`Device::open`] reports
//! missing parts.
#![deny(unsafe_code)]

#[cfg(not(any(feature = "cuda", feature = "opencl")))]
compile_error!("lagrange-device needs one of its features `cuda` and `opencl`");

mod backend;
mod device;
mod ends;
mod ensemble;
mod error;
mod number;
#[cfg(test)]
mod tests;

pub use device::Device;
pub use ends::{Ends, Failure, States};
pub use ensemble::{Ensemble, Motions};
pub use error::DeviceError;
pub use lagrange_runtime::integrate::RungeKutta4;
pub use number::DeviceNumber;
