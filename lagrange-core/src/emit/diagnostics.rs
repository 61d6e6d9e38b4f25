//! Mistakes as tokens that make the compiler report them.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use crate::diagnostics::{Diagnostic, Origin, Severity};

/// `compile_error!` for errors; for warnings, which a stable macro cannot issue, the use of a constant that
/// is deprecated with the warning as its note. Related places are reported where they are.
pub fn diagnostics(diagnostics: &[Diagnostic]) -> TokenStream {
    diagnostics.iter().map(diagnostic).collect()
}

fn diagnostic(diagnostic: &Diagnostic) -> TokenStream {
    let mut message = diagnostic.message.clone();
    if let Some(help) = &diagnostic.help {
        message += &format!("\n  = help: {help}");
    }
    match diagnostic.severity {
        Severity::Warning => warning(diagnostic.origin, &message),
        Severity::Error => {
            let related =
                diagnostic.related.iter().map(|(origin, note)| error(*origin, &format!("note: {note}")));
            std::iter::once(error(diagnostic.origin, &message)).chain(related).collect()
        }
    }
}

/// The error covers everything from the first to the last token of its origin: the compiler takes the span
/// of the invocation from its first and last tokens.
fn error(origin: Origin, message: &str) -> TokenStream {
    let start = quote_spanned!(origin.start=> ::core::compile_error!);
    let mut arguments = proc_macro2::Group::new(proc_macro2::Delimiter::Brace, quote!(#message));
    arguments.set_span(origin.end);
    start.into_iter().chain([TokenTree::Group(arguments)]).collect()
}

fn warning(origin: Origin, message: &str) -> TokenStream {
    let constant = Ident::new("LAGRANGE_WARNING", Span::mixed_site());
    let mut used = constant.clone();
    used.set_span(constant.span().located_at(origin.start));
    quote! {
        const _: () = {
            #[deprecated(note = #message)]
            const #constant: () = ();
            #used
        };
    }
}
