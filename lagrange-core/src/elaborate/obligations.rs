//! Conditions on masses and moments of inertia, checked as far as the numbers are known.

use super::elaborator::Elaborator;
use super::expression::value_of;
use super::matter;
use super::messages::events;
use super::messages::inertia as words;
use super::operand::Operand;
use crate::model::Bound;
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::{Diagnostic, Origin};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::symbol::Role;
use lagrange_language::bodies::Obligation;
use lagrange_language::syntax::ast::{AstId, Name};

/// Moments of inertia that differ by less than this fraction count as equal.
const ROUNDING: f64 = 1e-9;

/// Reports violated obligations: as errors if numbers are given, as warnings if they are only
/// violated with defaults.
pub(super) fn check_obligations(elaborator: &mut Elaborator, obligations: &[Obligation]) {
    for obligation in obligations {
        match obligation {
            Obligation::PositiveMass { body, mass } => positive_mass(elaborator, body, *mass),
            Obligation::Inertia { body, inertia } => inertia_not_negative(elaborator, body, *inertia),
            Obligation::SameInertia { body, stated, of_shape, shape } => {
                same_inertia(elaborator, body, [*stated, *of_shape], *shape);
            }
            Obligation::Fixed { what, value } => fixed(elaborator, what, *value),
            Obligation::Unmoved { what, value } => matter::unmoved(elaborator, what, *value),
            Obligation::Matter { body, mass, inertia } => matter::changes(elaborator, body, *mass, inertia),
            Obligation::Uniform { gravity } => uniform(elaborator, *gravity),
            Obligation::PlaneVector { what, value } => vector_of(elaborator, what, *value, 2),
            Obligation::SpaceVector { what, value } => vector_of(elaborator, what, *value, 3),
            Obligation::Tensor { body, tensor } => tensor_is_physical(elaborator, body, tensor),
            Obligation::Moves { body, center, angle } => moves(elaborator, body, [*center, *angle]),
            Obligation::Opens { contact, gap } => opens(elaborator, contact, *gap),
            Obligation::InRange { contact, quantity, value, lower } => {
                bounded_below(elaborator, contact, quantity, *value, *lower);
            }
            Obligation::Apart { contact, distance } => {
                let distance = scalar(elaborator, *distance);
                elaborator.distances.extend(distance.map(|distance| (contact.clone(), distance)));
            }
        }
    }
}

fn positive_mass(elaborator: &mut Elaborator, body: &Name, mass: AstId) {
    let Some(wrong) = unless(elaborator, mass, |mass| mass > 0.0) else { return };
    let message = words::mass_not_positive(&body.text, &wrong.text, wrong.is_constant);
    wrong.report(elaborator, message).help(words::HOLES_BELONG_IN_A_COMPOUND);
}

fn inertia_not_negative(elaborator: &mut Elaborator, body: &Name, inertia: AstId) {
    let Some(wrong) = unless(elaborator, inertia, |inertia| inertia >= 0.0) else { return };
    let message = words::inertia_negative(&body.text, &wrong.text, wrong.is_constant);
    wrong.report(elaborator, message).help(words::HOLES_LIE_WITHIN);
}

/// Checks that the mass of a rigid body and its distribution are constant.
fn fixed(elaborator: &mut Elaborator, what: &str, syntax: AstId) {
    let message = words::not_fixed(what);
    free_of(elaborator, syntax, |dependencies| !dependencies.is_constant_in_motion(), &message);
}

/// Checks that gravity is uniform, since only then has the weight m g of a body the potential −m
/// g·c.
fn uniform(elaborator: &mut Elaborator, gravity: AstId) {
    let varies =
        |dependencies: Dependencies| dependencies.intersects(Dependencies::COORDINATE | Dependencies::STATE);
    free_of(elaborator, gravity, varies, words::GRAVITY_NOT_UNIFORM);
}

/// Reports a value with a forbidden dependency.
fn free_of(elaborator: &mut Elaborator, syntax: AstId, is_wrong: fn(Dependencies) -> bool, message: &str) {
    let Some(value) = value_of(&mut elaborator.evaluator, syntax) else { return };
    let graph = &elaborator.evaluator.graph;
    if value.components().iter().any(|&component| is_wrong(graph.dependencies(component))) {
        let origin = elaborator.evaluator.origin(syntax);
        elaborator.evaluator.report.error(origin, message).help(words::FREE_OF_MOTION_HELP);
    }
}

/// A value that violates an obligation.
struct Wrong {
    text: String,
    origin: Origin,
    /// True if the value is wrong for all parameters, and not only with their defaults.
    is_constant: bool,
}

impl Wrong {
    fn report<'a>(&self, elaborator: &'a mut Elaborator, message: String) -> &'a mut Diagnostic {
        let report = &mut *elaborator.evaluator.report;
        match self.is_constant {
            true => report.error(self.origin, message),
            false => report.doubtful(self.origin, message),
        }
    }
}

