//! Methods of the crate's own types, by name. Where one type has `impl` blocks in several files, a
//! call leads to the file of the method, not to that of the type.

use std::collections::{BTreeMap, BTreeSet};

use syn::{ImplItem, ItemImpl, Type};

use crate::names::{Names, Target};
use crate::sources::Sources;

/// Files in which a type has a method, by the name of the method and the type. Methods of traits
/// are left out, since callers import the trait.
#[derive(Default)]
pub(crate) struct Methods(BTreeMap<String, BTreeSet<(usize, usize)>>);

/// The file of a called method.
#[derive(PartialEq, Eq, Debug)]
pub(crate) enum MethodFile {
    One(usize),
    /// Several candidates, of one type or of several types.
    Ambiguous,
    /// No method of the crate's own.
    None,
}

impl Methods {
    pub(crate) fn of(sources: &Sources, names: &Names) -> Self {
        let mut methods = Self::default();
        for (index, module) in sources.modules.iter().enumerate() {
            let blocks = module.items.iter().filter_map(|item| match item {
                syn::Item::Impl(block) if block.trait_.is_none() => Some(block),
                _ => None,
            });
            for block in blocks {
                methods.add(block, self_type(block, index, names), module.file);
            }
        }
        methods
    }

    /// Returns the file of the method `name` of a possible type.
    pub(crate) fn file(&self, name: &str, is_possible: impl Fn(usize) -> bool) -> MethodFile {
        let methods = self.0.get(name).into_iter().flatten();
        let files = methods.filter(|(item, _)| is_possible(*item)).map(|(_, file)| *file);
        let files = files.collect::<BTreeSet<_>>();
        match files.first() {
            Some(file) if files.len() == 1 => MethodFile::One(*file),
            Some(_) => MethodFile::Ambiguous,
            None => MethodFile::None,
        }
    }

    fn add(&mut self, block: &ItemImpl, item: Option<usize>, file: usize) {
        let Some(item) = item else { return };
        for method in &block.items {
            if let ImplItem::Fn(method) = method {
                self.0.entry(method.sig.ident.to_string()).or_default().insert((item, file));
            }
        }
    }
}

/// Returns the crate's own type that a block implements.
pub(crate) fn self_type(block: &ItemImpl, module: usize, names: &Names) -> Option<usize> {
    let Type::Path(path) = block.self_ty.as_ref() else { return None };
    let path = path.path.segments.iter().map(|segment| segment.ident.to_string()).collect::<Vec<_>>();
    names.resolve(module, &path).into_iter().find_map(|(target, _)| match target {
        Target::Item(item) if names.items[item].is_type => Some(item),
        _ => None,
    })
}
