//! Text that users of a crate read: documentation of modules and public items, and messages.
//!
//! Documentation is told apart by lines and their indentation, which `cargo fmt` keeps. Within a
//! function or a macro it belongs to code that these write, and is public.

use proc_macro2::{TokenStream, TokenTree};
use syn::Lit;

/// Words that begin an item, behind its visibility and modifiers.
const KEYWORDS: [&str; 9] = ["enum", "fn", "impl", "macro_rules!", "mod", "struct", "trait", "type", "union"];

/// Words that may stand in front of a keyword.
const MODIFIERS: [&str; 5] = ["async", "const", "default", "extern", "unsafe"];

/// True if the comment that begins at this line, counted from zero, documents a module or an item
/// that is public.
pub(crate) fn is_public(lines: &[&str], start: usize) -> bool {
    let comment = lines[start].trim_start();
    comment.starts_with("//!") || comment.starts_with("///") && documents_public_item(lines, start)
}

fn documents_public_item(lines: &[&str], start: usize) -> bool {
    let indent = indent(lines[start]);
    let is_item = |line: &&&str| {
        self::indent(line) == indent && !line.trim_start().starts_with(['/', '#', ')']) && !line.is_empty()
    };
    let item = lines[start..].iter().find(is_item).map_or("", |line| line.trim_start());
    let is_public = item.starts_with("pub ") || item.starts_with("macro_rules!");
    let mut outer = lines[..start].iter().rev().filter(|line| !line.trim().is_empty());
    match outer.find_map(|line| (self::indent(line) < indent).then(|| head(line))?) {
        None | Some((_, "impl")) => is_public,
        Some((outer_is_public, "enum" | "trait")) => outer_is_public,
        Some((outer_is_public, "struct" | "mod" | "union")) => outer_is_public && is_public,
        Some(_) => true,
    }
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

/// Returns the keyword of the item that begins on a line, with true if the item is public.
fn head(line: &str) -> Option<(bool, &'static str)> {
    let line = line.trim_start();
    let mut words = line
        .split_whitespace()
        .skip_while(|word| word.starts_with("pub") || word.ends_with(')') || MODIFIERS.contains(word));
    let word = words.next()?.split('<').next()?;
    let keyword = KEYWORDS.into_iter().find(|keyword| *keyword == word)?;
    Some((line.starts_with("pub "), keyword))
}

/// Returns the texts in a file of Rust, without documentation, with the lines where they begin,
/// counted from one.
pub(crate) fn literals(file: &str) -> Vec<(usize, String)> {
    let mut literals = Vec::new();
    let mut pending = vec![file.parse::<TokenStream>().unwrap_or_default()];
    while let Some(tokens) = pending.pop() {
        for token in tokens {
            match token {
                TokenTree::Group(group) if is_documentation(&group.stream()) => {}
                TokenTree::Group(group) => pending.push(group.stream()),
                TokenTree::Literal(literal) => {
                    let line = literal.span().start().line;
                    if let Lit::Str(text) = Lit::new(literal) {
                        literals.push((line, text.value()));
                    }
                }
                _ => {}
            }
        }
    }
    literals
}

/// True if these are the tokens of an attribute that a comment stands for.
fn is_documentation(tokens: &TokenStream) -> bool {
    matches!(tokens.clone().into_iter().next(), Some(TokenTree::Ident(name)) if name == "doc")
}

#[cfg(test)]
mod tests {
    use crate::readers::{is_public, literals};

    #[test]
    fn documentation_is_public_with_its_item() {
        let file = "//! 1\n/// 2\npub(crate) enum A {\n    /// 3\n    B,\n}\n/// 4\n#[rule(\n    a\n)]\n\
            pub unsafe trait T<S>\nwhere\n    S: Copy,\n{\n    /// 5\n    fn f();\n}\nimpl A {\n    /// 6\n    \
            pub fn g() {\n        // 7\n        quote! {\n            /// 8\n            fn h() {}\n        }\n    \
            }\n    /// 9\n    pub(in crate::a) fn i() {}\n}\n";
        let lines = file.lines().collect::<Vec<_>>();
        let comments = lines.iter().enumerate().filter(|(_, line)| line.trim_start().starts_with("//"));
        let public = comments.map(|(index, _)| is_public(&lines, index));
        let expected = [true, false, false, true, true, true, false, true, false];
        assert_eq!(public.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn texts_are_literals_but_no_documentation() {
        let file = "/// Doc.\nfn f() {\n    g(\"a \\\n       b\", 'c', 1);\n}";
        assert_eq!(literals(file), [(3, "a b".to_owned())]);
    }
}
