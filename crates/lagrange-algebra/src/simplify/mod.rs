//! Simplification by named, directional rules.
//!
//! [`RULES`] lists every identity in use, with its domain and the reason why its application
//! terminates. These functions serve equations that become code:
//!
//! - [`collect()`] applies rules that remove terms and otherwise preserves the nesting of a
//!   formula, because this nesting keeps derived equations small;
//! - [`quotient`] cancels common factors of the equation of a single coordinate and its inertia;
//! - [`contract()`] writes sums of products of sines and cosines with fewer terms, so that little
//!   cancels; [`open()`] multiplies out products that it may then contract;
//! - [`content()`] finds the common factor of expressions;
//! - [`multiply_out`] is for small systems, where cancellation saves more than sharing.
//!
//! Other functions serve readers and proofs, and are unsuitable for code. [`present()`] expands
//! within a budget and regroups. [`proves_zero`] expands to decide whether an expression vanishes,
//! and [`vanishing()`] selects the values for which this is worth trying.
//!
//! Every result equals its input wherever the input is defined; it may be defined in more places.

mod angle;
mod balance;
mod cancel;
mod collect;
mod content;
mod contract;
mod effort;
mod expand;
mod group;
mod monomial;
mod open;
mod pairs;
mod polynomial;
mod present;
mod rules;
mod sign;
mod vanishing;
mod waves;

pub use angle::Angles;
pub use balance::balanced;
pub use cancel::quotient;
pub use collect::collect;
pub use content::{content, safe_quotient};
pub use contract::{contract, contract_all};
pub use open::{count_opened, factors_to_open, is_no_difference, open};
pub use present::{multiply_out, present, present_all, proves_zero, somewhere};
pub use rules::{RULES, Rule, RuleArguments};
pub use sign::{has_one_sign, never_vanishes};
pub use vanishing::{ROUNDING, vanishing};

#[cfg(test)]
mod tests;
