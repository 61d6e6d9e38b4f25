//! Verification of folders of parts, without computing anything.

use std::path::Path;

use super::folder::{Folder, refuse_other};
use super::part::Label;
use crate::ensemble::error::EnsembleError;

/// The result of [`verify`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Verified {
    /// Parts that exist and are intact.
    pub parts: usize,
    /// Parts that do not exist yet.
    pub missing: usize,
}

/// Checks every byte of all parts that [`save_parquet`](crate::ensemble::Ensemble::save_parquet)
/// wrote into a folder, and that they are parts of one ensemble under the right names. Nothing is
/// written.
///
/// # Errors
/// If there are no parts, a file is not a part or cannot be read, or a part:
/// - is damaged,
/// - has the name of another one,
/// - or belongs to a different ensemble than the first.
pub fn verify(folder: impl AsRef<Path>) -> Result<Verified, EnsembleError> {
    let (mut first, mut parts) = (None::<Label>, 0);
    for (path, index) in Folder::open(folder.as_ref()).parts()? {
        let label = Label::read(&path)?;
        let first = first.get_or_insert_with(|| label.clone());
        refuse_other(&path, &label, &Label { part: index, ..first.clone() })?;
        parts += 1;
    }
    let none =
        || EnsembleError::Setting(std::format!("there are no parts in `{}`", folder.as_ref().display()));
    let Label { number, .. } = first.ok_or_else(none)?;
    Ok(Verified { parts, missing: number.saturating_sub(parts) })
}
