//! Expressions as text and LaTeX.

mod layout;
mod naming;
mod numerals;

pub mod latex;
pub mod text;

#[cfg(test)]
mod tests;
