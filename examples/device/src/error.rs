//! Errors that occur before motions begin, or that concern all of them.

use std::fmt;

/// The reason why a device computed nothing.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum DeviceError {
    /// There is no usable device; the reasons, one for each API.
    NotFound(Vec<String>),
    /// The device has no numbers of double precision.
    NoDoublePrecision {
        /// Name of the device.
        device: String,
    },
    /// An invalid setting, in words.
    Setting(&'static str),
    /// The compiler of the device refused the text.
    Build {
        /// Name of the device.
        device: String,
        /// Output of its compiler.
        log: String,
    },
    /// The driver refused to do something.
    Driver {
        /// Name of the device.
        device: String,
        /// Task of the device, in words.
        task: &'static str,
        /// Message of the driver.
        reason: String,
    },
}

impl fmt::Display for DeviceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DeviceError::NotFound(tried) => write!(f, "no device: {}", tried.join("; ")),
            DeviceError::NoDoublePrecision { device } => {
                write!(f, "{device} does not support double precision: call `.single_precision()`")
            }
            DeviceError::Setting(words) => f.write_str(words),
            DeviceError::Build { device, log } => {
                write!(f, "the compiler of {device} rejects the kernel:\n{log}")
            }
            DeviceError::Driver { device, task, reason } => write!(f, "{device} cannot {task}: {reason}"),
        }
    }
}

impl std::error::Error for DeviceError {}
