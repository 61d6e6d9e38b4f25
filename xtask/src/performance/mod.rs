//! `cargo xtask performance`: measures, and rewrites the tables of docs/performance.md. `cargo
//! xtask performance spatial` only does so for bodies in space, and `cargo xtask performance text`
//! for declarations in text, with the table of docs/command_line.md.

mod crate_of_variants;
mod declared;
mod document;
mod ideas;
mod machine;
mod run;
mod tables;
mod undo;

use std::path::Path;

use crate_of_variants::Variant;
use declared::Declared;
use ideas::{Chain, Derivation, Idea, ideas};
use lagrange_core::accuracy::Accuracy;
use run::{DEFAULT, NATIVE, Target, cargo};
use tables::{Comparison, Measured};

const DOCUMENT: &str = "docs/performance.md";
/// The page with motions of declarations in text.
const COMMAND_LINE: &str = "docs/command_line.md";
/// Chains whose operations are counted to show the growth of cost.
const GROWING: [(&str, usize); 7] = [
    ("absolute", 20),
    ("absolute", 30),
    ("absolute", 100),
    ("absolute", 200),
    ("relative", 20),
    ("relative", 100),
    ("relative", 200),
];
/// Chains on which ideas are evaluated.
const VARIED: [(&str, usize); 4] = [("absolute", 5), ("absolute", 10), ("absolute", 20), ("relative", 8)];

/// Measures the sections with these names, or everything if there are none.
///
/// # Errors
/// With the usage for other words, and if something cannot be compiled or run.
pub(crate) fn performance(root: &Path, sections: &[&str]) -> Result<(), String> {
    match sections {
        [] => everything(root),
        ["chains"] => chains(root),
        ["spatial"] => spatial(root),
        ["text"] => declared(root),
        _ => Err("usage: cargo xtask performance [chains | spatial | text]".to_owned()),
    }
}

/// Measures everything and updates the document.
fn everything(root: &Path) -> Result<(), String> {
    let growth = tables::growth(&counted(root)?);
    let ideas = ideas();
    let variants = variants(root, &ideas)?;
    let folder = crate_of_variants::write(root, &variants)?;
    let varied = [DEFAULT, NATIVE].map(|target| measured_variants(root, &folder, &target));
    let varied = tables::ideas(&ideas, &variants, &VARIED.map(chain), &collected(varied)?);
    let varied = format!("{}\n{varied}", machine::description()?);
    let sections = [("growth", growth), ("ideas", varied), ("spatial", measured_spatial(root)?)];
    document::rewrite(&root.join(DOCUMENT), &sections)?;
    chains(root)?;
    declared(root)
}

/// Measures chains beside handwritten code and updates the document.
fn chains(root: &Path) -> Result<(), String> {
    let compared = collected([DEFAULT, NATIVE].map(|target| compared(root, &target, "comparison")))?;
    let sections = [
        ("machine", machine::description()?),
        ("standard", tables::beside_by_hand("standard", &compared)),
        ("fast", tables::beside_by_hand("fast", &compared)),
        ("strict", tables::strict(&compared)),
    ];
    document::rewrite(&root.join(DOCUMENT), &sections)
}

/// Measures bodies in space and updates the document.
fn spatial(root: &Path) -> Result<(), String> {
    document::rewrite(&root.join(DOCUMENT), &[("spatial", measured_spatial(root)?)])
}

/// Measures declarations in text and updates the tables of both pages.
fn declared(root: &Path) -> Result<(), String> {
    let (folder, load) = (root.join("crates/lagrange-jit"), machine::load());
    let printed = cargo(root, &folder, &DEFAULT, &["bench", "--quiet", "--locked"])?;
    let rows = run::rows(&printed).filter_map(|cells| Declared::read(&cells)).collect::<Vec<_>>();
    if rows.is_empty() {
        return Err(format!("no row in the output of the benchmark:\n{printed}"));
    }
    let head = format!("{}{}\n", machine::description()?, load);
    for (page, table) in [(DOCUMENT, declared::rates(&rows)), (COMMAND_LINE, declared::motions(&rows))] {
        document::rewrite(&root.join(page), &[("text", format!("{head}{table}"))])?;
    }
    Ok(())
}

fn measured_spatial(root: &Path) -> Result<String, String> {
    let measured = collected([DEFAULT, NATIVE].map(|target| compared(root, &target, "spatial")))?;
    Ok(format!("{}\n{}", machine::description()?, tables::spatial(&measured)))
}

fn chain((kind, links): (&'static str, usize)) -> Chain {
    Chain { kind, links }
}

fn collected<T, const N: usize>(results: [Result<T, String>; N]) -> Result<Vec<T>, String> {
    results.into_iter().collect()
}

/// Counts the operations of the emitted accelerations of chains.
fn counted(root: &Path) -> Result<Vec<(Chain, usize)>, String> {
    let ideas = ideas();
    let count = |chain| Ok((chain, Derivation::of(root, chain, &ideas[0])?.operations()));
    GROWING.map(chain).into_iter().map(count).collect()
}

fn variants(root: &Path, ideas: &[Idea]) -> Result<Vec<Variant>, String> {
    let mut variants = Vec::new();
    for (idea, described) in ideas.iter().enumerate() {
        let base = base(ideas, described.accuracy);
        for chain in VARIED.map(chain) {
            variants.push(Variant { chain, idea, base, derivation: Derivation::of(root, chain, described)? });
        }
    }
    Ok(variants)
}

/// Returns the index of the base idea of a level.
fn base(ideas: &[Idea], accuracy: Accuracy) -> usize {
    ideas.iter().position(|idea| idea.accuracy == accuracy).unwrap_or(0)
}

fn measured_variants(root: &Path, folder: &Path, target: &Target) -> Result<Vec<Measured>, String> {
    let printed = cargo(root, folder, target, &["run", "--release", "--quiet"])?;
    Ok(run::rows(&printed).filter_map(|cells| Measured::read(&cells)).collect())
}

/// Returns the rows of a benchmark that times two functions alternately.
fn compared(root: &Path, target: &Target, bench: &str) -> Result<Vec<Comparison>, String> {
    let arguments = ["bench", "--quiet", "--package", "lagrange-benches", "--bench", bench];
    let printed = cargo(root, root, target, &arguments)?;
    Ok(run::rows(&printed).filter_map(|cells| Comparison::read(&cells)).collect())
}
