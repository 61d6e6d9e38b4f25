//! The items of an emitted system: the struct, its state, implementations and traits.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote, quote_spanned};

use super::base::attributes::{conditions, deprecated_exception};
use super::base::method::{ArgumentNames, Method};
use super::base::shape::{Shape, doc, identifier, length, local};
use super::base::state::{columns_impls, columns_struct, state_conversions, state_struct, state_variables};
use super::features::constrained::projections;
use super::features::contacts::mode_fields;
use super::features::ports::{inputs_impls, inputs_struct, outputs_impl};
use super::features::scene::motion_name;
use super::features::switches::switches_declaration;
use super::traits::trait_impls;

/// Everything that differs between a derived system and a skeleton.
pub(super) struct Parts {
    /// Documentation of the struct, after the user's own.
    pub(super) docs: Vec<String>,
    /// The body of `Default::default`, if all defaults are known.
    pub(super) default: Option<TokenStream>,
    pub(super) methods: Vec<Method>,
    /// Methods of `ConstrainedSystem`; none without constraints.
    pub(super) constrained: Vec<Method>,
    /// Methods of `CanonicalSystem` that only constrained systems have of their own.
    pub(super) canonical: Vec<Method>,
    /// Of each constraint, whether it holds positions.
    pub(super) are_holonomic: Vec<bool>,
    /// The body of `ContactSystem::terms`.
    pub(super) terms: TokenStream,
    /// The body of `SwitchedSystem::switch_times`, if there is a time to tell.
    pub(super) switch_times: Option<TokenStream>,
    /// Of each reaction, whether it has a coefficient of restitution that depends on time or the state.
    pub(super) restitutions_vary: Vec<bool>,
    /// Methods that only others call.
    pub(super) hidden: TokenStream,
    /// Methods that say how bodies move.
    pub(super) motions: TokenStream,
    /// The body of `Scene::items`, if that is asked for.
    pub(super) items: Option<TokenStream>,
    /// Associated constants.
    pub(super) constants: TokenStream,
    pub(super) names: ArgumentNames,
    /// Functions of `lagrange::private` that the methods call.
    pub(super) functions: BTreeSet<&'static str>,
    /// Whether explicit symplectic methods take the system.
    pub(super) is_separable: bool,
    /// Whether the methods hold rounded values of irrational constants.
    pub(super) has_rounded_constants: bool,
}

