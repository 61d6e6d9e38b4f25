//! Paths and calls of methods in the arguments of macros, which are tokens without syntax.

use proc_macro2::{Ident, Spacing, TokenStream, TokenTree};

/// A path in tokens; a call of a method is a path of one name behind a dot.
#[derive(Default)]
pub(crate) struct TokenPath {
    pub(crate) names: Vec<String>,
    pub(crate) line: usize,
    /// Behind a dot, the variable before it, or an empty text if that is not a name.
    pub(crate) receiver: Option<String>,
}

/// Returns the paths in the tokens, including those in brackets. Paths from outside, which begin
/// with `::`, are left out.
pub(crate) fn paths(tokens: &TokenStream) -> Vec<TokenPath> {
    let mut found = Vec::new();
    let tokens = tokens.clone().into_iter().collect::<Vec<_>>();
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            TokenTree::Group(group) => found.extend(paths(&group.stream())),
            TokenTree::Ident(first) => {
                let (path, end) = path(first, &tokens, at);
                found.extend((!is_colons(&tokens, at.wrapping_sub(2))).then_some(path));
                at = end;
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    found
}

/// Returns the path that begins at a token, and the index of the token behind it.
fn path(first: &Ident, tokens: &[TokenTree], start: usize) -> (TokenPath, usize) {
    let mut names = vec![first.to_string()];
    let mut at = start + 1;
    while let (true, Some(TokenTree::Ident(next))) = (is_colons(tokens, at), tokens.get(at + 2)) {
        names.push(next.to_string());
        at += 3;
    }
    let follows_dot = start.checked_sub(1).is_some_and(|before| is_punct(tokens, before, '.'));
    let receiver = follows_dot.then(|| variable(tokens, start.wrapping_sub(2)));
    (TokenPath { names, line: first.span().start().line, receiver }, at)
}

/// Returns the name at a token that is not part of a longer expression.
fn variable(tokens: &[TokenTree], at: usize) -> String {
    match tokens.get(at) {
        Some(TokenTree::Ident(name)) if !is_punct(tokens, at.wrapping_sub(1), '.') => name.to_string(),
        _ => String::new(),
    }
}

/// True if `::` begins at a token.
fn is_colons(tokens: &[TokenTree], at: usize) -> bool {
    let is_joint =
        matches!(tokens.get(at), Some(TokenTree::Punct(colon)) if colon.spacing() == Spacing::Joint);
    is_joint && is_punct(tokens, at, ':') && is_punct(tokens, at.wrapping_add(1), ':')
}

fn is_punct(tokens: &[TokenTree], at: usize, punct: char) -> bool {
    matches!(tokens.get(at), Some(TokenTree::Punct(found)) if found.as_char() == punct)
}

#[cfg(test)]
mod tests {
    use crate::tokens::paths;

    #[test]
    fn paths_and_calls_are_distinguished() {
        let tokens = "a::b::<C>(self.d.e(), x.f), [::core::f, $crate::g]".parse().expect("tokens");
        let found = paths(&tokens).into_iter().map(|path| {
            let receiver = path.receiver.map_or_else(String::new, |receiver| format!("{receiver}."));
            format!("{receiver}{}", path.names.join("::"))
        });
        let found = found.collect::<Vec<_>>();
        assert_eq!(found, ["a::b", "C", "self", "self.d", ".e", "x", "x.f", "crate::g"]);
    }
}
