//! Plain English in the documentation of libraries and tests alike: the beginnings of first lines,
//! and phrases that native writers avoid.

use std::fs;
use std::path::Path;

use crate::book::pages;
use crate::imports::Crate;
use crate::literals::literals;
use crate::prose::{long_sentences, long_sentences_of, wrapped};
use crate::workspace::RustFile;

/// Words with which the first line of documentation must not begin: a function's is a verb, a
/// type's a noun phrase.
const OPENINGS: [&str; 12] =
    ["As", "By", "How", "Of", "So", "Such", "The same", "Those", "What", "Where", "Whether", "Which"];

/// Nouns that look like verbs in the third person and begin first lines nevertheless.
const NOUNS: [&str; 14] = [
    "Accelerations",
    "Columns",
    "Constraints",
    "Derivatives",
    "Distances",
    "Equations",
    "Errors",
    "Frequencies",
    "Inputs",
    "Numbers",
    "Residuals",
    "Values",
    "Velocities",
    "Weights",
];

/// Number of functions whose documentation does not begin with a verb. It may only fall.
const WITHOUT_VERB: usize = 20;

/// Phrases that neither pages nor comments contain.
const PHRASES: [&str; 6] = ["be it", "in the place of", "lest", "that is said", "that which", "those which"];

/// Phrases that pages must not contain either.
const PHRASES_OF_COMMENTS: [&str; 2] = ["is none", "so that no"];

/// Finds sentences that are too long in pages, comments and messages.
pub(crate) fn sentences(root: &Path, crates: &[Crate], files: &[RustFile]) -> Vec<String> {
    let written = texts(root, files).into_iter().flat_map(|(path, text)| {
        let long = long_sentences(&text, path.ends_with(".rs")).into_iter();
        long.map(|(line, words)| format!("{path}:{line}: {words} …")).collect::<Vec<_>>()
    });
    written.chain(long_messages(crates)).collect()
}

/// Finds sentences that are too long in the literals of crates, without their tests.
fn long_messages(crates: &[Crate]) -> Vec<String> {
    let files = crates.iter().flat_map(|krate| &krate.files);
    let long = files.flat_map(|file| {
        let code = file.text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
        let messages = literals(code).into_iter().flat_map(|(line, text)| {
            let long = text.lines().flat_map(long_sentences_of).collect::<Vec<_>>();
            long.into_iter().map(move |words| (line, words))
        });
        messages.map(|(line, words)| format!("{}:{line}: {words} …", file.path)).collect::<Vec<_>>()
    });
    long.collect()
}

/// Finds files whose paragraphs are too wide; `cargo xtask wrap` wraps them.
pub(crate) fn wide_files(root: &Path, files: &[RustFile]) -> Vec<String> {
    let wide = texts(root, files).into_iter();
    let wide = wide.filter(|(path, text)| wrapped(text, path.ends_with(".rs")) != *text);
    wide.map(|(path, _)| path).collect()
}

/// Returns pages and files of Rust with their texts.
fn texts(root: &Path, files: &[RustFile]) -> Vec<(String, String)> {
    let pages = pages(root).into_iter().map(|page| {
        let text = page_text(root, &page);
        (page, text)
    });
    pages.chain(files.iter().map(|file| (file.path.clone(), file.text.clone()))).collect()
}

/// Returns the text of a page. For the changelog, it is the unreleased part.
fn page_text(root: &Path, page: &str) -> String {
    let text = fs::read_to_string(root.join(page)).unwrap_or_default();
    let released = text.match_indices("\n## ").nth(1).filter(|_| page == "CHANGELOG.md");
    let end = released.map_or(text.len(), |(start, _)| start + 1);
    text[..end].to_owned()
}

/// Finds the first lines of documentation that begin with one of [`OPENINGS`].
pub(crate) fn openings(files: &[RustFile]) -> Vec<String> {
    let found = files.iter().flat_map(|file| {
        let lines = clumsy_openings(&file.text).into_iter();
        lines.map(|(line, text)| format!("{}:{line}: {text}", file.path))
    });
    found.collect()
}

/// Finds functions whose documentation does not begin with a verb in the third person, or with
/// "True", if there are not exactly [`WITHOUT_VERB`] of them.
pub(crate) fn functions_without_verb(files: &[RustFile]) -> Vec<String> {
    // Documentation of emitted code is that of products.
    let files = files.iter().filter(|file| !file.path.contains("/golden/"));
    let found = files.flat_map(|file| {
        let lines = openings_of_functions(&file.text).into_iter();
        let lines = lines.filter(|(_, opening)| !begins_with_verb(opening));
        lines.map(|(line, text)| format!("{}:{line}: {text}", file.path))
    });
    let mut found = found.collect::<Vec<_>>();
    match found.len() {
        WITHOUT_VERB => Vec::new(),
        count => {
            found.push(format!("{count} functions begin without a verb, not {WITHOUT_VERB}"));
            found
        }
    }
}

