//! `use` items, as one path for each name that they bring into scope.

use syn::{ItemUse, UseTree, Visibility};

/// One name that a `use` item brings into scope. The name of a glob is [`GLOB`].
pub(crate) struct Use {
    pub(crate) path: Vec<String>,
    pub(crate) name: String,
    pub(crate) line: usize,
    pub(crate) is_reexport: bool,
}

pub(crate) const GLOB: &str = "*";

/// Returns the names of a `use` item. Paths from outside, which begin with `::`, have none.
pub(crate) fn uses(item: &ItemUse) -> Vec<Use> {
    let mut found = Vec::new();
    if item.leading_colon.is_none() {
        let is_reexport = !matches!(item.vis, Visibility::Inherited);
        leaves(&item.tree, &[], is_reexport, &mut found);
    }
    found
}

fn leaves(tree: &UseTree, before: &[String], is_reexport: bool, found: &mut Vec<Use>) {
    let (ident, name) = match tree {
        UseTree::Path(path) => {
            let before = [before, &[path.ident.to_string()]].concat();
            return leaves(&path.tree, &before, is_reexport, found);
        }
        UseTree::Group(group) => {
            return group.items.iter().for_each(|tree| leaves(tree, before, is_reexport, found));
        }
        UseTree::Glob(glob) => {
            let line = glob.star_token.spans[0].start().line;
            return found.push(Use { path: before.to_vec(), name: GLOB.to_owned(), line, is_reexport });
        }
        UseTree::Name(name) => (&name.ident, &name.ident),
        UseTree::Rename(rename) => (&rename.ident, &rename.rename),
    };
    let is_self = ident == "self" && !before.is_empty();
    let path = if is_self { before.to_vec() } else { [before, &[ident.to_string()]].concat() };
    let name = if ident == name { path.last().cloned().unwrap_or_default() } else { name.to_string() };
    found.push(Use { path, name, line: ident.span().start().line, is_reexport });
}

#[cfg(test)]
mod tests {
    use crate::uses::uses;

    #[test]
    fn groups_are_taken_apart() {
        let item = syn::parse_str("pub use crate::a::{self, b::C as D, e::*};").expect("an item");
        let found = uses(&item).into_iter().map(|found| format!("{}={}", found.name, found.path.join("::")));
        assert_eq!(found.collect::<Vec<_>>(), ["a=crate::a", "D=crate::a::b::C", "*=crate::a::e"]);
    }
}
