//! Programs and expressions as text in other languages. No algebra happens here.

mod layout;
mod naming;
mod numerals;

pub mod graphviz;
pub mod latex;
pub mod rust_body;
pub mod text;

#[cfg(test)]
mod tests;
