//! Emission of each product: its arguments and result for a system, from its row.

use super::jacobian::{by_displacements, by_fields, by_state};
use super::linearised::system_matrix;
use crate::derive::Equations;
use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::Shape;
use crate::model::{Extent, Model, Product, ProductArguments, ProductMethod, ProductShape};
use lagrange_expr::expr::ExprId;

/// A method to be lowered.
pub(in crate::emit) struct Plan {
    pub(in crate::emit) docs: &'static [&'static str],
    pub(in crate::emit) arguments: Arguments,
    pub(in crate::emit) returns: Returns,
    pub(in crate::emit) roots: Vec<ExprId>,
}

/// Plans the method of a product; `None` if the product is not a method or does not exist for the
/// system.
pub(in crate::emit) fn plan(
    product: Product,
    model: &mut Model,
    equations: &Equations,
    shape: &Shape<'_>,
) -> Option<Plan> {
    let ProductMethod { docs, .. } = product.row().method.as_ref()?;
    let moving = equations.structure.mass.depends_on_velocities;
    let (arguments, mut returns) = signature(product, shape, moving)?;
    let found = equations.product(product, model)?;
    let roots = match product {
        Product::Jacobian => by_state(model, &found),
        Product::TangentJacobian => by_displacements(model, &found),
        Product::ParameterJacobian => by_fields(model, &found),
        Product::SystemMatrix => system_matrix(model, equations, &found),
        _ => found,
    };
    match (product, &mut returns) {
        // The number of components of an output usually follows from its syntax, but not always,
        // and contacts may share an event.
        (Product::SystemMatrix | Product::EventJacobian, Returns::Matrix(rows, columns)) => {
            *rows = roots.len() / *columns;
        }
        // The derivation finds the columns.
        (Product::Regressor, Returns::Matrix(rows, columns)) => *columns = roots.len() / *rows,
        _ => {}
    }
    Some(Plan { docs, arguments, returns, roots })
}

/// Returns the arguments and the result of a product's method, if it has one. `is_moving` is true
/// if the mass matrix depends on velocities.
pub(in crate::emit) fn signature(
    product: Product,
    shape: &Shape<'_>,
    is_moving: bool,
) -> Option<(Arguments, Returns)> {
    let method = product.row().method.as_ref()?;
    let arguments = match method.arguments {
        ProductArguments::Configuration if is_moving => Arguments::State,
        ProductArguments::Configuration | ProductArguments::Positions => Arguments::Positions,
        ProductArguments::State => Arguments::State,
        ProductArguments::Motion => Arguments::Motion,
        ProductArguments::Whole => Arguments::Whole,
    };
    let tangent = 2 * shape.velocities.len() + shape.states;
    let outputs = shape.outputs.iter().map(|(_, components)| components).sum::<usize>();
    let count = |extent| match extent {
        Extent::Velocities => shape.velocities.len(),
        Extent::State => shape.coordinates.len() + shape.velocities.len(),
        Extent::Tangent => tangent,
        Extent::LinearRows => tangent + outputs + shape.constraints.len(),
        Extent::LinearColumns => tangent + shape.inputs.len(),
        Extent::Constraints => shape.constraints.len(),
        Extent::Fields => shape.fields.len(),
        // At most ten for each body, and one for each parameter.
        Extent::Regressed => 0,
        Extent::Axes if shape.declaration.is_in_space => 3,
        Extent::Axes => 2,
        Extent::Motions if shape.declaration.is_in_space => 6,
        Extent::Motions => 3,
        Extent::Events => shape.events.len(),
        Extent::StateAndTime => shape.coordinates.len() + shape.velocities.len() + 1,
    };
    let returns = match method.returns {
        ProductShape::Scalar => Returns::Scalar,
        ProductShape::Vector(entries) => Returns::Vector(count(entries)),
        ProductShape::Matrix(rows, columns) => Returns::Matrix(count(rows), count(columns)),
    };
    Some((arguments, returns))
}
