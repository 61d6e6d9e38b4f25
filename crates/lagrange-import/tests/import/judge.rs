//! The verdict on any text: either it is refused with an error, or the imported declaration
//! compiles.
//!
//! The fuzz target `urdf` uses the same verdict.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::parse;
use lagrange_import::urdf::{Import, Options, import};

/// Length above which declarations are parsed again but not derived, which takes the time of
/// thousands of short ones.
const MAX_DERIVED: usize = 1500;

/// Selects options by the bits of a number.
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

/// Imports a text. Returns true if it was accepted.
///
/// # Panics
/// Panics if the text is refused without an error, or accepted with an invalid declaration.
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
