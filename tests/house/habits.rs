//! Habits visible in the text of a file: explicit imports, no `unwrap`, no unsafe code, short
//! files.

use crate::imports::Crate;
use crate::sources::File;

const LONGEST_FILE: usize = 500;
/// The only files with unsafe code, and their crates.
const UNSAFE_FILES: [(&str, &str); 3] = [
    ("lagrange-jit", "machine.rs"),
    ("lagrange-runtime", "integrate/taylor/widest.rs"),
    ("lagrange-runtime", "scalar/order.rs"),
];
const FORBIDDEN: [&str; 4] = ["::*", ".unwrap()", "super::super", "use crate::{"];

/// Finds violations of the habits in a crate.
pub(crate) fn lapses(krate: &Crate) -> Vec<String> {
    let [root, ..] = krate.files.as_slice() else { return Vec::new() };
    let has_unsafe_file = UNSAFE_FILES.iter().any(|(name, _)| krate.name == *name);
    let level = if has_unsafe_file { "deny" } else { "forbid" };
    let safe = format!("#![{level}(unsafe_code)]");
    let unsafe_root = (!root.text.contains(&safe)).then(|| format!("{} does not have `{safe}`", root.path));
    let files = krate.files.iter().enumerate().flat_map(|(index, file)| {
        let is_top = index == 0 || krate.modules.iter().any(|(_, module)| *module == index);
        lapses_in(file, is_top)
    });
    unsafe_root.into_iter().chain(files).collect()
}

/// Finds violations in a file. In a top-level module `super` is the crate.
fn lapses_in(file: &File, is_top: bool) -> Vec<String> {
    let (path, code) = (&file.path, code(&file.text));
    let forbidden = FORBIDDEN.into_iter().chain(is_top.then_some("super::"));
    let is_unsafe = UNSAFE_FILES.iter().any(|(_, file)| path.ends_with(file));
    let unsafe_code = (!is_unsafe).then_some("(unsafe_code, reason");
    let found = forbidden.chain(unsafe_code).filter(|forbidden| code.contains(forbidden));
    let found = found.map(|found| format!("{path} has `{found}`"));
    let lines = file.text.lines().count();
    found.chain((lines > LONGEST_FILE).then(|| format!("{path} has {lines} lines"))).collect()
}

/// Returns the text without the tests at its end and without comments.
fn code(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use crate::habits::lapses_in;
    use crate::sources::File;

    fn lapses(text: &str) -> Vec<String> {
        let file = File { path: "a.rs".to_owned(), text: text.to_owned(), parent: None };
        lapses_in(&file, true)
    }

    #[test]
    fn lapses_are_found_in_code_only() {
        let glob = format!("use b::{}", '*');
        assert_eq!(lapses(&format!("// {glob}\nuse b::c;\n#[cfg(test)]\nmod tests {{ {glob}; }}")), [""; 0]);
        assert_eq!(lapses(&format!("{glob};\nsuper::f()")), ["a.rs has `::*`", "a.rs has `super::`"]);
        assert_eq!(lapses(&"\n".repeat(501)), ["a.rs has 501 lines"]);
    }
}
