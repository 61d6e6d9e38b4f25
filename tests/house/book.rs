//! The pages of `docs/`, which are those of the book: each is listed, its links are valid, and its
//! code is tested.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::prose::MAX_COLUMNS;

/// Pages beside those of `docs/`.
const OTHERS: [&str; 8] = [
    "ARCHITECTURE.md",
    "CHANGELOG.md",
    "README.md",
    "src/language.md",
    "src/overview.md",
    "tests/README.md",
    "tests/extremes/README.md",
    "tests/oracle/README.md",
];

/// The table of contents.
const CONTENTS: &str = "docs/SUMMARY.md";

/// The files that compile and run the code of pages.
const TESTS: [&str; 2] = ["lagrange-core/src/lib.rs", "tests/book/src/lib.rs"];

/// Blocks that need what tests lack: a device, MPI, a cluster.
const UNTESTED: [(&str, usize); 2] = [("docs/cluster.md", 2), ("docs/ensembles.md", 1)];

/// Returns the paths of all pages of the project that readers see.
pub(crate) fn pages(root: &Path) -> Vec<String> {
    let others = OTHERS.iter().map(|page| (*page).to_owned());
    others.chain(book(root)).collect()
}

/// Returns the paths of the pages of the book, without the table of contents.
pub(crate) fn book(root: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut pending = vec![root.join("docs")];
    while let Some(folder) = pending.pop() {
        for entry in fs::read_dir(folder).expect("a folder of pages") {
            let path = entry.expect("a file").path();
            if path.is_dir() {
                pending.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                found.push(path.strip_prefix(root).expect("within").to_string_lossy().into_owned());
            }
        }
    }
    found.retain(|page| page != CONTENTS);
    found.sort();
    found
}

/// Finds pages that the table of contents leaves out or names twice.
pub(crate) fn unlisted(root: &Path) -> Vec<String> {
    let contents = text(root, CONTENTS);
    let named = links(&contents).into_iter().map(|(_, link)| format!("docs/{link}")).collect::<Vec<_>>();
    let times = |page: &String| named.iter().filter(|name| *name == page).count();
    let pages = book(root).into_iter().filter(|page| times(page) != 1);
    pages.map(|page| format!("{CONTENTS} names {page} {} times", times(&page))).collect()
}

/// Finds examples to which the gallery has no link.
pub(crate) fn examples_without_line(root: &Path) -> Vec<String> {
    let gallery = text(root, "docs/gallery/README.md");
    let entries = fs::read_dir(root.join("examples")).expect("a folder").map(|entry| entry.expect("a file"));
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let programs = names.filter(|name| name.ends_with(".rs"));
    let missing = programs.filter(|name| !gallery.contains(&format!("](../../examples/{name})")));
    missing.map(|name| format!("the gallery does not lead to examples/{name}")).collect()
}

/// Finds pages whose end does not name the next page.
pub(crate) fn dead_ends(root: &Path) -> Vec<String> {
    let dead = book(root).into_iter().filter(|page| {
        let text = text(root, page);
        text.lines().rfind(|line| line.starts_with("## ")) != Some("## Where next")
    });
    dead.map(|page| format!("{page} does not end with \"## Where next\"")).collect()
}

/// Finds links to files or headings that do not exist.
pub(crate) fn dead_links(root: &Path) -> Vec<String> {
    let pages = pages(root).into_iter().chain([CONTENTS.to_owned()]);
    let dead = pages.flat_map(|page| {
        let links = links(&text(root, &page)).into_iter();
        let dead = links.filter(|(_, link)| !leads_somewhere(root, &page, link));
        dead.map(|(line, link)| format!("{page}:{line}: {link} leads nowhere")).collect::<Vec<_>>()
    });
    dead.collect()
}

fn leads_somewhere(root: &Path, page: &str, link: &str) -> bool {
    if ["http:", "https:", "crate::", "mod@"].iter().any(|start| link.starts_with(start)) {
        return true;
    }
    let (path, heading) = link.split_once('#').unwrap_or((link, ""));
    let folder = Path::new(page).parent().unwrap_or(Path::new(""));
    let target = if path.is_empty() { PathBuf::from(page) } else { folder.join(path) };
    let is_there = root.join(&target).exists();
    is_there && (heading.is_empty() || headings(root, &target.to_string_lossy()).contains(heading))
}

/// Returns the names of the headings of a page, with those of included sections.
fn headings(root: &Path, page: &str) -> BTreeSet<String> {
    let sections = included(root, page).into_iter().filter_map(|(_, section)| section);
    let texts = sections.chain([text(root, page)]).collect::<Vec<_>>();
    let lines = texts.iter().flat_map(|text| prose(text));
    lines.filter(|(_, line)| line.starts_with('#')).map(|(_, line)| name_of_heading(line)).collect()
}

/// Finds sections that pages include but that do not exist.
pub(crate) fn missing_sections(root: &Path) -> Vec<String> {
    let missing = book(root).into_iter().flat_map(|page| {
        let missing = included(root, &page).into_iter().filter(|(_, section)| section.is_none());
        missing.map(|(name, _)| format!("{page} includes {name}, which does not exist")).collect::<Vec<_>>()
    });
    missing.collect()
}

