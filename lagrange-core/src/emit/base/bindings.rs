//! Variables of method bodies: parameters, coordinates and other symbols.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::method::{ArgumentNames, Arguments};
use super::shape::{Shape, length, local};
use crate::model::Model;
use lagrange_algebra::code::Names;
use lagrange_expr::collections::HashSet;
use lagrange_expr::symbol::Role;

/// Variables for the symbols in the bodies of one system.
pub(super) struct Bindings<'a> {
    pub(super) shape: &'a Shape<'a>,
    pub(super) model: &'a Model,
    pub(super) arguments: &'a ArgumentNames,
    pub(super) emitted_type: EmittedType<'a>,
}

/// Type that a method body belongs to.
#[derive(Clone, Copy)]
pub(super) enum EmittedType<'a> {
    /// The system.
    System,
    /// The prepared type, with these fields.
    Prepared(&'a [Ident]),
    /// The type for numbers in lanes.
    Lanes,
}

impl Bindings<'_> {
    /// Binds parameters, coordinates and rates to the names that the body uses.
    pub(super) fn of(&self, used: &[Role], names: &mut Names, arguments: Arguments) -> TokenStream {
        let ArgumentNames { time, positions, velocities, accelerations, state, residuals, .. } =
            self.arguments;
        let fields = match self.emitted_type {
            EmittedType::System => field_bindings(self.shape, self.model, used, names),
            EmittedType::Prepared(fields) => self.prepared_bindings(fields, used, names),
            EmittedType::Lanes => self.lanes_bindings(used, names),
        };
        let sides = self.side_bindings(used, names, arguments);
        let places = self.place_bindings(used, names);
        let fields = quote!(#fields #sides #places);
        let (nq, nv) = (self.model.coordinates.len(), self.model.speeds.len());
        let position = |index: u32| self.model.role_of_position(index as usize);
        if arguments == Arguments::Whole {
            let [nq, nv] = [nq as u32, nv as u32];
            let roles = (0..nq).map(position).chain((0..nv).map(Role::Velocity));
            let pattern = self.pattern(roles, used, names);
            let entries = pattern.map(|pattern| quote!(let #pattern = *#state;));
            return quote!(#fields #entries);
        }
        let mut vector = |source: TokenStream, count: usize, role: &dyn Fn(u32) -> Role| {
            let pattern = self.pattern((0..count as u32).map(role), used, names);
            pattern.map(|pattern| quote!(let #pattern = #source;))
        };
        let q = vector(quote!(*#positions), nq, &position);
        let v = vector(quote!(*#velocities), nv, &Role::Velocity);
        let accelerations = match arguments {
            Arguments::Motion => quote!(*#accelerations),
            _ => quote!(self.acceleration(#time, #positions, #velocities)),
        };
        let a = vector(accelerations, nv, &Role::Acceleration);
        let multipliers = match arguments {
            Arguments::Residuals => quote!(*#residuals),
            _ => quote!(self.multipliers(#time, #positions, #velocities)),
        };
        let multipliers = vector(multipliers, self.model.constraints.len(), &Role::Multiplier);
        let reactions = quote!(self.reactions(#time, #positions, #velocities));
        let reactions = vector(reactions, self.model.reactions.len(), &Role::Reaction);
        quote!(#fields #q #v #a #multipliers #reactions)
    }

    /// Binds parameters and inputs of the underlying system, and the prepared values.
    fn prepared_bindings(&self, fields: &[Ident], used: &[Role], names: &mut Names) -> TokenStream {
        let system = self.shape.name();
        let own = bound_fields(self.shape, self.model, used, names);
        let own = destructured(&own, has_others(self.shape, &own), (&quote!(#system), &quote!(self.system)));
        let symbols = self.model.graph.symbols();
        let first = self.model.parameters.len() as u32;
        let roles = (first..).map(Role::Parameter).zip(fields);
        let bound = roles.filter(|(role, _)| used.contains(role)).map(|(role, field)| {
            let local = names.role(symbols, role);
            if local == *field { quote!(#local) } else { quote!(#field: #local) }
        });
        let bound = bound.collect::<Vec<_>>();
        let prepared = (!bound.is_empty()).then(|| quote!(let Self { #(#bound,)* .. } = *self;));
        quote!(#own #prepared)
    }

    /// Binds parameters and inputs in lanes; the type has no other fields.
    fn lanes_bindings(&self, used: &[Role], names: &mut Names) -> TokenStream {
        let bound = bound_fields(self.shape, self.model, used, names);
        let has_others = bound.len() < self.shape.number_fields().len();
        destructured(&bound, has_others, (&quote!(Self), &quote!(*self)))
    }

    /// Binds the variables of a height to the coordinates of a place.
    fn place_bindings(&self, used: &[Role], names: &mut Names) -> TokenStream {
        let (graph, place) = (&self.model.graph, &self.arguments.place);
        let heights = self.model.scene.drawing.iter().filter_map(|item| item.height.as_ref());
        let variables = heights.flat_map(|height| height.variables.iter().enumerate());
        let used = variables.filter(|(_, role)| used.contains(role));
        let bound = used.map(|(index, &role)| {
            let (name, index) = (names.role(graph.symbols(), role), length(index));
            quote!(let #name = #place[#index];)
        });
        bound.collect()
    }

    /// Binds the sides of switches that a body uses.
    fn side_bindings(&self, used: &[Role], names: &mut Names, arguments: Arguments) -> Option<TokenStream> {
        let ArgumentNames { time, positions, velocities, state, .. } = self.arguments;
        let pattern = self.pattern((0..self.shape.switches.len() as u32).map(Role::Side), used, names)?;
        let (krate, n) = (self.shape.krate, length(self.model.speeds.len()));
        Some(match arguments {
            _ if matches!(self.emitted_type, EmittedType::Lanes) => {
                quote!(let #pattern = self.sides(#time, #state);)
            }
            Arguments::Whole => quote! {
                let #pattern = {
                    let (positions, velocities) = #krate::system::split::<Self>(#state);
                    self.sides(#time, &positions, &velocities)
                };
            },
            // The result does not depend on velocities, so any values are valid.
            Arguments::Positions => {
                let scalar = self.shape.scalar();
                quote!(let #pattern = self.sides(#time, #positions, &[<#scalar as #krate::Number>::ZERO; #n]);)
            }
            _ => quote!(let #pattern = self.sides(#time, #positions, #velocities);),
        })
    }

    /// Returns an array pattern with the names of the used roles, if any are used.
    fn pattern(
        &self,
        roles: impl Iterator<Item = Role> + Clone,
        used: &[Role],
        names: &mut Names,
    ) -> Option<TokenStream> {
        let symbols = self.model.graph.symbols();
        let used = used.iter().copied().collect::<HashSet<_>>();
        let is_used = |role: &Role| used.contains(role);
        let pattern = roles.clone().map(|role| match is_used(&role) {
            true => names.role(symbols, role),
            false => local("_"),
        });
        let pattern = pattern.collect::<Vec<_>>();
        { roles }.any(|role| is_used(&role)).then(|| quote!([#(#pattern),*]))
    }
}

/// Binds parameters and inputs to the names that a body uses.
pub(in crate::emit) fn field_bindings(
    shape: &Shape<'_>,
    model: &Model,
    used: &[Role],
    names: &mut Names,
) -> TokenStream {
    let bound = bound_fields(shape, model, used, names);
    destructured(&bound, has_others(shape, &bound), (&quote!(Self), &quote!(*self)))
}

/// Returns the used fields, each with the names that the body uses.
fn bound_fields(shape: &Shape<'_>, model: &Model, used: &[Role], names: &mut Names) -> Vec<TokenStream> {
    let symbols = model.graph.symbols();
    let used = used.iter().copied().collect::<HashSet<_>>();
    let roles = (0..model.parameters.len() as u32).map(Role::Parameter);
    let mut roles = roles.chain((0..model.inputs.len() as u32).map(Role::Input));
    let bound = shape.number_fields().into_iter().filter_map(|field| {
        let own = roles.by_ref().take(field.names.len()).collect::<Vec<_>>();
        own.iter().any(|role| used.contains(role)).then(|| {
            // A field can be named with the span of the macro, and must be, so that the local
            // belongs to the macro.
            let locals = own.into_iter().map(|role| match used.contains(&role) {
                true => names.role(symbols, role).into_token_stream(),
                false => quote!(_),
            });
            field.with(&locals.collect::<Vec<_>>())
        })
    });
    bound.collect()
}

/// True if the system has fields other than these.
fn has_others(shape: &Shape<'_>, bound: &[TokenStream]) -> bool {
    !shape.switches.is_empty()
        || shape.fields_of_modes().next().is_some()
        || bound.len() < shape.number_fields().len()
}

fn destructured(
    bound: &[TokenStream],
    has_others: bool,
    (name, value): (&TokenStream, &TokenStream),
) -> TokenStream {
    if bound.is_empty() {
        return TokenStream::new();
    }
    let rest = has_others.then(|| quote!(..));
    quote!(let #name { #(#bound,)* #rest } = #value;)
}
