//! Declarations as the user writes them.
pub mod ast;
