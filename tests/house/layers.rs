//! Layers of the top-level modules of a crate: each imports only from earlier layers, not from its
//! own.
//!
//! Both the name in a path and its target must be below: a re-export does not make an import
//! downward. The root of a crate is above all layers, so no module may import what the root itself
//! defines.

use std::collections::BTreeMap;

use crate::imports::Crate;
use crate::tables::Library;

/// Finds imports from the same or later layers, each item once for each file.
pub(crate) fn upward_imports(krate: &Crate, library: &Library) -> Vec<String> {
    let leads = krate.imports.iter().map(|import| {
        let what = format!("`{}` of {}", import.item, krate.files[import.to].path);
        (import.from, krate.module_of[import.to].as_deref(), what, import.line)
    });
    let is_led = |from: usize, module: &str| {
        let mut imports = krate.imports.iter().filter(|import| import.from == from);
        imports.any(|import| krate.module_of[import.to].as_deref() == Some(module))
    };
    let names = krate.mentions.iter().filter(|mention| !is_led(mention.from, &mention.module));
    let names = names.map(|mention| {
        (mention.from, Some(mention.module.as_str()), format!("`{}`", mention.module), mention.line)
    });
    let mut complaints = BTreeMap::new();
    for (from, to, what, line) in leads.chain(names) {
        let Some(own) = krate.module_of[from].as_deref() else { continue };
        if Some(own) != to && !is_below(to, own, library) {
            complaints.entry((&krate.files[from].path, what)).or_insert(line);
        }
    }
    let complaints = complaints.into_iter();
    complaints.map(|((path, what), line)| format!("{path}:{line} imports upward: {what}")).collect()
}

/// Finds modules in no layer or in several, and modules in the table that do not exist.
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
        // A module without a layer is a separate complaint.
        (None, _) => module.is_some(),
        (_, None) => true,
    }
}