/// Returns the names and texts of the sections of other pages that a page includes.
fn included(root: &Path, page: &str) -> Vec<(String, Option<String>)> {
    let folder = Path::new(page).parent().unwrap_or(Path::new(""));
    let page = text(root, page);
    let names = page.lines().filter_map(|line| line.strip_prefix("{{#include ")?.strip_suffix("}}"));
    let section_of = |name: &str| {
        let (path, anchor) = name.split_once(':')?;
        section(&text(root, &folder.join(path).to_string_lossy()), anchor)
    };
    names.map(|name| (name.to_owned(), section_of(name))).collect()
}

/// Returns the section of a page between the comments that name it.
fn section(text: &str, anchor: &str) -> Option<String> {
    let (_, rest) = text.split_once(&format!("<!-- ANCHOR: {anchor} -->"))?;
    let (section, _) = rest.split_once(&format!("<!-- ANCHOR_END: {anchor} -->"))?;
    Some(section.to_owned())
}

/// Finds pages with code that no test compiles or runs.
pub(crate) fn untested(root: &Path) -> Vec<String> {
    let tests = TESTS.map(|file| text(root, file)).concat();
    let complaint = |page: String| {
        let blocks = blocks(&text(root, &page));
        let number = |found: fn(&str) -> bool| blocks.iter().filter(|block| found(block)).count();
        let allowed = UNTESTED.iter().find(|(path, _)| *path == page).map_or(0, |(_, blocks)| *blocks);
        let skipped = number(|block| block.contains("ignore") || block.contains("no_run"));
        let is_tested = tests.contains(&format!("{}\"", page.trim_start_matches("docs/")));
        if number(|block| block == "rust") > 0 && !is_tested {
            Some(format!("no test compiles the code of {page}"))
        } else if skipped != allowed {
            Some(format!("{page} has {skipped} blocks that do not run, instead of {allowed}"))
        } else {
            (number(str::is_empty) > 0).then(|| format!("{page} has a block of no language"))
        }
    };
    book(root).into_iter().filter_map(complaint).collect()
}

/// Finds lines of code that are wider than the book. Those of `text` show what tools write.
pub(crate) fn wide_code(root: &Path) -> Vec<String> {
    let mut wide = Vec::new();
    for page in book(root) {
        let mut fence = None;
        for (index, line) in text(root, &page).lines().enumerate() {
            if let Some(language) = line.trim_start().strip_prefix("```") {
                fence = if fence.is_none() { Some(language.to_owned()) } else { None };
            } else if fence.as_deref().is_some_and(|language| language != "text")
                && line.chars().count() > MAX_COLUMNS
            {
                wide.push(format!("{page}:{}: this line is wider than {MAX_COLUMNS} columns", index + 1));
            }
        }
    }
    wide
}

/// Returns the text behind the fences that begin blocks.
fn blocks(text: &str) -> Vec<String> {
    let fences = text.lines().filter_map(|line| line.trim_start().strip_prefix("```"));
    fences.step_by(2).map(str::to_owned).collect()
}

/// Returns the targets of links outside of code, with their lines, counted from one.
fn links(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (line, text) in prose(text) {
        let without_code = text.split('`').step_by(2).collect::<String>();
        let targets = without_code.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        found.extend(targets.map(|target| (line, target.to_owned())));
    }
    found
}

/// Returns the lines outside of blocks of code, with their numbers, counted from one.
fn prose(text: &str) -> Vec<(usize, &str)> {
    let mut is_code = false;
    let mut found = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let is_fence = line.trim_start().starts_with("```");
        if !is_code && !is_fence {
            found.push((index + 1, line));
        }
        is_code ^= is_fence;
    }
    found
}

/// Returns the name by which links reach a heading.
fn name_of_heading(line: &str) -> String {
    let kept = line.trim_start_matches('#').trim().chars();
    let kept = kept.filter(|sign| sign.is_alphanumeric() || " -_".contains(*sign));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

fn text(root: &Path, page: &str) -> String {
    fs::read_to_string(root.join(page)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use crate::book::{blocks, links, name_of_heading, section};

    #[test]
    fn links_are_those_outside_of_code() {
        let text = "A [b](c.md#d) and [`e`](f)\n```rust\n[g](h)\n```\n`if [i](j k)`\n";
        assert_eq!(links(text), [(1, "c.md#d".to_owned()), (1, "f".to_owned())]);
        assert_eq!(blocks(text), ["rust"]);
    }

    #[test]
    fn headings_have_names() {
        assert_eq!(name_of_heading("## 1. Text to `a`: b"), "1-text-to-a-b");
    }

    #[test]
    fn sections_stand_between_comments() {
        let text = "a\n<!-- ANCHOR: b -->c\n<!-- ANCHOR_END: b -->\n";
        assert_eq!(section(text, "b"), Some("c\n".to_owned()));
        assert_eq!(section(text, "a"), None);
    }
}
