//! Programs and expressions as text in other languages. No algebra happens here.

pub mod rust_body;
