//! `lagrange`: declarations of mechanical systems on the command line.
//!
//! A file contains the input of `lagrange::system!`. `lagrange check` lists its errors in the style
//! of the compiler. `lagrange equations` writes its equations of motion, and `lagrange rust` the
//! code of the macro. `lagrange simulate` computes a motion without a compiler, `lagrange film`
//! films it, `lagrange ensemble` computes many, and `lagrange linearise` computes a linear model.
//! `lagrange urdf` writes the declaration of a robot. `lagrange watch` reruns a command when its
//! files change. `lagrange --help` lists everything.
//!
//! The command is [`run`] without a backend, which interprets. `lagrange-jit` has the same command
//! with machine code.
#![forbid(unsafe_code)]

mod analyses;
mod arguments;
mod commands;
mod console;
mod ensembles;
mod help;
mod meter;
mod mistakes;
mod motions;
mod source;
mod trades;
mod values;
mod watch;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;
use std::sync::Arc;

use lagrange_core::pipeline::Backend;

use arguments::{Request, read_arguments};
use commands::Ended;
use console::{answer, report};
use help::HELP;
use watch::watch;

/// Exit code if files have errors.
const MISTAKES: u8 = 1;
/// Exit code of an invalid command.
const USAGE: u8 = 2;
/// Exit code if a motion failed before its end, or a state has no linear model.
const EARLY: u8 = 3;

/// Runs the command with these arguments, of which the first is the name of the program. A backend
/// compiles the programs of motions; without it they are interpreted, with the same results.
pub fn run(arguments: impl IntoIterator<Item = OsString>, backend: Option<&Arc<dyn Backend>>) -> ExitCode {
    let arguments = arguments.into_iter().collect::<Vec<_>>();
    match read_arguments(lexopt::Parser::from_iter(arguments), backend) {
        Ok(Request::Help) => printed(HELP),
        Ok(Request::Version) => {
            let compiles = if backend.is_some() { ", with machine code" } else { "" };
            printed(&format!("lagrange {}{compiles}\n", env!("CARGO_PKG_VERSION")))
        }
        Ok(Request::Watch(command)) => watch(&command),
        Ok(Request::Command(command)) => match command.run() {
            Ended::Well => ExitCode::SUCCESS,
            Ended::WithMistakes => ExitCode::from(MISTAKES),
            Ended::Misused => ExitCode::from(USAGE),
            Ended::Early => ExitCode::from(EARLY),
        },
        Err(error) => {
            report(&format!("error: {error}\n\nfor all commands, write `lagrange --help`\n"));
            ExitCode::from(USAGE)
        }
    }
}

fn printed(text: &str) -> ExitCode {
    match answer(|output| output.write_all(text.as_bytes())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            report(&format!("error: {message}\n"));
            ExitCode::from(MISTAKES)
        }
    }
}
