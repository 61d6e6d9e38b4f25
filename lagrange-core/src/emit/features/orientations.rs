//! Members of systems with velocities that are not rates of positions or have separate names.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::emit::base::fields::split_indices;
use crate::emit::base::members::Members;
use crate::emit::base::method::{ArgumentNames, Arguments, Method, Returns};
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::base::writer::MethodWriter;
use lagrange_language::syntax::ast::{Name, StateVelocity};

/// Writes `position_rates` where velocities are not the rates of the positions.
pub(in crate::emit) fn write_position_rates(writer: &mut MethodWriter<'_>) {
    if writer.shape.velocities_are_rates() {
        return;
    }
    let rates = writer.model.position_rates();
    let returns = Returns::Vector(rates.len());
    let (body, _) = writer.lowered(&rates, Arguments::State, |results| returns.collect(results));
    let docs = writer.shape.rates_docs(match writer.shape.states {
        0 => "Rates of the positions: kinematic differential equations.",
        _ => "Rates of the positions: kinematic differential equations, then the equations of the states.",
    });
    let name = format_ident!("position_rates");
    writer.members.methods.push(Method { name, docs, arguments: Arguments::State, returns, body });
}

/// Writes `MechanicalSystem::position_rates`.
pub(in crate::emit) fn position_rates(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (scalar, nq, nv) = (shape.scalar(), shape.positions_length(), shape.velocities_length());
    let ArgumentNames { time, positions, velocities, .. } = &members.names;
    let (time, positions, rates) = match shape.velocities_are_rates() {
        true => (quote!(_), quote!(_), quote!(*#velocities)),
        false => {
            let rates = quote!(self.position_rates(#time, #positions, #velocities));
            (quote!(#time), quote!(#positions), rates)
        }
    };
    quote! {
        #[inline]
        fn position_rates(
            &self,
            #time: #scalar,
            #positions: &[#scalar; #nq],
            #velocities: &[#scalar; #nv],
        ) -> [#scalar; #nq] {
            #rates
        }
    }
}

/// Emits the constants about named velocities and quaternions.
pub(in crate::emit) fn orientation_members(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    if !shape.names_velocities() {
        return None;
    }
    let names = shape.velocities.iter().map(|velocity| written_velocity(shape, velocity));
    let rates_of =
        shape.velocities.iter().map(|velocity| velocity.coordinate.map_or("", |name| shape.written(name)));
    let normalise = normalise(shape, members);
    let (displacement, change) = (displacement(shape), position_change(shape, members));
    let states = length(shape.states);
    let states =
        (shape.states > 0).then(|| quote!(const FIRST_ORDER_STATES: ::core::primitive::usize = #states;));
    Some(quote! {
        const VELOCITIES: &'static [&'static ::core::primitive::str] = &[#(#names),*];
        const RATES_OF: &'static [&'static ::core::primitive::str] = &[#(#rates_of),*];
        #states
        #normalise
        #displacement
        #change
    })
}

/// Writes `MechanicalSystem::position_change`, which leaves first-order states unchanged.
fn position_change(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, scalar, nq) = (shape.krate, shape.scalar(), shape.positions_length());
    let ([parameters, passed], change) = (Arguments::State.written(shape, &members.names), local("change"));
    let states = (shape.coordinates.len() - shape.states..shape.coordinates.len()).map(length);
    (shape.states > 0).then(|| {
        quote! {
            #[inline]
            fn position_change(&self, #parameters) -> [#scalar; #nq] {
                let mut #change = self.position_rates(#passed);
                #(#change[#states] = <#scalar as #krate::Number>::ZERO;)*
                #change
            }
        }
    })
}

/// Returns the spelling of a velocity: its own element, or the rate of one.
pub(in crate::emit) fn written_velocity(shape: &Shape<'_>, velocity: &StateVelocity<'_>) -> String {
    let is_rate = |name: &&Name| velocity.name.text == format!("{}_dot", name.text);
    match velocity.coordinate.filter(is_rate).map(|name| shape.written(name)) {
        Some(coordinate) => {
            let (stem, indices) = split_indices(coordinate);
            format!("{stem}_dot{indices}")
        }
        None => shape.written(&velocity.name).to_owned(),
    }
}

fn normalise(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, scalar, nq) = (shape.krate, shape.scalar(), shape.positions_length());
    let positions = &members.names.positions;
    let first = shape.quaternions.iter().map(|&first| length(first));
    (!shape.quaternions.is_empty()).then(|| {
        quote! {
            #[inline]
            fn normalise(#positions: &mut [#scalar; #nq]) {
                #(#krate::system::quaternion::normalise(#positions, #first);)*
            }
        }
    })
}

/// Writes differences of coordinates, and turns between quaternions.
fn displacement(shape: &Shape<'_>) -> TokenStream {
    let (krate, scalar) = (shape.krate, shape.scalar());
    let (nq, nv) = (shape.positions_length(), shape.velocities_length());
    let [from, to] = ["from", "to"].map(local);
    let turn = |number: usize| format_ident!("turn_{number}", span = proc_macro2::Span::mixed_site());
    let turns = shape.quaternions.iter().enumerate().map(|(number, &first)| {
        let (turn, first) = (turn(number), length(first));
        quote!(let #turn = #krate::system::quaternion::turn(#from, #to, #first);)
    });
    let mut angular = 0..;
    let entries = shape.velocities.iter().map(|velocity| match shape.position_of(velocity) {
        Some(position) => {
            let position = length(position);
            quote!(#to[#position] - #from[#position])
        }
        None => {
            let component = angular.next().unwrap_or_default();
            let (turn, axis) = (turn(component / 3), length(component % 3));
            quote!(#turn[#axis])
        }
    });
    let entries = entries.collect::<Vec<_>>();
    quote! {
        #[inline]
        fn displacement(&self, _: #scalar, #from: &[#scalar; #nq], #to: &[#scalar; #nq]) -> [#scalar; #nv] {
            #(#turns)*
            [#(#entries),*]
        }
    }
}
