//! Units by name, for axes and files.

use proc_macro2::TokenStream;
use quote::quote;

use super::orientations::written_velocity;
use crate::emit::base::fields::{Field, split_indices};
use crate::emit::base::shape::{Shape, doc};
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
    let column = |name: &Name| (shape.written(name).to_owned(), name.text.clone());
    let positions = shape.coordinates.iter().map(|name| column(name));
    let velocities = shape.velocities.iter();
    let velocities =
        velocities.map(|velocity| (written_velocity(shape, velocity), velocity.name.text.clone()));
    let accelerations = velocities.clone().map(|(written, name)| {
        let (stem, indices) = split_indices(&written);
        (format!("{}{indices}", acceleration_name(stem)), acceleration_name(&name))
    });
    let momenta = positions.clone().filter(|_| has_momenta);
    let momenta = momenta.map(|(written, name)| (format!("p_{written}"), momentum_name(&name)));
    let parameters = shape.fields.iter().map(|name| column(name));
    let columns = positions.chain(velocities).chain(accelerations).chain(parameters);
    let known = by_array(shape, columns).into_iter().chain(outputs);
    known.chain(by_array(shape, momenta)).collect()
}

/// Returns the known units of columns, given with the names of their quantities. Consecutive
/// elements of an array with the same unit have one entry.
fn by_array<'s>(
    shape: &'s Shape<'_>,
    columns: impl Iterator<Item = (String, String)>,
) -> Vec<(String, &'s str)> {
    let columns = columns.map(|(written, name)| (written, shape.unit(&name))).collect::<Vec<_>>();
    let array = |(written, _): &(String, _)| split_indices(written).0.to_owned();
    let arrays = columns.chunk_by(|before, after| array(before) == array(after));
    let entries = arrays.flat_map(|elements| match elements {
        [(_, unit), others @ ..] if others.iter().all(|(_, other)| other == unit) => {
            vec![(array(&elements[0]), *unit)]
        }
        _ => elements.to_vec(),
    });
    entries.filter_map(|(name, unit)| Some((name, unit?))).collect()
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
