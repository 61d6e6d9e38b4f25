//! Laws as tests: the trait for checking them, and a module of tests next to the type.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::emit::base::attributes::conditions;
use crate::emit::base::exclusion::Exclusion;
use crate::emit::base::members::Members;
use crate::emit::base::method::Arguments;
use crate::emit::base::refusal::Refusal;
use crate::emit::base::shape::Shape;
use crate::emit::base::writer::MethodWriter;
use crate::model::Product;
use lagrange_language::syntax::ast::ScalarType;

/// Systems that are not tested.
const EXCLUSIONS: [Exclusion; 1] = [Exclusion::Defaults];

/// Marks a system as tested, unless it has no values for tests.
pub(in crate::emit) fn write_tests(writer: &mut MethodWriter<'_>) -> Result<(), Refusal> {
    if !writer.model.products.contains(&Product::Tests) {
        return Ok(());
    }
    match Exclusion::first(&EXCLUSIONS, writer.model, writer.equations) {
        Some(exclusion) => Err(Refusal::Exclusion(Product::Tests, exclusion)),
        None => {
            writer.members.is_tested = true;
            Ok(())
        }
    }
}

/// Writes `LagrangianSystem`, if its methods exist.
pub(in crate::emit) fn lagrangian_impl(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let has = |product: Product| members.methods.iter().any(|method| method.name == product.name());
    let is_there = [Product::Energy, Product::Lagrangian, Product::GeneralisedForces].into_iter().all(has);
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, nv) = (shape.krate, shape.velocities_length());
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    is_there.then(|| {
        quote! {
            #[automatically_derived]
            impl #bounds #krate::system::LagrangianSystem for #name #generics {
                fn lagrangian(&self, #parameters) -> #scalar {
                    self.lagrangian(#passed)
                }
                fn generalised_forces(&self, #parameters) -> [#scalar; #nv] {
                    self.generalised_forces(#passed)
                }
            }
        }
    })
}

/// Writes a module of tests, which is only compiled for tests of the user's crate.
pub(in crate::emit) fn laws_module(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, name, all) = (shape.krate, &shape.declaration.name, shape.state_length());
    let conditions = conditions(&shape.declaration.attributes);
    let module = format_ident!("{}_laws", snake_case(&name.text));
    let (generics, scalar) = match shape.declaration.scalar {
        ScalarType::Generic(_) => (Some(quote!(::<::core::primitive::f64>)), quote!(::core::primitive::f64)),
        ScalarType::F64 | ScalarType::F32 => (None, shape.scalar_path()),
    };
    let system = shape.name();
    let start = match members.start {
        Some(_) => quote!(system.start().into()),
        None => quote!([<#scalar as #krate::Number>::from_f64(0.0); #all]),
    };
    members.is_tested.then(|| {
        quote! {
            #conditions
            #[cfg(test)]
            mod #module {
                #[test]
                fn laws_hold() {
                    let system = <super::#system #generics as ::core::default::Default>::default();
                    let start: [#scalar; #all] = #start;
                    if let ::core::result::Result::Err(broken) = #krate::laws::verify(&system, &start) {
                        ::core::panic!("{broken}");
                    }
                }
            }
        }
    })
}

/// Returns the name of the module for a type: `four_bar` for `FourBar`.
fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    let mut was_lower = false;
    for letter in name.chars() {
        if was_lower && letter.is_uppercase() {
            snake.push('_');
        }
        was_lower = !letter.is_uppercase();
        snake.extend(letter.to_lowercase());
    }
    snake
}
