//! All declarations of the repository as lists of tokens.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// Locations of declarations, relative to the root of the repository.
const PLACES: [&str; 9] = [
    "lagrange-core/tests/mutants",
    "README.md",
    "examples",
    "lagrange-core/tests/golden",
    "lagrange-core/tests/laws",
    "crates/lagrange-draw/src",
    "crates/lagrange-runtime/src",
    "src",
    "tests",
];
/// Tokens to put before a bare list of statements.
const HEAD: [&str; 4] = ["pub", "struct", "Machine", ";"];
/// The beginning of a declaration in Rust and in documentation.
const MACRO: &str = "system! {";

/// A declaration of the repository, correct or not.
pub(crate) struct Declaration {
    /// Its tokens, including brackets.
    pub(crate) pieces: Vec<String>,
}

/// Returns the declarations up to a number of characters, in the order of their files.
pub(crate) fn declarations(longest: usize) -> Vec<Declaration> {
    let mut folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let root =
        folders.find(|folder| folder.join("lagrange-core").is_dir()).expect("a folder of the repository");
    let mut texts = PLACES.iter().flat_map(|place| texts(&root.join(place))).collect::<Vec<_>>();
    texts.retain(|text| text.len() <= longest);
    let tokens = texts.iter().filter_map(|text| text.parse::<TokenStream>().ok());
    let pieces = tokens.map(|tokens| {
        let mut pieces = Vec::new();
        flatten(tokens, &mut pieces);
        if !pieces.iter().any(|piece| piece == "struct") {
            pieces.splice(0..0, HEAD.map(str::to_owned));
        }
        pieces
    });
    pieces.map(|pieces| Declaration { pieces }).collect()
}

fn texts(path: &Path) -> Vec<String> {
    if path.is_dir() {
        let entries = fs::read_dir(path).expect("a directory");
        let mut entries = entries.map(|entry| entry.expect("an entry").path()).collect::<Vec<PathBuf>>();
        entries.sort();
        return entries.iter().flat_map(|entry| texts(entry)).collect();
    }
    let read = || fs::read_to_string(path).expect("readable text");
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("lag") => vec![read()],
        Some("rs" | "md") => read().split(MACRO).skip(1).filter_map(body).collect(),
        _ => Vec::new(),
    }
}

/// Returns the text before the closing brace of the macro.
fn body(text: &str) -> Option<String> {
    let mut open = 1;
    let end = text.find(|character| {
        open += i32::from(character == '{') - i32::from(character == '}');
        open == 0
    });
    end.map(|end| unmarked(&text[..end]))
}

/// Removes the markers of documentation comments of Rust, where every line has one, and those of
/// lines that documentation hides.
fn unmarked(text: &str) -> String {
    const MARKERS: [&str; 2] = ["//!", "///"];
    let marker = MARKERS.into_iter().find(|marker| {
        let mut lines = text.lines().skip(1).peekable();
        lines.peek().is_some() && lines.all(|line| line.trim_start().starts_with(marker))
    });
    let Some(marker) = marker else { return text.to_owned() };
    let line = |line: &str| {
        let line = line.trim_start();
        let line = line.strip_prefix(marker).unwrap_or(line).trim_start();
        line.strip_prefix("# ").unwrap_or(line).to_owned() + "\n"
    };
    text.lines().map(line).collect()
}

fn flatten(tokens: TokenStream, pieces: &mut Vec<String>) {
    let mut operator = String::new();
    for token in tokens {
        match token {
            TokenTree::Punct(punct) => {
                operator.push(punct.as_char());
                if punct.spacing() == Spacing::Alone {
                    pieces.push(std::mem::take(&mut operator));
                }
            }
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::None => ["", ""],
                };
                pieces.push(open.to_owned());
                flatten(group.stream(), pieces);
                pieces.push(close.to_owned());
            }
            other => pieces.push(other.to_string()),
        }
    }
    pieces.extend((!operator.is_empty()).then_some(operator));
}
