//! Units by name, for axes and files.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::base::fields::Field;
use crate::emit::base::shape::{Shape, local};
use crate::syntax::ast::{Name, acceleration_name};

/// `MechanicalSystem::UNITS`, if any unit is known: of the state, of accelerations, of parameters and inputs, and of outputs, which are given.
pub(in crate::emit) fn units_constant(
    shape: &Shape<'_>,
    outputs: Vec<(String, &str)>,
) -> Option<TokenStream> {
    let state = shape.state_fields();
    let accelerations = accelerations(shape, &state);
    let fields = state.into_iter().chain(accelerations).chain(shape.number_fields());
    let named = fields.flat_map(|field| units_of(shape, &field)).chain(outputs);
    let entries = named.map(|(name, unit)| quote!((#name, #unit))).collect::<Vec<_>>();
    let text = quote!(&'static ::core::primitive::str);
    (!entries.is_empty()).then(|| quote!(const UNITS: &'static [(#text, #text)] = &[#(#entries),*];))
}

/// Fields as there would be for accelerations, behind those of velocities.
fn accelerations(shape: &Shape<'_>, state: &[Field]) -> Vec<Field> {
    let mut positions = shape.coordinates.len();
    let velocities = state.iter().skip_while(|field| {
        let is_position = positions > 0;
        positions = positions.saturating_sub(field.names.len());
        is_position
    });
    let rate = |name: &Name| Name::new(acceleration_name(&name.text), name.span);
    let accelerations = velocities.map(|field| Field {
        identifier: local(&acceleration_name(&field.identifier.to_string())),
        names: field.names.iter().map(rate).collect(),
        sizes: field.sizes.clone(),
    });
    accelerations.collect()
}

/// The unit of a field by its name, or those of its elements by theirs where they differ.
fn units_of<'s>(shape: &'s Shape<'_>, field: &Field) -> Vec<(String, &'s str)> {
    let units = field.names.iter().map(|name| shape.unit(&name.text)).collect::<Vec<_>>();
    match units.split_first() {
        Some((Some(first), others)) if others.iter().all(|unit| *unit == Some(*first)) => {
            vec![(field.identifier.to_string(), first)]
        }
        _ => field.written().into_iter().zip(units).filter_map(|(name, unit)| Some((name, unit?))).collect(),
    }
}
