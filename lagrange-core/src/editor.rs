//! The names of a declaration as an editor sees them.
//!
//! Emitted items use few words of a declaration: names in expressions become numbers, factors and
//! indices. An editor such as rust-analyzer could therefore neither jump from them nor complete
//! them. For editors the macro also emits a function that binds each name where the declaration
//! does, and mentions it wherever an expression does.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use lagrange_expr::diagnostics::Report;
use lagrange_language::syntax::ast::{ArrayExpression, Declaration, Expression, StatementKind};
use lagrange_language::syntax::{can_be_declared, parse_tokens};

/// Names that need no declaration.
const PREDEFINED: [&str; 2] = ["pi", "t"];

/// Returns an item that binds and mentions the names of a declaration at their places. It has no
/// meaning, and is of no use to a compiler.
pub fn names(tokens: &TokenStream) -> TokenStream {
    let Some(declaration) = parse_tokens(tokens.clone(), &mut Report::default()) else {
        return TokenStream::new();
    };
    let declared = declaration.statements.iter().flat_map(|statement| statement.kind.declared_names());
    let declared = declared.map(|name| (name.text.as_str(), name.span)).collect::<BTreeMap<_, _>>();
    let mentioned = mentions(&declaration);
    let others = mentioned.iter().map(|(name, _)| *name).filter(|name| !declared.contains_key(name));
    let others = others.collect::<BTreeSet<_>>();
    let predefined = PREDEFINED.map(|name| Ident::new(name, Span::call_site()));
    let bound = declared.iter().filter_map(|(name, place)| word(name, *place));
    let used = mentioned.iter().filter_map(|(name, place)| word(name, *place));
    // Variables of loops, members, and the word at the cursor. An editor compares the function with
    // this word and without it, so their functions come after all uses, which keep their places.
    let others = others.iter().filter_map(|name| word(name, Span::call_site()));
    quote! {
        const _: () = {
            #[allow(non_snake_case)]
            fn names() {
                #(let #predefined = 0.0_f64;)*
                #(let #bound = 0.0_f64;)*
                #(let _ = #used;)*
                #(fn #others() {})*
            }
        };
    }
}

/// Returns names in expressions with their places, in the order of the declaration.
fn mentions(declaration: &Declaration) -> Vec<(&str, Span)> {
    let expressions = &declaration.expressions;
    let in_expressions = expressions.iter().filter_map(|(id, expression)| match expression {
        Expression::Name(name) => Some((name.as_str(), expressions.origin(id).start)),
        Expression::Call(name, _) | Expression::Array(ArrayExpression::Element(name)) => {
            Some((name.text.as_str(), name.span))
        }
        _ => None,
    });
    let on_names = declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::ForceOn(name, _) | StatementKind::StateRate(name, _) => {
            Some((name.text.as_str(), name.span))
        }
        _ => None,
    });
    in_expressions.chain(on_names).collect()
}

/// Returns a word of Rust at a place, if the name is one.
fn word(name: &str, place: Span) -> Option<Ident> {
    can_be_declared(name).then(|| Ident::new(name, place))
}

#[cfg(test)]
mod tests {
    use super::names;
    use proc_macro2::{TokenStream, TokenTree};

    const TEXT: &str = "struct Arm; param m: kg = 1, l: m = 2; coord q[2], x;
let (a, b) = (l * sin(q[0]), m); kinetic = m * dot(a)^2; force x = b + unknown;";

    /// Returns the words of the function with their places, after `let`.
    fn words(text: &str) -> Vec<String> {
        fn collect(tokens: TokenStream, found: &mut Vec<String>) {
            for token in tokens {
                match token {
                    TokenTree::Group(group) => collect(group.stream(), found),
                    TokenTree::Ident(word)
                        if !["const", "allow", "non_snake_case", "fn", "let", "_", "names"]
                            .iter()
                            .any(|other| word == other) =>
                    {
                        let place = word.span().start();
                        found.push(format!("{word} {}:{}", place.line, place.column + 1));
                    }
                    _ => {}
                }
            }
        }
        let mut found = Vec::new();
        collect(names(&text.parse().expect("tokens")), &mut found);
        found
    }

    #[test]
    fn names_are_bound_and_mentioned_where_the_declaration_does() {
        let found = words(TEXT);
        assert_eq!(found[2..8], ["a 2:6", "b 2:9", "l 1:30", "m 1:19", "q 1:46", "x 1:52"]);
        // Units are not among them.
        let mentioned = "l 2:15, q 2:23, m 2:30, m 2:44, a 2:52, b 2:68, unknown 2:72, x 2:64, unknown 1:1";
        assert_eq!(found[8..].join(", "), mentioned);
    }

    #[test]
    fn nothing_is_emitted_without_a_declaration() {
        assert!(words("not a declaration").is_empty());
    }
}
