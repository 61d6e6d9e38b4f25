//! Sine and cosine against values with many digits, and their other guarantees.
//!
//! All bounds hold with and without fused products; `cargo xtask check` tests both where the
//! processor can.

mod accuracy;
mod double_double;
mod promises;
mod stored;
