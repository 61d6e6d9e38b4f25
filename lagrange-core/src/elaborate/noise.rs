//! White noise: its declaration, the places where it may act, and its factors in forces and rates.

use super::elaborator::{DeclaredNoise, Elaborator};
use super::messages::noise as words;
use super::operand::Operand;
use super::scope::NameKind;
use crate::model::Noise;
use lagrange_algebra::calculus::{gradient, substitute_all};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::limits::MAX_NOISES;
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Definition, Name, StatementKind};

/// Defines a noise, `noise w, density: e;`.
pub(super) fn define_noise(elaborator: &mut Elaborator<'_>, definition: &Definition) {
    let Definition { name, value, .. } = definition;
    let density = value.and_then(|syntax| density(elaborator, syntax));
    let index = elaborator.noises.len();
    if index == MAX_NOISES {
        let error = elaborator.evaluator.report.error(name.span, words::too_many(MAX_NOISES));
        error.help(words::TOO_MANY_HELP);
    }
    let symbol = elaborator.evaluator.graph.symbol(&name.text, Role::Noise(index as u32));
    let density = density.unwrap_or_else(|| elaborator.evaluator.graph.number(0));
    elaborator.noises.push(DeclaredNoise { name: name.clone(), symbol, density });
    elaborator.declare(name, NameKind::Noise, Some(Operand::Scalar(symbol)));
}

