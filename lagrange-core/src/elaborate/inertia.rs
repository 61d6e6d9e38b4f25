//! Function calls of the language: moments of inertia of solids by name, and where their centres of mass are.

use super::expression::Evaluator;
use super::messages::{self, inertia as words};
use super::operand::Operand;
use crate::calculus::evaluate;
use crate::expr::{Dependencies, ExprId};
use crate::number::Number;
use crate::solids::{self, Dimensions, SOLIDS, Solid};
use crate::syntax::ast::{AstId, Name};

/// A function of mass geometry.
#[derive(Clone, Copy)]
pub(super) enum MassFunction {
    /// `solid(m, …)`: the moment of inertia about the centre of mass.
    Inertia(&'static Solid),
    /// `solid_center(…)`: the centre of mass in the solid's own coordinates.
    Center(&'static Solid),
    /// `slender_rod_end(m, l)` = m l²/3, about an end.
    RodEnd,
    /// `steiner(j, m, r)` = j + m r², about an axis at the distance r from the centre of mass.
    Steiner,
}

/// The function of that name.
pub(super) fn by_name(name: &str) -> Option<MassFunction> {
    match name {
        "slender_rod_end" => Some(MassFunction::RodEnd),
        "steiner" => Some(MassFunction::Steiner),
        _ => {
            let inertia = solids::by_name(name).map(MassFunction::Inertia);
            inertia.or_else(|| solids::by_center_function(name).map(MassFunction::Center))
        }
    }
}

/// Names that calls may have meant.
pub(super) fn function_names() -> impl Iterator<Item = &'static str> {
    SOLIDS.iter().map(|solid| solid.name).chain(["slender_rod_end", "steiner"])
}

impl MassFunction {
    /// How it is called.
    fn usage(self) -> String {
        match self {
            MassFunction::Inertia(solid) => solid.inertia_usage(),
            MassFunction::Center(solid) => solid.center_usage(),
            MassFunction::RodEnd => "slender_rod_end(m, l)".to_owned(),
            MassFunction::Steiner => "steiner(j, m, r)".to_owned(),
        }
    }

    /// How many arguments it takes, and whether that is a least number.
    fn arity(self) -> (usize, bool) {
        let of_solid = |solid: &Solid| match solid.dimensions {
            Dimensions::Scalars(names) => (names.len(), false),
            Dimensions::Corners => (solids::FEWEST_CORNERS, true),
        };
        match self {
            MassFunction::Inertia(solid) => {
                let (count, or_more) = of_solid(solid);
                (count + 1, or_more)
            }
            MassFunction::Center(solid) => of_solid(solid),
            MassFunction::RodEnd => (2, false),
            MassFunction::Steiner => (3, false),
        }
    }
}

impl Evaluator<'_> {
    pub(super) fn evaluate_mass_function(
        &mut self,
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
            let error = self.report.error(self.origin(call), message);
            error.help(messages::names::write_call(&function.usage()));
            return None;
        }
        match function {
            MassFunction::Inertia(solid) => {
                let mass = self.scalar_arguments(name, &arguments[..1]);
                let dimensions = self.dimensions(solid, name, &arguments[1..], call)?;
                let of_unit = (solid.inertia)(&mut self.graph, &dimensions);
                Some(Operand::Scalar(self.graph.multiply(mass?[0], of_unit)))
            }
            MassFunction::Center(solid) => {
                let dimensions = self.dimensions(solid, name, arguments, call)?;
                let center = solid.centroid?(&mut self.graph, &dimensions);
                Some(Operand::Vector(center.to_vec()))
            }
            MassFunction::RodEnd | MassFunction::Steiner => {
                let scalars = self.scalar_arguments(name, arguments)?;
                Some(Operand::Scalar(self.about_other_axis(function, &scalars)))
            }
        }
    }

    /// m l²/3 or j + m r²
    fn about_other_axis(&mut self, function: MassFunction, scalars: &[ExprId]) -> ExprId {
        let graph = &mut self.graph;
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

    fn scalar_arguments(&mut self, name: &Name, arguments: &[AstId]) -> Option<Vec<ExprId>> {
        let what = format!("an argument of `{}`", name.text);
        let scalars = arguments.iter().map(|&argument| self.scalar(argument, &what)).collect::<Vec<_>>();
        scalars.into_iter().collect()
    }

    /// The scalars that give the size of a solid. What is wrong with them is reported once, although the moment of inertia and
    /// the centre of mass of a body's shape have the same arguments.
    fn dimensions(
        &mut self,
        solid: &Solid,
        name: &Name,
        arguments: &[AstId],
        call: AstId,
    ) -> Option<Vec<ExprId>> {
        if self.unsuitable.contains(&arguments.to_vec()) {
            return None;
        }
        let dimensions = self.suitable_dimensions(solid, name, arguments, call);
        if dimensions.is_none() {
            self.unsuitable.insert(arguments.to_vec(), ());
        }
        dimensions
    }

    /// Reports sizes that no such solid has.
    fn suitable_dimensions(
        &mut self,
        solid: &Solid,
        name: &Name,
        arguments: &[AstId],
        call: AstId,
    ) -> Option<Vec<ExprId>> {
        let dimensions = match solid.dimensions {
            Dimensions::Scalars(_) => self.scalar_arguments(name, arguments)?,
            Dimensions::Corners => self.corners(name, arguments)?,
        };
        if self.is_impossible(solid, &dimensions) {
            let error = self.report.error(self.origin(call), words::no_such_solid(&solid.shape_usage()));
            error.help(solid.condition);
            return None;
        }
        Some(dimensions)
    }

    /// Whether the numbers among the dimensions are those of no such solid.
    fn is_impossible(&mut self, solid: &Solid, dimensions: &[ExprId]) -> bool {
        if solid.dimensions == Dimensions::Corners {
            let area = solids::double_area(&mut self.graph, dimensions);
            return self.graph.is_zero(area);
        }
        let is_constant = |&id: &ExprId| self.graph.dependencies(id) == Dependencies::NONE;
        let all_constant = dimensions.iter().all(is_constant);
        let values = evaluate(&self.graph, dimensions, |_| f64::NAN);
        (solid.is_impossible)(&values) || all_constant && values.iter().any(|value| !value.is_finite())
    }

    /// The coordinates of corners, one after the other.
    fn corners(&mut self, name: &Name, arguments: &[AstId]) -> Option<Vec<ExprId>> {
        let what = format!("a corner of `{}`", name.text);
        let corners = arguments.iter().map(|&argument| {
            let corner = self.vector(argument, &what)?;
            if corner.len() != 2 {
                let message = words::plane_vector_needed(&what, &Operand::Vector(corner).kind());
                self.report.error(self.origin(argument), message).help(words::PLANE_VECTOR_HELP);
                return None;
            }
            Some(corner)
        });
        let corners = corners.collect::<Vec<_>>();
        corners.into_iter().collect::<Option<Vec<_>>>().map(|corners| corners.concat())
    }
}

#[cfg(test)]
mod tests;
