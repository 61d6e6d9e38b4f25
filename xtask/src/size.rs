//! `cargo xtask size [REVISION]`: lines of library code by crate, and the difference to a git
//! revision.
//!
//! A line counts if it contains a token of code. Comments, documentation, tests, test doubles and
//! other test-only code do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Lines of code by crate.
type Sizes = BTreeMap<String, usize>;

/// Prints the size of each crate in the working tree, and, if given, at a revision.
pub(crate) fn size(root: &Path, revision: Option<&str>) -> Result<(), String> {
    let now = sizes(&files(root, &["ls-files"])?, |file| {
        std::fs::read_to_string(root.join(file)).map_err(|error| format!("{file}: {error}"))
    })?;
    let Some(revision) = revision else {
        now.iter().chain([(&"all".to_owned(), &now.values().sum())]).for_each(|(name, lines)| {
            println!("{lines:>7}  {name}");
        });
        return Ok(());
    };
    let files = files(root, &["ls-tree", "-r", "--name-only", revision])?;
    let then = sizes(&files, |file| git(root, &["show", &format!("{revision}:{file}")]))?;
    print_beside(&now, &then);
    Ok(())
}

fn print_beside(now: &Sizes, then: &Sizes) {
    let crates = now.keys().chain(then.keys()).collect::<BTreeSet<_>>();
    let of = |sizes: &Sizes, name: &String| sizes.get(name).copied().unwrap_or(0);
    let rows = crates.into_iter().map(|name| (name.as_str(), of(then, name), of(now, name)));
    let all = ("all", then.values().sum(), now.values().sum());
    println!("   then     now  change");
    for (name, then, now) in rows.chain([all]) {
        println!("{then:>7} {now:>7} {:>+7}  {name}", now as i64 - then as i64);
    }
}

/// Lists the library files reported by a git command.
fn files(root: &Path, arguments: &[&str]) -> Result<Vec<String>, String> {
    let listed = git(root, arguments)?;
    Ok(listed.lines().filter(|file| is_library(file)).map(str::to_owned).collect())
}

/// True for library code: a file in `src` of a crate that is neither a test nor a test double.
fn is_library(file: &str) -> bool {
    let is_source = file.starts_with("src/") || file.starts_with("xtask/src/") || in_crate(file).is_some();
    let is_test = file.contains("/tests/") || file.ends_with("/tests.rs") || file.contains("/doubles");
    file.ends_with(".rs") && is_source && !is_test
}

/// Returns the name of the project's crate whose `src` contains a file.
fn in_crate(file: &str) -> Option<&str> {
    let (folder, _) = file.split_once("/src/")?;
    let name = folder.rsplit('/').next()?;
    name.starts_with("lagrange-").then_some(name)
}

fn sizes(files: &[String], mut text_of: impl FnMut(&str) -> Result<String, String>) -> Result<Sizes, String> {
    let mut sizes = Sizes::new();
    for file in files {
        let name = in_crate(file).unwrap_or(if file.starts_with("src/") { "lagrange" } else { "xtask" });
        *sizes.entry(name.to_owned()).or_default() +=
            lines_of_code(&text_of(file)?).map_err(|error| format!("{file}: {error}"))?;
    }
    Ok(sizes)
}

/// Returns the output of a git command.
pub(crate) fn git(root: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new("git").args(arguments).current_dir(root).output();
    let output = output.map_err(|error| format!("git cannot be started: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).trim().to_owned());
    }
    String::from_utf8(output.stdout).map_err(|error| error.to_string())
}

/// Counts the lines of a source text that contain code.
fn lines_of_code(text: &str) -> Result<usize, String> {
    let tokens: TokenStream = text.parse().map_err(|error| format!("{error}"))?;
    let mut lines = BTreeSet::new();
    collect_lines(tokens, &mut lines);
    Ok(lines.len())
}

/// Adds the lines of tokens, without documentation and items for tests.
fn collect_lines(tokens: TokenStream, lines: &mut BTreeSet<usize>) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match &token {
            TokenTree::Punct(hash) if hash.as_char() == '#' => {
                tokens.next_if(|next| matches!(next, TokenTree::Punct(inner) if inner.as_char() == '!'));
                let Some(TokenTree::Group(attribute)) = tokens.peek() else { continue };
                match attribute.stream().to_string().as_str() {
                    words if words.starts_with("doc =") => drop(tokens.next()),
                    "test" => skip_item(&mut tokens),
                    words if words.starts_with("cfg (test)") || words.starts_with("cfg (all (test") => {
                        skip_item(&mut tokens);
                    }
                    _ => drop(lines.insert(hash.span().start().line)),
                }
            }
            TokenTree::Group(group) => {
                lines.extend([group.span_open().start().line, group.span_close().end().line]);
                collect_lines(group.stream(), lines);
            }
            other => lines.extend(other.span().start().line..=other.span().end().line),
        }
    }
}

/// Skips an attribute and the item after it, which ends with a semicolon or a body in braces.
fn skip_item(tokens: &mut std::iter::Peekable<impl Iterator<Item = TokenTree>>) {
    let is_semicolon = |token: &TokenTree| matches!(token, TokenTree::Punct(end) if end.as_char() == ';');
    let ends = |token: &TokenTree| match token {
        TokenTree::Group(body) => body.delimiter() == Delimiter::Brace,
        other => is_semicolon(other),
    };
    if tokens.find(ends).is_some_and(|end| !is_semicolon(&end)) {
        tokens.next_if(is_semicolon);
    }
}

#[cfg(test)]
mod tests {
    use super::{is_library, lines_of_code};

    #[test]
    fn only_lines_with_code_count() {
        let text = "//! Module.\n\nuse a::b;\n/// Documentation\n/// of f.\nfn f() {\n    // Comment.\n    let text = \"x\ny\";\n}\n";
        assert_eq!(lines_of_code(text), Ok(5));
    }

    #[test]
    fn code_for_tests_does_not_count() {
        let text = "#[cfg(test)]\nmod tests;\n#[cfg(test)]\nuse a::{b, c};\n#[test]\nfn f() {\n    g();\n}\n#[inline]\nfn h() {}\n";
        assert_eq!(lines_of_code(text), Ok(2));
    }

    #[test]
    fn library_code_is_that_of_crates_of_the_project() {
        let library = [
            "src/lib.rs",
            "lagrange-core/src/expr/mod.rs",
            "xtask/src/main.rs",
            "crates/lagrange-expr/src/lib.rs",
        ];
        assert!(library.iter().all(|file| is_library(file)));
        let others = [
            "tests/api/main.rs",
            "lagrange-core/src/expr/tests.rs",
            "lagrange-core/tests/golden/a/code.rs",
            "examples/rope.rs",
        ];
        assert!(!others.iter().any(|file| is_library(file)));
    }
}
