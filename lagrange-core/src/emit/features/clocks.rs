//! Members for declared clocks: periods, and states after ticks.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::events::{call, write_assignments};
use crate::emit::base::members::Members;
use crate::emit::base::method::{ArgumentNames, Arguments};
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::base::writer::MethodWriter;

/// Writes the periods, and the states after assignments.
pub(in crate::emit) fn write_clocks(writer: &mut MethodWriter<'_>) {
    let clocks = writer.model.clocks.clone();
    if clocks.is_empty() {
        return;
    }
    let periods = clocks.iter().map(|clock| clock.period).collect::<Vec<_>>();
    let collect = |results: &[TokenStream]| quote!([#(#results),*]);
    let (body, _) = writer.lowered_as_declared(&periods, Arguments::None, collect);
    let (scalar, count) = (writer.shape.scalar(), length(clocks.len()));
    writer.members.hidden.extend(quote! {
        fn clock_periods(&self) -> [#scalar; #count] {
            #body
        }
    });
    for (index, clock) in clocks.iter().enumerate() {
        write_assignments(writer, &method(index), &clock.assignments);
    }
    writer.members.clocks = clocks.len();
}

fn method(clock: usize) -> String {
    format!("after_tick_{clock}")
}

/// Writes the members of `OdeSystem` for ticks of clocks. Simultaneous ticks occur in the order of
/// declaration.
pub(in crate::emit) fn clock_members(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    if members.clocks == 0 {
        return None;
    }
    let (krate, scalar, all) = (shape.krate, shape.scalar(), shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let option = quote!(::core::option::Option);
    let periods = (0..members.clocks).map(|index| format_ident!("period_{index}")).collect::<Vec<_>>();
    let after = (0..members.clocks).map(|index| call(shape, members, &method(index)));
    Some(quote! {
        fn shortest_period(&self) -> #option<#scalar> {
            #krate::event::shortest_period(self.clock_periods())
        }
        #[inline]
        fn is_tick(&self, #time: #scalar) -> ::core::primitive::bool {
            self.clock_periods().iter().any(|period| #krate::event::ticks(#time, *period))
        }
        fn tick(&self, #time: #scalar, #state: &[#scalar; #all]) -> #option<[#scalar; #all]> {
            if !#krate::system::OdeSystem::is_tick(self, #time) {
                return #option::None;
            }
            let [#(#periods),*] = self.clock_periods();
            #(
                let #state = &if #krate::event::ticks(#time, #periods) { #after } else { *#state };
            )*
            #option::Some(*#state)
        }
    })
}

/// Writes the time of the next tick.
pub(in crate::emit) fn next_tick(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, time, end) = (shape.krate, &members.names.time, local("end"));
    (members.clocks > 0).then(|| quote!(#krate::event::next_tick(#time, #end, self.clock_periods())))
}
