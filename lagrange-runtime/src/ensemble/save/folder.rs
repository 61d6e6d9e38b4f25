//! The folder that parts are saved in, of which nobody else writes the same parts.

use core::ops::Range;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::string::String;
use std::vec::Vec;
use std::{format, vec};

use super::lock::Lock;
use super::part;
use super::settings::difference;
use crate::ensemble::error::EnsembleError;
use crate::ensemble::shard::Shard;

/// A folder into which this process alone writes the parts of a shard.
pub(super) struct Folder {
    path: PathBuf,
    _lock: Lock,
}

/// What a file in a folder is, by its name.
enum Kind {
    Part(usize),
    /// A part that is not whole.
    Unfinished,
    /// Of a shard of so many.
    Lock(Option<u64>),
    Foreign,
}

const PART: &str = "part-";
const ENDING: &str = ".parquet";
const UNFINISHED: &str = ".parquet.unfinished";
const LOCK: &str = ".lock";

impl Folder {
    /// Opens or makes a folder.
    ///
    /// # Errors
    /// If somebody else writes the same parts there.
    pub(super) fn open(path: &Path, shard: Shard) -> Result<Self, EnsembleError> {
        fs::create_dir_all(path).map_err(|source| EnsembleError::File { path: path.into(), source })?;
        let (index, count) = (shard.index(), shard.count());
        let lock = Lock::take(path.join(format!("shard-{index}-of-{count}{LOCK}")))?;
        let folder = Folder { path: path.into(), _lock: lock };
        for (path, kind) in folder.files()? {
            // Shards of another number are others.
            if let Kind::Lock(Some(other)) = kind
                && other != count
            {
                Lock::clear(&path)?;
            }
        }
        Ok(folder)
    }

    /// Which of all parts are there. Those of this shard, and one of others, were looked into.
    ///
    /// # Errors
    /// If there are files that are none, or parts of another ensemble.
    pub(super) fn parts(
        &self,
        shard: &Range<usize>,
        number: usize,
        settings: &str,
    ) -> Result<Vec<bool>, EnsembleError> {
        let mut is_found = vec![false; number];
        let mut has_other = false;
        for (path, kind) in self.files()? {
            let index = match kind {
                Kind::Part(index) => index,
                Kind::Unfinished | Kind::Lock(_) => continue,
                Kind::Foreign => return Err(EnsembleError::ForeignFile(path)),
            };
            if shard.contains(&index) || !has_other {
                has_other |= !shard.contains(&index);
                let there = part::settings(&path).ok_or_else(|| EnsembleError::ForeignFile(path.clone()))?;
                if let Some(differs) = difference(&there, settings) {
                    return Err(EnsembleError::OtherEnsemble { path, differs });
                }
            }
            match is_found.get_mut(index) {
                Some(is_found) => *is_found = true,
                None => return Err(EnsembleError::ForeignFile(path)),
            }
        }
        Ok(is_found)
    }

    /// How many parts there are.
    pub(super) fn count(&self) -> Result<usize, EnsembleError> {
        Ok(self.files()?.iter().filter(|(_, kind)| matches!(kind, Kind::Part(_))).count())
    }

    /// Writes a part under another name and renames it when it is whole.
    ///
    /// `write` is given the file, and what makes an error of what the operating system says about it.
    ///
    /// # Errors
    /// Those of `write`, and what the operating system says. What was written is deleted.
    pub(super) fn write<T>(
        &self,
        index: usize,
        write: impl FnOnce(&File, &dyn Fn(io::Error) -> EnsembleError) -> Result<T, EnsembleError>,
    ) -> Result<T, EnsembleError> {
        let [path, unfinished] =
            [ENDING, UNFINISHED].map(|ending| self.path.join(format!("{PART}{index:06}{ending}")));
        let wrong = |source| EnsembleError::File { path: path.clone(), source };
        let written = File::create(&unfinished).map_err(wrong).and_then(|file| {
            let written = write(&file, &wrong)?;
            file.sync_all().and_then(|()| fs::rename(&unfinished, &path)).map_err(wrong)?;
            Ok(written)
        });
        if written.is_err() {
            // The first error is the one that matters.
            drop(fs::remove_file(&unfinished));
        }
        written
    }

    /// The files in the order of their names.
    fn files(&self) -> Result<Vec<(PathBuf, Kind)>, EnsembleError> {
        let wrong = |source| EnsembleError::File { path: self.path.clone(), source };
        let mut files = Vec::new();
        for entry in fs::read_dir(&self.path).map_err(wrong)? {
            let path = entry.map_err(wrong)?.path();
            let kind = kind(&path);
            files.push((path, kind));
        }
        files.sort_by(|(one, _), (other, _)| one.cmp(other));
        Ok(files)
    }
}

/// What a file is.
fn kind(path: &Path) -> Kind {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    if let Some(shard) = name.strip_suffix(LOCK) {
        return lock(shard);
    }
    let number = |ending: &str| {
        let digits: &str = name.strip_prefix(PART)?.strip_suffix(ending)?;
        let index: usize = digits.parse().ok()?;
        (format!("{index:06}") == digits).then_some(index)
    };
    match (number(ENDING), number(UNFINISHED)) {
        (Some(index), _) => Kind::Part(index),
        (None, Some(_)) => Kind::Unfinished,
        (None, None) => Kind::Foreign,
    }
}

fn lock(name: &str) -> Kind {
    let count = name.strip_prefix("shard-").and_then(|rest: &str| rest.split_once("-of-"));
    let numbers: Option<[String; 2]> = count.map(|(index, count)| [index.into(), count.into()]);
    match numbers {
        Some([_, count]) => Kind::Lock(count.parse().ok()),
        None => Kind::Foreign,
    }
}
