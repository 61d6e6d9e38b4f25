//! Files that keep other processes off.

use std::format;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::string::{String, ToString};

use crate::ensemble::error::EnsembleError;

/// A file that says that this process writes; it is deleted when this is dropped.
pub(super) struct Lock {
    path: PathBuf,
}

impl Lock {
    /// Takes the lock.
    ///
    /// # Errors
    /// If another process has it, or may have.
    pub(super) fn take(path: PathBuf) -> Result<Self, EnsembleError> {
        let wrong = |source| EnsembleError::File { path: path.clone(), source };
        match create(&path) {
            Ok(()) => return Ok(Lock { path }),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(wrong(error)),
        }
        let holder = fs::read_to_string(&path).unwrap_or_default();
        if is_gone(&holder) && remove(&path, &holder).map_err(wrong)? {
            match create(&path) {
                Ok(()) => return Ok(Lock { path }),
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(wrong(error)),
            }
        }
        let holder =
            if holder.trim().is_empty() { "another process".into() } else { holder.trim().to_string() };
        Err(EnsembleError::Locked { path, holder })
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // What stays is taken over, or explained, by the next process.
        drop(fs::remove_file(&self.path));
    }
}

fn create(path: &Path) -> io::Result<()> {
    let mut file: File = OpenOptions::new().write(true).create_new(true).open(path)?;
    let written = file.write_all(this().as_bytes());
    if written.is_err() {
        drop(fs::remove_file(path));
    }
    written
}

/// Removes a lock that a process left that is gone; whether it was that one, and not that of somebody who was faster.
fn remove(path: &Path, holder: &str) -> io::Result<bool> {
    let aside = path.with_extension(format!("{}.lock", process::id()));
    match fs::rename(path, &aside) {
        Ok(()) => {}
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(true),
        Err(error) => return Err(error),
    }
    if fs::read_to_string(&aside)? == holder {
        return fs::remove_file(&aside).map(|()| true);
    }
    fs::rename(&aside, path).map(|()| false)
}

/// How this process calls itself.
fn this() -> String {
    format!("process {} on {}\n", process::id(), host())
}

/// Whether it is sure that the process that calls itself like this is gone: it ran on this machine, and Linux does not know it any more.
fn is_gone(holder: &str) -> bool {
    let id = holder.strip_prefix("process ").and_then(|rest| rest.split_once(" on "));
    id.is_some_and(|(id, on)| {
        let is_number = !id.is_empty() && id.bytes().all(|byte| byte.is_ascii_digit());
        let knows = Path::new("/proc/self").exists();
        is_number && knows && on.trim_end() == host() && !Path::new("/proc").join(id).exists()
    })
}

/// This machine, since it was started.
fn host() -> String {
    let read = |path| fs::read_to_string(path).unwrap_or_default().trim().to_string();
    let [name, boot] = ["/proc/sys/kernel/hostname", "/proc/sys/kernel/random/boot_id"].map(read);
    if name.is_empty() { "a machine without a name".into() } else { format!("{name} ({boot})") }
}
