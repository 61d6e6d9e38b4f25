//! Numbers that devices compute with.

use lagrange_runtime::Scalar;
use lagrange_runtime::system::KernelSystem;

/// A number of devices: `f64` or `f32`.
pub trait DeviceNumber: Scalar + sealed::Sealed {
    /// Converts to double precision.
    fn to_f64(self) -> f64;
}

pub(crate) mod sealed {
    /// A bound that only this crate implements.
    pub trait Sealed {
        /// True if motions of systems in these numbers are computed in single precision by default.
        const IS_SINGLE: bool;
    }
}

impl sealed::Sealed for f64 {
    const IS_SINGLE: bool = false;
}

impl DeviceNumber for f64 {
    fn to_f64(self) -> f64 {
        self
    }
}

impl sealed::Sealed for f32 {
    const IS_SINGLE: bool = true;
}

impl DeviceNumber for f32 {
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
}

/// The precision of a device.
pub(crate) trait Precision: DeviceNumber {
    /// The error tolerated by default.
    const TOLERANCE: f64;
    /// The smallest relative error that may be set.
    const LEAST_TOLERANCE: f64;

    /// Returns the equations of motion of a system.
    fn text<M: KernelSystem>() -> &'static str;
}

impl Precision for f64 {
    const TOLERANCE: f64 = 1e-9;
    const LEAST_TOLERANCE: f64 = 1e-14;

    fn text<M: KernelSystem>() -> &'static str {
        M::KERNEL_F64
    }
}

impl Precision for f32 {
    const TOLERANCE: f64 = 1e-5;
    const LEAST_TOLERANCE: f64 = 1e-6;

    fn text<M: KernelSystem>() -> &'static str {
        M::KERNEL_F32
    }
}
