//! Mistakes as tokens that make the compiler report them.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use crate::diagnostics::{Diagnostic, Origin, Report, Severity};
use crate::syntax::ast::{Declaration, Expression, ScalarType};

/// `compile_error!` for errors, and variables that are not used for names that are not: a stable macro
/// cannot report anything else. Related places are reported where they are.
///
/// `attributes` are those of the struct: what they allow is not warned of.
pub fn diagnostics(diagnostics: &[Diagnostic], attributes: &TokenStream) -> TokenStream {
    let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error).map(error);
    let unused = diagnostics.iter().filter_map(|diagnostic| match &diagnostic.severity {
        Severity::Unused(name) => Some(Ident::new(name, diagnostic.origin.start)),
        Severity::Error => None,
    });
    let (errors, unused) = (errors.collect::<TokenStream>(), unused.collect::<Vec<_>>());
    let warnings = (!unused.is_empty()).then(|| warnings(&unused, attributes));
    quote!(#errors #warnings)
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
    let mut message = diagnostic.message.clone();
    if let Some(help) = &diagnostic.help {
        message += &format!("\nhelp: {help}");
    }
    let related = diagnostic.related.iter();
    let notes = related.map(|(origin, note)| compile_error(*origin, &format!("note: {note}")));
    std::iter::once(compile_error(diagnostic.origin, &message)).chain(notes).collect()
}

/// The error covers everything from the first to the last token of its origin: the compiler takes the span
/// of the invocation from its first and last tokens.
fn compile_error(origin: Origin, message: &str) -> TokenStream {
    let start = quote_spanned!(origin.start=> ::core::compile_error!);
    let mut arguments = Group::new(Delimiter::Brace, quote!(#message));
    arguments.set_span(origin.end);
    start.into_iter().chain([TokenTree::Group(arguments)]).collect()
}

/// Reports constants that the scalar cannot represent: at the literals that are too large themselves, or, where
/// only what follows from them is, at the name of the system.
pub fn report_too_large(declaration: &Declaration, constants: &[String], report: &mut Report) {
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
