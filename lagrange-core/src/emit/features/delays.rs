//! Members for delayed signals: their values, their delays, and `DelayedSystem`.

use proc_macro2::TokenStream;
use quote::quote;

use super::switches::kept_switches;
use crate::emit::base::fields::places;
use crate::emit::base::members::Members;
use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::base::writer::MethodWriter;

/// Writes the signals and their delays.
pub(in crate::emit) fn write_delays(writer: &mut MethodWriter<'_>) {
    let delays = writer.model.delays.clone();
    if delays.is_empty() {
        return;
    }
    let lags = delays.iter().map(|delay| delay.lag).collect::<Vec<_>>();
    let signals = delays.iter().map(|delay| delay.signal).collect::<Vec<_>>();
    let collect = |results: &[TokenStream]| quote!([#(#results),*]);
    let (lags, _) = writer.lowered_as_declared(&lags, Arguments::None, collect);
    let (signals, _) = writer.lowered(&signals, Arguments::State, collect);
    let lags = lags_method(writer.shape, &lags);
    writer.members.hidden.extend(lags);
    let returns = Returns::Vector(delays.len());
    writer.push_hidden("signals_to_delay", returns, signals);
    if writer.shape.has_history {
        let before = delays.iter().filter_map(|delay| delay.before).collect::<Vec<_>>();
        let (before, _) = writer.lowered_as_declared(&before, Arguments::State, collect);
        writer.push_hidden("signals_before_start", returns, before);
    }
}

/// Returns the method that computes the delays of signals.
pub(in crate::emit) fn lags_method(shape: &Shape<'_>, body: &TokenStream) -> TokenStream {
    let (scalar, count) = (shape.scalar(), length(shape.delays.len()));
    quote! {
        fn lags_of_delays(&self) -> [#scalar; #count] {
            #body
        }
    }
}

/// Implements `DelayedSystem`, if signals are delayed.
pub(in crate::emit) fn delayed_impl(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    if shape.delays.is_empty() {
        return None;
    }
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, count) = (shape.krate, length(shape.delays.len()));
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    let (values, delayed) = (local("values"), local("delayed"));
    let first = shape.fields.len() - shape.inputs.len();
    let places = places(&shape.number_fields());
    let assignments = shape.delays.iter().enumerate().map(|(number, input)| {
        let (number, place) = (length(number), &places[first + input]);
        quote!(#delayed.#place = #values[#number];)
    });
    let (kept, switches) = (shape.kept_fields(|_| true), kept_switches(shape));
    let before = shape.has_history.then(|| {
        quote! {
            #[inline]
            fn signals_before(&self, #parameters) -> ::core::option::Option<[#scalar; #count]> {
                ::core::option::Option::Some(self.signals_before_start(#passed))
            }
        }
    });
    Some(quote! {
        #[automatically_derived]
        impl #bounds #krate::system::DelayedSystem for #name #generics {
            type Signals = [#scalar; #count];
            fn lags(&self) -> [#scalar; #count] {
                self.lags_of_delays()
            }
            #[inline]
            fn signals(&self, #parameters) -> [#scalar; #count] {
                self.signals_to_delay(#passed)
            }
            #before
            #[inline]
            fn with_delayed(&self, #values: &[#scalar; #count]) -> Self {
                let mut #delayed = Self { #kept #switches };
                #(#assignments)*
                #delayed
            }
        }
    })
}

/// Returns the member of `OdeSystem` that marks systems with delayed signals.
pub(in crate::emit) fn delay_member(shape: &Shape<'_>) -> Option<TokenStream> {
    (!shape.delays.is_empty()).then(|| {
        quote!(
            const HAS_DELAYS: ::core::primitive::bool = true;
        )
    })
}
