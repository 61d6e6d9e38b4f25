//! Members for the regressor, except its method: names and values of the parameters, and the trait.

use proc_macro2::TokenStream;
use quote::quote;

use crate::derive::Equations;
use crate::emit::base::members::{Members, Regressed};
use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::refusal::Refusal;
use crate::emit::base::shape::{Shape, length};
use crate::emit::base::writer::MethodWriter;
use crate::model::Product;
use lagrange_language::syntax::ast::Name;

/// Writes the names and values of the parameters, if the regressor is requested.
pub(in crate::emit) fn write_regressor(writer: &mut MethodWriter<'_>) -> Result<(), Refusal> {
    if !writer.model.products.contains(&Product::Regressor) {
        return Ok(());
    }
    let names = regressor_names(writer.shape, writer.equations);
    if names.is_empty() {
        return Err(Refusal::NothingLinear);
    }
    let values = writer.equations.regressor.columns.iter().map(|column| column.parameter);
    let values = values.collect::<Vec<_>>();
    let returns = Returns::Vector(values.len());
    let (body, _) = writer.lowered_as_declared(&values, Arguments::None, |results| returns.collect(results));
    writer.members.regressor = Some(Regressed { names, body });
    Ok(())
}

/// Returns the names of the parameters, as they are written.
pub(in crate::emit) fn regressor_names(shape: &Shape<'_>, equations: &Equations) -> Vec<String> {
    let named = equations.regressor.columns.iter().map(|column| {
        let owner = Name::new(column.owner.clone(), shape.declaration.name.span);
        match column.part {
            Some(part) => format!("{}.{part}", shape.written(&owner)),
            None => shape.written(&owner).to_owned(),
        }
    });
    named.collect()
}

/// Writes the constant and the method for the parameters.
pub(in crate::emit) fn regressor_members(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let Regressed { names, body } = members.regressor.as_ref()?;
    let (count, scalar) = (length(names.len()), shape.scalar());
    Some(quote! {
        /// Names of the parameters that the columns of `regressor` multiply.
        pub const REGRESSOR_PARAMETERS: [&'static ::core::primitive::str; #count] = [#(#names),*];
        /// Values of the parameters that the columns of `regressor` multiply.
        #[must_use]
        pub fn regressor_parameters(&self) -> [#scalar; #count] {
            #body
        }
    })
}

/// Writes `RegressorSystem`, if its methods exist.
pub(in crate::emit) fn regressor_impl(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let Regressed { names, .. } = members.regressor.as_ref()?;
    let mut methods = members.methods.iter();
    methods.find(|method| method.name == Product::InverseDynamics.name())?;
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, nv, count) = (shape.krate, shape.velocities_length(), length(names.len()));
    let [parameters, passed] = Arguments::Motion.written(shape, &members.names);
    Some(quote! {
        #[automatically_derived]
        impl #bounds #krate::system::RegressorSystem for #name #generics {
            type Row = [#scalar; #count];
            type Regressor = [[#scalar; #count]; #nv];
            const REGRESSOR_PARAMETERS: &'static [&'static ::core::primitive::str] = &Self::REGRESSOR_PARAMETERS;
            #[inline]
            fn regressor(&self, #parameters) -> [[#scalar; #count]; #nv] {
                self.regressor(#passed)
            }
            #[inline]
            fn regressor_parameters(&self) -> [#scalar; #count] {
                self.regressor_parameters()
            }
            #[inline]
            fn inverse_dynamics(&self, #parameters) -> [#scalar; #nv] {
                self.inverse_dynamics(#passed)
            }
        }
    })
}
