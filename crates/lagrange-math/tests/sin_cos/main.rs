//! Sine and cosine against values with many digits, and what else is promised of them.
//!
//! All bounds hold with and without fused products; `cargo xtask check` tries both where the
//! processor can.

mod accuracy;
mod double_double;
mod promises;
mod stored;
