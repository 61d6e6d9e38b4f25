//! The language of `lagrange`: from tokens or text to plain statements.
//!
//! 1. [`syntax`] reads a [`Declaration`](syntax::ast::Declaration), reports all errors together,
//!    and writes it back as text;
//! 2. [`tables`] reads the files of tables and parts, and [`expand`] expands arrays, loops, sums
//!    and parts;
//! 3. [`inline`] replaces calls of declared functions by their bodies;
//! 4. [`dimensions`] checks and converts units;
//! 5. [`bodies`] translates statements about rigid bodies into plain ones.
//!
//! No step differentiates or simplifies: formulas remain syntax.
#![forbid(unsafe_code)]

pub mod bodies;
pub mod dimensions;
pub mod expand;
pub mod inline;
pub mod syntax;
pub mod tables;
