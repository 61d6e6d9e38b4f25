//! Any text is either emitted or refused with an error.
#![no_main]

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::parse;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let derived =
        parse(&String::from_utf8_lossy(bytes)).and_then(|system| system.derive(StrategyChoice::Cheapest));
    match derived.and_then(|derived| derived.emit(&quote::quote!(::lagrange))) {
        Ok(tokens) => drop(tokens.to_string()),
        Err(report) => drop(report.to_string()),
    }
});
