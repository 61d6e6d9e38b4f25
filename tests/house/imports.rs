//! Imports from file to file: the targets of `use` items and paths in code, and the files of called
//! methods.

use crate::methods::Methods;
use crate::names::{Item, Names};
use crate::receivers::Declared;
use crate::sources::{File, Sources, TextOf};
use crate::walk::{Known, Needs, needs};

/// The contents of a crate that matter to the rules.
pub(crate) struct Crate {
    pub(crate) name: String,
    pub(crate) files: Vec<File>,
    /// Top-level modules with files of their own, by name and file.
    pub(crate) modules: Vec<(String, usize)>,
    /// Top-level module of each file; the root of the crate has none.
    pub(crate) module_of: Vec<Option<String>>,
    pub(crate) types: Vec<Item>,
    pub(crate) imports: Vec<Import>,
    pub(crate) mentions: Vec<Mention>,
    /// Number of calls that might refer to methods in several files.
    pub(crate) ambiguous_calls: usize,
}

/// One file needs what another file defines.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Import {
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) line: usize,
    pub(crate) item: String,
}

/// A path in a file that names a top-level module, wherever the path leads.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Mention {
    pub(crate) from: usize,
    pub(crate) module: String,
    pub(crate) line: usize,
}

impl Crate {
    /// Reads the crate whose root is the file `root`.
    pub(crate) fn read(name: &str, root: &str, text_of: TextOf) -> Self {
        let sources = Sources::read(root, text_of);
        let names = Names::of(&sources);
        let (methods, declared) = (Methods::of(&sources, &names), Declared::of(&sources, &names));
        let known = Known { sources: &sources, names: &names, methods, declared };
        let Needs { mut imports, mut mentions, ambiguous_calls } = needs(&known);
        imports.sort();
        imports.dedup();
        mentions.sort();
        mentions.dedup();
        let (modules, module_of) = top_level(&sources);
        let types = names.items.into_iter().filter(|item| item.is_type).collect();
        let (name, files) = (name.to_owned(), sources.files);
        Self { name, files, modules, module_of, types, imports, mentions, ambiguous_calls }
    }
}

/// Returns top-level modules with their files, and the top-level module of each file.
fn top_level(sources: &Sources) -> (Vec<(String, usize)>, Vec<Option<String>>) {
    let mut modules = Vec::new();
    let mut module_of = vec![None; sources.files.len()];
    for (index, module) in sources.modules.iter().enumerate().filter(|(_, module)| module.file != 0) {
        let path = sources.path(index);
        module_of[module.file] = Some(path[0].to_owned());
        if path.len() == 1 {
            modules.push((path[0].to_owned(), module.file));
        }
    }
    (modules, module_of)
}
