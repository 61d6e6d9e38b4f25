//! Expressions of the language to expressions of the graph.
//!
//! The walk is iterative. Chains of `+`/`-` and of `*`/`/` are evaluated as one, so that a sum of many terms
//! is collected once and not pair by pair.

use super::messages;
use super::numbers::Constants;
use super::operand::Operand;
use super::scope::{Kind, Scope};
use super::unresolved::Unresolved;
use crate::calculus::{AccelerationTerms, Rates};
use crate::collections::{HashMap, OrderedMap};
use crate::diagnostics::{Origin, Report};
use crate::expr::{Dependencies, ExprId, Graph, Node};
use crate::functions;
use crate::symbol::Role;
use crate::syntax::ast::{AstId, BinaryOperator, Condition, Declaration, Expression, Name};

/// Evaluates the expressions of one declaration.
pub(super) struct Evaluator<'a> {
    pub(super) graph: Graph,
    pub(super) scope: Scope,
    pub(super) report: &'a mut Report,
    pub(super) declaration: &'a Declaration,
    rates: Rates,
    /// What each `dot(…)` evaluated to: velocity and position.
    pub(super) named_rates: OrderedMap<ExprId, ExprId>,
    /// Arguments that are reported to be no size of a solid.
    pub(super) unsuitable: HashMap<Vec<AstId>, ()>,
    /// Joints of which it was reported that they have no force.
    forceless_joints: HashMap<String, ()>,
    pub(super) constants: Constants,
    pub(super) unresolved: Unresolved,
    /// Operands by expression; `None` where something was wrong and has been reported.
    values: HashMap<AstId, Option<Operand>>,
    /// What is claimed to be a vector: that it is none is reported there, not for each of its components.
    pub(super) claimed_vectors: HashMap<AstId, ()>,
    /// What is claimed to be a mass or a moment of inertia of a body: that it is negative is reported there.
    pub(super) claimed_masses: HashMap<AstId, ()>,
}

