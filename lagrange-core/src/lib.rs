//! The computer algebra, the mechanics and the code emission behind `lagrange::system!`: everything
//! that happens at compile time.
//!
//! It is an ordinary library, so tests, tools and build scripts can also read systems from text,
//! inspect them and evaluate them. It is *not* a general computer algebra system. Expressions are
//! never expanded for comparison or simplification. There is no solving, no integration, and no
//! polynomial arithmetic beyond the needs of printed formulas. Users of `lagrange` do not link it.
//!
//! A pendulum, from text to its equation and its acceleration:
//!
//! ```
//! use lagrange_core::derive::StrategyChoice;
//! use lagrange_core::pipeline::{NumericSystem, parse};
//!
//! let pendulum = "
//!     param m = 1, l = 2, g = 9.81;
//!     coord theta;
//!     kinetic = 1/2 * m * (l * dot(theta))^2;
//!     potential = -m * g * l * cos(theta);
//! ";
//! let mut derived = parse(pendulum)?.derive(StrategyChoice::Cheapest)?;
//!
//! let lines = derived.documentation();
//! assert!(lines.iter().any(|line| line == "m*l^2*ddot(theta) = -m*l*g*sin(theta)"));
//!
//! let numeric = NumericSystem::new(&derived);
//! let (t, angle, rate) = (0.0, 0.3, 0.0);
//! let acceleration = numeric.acceleration(t, &[angle], &[rate]);
//! assert!((acceleration[0] + 9.81 / 2.0 * angle.sin()).abs() < 1e-15);
//! # Ok::<(), lagrange_core::diagnostics::Report>(())
//! ```
//!
//! # Phases
//!
//! [`pipeline`] shows all phases on one screen:
//!
//! 1. [`syntax`] reads tokens or text into a [`Declaration`](syntax::ast::Declaration), and reports
//!    all errors together;
//! 2. [`expand`] writes out arrays, loops and sums, [`inline`] replaces function calls by their
//!    bodies, and [`bodies`] translates bodies into plain statements, [`Plain`](bodies::Plain);
//! 3. [`mod@elaborate`] resolves names and checks semantics, which yields a
//!    [`Model`](model::Model);
//! 4. [`mod@derive`] finds the [`Equations`](derive::Equations) of a model;
//! 5. [`emit`] writes them as Rust. [`program`] lowers expressions to straight-line
//!    [`Program`](program::Program)s, [`code`] writes those as the body of a function, and
//!    [`formula`] writes expressions as text, LaTeX or graphs.
//!
//! This crate holds [`model`], [`mod@elaborate`], [`mod@derive`], [`emit`], [`pipeline`],
//! [`files`], which reads table files, and [`editor`], which shows names to editors. It re-exports
//! the modules of three crates below it. `lagrange-expr` is the graph that owns every expression of
//! a system, with its vocabulary. `lagrange-algebra` holds the algorithms on the graph, and
//! `lagrange-language` leads from tokens to plain statements. `ARCHITECTURE.md` lists their layers,
//! and `docs/tour.md` follows a double pendulum through each phase.
#![forbid(unsafe_code)]

pub mod derive;
pub mod editor;
pub mod elaborate;
pub mod emit;
pub mod files;
pub mod model;
pub mod pipeline;

pub use lagrange_algebra::{calculus, code, formula, program, simplify};
pub use lagrange_expr::{
    accuracy, collections, diagnostics, elementary, expr, functions, keywords, limits, number, opaque,
    solids, symbol, units,
};
#[doc(hidden)]
pub use lagrange_language::mobilizers;
pub use lagrange_language::{bodies, dimensions, expand, inline, syntax, tables};

/// `docs/tour.md`, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../docs/tour.md")]
struct Tour;
