//! Expressions as text, LaTeX and graphs.

mod layout;
mod naming;
mod numerals;

pub mod graphviz;
pub mod latex;
pub mod text;

#[cfg(test)]
mod tests;
