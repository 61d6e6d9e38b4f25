//! Names that statements define: parameters, inputs, constants, abbreviations.

use super::carried::record_name;
use super::elaborator::Elaborator;
use super::expression::value_of;
use super::messages;
use super::operand::Operand;
use super::ranges::range_of;
use super::scalar_range::{Misfit, largest, misfit, misfit_of_value};
use super::scope::NameKind;
use crate::model::Parameter;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Definition, Expression, Name};

/// Names of the components of vectors in the plane and in space.
const AXES: [&str; 3] = ["x", "y", "z"];

pub(super) fn define_parameter(elaborator: &mut Elaborator<'_>, definition: &Definition, kind: NameKind) {
    let default = definition.value.and_then(|value| default_value(elaborator, &definition.name, value));
    let name = &definition.name.text;
    let is_input = kind == NameKind::Input;
    let index = if is_input { elaborator.inputs.len() } else { elaborator.parameters.len() } as u32;
    let role = if is_input { Role::Input(index) } else { Role::Parameter(index) };
    let range = range_of(elaborator, definition, default);
    let symbol = elaborator.evaluator.graph.symbol(name, role);
    let default = match default {
        None if is_input => Some(elaborator.evaluator.graph.number(0)),
        given => given,
    };
    let list = if is_input { &mut elaborator.inputs } else { &mut elaborator.parameters };
    list.push(Parameter { name: name.clone(), symbol, default, range });
    elaborator.declare(&definition.name, kind, Some(Operand::Scalar(symbol)));
}

fn default_value(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) -> Option<ExprId> {
    let value = elaborator.constant_scalar(syntax, "a default")?;
    let (graph, scalar) = (&elaborator.evaluator.graph, &elaborator.declaration.scalar);
    let misfit = match graph.as_number(value) {
        Some(number) => misfit(scalar, number),
        None => misfit_of_value(scalar, evaluate(graph, &[value], |_| f64::NAN)[0]),
    };
    if let Some(misfit) = misfit {
        let (scalar, largest) = largest(scalar);
        let (message, help) = match misfit {
            Misfit::TooLarge => {
                (messages::number_too_large(&name.text, scalar), messages::largest_help(scalar, largest))
            }
            Misfit::TooSmall => {
                (messages::number_too_small(&name.text, scalar), messages::VANISHING_HELP.to_owned())
            }
        };
        elaborator.evaluator.refuse::<()>(syntax, message, help);
    }
    Some(value)
}

pub(super) fn define_constant(elaborator: &mut Elaborator<'_>, definition: &Definition) {
    let value = definition.value.and_then(|value| elaborator.constant_scalar(value, "a constant"));
    elaborator.declare(&definition.name, NameKind::Constant, value.map(Operand::Scalar));
}

pub(super) fn define_abbreviation(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) {
    let value = value_of(&mut elaborator.evaluator, syntax)
        .filter(|value| is_sound_place(elaborator, name, syntax, value));
    record_name(&mut elaborator.evaluator, &name.text, syntax);
    declare_abbreviation(elaborator, name, value);
}

/// Declares a name for a value, and labels its components with it.
fn declare_abbreviation(elaborator: &mut Elaborator<'_>, name: &Name, value: Option<Operand>) {
    match &value {
        Some(Operand::Scalar(id)) => elaborator.labels.push((*id, name.text.clone())),
        Some(Operand::Vector(components)) if components.len() <= AXES.len() => {
            for (id, axis) in components.iter().zip(AXES) {
                elaborator.labels.push((*id, format!("{}_{axis}", name.text)));
            }
        }
        Some(whole) => {
            for (number, id) in whole.components().iter().enumerate() {
                elaborator.labels.push((*id, format!("{}_{number}", name.text)));
            }
        }
        None => {}
    }
    elaborator.declare(name, NameKind::Abbreviation, value);
}

/// True if a name is not that of a place, or the place depends only on coordinates and time.
fn is_sound_place(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId, value: &Operand) -> bool {
    let Some((_, what)) = elaborator.places.iter().find(|(place, _)| *place == name.text) else {
        return true;
    };
    let moving = Dependencies::VELOCITY
        | Dependencies::ACCELERATION
        | Dependencies::MULTIPLIER
        | Dependencies::REACTION;
    let depends = |&id: &ExprId| elaborator.evaluator.graph.dependencies(id).intersects(moving);
    if !value.components().iter().any(depends) {
        return true;
    }
    let (place, _) = elaborator.evaluator.blame(syntax, moving);
    elaborator.evaluator.report.error(place, messages::no_place(what)).help(messages::PLACE_HELP);
    false
}

/// Defines the components of a vector. Components that are written out may have different shapes.
pub(super) fn define_abbreviations(elaborator: &mut Elaborator<'_>, names: &[Name], syntax: AstId) {
    if let Expression::Tuple(parts) = elaborator.evaluator.declaration.expressions.get(syntax)
        && parts.len() == names.len()
    {
        // The names are not yet defined in the parts.
        for part in parts {
            value_of(&mut elaborator.evaluator, *part);
        }
        let parts = parts.clone();
        return names.iter().zip(parts).for_each(|(name, part)| define_abbreviation(elaborator, name, part));
    }
    let whole = value_of(&mut elaborator.evaluator, syntax);
    let is_sound = whole.as_ref().is_some_and(|whole| whole.len() == names.len());
    if let Some(other) = whole.as_ref().filter(|_| !is_sound) {
        let message = messages::tuple_size(names.len(), other.kind());
        elaborator.evaluator.refuse::<()>(syntax, message, messages::TUPLE_SIZE_HELP.to_owned());
    }
    for (i, name) in names.iter().enumerate() {
        let component = whole.as_ref().filter(|_| is_sound).and_then(|whole| whole.entry(&[i]));
        record_name(&mut elaborator.evaluator, &name.text, syntax);
        declare_abbreviation(elaborator, name, component);
    }
}
