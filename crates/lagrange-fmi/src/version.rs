//! Versions of the standard, and their differences.

use std::env::consts::{ARCH, OS};

/// A version of the standard.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Version {
    /// Version 2.0, supported by most programs.
    #[default]
    Two,
    /// Version 3.0.
    Three,
}

impl Version {
    /// Returns the version number in descriptions.
    #[must_use]
    pub fn number(self) -> &'static str {
        match self {
            Version::Two => "2.0",
            Version::Three => "3.0",
        }
    }

    /// Returns names and texts of the sources specific to this version.
    pub(crate) fn sources(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Version::Two => &[
                ("fmi2.c", include_str!("../sources/fmi2.c")),
                ("fmi2.h", include_str!("../sources/fmi2.h")),
            ],
            Version::Three => &[
                ("fmi3.c", include_str!("../sources/fmi3.c")),
                ("fmi3.h", include_str!("../sources/fmi3.h")),
                ("absent.h", include_str!("../sources/absent.h")),
            ],
        }
    }

    /// Returns folder and extension of libraries for this machine.
    pub(crate) fn platform(self) -> Option<(&'static str, &'static str)> {
        let (system, extension) = match OS {
            "linux" => ("linux", "so"),
            "macos" => ("darwin", "dylib"),
            "windows" => ("windows", "dll"),
            _ => return None,
        };
        let folder = match (self, system, ARCH) {
            (Version::Two, "linux", "x86_64") => "linux64",
            (Version::Two, "linux", "x86") => "linux32",
            (Version::Two, "darwin", _) => "darwin64",
            (Version::Two, "windows", "x86_64") => "win64",
            (Version::Two, "windows", "x86") => "win32",
            (Version::Three, "linux", "x86_64") => "x86_64-linux",
            (Version::Three, "linux", "x86") => "x86-linux",
            (Version::Three, "linux", "aarch64") => "aarch64-linux",
            (Version::Three, "darwin", "x86_64") => "x86_64-darwin",
            (Version::Three, "darwin", "aarch64") => "aarch64-darwin",
            (Version::Three, "windows", "x86_64") => "x86_64-windows",
            (Version::Three, "windows", "x86") => "x86-windows",
            (Version::Three, "windows", "aarch64") => "aarch64-windows",
            _ => return None,
        };
        Some((folder, extension))
    }
}