/// Returns the value of a scalar if it is wrong. The value must be known, at least with the
/// defaults of parameters.
fn unless(elaborator: &mut Elaborator, syntax: AstId, is_right: fn(f64) -> bool) -> Option<Wrong> {
    let value = scalar(elaborator, syntax)?;
    let graph = &elaborator.evaluator.graph;
    let number = Defaults::of(elaborator).evaluate(graph, value).filter(|&number| !is_right(number))?;
    Some(Wrong {
        text: graph.as_number(value).map_or_else(|| number.to_string(), ToString::to_string),
        origin: elaborator.evaluator.origin(syntax),
        is_constant: graph.dependencies(value) == Dependencies::NONE,
    })
}

fn same_inertia(elaborator: &mut Elaborator, body: &Name, inertias: [AstId; 2], shape: Origin) {
    let [Some(stated), Some(of_shape)] = inertias.map(|syntax| scalar(elaborator, syntax)) else { return };
    let origin = elaborator.evaluator.origin(inertias[0]);
    let (graph, defaults) = (&elaborator.evaluator.graph, Defaults::of(elaborator));
    let Some((values, condition)) = difference(graph, &defaults, stated, of_shape) else { return };
    let message = words::other_inertia(&body.text, values[0], values[1], &condition);
    let warning = elaborator.evaluator.report.doubtful(origin, message);
    warning.related(shape, words::SHAPE_IS_HERE).help(words::OTHER_INERTIA_HELP);
}

fn vector_of(elaborator: &mut Elaborator, what: &str, syntax: AstId, dimension: usize) {
    let Some(value) = value_of(&mut elaborator.evaluator, syntax) else { return };
    if !matches!(&value, Operand::Vector(components) if components.len() == dimension) {
        let origin = elaborator.evaluator.origin(syntax);
        let message = words::vector_needed(what, dimension, value.kind());
        elaborator.evaluator.report.error(origin, message).help(words::vector_help(dimension));
    }
}

/// Checks that moments and products of inertia are physical. No principal moment may exceed the sum
/// of the others, which also makes them positive. The second moments ½ (tr J) 1 − J of the mass
/// then have no negative eigenvalue.
fn tensor_is_physical(elaborator: &mut Elaborator, body: &Name, tensor: &[AstId; 6]) {
    let components = tensor.map(|syntax| scalar(elaborator, syntax));
    let (graph, defaults) = (&elaborator.evaluator.graph, Defaults::of(elaborator));
    let mut numbers = [0.0; 6];
    let mut is_constant = true;
    for (number, component) in numbers.iter_mut().zip(components) {
        let Some(component) = component else { return };
        let Some(value) = defaults.evaluate(graph, component).filter(|value| value.is_finite()) else {
            return;
        };
        (*number, is_constant) = (value, is_constant && graph.dependencies(component) == Dependencies::NONE);
    }
    if !is_physical(numbers) {
        let wrong =
            Wrong { text: String::new(), origin: elaborator.evaluator.origin(tensor[0]), is_constant };
        wrong.report(elaborator, words::tensor_impossible(&body.text, is_constant)).help(words::TENSOR_HELP);
    }
}