/// All items. The implementations stand in an anonymous constant, so that the names they import and the
/// helpers they need are nobody else's.
pub(super) fn items(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let system = system_struct(shape, parts);
    let (state, columns) = (state_struct(shape), columns_struct(shape));
    let implementations = [inherent_impl(shape, parts), default_impl(shape, parts)];
    let conversions = [state_conversions(shape), columns_impls(shape)];
    let traits = trait_impls(shape, parts);
    let ports = [inputs_impls(shape), outputs_impl(shape, parts)].into_iter().flatten();
    let scalar = shape.scalar_path();
    let import = shape.generics().is_empty().then(|| quote!(use #scalar;));
    let (krate, functions) = (shape.krate, parts.functions.iter().map(|name| local(name)));
    let functions = (!parts.functions.is_empty()).then(|| quote!(use #krate::private::{#(#functions),*};));
    let names = name_exception(shape);
    let rounded = rounded_exception(parts.has_rounded_constants);
    let attributes = &shape.declaration.attributes;
    let (conditions, deprecated) = (conditions(attributes), deprecated_exception(attributes));
    let is_derived = shape.declaration.derives.iter().any(|name| name.text == "Default");
    let default = (parts.default.is_none() && !is_derived)
        .then(|| quote!(#conditions #krate::private::bring_hints! { default }));
    let inputs = inputs_struct(shape).map(|inputs| quote!(#conditions #inputs));
    quote! {
        #system
        #conditions
        #state
        #conditions
        #columns
        #inputs
        #conditions
        #krate::private::bring_hints! {}
        #default
        #conditions
        #names
        #rounded
        #deprecated
        const _: () = {
            #import
            #functions
            #(#implementations)*
            #(#conversions)*
            #traits
            #(#ports)*
        };
    }
}

/// Lets rounded constants look like those of the standard library.
pub(super) fn rounded_exception(is_needed: bool) -> Option<TokenStream> {
    is_needed.then(
        || quote!(#[allow(clippy::approx_constant, reason = "constants are rounded to the scalar once")]),
    )
}

/// Lets the names of types go with that of the struct, which alone is warned of.
pub(super) fn type_name_exception(shape: &Shape<'_>) -> Option<TokenStream> {
    let name = shape.declaration.name.text.trim_matches('_');
    let is_camel_case = !name.starts_with(char::is_lowercase) && !name.contains('_');
    let exception = quote!(#[allow(non_camel_case_types, reason = "the name goes with that of the system")]);
    (!is_camel_case).then_some(exception)
}

/// Lets names keep the letters that they have in formulas.
pub(super) fn name_exception(shape: &Shape<'_>) -> Option<TokenStream> {
    let touching = shape.touching.iter().map(|(name, _)| name);
    let outputs = shape.outputs.iter().map(|(name, _)| name);
    let names = shape.fields.iter().chain(&shape.coordinates).chain(touching).chain(outputs);
    let methods = shape.bodies.iter().map(|body| motion_name(body).to_string());
    let names = names.map(|name| name.text.clone()).chain(methods);
    let is_snake_case = |name: &str| !name.contains(char::is_uppercase) && !name.contains("__");
    let exception =
        quote!(#[allow(non_snake_case, reason = "symbols keep the letters they have in formulas")]);
    (!{ names }.all(|name| is_snake_case(&name))).then_some(exception)
}

/// A place of the user's for what is emitted nevertheless, and no matter of the user's lints.
fn emitted_at(place: Span) -> Span {
    place.resolved_at(Span::mixed_site())
}

fn system_struct(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let declaration = shape.declaration;
    let (mut docs, attributes) = split_attributes(&declaration.attributes);
    let (name, generics, scalar) = (shape.name(), shape.generics(), shape.scalar_path());
    let visibility = declaration.visibility.clone().into_iter().map(|mut token| {
        token.set_span(emitted_at(token.span()));
        token
    });
    let (visibility, keyword) =
        (visibility.collect::<TokenStream>(), Ident::new("struct", emitted_at(declaration.keyword)));
    if docs.is_empty() {
        docs.push(doc(&format!("A mechanical system with the {}.", coordinate_list(shape))));
    }
    if !parts.docs.is_empty() {
        docs.push(doc(""));
        docs.extend(parts.docs.iter().map(|line| doc(line)));
    }
    let field_docs = shape
        .fields
        .iter()
        .map(|name| shape.docs(name, &format!("{} `{}`.", shape.kind_of_field(name), name.text)));
    let fields = shape.fields.iter().map(|name| identifier(name));
    let fields = quote!(#(#field_docs pub #fields: #scalar,)*);
    let marker = shape.needs_marker().then(|| {
        quote! {
            /// The number type.
            pub scalar: ::core::marker::PhantomData<#scalar>,
        }
    });
    let fields =
        [fields, mode_fields(shape)].into_iter().chain(switches_declaration(shape)).collect::<TokenStream>();
    // It begins and ends in what the user wrote, so that the compiler proposes attributes there and not in the macro.
    let body = match fields.is_empty() && marker.is_none() {
        true => quote_spanned!(emitted_at(declaration.name.span)=> ;),
        false => {
            let mut body = Group::new(Delimiter::Brace, quote!(#fields #marker));
            body.set_span(emitted_at(declaration.name.span));
            body.into_token_stream()
        }
    };
    let names = name_exception(shape);
    let touching = shape.touching.iter().map(|(name, _)| name);
    let unused = shape.fields.iter().chain(touching).any(|name| name.text.starts_with('_'));
    let unused = unused.then(|| {
        quote!(#[allow(clippy::pub_underscore_fields, reason = "the user marked the parameter as unused")])
    });
    quote! {
        #(#docs)*
        #(#attributes)*
        #names
        #unused
        #visibility #keyword #name #generics #body
    }
}

/// The lines of documentation and the other attributes.
pub(super) fn split_attributes(attributes: &TokenStream) -> (Vec<TokenStream>, Vec<TokenStream>) {
    let tokens = attributes.clone().into_iter().collect::<Vec<_>>();
    // An attribute is a number sign and a group in brackets.
    let (docs, others) = tokens.chunks(2).partition::<Vec<_>, _>(|attribute| is_documentation(attribute));
    let attributes = |list: Vec<&[TokenTree]>| {
        list.into_iter().map(|attribute| attribute.iter().cloned().collect()).collect()
    };
    (attributes(docs), attributes(others))
}

/// `#[doc = …]`, which is also what comments become, but not `#[doc(hidden)]`.
fn is_documentation(attribute: &[TokenTree]) -> bool {
    let Some(TokenTree::Group(group)) = attribute.get(1) else { return false };
    let mut tokens = group.stream().into_iter();
    let is_doc = matches!(tokens.next(), Some(TokenTree::Ident(word)) if word == "doc");
    is_doc && matches!(tokens.next(), Some(TokenTree::Punct(punct)) if punct.as_char() == '=')
}

fn coordinate_list(shape: &Shape<'_>) -> String {
    let names = shape.coordinates.iter().map(|name| format!("`{}`", name.text)).collect::<Vec<_>>();
    match names.as_slice() {
        [single] => format!("coordinate {single}"),
        names => format!("coordinates {}", names.join(", ")),
    }
}

fn inherent_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    let methods = parts.methods.iter().map(|method| method.tokens(shape, &parts.names));
    let (constants, rhs) = (&parts.constants, rhs(shape, &parts.names));
    let (hidden, motions) = (&parts.hidden, &parts.motions);
    let projections = projections(shape, parts);
    quote! {
        impl #bounds #name #generics {
            #constants
            #(#methods)*
            #rhs
            #motions
            #projections
            #hidden
        }
    }
}

/// ẏ = [v, a]
fn rhs(shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
    let (scalar, n) = (shape.scalar(), shape.coordinates.len());
    let (twice, variables) = (length(2 * n), state_variables(shape));
    let (positions, velocities) = variables.split_at(n);
    let ArgumentNames { time, state, accelerations, .. } = names;
    let indices = (0..n).map(length);
    quote! {
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, #time: #scalar, #state: &[#scalar; #twice]) -> [#scalar; #twice] {
            let [#(#variables),*] = *#state;
            let #accelerations = self.acceleration(#time, &[#(#positions),*], &[#(#velocities),*]);
            [#(#velocities,)* #(#accelerations[#indices]),*]
        }
    }
}

fn default_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let Some(default) = &parts.default else { return TokenStream::new() };
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    quote! {
        #[automatically_derived]
        impl #bounds ::core::default::Default for #name #generics {
            fn default() -> Self {
                #default
            }
        }
    }
}

/// Distinct names for the arguments; the user's names come first.
pub(super) fn argument_names(mut allocate: impl FnMut(&str) -> Ident) -> ArgumentNames {
    let (residuals, shares, visit) = (allocate("residuals"), allocate("shares"), allocate("visit"));
    let mut either = |short: &str, long: &str| {
        let name = allocate(short);
        if name == short { name } else { allocate(long) }
    };
    ArgumentNames {
        time: either("t", "time"),
        positions: either("q", "positions"),
        velocities: either("v", "velocities"),
        accelerations: either("a", "accelerations"),
        state: either("y", "state"),
        residuals,
        shares,
        visit,
    }
}
