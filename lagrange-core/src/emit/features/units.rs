//! Units by name, for axes and files.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::emit::base::fields::Field;
use crate::emit::base::shape::{Shape, doc, local};
use crate::emit::base::units::PLAIN;
use lagrange_expr::units::momentum_name;
use lagrange_language::syntax::ast::{Name, acceleration_name};

/// Returns `MechanicalSystem::UNITS`, if any unit is known. It has the units of the state, of
/// accelerations, of parameters and inputs, of the given outputs, and of momenta if there are any.
/// Momenta come last, so that the unit of a declared name takes precedence.
pub(in crate::emit) fn units_constant(
    shape: &Shape<'_>,
    outputs: Vec<(String, &str)>,
    has_momenta: bool,
) -> Option<TokenStream> {
    let entries = units_by_name(shape, outputs, has_momenta);
    let entries = entries.iter().map(|(name, unit)| quote!((#name, #unit))).collect::<Vec<_>>();
    let text = quote!(&'static ::core::primitive::str);
    (!entries.is_empty()).then(|| quote!(const UNITS: &'static [(#text, #text)] = &[#(#entries),*];))
}

/// Returns the known units of the state, accelerations, momenta, parameters, inputs and outputs.
pub(in crate::emit) fn units_by_name<'s>(
    shape: &'s Shape<'_>,
    outputs: Vec<(String, &'s str)>,
    has_momenta: bool,
) -> Vec<(String, &'s str)> {
    let state = shape.state_fields();
    let accelerations = accelerations(shape, &state);
    let momenta = if has_momenta { momenta(shape, &state) } else { Vec::new() };
    let fields = state.into_iter().chain(accelerations).chain(shape.number_fields());
    let named = fields.flat_map(|field| units_of(shape, &field)).chain(outputs);
    named.chain(momenta.iter().flat_map(|field| units_of(shape, field))).collect()
}

/// Returns documentation of the units of parameters and inputs, such as `` `m` in kg, `l` in m ``.
/// `None` if all known units are those of plain numbers.
pub(in crate::emit) fn units_of_parameters(shape: &Shape<'_>) -> Option<TokenStream> {
    let fields = shape.number_fields();
    let units = fields.iter().flat_map(|field| units_of(shape, field)).filter(|(_, unit)| *unit != PLAIN);
    let units = units.map(|(name, unit)| format!("`{name}` in {unit}")).collect::<Vec<_>>().join(", ");
    let (blank, line) = (doc(""), doc(&format!("Units: {units}.")));
    (!units.is_empty()).then(|| quote!(#blank #line))
}

/// Returns fields for accelerations, derived from those of velocities.
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

/// Returns fields for the momenta of coordinates.
fn momenta(shape: &Shape<'_>, state: &[Field]) -> Vec<Field> {
    let mut coordinates = shape.coordinates.len();
    let of_coordinates = state.iter().take_while(|field| {
        let is_coordinate = coordinates > 0;
        coordinates = coordinates.saturating_sub(field.names.len());
        is_coordinate
    });
    let momenta = of_coordinates.map(|field| Field {
        identifier: format_ident!("p_{}", field.identifier),
        names: field.names.iter().map(|name| Name::new(momentum_name(&name.text), name.span)).collect(),
        sizes: field.sizes.clone(),
    });
    momenta.collect()
}

/// Returns the unit of a field under its name, or the units of its elements under their names if
/// these differ.
fn units_of<'s>(shape: &'s Shape<'_>, field: &Field) -> Vec<(String, &'s str)> {
    let units = field.names.iter().map(|name| shape.unit(&name.text)).collect::<Vec<_>>();
    match units.split_first() {
        Some((Some(first), others)) if others.iter().all(|unit| *unit == Some(*first)) => {
            vec![(field.identifier.to_string(), first)]
        }
        _ => field.written().into_iter().zip(units).filter_map(|(name, unit)| Some((name, unit?))).collect(),
    }
}
