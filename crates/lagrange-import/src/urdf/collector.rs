//! Mistakes while a file is read: kept by their place in the text, and given lines and columns all
//! at once.
//!
//! Counting lines from the start of the text for each mistake would take time that grows with the
//! square of their number.

use std::collections::HashMap;

use super::messages;
use crate::mistakes::Mistake;

/// A file that is read, and its mistakes so far.
pub(super) struct Source<'d> {
    text: &'d str,
    /// Places at which lines begin.
    lines: Vec<usize>,
    found: Vec<(usize, Mistake)>,
}

impl<'d> Source<'d> {
    pub(super) fn new(text: &'d str) -> Source<'d> {
        let behind = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(place, _)| place + 1);
        Source { text, lines: [0].into_iter().chain(behind).collect(), found: Vec::new() }
    }

    /// The line of a place, from one.
    pub(super) fn line(&self, place: usize) -> u32 {
        let before = self.lines.partition_point(|start| *start <= place);
        u32::try_from(before).unwrap_or(u32::MAX)
    }

    /// Adds an error at a place, whose element is described in words.
    pub(super) fn error_at(&mut self, place: (usize, String), message: impl Into<String>) -> &mut Mistake {
        self.add(place, message.into(), true)
    }

    pub(super) fn warning_at(&mut self, place: (usize, String), message: impl Into<String>) -> &mut Mistake {
        self.add(place, message.into(), false)
    }

    fn add(&mut self, (place, element): (usize, String), message: String, is_error: bool) -> &mut Mistake {
        // The column is found when all mistakes are known.
        let line = self.line(place);
        let mistake = Mistake { line, column: 1, element, message, help: None, is_error };
        let last = self.found.len();
        self.found.push((place, mistake));
        &mut self.found[last].1
    }

    pub(super) fn error_count(&self) -> usize {
        self.found.iter().filter(|(_, mistake)| mistake.is_error).count()
    }

    /// Mistakes and warnings from the first place to the last. Equal warnings about elements of one
    /// tag are merged.
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

    /// Counts the characters before each mistake in its line, from the mistake before it on.
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

/// The last part of an element in words, without names: `<axis>` of `joint "elbow", <axis>`.
fn tag(mistake: &Mistake) -> &str {
    let last = mistake.element.rsplit(", ").next().unwrap_or_default();
    if last.starts_with('<') { last } else { last.split(' ').next().unwrap_or_default() }
}
