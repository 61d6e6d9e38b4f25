//! A crate with the accelerations of chains in several variants, and its measurements.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use super::ideas::{Chain, Derivation};

/// A function in the crate.
pub(super) struct Variant {
    pub(super) chain: Chain,
    /// Index of the idea.
    pub(super) idea: usize,
    /// Index of the idea used for comparison.
    pub(super) base: usize,
    pub(super) derivation: Derivation,
}

/// Writes the crate and returns its folder.
pub(super) fn write(root: &Path, variants: &[Variant]) -> Result<PathBuf, String> {
    let folder = root.join("target/performance");
    let source = source(root, variants)?;
    let written = fs::create_dir_all(folder.join("src"))
        .and_then(|()| fs::write(folder.join("Cargo.toml"), manifest(root)))
        .and_then(|()| fs::write(folder.join("src/main.rs"), source));
    written.map_err(|error| format!("{}: {error}", folder.display()))?;
    Ok(folder)
}

fn manifest(root: &Path) -> String {
    format!(
        "[package]\nname = \"variants\"\nedition = \"2024\"\n\n[workspace]\n\n\
         [dependencies]\nlagrange = {{ path = {root:?} }}\n"
    )
}

/// Returns the functions in modules, and a program that prints a row for each function with a base
/// for comparison.
fn source(root: &Path, variants: &[Variant]) -> Result<String, String> {
    let mut source = format!("#[path = {:?}]\nmod timing;\n", root.join("benches/timing.rs"));
    for variant in variants {
        let function = variant.derivation.function()?;
        let _ = write!(
            source,
            "#[allow(warnings)]\nmod {} {{\n{function}\n}}\n",
            module(variant.chain, variant.idea)
        );
    }
    source.push_str("fn main() {\n");
    variants
        .iter()
        .filter(|variant| variant.idea != variant.base)
        .for_each(|variant| call(&mut source, variant));
    source.push_str("}\n");
    Ok(source)
}

fn call(source: &mut String, Variant { chain, idea, base, .. }: &Variant) {
    let n = chain.links;
    let [first, second] = [*idea, *base].map(|idea| module(*chain, idea));
    let function = |module: &str| {
        format!("|q: &[f64; {n}], v: &[f64; {n}]| {module}::acceleration(std::hint::black_box(&p), q, v)")
    };
    let _ = writeln!(
        source,
        "{{ let p: [f64; {fields}] = std::array::from_fn(|k| match k {{ {last} => 9.81, k if k < {n} => 1.0 + 0.1 * k as f64, \
         k => 0.8 + 0.05 * (k - {n}) as f64 }});\n\
         println!(\"| {title} | {idea} | {{}} |\", timing::in_turns({}, {})); }}",
        function(&first),
        function(&second),
        fields = 2 * n + 1,
        last = 2 * n,
        title = chain.title(),
    );
}

fn module(chain: Chain, idea: usize) -> String {
    format!("{}_{}_{idea}", chain.kind, chain.links)
}
