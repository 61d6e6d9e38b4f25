//! Any text of a robot is refused with an error, or its imported declaration compiles. Its length
//! determines the options.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../crates/lagrange-import/tests/import/judge.rs"]
mod judge;

fuzz_target!(|bytes: &[u8]| {
    judge::judged(&String::from_utf8_lossy(bytes), &judge::options(bytes.len()));
});
