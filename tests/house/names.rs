//! Items of a crate, and the meanings of paths in a module. `use` items and re-exports are followed
//! to the file that defines an item. Names from macros, local variables and generic parameters are
//! unknown.

use std::collections::BTreeMap;

use syn::visit::{Visit, visit_item_use};
use syn::{Attribute, Ident, ItemUse};

use crate::sources::{Module, Sources};
use crate::uses::{GLOB, uses};

/// A named item at the level of a module.
pub(crate) struct Item {
    pub(crate) name: String,
    pub(crate) module: usize,
    pub(crate) file: usize,
    pub(crate) line: usize,
    /// True for types, aliases and traits.
    pub(crate) is_type: bool,
}

/// The target of a path.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Target {
    Module(usize),
    Item(usize),
}

/// A target, and the name behind it in the path: a variant or something associated.
pub(crate) type Found = (Target, Option<String>);

/// All names of a crate.
pub(crate) struct Names {
    pub(crate) items: Vec<Item>,
    scopes: Vec<Scope>,
}

/// Meanings of names in one module. One name may stand for a module, a type and a function.
#[derive(Default)]
struct Scope {
    parent: Option<usize>,
    meanings: BTreeMap<String, Vec<Meaning>>,
}

enum Meaning {
    Target(Target),
    Path(Vec<String>),
}

impl Names {
    pub(crate) fn of(sources: &Sources) -> Self {
        let mut names = Self { items: Vec::new(), scopes: Vec::new() };
        for module in &sources.modules {
            names.scopes.push(Scope { parent: module.parent, ..Scope::default() });
        }
        for (index, module) in sources.modules.iter().enumerate() {
            if let Some(parent) = module.parent {
                names.mean(parent, &module.name, Meaning::Target(Target::Module(index)));
            }
            names.declare(index, module);
        }
        names
    }

    /// Returns all meanings of `path` in `module`, none if it leads out of the crate.
    pub(crate) fn resolve(&self, module: usize, path: &[String]) -> Vec<Found> {
        self.follow(module, path, &mut Vec::new())
    }

    fn declare(&mut self, index: usize, module: &Module) {
        for item in &module.items {
            if let Some((name, is_type)) = definition(item) {
                let (line, file) = (name.span().start().line, module.file);
                self.mean(index, &name.to_string(), Meaning::Target(Target::Item(self.items.len())));
                self.items.push(Item { name: name.to_string(), module: index, file, line, is_type });
            }
            let mut within = Uses { names: self, module: index };
            within.visit_item(item);
        }
    }

    fn mean(&mut self, module: usize, name: &str, meaning: Meaning) {
        self.scopes[module].meanings.entry(name.to_owned()).or_default().push(meaning);
    }

    /// Follows a path. `pending` contains the names under resolution, so that no name is followed
    /// to itself.
    fn follow(&self, module: usize, path: &[String], pending: &mut Vec<(usize, String)>) -> Vec<Found> {
        let Some((first, rest)) = path.split_first() else { return Vec::new() };
        let mut found = match first.as_str() {
            "crate" => vec![(Target::Module(0), None)],
            "self" => vec![(Target::Module(module), None)],
            name => self.enter((Target::Module(module), None), name, pending),
        };
        for name in rest {
            found = found.into_iter().flat_map(|found| self.enter(found, name, pending)).collect();
        }
        found
    }

    /// Returns the meanings of `name` within an earlier result.
    fn enter(&self, found: Found, name: &str, pending: &mut Vec<(usize, String)>) -> Vec<Found> {
        match found {
            (Target::Module(module), _) if name == "super" => {
                self.scopes[module].parent.map(|parent| (Target::Module(parent), None)).into_iter().collect()
            }
            (Target::Module(module), _) => self.look_up(module, name, pending),
            (Target::Item(item), None) if self.items[item].is_type => {
                vec![(Target::Item(item), Some(name.to_owned()))]
            }
            (Target::Item(_), None) => Vec::new(),
            (item, member) => vec![(item, member)],
        }
    }

    fn look_up(&self, module: usize, name: &str, pending: &mut Vec<(usize, String)>) -> Vec<Found> {
        let key = (module, name.to_owned());
        if pending.contains(&key) {
            return Vec::new();
        }
        pending.push(key);
        let meanings = |name: &str| self.scopes[module].meanings.get(name).into_iter().flatten();
        let mut found = Vec::new();
        for meaning in meanings(name) {
            match meaning {
                Meaning::Target(target) => found.push((*target, None)),
                Meaning::Path(path) => found.extend(self.follow(module, path, pending)),
            }
        }
        for meaning in meanings(GLOB).filter(|_| name != GLOB && self.scopes[module].is_unknown(name)) {
            if let Meaning::Path(path) = meaning {
                let path = [path.as_slice(), &[name.to_owned()]].concat();
                found.extend(self.follow(module, &path, pending));
            }
        }
        pending.pop();
        found.sort();
        found.dedup();
        found
    }
}

impl Scope {
    fn is_unknown(&self, name: &str) -> bool {
        !self.meanings.contains_key(name)
    }
}

/// Visitor that collects `use` items, including those in bodies of functions.
struct Uses<'a> {
    names: &'a mut Names,
    module: usize,
}

impl<'ast> Visit<'ast> for Uses<'_> {
    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        for found in uses(item) {
            self.names.mean(self.module, &found.name, Meaning::Path(found.path));
        }
        visit_item_use(self, item);
    }
}

/// Returns the name that an item defines, and true if it is a type, an alias or a trait. Macros for
/// other crates are left out, since paths from outside name them.
fn definition(item: &syn::Item) -> Option<(&Ident, bool)> {
    Some(match item {
        syn::Item::Enum(item) => (&item.ident, true),
        syn::Item::Struct(item) => (&item.ident, true),
        syn::Item::Trait(item) => (&item.ident, true),
        syn::Item::Type(item) => (&item.ident, true),
        syn::Item::Union(item) => (&item.ident, true),
        syn::Item::Const(item) => (&item.ident, false),
        syn::Item::Fn(item) => (&item.sig.ident, false),
        syn::Item::Macro(item) if !is_exported(&item.attrs) => (item.ident.as_ref()?, false),
        syn::Item::Static(item) => (&item.ident, false),
        _ => return None,
    })
}

fn is_exported(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("macro_export"))
}
