//! Units of the results of emitted methods, in documentation.

use proc_macro2::TokenStream;
use quote::quote;

use super::docs::with_counts;
use super::method::Returns;
use super::shape::{Shape, doc};
use crate::model::{Product, ProductShape, ProductUnit};
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::number::Number;
use lagrange_expr::units::{Dimension, spelled};
use lagrange_language::syntax::ast::acceleration_name;
use lagrange_language::syntax::parse_unit;

/// The unit of rates.
const RATES: &str = "Each is in the unit of its entry of the state over s.";

impl Shape<'_> {
    /// Returns the documentation of a method: lines, the unit of its result, and its cost.
    pub(in crate::emit) fn method_docs(
        &self,
        (name, returns): (&str, Returns),
        lines: &TokenStream,
        counts: OperationCounts,
    ) -> TokenStream {
        let unit = Product::unit_of_method(name).filter(|_| self.declaration.has_dimensions);
        let unit = unit.and_then(|unit| self.unit_of_entries(unit, returns));
        let unit = unit.map(|line| paragraph(&line));
        with_counts(quote!(#lines #unit), counts)
    }

    /// Returns the documentation of rates of the state or of its positions: a line and their units.
    pub(in crate::emit) fn rates_docs(&self, line: &str) -> TokenStream {
        let (line, unit) = (doc(line), self.declaration.has_dimensions.then(|| paragraph(RATES)));
        quote!(#line #unit)
    }

    /// Describes the unit of the entries of a result; `None` if that of a velocity is unknown.
    fn unit_of_entries(&self, unit: ProductUnit, returns: Returns) -> Option<String> {
        let (unit, exponent) = match unit {
            ProductUnit::Quotient | ProductUnit::Described(_) | ProductUnit::Same(_) => {
                return Some(unit.sentence(ProductShape::Scalar));
            }
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

/// Returns a line of documentation after a blank one.
fn paragraph(line: &str) -> TokenStream {
    let (blank, line) = (doc(""), doc(line));
    quote!(#blank #line)
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