/// True if a body can have these moments and products of inertia, xx, yy, zz, xy, xz and yz, about
/// its centre of mass.
///
/// The second moments of its mass are then positive semidefinite up to rounding, which is tested by
/// the signs of the principal minors.
pub fn is_physical([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> bool {
    let half = 0.5 * (xx + yy + zz);
    let [a, b, c] = [half - xx, half - yy, half - zz];
    let (size, slack) = (half.abs(), ROUNDING * half.abs());
    let pairs = [a * b - xy * xy, a * c - xz * xz, b * c - yz * yz];
    let volume = a * pairs[2] - xy * (xy * c + yz * xz) - xz * (xy * yz + b * xz);
    half >= 0.0
        && [a, b, c].iter().all(|&moment| moment >= -slack)
        && pairs.iter().all(|&minor| minor >= -slack * size)
        && volume >= -slack * size * size
}

/// Checks that a body is able to move.
fn moves(elaborator: &mut Elaborator, body: &Name, placed: [AstId; 2]) {
    let mut components = Vec::new();
    for syntax in placed {
        let Some(value) = value_of(&mut elaborator.evaluator, syntax) else { return };
        components.extend_from_slice(value.components());
    }
    let graph = &elaborator.evaluator.graph;
    let stands = |&component: &ExprId| graph.dependencies(component).is_constant_in_motion();
    if components.iter().all(stands) {
        let report = &mut *elaborator.evaluator.report;
        report.error(body.span, words::body_stands_still(&body.text)).help(words::BODY_STANDS_STILL_HELP);
    }
}

/// Checks that a gap depends on coordinates, since it has no forces otherwise.
fn opens(elaborator: &mut Elaborator, contact: &Name, syntax: AstId) {
    let Some(gap) = scalar(elaborator, syntax) else { return };
    if !elaborator.evaluator.graph.dependencies(gap).intersects(Dependencies::COORDINATE) {
        let message = events::gap_without_coordinate(&contact.text);
        elaborator.evaluator.report.error(contact.span, message).help(events::GAP_HELP);
    }
}

/// Adds the lower bound of a quantity of a contact that depends on parameters alone. It is checked
/// at the start of runs.
fn bounded_below(
    elaborator: &mut Elaborator,
    contact: &Name,
    quantity: &str,
    value: AstId,
    (bound, is_included): (AstId, bool),
) {
    let [Some(value), Some(bound)] = [value, bound].map(|syntax| scalar(elaborator, syntax)) else { return };
    let range = [Some(Bound { value: bound, is_included }), None];
    elaborator.bound_quantity(contact, quantity, value, range);
}

/// Returns the value of a scalar expression; other shapes have been reported where they are used.
fn scalar(elaborator: &mut Elaborator, syntax: AstId) -> Option<ExprId> {
    match value_of(&mut elaborator.evaluator, syntax)? {
        Operand::Scalar(value) => Some(value),
        Operand::Vector(_) | Operand::Matrix(..) => None,
    }
}

/// Returns both values if they differ by more than rounding, and the condition under which they
/// hold. Formulas in different symbols without defaults are not compared.
fn difference(
    graph: &Graph,
    defaults: &Defaults,
    stated: ExprId,
    of_shape: ExprId,
) -> Option<([f64; 2], String)> {
    if stated == of_shape || ![stated, of_shape].iter().all(|&value| has_formula(graph, value)) {
        return None;
    }
    let both = [stated, of_shape];
    if let [Some(stated), Some(of_shape)] = both.map(|value| defaults.evaluate(graph, value)) {
        let is_constant = both.iter().all(|&value| graph.dependencies(value) == Dependencies::NONE);
        let condition = if is_constant { "" } else { words::WITH_DEFAULTS };
        return differ(stated, of_shape).then(|| ([stated, of_shape], condition.to_owned()));
    }
    let symbols = symbols(graph, stated);
    if symbols != self::symbols(graph, of_shape) {
        return None;
    }
    let values = symbols.into_iter().zip(generic_values()).collect::<Vec<_>>();
    let value_of = |role| {
        let known = values.iter().find(|((_, known), _)| *known == role);
        known.map_or(f64::NAN, |(_, value)| *value)
    };
    let [stated, of_shape] = both.map(|value| evaluate(graph, &[value], value_of)[0]);
    let values = values.iter().map(|((name, _), value)| (name.clone(), *value)).collect::<Vec<_>>();
    let certain = stated.is_finite() && of_shape.is_finite() && differ(stated, of_shape);
    certain.then(|| ([stated, of_shape], words::for_values(&values)))
}

/// Returns generic values: 2, 3, 5, 7, 9, ….
fn generic_values() -> impl Iterator<Item = f64> {
    std::iter::once(2.0).chain((1..).map(|i| f64::from(2 * i + 1)))
}

/// True if two numbers differ by more than rounding; NaN differs from everything.
fn differ(a: f64, b: f64) -> bool {
    let error = (a - b).abs();
    error > ROUNDING * a.abs().max(b.abs()) || error.is_nan()
}

/// True if an expression contains no function whose values are only known at run time.
fn has_formula(graph: &Graph, value: ExprId) -> bool {
    !graph
        .reachable(&[value])
        .into_iter()
        .any(|id| matches!(graph.node(id), Node::Opaque(function, _) if function.table().is_none()))
}

/// Returns the symbols of an expression, in the order of their creation in the graph.
fn symbols(graph: &Graph, value: ExprId) -> Vec<(String, Role)> {
    let symbols = graph.reachable(&[value]).into_iter().filter_map(|id| graph.symbol_of(id));
    symbols.map(|symbol| (symbol.name.clone(), symbol.role)).collect()
}

/// The defaults of parameters.
pub(super) struct Defaults(HashMap<Role, f64>);

impl Defaults {
    pub(super) fn of(elaborator: &Elaborator) -> Defaults {
        let graph = &elaborator.evaluator.graph;
        let values = elaborator.parameters.iter().filter_map(|parameter| {
            let symbol = graph.symbol_of(parameter.symbol)?;
            let value = evaluate(graph, &[parameter.default?], |_| f64::NAN)[0];
            Some((symbol.role, value))
        });
        Defaults(values.collect())
    }

    /// Returns the value with these defaults, if it depends on nothing else.
    pub(super) fn evaluate(&self, graph: &Graph, value: ExprId) -> Option<f64> {
        let is_known =
            has_formula(graph, value) && symbols(graph, value).iter().all(|(_, role)| self.0.contains(role));
        is_known.then(|| evaluate(graph, &[value], |role| self.0.get(&role).copied().unwrap_or(f64::NAN))[0])
    }
}

#[cfg(test)]
mod tests;
