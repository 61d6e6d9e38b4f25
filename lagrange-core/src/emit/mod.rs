//! Output for readers and compilers. Nothing here does algebra.

mod layout;
mod naming;
mod numerals;

pub mod graphviz;
pub mod latex;
pub mod text;

#[cfg(test)]
mod tests;
