//! Errors and warnings as tokens that make the compiler report them.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use super::base::attributes::{NOTICE, UNUSED, conditions, expectations, of_warnings};
use lagrange_expr::diagnostics::{Diagnostic, Origin, Severity};

/// Writes diagnostics as code, since a stable macro can only trigger the compiler's own
/// diagnostics. Errors are `compile_error!`, unused names are unused variables, and slow
/// compilation or doubtful declarations are uses of a deprecated item. Each diagnostic causes one
/// report; its text contains related places.
///
/// `attributes` are those of the struct; their conditions and lint levels also apply here.
pub fn diagnostics(diagnostics: &[Diagnostic], attributes: &TokenStream) -> TokenStream {
    let errors = diagnostics.iter().filter(|d| d.severity == Severity::Error);
    let errors = errors.map(|diagnostic| error(diagnostic, attributes)).collect::<TokenStream>();
    let unused = diagnostics.iter().filter_map(|diagnostic| match &diagnostic.severity {
        Severity::Unused(name) => Some(Ident::new(name, diagnostic.origin.start)),
        Severity::Error | Severity::Expensive | Severity::Doubtful => None,
    });
    let unused = unused.collect::<Vec<_>>();
    let notices = diagnostics.iter().filter_map(|diagnostic| match diagnostic.severity {
        Severity::Expensive => Some(notice("LargeSystem", diagnostic, attributes)),
        Severity::Doubtful => Some(notice("DoubtfulValue", diagnostic, attributes)),
        Severity::Error | Severity::Unused(_) => None,
    });
    let mut notices = notices.collect::<TokenStream>();
    // After errors, some warnings may not have been checked.
    let warnings = match () {
        () if !unused.is_empty() => warnings(&unused, attributes),
        () if errors.is_empty() => nothing(expectations(attributes, &UNUSED[..1])),
        () => TokenStream::new(),
    };
    if errors.is_empty() && notices.is_empty() {
        notices = nothing(expectations(attributes, NOTICE));
    }
    quote!(#errors #warnings #notices)
}

/// Writes an item for which the compiler reports unfulfilled expectations.
fn nothing(expectations: TokenStream) -> TokenStream {
    if expectations.is_empty() { expectations } else { quote!(#expectations const _: () = ();) }
}

/// Triggers the compiler's deprecation warning, the only one with a free text. It is located at the
/// user's token and obeys the user's lint levels.
fn notice(name: &str, diagnostic: &Diagnostic, attributes: &TokenStream) -> TokenStream {
    let (levels, text) = (of_warnings(attributes, NOTICE), diagnostic.text());
    let used = Ident::new(name, diagnostic.origin.start);
    quote! {
        #levels
        const _: () = {
            #[deprecated(note = #text)]
            struct #used;
            let _ = #used;
        };
    }
}

/// Triggers the compiler's warning about unused variables, with a fix that editors can apply. It is
/// located at the user's name and obeys the user's lint levels.
fn warnings(unused: &[Ident], attributes: &TokenStream) -> TokenStream {
    let levels = of_warnings(attributes, UNUSED);
    // A local function shadows any other item of this name; a variable could not shadow a constant.
    let hiding =
        unused.iter().map(|name| Ident::new(&name.to_string(), Span::mixed_site().located_at(name.span())));
    quote! {
        #levels
        #[allow(dead_code, non_snake_case, reason = "generated to warn of unused names")]
        const _: fn() = || {
            #(fn #hiding() {})*
            #(let #unused = || ();)*
        };
    }
}

fn error(diagnostic: &Diagnostic, attributes: &TokenStream) -> TokenStream {
    let conditions = conditions(attributes);
    let error = compile_error(diagnostic.origin, &diagnostic.text());
    quote!(#conditions #error)
}

/// Writes an error that covers its origin from the first to the last token. The compiler derives
/// the span of the invocation from its first and last tokens.
fn compile_error(origin: Origin, message: &str) -> TokenStream {
    let start = quote_spanned!(origin.start=> ::core::compile_error!);
    let mut arguments = Group::new(Delimiter::Brace, quote!(#message));
    arguments.set_span(origin.end);
    start.into_iter().chain([TokenTree::Group(arguments)]).collect()
}
