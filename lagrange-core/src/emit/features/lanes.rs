//! The type for numbers in lanes: right-hand side, and the parameters of several motions.
//!
//! If equations have switches, each motion follows the sides of its state, like a system with free
//! switches. Runs fix sides and stop at each surface, which parallel motions reach at different
//! times. The system therefore does not offer this type to ensembles.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::product::plan;
use super::taylor::series_in_lanes;
use crate::emit::base::docs;
use crate::emit::base::exclusion::Exclusion;
use crate::emit::base::fields::{entries, places};
use crate::emit::base::lints::{name_exception, type_name_exception, unused_exception};
use crate::emit::base::members::{Lanes, Members};
use crate::emit::base::method::Returns;
use crate::emit::base::refusal::Refusal;
use crate::emit::base::shape::{Shape, doc, length, local};
use crate::emit::base::writer::MethodWriter;
use crate::model::Product;
use lagrange_expr::expr::ExprId;

/// Names of the arguments of `Equations::differentiated`, and of the derivatives with respect to
/// all numbers.
const NAMES: [&str; 4] = ["jacobian", "indices", "columns", "by_numbers"];

/// Features not supported by loops over parallel motions.
const EXCLUSIONS: [Exclusion; 7] = [
    Exclusion::Contacts,
    Exclusion::Constraints,
    Exclusion::Events,
    Exclusion::Orientations,
    Exclusion::Indefinite,
    Exclusion::Noise,
    Exclusion::Delays,
];

/// Writes the right-hand side for numbers in lanes, if requested.
pub(in crate::emit) fn write_lanes(writer: &mut MethodWriter<'_>) -> Result<(), Refusal> {
    if !writer.model.products.contains(&Product::Lanes) || writer.is_hopeless() {
        return Ok(());
    }
    if let Some(exclusion) = Exclusion::first(&EXCLUSIONS, writer.model, writer.equations) {
        return Err(Refusal::Exclusion(Product::Lanes, exclusion));
    }
    let rates = [writer.model.position_rates(), writer.equations.accelerations.clone()].concat();
    let roots = writer.on_sides(&rates);
    let (rhs, counts) =
        writer.lowered_in_lanes(&roots, |results| Returns::Vector(results.len()).collect(results));
    let derivatives = write_derivatives(writer, &rates);
    let sides = write_sides(writer);
    let docs = format!("An evaluation takes {}.", docs::counts_text(counts));
    writer.members.lanes = Some(Lanes { rhs, derivatives, sides, docs });
    Ok(())
}

/// Writes the rates with their Jacobians, if these are requested: one program, as they share most
/// of their values.
fn write_derivatives(writer: &mut MethodWriter<'_>, rates: &[ExprId]) -> Option<TokenStream> {
    let requested = [Product::Jacobian, Product::ParameterJacobian];
    if !requested.iter().all(|product| writer.model.products.contains(product)) {
        return None;
    }
    let mut entries = |product| Some(plan(product, writer.model, writer.equations, writer.shape)?.roots);
    let by_state = entries(Product::Jacobian)?;
    // There is none without fields.
    let by_numbers = entries(Product::ParameterJacobian).unwrap_or_default();
    let roots = [rates, &by_state, &by_numbers].concat();
    let (krate, all, fields) = (writer.shape.krate, rates.len(), writer.shape.fields.len());
    let [jacobian, indices, columns, by_numbers] = NAMES.map(local);
    let roots = writer.on_sides(&roots);
    let (body, _) = writer.lowered_in_lanes(&roots, |results| {
        let (rates, results) = results.split_at(all);
        let (by_state, numbers) = results.split_at(all * all);
        let [rates, by_state, numbers] = [
            Returns::Vector(all).collect(rates),
            Returns::Matrix(all, all).collect(by_state),
            Returns::Matrix(all, fields).collect(numbers),
        ];
        let pick = (fields > 0).then(|| {
            quote! {
                let #by_numbers = #numbers;
                #krate::system::pick_columns(&#by_numbers, #indices, #columns);
            }
        });
        quote! {
            *#jacobian = #by_state;
            #pick
            #rates
        }
    });
    Some(body)
}

