//! Attributes of the head, and their effect on everything else that is emitted.
//!
//! The struct keeps them. Conditions apply to every item. Lint levels also apply to the warnings
//! about the declaration. An `#[expect]` of these warnings applies only to them, since the struct
//! itself never causes them.

use proc_macro2::{Group, TokenStream, TokenTree};
use quote::quote;

use lagrange_expr::diagnostics::{Diagnostic, Severity};
use lagrange_language::syntax::ast::{Declaration, Name};

/// The lint for expensive or doubtful declarations.
pub(in crate::emit) const NOTICE: &[&str] = &["deprecated"];
/// The lint for unused names, and its group.
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

    /// Returns the arguments in its parentheses: lints, and an optional reason.
    fn arguments(&self) -> Vec<TokenStream> {
        let Some(TokenTree::Group(list)) = self.group.stream().into_iter().nth(1) else { return Vec::new() };
        let tokens = list.stream().into_iter().collect::<Vec<_>>();
        let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
        let arguments = tokens.split(is_comma).filter(|argument| !argument.is_empty());
        arguments.map(|argument| argument.iter().cloned().collect()).collect()
    }

    /// Returns the attribute without arguments that end in one of these words.
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

    /// Returns the attribute with its `chosen` lints and the reason; `None` without such a lint.
    fn with(&self, level: &str, chosen: impl Fn(&str) -> bool) -> Option<TokenStream> {
        let is_reason = |argument: &TokenStream| argument.to_string().starts_with("reason =");
        let (reasons, lints): (Vec<_>, Vec<_>) = self.arguments().into_iter().partition(is_reason);
        let lints = lints.into_iter().filter(|lint| chosen(&lint.to_string())).collect::<Vec<_>>();
        let level = quote::format_ident!("{level}");
        (!lints.is_empty()).then(|| quote!(#[#level(#(#lints,)* #(#reasons),*)]))
    }
}

/// Applies `write` to each attribute.
fn mapped(attributes: &TokenStream, write: impl Fn(&Attribute<'_>) -> Option<TokenStream>) -> TokenStream {
    let tokens = attributes.clone().into_iter().collect::<Vec<_>>();
    let attributes = tokens.chunks(2).filter_map(|tokens| match tokens {
        [_, TokenTree::Group(group)] => Some(Attribute { tokens, group }),
        _ => None,
    });
    attributes.filter_map(|attribute| write(&attribute)).collect()
}

/// Returns the conditions of the struct, `#[cfg(…)]`.
pub(in crate::emit) fn conditions(attributes: &TokenStream) -> TokenStream {
    mapped(attributes, |attribute| attribute.is("cfg").then(|| attribute.tokens()))
}

/// Returns the attributes for warnings of one of these lints: the conditions of the struct and its
/// lint levels.
pub(in crate::emit) fn of_warnings(attributes: &TokenStream, lints: &[&str]) -> TokenStream {
    mapped(attributes, |attribute| {
        match ["cfg", "allow", "warn", "deny"].iter().any(|name| attribute.is(name)) {
            true => Some(attribute.tokens()),
            false if attribute.is("expect") => attribute.with("expect", |lint| lints.contains(&lint)),
            false => None,
        }
    })
}

/// Returns the expectations of one of these lints, with the conditions of the struct; empty if
/// there are no expectations.
pub(in crate::emit) fn expectations(attributes: &TokenStream, lints: &[&str]) -> TokenStream {
    let expected = mapped(attributes, |attribute| match attribute.is("expect") {
        true => attribute.with("expect", |lint| lints.contains(&lint)),
        false => None,
    });
    let conditions = conditions(attributes);
    if expected.is_empty() { expected } else { quote!(#conditions #expected) }
}

/// Returns the attributes that the struct keeps. Expected lints about the declaration become
/// allowed there. Traits that have been reported as not derivable are omitted.
pub fn attributes_of_struct(declaration: &Declaration, diagnostics: &[Diagnostic]) -> TokenStream {
    let underivable = declaration.underivable();
    let warns_of_unused = diagnostics.iter().any(|one| matches!(one.severity, Severity::Unused(_)));
    // The struct itself may be unused, but it is neither a variable nor deprecated.
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

/// Lets emitted items use a deprecated struct.
pub(in crate::emit) fn deprecated_exception(attributes: &TokenStream) -> Option<TokenStream> {
    let exception =
        quote!(#[allow(deprecated, reason = "what is deprecated is the type, not what makes it one")]);
    let found = mapped(attributes, |attribute| attribute.is("deprecated").then(|| attribute.tokens()));
    (!found.is_empty()).then_some(exception)
}

/// Splits attributes into the lines of documentation and the others.
pub(in crate::emit) fn split_attributes(attributes: &TokenStream) -> (Vec<TokenStream>, Vec<TokenStream>) {
    let tokens = attributes.clone().into_iter().collect::<Vec<_>>();
    // An attribute is a number sign and a group in brackets.
    let (docs, others) = tokens.chunks(2).partition::<Vec<_>, _>(|attribute| is_documentation(attribute));
    let attributes = |list: Vec<&[TokenTree]>| {
        list.into_iter().map(|attribute| attribute.iter().cloned().collect()).collect()
    };
    (attributes(docs), attributes(others))
}

/// True for `#[doc = …]`, the form of documentation comments, but not for `#[doc(hidden)]`.
fn is_documentation(attribute: &[TokenTree]) -> bool {
    let Some(TokenTree::Group(group)) = attribute.get(1) else { return false };
    let mut tokens = group.stream().into_iter();
    let is_doc = matches!(tokens.next(), Some(TokenTree::Ident(word)) if word == "doc");
    is_doc && matches!(tokens.next(), Some(TokenTree::Punct(punct)) if punct.as_char() == '=')
}
