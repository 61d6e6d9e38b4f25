//! Programs and expressions as text in other languages. No algebra happens here.

mod diagnostics;
mod docs;
mod item;
mod layout;
mod method;
mod naming;
mod numerals;
mod shape;
mod skeleton;
mod system;

pub mod graphviz;
pub mod latex;
pub mod rust_body;
pub mod text;

pub use diagnostics::{diagnostics, report_too_large};
pub use docs::{documentation, equations_latex};
pub use skeleton::skeleton;
pub use system::system;

#[cfg(test)]
mod tests;
