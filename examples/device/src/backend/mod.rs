//! APIs that lead to a device: OpenCL and CUDA.

#[cfg(feature = "cuda")]
mod cuda;
#[cfg(feature = "opencl")]
mod opencl;
mod work;

pub(crate) use self::work::{Method, Status, Work};

use crate::error::DeviceError;

/// A device under one of the two APIs.
pub(crate) trait Backend: Run<f64> + Run<f32> {
    fn description(&self) -> &Description;
}

/// Computation of motions in numbers of a type.
pub(crate) trait Run<T> {
    /// Computes all motions by the kernel in a text.
    fn run(&self, text: &str, work: &mut Work<T>) -> Result<(), DeviceError>;
}

/// The name and abilities of a device.
pub(crate) struct Description {
    pub(crate) name: String,
    /// True for a graphics processor, false for a processor that emulates one.
    pub(crate) is_graphics: bool,
    pub(crate) has_doubles: bool,
}

/// The devices of one API, or the reason why there are none.
type Found = Result<Vec<Box<dyn Backend>>, String>;

/// Returns all devices, and the reasons why there are no others.
pub(crate) fn devices() -> (Vec<Box<dyn Backend>>, Vec<String>) {
    let ways: &[fn() -> Found] = &[
        #[cfg(feature = "cuda")]
        cuda::devices,
        #[cfg(feature = "opencl")]
        opencl::devices,
    ];
    let (mut found, mut missing) = (Vec::new(), Vec::new());
    for way in ways {
        match way() {
            Ok(devices) => found.extend(devices),
            Err(reason) => missing.push(reason),
        }
    }
    (found, missing)
}

/// Threads of a group; the number of threads is a multiple of it.
const GROUP: u32 = 64;

/// Number of steps per call, small enough for devices that also drive a screen and abort calls of
/// several seconds.
const BUDGET: u32 = 1000;
