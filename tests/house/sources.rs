//! Files and modules of a crate, read along its `mod` declarations, without tests.

use std::path::{Component, Path, PathBuf};

use syn::{Attribute, Expr, Item, ItemMod, Lit, Meta};

/// Source text by path; `None` if the file does not exist.
pub(crate) type TextOf<'a> = &'a dyn Fn(&str) -> Option<String>;

/// Files and modules of one crate; the root of the crate is the first of both.
#[derive(Default)]
pub(crate) struct Sources {
    pub(crate) files: Vec<File>,
    pub(crate) modules: Vec<Module>,
}

/// One file and the file that declares it.
pub(crate) struct File {
    pub(crate) path: String,
    pub(crate) text: String,
    pub(crate) parent: Option<usize>,
}

/// One module, in a file of its own or inline, with its items other than modules.
pub(crate) struct Module {
    pub(crate) name: String,
    pub(crate) parent: Option<usize>,
    pub(crate) file: usize,
    pub(crate) items: Vec<Item>,
}

impl Sources {
    /// Reads the sources of the crate whose root is the file `root`.
    pub(crate) fn read(root: &str, text_of: TextOf) -> Self {
        let mut loader = Loader { text_of, sources: Self::default() };
        loader.file(root, "", None, &folder_of(root));
        loader.sources
    }

    /// Returns the modules from the root, which is left out, to `module`.
    pub(crate) fn path(&self, module: usize) -> Vec<&str> {
        let Module { name, parent, .. } = &self.modules[module];
        let Some(parent) = parent else { return Vec::new() };
        let mut path = self.path(*parent);
        path.push(name);
        path
    }
}

struct Loader<'a> {
    text_of: TextOf<'a>,
    sources: Sources,
}

impl Loader<'_> {
    /// Reads the file of module `name`, whose children have their files in `folder`.
    fn file(&mut self, path: &str, name: &str, parent: Option<usize>, folder: &str) {
        let text = (self.text_of)(path).unwrap_or_else(|| panic!("there is no file {path}"));
        let syntax = syn::parse_file(&text).unwrap_or_else(|error| panic!("{path}: {error}"));
        let file = self.sources.files.len();
        let declared_in = parent.map(|parent| self.sources.modules[parent].file);
        self.sources.files.push(File { path: path.to_owned(), text, parent: declared_in });
        self.module(Module { name: name.to_owned(), parent, file, items: syntax.items }, folder);
    }

    fn module(&mut self, mut module: Module, folder: &str) {
        let index = self.sources.modules.len();
        let items = std::mem::take(&mut module.items);
        self.sources.modules.push(module);
        for item in items.into_iter().filter(|item| !is_test(attributes(item))) {
            match item {
                Item::Mod(child) => self.child(index, child, folder),
                item => self.sources.modules[index].items.push(item),
            }
        }
    }

    fn child(&mut self, parent: usize, child: ItemMod, folder: &str) {
        let name = child.ident.to_string();
        let inner = join(folder, &name);
        let file = self.sources.modules[parent].file;
        if let Some((_, items)) = child.content {
            return self.module(Module { name, parent: Some(parent), file, items }, &inner);
        }
        if let Some(path) = path_attribute(&child.attrs) {
            let path = join(&folder_of(&self.sources.files[file].path), &path);
            return self.file(&path, &name, Some(parent), &folder_of(&path));
        }
        let (beside, inside) = (format!("{inner}.rs"), format!("{inner}/mod.rs"));
        let path = if (self.text_of)(&beside).is_some() { beside } else { inside };
        self.file(&path, &name, Some(parent), &inner);
    }
}

/// True if an item exists only for tests.
fn is_test(attributes: &[Attribute]) -> bool {
    let conditions = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("cfg") => Some(list.tokens.to_string()),
        _ => None,
    });
    conditions
        .into_iter()
        .any(|condition| condition == "test" || condition == "doctest" || condition.starts_with("all (test"))
}

fn path_attribute(attributes: &[Attribute]) -> Option<String> {
    attributes.iter().find_map(|attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("path") => match &pair.value {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Str(path) => Some(path.value()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    })
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Union(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn folder_of(path: &str) -> String {
    path.rsplit_once('/').map_or_else(String::new, |(folder, _)| folder.to_owned())
}

/// Returns `path` relative to `folder`, without `..`.
fn join(folder: &str, path: &str) -> String {
    let mut joined = PathBuf::new();
    for part in Path::new(folder).join(path).components() {
        if part == Component::ParentDir {
            joined.pop();
        } else {
            joined.push(part);
        }
    }
    joined.to_string_lossy().replace('\\', "/")
}

#[cfg(test)]
mod tests {
    use crate::sources::Sources;

    #[test]
    fn modules_are_found_along_declarations() {
        let text_of = |path: &str| {
            let text = match path {
                "src/lib.rs" => "mod a; mod b { mod c; } #[cfg(test)] mod tests;",
                "src/a.rs" => "mod d; #[path = \"../other/e.rs\"] mod e;",
                "src/a/d/mod.rs" | "src/b/c.rs" | "other/e.rs" => "",
                _ => return None,
            };
            Some(text.to_owned())
        };
        let sources = Sources::read("src/lib.rs", &text_of);
        let files = sources.files.iter().map(|file| file.path.as_str()).collect::<Vec<_>>();
        assert_eq!(files, ["src/lib.rs", "src/a.rs", "src/a/d/mod.rs", "other/e.rs", "src/b/c.rs"]);
        let modules = (0..6).map(|module| sources.path(module).join("::")).collect::<Vec<_>>();
        assert_eq!(modules, ["", "a", "a::d", "a::e", "b", "b::c"]);
    }
}
