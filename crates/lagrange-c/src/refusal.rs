//! Systems that cannot be written as C or JavaScript.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use lagrange_core::opaque::Opaque;
use lagrange_core::pipeline::Programs;

/// The reason why a system is not written as C or JavaScript.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Refusal {
    /// The system declares rigid contacts or friction with these names.
    Touching(Vec<String>),
    /// The system delays signals, the inputs with these names.
    Delays(Vec<String>),
    /// The system calls these functions of the user's crate.
    Functions(Vec<String>),
    /// Noise with these names acts on the system.
    Noise(Vec<String>),
    /// Some of these constraints always follow from others.
    Redundant(Vec<String>),
    /// These constants are outside the range of `double`.
    Constants(Vec<String>),
}

impl Display for Refusal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Touching(names) => {
                let instead = "compliant contacts, with a `stiffness`, run here, too";
                let run = "run in Rust, on the command line and in Python only";
                write!(f, "rigid contacts and friction {run} ({instead}): {}", quoted(names))
            }
            Refusal::Delays(names) => {
                let runs = "compiled Rust, the command `lagrange simulate` and Python keep it";
                write!(f, "delayed signals need a past, which is not kept here ({runs}): {}", quoted(names))
            }
            Refusal::Functions(names) => {
                write!(f, "functions of a crate are known to compiled Rust only: {}", quoted(names))
            }
            Refusal::Noise(names) => {
                write!(
                    f,
                    "white noise runs in compiled Rust and by `lagrange simulate` only: {}",
                    quoted(names)
                )
            }
            Refusal::Redundant(names) => write!(
                f,
                "some constraints always follow from others, which written code does not solve: {}",
                quoted(names)
            ),
            Refusal::Constants(constants) => {
                write!(f, "constants are out of the range of `double`: {}", constants.join(", "))
            }
        }
    }
}

impl Error for Refusal {}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// Checks that a system can be written.
pub(crate) fn check(programs: &Programs) -> Result<(), Refusal> {
    let (variables, functions) = (&programs.variables, programs.functions());
    if !variables.touching.is_empty() {
        return Err(Refusal::Touching(variables.touching.clone()));
    }
    if !programs.noises.is_empty() {
        return Err(Refusal::Noise(programs.noises.clone()));
    }
    if !variables.delayed.is_empty() {
        return Err(Refusal::Delays(variables.delayed.clone()));
    }
    if !functions.is_empty() {
        return Err(Refusal::Functions(functions.iter().map(Opaque::rust_name).collect()));
    }
    match programs.is_redundant {
        true => Err(Refusal::Redundant(variables.constraints.clone())),
        false => Ok(()),
    }
}
