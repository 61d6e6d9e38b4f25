//! The declared initial state.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::base::fields::entries;
use crate::emit::base::members::Members;
use crate::emit::base::method::Arguments;
use crate::emit::base::shape::Shape;
use crate::emit::base::writer::MethodWriter;

/// Writes the body of `start`, a literal of the state.
pub(in crate::emit) fn write_start(writer: &mut MethodWriter<'_>) {
    let (values, shape) = (writer.model.start.clone(), writer.shape);
    if values.is_empty() {
        return;
    }
    let (body, _) = writer.lowered_as_declared(&values, Arguments::None, |results| {
        let (name, entries) = (shape.state_name(), entries(&shape.state_fields(), results));
        quote!(#name { #(#entries),* })
    });
    writer.members.start = Some(body);
}

/// Writes the method `start`.
pub(in crate::emit) fn start_method(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (name, generics) = (shape.state_name(), shape.generics());
    let body = members.start.as_ref()?;
    Some(quote! {
        /// The declared state at the start; entries without a declared value are zero.
        #[must_use]
        pub fn start(&self) -> #name #generics {
            #body
        }
    })
}
