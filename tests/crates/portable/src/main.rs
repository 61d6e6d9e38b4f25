//! Compares all hashes with their expected values. The exit code is the number of differences;
//! where there is a standard output, they are printed.

use std::process::ExitCode;

fn main() -> ExitCode {
    let mut differ = 0;
    for row in &portable::ROWS {
        let found = (row.compute)().value();
        println!("{found:#018x} {} {}", row.name, if found == row.expected { "" } else { "DIFFERS" });
        differ += u8::from(found != row.expected);
    }
    ExitCode::from(differ)
}
