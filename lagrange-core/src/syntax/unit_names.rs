//! Names of units among other names.

use super::parser::Parser;
use crate::units::{meaning, meant};

/// Names of units that have a meaning in expressions, too.
const BUILT_IN: [&str; 1] = ["t"];

impl Parser<'_> {
    /// Whether a word is the name of a unit and of nothing that was declared.
    pub(super) fn is_free_unit(&self, word: &str) -> bool {
        let is_unit = meaning(word).is_some() || meant(word).is_some();
        is_unit && self.declared(word).is_none() && !BUILT_IN.contains(&word)
    }
}
