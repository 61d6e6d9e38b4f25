//! Dimensions of what is declared: numbers in coherent units, and what has which unit.
//!
//! Numbers at run time are in coherent units of the SI. A number that is written in another unit is scaled here, exactly, before anything
//! else is known of the declaration: `param l: mm = 500` has the default 1/2. A declaration in which no unit is written passes unseen.

mod defaults;
mod messages;
#[cfg(test)]
mod tests;

pub use defaults::in_coherent_units;
