//! Files named in a declaration.
//!
//! A build must terminate for any path: reading from pipes and devices could block or never end.

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

use lagrange_expr::limits::MAX_FILE_BYTES;
use lagrange_language::tables::{FileText, decoded};

/// Reads a regular file in a folder, of at most [`MAX_FILE_BYTES`].
///
/// # Errors
/// The reason why the file cannot be read.
pub fn read(folder: &Path, path: &str) -> Result<FileText, String> {
    let path = folder.join(path);
    let metadata = fs::metadata(&path).map_err(|error| error.to_string())?;
    if metadata.is_dir() {
        return Err("it is a folder".to_owned());
    }
    // This excludes everything that only looks like a file: kernel files have no length, and
    // reading some of them blocks.
    if !metadata.is_file() {
        return Err("it is not a regular file, but a device, a pipe or a socket".to_owned());
    }
    let mut bytes = Vec::new();
    if metadata.len() > 0 {
        // The file may grow while it is being read.
        let file = File::open(&path).map_err(|error| error.to_string())?;
        file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    }
    let path = path.into_os_string().into_string().map_err(|_| "its path is not in UTF-8".to_owned())?;
    Ok(FileText { path, text: decoded(bytes)? })
}

#[cfg(test)]
mod tests;
