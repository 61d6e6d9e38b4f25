//! Expressions of `lagrange`: the hash-consed graph that owns every expression of a system, and its
//! vocabulary.
//!
//! [`expr`] is the graph, with the only constructors of sums, products and conditionals.
//! [`functions`] returns function values as expressions. Below them are exact numbers ([`number`]),
//! symbols with roles ([`symbol`]), functions with and without a formula ([`elementary`],
//! [`opaque`]) and containers with a fixed order ([`collections`]).
//!
//! Language and algebra also share [`units`], [`solids`], [`limits`], [`accuracy`], [`keywords`] of
//! Rust and [`diagnostics`] with spans and help.
#![forbid(unsafe_code)]

pub mod accuracy;
pub mod collections;
pub mod diagnostics;
pub mod elementary;
pub mod expr;
pub mod functions;
pub mod keywords;
pub mod limits;
pub mod number;
pub mod opaque;
pub mod solids;
pub mod symbol;
pub mod units;
