//! Units of the results of emitted methods, in documentation.

use proc_macro2::TokenStream;
use quote::quote;

use super::docs::with_counts;
use super::method::Returns;
use super::shape::{Shape, doc};
use crate::model::{Product, ProductUnit};
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::number::Number;
use lagrange_expr::units::{Dimension, spelled};
use lagrange_language::syntax::ast::acceleration_name;
use lagrange_language::syntax::parse_unit;

/// The unit of derivatives.
const QUOTIENT: &str = "Each entry has the unit of its row over that of its column.";

impl Shape<'_> {
    /// Returns the documentation of a method: lines, the unit of its result, and its cost.
    pub(in crate::emit) fn method_docs(
        &self,
        (name, returns): (&str, Returns),
        lines: &TokenStream,
        counts: OperationCounts,
    ) -> TokenStream {
        let unit = Product::unit_of_method(name).filter(|_| self.declaration.has_dimensions);
        let unit = unit.and_then(|unit| self.unit_of_entries(unit, returns)).map(|line| {
            let (blank, line) = (doc(""), doc(&line));
            quote!(#blank #line)
        });
        with_counts(quote!(#lines #unit), counts)
    }

    /// Describes the unit of the entries of a result; `None` if that of a velocity is unknown.
    fn unit_of_entries(&self, unit: ProductUnit, returns: Returns) -> Option<String> {
        let (unit, exponent) = match unit {
            ProductUnit::Quotient => return Some(QUOTIENT.to_owned()),
            ProductUnit::Described(units) => return Some(units.to_owned()),
            ProductUnit::Same(unit) => return Some(format!("In {unit}.")),
            ProductUnit::Over(unit) => (unit, -1),
            ProductUnit::Times(unit) => (unit, 1),
            ProductUnit::Acceleration => return self.unit_of_accelerations(),
        };
        let unit = parse_unit(unit)?.dimension;
        let of = |velocities: &[&Dimension]| {
            let power = |velocity: &&Dimension| velocity.power(&Number::from(exponent));
            moment(&velocities.iter().map(power).fold(unit.clone(), |unit, power| unit.times(&power)))
        };
        let velocities = self.units_of_velocities()?;
        let mut all = Vec::new();
        for (index, (name, dimension)) in velocities.iter().enumerate() {
            if !matches!(returns, Returns::Matrix(..)) {
                all.push((of(&[dimension]), (*name).to_owned()));
                continue;
            }
            all.push((of(&[dimension, dimension]), (*name).to_owned()));
            let others = velocities[index + 1..].iter();
            all.extend(
                others.map(|(other, second)| (of(&[dimension, second]), format!("{name} and {other}"))),
            );
        }
        listed(&all)
    }

    fn unit_of_accelerations(&self) -> Option<String> {
        let mut all: Vec<(String, String)> = Vec::new();
        for velocity in &self.velocities {
            let name = &velocity.name.text;
            let units = (self.unit(&acceleration_name(name))?.to_owned(), self.unit(name)?.to_owned());
            if !all.contains(&units) {
                all.push(units);
            }
        }
        listed(&all)
    }

    /// Returns the different units of velocities, if all are known.
    fn units_of_velocities(&self) -> Option<Vec<(&str, Dimension)>> {
        let mut units: Vec<(&str, Dimension)> = Vec::new();
        for velocity in &self.velocities {
            let unit = self.unit(&velocity.name.text)?;
            let dimension = parse_unit(unit)?.dimension;
            if units.iter().all(|(_, known)| *known != dimension) {
                units.push((unit, dimension));
            }
        }
        Some(units)
    }
}

/// Describes units, each with the units of velocities to which it belongs.
fn listed(all: &[(String, String)]) -> Option<String> {
    let (first, _) = all.first()?;
    if all.iter().all(|(unit, _)| unit == first) {
        return Some(format!("In {first}."));
    }
    let all = all.iter().map(|(unit, velocities)| format!("{unit} for {velocities}")).collect::<Vec<_>>();
    Some(format!("Units by those of the velocities: {}.", all.join(", ")))
}

/// Spells the unit of an entry; that of moments is not J.
fn moment(dimension: &Dimension) -> String {
    match spelled(dimension) {
        unit if unit == "J" => "N*m".to_owned(),
        unit => unit,
    }
}
