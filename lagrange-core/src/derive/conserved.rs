//! Conserved quantities as outputs: the momenta of symmetries, and the energy.

use super::displacements::Displacement;
use super::energy_function::energy_function;
use super::structure::{Conserved, Structure};
use super::symmetries::{Symmetry, symmetries};
use crate::model::{Model, Output, Product};
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::number::Number;
use lagrange_expr::units::momentum_name;

/// Adds an output for each conserved quantity if the model requests them.
pub(super) fn add_conserved(model: &mut Model, structure: &Structure) {
    if !model.products.contains(&Product::Conserved) {
        return;
    }
    if structure.conserved.contains(&Conserved::Energy) {
        let energy = energy_function(model);
        add(model, "conserved_energy".to_owned(), energy, "Conserved energy v·∂L/∂v − L".to_owned());
    }
    for symmetry in symmetries(model) {
        let (name, description) = (name(model, &symmetry), description(model, &symmetry));
        if let [(Displacement::Translation(position), _)] = symmetry.terms[..] {
            let unit = model.units.get(&momentum_name(&model.coordinates[position].name)).cloned();
            unit.into_iter().for_each(|unit| model.units.insert(&name, unit));
        }
        add(model, name, symmetry.momentum, description);
    }
}

/// Adds a derived output under a unique name.
pub(super) fn add(model: &mut Model, name: String, value: ExprId, description: String) {
    let is_taken = |name: &str| model.outputs.iter().any(|output| output.name == name);
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    let name = std::iter::once(name.clone()).chain(numbered).find(|name| !is_taken(name)).unwrap_or(name);
    let dependencies = model.graph.dependencies(value);
    model.outputs.push(Output {
        name,
        components: vec![value],
        uses_accelerations: dependencies.intersects(Dependencies::ACCELERATION),
        uses_multipliers: dependencies.intersects(Dependencies::MULTIPLIER),
        uses_reactions: dependencies.intersects(Dependencies::REACTION),
        description: Some(description),
    });
}

/// Maximum number of coordinates in a name.
const MAX_NAMED: usize = 3;

fn name(model: &Model, symmetry: &Symmetry) -> String {
    let coordinate = |(of, _): &(Displacement, Number)| match *of {
        Displacement::Translation(position) => Some(model.coordinates[position].name.to_lowercase()),
        Displacement::Rotation(..) | Displacement::Turn(..) | Displacement::Spin(..) => None,
    };
    match symmetry.terms.iter().map(coordinate).collect::<Option<Vec<_>>>() {
        Some(names) if names.len() <= MAX_NAMED => format!("conserved_{}", names.join("_")),
        Some(_) => "conserved_momentum".to_owned(),
        None => "conserved_angular_momentum".to_owned(),
    }
}

/// Describes the momentum as the sum of the momenta of its displacements.
fn description(model: &Model, symmetry: &Symmetry) -> String {
    let terms = symmetry.terms.iter().map(|(displacement, coefficient)| {
        let displacement = words(model, *displacement);
        if coefficient.is_one() { displacement } else { format!("{coefficient} × {displacement}") }
    });
    format!("Conserved momentum along {}", terms.collect::<Vec<_>>().join(" + "))
}

fn words(model: &Model, displacement: Displacement) -> String {
    let name = |position: usize| &model.coordinates[position].name;
    let body = |orientation: usize| {
        let scalar = name(model.orientations[orientation].position);
        scalar.strip_suffix("_qw").unwrap_or(scalar)
    };
    let axis = |axis: usize| ["x", "y", "z"][axis];
    match displacement {
        Displacement::Translation(position) => format!("`{}`", name(position)),
        Displacement::Rotation(from, to) => format!("the rotation (`{}`, `{}`)", name(from), name(to)),
        Displacement::Turn(of, about) => format!("the rotation of `{}` about {}", body(of), axis(about)),
        Displacement::Spin(of, about) => {
            format!("the rotation of `{}` about its own {}", body(of), axis(about))
        }
    }
}
