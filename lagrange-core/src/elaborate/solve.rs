//! Algebraic unknowns: values that equations define.
//!
//! While their equations are read, the unknowns are symbols. The largest parts of the equations
//! without an unknown become arguments of the solving functions. They are then computed once
//! instead of in every iteration.

use super::elaborator::Elaborator;
use super::evaluator::Evaluator;
use super::expression::value_of;
use super::messages::{self, solve as words};
use super::operand::Operand;
use super::scope::NameKind;
use super::tables::names_of_functions;
use lagrange_algebra::calculus::{jacobian_determinant, partial, rebuild};
use lagrange_algebra::simplify::{has_one_sign, proves_zero};
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{AlgebraicUnknowns, Dependencies, ExprId, Graph, Node};
use lagrange_expr::limits::MAX_ITERATIONS;
use lagrange_expr::number::Number;
use lagrange_expr::opaque::{Opaque, OpaqueFunction, Source};
use lagrange_language::syntax::ast::{AstId, Name, StatementKind, UnknownDefinition};

/// Default number of iterations.
const ITERATIONS: u32 = 30;

/// Maximum number of products in an expanded proof of dependence.
const LARGEST_PROOF: usize = 500;

/// Defines `solve y: 0 = e, start: s, iterations: n;`, or several equations in the same number of
/// unknowns.
pub(super) fn define_unknowns(elaborator: &mut Elaborator<'_>, definition: &UnknownDefinition) {
    let names = &definition.names;
    let mut symbols = Vec::new();
    for name in names {
        let symbol = elaborator.evaluator.graph.operand(&name.text);
        elaborator.declare(name, NameKind::Unknown, Some(Operand::Scalar(symbol)));
        symbols.push(symbol);
    }
    let scope = &elaborator.evaluator.scope;
    if names.iter().any(|name| scope.find(&name.text).is_some_and(|entry| entry.is_ambiguous)) {
        return;
    }
    let equations = StatedEquations::read(&mut elaborator.evaluator, definition, &symbols);
    let values = equations.map(|equations| solution(elaborator, names, &symbols, &equations));
    elaborator.evaluator.scope.couple(names);
    for (i, name) in names.iter().enumerate() {
        let value = values.as_ref().map(|values| values[i]);
        elaborator.labels.extend(value.map(|value| (value, name.text.clone())));
        elaborator.evaluator.scope.define(&name.text, value.map(Operand::Scalar));
    }
}

/// The checked parts of a statement that defines unknowns.
struct StatedEquations {
    residuals: Vec<ExprId>,
    starts: Vec<ExprId>,
    iterations: u32,
}

impl StatedEquations {
    /// Checks the whole statement; `None` after an error, which is reported.
    fn read(
        evaluator: &mut Evaluator<'_>,
        definition: &UnknownDefinition,
        symbols: &[ExprId],
    ) -> Option<StatedEquations> {
        let names = &definition.names;
        let residuals =
            definition.residuals.iter().map(|&syntax| residual(evaluator, names, syntax, symbols));
        let residuals = residuals.collect::<Vec<_>>().into_iter().collect::<Option<Vec<_>>>();
        let starts = match &definition.starts[..] {
            [] => Some(vec![evaluator.graph.number(0); names.len()]),
            starts => {
                let starts = names.iter().zip(starts);
                let starts = starts.map(|(name, &start)| starting_value(evaluator, &name.text, start));
                starts.collect::<Vec<_>>().into_iter().collect()
            }
        };
        let iterations = definition.iterations.map_or(Some(ITERATIONS), |count| iterations(evaluator, count));
        let residuals = residuals?;
        check_dependence(evaluator, definition, &residuals, symbols)?;
        Some(StatedEquations { residuals, starts: starts?, iterations: iterations? })
    }
}

fn residual(
    evaluator: &mut Evaluator<'_>,
    names: &[Name],
    syntax: AstId,
    symbols: &[ExprId],
) -> Option<ExprId> {
    let name = &words::names(names);
    value_of(evaluator, syntax)?;
    let residual = evaluator.scalar(syntax, &words::equation(name))?;
    let slopes = symbols.iter().map(|&symbol| partial(&mut evaluator.graph, residual, symbol));
    let slopes = slopes.collect::<Vec<_>>();
    if slopes.into_iter().all(|slope| evaluator.graph.is_zero(slope)) {
        return evaluator.refuse(syntax, words::without_unknown(name), words::without_unknown_help(name));
    }
    if has_one_sign(&evaluator.graph, residual) {
        return evaluator.refuse(syntax, words::without_solution(name), words::without_solution_help(name));
    }
    Some(residual)
}

