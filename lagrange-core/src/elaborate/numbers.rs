//! Numbers in what the user wrote: whether they can be kept exactly, whether they are real, whether the scalar holds them.
//!
//! A value without symbols that is not real is a mistake wherever it stands. A number that is too large for the scalar is
//! one only where it is left in what is to be computed: `1e400 / 1e399` is ten.

use super::elaborator::Elaborator;
use super::expression::Evaluator;
use super::messages;
use super::operand::Operand;
use crate::calculus::node_value;
use crate::collections::HashMap;
use crate::expr::{Dependencies, ExprId, Graph, Node};
use crate::functions;
use crate::number::Number;
use crate::syntax::ast::{Action, AstId, Declaration, Expression, ScalarType, StatementKind};

/// Values of expressions without symbols.
#[derive(Default)]
pub(super) struct Constants {
    values: HashMap<ExprId, f64>,
}

impl Constants {
    /// Evaluates an expression without symbols; gives the first part of it that is not real although all that it is made
    /// of is finite.
    fn first_unreal(&mut self, graph: &Graph, root: ExprId) -> Option<ExprId> {
        if self.values.contains(&root) {
            return None;
        }
        let new = graph.reachable_until(&[root], |id| self.values.contains(&id));
        let unreal = new.into_iter().filter(|&id| self.add(graph, id));
        unreal.min()
    }

    /// Evaluates one node, whose operands have been; says whether its value is the first that is not real.
    fn add(&mut self, graph: &Graph, id: ExprId) -> bool {
        if self.values.contains(&id) {
            return false;
        }
        let at = |child: &ExprId| self.values.get(child).copied().unwrap_or(f64::NAN);
        let value = node_value(graph, id, at, |_| f64::NAN);
        let mut from_finite = true;
        graph.node(id).for_each_child(|child| from_finite &= at(&child).is_finite());
        self.values.insert(id, value);
        from_finite && (value.is_nan() || value.is_infinite() && has_poles(graph.node(id)))
    }
}

/// Whether this is a function with arguments for which it is not defined.
fn has_poles(node: &Node) -> bool {
    matches!(node, Node::Call(function, _) if !functions::row(*function).is_total())
}

impl Evaluator<'_> {
    /// Whether one can go on with a value; reports it if not.
    pub(super) fn is_sound(&mut self, value: &Operand, id: AstId) -> bool {
        self.is_short(value, id) && self.is_real(value, id)
    }

    /// Exact numbers grow with every operation, twofold in each of `a1 = a0*a0 + 1/7`, `a2 = a1*a1 + 1/7`, ….
    fn is_short(&mut self, value: &Operand, id: AstId) -> bool {
        let has_short_powers = |id: ExprId| match self.graph.node(id) {
            Node::Product(factors) => factors.iter().all(|(_, exponent)| exponent.is_short()),
            _ => true,
        };
        let is_short = |&component: &ExprId| {
            let (coefficient, core) = self.graph.split_coefficient(component);
            let number = self.graph.as_number(core);
            coefficient.is_short() && number.is_none_or(Number::is_short) && has_short_powers(core)
        };
        let short = value.components().iter().all(is_short);
        if !short {
            self.report
                .error(self.origin(id), messages::NUMBER_TOO_LONG)
                .help(messages::NUMBER_TOO_LONG_HELP);
        }
        short
    }

    fn is_real(&mut self, value: &Operand, id: AstId) -> bool {
        let graph = &self.graph;
        let unknown = |&component: &ExprId| {
            graph.dependencies(component) == Dependencies::NONE && graph.as_number(component).is_none()
        };
        let mut constants = value.components().iter().copied().filter(unknown);
        let is_real = constants.all(|component| self.constants.first_unreal(graph, component).is_none());
        if !is_real {
            let help = match self.syntax(id) {
                Expression::Call(function, _) => functions::by_name(&function.text)
                    .map(|row| messages::defined_where(row.name, row.domain)),
                _ => None,
            };
            let error = self.report.error(self.origin(id), messages::NOT_REAL);
            error.help(help.unwrap_or_else(|| messages::NEGATIVE_BASE_HELP.to_owned()));
        }
        is_real
    }
}

impl Elaborator<'_> {
    /// Reports numbers that are too large for the scalar, each at the smallest expression that holds it.
    pub(super) fn check_magnitudes(&mut self) {
        let declaration = self.declaration;
        let roots = declaration.statements.iter().flat_map(|statement| computed(&statement.kind));
        let roots = roots.collect::<Vec<_>>();
        let definitions = definitions(declaration);
        let evaluator = &mut self.evaluator;
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
                true => evaluator.report_excessive(id, &declaration.scalar),
                false => pending.extend(parts.into_iter().rev()),
            }
        }
    }
}

/// Which expressions hold a number that the scalar does not.
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

impl Evaluator<'_> {
    fn report_excessive(&mut self, id: AstId, scalar: &ScalarType) {
        let constant = |id: &ExprId| self.graph.dependencies(*id) == Dependencies::NONE;
        let is_constant = self.value(id).is_some_and(|value| value.components().iter().all(constant));
        let (name, largest) = largest(scalar);
        let error = self.report.error(self.origin(id), messages::excessive(is_constant, name));
        error.help(messages::largest_help(name, largest));
    }
}

/// The name of the scalar that limits numbers, and the largest that it holds.
pub(super) fn largest(scalar: &ScalarType) -> (&'static str, f64) {
    match scalar {
        ScalarType::F32 => ("f32", f64::from(f32::MAX)),
        ScalarType::F64 | ScalarType::Generic(_) => ("f64", f64::MAX),
    }
}

/// Whether a number stays finite when it is rounded to the scalar.
pub(super) fn holds(scalar: &ScalarType, value: f64) -> bool {
    match scalar {
        ScalarType::F32 => (value as f32).is_finite(),
        ScalarType::F64 | ScalarType::Generic(_) => value.is_finite(),
    }
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

/// What names stand for that abbreviate an expression.
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
