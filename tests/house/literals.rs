//! Texts in files of Rust, such as messages.

use proc_macro2::{TokenStream, TokenTree};
use syn::Lit;

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
    use crate::literals::literals;

    #[test]
    fn texts_are_literals_but_no_documentation() {
        let file = "/// Doc.\nfn f() {\n    g(\"a \\\n       b\", 'c', 1);\n}";
        assert_eq!(literals(file), [(3, "a b".to_owned())]);
    }
}
