//! Ignored coordinates of reduced types: their momenta from states of the whole system, and their
//! velocities from momenta.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::switches::free_switches;
use crate::emit::base::fields::{Field, entries, places};
use crate::emit::base::shape::{Shape, doc, identifier, length, local};
use lagrange_expr::collections::HashMap;
use lagrange_language::syntax::ast::{Name, ReductionKind, StatementKind, momentum_of};

/// An ignored coordinate of a reduced type.
pub(super) struct Ignored {
    /// The parameter that is its momentum.
    momentum: Name,
    /// Index of its velocity in the whole system.
    velocity: usize,
    /// Index of its state in the reduced type.
    state: usize,
}

impl Ignored {
    /// Returns the ignored coordinates of a reduced type.
    pub(super) fn of(full: &Shape<'_>, part: &Shape<'_>) -> Vec<Ignored> {
        let is_ignored = |name: &Name| match part.declaration.reduction.as_ref().map(|of| &of.kind) {
            Some(StatementKind::Reduce(reduction)) => {
                reduction.of_kind(ReductionKind::Ignored).any(|item| item.coordinate.text == name.text)
            }
            _ => false,
        };
        let velocities = full.velocities.iter().enumerate();
        let own = velocities.filter_map(|(velocity, of)| {
            let name = of.coordinate.filter(|name| is_ignored(name))?;
            let state = part.coordinates.iter().position(|state| state.text == name.text)?;
            Some(Ignored { momentum: momentum_of(name), velocity, state })
        });
        own.collect()
    }
}

/// Returns the reconstructed velocity for an entry of the state, if it belongs to an ignored
/// coordinate.
pub(super) fn rate_of(ignored: &[Ignored], entry: usize, full: &Shape<'_>) -> Option<TokenStream> {
    let velocity = entry.checked_sub(full.coordinates.len())?;
    let Ignored { state, .. } = ignored.iter().find(|of| of.velocity == velocity)?;
    let (rates, state) = (local("rates"), length(*state));
    Some(quote!(#rates[#state]))
}

/// Writes the statement that reconstructs velocities of ignored coordinates from a state of the
/// reduced type.
pub(super) fn rates_at(ignored: &[Ignored], state: &TokenStream) -> Option<TokenStream> {
    let [rates, reduced, time] = ["rates", "reduced", "t"].map(local);
    (!ignored.is_empty()).then(|| {
        quote! {
            let #reduced = #state;
            let #rates = self.position_rates(#time, &#reduced.coordinates(), &#reduced.velocities());
        }
    })
}

/// Writes the constructor that computes momenta from a state of the whole system, or nothing if no
/// coordinate is ignored. In this state, frozen coordinates rest at their values.
pub(super) fn constructor(full: &Shape<'_>, part: &Shape<'_>, is_derived: bool) -> Option<TokenStream> {
    let ignored = Ignored::of(full, part);
    let [system, state, time, momenta] = ["system", "state", "t", "momenta"].map(local);
    let (whole, generics, scalar) = (full.name(), part.generics(), part.scalar());
    let whole_state = full.state_name();
    let names = ignored.iter().map(|of| format!("`{}`", of.momentum.text)).collect::<Vec<_>>().join(", ");
    let docs = doc(&format!(
        "The system that [`{}`] is in the motion through a state at time `t`:",
        full.declaration.name.text
    ));
    let parameters = doc(&format!("{names} from that state, all else as in `system`."));
    let body = match is_derived {
        true => {
            let held = held_state(full, part, &ignored);
            let own = literal(part, &ignored, |of| {
                let velocity = length(of.velocity);
                quote!(#momenta[#velocity])
            });
            quote! {
                #held
                let #momenta = #system.momenta(#time, &#state.coordinates(), &#state.velocities());
                #own
            }
        }
        false => quote!(::core::unreachable!()),
    };
    (!ignored.is_empty()).then(|| quote! {
        #docs
        #parameters
        #[must_use]
        #[inline]
        pub fn from_state(#system: &#whole #generics, #time: #scalar, #state: #whole_state #generics) -> Self {
            #body
        }
    })
}

/// Writes a statement that sets frozen coordinates to rest at their values, if there are any.
fn held_state(full: &Shape<'_>, part: &Shape<'_>, ignored: &[Ignored]) -> Option<TokenStream> {
    let [held, state, time] = ["held", "state", "t"].map(local);
    let (whole, reduced) = (full.state_name(), part.state_name());
    let kept = values_of(full, (part, &part.state_fields()), &state).into_iter().enumerate();
    let is_ignored = |entry: usize| {
        let velocity = entry.checked_sub(full.coordinates.len());
        ignored.iter().any(|of| Some(of.velocity) == velocity)
    };
    let is_frozen = kept.map(|(entry, kept)| kept.is_empty() && !is_ignored(entry)).collect::<Vec<_>>();
    let values = places(&full.state_fields()).into_iter().zip(&is_frozen);
    let values = values.map(|(place, is_frozen)| match is_frozen {
        true => quote!(#held.#place),
        false => quote!(#state.#place),
    });
    let entries = entries(&full.state_fields(), &values.collect::<Vec<_>>());
    let (scalar, krate) = (part.scalar(), part.krate);
    let resting = literal(part, ignored, |_| quote!(<#scalar as #krate::Number>::ZERO));
    is_frozen.contains(&true).then(|| {
        quote! {
            let #held = #resting.expand(#time, #reduced::from(#state));
            let #state = #whole { #(#entries),* };
        }
    })
}

/// Writes a system with the fields of `system` and with momenta.
fn literal(part: &Shape<'_>, ignored: &[Ignored], momentum: impl Fn(&Ignored) -> TokenStream) -> TokenStream {
    let system = local("system");
    let own = ignored.iter().map(|of| (identifier(&of.momentum), momentum(of))).collect::<Vec<_>>();
    let kept = part.number_identifiers().into_iter().chain(part.fields_of_modes().map(identifier));
    let kept = kept.filter(|field| own.iter().all(|(momentum, _)| momentum != field));
    let kept = kept.map(|field| quote!(#field: #system.#field,));
    let own = own.iter().map(|(field, value)| quote!(#field: #value,));
    let switches = free_switches(part);
    quote!(Self { #(#kept)* #(#own)* #switches })
}

/// Returns, for each entry of the state of one shape, the same entry in the state of another;
/// `None` if it does not exist.
pub(super) fn values_of(
    of: &Shape<'_>,
    (other, fields): (&Shape<'_>, &[Field]),
    state: &Ident,
) -> Vec<TokenStream> {
    let names = other.state_names().into_iter().map(|name| name.text);
    let places = names.zip(places(fields)).collect::<HashMap<_, _>>();
    let names = of.state_names().into_iter();
    let values =
        names.map(|name| places.get(&name.text).map(|place| quote!(#state.#place)).unwrap_or_default());
    values.collect()
}
