//! Input files with declarations, and the standard input.

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use lagrange_core::limits::MAX_FILE_BYTES;
use lagrange_core::tables::decoded;
use lagrange_dynamic::Source;

use crate::arguments::STANDARD_INPUT;

/// Reads a file, or the standard input for `-`.
///
/// # Errors
/// If the file cannot be read, with its name and the reason.
pub(crate) fn read(path: &Path) -> Result<Source, String> {
    if path.as_os_str() == STANDARD_INPUT {
        let text = standard_input().map_err(|reason| format!("the standard input: {reason}"))?;
        return Ok(Source { name: "<stdin>".to_owned(), text, folder: PathBuf::new() });
    }
    Source::read(path)
}

fn standard_input() -> Result<String, String> {
    let mut bytes = Vec::new();
    let input = io::stdin().lock().take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes);
    input.map_err(|error| error.to_string())?;
    decoded(bytes)
}
