//! The verdict on any text: it is refused with words, or what is imported compiles.
//!
//! The fuzz target `urdf` has no other.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::parse;
use lagrange_import::urdf::{Import, Options, import};

/// Longer declarations are read again, but no equations derived: that takes the time of thousands
/// of short ones.
const MAX_DERIVED: usize = 1500;

/// Options by the bits of a number.
pub(crate) fn options(bits: usize) -> Options {
    Options {
        is_free: bits & 1 != 0,
        has_inputs: bits & 2 != 0,
        trusts_inertia: bits & 4 != 0,
        name: (bits & 8 != 0).then(|| "Other".to_owned()),
        has_limits: bits & 2 != 0,
        has_friction: bits & 4 != 0,
        has_contacts: bits & 8 != 0,
        corners: if bits & 24 == 24 { vec!["sled".to_owned()] } else { Vec::new() },
    }
}

/// Imports a text. The result is true if it was accepted.
///
/// # Panics
/// If it is refused without an error, or accepted although its declaration is not.
pub(crate) fn judged(text: &str, options: &Options) -> bool {
    match import(text, options) {
        Ok(Import { declaration, .. }) => {
            compile(&declaration);
            true
        }
        Err(mistakes) => {
            let is_told = mistakes.iter().any(|mistake| mistake.is_error && !mistake.message.is_empty());
            let refused_late = mistakes.iter().find(|mistake| mistake.message.contains("is rejected"));
            assert!(is_told && refused_late.is_none(), "{mistakes:?}\n{text}");
            false
        }
    }
}

fn compile(declaration: &str) {
    let inner = declaration.strip_prefix("lagrange::system! {").and_then(|rest| rest.strip_suffix("}\n"));
    let system = parse(inner.expect("a declaration within the macro"));
    let system = system.unwrap_or_else(|report| panic!("{report}\n{declaration}"));
    if declaration.len() <= MAX_DERIVED {
        let derived = system.derive(StrategyChoice::Cheapest);
        let emitted = derived.and_then(|derived| derived.emit(&"::lagrange".parse().expect("a path")));
        emitted.unwrap_or_else(|report| panic!("{report}\n{declaration}"));
    }
}
