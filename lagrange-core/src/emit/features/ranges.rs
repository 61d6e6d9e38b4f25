//! Check that parameters are in their declared ranges, and quantities of contacts in theirs. The
//! domain of the state.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::orientations::written_velocity;
use crate::emit::base::fields::places;
use crate::emit::base::members::Members;
use crate::emit::base::method::Arguments;
use crate::emit::base::shape::{Shape, doc, length};
use crate::emit::base::writer::MethodWriter;
use crate::model::{Bound, EntryLimits, Quantity};
use lagrange_algebra::code::float;

/// Writes the limits of the state, and the body of `check_parameters` if any parameter or quantity
/// of a contact has a range.
pub(in crate::emit) fn write_ranges(writer: &mut MethodWriter<'_>) {
    writer.members.limits = writer.model.entry_limits();
    let (parameters, quantities) = (parameter_checks(writer), quantity_checks(writer));
    if parameters.is_none() && quantities.is_none() {
        return;
    }
    let end = quantities.unwrap_or_else(|| quote!(::core::result::Result::Ok(())));
    writer.members.ranges = Some(quote!(#parameters #end));
}

/// Writes the checks of quantities of contacts with the final result, if there are any.
fn quantity_checks(writer: &mut MethodWriter<'_>) -> Option<TokenStream> {
    let quantities = writer.model.quantities.clone();
    if quantities.is_empty() {
        return None;
    }
    let (shape, krate) = (writer.shape, writer.shape.krate);
    let values = |quantity: &Quantity| {
        let bounds = quantity.range.iter().flatten().map(|bound| bound.value);
        [quantity.value].into_iter().chain(bounds).collect::<Vec<_>>()
    };
    let roots = quantities.iter().flat_map(values).collect::<Vec<_>>();
    let collect = |results: &[TokenStream]| {
        let mut results = results.iter();
        let checks = quantities.iter().map(|quantity| {
            let value = results.next();
            let [lower, upper] = quantity.range.map(|bound| written_bound(bound, &mut results));
            let words = quantity.in_words(shape.written(&quantity.contact));
            quote! {
                #krate::system::OutOfRange::check(
                    #krate::system::RangedKind::OfContact, #words, #value, (#lower, #upper), ""
                )?;
            }
        });
        let checks = checks.collect::<TokenStream>();
        quote!(#checks ::core::result::Result::Ok(()))
    };
    Some(writer.lowered_as_declared(&roots, Arguments::None, collect).0)
}

/// Writes a bound with the next of these values.
fn written_bound<'v>(
    bound: Option<Bound>,
    values: &mut impl Iterator<Item = &'v TokenStream>,
) -> TokenStream {
    let value = bound.and_then(|_| values.next());
    match bound {
        None => quote!(::core::ops::Bound::Unbounded),
        Some(bound) if bound.is_included => quote!(::core::ops::Bound::Included(#value)),
        Some(_) => quote!(::core::ops::Bound::Excluded(#value)),
    }
}

/// Writes the checks of parameters, if any has a range.
fn parameter_checks(writer: &mut MethodWriter<'_>) -> Option<TokenStream> {
    let parameters = writer.model.parameters.clone();
    let limits = parameters.iter().flat_map(|parameter| &parameter.range).flatten();
    let values = limits.map(|limit| limit.value).collect::<Vec<_>>();
    if values.is_empty() {
        return None;
    }
    let body = writer.constants(&values)?;
    let (shape, krate) = (writer.shape, writer.shape.krate);
    let mut values = body.outputs.iter();
    let places = places(&shape.number_fields());
    let checks = parameters.iter().zip(&shape.fields).zip(places).filter_map(|((parameter, name), place)| {
        let [lower, upper] = &parameter.range;
        lower.as_ref().or(upper.as_ref())?;
        let range = [lower, upper].map(|bound| written_bound(*bound, &mut values));
        let written = shape.written(name);
        let unit = shape.shown_unit(&name.text);
        Some(quote! {
            #krate::system::OutOfRange::check(
                #krate::system::RangedKind::Parameter, #written, self.#place, (#(#range),*), #unit
            )?;
        })
    });
    let (checks, statements) = (checks.collect::<TokenStream>(), &body.statements);
    Some(quote!(#statements #checks))
}

/// Writes the method `check_parameters`.
pub(in crate::emit) fn check_method(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, scalar, body) = (shape.krate, shape.scalar(), members.ranges.as_ref()?);
    let docs = [
        "Checks that parameters, and quantities of contacts, are in their ranges. Runs do so before the first step.",
        "",
        "# Errors",
        "",
        "The first one that is outside of its range, or NaN.",
    ];
    let docs = docs.map(doc);
    Some(quote! {
        #(#docs)*
        pub fn check_parameters(&self) -> ::core::result::Result<(), #krate::system::OutOfRange<#scalar>> {
            #body
        }
    })
}

/// Returns the member of `OdeSystem` with the declared ranges and nominal values of the state, if
/// there are any.
pub(in crate::emit) fn domain_member(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    if members.limits.iter().all(|limits| *limits == EntryLimits::default()) {
        return None;
    }
    let krate = shape.krate;
    let entries = entries(shape).into_iter().zip(&members.limits).enumerate();
    let ranges = entries.filter_map(|(entry, ((kind, name, unit), limits))| {
        let kind = format_ident!("{kind}");
        let [lower, upper] = limits.bounds.map(constant_bound);
        limits.is_bounded().then(|| {
            let entry = length(entry);
            quote! {
                #krate::system::EntryRange {
                    entry: #entry,
                    kind: #krate::system::RangedKind::#kind,
                    name: #name,
                    unit: #unit,
                    bounds: (#lower, #upper),
                }
            }
        })
    });
    let nominal = EntryLimits::nominal_values(&members.limits).into_iter().map(float);
    Some(quote! {
        #[inline]
        fn domain(&self) -> &'static #krate::system::Domain {
            const DOMAIN: #krate::system::Domain =
                #krate::system::Domain { ranges: &[#(#ranges),*], nominal: &[#(#nominal),*] };
            &DOMAIN
        }
    })
}

/// Returns the kind, the name and the unit of each entry of the state.
fn entries<'s>(shape: &'s Shape<'_>) -> Vec<(&'static str, String, &'s str)> {
    let positions = shape.coordinates.iter().enumerate().map(|(index, name)| {
        let kind = if shape.is_state(index) { "State" } else { "Coordinate" };
        (kind, shape.written(name).to_owned(), shape.shown_unit(&name.text))
    });
    let velocities = shape.velocities.iter().map(|velocity| {
        ("Velocity", written_velocity(shape, velocity), shape.shown_unit(&velocity.name.text))
    });
    positions.chain(velocities).collect()
}

fn constant_bound(bound: Option<(f64, bool)>) -> TokenStream {
    let value = bound.map(|(value, _)| float(value));
    match bound {
        None => quote!(::core::ops::Bound::Unbounded),
        Some((_, true)) => quote!(::core::ops::Bound::Included(#value)),
        Some((_, false)) => quote!(::core::ops::Bound::Excluded(#value)),
    }
}