impl<'a> Evaluator<'a> {
    pub(super) fn new(declaration: &'a Declaration, report: &'a mut Report) -> Evaluator<'a> {
        Evaluator {
            graph: Graph::new(),
            scope: Scope::default(),
            report,
            declaration,
            rates: Rates::new(AccelerationTerms::Kept),
            named_rates: OrderedMap::default(),
            unsuitable: HashMap::default(),
            forceless_joints: HashMap::default(),
            constants: Constants::default(),
            unresolved: Unresolved::default(),
            values: HashMap::default(),
            claimed_vectors: HashMap::default(),
            claimed_masses: HashMap::default(),
        }
    }

    pub(super) fn origin(&self, id: AstId) -> Origin {
        self.declaration.expressions.origin(id)
    }

    pub(super) fn syntax(&self, id: AstId) -> &'a Expression {
        self.declaration.expressions.get(id)
    }

    /// The value of an expression; `None` if something in it is wrong, which has been reported.
    pub(super) fn evaluate(&mut self, root: AstId) -> Option<Operand> {
        let mut pending = vec![root];
        while let Some(&id) = pending.last() {
            let before = pending.len();
            if !self.values.contains(&id) {
                // Reversed, so that operands are evaluated, and complained of, from left to right.
                let operands = self.operands(id).into_iter().rev();
                pending.extend(operands.filter(|operand| !self.values.contains(operand)));
            }
            if pending.len() == before {
                pending.pop();
                if !self.values.contains(&id) {
                    let value = self.evaluate_node(id).filter(|value| self.is_sound(value, id));
                    self.values.insert(id, value);
                }
            }
        }
        self.value(root)
    }

    pub(super) fn value(&self, id: AstId) -> Option<Operand> {
        self.values.get(&id).cloned().flatten()
    }

    /// The expressions that must have values before `id` has one: the leaves of a chain.
    pub(super) fn operands(&self, id: AstId) -> Vec<AstId> {
        match self.syntax(id) {
            Expression::Number(_) | Expression::Name(_) | Expression::Invalid => Vec::new(),
            Expression::Binary(BinaryOperator::Power, _, base, exponent) => vec![*base, *exponent],
            Expression::Negate(_) | Expression::Binary(..) => {
                self.chain(id).into_iter().map(|link| link.operand).collect()
            }
            Expression::Tuple(components) => components.clone(),
            Expression::Call(_, arguments) => arguments.clone(),
            Expression::Component(of, _) => vec![*of],
            Expression::If { condition, then, otherwise } => {
                vec![condition.left, condition.right, *then, *otherwise]
            }
        }
    }

    fn evaluate_node(&mut self, id: AstId) -> Option<Operand> {
        match self.syntax(id) {
            Expression::Number(value) => Some(Operand::Scalar(self.graph.number(value.clone()))),
            Expression::Name(name) => self.evaluate_name(name, self.origin(id)),
            Expression::Binary(BinaryOperator::Power, _, base, exponent) => {
                self.evaluate_power(*base, *exponent, self.origin(id))
            }
            Expression::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, ..) => {
                self.evaluate_product(id)
            }
            Expression::Negate(_) | Expression::Binary(..) => self.evaluate_sum(id),
            Expression::Tuple(components) => {
                let components =
                    components.iter().map(|&c| self.scalar(c, "a component")).collect::<Vec<_>>();
                components.into_iter().collect::<Option<Vec<_>>>().map(Operand::Vector)
            }
            Expression::Call(function, arguments) => self.evaluate_call(function, arguments, id),
            Expression::Component(of, component) => self.evaluate_component(*of, component),
            Expression::If { condition, then, otherwise } => self.evaluate_if(*condition, *then, *otherwise),
            Expression::Invalid => None,
        }
    }

    fn evaluate_name(&mut self, name: &str, origin: Origin) -> Option<Operand> {
        match name {
            "t" => return Some(Operand::Scalar(self.graph.symbol("t", Role::Time))),
            "pi" => return Some(Operand::Scalar(self.graph.pi())),
            _ => {}
        }
        if let Some(entry) = self.scope.resolve(name) {
            if entry.kind.has_value() {
                return entry.value.clone();
            }
            let kind = entry.kind;
            if kind == Kind::Implied && !self.is_first_of_joint(name) {
                return None;
            }
            let (message, help) = match kind {
                Kind::Implied => (messages::FORCE_OF_IMPLIED.to_owned(), messages::FORCE_OF_IMPLIED_HELP),
                kind => {
                    (messages::names::has_no_value(kind.describe(), name), messages::names::NAME_IT_WITH_LET)
                }
            };
            self.report.error(origin, message).help(help);
            return None;
        }
        if super::kinematics::is_function(name) {
            self.report.error(origin, messages::names::function_as_value(name)).help(messages::FUNCTION_HELP);
            return None;
        }
        if !self.is_known_unresolved(name, origin) && !self.is_declared_elsewhere(name, origin) {
            let help = self.help_for_unknown(name);
            self.report_unknown(name, origin, help);
        }
        None
    }

    /// Whether nothing was said yet of a joint without forces, one of whose constraints has this name.
    fn is_first_of_joint(&mut self, constraint: &str) -> bool {
        let joint = constraint.rsplit_once('_').map_or(constraint, |(joint, _)| joint);
        self.forceless_joints.insert(joint.to_owned(), ()).is_none()
    }

    fn evaluate_power(&mut self, base: AstId, exponent: AstId, origin: Origin) -> Option<Operand> {
        let value = self.scalar(base, "the base of a power");
        let power = self.scalar(exponent, "an exponent");
        self.power(value?, power?, origin).map(Operand::Scalar)
    }

    /// base ^ exponent, with a complaint where no real number results.
    pub(super) fn power(&mut self, base: ExprId, exponent: ExprId, origin: Origin) -> Option<ExprId> {
        if let (Some(b), Some(e)) = (self.graph.as_number(base), self.graph.as_number(exponent)) {
            if b.is_negative() && !e.is_integer() {
                let message = messages::root_of_negative(&b.to_string(), &e.to_string());
                self.report.error(origin, message).help(messages::NEGATIVE_BASE_HELP);
                return None;
            }
            if b.is_zero() && e.is_negative() {
                self.report.error(origin, messages::DIVISION_BY_ZERO).help(messages::ZERO_BASE_HELP);
                return None;
            }
        } else if let Some(b) = self.graph.as_number(base)
            && b.is_negative()
        {
            let message = messages::varying_power_of_negative(&b.to_string());
            self.report.error(origin, message).help(messages::NEGATIVE_BASE_HELP);
            return None;
        }
        Some(functions::apply(&mut self.graph, crate::expr::Function::Power, &[base, exponent]))
    }

    fn evaluate_component(&mut self, of: AstId, component: &Name) -> Option<Operand> {
        let value = self.value(of)?;
        let index = ["x", "y", "z"].iter().position(|name| *name == component.text);
        if let (Operand::Vector(components), Some(index)) = (&value, index)
            && let Some(&found) = components.get(index)
        {
            return Some(Operand::Scalar(found));
        }
        if super::kinematics::is_function(&component.text) {
            let error = self.report.error(component.span, messages::names::method_as_value(&component.text));
            error.help(messages::FUNCTION_HELP);
            return None;
        }
        if self.claimed_vectors.contains(&of) {
            return None;
        }
        let message = messages::no_component(&component.text, &value.kind());
        self.report.error(component.span, message).help(messages::COMPONENTS);
        None
    }

    fn evaluate_if(&mut self, condition: Condition, then: AstId, otherwise: AstId) -> Option<Operand> {
        let left = self.scalar(condition.left, "a compared value");
        let right = self.scalar(condition.right, "a compared value");
        let (a, b) = (self.value(then)?, self.value(otherwise)?);
        if !a.same_kind(&b) {
            let message = messages::kinds_differ("choose between", &a.kind(), &b.kind());
            self.report.error(self.origin(otherwise), message).help(messages::KINDS_HELP);
            return None;
        }
        let (left, right) = (left?, right?);
        let chosen = a.components().iter().zip(b.components());
        let chosen = chosen.map(|(&a, &b)| self.graph.choose(condition.relation, left, right, a, b));
        let chosen = chosen.collect();
        Some(rebuild(&a, chosen))
    }

    /// The value as a scalar; reports anything else as `what`.
    pub(super) fn scalar(&mut self, id: AstId, what: &str) -> Option<ExprId> {
        match self.value(id)? {
            Operand::Scalar(scalar) => Some(scalar),
            vector => {
                let message = messages::scalar_needed(what, &vector.kind());
                self.report.error(self.origin(id), message).help(messages::HOW_TO_GET_A_SCALAR);
                None
            }
        }
    }

    /// The value as the components of a vector; reports a scalar as `what`.
    pub(super) fn vector(&mut self, id: AstId, what: &str) -> Option<Vec<ExprId>> {
        match self.value(id)? {
            Operand::Vector(components) => Some(components),
            scalar => {
                let error = self.report.error(self.origin(id), messages::vector_needed(what, &scalar.kind()));
                error.help(messages::VECTOR_HELP);
                None
            }
        }
    }

    /// d/dt of an operand; remembers which velocity is the rate of what.
    pub(super) fn rate(&mut self, value: &Operand, origin: AstId) -> Option<Operand> {
        for &component in value.components() {
            let forces = Dependencies::MULTIPLIER | Dependencies::REACTION;
            if self.graph.dependencies(component).intersects(forces) {
                let (place, name) = self.blame(origin, forces);
                self.report.error(place, messages::rate_of_force(&name)).help(messages::RATE_OF_FORCE_HELP);
                return None;
            }
            if self.graph.dependencies(component).intersects(Dependencies::INPUT) {
                let (place, name) = self.blame(origin, Dependencies::INPUT);
                self.report.error(place, messages::rate_of_input(&name)).help(messages::RATE_OF_INPUT_HELP);
                return None;
            }
        }
        Some(value.map(|component| {
            let rate = self.rates.of(&mut self.graph, component);
            self.remember_rate(component, rate);
            rate
        }))
    }

    fn remember_rate(&mut self, position: ExprId, rate: ExprId) {
        let (coefficient, velocity) = self.graph.split_coefficient(rate);
        if self.graph.as_number(velocity).is_some() || self.named_rates.contains(&velocity) {
            return;
        }
        if let Some(inverse) = coefficient.reciprocal() {
            let position = self.graph.scale(inverse, position);
            self.named_rates.insert(velocity, position);
        }
    }

    /// The smallest part of an expression that depends on one of `kinds`, and its text if it is a name.
    pub(super) fn blame(&self, root: AstId, kinds: Dependencies) -> (Origin, String) {
        let guilty = |id: AstId| {
            let value = self.value(id);
            value.is_some_and(|value| {
                value.components().iter().any(|&c| self.graph.dependencies(c).intersects(kinds))
            })
        };
        let mut culprit = root;
        while let Some(inner) = self.operands(culprit).into_iter().find(|&operand| guilty(operand)) {
            culprit = inner;
        }
        let name = match self.syntax(culprit) {
            Expression::Name(name) => self.symbol_behind(name, culprit, kinds),
            _ => String::new(),
        };
        (self.origin(culprit), name)
    }

    /// The smallest part of an expression of which another one is a part; `None` if it is none of its parts.
    pub(super) fn place_of(&self, root: AstId, part: ExprId) -> Option<Origin> {
        let holds = |id: AstId| {
            let components = self.value(id).map_or_else(Vec::new, |value| value.components().to_vec());
            self.graph.reachable(&components).contains(&part)
        };
        let mut place = Some(root).filter(|&root| holds(root))?;
        while let Some(inner) = self.operands(place).into_iter().find(|&operand| holds(operand)) {
            place = inner;
        }
        Some(self.origin(place))
    }

    /// The name itself if it is a symbol, else that of a symbol of these kinds that it abbreviates.
    fn symbol_behind(&self, name: &str, id: AstId, kinds: Dependencies) -> String {
        let roots = self.value(id).map(|value| value.components().to_vec()).unwrap_or_default();
        let found = self.graph.reachable(&roots).into_iter().find_map(|id| match self.graph.node(id) {
            Node::Symbol(symbol) if self.graph.dependencies(id).intersects(kinds) => {
                Some(self.graph.symbols().get(*symbol).name.clone())
            }
            _ => None,
        });
        found.unwrap_or_else(|| name.to_owned())
    }
}

/// An operand of the kind of `like` with these components.
pub(super) fn rebuild(like: &Operand, components: Vec<ExprId>) -> Operand {
    match like {
        Operand::Scalar(_) => Operand::Scalar(components[0]),
        Operand::Vector(_) => Operand::Vector(components),
    }
}