/// Reports equations that do not determine their unknowns at any point.
fn check_dependence(
    evaluator: &mut Evaluator<'_>,
    definition: &UnknownDefinition,
    residuals: &[ExprId],
    symbols: &[ExprId],
) -> Option<()> {
    let last = *definition.residuals.last()?;
    for (name, &symbol) in definition.names.iter().zip(symbols) {
        let slopes = residuals.iter().map(|&residual| partial(&mut evaluator.graph, residual, symbol));
        let slopes = slopes.collect::<Vec<_>>();
        if slopes.into_iter().all(|slope| evaluator.graph.is_zero(slope)) {
            let name = &words::names(std::slice::from_ref(name));
            return evaluator.refuse(last, words::in_no_equation(name), words::without_unknown_help(name));
        }
    }
    let determinant = jacobian_determinant(&mut evaluator.graph, residuals, symbols);
    if symbols.len() > 1 && proves_zero(&mut evaluator.graph, determinant, LARGEST_PROOF) {
        let names = words::names(&definition.names);
        return evaluator.refuse(last, words::dependent(&names), words::DEPENDENT_HELP);
    }
    Some(())
}

fn starting_value(evaluator: &mut Evaluator<'_>, name: &str, syntax: AstId) -> Option<ExprId> {
    value_of(evaluator, syntax)?;
    let start = evaluator.scalar(syntax, words::START)?;
    if holds_unknown(&evaluator.graph, start) {
        let (place, _) = evaluator.blame(syntax, Dependencies::PLACEHOLDER);
        evaluator.report.error(place, words::start_holds(name)).help(words::START_HELP);
        return None;
    }
    Some(start)
}

fn iterations(evaluator: &mut Evaluator<'_>, syntax: AstId) -> Option<u32> {
    value_of(evaluator, syntax)?;
    let value = evaluator.scalar(syntax, words::ITERATIONS)?;
    let count = evaluator.graph.as_number(value).and_then(Number::to_i32);
    let possible = count.filter(|count| (1..=MAX_ITERATIONS).contains(count));
    if possible.is_none() {
        evaluator.refuse::<()>(syntax, words::NO_ITERATIONS, words::iterations_help(MAX_ITERATIONS));
    }
    possible.and_then(|count| u32::try_from(count).ok())
}

fn holds_unknown(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::PLACEHOLDER)
}

/// Returns the unknowns as functions of their arguments.
fn solution(
    elaborator: &mut Elaborator<'_>,
    names: &[Name],
    symbols: &[ExprId],
    equations: &StatedEquations,
) -> Vec<ExprId> {
    let labels = elaborator.labels.iter().cloned().collect::<HashMap<_, _>>();
    let graph = &mut elaborator.evaluator.graph;
    let mut known = KnownParts { labels, symbols: OrderedMap::default() };
    let residuals = equations.residuals.iter().map(|&residual| known.taken_out(graph, residual)).collect();
    let starts = equations.starts.iter().map(|&start| known.symbol(graph, start)).collect();
    let (parts, arguments): (Vec<_>, Vec<_>) =
        known.symbols.iter().map(|(part, symbol)| (*part, *symbol)).unzip();
    let name_of =
        |symbol: &ExprId| graph.symbol_of(*symbol).map(|symbol| symbol.name.clone()).unwrap_or_default();
    let parameters = arguments.iter().map(name_of).collect::<Vec<_>>();
    let unknowns = names.iter().map(|name| name.text.clone()).collect::<Vec<_>>();
    let function = |place: usize| {
        let source = Source::Equation { unknowns: unknowns.clone(), place };
        let name = unknowns[place].clone();
        Opaque::value_of(OpaqueFunction { name, parameters: parameters.clone(), source })
    };
    let functions = (0..unknowns.len()).map(function).collect::<Vec<_>>();
    graph.add_unknowns(AlgebraicUnknowns {
        functions: functions.clone(),
        arguments,
        values: symbols.to_vec(),
        residuals,
        starts,
        iterations: equations.iterations,
    });
    functions.into_iter().map(|function| graph.opaque(function, &parts)).collect()
}

/// Parts of an equation that do not contain the unknown, with the symbols that stand for them.
struct KnownParts {
    labels: HashMap<ExprId, String>,
    symbols: OrderedMap<ExprId, ExprId>,
}

/// Operands of a sum or a product with their coefficients or exponents.
type Operands = Vec<(ExprId, Number)>;

