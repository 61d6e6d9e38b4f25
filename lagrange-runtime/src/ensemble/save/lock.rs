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
        loop {
            match create(&path) {
                Ok(()) => return Ok(Lock { path }),
                Err(error) if error.kind() == ErrorKind::AlreadyExists => Lock::clear(&path)?,
                Err(source) => return Err(EnsembleError::File { path, source }),
            }
        }
    }

    /// Removes a lock whose process is gone.
    ///
    /// # Errors
    /// If it is not sure that it is.
    pub(super) fn clear(path: &Path) -> Result<(), EnsembleError> {
        let holder = fs::read_to_string(path).unwrap_or_default();
        let wrong = |source| EnsembleError::File { path: path.into(), source };
        if is_gone(&holder) && remove(path, &holder).map_err(wrong)? {
            return Ok(());
        }
        let holder =
            if holder.trim().is_empty() { "another process".into() } else { holder.trim().to_string() };
        Err(EnsembleError::Locked { path: path.into(), holder })
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

/// Whether it is sure that the process that calls itself like this is gone: it ran on this machine, and Linux does not know it any more, or
/// only that it ended.
fn is_gone(holder: &str) -> bool {
    let id = holder.strip_prefix("process ").and_then(|rest| rest.split_once(" on "));
    id.is_some_and(|(id, on)| {
        let is_number = !id.is_empty() && id.bytes().all(|byte| byte.is_ascii_digit());
        let knows = Path::new("/proc/self").exists();
        is_number && knows && on.trim_end() == host() && has_ended(&Path::new("/proc").join(id))
    })
}

/// Whether a process that Linux keeps here has ended, and waits at most for its parent to ask how: its state, behind its name in brackets, is Z.
fn has_ended(process: &Path) -> bool {
    match fs::read_to_string(process.join("stat")) {
        Ok(stat) => stat.rsplit_once(") ").is_some_and(|(_, rest)| rest.starts_with(['Z', 'X'])),
        Err(error) => error.kind() == ErrorKind::NotFound && !process.exists(),
    }
}

/// This machine, since it was started.
fn host() -> String {
    let read = |path| fs::read_to_string(path).unwrap_or_default().trim().to_string();
    let [name, boot] = ["/proc/sys/kernel/hostname", "/proc/sys/kernel/random/boot_id"].map(read);
    if name.is_empty() { "a machine without a name".into() } else { format!("{name} ({boot})") }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::format;
    use std::process::Command;
    use std::thread;
    use std::time::Duration;

    use super::{is_gone, this};

    #[test]
    fn a_process_is_gone_when_it_has_ended_before_anybody_asks() {
        assert!(!is_gone(&this()));
        let mut child = Command::new("sleep").arg("600").spawn().expect("starts");
        let holder =
            this().replace(&format!("process {} ", std::process::id()), &format!("process {} ", child.id()));
        assert!(!is_gone(&holder));
        child.kill().expect("can be killed");
        while !is_gone(&holder) {
            thread::sleep(Duration::from_millis(1));
        }
        child.wait().expect("is a child");
        assert!(is_gone(&holder));
        assert!(!is_gone(&holder.replace(" on ", " on another ")));
    }
}
