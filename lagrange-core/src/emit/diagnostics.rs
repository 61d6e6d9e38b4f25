//! Mistakes and warnings as tokens that make the compiler report them.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use super::size::report_hopeless;
use super::system::Refusal;
use crate::diagnostics::{Diagnostic, Origin, Report, Severity};
use crate::syntax::ast::{Declaration, Expression, ScalarType};

/// `compile_error!` for errors, variables that are not used for names that are not, and something deprecated
/// for what takes long to compile or is doubtful: a stable macro cannot report anything else. Related places are reported
/// where they are.
///
/// `attributes` are those of the struct: what they allow is not warned of.
pub fn diagnostics(diagnostics: &[Diagnostic], attributes: &TokenStream) -> TokenStream {
    let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error).map(error);
    let unused = diagnostics.iter().filter_map(|diagnostic| match &diagnostic.severity {
        Severity::Unused(name) => Some(Ident::new(name, diagnostic.origin.start)),
        Severity::Error | Severity::Expensive | Severity::Doubtful => None,
    });
    let notices = diagnostics.iter().filter_map(|diagnostic| match diagnostic.severity {
        Severity::Expensive => Some(notice("LargeSystem", diagnostic, attributes)),
        Severity::Doubtful => Some(notice("DoubtfulValue", diagnostic, attributes)),
        Severity::Error | Severity::Unused(_) => None,
    });
    let notices = notices.collect::<TokenStream>();
    let (errors, unused) = (errors.collect::<TokenStream>(), unused.collect::<Vec<_>>());
    let warnings = (!unused.is_empty()).then(|| warnings(&unused, attributes));
    quote!(#errors #warnings #notices)
}

/// The compiler's own warning of something deprecated, the only one whose text can be chosen. It stands at the
/// user's token and obeys the user's lint levels.
fn notice(name: &str, diagnostic: &Diagnostic, attributes: &TokenStream) -> TokenStream {
    let (allowed, text) = (allowed(attributes), text(diagnostic));
    let used = Ident::new(name, diagnostic.origin.start);
    quote! {
        #allowed
        const _: () = {
            #[deprecated(note = #text)]
            struct #used;
            let _ = #used;
        };
    }
}

/// The message with its help.
fn text(diagnostic: &Diagnostic) -> String {
    match &diagnostic.help {
        Some(help) => format!("{}\nhelp: {help}", diagnostic.message),
        None => diagnostic.message.clone(),
    }
}

/// The compiler's own warning of unused variables, with the remedy that editors know how to apply. It
/// stands at the user's name and obeys the user's lint levels.
fn warnings(unused: &[Ident], attributes: &TokenStream) -> TokenStream {
    let allowed = allowed(attributes);
    // A local function hides what else of that name is in scope: a variable cannot hide a constant.
    let hiding =
        unused.iter().map(|name| Ident::new(&name.to_string(), Span::mixed_site().located_at(name.span())));
    quote! {
        #allowed
        #[allow(dead_code, non_snake_case, reason = "generated to warn of unused names")]
        const _: fn() = || {
            #(fn #hiding() {})*
            #(let #unused = || ();)*
        };
    }
}

/// The attributes that begin with `allow`.
fn allowed(attributes: &TokenStream) -> TokenStream {
    let tokens = attributes.clone().into_iter().collect::<Vec<_>>();
    let allows = |token: &TokenTree| match token {
        TokenTree::Group(group) => {
            matches!(group.stream().into_iter().next(), Some(TokenTree::Ident(word)) if word == "allow")
        }
        _ => false,
    };
    tokens.windows(2).filter(|pair| allows(&pair[1])).flatten().cloned().collect()
}

fn error(diagnostic: &Diagnostic) -> TokenStream {
    let related = diagnostic.related.iter();
    let notes = related.map(|(origin, note)| compile_error(*origin, &format!("note: {note}")));
    std::iter::once(compile_error(diagnostic.origin, &text(diagnostic))).chain(notes).collect()
}

/// The error covers everything from the first to the last token of its origin: the compiler takes the span
/// of the invocation from its first and last tokens.
fn compile_error(origin: Origin, message: &str) -> TokenStream {
    let start = quote_spanned!(origin.start=> ::core::compile_error!);
    let mut arguments = Group::new(Delimiter::Brace, quote!(#message));
    arguments.set_span(origin.end);
    start.into_iter().chain([TokenTree::Group(arguments)]).collect()
}

/// Reports why a system cannot be written.
pub fn report_refusal(declaration: &Declaration, refusal: &Refusal, report: &mut Report) {
    match refusal {
        Refusal::Constants(constants) => report_too_large(declaration, constants, report),
        Refusal::Size => report_hopeless(declaration, report),
    }
}

/// Reports constants that the scalar cannot represent: at the literals that are too large themselves, or, where
/// only what follows from them is, at the name of the system.
fn report_too_large(declaration: &Declaration, constants: &[String], report: &mut Report) {
    let (scalar, largest) = match &declaration.scalar {
        ScalarType::F32 => ("f32", f64::from(f32::MAX)),
        ScalarType::F64 | ScalarType::Generic(_) => ("f64", f64::MAX),
    };
    let help = format!("`{scalar}` holds numbers up to about {largest:.1e}: choose larger units");
    let expressions = &declaration.expressions;
    let literals = expressions.iter().filter_map(|(id, expression)| match expression {
        Expression::Number(value) if value.to_f64() > largest => Some(expressions.origin(id)),
        _ => None,
    });
    let literals = literals.collect::<Vec<_>>();
    for &origin in &literals {
        report.error(origin, format!("this number is too large for `{scalar}`")).help(help.as_str());
    }
    if literals.is_empty() {
        let message =
            format!("the equations hold numbers too large for `{scalar}`: {}", constants.join(", "));
        report.error(declaration.name.span, message).help(help);
    }
}
