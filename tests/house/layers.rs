//! Layers of the top-level modules of a crate: each imports only from earlier layers, not from its own.
//!
//! What a path names and what it leads to must both be below: a re-export does not make an import downward.
//! The root of a crate is above all layers, so that no module imports what the root itself defines.

use std::collections::BTreeSet;

use crate::imports::Crate;
use crate::tables::Library;

/// Imports from the own or from later layers.
pub(crate) fn upward_imports(krate: &Crate, library: &Library) -> Vec<String> {
    let leads = krate.imports.iter().map(|import| {
        let to = krate.module_of[import.to].as_deref();
        (import.from, to, import.line, format!("`{}` of {}", import.item, krate.files[import.to].path))
    });
    let names = krate.mentions.iter().map(|mention| {
        (mention.from, Some(mention.module.as_str()), mention.line, format!("`{}`", mention.module))
    });
    let mut complaints = BTreeSet::new();
    for (from, to, line, what) in leads.chain(names) {
        let Some(own) = krate.module_of[from].as_deref() else { continue };
        if Some(own) != to && !is_below(to, own, library) {
            complaints.insert((&krate.files[from].path, line, what));
        }
    }
    complaints.into_iter().map(|(path, line, what)| format!("{path}:{line} imports upward: {what}")).collect()
}

/// Modules that are in no layer or in several, and those in the table that do not exist.
pub(crate) fn misplaced_modules(krate: &Crate, library: &Library) -> Vec<String> {
    let exists = |name: &str| krate.modules.iter().any(|(module, _)| module == name);
    let in_table = library.layers.iter().flat_map(|layer| layer.modules);
    let unknown = in_table.clone().filter(|name| !exists(name));
    let unknown = unknown.map(|name| format!("{} has no module `{name}`", krate.name));
    let places = |name: &str| in_table.clone().filter(|module| **module == name).count();
    let misplaced =
        krate.modules.iter().map(|(name, _)| (name, places(name))).filter(|(_, count)| *count != 1);
    let misplaced = misplaced.map(|(name, count)| format!("{}: `{name}` is in {count} layers", krate.name));
    unknown.chain(misplaced).collect()
}

fn is_below(module: Option<&str>, own: &str, library: &Library) -> bool {
    let layer = |name: &str| library.layers.iter().position(|layer| layer.modules.contains(&name));
    match (module.and_then(layer), layer(own)) {
        (Some(layer), Some(own)) => layer < own,
        // What is in no layer is a complaint of its own.
        (None, _) => module.is_some(),
        (_, None) => true,
    }
}
