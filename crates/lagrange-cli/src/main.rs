//! The command `lagrange`, which interprets declarations.
#![forbid(unsafe_code)]

use std::env;
use std::process::ExitCode;

fn main() -> ExitCode {
    lagrange_cli::run(env::args_os(), None)
}
