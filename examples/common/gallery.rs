//! The folder for the pictures of examples.

use std::fs::create_dir_all;
use std::io;
use std::path::{Path, PathBuf};

/// Returns the path of a picture in `target/gallery`, and prints it.
///
/// # Errors
/// If the folder cannot be created.
pub(crate) fn picture(name: &str) -> io::Result<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target").join("gallery");
    create_dir_all(&folder)?;
    println!("target/gallery/{name}");
    Ok(folder.join(name))
}
