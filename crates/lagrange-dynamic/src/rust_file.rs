//! Declarations in Rust files.

use std::ops::Range;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A declaration in `system! { … }`.
struct Declaration {
    /// Name of the struct; empty if it has none.
    name: String,
    /// Byte range between the braces.
    inside: Range<usize>,
}

/// Blanks everything except one declaration, which keeps its position. Texts without the macro stay
/// unchanged.
///
/// # Errors
/// If there are several and no name is given, or none has the name.
pub(crate) fn with_declaration(text: &str, name: Option<&str>) -> Result<String, String> {
    let declarations = declarations(text);
    let names = || declarations.iter().map(|one| format!("`#{}`", one.name)).collect::<Vec<_>>().join(", ");
    match (&*declarations, name) {
        ([], None) => Ok(text.to_owned()),
        ([], Some(name)) => Err(format!("there is no `system!`, so no `#{name}`")),
        ([one], None) => Ok(alone(text, one)),
        (_, None) => {
            Err(format!("several declarations: write one of {} behind the name of the file", names()))
        }
        (all, Some(name)) => {
            let named = all.iter().find(|one| one.name == name);
            named.map(|one| alone(text, one)).ok_or_else(|| format!("no `#{name}` among {}", names()))
        }
    }
}

/// Blanks everything before a declaration, and removes everything after it.
fn alone(text: &str, declaration: &Declaration) -> String {
    let blank = |c: char| if c == '\n' { c } else { ' ' };
    let before = text.get(..declaration.inside.start).unwrap_or_default();
    before
        .chars()
        .map(blank)
        .chain(text.get(declaration.inside.clone()).unwrap_or_default().chars())
        .collect()
}

/// Returns all declarations in order; none if the text is not a sequence of tokens.
fn declarations(text: &str) -> Vec<Declaration> {
    let mut found = Vec::new();
    let mut open: Vec<TokenStream> = text.parse().into_iter().collect();
    while let Some(tokens) = open.pop() {
        let tokens = tokens.into_iter().collect::<Vec<_>>();
        found.extend(tokens.windows(3).filter_map(declaration));
        open.extend(tokens.into_iter().filter_map(|token| match token {
            TokenTree::Group(group) => Some(group.stream()),
            _ => None,
        }));
    }
    found.sort_by_key(|declaration| declaration.inside.start);
    found
}

/// Parses `system`, `!` and braces.
fn declaration(tokens: &[TokenTree]) -> Option<Declaration> {
    let [TokenTree::Ident(macro_name), TokenTree::Punct(mark), TokenTree::Group(group)] = tokens else {
        return None;
    };
    let is_one = macro_name == "system" && mark.as_char() == '!' && group.delimiter() == Delimiter::Brace;
    let inside = group.span_open().byte_range().end..group.span_close().byte_range().start;
    is_one.then(|| Declaration { name: name(group.stream()), inside })
}

/// Returns the word after `struct`, or the path of the file that is the declaration.
fn name(tokens: TokenStream) -> String {
    let mut behind = tokens.clone().into_iter().skip_while(|token| token.to_string() != "struct").skip(1);
    let name = behind.next().or_else(|| tokens.into_iter().nth(1));
    name.map(|token| token.to_string().trim_matches('"').to_owned()).unwrap_or_default()
}
