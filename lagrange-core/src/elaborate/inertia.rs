//! Function calls of the language: moments of inertia and centres of mass of solids by name.

use super::evaluator::Evaluator;
use super::function_names::MassFunction;
use super::messages::{self, inertia as words};
use super::operand::Operand;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::number::Number;
use lagrange_expr::solids::{self, Dimensions, Solid};
use lagrange_language::syntax::ast::{AstId, Name};

pub(super) fn evaluate_mass_function(
    evaluator: &mut Evaluator<'_>,
    function: MassFunction,
    name: &Name,
    arguments: &[AstId],
    call: AstId,
) -> Option<Operand> {
    let (count, or_more) = function.arity();
    if arguments.len() < count || arguments.len() > count && !or_more {
        let message = match or_more {
            true => words::too_few_arguments(&name.text, count, arguments.len()),
            false => messages::names::wrong_argument_count(&name.text, count, arguments.len()),
        };
        return evaluator.refuse(call, message, messages::names::write_call(function.usage()));
    }
    match function {
        MassFunction::Inertia(solid) => {
            let mass = scalar_arguments(evaluator, name, &arguments[..1]);
            let dimensions = solid_dimensions(evaluator, solid, name, &arguments[1..], call)?;
            let of_unit = (solid.inertia)(&mut evaluator.graph, &dimensions);
            Some(Operand::Scalar(evaluator.graph.multiply(mass?[0], of_unit)))
        }
        MassFunction::Center(solid) => {
            let dimensions = solid_dimensions(evaluator, solid, name, arguments, call)?;
            let center = solid.centroid?(&mut evaluator.graph, &dimensions);
            Some(Operand::Vector(center.to_vec()))
        }
        MassFunction::RodEnd | MassFunction::Steiner => {
            let scalars = scalar_arguments(evaluator, name, arguments)?;
            Some(Operand::Scalar(about_other_axis(evaluator, function, &scalars)))
        }
    }
}

/// Returns m l²/3 or j + m r².
fn about_other_axis(evaluator: &mut Evaluator<'_>, function: MassFunction, scalars: &[ExprId]) -> ExprId {
    let graph = &mut evaluator.graph;
    let mut moment = |mass: ExprId, distance: ExprId| {
        let square = graph.square(distance);
        graph.multiply(mass, square)
    };
    match (function, scalars) {
        (MassFunction::Steiner, &[about_center, mass, distance]) => {
            let moment = moment(mass, distance);
            graph.add(about_center, moment)
        }
        (_, scalars) => {
            let (moment, three) = (moment(scalars[0], scalars[1]), Number::from(3));
            let three = graph.number(three);
            graph.divide(moment, three)
        }
    }
}

fn scalar_arguments(evaluator: &mut Evaluator<'_>, name: &Name, arguments: &[AstId]) -> Option<Vec<ExprId>> {
    let what = format!("an argument of `{}`", name.text);
    let scalars = arguments.iter().map(|&argument| evaluator.scalar(argument, &what)).collect::<Vec<_>>();
    scalars.into_iter().collect()
}

/// Returns the scalars that give the size of a solid. Errors in these are reported once, although
/// the moment of inertia and the centre of mass of a body's shape have the same arguments.
fn solid_dimensions(
    evaluator: &mut Evaluator<'_>,
    solid: &Solid,
    name: &Name,
    arguments: &[AstId],
    call: AstId,
) -> Option<Vec<ExprId>> {
    if evaluator.unsuitable.contains(&arguments.to_vec()) {
        return None;
    }
    let dimensions = suitable_dimensions(evaluator, solid, name, arguments, call);
    if dimensions.is_none() {
        evaluator.unsuitable.insert(arguments.to_vec());
    }
    dimensions
}

/// Reports impossible sizes of a solid.
fn suitable_dimensions(
    evaluator: &mut Evaluator<'_>,
    solid: &Solid,
    name: &Name,
    arguments: &[AstId],
    call: AstId,
) -> Option<Vec<ExprId>> {
    let dimensions = match solid.dimensions {
        Dimensions::Scalars(_) => scalar_arguments(evaluator, name, arguments)?,
        Dimensions::Corners => corner_coordinates(evaluator, name, arguments)?,
    };
    if is_impossible(evaluator, solid, &dimensions) {
        return evaluator.refuse(call, words::no_such_solid(solid.shape_usage()), solid.condition);
    }
    Some(dimensions)
}

/// True if the numeric dimensions are impossible for such a solid.
fn is_impossible(evaluator: &mut Evaluator<'_>, solid: &Solid, dimensions: &[ExprId]) -> bool {
    if solid.dimensions == Dimensions::Corners {
        let area = solids::double_area(&mut evaluator.graph, dimensions);
        return evaluator.graph.is_zero(area);
    }
    let is_constant = |&id: &ExprId| evaluator.graph.dependencies(id) == Dependencies::NONE;
    let all_constant = dimensions.iter().all(is_constant);
    let values = evaluate(&evaluator.graph, dimensions, |_| f64::NAN);
    (solid.is_impossible)(&values) || all_constant && values.iter().any(|value| !value.is_finite())
}

/// Returns the coordinates of corners, one after the other.
fn corner_coordinates(
    evaluator: &mut Evaluator<'_>,
    name: &Name,
    arguments: &[AstId],
) -> Option<Vec<ExprId>> {
    let what = format!("a corner of `{}`", name.text);
    let corners = arguments.iter().map(|&argument| {
        let corner = evaluator.vector(argument, &what)?;
        if corner.len() != 2 {
            let message = words::vector_needed(&what, 2, Operand::Vector(corner).kind());
            return evaluator.refuse(argument, message, words::PLANE_VECTOR_HELP);
        }
        Some(corner)
    });
    let corners = corners.collect::<Vec<_>>();
    corners.into_iter().collect::<Option<Vec<_>>>().map(|corners| corners.concat())
}

#[cfg(test)]
mod tests;
