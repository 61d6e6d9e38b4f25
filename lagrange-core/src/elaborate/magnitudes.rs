//! Diagnostics for numbers that are too large for the scalar.

use super::constants::Constants;
use super::elaborator::Elaborator;
use super::evaluator::Evaluator;
use super::messages;
use super::scalar_range::{holds, largest};
use crate::collections::HashMap;
use crate::expr::{Dependencies, ExprId, Graph, Node};
use crate::number::Number;
use crate::syntax::ast::{Action, AstId, Declaration, Expression, ScalarType, StatementKind};

/// Reports numbers that are too large for the scalar, each at the smallest expression that holds it.
pub(super) fn check_magnitudes(elaborator: &mut Elaborator<'_>) {
    let declaration = elaborator.declaration;
    let roots = declaration.statements.iter().flat_map(|statement| computed(&statement.kind));
    let roots = roots.collect::<Vec<_>>();
    let definitions = definitions(declaration);
    let evaluator = &mut elaborator.evaluator;
    let mut excessive = Excessive { scalar: &declaration.scalar, known: HashMap::default() };
    excessive.learn(evaluator, &roots);
    let mut seen = HashMap::default();
    let mut pending = roots.into_iter().rev().collect::<Vec<_>>();
    while let Some(id) = pending.pop() {
        if !excessive.contains(evaluator, id) || seen.insert(id, ()).is_some() {
            continue;
        }
        let mut parts = evaluator.operands(id);
        if let Expression::Name(name) = evaluator.syntax(id) {
            parts.extend(definitions.get(&name.as_str()));
        }
        excessive.learn(evaluator, &parts);
        parts.retain(|&part| excessive.contains(evaluator, part));
        match parts.is_empty() {
            true => report_excessive(evaluator, id, &declaration.scalar),
            false => pending.extend(parts.into_iter().rev()),
        }
    }
}

/// Expressions that hold a number out of the range of the scalar.
struct Excessive<'a> {
    scalar: &'a ScalarType,
    known: HashMap<ExprId, bool>,
}

impl Excessive<'_> {
    fn contains(&self, evaluator: &Evaluator, id: AstId) -> bool {
        let is_excessive = |id: &ExprId| self.known.get(id) == Some(&true);
        evaluator.value(id).is_some_and(|value| value.components().iter().any(is_excessive))
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
            let is_excessive = self.is_excessive(graph, constants, id);
            self.known.insert(id, is_excessive);
        }
    }

    /// Whether a node whose operands are known holds such a number.
    fn is_excessive(&self, graph: &Graph, constants: &Constants, id: ExprId) -> bool {
        let fits = |number: &Number| holds(self.scalar, number.to_f64());
        let own = match graph.node(id) {
            Node::Sum { constant, terms } => !fits(constant) || !terms.iter().all(|(_, c)| fits(c)),
            Node::Product(factors) => !factors.iter().all(|(base, exponent)| {
                let power = constants.values.get(base).map(|base| base.powf(exponent.to_f64()));
                fits(exponent) && power.is_none_or(|power| holds(self.scalar, power))
            }),
            _ => false,
        };
        let value = constants.values.get(&id);
        let mut is_excessive = own || value.is_some_and(|&value| !holds(self.scalar, value));
        graph.node(id).for_each_child(|child| is_excessive |= self.known.get(&child) == Some(&true));
        is_excessive
    }
}

fn report_excessive(evaluator: &mut Evaluator<'_>, id: AstId, scalar: &ScalarType) {
    let constant = |id: &ExprId| evaluator.graph.dependencies(*id) == Dependencies::NONE;
    let is_constant = evaluator.value(id).is_some_and(|value| value.components().iter().all(constant));
    let (name, largest) = largest(scalar);
    let error = evaluator.report.error(evaluator.origin(id), messages::excessive(is_constant, name));
    error.help(messages::largest_help(name, largest));
}

/// The expressions of a statement whose values are computed at run time, those of defaults aside.
fn computed(kind: &StatementKind) -> Vec<AstId> {
    match kind {
        StatementKind::Kinetic(value)
        | StatementKind::Potential(value)
        | StatementKind::Lagrangian(value)
        | StatementKind::Dissipation(value)
        | StatementKind::Stabilise(value)
        | StatementKind::ForceOn(_, value)
        | StatementKind::Constraint(_, value)
        | StatementKind::Output(_, value) => vec![*value],
        StatementKind::ForceAt { force, point } => vec![*force, *point],
        StatementKind::Gibbs { function, stated } => vec![*function, *stated],
        StatementKind::Torque { moment, angle } => vec![*moment, *angle],
        StatementKind::Event(event) => match &event.action {
            Action::Impact(restitution) => vec![event.value, *restitution],
            Action::Assign(list) => {
                [event.value].into_iter().chain(list.iter().map(|assignment| assignment.value)).collect()
            }
            Action::Stop | Action::Record => vec![event.value],
        },
        StatementKind::Friction(friction) => [friction.slip, friction.kinetic]
            .into_iter()
            .chain(friction.fixed)
            .chain(friction.width)
            .collect(),
        StatementKind::Reduce(reduction) => reduction.items.iter().filter_map(|item| item.value).collect(),
        _ => Vec::new(),
    }
}

/// Names that abbreviate an expression, with these expressions.
fn definitions(declaration: &Declaration) -> HashMap<&str, AstId> {
    let kinds = declaration.statements.iter().map(|statement| &statement.kind);
    let definitions = kinds.flat_map(|kind| match kind {
        StatementKind::Let(name, value) => vec![(name.text.as_str(), *value)],
        StatementKind::LetTuple(names, value) => {
            names.iter().map(|name| (name.text.as_str(), *value)).collect()
        }
        StatementKind::Constants(list) => {
            list.iter().filter_map(|one| Some((one.name.text.as_str(), one.value?))).collect()
        }
        _ => Vec::new(),
    });
    definitions.collect()
}
