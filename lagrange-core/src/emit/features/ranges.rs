//! Check that parameters are in their declared ranges.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::base::fields::places;
use crate::emit::base::members::Members;
use crate::emit::base::shape::{Shape, doc};
use crate::emit::base::writer::MethodWriter;
use crate::model::Bound;

/// Writes the body of `check_parameters`, if any parameter has a range.
pub(in crate::emit) fn write_ranges(writer: &mut MethodWriter<'_>) {
    let parameters = writer.model.parameters.clone();
    let limits = parameters.iter().flat_map(|parameter| &parameter.range).flatten();
    let values = limits.map(|limit| limit.value).collect::<Vec<_>>();
    if values.is_empty() {
        return;
    }
    let Some(body) = writer.constants(&values) else { return };
    let (shape, krate) = (writer.shape, writer.shape.krate);
    let mut values = body.outputs.iter();
    let mut bound = |bound: &Option<Bound>| match bound {
        None => quote!(::core::ops::Bound::Unbounded),
        Some(bound) => {
            let value = values.by_ref().take(1);
            match bound.is_included {
                true => quote!(::core::ops::Bound::Included(#(#value)*)),
                false => quote!(::core::ops::Bound::Excluded(#(#value)*)),
            }
        }
    };
    let places = places(&shape.number_fields());
    let checks = parameters.iter().zip(&shape.fields).zip(places).filter_map(|((parameter, name), place)| {
        let [lower, upper] = &parameter.range;
        lower.as_ref().or(upper.as_ref())?;
        let range = [bound(lower), bound(upper)];
        let written = shape.written(name);
        let unit = shape.units.get(&name.text).map_or("", |unit| unit.unit.as_str());
        let unit = if unit == "1" { "" } else { unit };
        Some(quote!(#krate::system::OutOfRange::check(#written, self.#place, (#(#range),*), #unit)?;))
    });
    let (checks, statements) = (checks.collect::<TokenStream>(), &body.statements);
    writer.members.ranges = Some(quote!(#statements #checks ::core::result::Result::Ok(())));
}

/// Writes the method `check_parameters`.
pub(in crate::emit) fn check_method(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, scalar, body) = (shape.krate, shape.scalar(), members.ranges.as_ref()?);
    let docs = [
        "Checks that parameters are in their declared ranges. Runs do so before the first step.",
        "",
        "# Errors",
        "",
        "The first parameter that is outside of its range, or NaN.",
    ];
    let docs = docs.map(doc);
    Some(quote! {
        #(#docs)*
        pub fn check_parameters(&self) -> ::core::result::Result<(), #krate::system::OutOfRange<#scalar>> {
            #body
        }
    })
}