impl KnownParts {
    /// Returns the equation with symbols for the largest parts that do not contain the unknown.
    fn taken_out(&mut self, graph: &mut Graph, residual: ExprId) -> ExprId {
        let mut image: HashMap<ExprId, ExprId> = HashMap::default();
        for id in graph.reachable(&[residual]) {
            if holds_unknown(graph, id) {
                let new = self.rebuilt(graph, id, &image);
                image.insert(id, new);
            }
        }
        image.get(&residual).copied().unwrap_or(residual)
    }

    /// Rebuilds an expression that contains the unknown; operands that contain it are in `image`.
    fn rebuilt(&mut self, graph: &mut Graph, id: ExprId, image: &HashMap<ExprId, ExprId>) -> ExprId {
        let node = graph.node(id).clone();
        let image_of = |operand: ExprId| image.get(&operand).copied();
        match &node {
            Node::Sum { constant, terms } => {
                let (mut bound, known) = split(terms, image_of);
                bound.extend(self.together(graph, known, |graph, terms| graph.sum(Number::ZERO, terms)));
                graph.sum(constant.clone(), bound)
            }
            Node::Product(factors) => {
                let (mut bound, known) = split(factors, image_of);
                bound.extend(self.together(graph, known, Graph::product));
                graph.product(bound)
            }
            _ => {
                let mut known = HashMap::default();
                node.for_each_child(|operand| {
                    if image_of(operand).is_none() {
                        known.insert(operand, self.symbol(graph, operand));
                    }
                });
                let of_known = |operand: ExprId| known.get(&operand).copied().unwrap_or(operand);
                rebuild(graph, id, |operand| image_of(operand).unwrap_or_else(|| of_known(operand)))
            }
        }
    }

    /// Returns one symbol for all known operands together.
    fn together(
        &mut self,
        graph: &mut Graph,
        mut known: Operands,
        combine: impl Fn(&mut Graph, Operands) -> ExprId,
    ) -> Option<(ExprId, Number)> {
        if known.len() > 1 {
            known = vec![(combine(graph, known), Number::ONE)];
        }
        let (part, weight) = known.pop()?;
        Some((self.symbol(graph, part), weight))
    }

    /// Returns a symbol for a part; numbers remain as they are.
    fn symbol(&mut self, graph: &mut Graph, part: ExprId) -> ExprId {
        if graph.dependencies(part) == Dependencies::NONE {
            return part;
        }
        if let Some(&symbol) = self.symbols.get(&part) {
            return symbol;
        }
        let name = match (graph.symbol_of(part), self.labels.get(&part)) {
            (Some(symbol), _) => symbol.identifier(),
            (None, Some(label)) => label.clone(),
            (None, None) => format!("given_{}", self.symbols.len()),
        };
        let symbol = graph.operand(&name);
        self.symbols.insert(part, symbol);
        symbol
    }
}

/// Splits operands into those that contain the unknown, as their images, and the others.
fn split(operands: &[(ExprId, Number)], image: impl Fn(ExprId) -> Option<ExprId>) -> (Operands, Operands) {
    let (mut bound, mut known) = (Vec::new(), Vec::new());
    for (operand, weight) in operands {
        match image(*operand) {
            Some(image) => bound.push((image, weight.clone())),
            None => known.push((*operand, weight.clone())),
        }
    }
    (bound, known)
}

/// Reports functions of users, and equations, that have the name of a solving function.
pub(super) fn check_names_of_solvers(elaborator: &mut Elaborator<'_>) {
    let statements = &elaborator.declaration.statements;
    let solved = statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Solve(unknowns) => Some(&unknowns.names),
        _ => None,
    });
    let mut named: OrderedMap<String, &[Name]> = OrderedMap::default();
    for names in solved {
        let joined = names.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join("_");
        let functions = names_of_functions(statements).into_iter();
        let clash =
            functions.filter(|name| name.text.strip_prefix("solve_") == Some(&joined)).collect::<Vec<_>>();
        for name in clash {
            let message = words::name_of_solver(&name.text, words::names(names));
            let error = elaborator.evaluator.report.error(name.span, message).help(messages::OTHER_NAME_HELP);
            error.related(names[0].span.into(), messages::names::DECLARED_HERE);
        }
        if let Some(first) = named.insert(joined.clone(), names) {
            let message = words::name_of_solver(format!("solve_{joined}"), words::names(first));
            let error =
                elaborator.evaluator.report.error(names[0].span, message).help(messages::OTHER_NAME_HELP);
            error.related(first[0].span.into(), messages::names::DECLARED_HERE);
        }
    }
}
