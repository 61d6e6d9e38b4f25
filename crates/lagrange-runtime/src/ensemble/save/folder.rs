//! Folders of parts, locked against other processes that would write the same parts.

use core::ops::Range;
use std::collections::BTreeSet;
use std::format;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::vec::Vec;

use super::lock::Lock;
use super::part::Label;
use super::settings::difference;
use crate::ensemble::error::EnsembleError;
use crate::ensemble::shard::Shard;
use lagrange_files::{UNFINISHED, save};

/// A folder with parts. Nothing is written to it before it is [locked](Folder::lock).
pub(super) struct Folder {
    path: PathBuf,
    /// Parts that were checked.
    checked: BTreeSet<usize>,
}

/// The kind of a file, judged by its name.
enum Kind {
    Part(usize),
    /// The unfinished file of a part whose process was killed.
    Unfinished(usize),
    /// A lock of one of this many shards.
    Lock(u64),
    /// A name similar to that of a part, which readers would include.
    Misnamed,
    Other,
}

const PART: &str = "part-";
const ENDING: &str = ".parquet";
const LOCK: &str = ".lock";

impl Folder {
    /// Opens a folder, which need not exist.
    pub(super) fn open(path: &Path) -> Self {
        Folder { path: path.into(), checked: BTreeSet::new() }
    }

    /// Creates the folder if needed, and keeps other processes from writing the parts of this shard
    /// until the lock is dropped.
    ///
    /// # Errors
    /// If another process writes the same parts.
    pub(super) fn lock(&self, shard: Shard, parts: &Range<usize>) -> Result<Lock, EnsembleError> {
        fs::create_dir_all(&self.path)
            .map_err(|source| EnsembleError::File { path: self.path.clone(), source })?;
        let (index, count) = (shard.index(), shard.count());
        let lock = Lock::take(self.path.join(format!("shard-{index}-of-{count}{LOCK}")))?;
        for (path, kind) in self.files()? {
            match kind {
                // With another number of shards, the parts of a shard differ.
                Kind::Lock(other) if other != count => drop(Lock::take(path)?),
                // If it cannot be deleted, it does no harm: it is not a part.
                Kind::Unfinished(part) if parts.contains(&part) => drop(fs::remove_file(path)),
                _ => {}
            }
        }
        Ok(lock)
    }

    /// Returns the parts that exist. The parts of this shard, and one part of another shard, are
    /// checked, each once.
    ///
    /// # Errors
    /// If one of these is damaged or belongs to another ensemble, or another file has a name like a
    /// part.
    pub(super) fn find(
        &mut self,
        shard: &Range<usize>,
        expected: &Label,
    ) -> Result<BTreeSet<usize>, EnsembleError> {
        let parts = self.parts()?;
        let mut has_other = self.checked.iter().any(|index| !shard.contains(index));
        for (path, index) in &parts {
            if *index >= expected.number {
                refuse_other(path, &Label::read(path)?, expected)?;
                return Err(EnsembleError::ForeignFile(path.clone()));
            }
            if (shard.contains(index) || !has_other) && self.checked.insert(*index) {
                has_other |= !shard.contains(index);
                refuse_other(path, &Label::read(path)?, &Label { part: *index, ..expected.clone() })?;
            }
        }
        Ok(parts.into_iter().map(|(_, index)| index).collect())
    }

    /// Returns the parts that exist, in order.
    ///
    /// # Errors
    /// If the name of a file is similar to that of a part.
    pub(super) fn parts(&self) -> Result<Vec<(PathBuf, usize)>, EnsembleError> {
        let mut parts = Vec::new();
        for (path, kind) in self.files()? {
            match kind {
                Kind::Part(index) => parts.push((path, index)),
                Kind::Misnamed => return Err(EnsembleError::ForeignFile(path)),
                Kind::Unfinished(_) | Kind::Lock(_) | Kind::Other => {}
            }
        }
        Ok(parts)
    }

    /// Writes a part, as a whole or not at all.
    ///
    /// `write` receives the file, and a function that converts an error of the operating system.
    ///
    /// # Errors
    /// If `write` fails, or the operating system cannot write the file.
    pub(super) fn write<T>(
        &self,
        index: usize,
        write: impl FnOnce(&File, &dyn Fn(io::Error) -> EnsembleError) -> Result<T, EnsembleError>,
    ) -> Result<T, EnsembleError> {
        let path = self.path.join(format!("{PART}{index:06}{ENDING}"));
        let wrong = |source| EnsembleError::File { path: path.clone(), source };
        save(&path, wrong, |file| write(file, &wrong))
    }

    /// Returns the files in the order of their names; none if the folder does not exist.
    fn files(&self) -> Result<Vec<(PathBuf, Kind)>, EnsembleError> {
        let wrong = |source| EnsembleError::File { path: self.path.clone(), source };
        let entries = match fs::read_dir(&self.path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
            entries => entries.map_err(wrong)?,
        };
        let mut files = Vec::new();
        for entry in entries {
            let path = entry.map_err(wrong)?.path();
            let kind = kind(&path);
            files.push((path, kind));
        }
        files.sort_by(|(one, _), (other, _)| one.cmp(other));
        Ok(files)
    }
}

/// Checks that a file belongs to this ensemble.
///
/// # Errors
/// If the label of a file is not the expected one.
pub(super) fn refuse_other(path: &Path, label: &Label, expected: &Label) -> Result<(), EnsembleError> {
    if let Some(differs) = difference(&label.settings, &expected.settings) {
        return Err(EnsembleError::OtherEnsemble { path: path.into(), differs });
    }
    if label == expected {
        return Ok(());
    }
    let why = format!("it is part {} of {}, under the name of another", label.part, label.number);
    Err(EnsembleError::Damaged { path: path.into(), why })
}

/// Returns the kind of a file.
fn kind(path: &Path) -> Kind {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    if let Some(count) = name.strip_suffix(LOCK).and_then(shards) {
        return Kind::Lock(count);
    }
    let Some((digits, rest)) = name.strip_prefix(PART).and_then(|rest| rest.split_once(ENDING)) else {
        return Kind::Other;
    };
    let index = digits.parse().ok().filter(|index: &usize| format!("{index:06}") == digits);
    match (index, rest) {
        (Some(index), "") => Kind::Part(index),
        (None, "") => Kind::Misnamed,
        (Some(index), rest) if rest.ends_with(UNFINISHED) => Kind::Unfinished(index),
        _ => Kind::Other,
    }
}

/// Returns the number of shards in the name of a lock.
fn shards(name: &str) -> Option<u64> {
    name.strip_prefix("shard-")?.split_once("-of-")?.1.parse().ok()
}
