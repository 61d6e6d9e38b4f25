//! The prepared type: a system, together with all values that its methods compute from parameters
//! alone.
//!
//! It wraps the system (`lagrange::system::Wrapper`), which provides events, normalisation and
//! energy. It has separate methods for the parts of the equations of motion. Its fields are private
//! and it returns the system by a shared reference. Code outside the module of the declaration
//! therefore cannot change parameters after they were prepared.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::ports::{has_outputs, inputs_name};
use super::product::{Plan, plan};
use super::switches::kept_switches;
use crate::emit::base::docs;
use crate::emit::base::exclusion::Exclusion;
use crate::emit::base::lints::type_name_exception;
use crate::emit::base::members::{Members, Prepared, PreparedFields};
use crate::emit::base::method::{ArgumentNames, Arguments, Method, Returns};
use crate::emit::base::refusal::Refusal;
use crate::emit::base::shape::{Shape, doc, local};
use crate::emit::base::state::rhs;
use crate::emit::base::writer::MethodWriter;
use crate::model::Product;
use lagrange_algebra::program::Preparation;

/// Products, in addition to `acceleration` and `rhs`, for which the prepared type has methods if
/// the system has them.
pub(in crate::emit) const METHODS_OF_PREPARED: [Product; 13] = [
    Product::MassMatrix,
    Product::InverseMassMatrix,
    Product::Forcing,
    Product::Bias,
    Product::CoriolisMatrix,
    Product::InverseDynamics,
    Product::InverseDynamicsJacobian,
    Product::Regressor,
    Product::Momenta,
    Product::MomentumRates,
    Product::Jacobian,
    Product::TangentJacobian,
    Product::ParameterJacobian,
];

/// Features that cannot be prepared.
const EXCLUSIONS: [Exclusion; 6] = [
    Exclusion::Contacts,
    Exclusion::Constraints,
    Exclusion::Switches,
    Exclusion::Indefinite,
    Exclusion::Noise,
    Exclusion::Delays,
];

/// Writes the methods of the prepared type, if requested.
pub(in crate::emit) fn write_prepared(writer: &mut MethodWriter<'_>) -> Result<(), Refusal> {
    if !writer.model.products.contains(&Product::Prepared) || writer.is_hopeless() {
        return Ok(());
    }
    if let Some(exclusion) = Exclusion::first(&EXCLUSIONS, writer.model, writer.equations) {
        return Err(Refusal::Exclusion(Product::Prepared, exclusion));
    }
    let mut preparation = Preparation::new(writer.model.parameters.len() as u32);
    let mut fields = PreparedFields::new();
    let n = writer.shape.velocities.len();
    let accelerations = Plan {
        docs: &["Accelerations in the order of the velocities."],
        arguments: Arguments::State,
        returns: Returns::Vector(n),
        roots: writer.equations.accelerations.clone(),
    };
    let mut methods = vec![method(writer, "acceleration", accelerations, (&mut preparation, &mut fields))];
    for product in METHODS_OF_PREPARED
        .into_iter()
        .filter(|product| writer.model.products.contains(product))
        .collect::<Vec<_>>()
    {
        if let Some(plan) = plan(product, writer.model, writer.equations, writer.shape) {
            methods.push(method(writer, product.name(), plan, (&mut preparation, &mut fields)));
        }
    }
    let (statements, values, counts) = writer.prepared_values(preparation);
    let docs = match fields.names.len() {
        0 => "Nothing is computed of parameters alone.".to_owned(),
        1 => format!("Keeps 1 value, which takes {}.", docs::counts_text(counts)),
        kept => format!("Keeps {kept} values, which take {}.", docs::counts_text(counts)),
    };
    writer.members.prepared = Some(Prepared { fields, values: (statements, values), methods, docs });
    Ok(())
}

fn method(
    writer: &mut MethodWriter<'_>,
    name: &str,
    Plan { docs, arguments, returns, roots }: Plan,
    prepared: (&mut Preparation, &mut PreparedFields),
) -> Method {
    let (body, counts) =
        writer.lowered_prepared(&roots, arguments, prepared, |results| returns.collect(results));
    let docs = docs.iter().map(|line| doc(line)).collect();
    let docs = writer.shape.method_docs((name, returns), &docs, counts);
    Method { name: format_ident!("{name}"), docs, arguments, returns, body }
}

/// Returns the prepared type, if requested.
pub(in crate::emit) fn prepared_struct(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let prepared = members.prepared.as_ref()?;
    let (name, system, generics) = (shape.prepared_name(), shape.name(), shape.generics());
    let (visibility, scalar, fields) =
        (&shape.declaration.visibility, shape.scalar_path(), &prepared.fields.names);
    let text = &shape.declaration.name.text;
    let title =
        doc(&format!("[`{text}`] beside the values of all that its methods compute of parameters alone."));
    let made = doc(&format!(
        "[`{text}::prepared`] makes it of the parameters as they are then: it keeps a copy of the system."
    ));
    let (kept, type_name) = (doc(&prepared.docs), type_name_exception(shape));
    Some(quote! {
        #title
        ///
        #made
        #kept
        #type_name
        #visibility struct #name #generics {
            system: #system #generics,
            #(#fields: #scalar,)*
        }
    })
}

