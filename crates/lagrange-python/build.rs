//! Writes the docstrings of `lagrange.pyi` as a macro, so that `help` shows what editors show.

use std::env;
use std::fs;
use std::io;
use std::path::Path;

const STUBS: &str = "lagrange.pyi";
const QUOTES: &str = "\"\"\"";

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed={STUBS}");
    let stubs = fs::read_to_string(STUBS)?;
    let arms =
        docstrings(&stubs).into_iter().map(|(name, text)| format!("    ({name}) => {{ {text:?} }};\n"));
    let text = format!("macro_rules! described {{\n{}}}\n", arms.collect::<String>());
    let folder = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("cargo sets OUT_DIR"))?;
    fs::write(Path::new(&folder).join("described.rs"), text)
}

/// Returns the docstrings of the module, its classes and their members, by name.
fn docstrings(stubs: &str) -> Vec<(String, String)> {
    let (mut found, mut class, mut name) = (Vec::new(), String::new(), "lagrange".to_owned());
    let mut lines = stubs.lines();
    while let Some(line) = lines.next() {
        let words = line.trim_start();
        if let Some(rest) = line.strip_prefix("class ") {
            class = identifier(rest);
            name.clone_from(&class);
        } else if let Some(rest) = words.strip_prefix("def ") {
            name = format!("{class}.{}", identifier(rest));
        } else if let Some(first) = words.strip_prefix(QUOTES) {
            found.push((name.clone(), docstring(first, line.len() - words.len(), &mut lines)));
        }
    }
    found
}

fn identifier(text: &str) -> String {
    text.chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect()
}

/// Returns the text up to the closing quotes, without the indentation of its lines.
fn docstring<'a>(first: &str, indentation: usize, lines: &mut impl Iterator<Item = &'a str>) -> String {
    let (mut text, mut line) = (String::new(), first);
    loop {
        if let Some(last) = line.strip_suffix(QUOTES) {
            return (text + last).trim_end().to_owned();
        }
        text += line;
        text.push('\n');
        let Some(next) = lines.next() else { return text };
        line = next.get(indentation..).unwrap_or_default();
    }
}
