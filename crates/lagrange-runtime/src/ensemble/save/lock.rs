//! Lock files that keep other processes out.
//!
//! The operating system keeps a lock on such a file while its process lives, in any container or
//! namespace. The file names its owner. File systems do not always honour locks across machines, so
//! a lock of another machine is never taken over.

use std::format;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::string::{String, ToString};

use crate::ensemble::error::EnsembleError;

/// A lock file of this process. The file is deleted when the lock is dropped.
pub(super) struct Lock {
    path: PathBuf,
    /// File that the operating system keeps locked.
    _file: File,
}

impl Lock {
    /// Takes the lock, even from a process of this machine that no longer exists.
    ///
    /// # Errors
    /// If another process holds it, or may hold it.
    pub(super) fn take(path: PathBuf) -> Result<Self, EnsembleError> {
        let taken = loop {
            match attempt(&path) {
                Ok(LockAttempt::Taken(file)) => break Ok(file),
                Ok(LockAttempt::Deleted) => {}
                Ok(LockAttempt::Held(holder)) => return Err(EnsembleError::Locked { path, holder }),
                Err(source) => break Err(source),
            }
        };
        match taken {
            Ok(file) => Ok(Lock { path, _file: file }),
            Err(source) => Err(EnsembleError::File { path, source }),
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // A file that cannot be deleted is taken over, or reported, by the next process.
        drop(fs::remove_file(&self.path));
    }
}

/// The result of one attempt to take a lock.
enum LockAttempt {
    Taken(File),
    /// Another process holds it, with this description.
    Held(String),
    /// It was given up, with its file, between two looks at it.
    Deleted,
}

fn attempt(path: &Path) -> io::Result<LockAttempt> {
    let Some((mut file, is_new)) = open(path)? else { return Ok(LockAttempt::Deleted) };
    let is_locked = match file.try_lock() {
        Ok(()) => true,
        // If files cannot be locked, the process that created the file holds the lock.
        Err(TryLockError::Error(_)) => is_new,
        Err(TryLockError::WouldBlock) => false,
    };
    // Some systems do not let other processes read a locked file.
    let mut holder = String::new();
    drop(file.read_to_string(&mut holder));
    if !(is_locked && is_gone(&holder)) {
        let holder = holder.trim();
        return Ok(LockAttempt::Held(if holder.is_empty() { "another process" } else { holder }.to_string()));
    }
    if !is_at(&file, path)? {
        return Ok(LockAttempt::Deleted);
    }
    say(&mut file, path)?;
    Ok(LockAttempt::Taken(file))
}

/// Returns the file, and true if it was created; `None` if it was deleted meanwhile.
fn open(path: &Path) -> io::Result<Option<(File, bool)>> {
    let mut options = OpenOptions::new();
    options.read(true).write(true);
    match options.clone().create_new(true).open(path) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
        made => return made.map(|file| Some((file, true))),
    }
    match options.open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        opened => opened.map(|file| Some((file, false))),
    }
}

/// True if this is the file at the path, and not one that was deleted from it.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    let there = match fs::metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(false),
        there => there?,
    };
    let this = file.metadata()?;
    Ok((this.dev(), this.ino()) == (there.dev(), there.ino()))
}

/// True always: on other systems, an open file is not deleted from its path.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> io::Result<bool> {
    Ok(true)
}

/// Writes the name of this process to the file, and deletes the file if that fails.
fn say(file: &mut File, path: &Path) -> io::Result<()> {
    let written =
        file.set_len(0).and_then(|()| file.rewind()).and_then(|()| file.write_all(this().as_bytes()));
    if written.is_err() {
        drop(fs::remove_file(path));
    }
    written
}

/// True if the process of this name no longer exists, given that this one could take its lock.
/// Either it is unnamed, or it ran on this machine, which honours locks.
fn is_gone(holder: &str) -> bool {
    let boot = |text: &str| Some(text.split_once(BOOT)?.1.split_once(';')?.0.to_string());
    let this = this();
    holder.is_empty() || (boot(holder).is_some() && boot(holder) == boot(&this) && holder != this)
}

const BOOT: &str = " (boot ";

/// Returns the name of this process in lock files. The name has the process number and machine. If
/// known, it also has the boot ID of the machine, the PID namespace and the start time.
fn this() -> String {
    let read = |path| fs::read_to_string(path).unwrap_or_default().trim().to_string();
    let [name, boot] = ["/proc/sys/kernel/hostname", "/proc/sys/kernel/random/boot_id"].map(read);
    let name = if name.is_empty() { "a machine without a name" } else { &name };
    let id = process::id();
    if boot.is_empty() {
        return format!("process {id} on {name}\n");
    }
    let namespace = fs::read_link("/proc/self/ns/pid").unwrap_or_default();
    let stat = read("/proc/self/stat");
    // The start time is field 22; field 2 is a name in parentheses.
    let start = stat.rsplit_once(") ").and_then(|(_, rest)| rest.split(' ').nth(19)).unwrap_or_default();
    format!("process {id} on {name}{BOOT}{boot}; {}; start {start})\n", namespace.display())
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::format;
    use std::fs::{self, File};
    use std::string::String;

    use super::{Lock, is_gone, this};
    use crate::ensemble::error::EnsembleError;

    #[test]
    fn only_a_process_of_this_machine_can_be_known_to_be_gone() {
        let id = format!("process {} ", std::process::id());
        assert!(this().starts_with(&id) && !is_gone(&this()));
        let other = this().replace(&id, "process 4711 ");
        assert!(is_gone("") && is_gone(&other) && is_gone(&other.replace(" on ", " on a container on ")));
        assert!(!is_gone(&other.replace("(boot ", "(boot 0")));
        assert!(!is_gone("process 4711 on elsewhere\n") && !is_gone("mine"));
    }

    /// Whatever its text, a lock is held only by a process for which the operating system holds it.
    #[test]
    fn a_lock_is_held_by_who_holds_it() {
        let path = std::env::temp_dir().join(format!("lagrange_lock_{}.lock", std::process::id()));
        let other = this().replace("process ", "process 1");
        for says in [String::new(), other.clone()] {
            fs::write(&path, &says).expect("can be written");
            let file = File::open(&path).expect("is there");
            file.lock().expect("can be locked");
            let held = Lock::take(path.clone()).err();
            assert!(matches!(held, Some(EnsembleError::Locked { .. })), "{held:?}");
            drop(file);
            let lock = Lock::take(path.clone()).expect("is free");
            assert_eq!(fs::read_to_string(&path).expect("is there"), this());
            drop(lock);
            assert!(!path.exists());
        }
    }
}
