//! Mistakes found while reading a file. They are stored with their offsets in the text; lines and
//! columns are determined for all of them at once.
//!
//! Counting from the start of the text for each mistake would take quadratic time.

use std::collections::HashMap;

use super::messages;
use crate::mistakes::Mistake;

/// A file that is being read, and its mistakes so far.
pub(super) struct Source<'d> {
    text: &'d str,
    /// Offsets at which lines begin.
    lines: Vec<usize>,
    found: Vec<(usize, Mistake)>,
}

impl<'d> Source<'d> {
    pub(super) fn new(text: &'d str) -> Source<'d> {
        let behind = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(place, _)| place + 1);
        Source { text, lines: [0].into_iter().chain(behind).collect(), found: Vec::new() }
    }

    /// Returns the line of an offset, counted from one.
    pub(super) fn line(&self, place: usize) -> u32 {
        let before = self.lines.partition_point(|start| *start <= place);
        u32::try_from(before).unwrap_or(u32::MAX)
    }

    /// Adds an error at a place, which includes a description of the element.
    pub(super) fn error_at(&mut self, place: (usize, String), message: impl Into<String>) -> &mut Mistake {
        self.add(place, message.into(), true)
    }

    pub(super) fn warning_at(&mut self, place: (usize, String), message: impl Into<String>) -> &mut Mistake {
        self.add(place, message.into(), false)
    }

    fn add(&mut self, (place, element): (usize, String), message: String, is_error: bool) -> &mut Mistake {
        // The column is determined once all mistakes are known.
        let line = self.line(place);
        let mistake = Mistake { line, column: 1, element, message, help: None, is_error };
        let last = self.found.len();
        self.found.push((place, mistake));
        &mut self.found[last].1
    }

    pub(super) fn error_count(&self) -> usize {
        self.found.iter().filter(|(_, mistake)| mistake.is_error).count()
    }

    /// Returns mistakes and warnings in the order of the text. Equal warnings about elements with
    /// the same tag are merged.
    pub(super) fn into_mistakes(mut self) -> Vec<Mistake> {
        self.found.sort_by_key(|(place, _)| *place);
        self.count_columns();
        let mut kept = Vec::<(Mistake, usize)>::new();
        let mut warnings = HashMap::<(String, String), usize>::new();
        for (_, mistake) in self.found {
            let key = (!mistake.is_error).then(|| (tag(&mistake).to_owned(), mistake.message.clone()));
            match key
                .map(|key| *warnings.entry(key).or_insert(kept.len()))
                .filter(|&first| first < kept.len())
            {
                Some(first) => kept[first].1 += 1,
                None => kept.push((mistake, 0)),
            }
        }
        let counted = kept.into_iter().map(|(mut mistake, others)| {
            mistake.message.push_str(&messages::and_others(others));
            mistake
        });
        counted.collect()
    }

    /// Counts the characters before each mistake in its line, starting at the previous mistake.
    fn count_columns(&mut self) {
        let (mut last, mut column) = (0, 1);
        for (place, mistake) in &mut self.found {
            let start = self.lines[mistake.line.saturating_sub(1) as usize];
            if start > last {
                (last, column) = (start, 1);
            }
            let between = self.text.get(last..*place).unwrap_or_default();
            column += u32::try_from(between.chars().count()).unwrap_or(u32::MAX - column);
            last = *place;
            mistake.column = column;
        }
    }
}

/// Returns the last part of the description of an element, without names: `<axis>` for `joint
/// "elbow", <axis>`.
fn tag(mistake: &Mistake) -> &str {
    let last = mistake.element.rsplit(", ").next().unwrap_or_default();
    if last.starts_with('<') { last } else { last.split(' ').next().unwrap_or_default() }
}