/// Writes the sides of the switches, the signs of their surface functions.
fn write_sides(writer: &mut MethodWriter<'_>) -> Option<TokenStream> {
    let switches = &writer.equations.switches[..writer.shape.switches.len()];
    if switches.is_empty() {
        return None;
    }
    let values = switches.iter().map(|switch| switch.value).collect::<Vec<_>>();
    let (sides, _) = writer.lowered_in_lanes(&writer.as_declared(&values), |results| {
        let sign = local("sign");
        quote!([#(#sign(#results)),*])
    });
    writer.members.functions.insert("sign");
    Some(sides)
}

/// Returns the type, if requested.
pub(in crate::emit) fn lanes_struct(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let lanes = members.lanes.as_ref()?;
    let (name, number, visibility) =
        (shape.lanes_name(), shape.lanes_number(), &shape.declaration.visibility);
    let title = doc(&format!(
        "Equations of [`{}`] for numbers side by side, with parameters of as many motions.",
        shape.declaration.name.text
    ));
    let (counts, names, unused) = (doc(&lanes.docs), name_exception(shape), unused_exception(shape));
    let type_name = type_name_exception(shape);
    let fields = shape.declared_fields(&shape.fields, &number.to_token_stream());
    let marker = shape.fields.is_empty().then(|| {
        quote! {
            /// The number type.
            pub scalar: ::core::marker::PhantomData<#number>,
        }
    });
    Some(quote! {
        #title
        ///
        #counts
        #names
        #unused
        #type_name
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        #visibility struct #name<#number> {
            #fields
            #marker
        }
    })
}

/// Returns the traits of the type, and the trait by which the system provides it.
pub(in crate::emit) fn lanes_items(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let lanes = members.lanes.as_ref()?;
    let (name, number, krate, all) =
        (shape.lanes_name(), shape.lanes_number(), shape.krate, shape.state_length());
    let (time, state, rhs) = (&members.names.time, &members.names.state, &lanes.rhs);
    let sides = lanes.sides.as_ref().map(|sides| {
        let k = length(shape.switches.len());
        quote! {
            impl<#number: #krate::Number> #name<#number> {
                #[inline(always)]
                fn sides(&self, #time: #number, #state: &[#number; #all]) -> [#number; #k] {
                    #sides
                }
            }
        }
    });
    let (system, series) = (system_impl(shape), series_in_lanes(shape, members));
    let derivatives = lanes.derivatives.as_ref().map(|body| {
        let [jacobian, mut indices, mut columns, _] = NAMES.map(local);
        if shape.fields.is_empty() {
            [indices, columns] = ["_"; 2].map(local);
        }
        quote! {
            const HAS_DERIVATIVES: ::core::primitive::bool = true;
            #[inline(always)]
            fn differentiated(
                &self,
                #time: #number,
                #state: &[#number; #all],
                #jacobian: &mut [[#number; #all]; #all],
                #indices: &[::core::primitive::usize],
                #columns: &mut [[#number; #all]],
            ) -> [#number; #all] {
                #body
            }
        }
    });
    Some(quote! {
        #sides
        #[automatically_derived]
        impl<#number: #krate::Number> #krate::system::Equations<#number> for #name<#number> {
            type State = [#number; #all];
            #series
            #[inline(always)]
            fn rhs(&self, #time: #number, #state: &[#number; #all]) -> [#number; #all] {
                #rhs
            }
            #derivatives
        }
        #system
    })
}

/// Implements `LanesSystem`.
fn system_impl(shape: &Shape<'_>) -> TokenStream {
    let (system, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (name, krate, number) = (shape.lanes_name(), shape.krate, shape.other_type_parameter("L"));
    let (fields, places) = (shape.number_fields(), places(&shape.number_fields()));
    let [splat, lanes, lane] = match fields.is_empty() {
        true => ["_"; 3].map(local),
        false => ["splat", "lanes", "lane"].map(local),
    };
    let marker = fields.is_empty().then(|| quote!(scalar: ::core::marker::PhantomData,));
    let splats = places.iter().map(|place| quote!(#splat(self.#place))).collect::<Vec<_>>();
    let splats = entries(&fields, &splats);
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::LanesSystem for #system #generics {
            type Lanes<#number: #krate::Number> = #name<#number>;
            fn lanes<#number: #krate::Number>(
                &self,
                #splat: impl ::core::ops::Fn(#scalar) -> #number,
            ) -> #name<#number> {
                #name { #(#splats,)* #marker }
            }
            fn set_lane<#number: #krate::system::SideBySide<Element = #scalar>>(
                &self,
                #lanes: &mut #name<#number>,
                #lane: ::core::primitive::usize,
            ) {
                #(#krate::system::SideBySide::set_lane(&mut #lanes.#places, #lane, self.#places);)*
            }
        }
    }
}

/// Returns `OdeSystem::with_lanes`, unless there are surfaces at which motions would stop at
/// different times.
pub(in crate::emit) fn with_lanes(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, visitor_type, visitor) = (shape.krate, shape.other_type_parameter("V"), local("visitor"));
    let is_offered = members.lanes.is_some() && shape.switches.is_empty();
    is_offered.then(|| {
        quote! {
            #[inline]
            fn with_lanes<#visitor_type: #krate::system::LanesVisitor<Self>>(
                #visitor: #visitor_type,
            ) -> ::core::result::Result<#visitor_type::Output, #visitor_type> {
                ::core::result::Result::Ok(#visitor.visit())
            }
        }
    })
}
