//! The house rules, most of which concern several files, checked on the sources of every crate of
//! the workspace.
//!
//! 1. No circle of files ([`circles`]).
//! 2. Every top-level module is in one layer and imports only from earlier layers ([`layers`]).
//!    `ARCHITECTURE.md` shows the table of layers ([`tables`], [`architecture`]).
//! 3. Few types of one crate share a name ([`homonyms`]).
//! 4. Imports are explicit, failures are handled, files are short, and no code is unsafe
//!    ([`habits`]).
//! 5. Documentation is plain English ([`english`]), in short sentences and narrow paragraphs
//!    ([`prose`]), that of tests included, and so are messages ([`literals`]).
//! 6. Published packages have complete manifests ([`packages`]).
//! 7. The book contains every page, its links are valid, and its code is tested ([`book`]).
//!
//! Sources become files and modules ([`sources`]), then items and the meanings of names ([`names`],
//! [`methods`], [`receivers`]). With these a walk through the code ([`walk`]) finds the
//! dependencies of each file ([`imports`]). The rules on imports, names and habits leave out tests.

mod architecture;
mod book;
mod circles;
mod english;
mod habits;
mod homonyms;
mod imports;
mod layers;
mod literals;
mod made_up;
mod methods;
mod names;
mod packages;
mod prose;
mod receivers;
mod sources;
mod standard;
mod tables;
mod tokens;
mod uses;
mod walk;
mod workspace;

use crate::imports::Crate;
use crate::tables::{LIBRARIES, Library};
use crate::workspace::{Workspace, workspace};

#[test]
fn no_files_import_each_other_in_a_circle() {
    let skipped: usize = workspace().crates.iter().map(|krate| krate.ambiguous_calls).sum();
    println!("{skipped} calls of methods are left out, as several types have a method of that name.");
    nothing_in(workspace().crates.iter().flat_map(circles::circles));
}

#[test]
fn modules_import_only_from_earlier_layers() {
    nothing_in(each_library(layers::upward_imports));
}

#[test]
fn every_module_is_in_one_layer() {
    let libraries = workspace().misplaced_libraries();
    nothing_in(libraries.into_iter().chain(each_library(layers::misplaced_modules)));
}

#[test]
fn architecture_shows_the_layers() {
    architecture::check(&workspace().root);
}

#[test]
fn packages_have_complete_manifests() {
    nothing_in(packages::lapses(&workspace().root));
}

#[test]
fn documents_name_files_that_exist() {
    nothing_in(architecture::missing_paths(&workspace().root));
}

#[test]
fn every_page_is_in_the_book() {
    let root = &workspace().root;
    nothing_in(book::unlisted(root).into_iter().chain(book::examples_without_line(root)));
}

#[test]
fn links_of_pages_lead_somewhere() {
    let root = &workspace().root;
    let sections = book::missing_sections(root).into_iter().chain(book::dead_ends(root));
    nothing_in(book::dead_links(root).into_iter().chain(sections));
}

#[test]
fn code_of_pages_is_tested() {
    nothing_in(book::untested(&workspace().root));
}

#[test]
fn every_file_keeps_the_habits() {
    nothing_in(each_library(|krate, _| habits::lapses(krate)));
}

#[test]
fn few_names_are_defined_twice() {
    nothing_in(workspace().crates.iter().filter_map(homonyms::too_many));
}

#[test]
fn documentation_is_plain_english() {
    let Workspace { root, files, .. } = workspace();
    nothing_in(english::openings(files).into_iter().chain(english::phrases(root, files)));
}

#[test]
fn documentation_of_functions_begins_with_a_verb() {
    nothing_in(english::functions_without_verb(&workspace().files));
}

#[test]
fn sentences_are_short() {
    let Workspace { root, crates, files } = workspace();
    nothing_in(english::sentences(root, crates, files));
}

#[test]
fn paragraphs_are_wrapped() {
    let Workspace { root, files, .. } = workspace();
    nothing_in(english::wide_files(root, files).into_iter().chain(book::wide_code(root)));
}

fn each_library(rule: fn(&Crate, &Library) -> Vec<String>) -> Vec<String> {
    let crates = &workspace().crates;
    let read = |library: &Library| crates.iter().find(|krate| krate.name == library.name);
    LIBRARIES.iter().filter_map(|library| Some(rule(read(library)?, library))).flatten().collect()
}

#[track_caller]
fn nothing_in(complaints: impl IntoIterator<Item = String>) {
    let complaints = complaints.into_iter().collect::<Vec<_>>();
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}
