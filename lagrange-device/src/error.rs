//! What can go wrong before motions begin, or with all of them.

use std::fmt;

/// Why a device computed nothing.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum DeviceError {
    /// There is no device that can be used; why, for each of the ways that were tried.
    NotFound(Vec<String>),
    /// The device has no numbers of double precision.
    NoDoublePrecision {
        /// What it is called.
        device: String,
    },
    /// A setting that makes no sense, in words.
    Setting(&'static str),
    /// The compiler of the device refused the text.
    Build {
        /// What the device is called.
        device: String,
        /// What its compiler says.
        log: String,
    },
    /// The driver refused to do something.
    Driver {
        /// What the device is called.
        device: String,
        /// What it was to do, in words.
        task: &'static str,
        /// What the driver says.
        reason: String,
    },
}

impl fmt::Display for DeviceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DeviceError::NotFound(tried) => write!(f, "no device: {}", tried.join("; ")),
            DeviceError::NoDoublePrecision { device } => {
                write!(f, "{device} has no numbers of double precision: ask for `.single_precision()`")
            }
            DeviceError::Setting(words) => f.write_str(words),
            DeviceError::Build { device, log } => {
                write!(f, "the compiler of {device} refuses the kernel:\n{log}")
            }
            DeviceError::Driver { device, task, reason } => write!(f, "{device} cannot {task}: {reason}"),
        }
    }
}

impl std::error::Error for DeviceError {}
