//! Many kinds of systems under every lint that a user may turn on.
#![deny(warnings, missing_docs, clippy::all, clippy::pedantic, clippy::nursery)]
#![deny(future_incompatible, let_underscore, nonstandard_style, rust_2018_idioms, unused)]
#![deny(missing_copy_implementations, missing_debug_implementations, single_use_lifetimes)]
#![deny(trivial_casts, trivial_numeric_casts, unreachable_pub, unused_lifetimes, unused_qualifications)]
#![deny(clippy::allow_attributes, clippy::allow_attributes_without_reason, clippy::as_conversions)]
#![deny(clippy::expect_used, clippy::lossy_float_literal, clippy::panic)]
#![deny(clippy::missing_docs_in_private_items, clippy::missing_inline_in_public_items)]
#![deny(clippy::shadow_reuse, clippy::shadow_same, clippy::shadow_unrelated, clippy::unwrap_used)]
#![deny(clippy::single_char_lifetime_names, clippy::std_instead_of_core, clippy::indexing_slicing)]
#![forbid(unsafe_code)]

pub mod arguments;
pub mod attributes;
pub mod bodies;
pub mod friction;
pub mod letters;
pub mod precision;
pub mod products;
pub mod reduced;
pub mod tables;
pub mod touching;
