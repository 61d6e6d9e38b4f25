//! Machine code of declarations read at run time, by [Cranelift](https://cranelift.dev).
//!
//! The [`Compiler`] plugs into `lagrange-core` and everything above it: it compiles the
//! [`Program`]s of a system on their first run. Results are bit-identical to the interpreter. No
//! simulation code is duplicated.
//!
//! ```
//! use lagrange_core::derive::StrategyChoice;
//! use lagrange_core::pipeline::{NumericSystem, parse};
//! use lagrange_jit::Compiler;
//!
//! let swing = "coord theta; kinetic = 1/2 * dot(theta)^2; potential = -9.81 * cos(theta);";
//! let interpreted = NumericSystem::new(&parse(swing)?.derive(StrategyChoice::Cheapest)?);
//! let compiled = interpreted.clone().compiled_by(Compiler::for_this_processor()?);
//! assert_eq!(compiled.acceleration(0.0, &[0.3], &[0.0]), interpreted.acceleration(0.0, &[0.3], &[0.0]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Products, sums, quotients, roots, magnitudes and conditions are instructions. Other elementary
//! functions are calls of the functions that the interpreter calls. Tables and solutions of
//! equations are computed by the functions of the interpreter, too: compiled code calls them back.
//! The sign and payload of NaN may differ; no operation here depends on them.
//!
//! All code without the checks of the Rust compiler is in one file, `machine.rs`.
#![deny(unsafe_code)]

mod machine;
mod translate;

use std::error::Error;
use std::fmt::{self, Debug, Display, Formatter};
use std::sync::Arc;

use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use cranelift_codegen::{CodegenError, Context};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{Module, ModuleError, default_libcall_names};
use lagrange_core::pipeline::{Backend, Call, Code, Layout};
use lagrange_core::program::Program;

use machine::{Machine, Taken};
use translate::{Translation, signature};

/// Limit on the values, operands and outputs of a program that is compiled. Each value may take
/// eight bytes of the stack, and the time to assign registers grows faster than the size.
pub const LARGEST_PROGRAM: usize = 30_000;

/// Settings of Cranelift. It does not optimise: programs are optimised before, so that their code
/// would take longer to make and run no faster. Frames of more than a page touch each of their
/// pages, so that a full stack is noticed.
const SETTINGS: [(&str, &str); 5] = [
    ("opt_level", "none"),
    ("is_pic", "false"),
    ("use_colocated_libcalls", "false"),
    ("enable_probestack", "true"),
    ("probestack_strategy", "inline"),
];

/// A compiler of programs for the current processor.
#[derive(Clone)]
pub struct Compiler {
    isa: OwnedTargetIsa,
}

/// The reason why a program has no machine code.
#[derive(Debug)]
#[non_exhaustive]
pub enum CompileError {
    /// Cranelift does not support this processor.
    Processor(String),
    /// The program has more values, operands and outputs than [`LARGEST_PROGRAM`].
    TooLarge(usize),
    /// Cranelift failed.
    Cranelift(Box<ModuleError>),
}

impl Display for CompileError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            CompileError::Processor(reason) => write!(f, "no machine code for this processor: {reason}"),
            CompileError::TooLarge(size) => {
                let parts = "values, operands and outputs";
                write!(f, "a program of {size} {parts} is not compiled: the limit is {LARGEST_PROGRAM}")
            }
            CompileError::Cranelift(error) => write!(f, "no machine code: {error}"),
        }
    }
}

impl Error for CompileError {}

impl From<ModuleError> for CompileError {
    fn from(error: ModuleError) -> Self {
        CompileError::Cranelift(Box::new(error))
    }
}

impl From<CodegenError> for CompileError {
    fn from(error: CodegenError) -> Self {
        ModuleError::from(error).into()
    }
}

impl Debug for Compiler {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "Compiler({})", self.isa.triple())
    }
}

impl Compiler {
    /// Returns the compiler for the current processor.
    ///
    /// # Errors
    /// If Cranelift does not support the processor.
    pub fn for_this_processor() -> Result<Arc<Compiler>, CompileError> {
        let mut flags = settings::builder();
        for (name, value) in SETTINGS {
            flags.set(name, value).map_err(|error| CompileError::Processor(error.to_string()))?;
        }
        let isa = cranelift_native::builder().map_err(|reason| CompileError::Processor(reason.to_owned()))?;
        Ok(Arc::new(Compiler { isa: isa.finish(settings::Flags::new(flags))? }))
    }

    /// Compiles a program whose arguments have the places of a layout; `call` computes solutions of
    /// equations.
    ///
    /// # Errors
    /// If the program is too large, or Cranelift fails.
    pub fn code(
        &self,
        program: &Program,
        layout: &Layout,
        call: &Call,
    ) -> Result<impl Code + use<>, CompileError> {
        let size = size(program);
        if size > LARGEST_PROGRAM {
            return Err(CompileError::TooLarge(size));
        }
        let mut module = JITModule::new(JITBuilder::with_isa(self.isa.clone(), default_libcall_names()));
        let mut context = module.make_context();
        context.func.signature = signature(&*self.isa);
        let entry = module.declare_anonymous_function(&context.func.signature)?;
        let translation = self.translated(&mut context, program, layout, call);
        module.define_function(entry, &mut context)?;
        module.finalize_definitions()?;
        Ok(Machine::new(module, entry, translation))
    }

    fn translated(&self, context: &mut Context, program: &Program, layout: &Layout, call: &Call) -> Taken {
        let mut shared = FunctionBuilderContext::new();
        let mut builder = FunctionBuilder::new(&mut context.func, &mut shared);
        let taken = Translation::new(&mut builder, program, layout, call).run();
        builder.finalize(self.isa.frontend_config());
        taken
    }
}

impl Backend for Compiler {
    fn compile(&self, program: &Program, layout: &Layout, call: &Call) -> Option<Box<dyn Code>> {
        Some(Box::new(self.code(program, layout, call).ok()?))
    }
}

/// Returns the number of values, operands and outputs.
fn size(program: &Program) -> usize {
    let mut operands = 0;
    program.values().for_each(|(_, op)| op.for_each_operand(|_| operands += 1));
    program.len() + operands + program.outputs().len()
}
