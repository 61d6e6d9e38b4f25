//! Systems as C modules, a header and a source file that need only the standard library, and as
//! JavaScript functions.
//!
//! All functions have one signature, `void NAME_rhs(double t, const double *y, const double *p,
//! double *out)`. The time is `t`. The state `y` holds positions, then velocities; `p` holds
//! parameters, then inputs; `out` receives the results. Numbers are in coherent units. The text is
//! C99. Names, units, defaults and sizes are arrays and macros.
//!
//! The operations are those of the interpreter. Results are bit-identical given the same elementary
//! functions, and without contraction of products and sums. A [`Script`] has the same functions
//! with the same arguments, `system_rhs(t, y, p, out)`.
//!
//! ```
//! use lagrange_c::Module;
//! use lagrange_core::derive::StrategyChoice;
//! use lagrange_core::pipeline::{Programs, parse};
//!
//! let swing = "struct Swing; param l: m = 2, g: m/s^2 = 9.81; coord theta: rad = 0.5;
//!     kinetic = 1/2 * (1 [kg]) * (l * dot(theta))^2; potential = -(1 [kg]) * g * l * cos(theta);";
//! let derived = parse(swing)?.derive(StrategyChoice::Cheapest)?;
//! let module = Module::new(&Programs::new(&derived), None)?;
//! assert_eq!(module.name, "swing");
//! assert!(module.header.contains("void swing_rhs(double t, const double *y, const double *p, double *out);"));
//! assert!(module.source.starts_with("#include \"swing.h\""));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod arrays;
mod bodies;
mod callables;
mod functions;
mod header;
mod names;
mod refusal;
mod script;
mod source;
mod syntax;

use lagrange_core::pipeline::Programs;

use functions::functions;
use names::identifier;

pub use refusal::Refusal;
pub use script::Script;

/// A C module.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Module {
    /// Prefix of all names, the name of the struct in lower case.
    pub name: String,
    /// Header: sizes, arrays and functions, with their units.
    pub header: String,
    /// Source file, which includes the header.
    pub source: String,
}

impl Module {
    /// Writes a module. The header is included as `stem.h`; without a stem, the name of the struct
    /// is used.
    ///
    /// # Errors
    /// If the system has parts that only compiled Rust can run, or a constant is too large.
    pub fn new(programs: &Programs, stem: Option<&str>) -> Result<Module, Refusal> {
        refusal::check(programs)?;
        let name = identifier(&programs.name);
        let functions = functions(programs);
        let header = header::header(&name, programs, &functions);
        let source = source::source(&name, stem.unwrap_or(&name), programs, &functions)?;
        Ok(Module { name, header, source })
    }
}
