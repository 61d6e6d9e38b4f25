//! Diagnostics for numbers that overflow or underflow the scalar.

use super::constants::Constants;
use super::elaborator::Elaborator;
use super::evaluator::Evaluator;
use super::messages;
use super::scalar_range::{Misfit, largest, misfit, misfit_of_value};
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::expr::Dependencies;
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::Graph;
use lagrange_expr::expr::Node;
use lagrange_expr::number::Number;
use lagrange_language::syntax::ast::AstId;
use lagrange_language::syntax::ast::Declaration;
use lagrange_language::syntax::ast::Expression;
use lagrange_language::syntax::ast::ScalarType;
use lagrange_language::syntax::ast::StatementKind;

/// Reports numbers outside the range of the scalar, each at the smallest expression that contains
/// it.
pub(super) fn check_magnitudes(elaborator: &mut Elaborator<'_>) {
    let declaration = elaborator.declaration;
    let roots = declaration.statements.iter().flat_map(|statement| computed(&statement.kind));
    let roots = roots.collect::<Vec<_>>();
    let definitions = definitions(declaration);
    let evaluator = &mut elaborator.evaluator;
    let mut misfits = Misfits { scalar: &declaration.scalar, known: HashMap::default() };
    misfits.learn(evaluator, &roots);
    let mut seen = HashSet::default();
    let mut pending = roots.into_iter().rev().collect::<Vec<_>>();
    while let Some(id) = pending.pop() {
        let misfit = misfits.of(evaluator, id);
        if misfit.is_none() || !seen.insert(id) {
            continue;
        }
        let mut parts = evaluator.constituents(id);
        if let Expression::Name(name) = evaluator.syntax(id) {
            parts.extend(definitions.get(&name.as_str()));
        }
        misfits.learn(evaluator, &parts);
        parts.retain(|&part| misfits.of(evaluator, part) == misfit);
        match misfit.filter(|_| parts.is_empty()) {
            Some(misfit) => report(evaluator, id, misfit, &declaration.scalar),
            None => pending.extend(parts.into_iter().rev()),
        }
    }
}

/// Expressions with a number outside the range of the scalar.
struct Misfits<'a> {
    scalar: &'a ScalarType,
    known: HashMap<ExprId, Option<Misfit>>,
}

impl Misfits<'_> {
    fn of(&self, evaluator: &Evaluator, id: AstId) -> Option<Misfit> {
        let of_component = |id: &ExprId| self.known.get(id).copied().flatten();
        evaluator.value(id)?.components().iter().find_map(of_component)
    }

    fn learn(&mut self, evaluator: &mut Evaluator, ids: &[AstId]) {
        let values = ids.iter().filter_map(|&id| evaluator.value(id));
        let mut values = values.flat_map(|value| value.components().to_vec()).collect::<Vec<_>>();
        values.retain(|value| !self.known.contains(value));
        let Evaluator { graph, constants, .. } = evaluator;
        for id in graph.reachable_until(&values, |id| self.known.contains(&id)) {
            if graph.dependencies(id) == Dependencies::NONE {
                constants.add(graph, id);
            }
            let found = self.find(graph, constants, id);
            self.known.insert(id, found);
        }
    }

    /// Returns the error in a node whose operands are known.
    fn find(&self, graph: &Graph, constants: &Constants, id: ExprId) -> Option<Misfit> {
        let of_number = |number: &Number| misfit(self.scalar, number);
        let of_value = |value: f64| misfit_of_value(self.scalar, value);
        let of_power = |base: f64, exponent: f64| match base.powf(exponent) {
            0.0 if base != 0.0 => Some(Misfit::TooSmall),
            power => of_value(power),
        };
        let own = match graph.node(id) {
            Node::Number(number) => of_number(number),
            Node::Sum { constant, terms } => of_number(constant)
                .or_else(|| terms.iter().find_map(|(_, coefficient)| of_number(coefficient))),
            Node::Product(factors) => factors.iter().find_map(|(base, exponent)| {
                let base = constants.values.get(base).copied();
                of_number(exponent).or_else(|| of_power(base?, exponent.to_f64()))
            }),
            _ => None,
        };
        let mut found = own.or_else(|| constants.values.get(&id).copied().and_then(of_value));
        graph.node(id).for_each_child(|child| found = found.or(self.known.get(&child).copied().flatten()));
        found
    }
}

fn report(evaluator: &mut Evaluator<'_>, id: AstId, misfit: Misfit, scalar: &ScalarType) {
    let constant = |id: &ExprId| evaluator.graph.dependencies(*id) == Dependencies::NONE;
    let is_constant = evaluator.value(id).is_some_and(|value| value.components().iter().all(constant));
    let (name, largest) = largest(scalar);
    let (message, help) = match misfit {
        Misfit::TooLarge => (messages::excessive(is_constant, name), messages::largest_help(name, largest)),
        Misfit::TooSmall => (messages::vanishing(is_constant, name), messages::VANISHING_HELP.to_owned()),
    };
    evaluator.refuse::<()>(id, message, help);
}

/// Returns the expressions of a statement that are computed at run time; none for definitions.
fn computed(kind: &StatementKind) -> Vec<AstId> {
    if kind.definitions().is_empty() { kind.expressions() } else { Vec::new() }
}

/// Returns the names that stand for expressions, with these expressions.
fn definitions(declaration: &Declaration) -> HashMap<&str, AstId> {
    let definitions = declaration.statements.iter().flat_map(|statement| statement.kind.definitions());
    definitions.map(|(name, value)| (name.text.as_str(), value)).collect()
}
