//! Whatever the bytes of a file that a table names, they are refused with words, or the table goes
//! through its points. The kind of table goes by their number.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../lagrange-core/tests/mutants/table_judge.rs"]
mod table_judge;

fuzz_target!(|bytes: &[u8]| {
    table_judge::judged(bytes, bytes.len());
});
