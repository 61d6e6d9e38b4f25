//! Everything of `lagrange` that happens at compile time.
#![forbid(unsafe_code)]

pub mod calculus;
pub mod collections;
pub mod diagnostics;
pub mod emit;
pub mod expr;
pub mod functions;
pub mod mechanics;
pub mod number;
pub mod pipeline;
pub mod program;
pub mod simplify;
pub mod symbol;
pub mod syntax;
