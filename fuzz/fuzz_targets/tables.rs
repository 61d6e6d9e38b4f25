//! Any bytes of a table file are refused with an error, or the table passes through its points.
//! Their number determines the kind of table.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../lagrange-core/tests/mutants/table_judge.rs"]
mod table_judge;

fuzz_target!(|bytes: &[u8]| {
    table_judge::judged(bytes, bytes.len());
});