/// Evaluates a spectral density, which must not be a negative number.
fn density(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<ExprId> {
    let value = elaborator.known_scalar(syntax, words::DENSITY, words::DENSITY_HELP)?;
    if elaborator.numeric(value).is_some_and(|number| !(0.0..).contains(&number)) {
        elaborator.evaluator.refuse::<()>(syntax, words::NEGATIVE.to_owned(), words::DENSITY_HELP.to_owned());
    }
    Some(value)
}

/// Reports misplaced noise, and systems that do not support noise.
pub(super) fn check_noise(elaborator: &mut Elaborator<'_>) {
    let Some(first) = elaborator.noises.first().map(|noise| noise.name.clone()) else { return };
    let declaration = elaborator.declaration;
    for statement in &declaration.statements {
        let acting = acting(&statement.kind);
        let is_name = matches!(statement.kind, StatementKind::Let(..) | StatementKind::LetTuple(..));
        for syntax in statement.kind.expressions() {
            match acting {
                _ if is_name => {}
                Some(acting) if acting == syntax => check_linear(elaborator, syntax),
                _ => forbid_noise(elaborator, syntax),
            }
        }
    }
    check_system(elaborator, &first);
}

/// Returns the expression of a statement in which noise may act.
fn acting(kind: &StatementKind) -> Option<AstId> {
    match *kind {
        StatementKind::ForceOn(_, force)
        | StatementKind::ForceAt { force, .. }
        | StatementKind::ForceAlong { force, .. } => Some(force),
        StatementKind::Torque { moment, .. } => Some(moment),
        StatementKind::StateRate(_, rate) | StatementKind::RateEquation(rate) => Some(rate),
        _ => None,
    }
}

fn components(elaborator: &Elaborator<'_>, syntax: AstId) -> Vec<ExprId> {
    elaborator.evaluator.value(syntax).map_or_else(Vec::new, |value| value.components().to_vec())
}

/// Reports a force or a rate in which noise is the argument of a function or of a condition, or has
/// a factor with noise.
fn check_linear(elaborator: &mut Elaborator<'_>, syntax: AstId) {
    let symbols = symbols(elaborator);
    let components = components(elaborator, syntax);
    let graph = &mut elaborator.evaluator.graph;
    let has_function = graph.reachable(&components).into_iter().any(|id| is_function_of_noise(graph, id));
    for component in components {
        let graph = &mut elaborator.evaluator.graph;
        let slopes = gradient(graph, component, &symbols);
        let depends = |&slope: &ExprId| graph.dependencies(slope).intersects(Dependencies::NOISE);
        if has_function || slopes.iter().any(depends) {
            let (place, _) = elaborator.evaluator.blame(syntax, Dependencies::NOISE);
            let error = elaborator.evaluator.report.error(place, words::NONLINEAR);
            error.help(words::NONLINEAR_HELP);
            return;
        }
    }
}

/// True for a function or a condition of an argument that depends on noise. The slope of the
/// function may be independent of noise: the slope of a sign is zero.
fn is_function_of_noise(graph: &Graph, id: ExprId) -> bool {
    let depends = |&id: &ExprId| graph.dependencies(id).intersects(Dependencies::NOISE);
    match graph.node(id) {
        Node::Call(_, arguments) | Node::Opaque(_, arguments) => arguments.iter().any(depends),
        Node::Choose { left, right, .. } => depends(left) || depends(right),
        Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Sum { .. } | Node::Product(_) => false,
    }
}

fn forbid_noise(elaborator: &mut Elaborator<'_>, syntax: AstId) {
    let depends = |&id: &ExprId| elaborator.evaluator.graph.dependencies(id).intersects(Dependencies::NOISE);
    if components(elaborator, syntax).iter().any(depends) {
        let (place, name) = elaborator.evaluator.blame(syntax, Dependencies::NOISE);
        let report = &mut elaborator.evaluator.report;
        // A reported rate of the noise is the actual error.
        if report.diagnostics().iter().all(|reported| reported.origin.start.start() != place.start.start()) {
            report.error(place, words::misplaced(&name)).help(words::MISPLACED_HELP);
        }
    }
}

/// Reports constraints, contacts, friction and reductions in systems with noise.
fn check_system(elaborator: &mut Elaborator<'_>, first: &Name) {
    let constraint = elaborator.constraints.first().map(|(constraint, span)| (&constraint.name, *span));
    let reaction = elaborator.reactions.first().map(|(reaction, span)| (&reaction.name, *span));
    let reduction =
        elaborator.reductions.first().map(|reduction| (&reduction.name.text, reduction.name.span));
    let refused = [
        (constraint, words::CONSTRAINED_HELP),
        (reaction, words::TOUCHING_HELP),
        (reduction, words::REDUCED_HELP),
    ];
    for (name, span, help) in
        refused.into_iter().filter_map(|(at, help)| at.map(|(name, span)| (name, span, help)))
    {
        let error = elaborator.evaluator.report.error(span, words::beside_noise(name));
        error.related(Origin::from(first.span), words::DECLARED_HERE).help(help);
    }
}

fn symbols(elaborator: &Elaborator<'_>) -> Vec<ExprId> {
    elaborator.noises.iter().map(|noise| noise.symbol).collect()
}

/// Removes the noises from forces and rates, and returns them with their factors.
pub(super) fn separate_noises(elaborator: &mut Elaborator<'_>) -> Vec<Noise> {
    let symbols = symbols(elaborator);
    if symbols.is_empty() {
        return Vec::new();
    }
    let rates = elaborator.states.iter().map(|state| state.position).collect::<Vec<_>>();
    let graph = &mut elaborator.evaluator.graph;
    let rates = rates.into_iter().map(|position| (position, graph.rate_of_position(position)));
    let rates = rates.filter_map(|(position, rate)| Some((position, rate?))).collect::<Vec<_>>();
    let noises = elaborator.noises.iter().map(|DeclaredNoise { name, symbol, density }| {
        let loads =
            elaborator.loads.iter().map(|load| (load.velocity, gradient(graph, load.force, &[*symbol])[0]));
        let loads = loads.collect::<Vec<_>>();
        let rates = rates.iter().map(|&(position, rate)| (position, gradient(graph, rate, &[*symbol])[0]));
        Noise { name: name.text.clone(), density: *density, loads, rates: rates.collect() }
    });
    let noises = noises.collect();
    let zero = graph.number(0);
    let silent = symbols.into_iter().map(|symbol| (symbol, zero)).collect();
    for load in &mut elaborator.loads {
        load.force = substitute_all(graph, &[load.force], &silent)[0];
    }
    for (position, rate) in rates {
        let rate = substitute_all(graph, &[rate], &silent)[0];
        graph.set_rate(position, rate);
    }
    noises
}
