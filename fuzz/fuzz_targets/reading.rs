//! Any text is read and checked within the limits of time and memory set by the command.
#![no_main]

use lagrange_core::pipeline::parse;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Err(report) = parse(&String::from_utf8_lossy(bytes)) {
        assert!(report.has_errors());
        drop(report.to_string());
    }
});
