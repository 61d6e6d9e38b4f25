//! Paragraphs of comments and pages: how they are wrapped, and their sentences.
//!
//! `cargo xtask wrap` applies [`wrapped`], so that the rule and the tool agree. Code, tables,
//! headings, quotes, pictures and links that stand alone are no paragraphs. An item of a list is
//! one, with its later lines under its text.

use std::collections::HashSet;
use std::ops::Range;

use proc_macro2::{TokenStream, TokenTree};

/// Columns of a line, its indentation and comment marker included.
pub(crate) const MAX_COLUMNS: usize = 100;

/// Words of a sentence.
pub(crate) const MAX_WORDS: usize = 25;

/// A paragraph of a file.
pub(crate) struct Paragraph<'t> {
    /// Its lines in the file, counted from zero.
    pub(crate) lines: Range<usize>,
    /// The text before its first line, and before each other one: `/// - ` and `/// `.
    prefixes: [String; 2],
    text: Vec<&'t str>,
}

/// Returns a file with every paragraph wrapped that is wider than [`MAX_COLUMNS`].
pub(crate) fn wrapped(file: &str, is_rust: bool) -> String {
    let lines = file.split('\n').collect::<Vec<_>>();
    // Most files need no search for paragraphs, which has to parse Rust.
    let is_text = |line: &str| !is_rust || !comment(line).0.is_empty();
    if !lines.iter().any(|line| line.chars().count() > MAX_COLUMNS && is_text(line)) {
        return file.to_owned();
    }
    let mut wrapped = Vec::new();
    let mut next = 0;
    for paragraph in paragraphs(&lines, is_rust).into_iter().filter(|paragraph| paragraph.is_wide(&lines)) {
        wrapped.extend(lines[next..paragraph.lines.start].iter().map(|line| (*line).to_owned()));
        wrapped.extend(paragraph.wrap());
        next = paragraph.lines.end;
    }
    wrapped.extend(lines[next..].iter().map(|line| (*line).to_owned()));
    wrapped.join("\n")
}

/// Returns the line numbers, counted from one, of paragraphs with sentences of more than
/// [`MAX_WORDS`] words, with the beginnings of these.
pub(crate) fn long_sentences(file: &str, is_rust: bool) -> Vec<(usize, String)> {
    let lines = file.split('\n').collect::<Vec<_>>();
    let long = paragraphs(&lines, is_rust).into_iter().flat_map(|paragraph| {
        let line = paragraph.lines.start + 1;
        long_sentences_of(&paragraph.text.join(" ")).into_iter().map(move |beginning| (line, beginning))
    });
    long.collect()
}

/// Returns the beginnings of the sentences of a text that have more than [`MAX_WORDS`] words.
pub(crate) fn long_sentences_of(text: &str) -> Vec<String> {
    let long = sentences(text).into_iter().filter(|words| words.len() > MAX_WORDS);
    long.map(|words| words[..6].join(" ")).collect()
}

impl Paragraph<'_> {
    fn is_wide(&self, lines: &[&str]) -> bool {
        let is_wide = |line: &&str| line.chars().count() > MAX_COLUMNS;
        lines[self.lines.clone()].iter().any(is_wide) && self.wrap() != lines[self.lines.clone()]
    }

    /// Returns its lines, each filled as far as possible.
    fn wrap(&self) -> Vec<String> {
        let mut wrapped = Vec::new();
        let mut line = self.prefixes[0].clone();
        let mut is_empty = true;
        for piece in pieces(&self.text.join(" ")) {
            let width = line.chars().count() + usize::from(!is_empty) + piece.chars().count();
            // A line that began with such a piece would be an item or a heading.
            if !is_empty && width > MAX_COLUMNS && !begins_block(&piece) {
                wrapped.push(std::mem::replace(&mut line, self.prefixes[1].clone()));
                is_empty = true;
            }
            line.push_str(if is_empty { "" } else { " " });
            line.push_str(&piece);
            is_empty = false;
        }
        wrapped.push(line);
        wrapped
    }
}

/// Returns the words of each sentence, with code as one word. References are no sentences.
fn sentences(text: &str) -> Vec<Vec<String>> {
    if text.starts_with("Source") {
        return Vec::new();
    }
    let mut sentences = vec![Vec::new()];
    for piece in pieces(text) {
        let ends = ends_sentence(&piece);
        if piece.chars().any(char::is_alphanumeric) {
            sentences.last_mut().into_iter().for_each(|sentence| sentence.push(piece.clone()));
        }
        if ends {
            sentences.push(Vec::new());
        }
    }
    sentences
}

/// Finds the paragraphs of a file of Rust, which are in its comments, or of Markdown.
fn paragraphs<'t>(lines: &[&'t str], is_rust: bool) -> Vec<Paragraph<'t>> {
    let inside_strings = if is_rust { lines_inside_strings(&lines.join("\n")) } else { HashSet::new() };
    let mut found: Vec<Paragraph<'t>> = Vec::new();
    let (mut is_open, mut is_code, mut marker) = (false, false, "");
    for (number, line) in lines.iter().enumerate() {
        let (own, text) = if is_rust { comment(line) } else { ("", *line) };
        let is_comment = !is_rust || (!own.is_empty() && !inside_strings.contains(&number));
        if !is_comment || own != marker {
            (is_open, is_code, marker) = (false, false, own);
        }
        if text.trim_start().starts_with("```") {
            (is_open, is_code) = (false, !is_code);
        } else if !is_comment || is_code || !is_prose(text, is_open) {
            is_open = false;
        } else if let (true, Some(paragraph), None) = (is_open, found.last_mut(), item(text)) {
            paragraph.lines.end = number + 1;
            paragraph.text.push(text.trim());
        } else {
            let indent = &text[..text.len() - text.trim_start().len()];
            let bullet = item(text).unwrap_or_default();
            let space = if is_rust { " " } else { "" };
            let first = format!("{own}{space}{indent}{bullet}");
            let rest = format!("{own}{space}{indent}{}", " ".repeat(bullet.chars().count()));
            let text = vec![text.trim_start()[bullet.len()..].trim()];
            found.push(Paragraph { lines: number..number + 1, prefixes: [first, rest], text });
            is_open = true;
        }
    }
    found
}