/// Returns the first lines of the documentation of functions, with their numbers. Tests and
/// implementations of traits are left out.
fn openings_of_functions(text: &str) -> Vec<(usize, &str)> {
    let (mut found, mut opening, mut is_test) = (Vec::new(), None, false);
    // The line that ends the implementation of a trait.
    let mut end = None;
    for (index, line) in text.lines().enumerate() {
        let code = line.trim_start();
        if let Some(documentation) = code.strip_prefix("///") {
            opening = opening.or(Some((index + 1, documentation.trim_start())));
            continue;
        }
        if end.as_deref() == Some(line) {
            end = None;
        } else if end.is_none() && is_of_trait(code) {
            end = Some(format!("{}}}", &line[..line.len() - code.len()]));
        }
        if code.starts_with("#[") {
            is_test |= code == "#[test]";
            continue;
        }
        let is_function = is_function(code) && !is_test && end.is_none();
        found.extend(opening.take().filter(|_| is_function));
        is_test = false;
    }
    found
}

/// True at the first line of an implementation of a trait.
fn is_of_trait(code: &str) -> bool {
    let code = code.trim_start_matches("$(");
    (code.starts_with("impl ") || code.starts_with("impl<"))
        && code.contains(" for ")
        && !code.ends_with("{}")
}

/// True at the first line of a function.
fn is_function(code: &str) -> bool {
    let code =
        code.strip_prefix("pub(").and_then(|rest| rest.split_once(") ")).map_or(code, |(_, rest)| rest);
    let mut words =
        code.split_whitespace().skip_while(|word| ["pub", "const", "unsafe", "async"].contains(word));
    words.next() == Some("fn")
}

/// True for a verb in the third person, or "True".
fn begins_with_verb(opening: &str) -> bool {
    let word = opening.split_whitespace().next().unwrap_or_default().trim_end_matches(',');
    let is_capitalised = word.starts_with(|first: char| first.is_ascii_uppercase());
    let is_word = is_capitalised && word[1..].chars().all(|letter| letter.is_ascii_lowercase());
    word == "True" || is_word && word.ends_with('s') && !NOUNS.contains(&word)
}

/// Finds the phrases to be avoided in pages and comments.
pub(crate) fn phrases(root: &Path, files: &[RustFile]) -> Vec<String> {
    let texts = texts(root, files).into_iter();
    let found = texts.flat_map(|(path, text)| {
        let is_rust = path.ends_with(".rs");
        let others = if is_rust { &[] } else { &PHRASES_OF_COMMENTS[..] };
        let lines = text.lines().enumerate();
        let lines = lines.filter(|(_, line)| !is_rust || line.trim_start().starts_with("//"));
        let found = lines.filter_map(|(index, line)| {
            let phrase = PHRASES.iter().chain(others).find(|phrase| has_words(line, phrase))?;
            Some(format!("{path}:{}: \"{phrase}\"", index + 1))
        });
        found.collect::<Vec<_>>()
    });
    found.collect()
}

/// Returns the first lines of documentation in a source text that begin with a word to be avoided,
/// with their numbers.
fn clumsy_openings(text: &str) -> Vec<(usize, &str)> {
    let documentation = |line: &str| -> bool { line.starts_with("/// ") || line.starts_with("//! ") };
    let mut found = Vec::new();
    let mut before = "";
    for (index, line) in text.lines().map(str::trim_start).enumerate() {
        let is_first = documentation(line) && !before.starts_with(&line[..3]);
        let opening = is_first.then(|| &line[4..]).filter(|line| begins_clumsily(line));
        found.extend(opening.map(|line| (index + 1, line)));
        before = line;
    }
    found
}

fn begins_clumsily(line: &str) -> bool {
    let rest = |word: &str| line.strip_prefix(word).map(|rest| rest.chars().next());
    OPENINGS.iter().any(|word| rest(word).is_some_and(|next| !next.is_some_and(char::is_alphanumeric)))
}

/// True if a line contains words as whole words.
fn has_words(line: &str, words: &str) -> bool {
    line.match_indices(words).any(|(start, _)| {
        let around = [line[..start].chars().next_back(), line[start + words.len()..].chars().next()];
        !around.into_iter().flatten().any(char::is_alphanumeric)
    })
}

#[cfg(test)]
mod tests {
    use crate::english::{begins_with_verb, clumsy_openings, has_words, openings_of_functions};

    #[test]
    fn openings_of_functions_leave_out_tests_and_traits() {
        let text = "/// Asks.\n///\n/// The rest.\n#[inline]\npub(in crate::a) const fn f() {}\n/// A type.\nstruct T;\n\
                    /// A claim.\n#[test]\nfn g() {}\nimpl A for T {\n    /// The name.\n    fn a() {}\n}\n\
                    impl T {\n    /// The sum.\n    pub fn b() {}\n}\n";
        assert_eq!(openings_of_functions(text), [(1, "Asks."), (16, "The sum.")]);
    }

    #[test]
    fn verbs_are_in_the_third_person() {
        assert!(["Returns x.", "True if x.", "Clips, but."].into_iter().all(begins_with_verb));
        assert!(
            ["The sum.", "Residuals.", "a + b", "True: x.", "Σ", "# Errors"]
                .into_iter()
                .all(|line| !begins_with_verb(line))
        );
    }

    #[test]
    fn first_lines_are_judged_and_only_these() {
        let text = "//! Whether this is read.\n\n    /// Asks.\n    /// What follows is no first line.\n/// The sameness.\n/// Of.\n";
        assert_eq!(clumsy_openings(text), [(1, "Whether this is read.")]);
        assert_eq!(clumsy_openings("fn f() {}\n/// Of.\n"), [(2, "Of.")]);
    }

    #[test]
    fn phrases_are_whole_words() {
        assert!(has_words("a table, be it long,", "be it") && !has_words("maybe items", "be it"));
    }
}
