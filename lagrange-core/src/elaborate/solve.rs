//! Algebraic unknowns: values that equations define.
//!
//! While its equation is read the unknown is a symbol. The largest parts of the equation without
//! the unknown become the arguments of its function. They are then computed once and not in every
//! step of the iteration.

use super::elaborator::Elaborator;
use super::evaluator::Evaluator;
use super::expression::value_of;
use super::messages::{self, solve as words};
use super::operand::Operand;
use super::scope::NameKind;
use super::tables::names_of_functions;
use lagrange_algebra::calculus::{partial, rebuild};
use lagrange_algebra::simplify::has_one_sign;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{AlgebraicUnknown, Dependencies, ExprId, Graph, Node};
use lagrange_expr::limits::MAX_ITERATIONS;
use lagrange_expr::number::Number;
use lagrange_expr::opaque::{Opaque, OpaqueFunction, Source};
use lagrange_language::syntax::ast::{AstId, Name, StatementKind, UnknownDefinition};

/// Steps of the iteration where nothing else is said.
const ITERATIONS: u32 = 30;

/// `solve y: 0 = e, start: s, iterations: n;`
pub(super) fn define_unknown(elaborator: &mut Elaborator<'_>, definition: &UnknownDefinition) {
    let name = &definition.name.text;
    let symbol = elaborator.evaluator.graph.operand(name);
    elaborator.declare(&definition.name, NameKind::Unknown, Some(Operand::Scalar(symbol)));
    if elaborator.evaluator.scope.find(name).is_some_and(|entry| entry.is_ambiguous) {
        return;
    }
    let equation = StatedEquation::read(&mut elaborator.evaluator, definition, symbol);
    let value = equation.map(|equation| solution(elaborator, name, symbol, &equation));
    elaborator.labels.extend(value.map(|value| (value, name.clone())));
    elaborator.evaluator.scope.define(name, value.map(Operand::Scalar));
}

/// The parts of a statement that defines an unknown.
struct StatedEquation {
    residual: ExprId,
    start: ExprId,
    iterations: u32,
}

impl StatedEquation {
    /// Checks the whole statement; `None` if it has a mistake, which is reported.
    fn read(
        evaluator: &mut Evaluator<'_>,
        definition: &UnknownDefinition,
        symbol: ExprId,
    ) -> Option<StatedEquation> {
        let name = &definition.name.text;
        let residual = residual(evaluator, name, definition.residual, symbol);
        let start = match definition.start {
            Some(start) => starting_value(evaluator, name, start),
            None => Some(evaluator.graph.number(0)),
        };
        let iterations = definition.iterations.map_or(Some(ITERATIONS), |count| iterations(evaluator, count));
        Some(StatedEquation { residual: residual?, start: start?, iterations: iterations? })
    }
}

fn residual(evaluator: &mut Evaluator<'_>, name: &str, syntax: AstId, symbol: ExprId) -> Option<ExprId> {
    value_of(evaluator, syntax)?;
    let residual = evaluator.scalar(syntax, &words::equation(name))?;
    let slope = partial(&mut evaluator.graph, residual, symbol);
    if evaluator.graph.is_zero(slope) {
        return evaluator.refuse(syntax, words::without_unknown(name), words::without_unknown_help(name));
    }
    if has_one_sign(&evaluator.graph, residual) {
        return evaluator.refuse(syntax, words::without_solution(name), words::without_solution_help(name));
    }
    Some(residual)
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

/// The unknown as a function of its arguments.
fn solution(
    elaborator: &mut Elaborator<'_>,
    name: &str,
    symbol: ExprId,
    equation: &StatedEquation,
) -> ExprId {
    let labels = elaborator.labels.iter().cloned().collect::<HashMap<_, _>>();
    let graph = &mut elaborator.evaluator.graph;
    let mut arguments = KnownParts { labels, symbols: OrderedMap::default() };
    let residual = arguments.taken_out(graph, equation.residual);
    let start = arguments.symbol(graph, equation.start);
    let (parts, symbols): (Vec<_>, Vec<_>) =
        arguments.symbols.iter().map(|(part, symbol)| (*part, *symbol)).unzip();
    let name_of =
        |symbol: &ExprId| graph.symbol_of(*symbol).map(|symbol| symbol.name.clone()).unwrap_or_default();
    let parameters = symbols.iter().map(name_of).collect();
    let function =
        Opaque::value_of(OpaqueFunction { name: name.to_owned(), parameters, source: Source::Equation });
    let iterations = equation.iterations;
    graph.add_unknown(AlgebraicUnknown {
        function: function.clone(),
        arguments: symbols,
        value: symbol,
        residual,
        start,
        iterations,
    });
    graph.opaque(function, &parts)
}

/// Parts of an equation that do not hold the unknown, with the symbols that stand for them.
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

    /// An expression that holds the unknown, whose operands are in `image` if they do.
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

    /// A symbol for known operands, all of which are one part of the equation.
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

    /// A symbol for a part, which numbers stand for themselves.
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

/// Operands that hold the unknown, as their images, and the others.
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

/// Reports functions of the user's that have the name of one that solves an equation.
pub(super) fn check_names_of_solvers(elaborator: &mut Elaborator<'_>) {
    let statements = &elaborator.declaration.statements;
    let unknowns = statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Solve(unknown) => Some(&unknown.name),
        _ => None,
    });
    for unknown in unknowns {
        let clashes = |name: &&Name| name.text.strip_prefix("solve_") == Some(unknown.text.as_str());
        for name in names_of_functions(statements).into_iter().filter(clashes) {
            let message = words::name_of_solver(&name.text, &unknown.text);
            let error = elaborator.evaluator.report.error(name.span, message).help(messages::OTHER_NAME_HELP);
            error.related(unknown.span.into(), messages::names::DECLARED_HERE);
        }
    }
}