/// Splits a line at its comment marker: the marker with the indentation before it, empty if there
/// is none, and the text.
fn comment(line: &str) -> (&str, &str) {
    let start = line.len() - line.trim_start().len();
    let marker = ["///", "//!", "//"].into_iter().find(|marker| line[start..].starts_with(marker));
    let Some(marker) = marker else { return ("", line) };
    let end = start + marker.len();
    (&line[..end], line[end..].strip_prefix(' ').unwrap_or(&line[end..]))
}

/// True if a line is text of a paragraph. Indented lines are code unless they continue one.
fn is_prose(text: &str, is_open: bool) -> bool {
    let trimmed = text.trim_start();
    let is_link = trimmed.starts_with("![") || trimmed.starts_with('[') && trimmed.contains("]: ");
    let is_code = text.starts_with("    ") && !is_open && item(text).is_none();
    !(trimmed.is_empty() || trimmed.starts_with(['|', '#', '<', '>', '~']) || is_link || is_code)
}

/// Returns the bullet or number of an item of a list with the space behind it.
fn item(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let digits = text.chars().take_while(char::is_ascii_digit).count();
    let is_item = text.starts_with(['-', '*']) && text[1..].starts_with(' ')
        || (1..=3).contains(&digits) && text[digits..].starts_with(". ");
    is_item.then(|| &text[..digits.max(1) + if digits > 0 { 2 } else { 1 }])
}

/// Splits text at spaces, but for those within code and the targets of links.
fn pieces(text: &str) -> Vec<String> {
    let mut pieces: Vec<String> = Vec::new();
    let mut is_whole = true;
    for word in text.split_whitespace() {
        match pieces.last_mut().filter(|_| !is_whole) {
            Some(piece) => *piece = format!("{piece} {word}"),
            None => pieces.push(word.to_owned()),
        }
        is_whole = pieces.last().is_none_or(|piece| piece.matches('`').count() % 2 == 0);
    }
    pieces
}

fn begins_block(piece: &str) -> bool {
    ["-", "*", "+", "|", ">", "#", "="].iter().any(|marker| piece.starts_with(marker))
        || item(&format!("{piece} ")).is_some()
}

fn ends_sentence(piece: &str) -> bool {
    let word = piece.trim_end_matches([')', '*', '"', '”']);
    let is_abbreviation =
        ["e.g.", "i.e.", "Fig.", "ed.", "vol.", "no.", "pp.", "eq."].contains(&word.trim_start_matches('('));
    word.ends_with(['.', '?', '!']) && !is_abbreviation
}

/// Returns the lines, counted from zero, that begin within a literal.
fn lines_inside_strings(file: &str) -> HashSet<usize> {
    let mut lines = HashSet::new();
    let tokens = file.parse::<TokenStream>().unwrap_or_default();
    let mut pending = vec![tokens];
    while let Some(tokens) = pending.pop() {
        for token in tokens {
            match token {
                TokenTree::Group(group) => pending.push(group.stream()),
                TokenTree::Literal(literal) => {
                    let span = literal.span();
                    lines.extend(span.start().line..span.end().line);
                }
                _ => {}
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::{MAX_COLUMNS, long_sentences, wrapped};

    #[test]
    fn comments_are_filled_under_their_marker() {
        let words = "word ".repeat(30);
        let file = format!("    /// - {words}`a b` end\n    ///   more\n    fn f() {{}}\n");
        let found = wrapped(&file, true);
        assert!(found.lines().all(|line| line.chars().count() <= MAX_COLUMNS), "{found}");
        assert!(found.starts_with("    /// - word word") && found.contains("\n    ///   word"), "{found}");
        assert!(found.contains("`a b` end more\n    fn f() {}\n"), "{found}");
        assert_eq!(wrapped(&found, true), found);
    }

    #[test]
    fn other_text_stays_as_it_is() {
        let wide = "word ".repeat(30);
        let kept = [
            format!("| {wide}|"),
            format!("/// ```\n/// {wide}\n/// ```"),
            format!("let text = \"a\n// {wide}\";"),
            format!("let a = 1; // {wide}"),
            format!("# {wide}"),
        ];
        for (text, is_rust) in kept.iter().zip([false, true, true, true, false]) {
            assert_eq!(&wrapped(text, is_rust), text);
        }
        let narrow = "A line.\nAnd another one.";
        assert_eq!(wrapped(narrow, false), narrow);
    }

    #[test]
    fn no_line_begins_as_an_item_by_chance() {
        let text = format!("{}aaa - b\n", "word ".repeat(19));
        assert_eq!(
            wrapped(&format!("{}- b {}", "abcd ".repeat(19), "c ".repeat(9)), false).lines().count(),
            2
        );
        assert!(!wrapped(&text, false).contains("\n-"), "{text}");
    }

    #[test]
    fn sentences_end_at_full_stops_and_count_code_as_a_word() {
        let short = "It is a b c d e f g h i j k l m n o p q r `v w x y z`, see e.g. these. ";
        assert_eq!(long_sentences(&short.repeat(3), false), []);
        let long = format!("/// Short.\n/// {}end.\n", "word ".repeat(26));
        assert_eq!(long_sentences(&long, true), [(1, "word word word word word word".to_owned())]);
    }
}
