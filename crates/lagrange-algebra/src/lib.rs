//! The computer algebra of `lagrange`: algorithms on expression graphs.
//!
//! [`calculus`] differentiates, expands and substitutes; [`simplify`] applies named rewrite rules;
//! [`formula`] prints text, LaTeX and graphs. [`program`] lowers expressions to straight-line
//! programs, which it optimises, verifies and interprets; [`code`] writes programs as source text
//! of a target language.
//!
//! This is *not* a general computer algebra system. Expressions are never expanded for comparison,
//! and there is no integration and no polynomial arithmetic beyond the needs of printed formulas.
//!
//! ```
//! use lagrange_algebra::calculus::partial;
//! use lagrange_expr::expr::{Function, Graph, evaluate};
//! use lagrange_expr::symbol::Role;
//!
//! let mut graph = Graph::new();
//! let x = graph.symbol("x", Role::Coordinate(0));
//! let sine = lagrange_expr::functions::apply(&mut graph, Function::Sin, &[x]);
//! let slope = partial(&mut graph, sine, x);
//! assert_eq!(evaluate(&graph, &[slope], |_| 0.0), [1.0]);
//! ```
#![forbid(unsafe_code)]

pub mod calculus;
pub mod code;
pub mod formula;
pub mod program;
pub mod series;
pub mod simplify;
