//! Attributes of the head, and their effect on everything else that is emitted.
//!
//! The struct keeps them. Conditions hold for every item. Lint levels hold for the warnings about
//! the declaration, too. An `#[expect]` of these warnings applies to them alone, since the struct
//! itself never causes them.

use proc_macro2::{Group, TokenStream, TokenTree};
use quote::quote;

use lagrange_expr::diagnostics::{Diagnostic, Severity};
use lagrange_language::syntax::ast::{Declaration, Name};

/// The lint of what is expensive or doubtful.
pub(in crate::emit) const NOTICE: &[&str] = &["deprecated"];
/// The lint of names that are never used, and the group that it belongs to.
pub(in crate::emit) const UNUSED: &[&str] = &["unused_variables", "unused"];

/// An attribute: a number sign and a group in brackets.
struct Attribute<'a> {
    tokens: &'a [TokenTree],
    group: &'a Group,
}

impl Attribute<'_> {
    /// True if it is `#[name]`, `#[name(…)]` or `#[name = …]`.
    fn is(&self, name: &str) -> bool {
        matches!(self.group.stream().into_iter().next(), Some(TokenTree::Ident(word)) if word == name)
    }

    fn tokens(&self) -> TokenStream {
        self.tokens.iter().cloned().collect()
    }

    /// The list in its parentheses: lints, and perhaps a reason.
    fn arguments(&self) -> Vec<TokenStream> {
        let Some(TokenTree::Group(list)) = self.group.stream().into_iter().nth(1) else { return Vec::new() };
        let tokens = list.stream().into_iter().collect::<Vec<_>>();
        let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
        let arguments = tokens.split(is_comma).filter(|argument| !argument.is_empty());
        arguments.map(|argument| argument.iter().cloned().collect()).collect()
    }

    /// Attribute without those of its arguments that end in one of these words.
    fn without(&self, words: &[&Name]) -> Option<TokenStream> {
        let ends_in = |argument: &TokenStream| match argument.clone().into_iter().last() {
            Some(TokenTree::Ident(word)) => words.iter().any(|other| word == other.text.as_str()),
            _ => false,
        };
        let arguments = self.arguments();
        if !arguments.iter().any(ends_in) {
            return Some(self.tokens());
        }
        let kept = arguments.iter().filter(|argument| !ends_in(argument));
        Some(quote!(#[derive(#(#kept),*)]))
    }

    /// Attribute with those of its lints that are `chosen`, and the reason; `None` without such a
    /// lint.
    fn with(&self, level: &str, chosen: impl Fn(&str) -> bool) -> Option<TokenStream> {
        let is_reason = |argument: &TokenStream| argument.to_string().starts_with("reason =");
        let (reasons, lints): (Vec<_>, Vec<_>) = self.arguments().into_iter().partition(is_reason);
        let lints = lints.into_iter().filter(|lint| chosen(&lint.to_string())).collect::<Vec<_>>();
        let level = quote::format_ident!("{level}");
        (!lints.is_empty()).then(|| quote!(#[#level(#(#lints,)* #(#reasons),*)]))
    }
}

/// Attributes as `write` changes each.
fn mapped(attributes: &TokenStream, write: impl Fn(&Attribute<'_>) -> Option<TokenStream>) -> TokenStream {
    let tokens = attributes.clone().into_iter().collect::<Vec<_>>();
    let attributes = tokens.chunks(2).filter_map(|tokens| match tokens {
        [_, TokenTree::Group(group)] => Some(Attribute { tokens, group }),
        _ => None,
    });
    attributes.filter_map(|attribute| write(&attribute)).collect()
}

/// The conditions of the struct, `#[cfg(…)]`.
pub(in crate::emit) fn conditions(attributes: &TokenStream) -> TokenStream {
    mapped(attributes, |attribute| attribute.is("cfg").then(|| attribute.tokens()))
}

/// Attributes for warnings of one of these lints: the conditions of the struct and its lint levels.
pub(in crate::emit) fn of_warnings(attributes: &TokenStream, lints: &[&str]) -> TokenStream {
    mapped(attributes, |attribute| {
        match ["cfg", "allow", "warn", "deny"].iter().any(|name| attribute.is(name)) {
            true => Some(attribute.tokens()),
            false if attribute.is("expect") => attribute.with("expect", |lint| lints.contains(&lint)),
            false => None,
        }
    })
}

/// Expectations of one of these lints, with the conditions of the struct; nothing if there are
/// none.
pub(in crate::emit) fn expectations(attributes: &TokenStream, lints: &[&str]) -> TokenStream {
    let expected = mapped(attributes, |attribute| match attribute.is("expect") {
        true => attribute.with("expect", |lint| lints.contains(&lint)),
        false => None,
    });
    let conditions = conditions(attributes);
    if expected.is_empty() { expected } else { quote!(#conditions #expected) }
}

/// Returns the attributes that the struct keeps. Lints about the declaration that are expected are
/// only allowed there, and traits that were reported as not derivable are omitted.
pub fn attributes_of_struct(declaration: &Declaration, diagnostics: &[Diagnostic]) -> TokenStream {
    let underivable = declaration.underivable();
    let warns_of_unused = diagnostics.iter().any(|one| matches!(one.severity, Severity::Unused(_)));
    // The struct itself may be unused, but it is no variable and nothing deprecated.
    let is_of_warnings =
        |lint: &str| NOTICE.contains(&lint) || lint == UNUSED[0] || warns_of_unused && UNUSED.contains(&lint);
    mapped(&declaration.attributes, |attribute| match attribute.is("expect") {
        false if attribute.is("derive") => attribute.without(&underivable),
        false => Some(attribute.tokens()),
        true => {
            let kept = attribute.with("expect", |lint| !is_of_warnings(lint));
            let allowed = attribute.with("allow", is_of_warnings);
            Some(quote!(#kept #allowed))
        }
    })
}

/// Lets emitted items use a struct that is deprecated.
pub(in crate::emit) fn deprecated_exception(attributes: &TokenStream) -> Option<TokenStream> {
    let exception =
        quote!(#[allow(deprecated, reason = "what is deprecated is the type, not what makes it one")]);
    let found = mapped(attributes, |attribute| attribute.is("deprecated").then(|| attribute.tokens()));
    (!found.is_empty()).then_some(exception)
}

/// The lines of documentation and the other attributes.
pub(in crate::emit) fn split_attributes(attributes: &TokenStream) -> (Vec<TokenStream>, Vec<TokenStream>) {
    let tokens = attributes.clone().into_iter().collect::<Vec<_>>();
    // An attribute is a number sign and a group in brackets.
    let (docs, others) = tokens.chunks(2).partition::<Vec<_>, _>(|attribute| is_documentation(attribute));
    let attributes = |list: Vec<&[TokenTree]>| {
        list.into_iter().map(|attribute| attribute.iter().cloned().collect()).collect()
    };
    (attributes(docs), attributes(others))
}

/// `#[doc = …]`, which is also what comments become, but not `#[doc(hidden)]`.
fn is_documentation(attribute: &[TokenTree]) -> bool {
    let Some(TokenTree::Group(group)) = attribute.get(1) else { return false };
    let mut tokens = group.stream().into_iter();
    let is_doc = matches!(tokens.next(), Some(TokenTree::Ident(word)) if word == "doc");
    is_doc && matches!(tokens.next(), Some(TokenTree::Punct(punct)) if punct.as_char() == '=')
}