/// Returns the method that creates the prepared type.
pub(in crate::emit) fn prepared_method(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let prepared = members.prepared.as_ref()?;
    let (name, generics, fields) = (shape.prepared_name(), shape.generics(), &prepared.fields.names);
    let (statements, values) = &prepared.values;
    let entries = fields.iter().zip(values).map(|(field, value)| match *field == value.to_string() {
        true => quote!(#field),
        false => quote!(#field: #value),
    });
    let (others, switches) = (shape.kept_fields(|_| true), kept_switches(shape));
    let others = quote!(#others #switches);
    let system = if others.is_empty() { quote!(Self) } else { quote!(Self { #others }) };
    Some(quote! {
        /// The system beside the values of all that its methods compute of parameters alone.
        #[must_use]
        pub fn prepared(&self) -> #name #generics {
            #statements
            #name { system: #system, #(#entries,)* }
        }
    })
}

/// Returns methods and traits of the prepared type.
pub(in crate::emit) fn prepared_items(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let prepared = members.prepared.as_ref()?;
    let (name, system) = (shape.prepared_name(), shape.name());
    let (generics, bounds) = (shape.generics(), shape.bounds());
    let methods = prepared.methods.iter().map(|method| method.tokens(shape, &members.names));
    let rhs = rhs(shape, &members.names, &quote!(self.system));
    let (wrapper, inputs, outputs) =
        (wrapper_impl(shape, members), inputs_impl(shape, prepared), outputs_impl(shape, members));
    Some(quote! {
        impl #bounds #name #generics {
            /// The system as it was prepared.
            #[must_use]
            #[inline]
            pub fn system(&self) -> &#system #generics {
                &self.system
            }
            #(#methods)*
            #rhs
        }
        #[automatically_derived]
        impl #bounds ::core::clone::Clone for #name #generics {
            fn clone(&self) -> Self {
                self.system.prepared()
            }
        }
        #wrapper
        #inputs
        #outputs
    })
}

fn wrapper_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (name, system, generics, bounds) =
        (shape.prepared_name(), shape.name(), shape.generics(), shape.bounds());
    let (krate, scalar, all) = (shape.krate, shape.scalar(), shape.state_length());
    let (inner, ArgumentNames { time, state, .. }) = (local("system"), &members.names);
    let has_jacobian = members.methods.iter().any(|method| method.name == Product::Jacobian.name());
    let jacobian = has_jacobian.then(|| {
        quote! {
            #[inline]
            fn outer_jacobian(
                &self,
                #time: #scalar,
                #state: &[#scalar; #all],
            ) -> ::core::option::Option<[[#scalar; #all]; #all]> {
                ::core::option::Option::Some(self.jacobian(#time, #state))
            }
        }
    });
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::Wrapper for #name #generics {
            type Inner = #system #generics;
            type State = [#scalar; #all];
            #[inline]
            fn inner(&self) -> &#system #generics {
                &self.system
            }
            fn around(&self, #inner: #system #generics) -> Self {
                #inner.prepared()
            }
            #[inline]
            fn outer_rhs(&self, #time: #scalar, #state: &[#scalar; #all]) -> [#scalar; #all] {
                self.rhs(#time, #state)
            }
            #jacobian
        }
    }
}

/// Implements `ControlledSystem`, if there are inputs: no prepared value depends on them.
fn inputs_impl(shape: &Shape<'_>, prepared: &Prepared) -> Option<TokenStream> {
    let has_inputs = shape.fields.iter().any(|name| shape.is_input(name));
    let (name, system, inputs) = (shape.prepared_name(), shape.name(), inputs_name(shape));
    let (generics, bounds, krate) = (shape.generics(), shape.bounds(), shape.krate);
    let (fields, values) = (&prepared.fields.names, local("inputs"));
    let inner = quote!(<#system #generics as #krate::system::ControlledSystem>);
    has_inputs.then(|| {
        quote! {
            #[automatically_derived]
            impl #bounds #krate::system::ControlledSystem for #name #generics {
                type Inputs = #inputs #generics;
                type InputVector = #inner::InputVector;
                const INPUTS: &'static [&'static ::core::primitive::str] = #inner::INPUTS;
                #[inline]
                fn inputs(&self) -> #inputs #generics {
                    #inner::inputs(&self.system)
                }
                #[inline]
                fn with_inputs(&self, #values: #inputs #generics) -> Self {
                    Self { system: #inner::with_inputs(&self.system, #values), #(#fields: self.#fields,)* }
                }
            }
        }
    })
}

/// Implements `OutputSystem`, if there are outputs.
fn outputs_impl(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (name, system, krate) = (shape.prepared_name(), shape.name(), shape.krate);
    let (generics, bounds) = (shape.generics(), shape.bounds());
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    let inner = quote!(<#system #generics as #krate::system::OutputSystem>);
    has_outputs(shape, members).then(|| {
        quote! {
            #[automatically_derived]
            impl #bounds #krate::system::OutputSystem for #name #generics {
                type Outputs = #inner::Outputs;
                const OUTPUTS: &'static [&'static ::core::primitive::str] = #inner::OUTPUTS;
                #[inline]
                fn outputs(&self, #parameters) -> Self::Outputs {
                    #inner::outputs(&self.system, #passed)
                }
            }
        }
    })
}
