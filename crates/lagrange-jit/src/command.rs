//! The command `lagrange` with machine code instead of the interpreter.
#![forbid(unsafe_code)]

use std::env;
use std::process::ExitCode;
use std::sync::Arc;

use lagrange_core::pipeline::Backend;
use lagrange_jit::Compiler;

fn main() -> ExitCode {
    match Compiler::for_this_processor() {
        Ok(compiler) => {
            let backend: Arc<dyn Backend> = compiler;
            lagrange_cli::run(env::args_os(), Some(&backend))
        }
        Err(error) => {
            eprintln!("error: {error}; `lagrange` of the crate `lagrange-cli` interprets declarations");
            ExitCode::FAILURE
        }
    }
}
