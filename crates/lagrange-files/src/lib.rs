//! Files that are saved completely or not at all, and cells of tables in text.
//!
//! A file is written under another name in the same folder, and replaces the older file once it is
//! completely on the disk. Readers find either the older file or the new one, even after an error,
//! a full disk, a signal or a power failure.
#![forbid(unsafe_code)]

use std::borrow::Cow;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};

/// The end of names of incomplete files.
pub const UNFINISHED: &str = ".unfinished";

/// Saves a file written by `write`. An older file remains until the new one is complete, and
/// remains unchanged after an error.
///
/// The new file has the permissions of the older one. For a link, the target is replaced. A pipe or
/// a device is written to directly. `wrong` converts errors of the operating system.
///
/// # Errors
/// If `write` fails, or the operating system cannot write the file.
pub fn save<T, E>(
    path: &Path,
    wrong: impl Fn(io::Error) -> E,
    write: impl FnOnce(&File) -> Result<T, E>,
) -> Result<T, E> {
    match Place::of(path).map_err(&wrong)? {
        Place::Device(file) => write(&file),
        Place::File { path, older } => {
            let unfinished = Unfinished::beside(&path).map_err(&wrong)?;
            let written = write(&unfinished.file)?;
            unfinished.put(&path, older).map_err(wrong)?;
            Ok(written)
        }
    }
}

/// Saves these bytes, like [`save`].
///
/// # Errors
/// If the operating system cannot write the file.
pub fn save_bytes(path: &Path, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    save(path, |error| error, |mut file| file.write_all(bytes.as_ref()))
}

/// Returns a text as a cell of comma-separated values (RFC 4180). An apostrophe precedes text that
/// spreadsheets would interpret as a formula.
pub fn csv_cell(text: &str) -> Cow<'_, str> {
    let is_formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
    let text = if is_formula { format!("'{text}").into() } else { Cow::from(text) };
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\"")).into()
    } else {
        text
    }
}

/// The destination of a file.
enum Place {
    /// A device or pipe, which is written to directly.
    Device(File),
    /// A file, with the permissions of the older one that it replaces.
    File { path: PathBuf, older: Option<fs::Permissions> },
}

impl Place {
    /// Finds where a file of this path is written.
    ///
    /// # Errors
    /// If the path refers to an object that cannot be written.
    fn of(path: &Path) -> io::Result<Place> {
        let older = match OpenOptions::new().write(true).open(path) {
            Ok(older) => older,
            Err(error) if error.kind() == ErrorKind::NotFound => {
                return Ok(Place::File { path: path.into(), older: None });
            }
            Err(error) => return Err(error),
        };
        let metadata = older.metadata()?;
        if !metadata.is_file() {
            return Ok(Place::Device(older));
        }
        Ok(Place::File { path: fs::canonicalize(path)?, older: Some(metadata.permissions()) })
    }
}

/// An incomplete file, which is deleted when this is dropped.
struct Unfinished {
    path: PathBuf,
    file: File,
}

/// Maximum number of characters taken from the original name. Names of 255 bytes have enough space
/// for them.
const MAX_CHARACTERS: usize = 50;

impl Unfinished {
    /// Creates a new file in the folder of this path, with a unique name.
    fn beside(path: &Path) -> io::Result<Unfinished> {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let name: String = name.chars().take(MAX_CHARACTERS).collect();
        loop {
            let number = COUNT.fetch_add(1, Ordering::Relaxed);
            let path = path.with_file_name(format!("{name}.{}-{number}{UNFINISHED}", process::id()));
            match OpenOptions::new().read(true).write(true).create_new(true).open(&path) {
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                opened => return opened.map(|file| Unfinished { path, file }),
            }
        }
    }

    /// Moves the complete file to its place.
    fn put(&self, path: &Path, older: Option<fs::Permissions>) -> io::Result<()> {
        if let Some(permissions) = older {
            self.file.set_permissions(permissions)?;
        }
        self.file.sync_all()?;
        fs::rename(&self.path, path)?;
        sync_folder(path);
        Ok(())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        // After the move, no file with this name exists.
        drop(fs::remove_file(&self.path));
    }
}

/// Synchronises the names in the folder of this file to the disk. Not every system supports this;
/// the file itself is complete.
fn sync_folder(path: &Path) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    drop(File::open(folder.unwrap_or(Path::new("."))).and_then(|folder| folder.sync_all()));
}

#[cfg(test)]
mod tests;
