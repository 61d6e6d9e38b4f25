//! State of the evaluation of a declaration's expressions.

use super::callable::Callable;
use super::constants::Constants;
use super::messages;
use super::operand::Operand;
use super::scope::Scope;
use super::unresolved::Unresolved;
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_algebra::calculus::Rates;
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::expr::Dependencies;
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::Graph;
use lagrange_expr::expr::Node;
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::AstId;
use lagrange_language::syntax::ast::BinaryOperator;
use lagrange_language::syntax::ast::Declaration;
use lagrange_language::syntax::ast::Expression;
use lagrange_language::syntax::ast::StatementKind;

/// Evaluates the expressions of one declaration.
pub(super) struct Evaluator<'a> {
    pub(super) graph: Graph,
    pub(super) scope: Scope,
    pub(super) report: &'a mut Report,
    pub(super) declaration: &'a Declaration,
    pub(super) rates: Rates,
    /// Velocity and position resulting from each `dot(…)`.
    pub(super) named_rates: OrderedMap<ExprId, ExprId>,
    /// Arguments already reported as unsuitable sizes of a solid.
    pub(super) unsuitable: HashSet<Vec<AstId>>,
    /// Values whose shape was already reported to differ from the array.
    pub(super) misshapen: HashSet<AstId>,
    /// Joints already reported to have no force.
    pub(super) forceless_joints: HashSet<String>,
    pub(super) constants: Constants,
    pub(super) unresolved: Unresolved,
    /// Operands by expression; `None` for errors, which have been reported.
    pub(super) values: HashMap<AstId, Option<Operand>>,
    /// Functions without a formula that calls may refer to.
    pub(super) callables: OrderedMap<String, Callable>,
    /// Expressions that must be vectors. A violation is reported at the expression, not for each
    /// component.
    pub(super) obliged_vectors: HashSet<AstId>,
    /// Expressions that must be valid masses or moments of inertia. Negative ones are reported at
    /// the expression.
    pub(super) obliged_masses: HashSet<AstId>,
    /// Nesting depth of the partial derivatives under evaluation.
    pub(super) derivatives: u32,
    /// States that carry along what these calls of `dot` and `ddot` differentiate.
    pub(super) carried_calls: HashMap<AstId, ExprId>,
    /// States of the calls in the definitions of these names.
    pub(super) carried_names: HashMap<String, ExprId>,
}

/// A leaf of a chain, negated in a sum or inverted in a product.
pub(super) struct ChainLink {
    pub(super) operand: AstId,
    pub(super) inverted: bool,
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
            unsuitable: HashSet::default(),
            misshapen: HashSet::default(),
            forceless_joints: HashSet::default(),
            constants: Constants::default(),
            unresolved: Unresolved::default(),
            values: HashMap::default(),
            callables: OrderedMap::default(),
            obliged_vectors: HashSet::default(),
            obliged_masses: HashSet::default(),
            derivatives: 0,
            carried_calls: HashMap::default(),
            carried_names: HashMap::default(),
        }
    }

    pub(super) fn origin(&self, id: AstId) -> Origin {
        self.declaration.expressions.origin(id)
    }

    pub(super) fn syntax(&self, id: AstId) -> &'a Expression {
        self.declaration.expressions.get(id)
    }

    pub(super) fn value(&self, id: AstId) -> Option<Operand> {
        self.values.get(&id).cloned().flatten()
    }

    /// Reports an invalid expression, and returns none.
    pub(super) fn refuse<T>(
        &mut self,
        syntax: AstId,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Option<T> {
        self.report.error(self.origin(syntax), message).help(help);
        None
    }

    /// Returns the value as a scalar; reports anything else, described as `what`.
    pub(super) fn scalar(&mut self, id: AstId, what: &str) -> Option<ExprId> {
        match self.value(id)? {
            Operand::Scalar(scalar) => Some(scalar),
            vector => {
                let message = messages::scalar_needed(what, vector.kind());
                self.refuse(id, message, messages::HOW_TO_GET_A_SCALAR)
            }
        }
    }

    /// Returns the value as the components of a vector; reports a scalar, described as `what`.
    pub(super) fn vector(&mut self, id: AstId, what: &str) -> Option<Vec<ExprId>> {
        match self.value(id)? {
            Operand::Vector(components) => Some(components),
            scalar => self.refuse(id, messages::vector_needed(what, scalar.kind()), messages::VECTOR_HELP),
        }
    }

    /// Returns the expressions that must be evaluated before `id`: the leaves of a chain.
    pub(super) fn operands(&self, id: AstId) -> Vec<AstId> {
        match self.syntax(id) {
            Expression::Call(name, arguments) if reads_its_arguments(&name.text, arguments) => Vec::new(),
            _ => self.constituents(id),
        }
    }

    /// Returns the expressions that determine the value of `id`: its operands, and the expressions
    /// that a call differentiates.
    pub(super) fn constituents(&self, id: AstId) -> Vec<AstId> {
        match self.syntax(id) {
            Expression::Number(_) | Expression::Name(_) | Expression::Array(_) | Expression::Invalid => {
                Vec::new()
            }
            Expression::Binary(BinaryOperator::Power, _, base, exponent) => vec![*base, *exponent],
            Expression::Negate(_) | Expression::Binary(..) => {
                self.chain(id).into_iter().map(|link| link.operand).collect()
            }
            Expression::Tuple(components) => components.clone(),
            Expression::Call(name, arguments) if reads_its_arguments(&name.text, arguments) => {
                arguments[..1].to_vec()
            }
            Expression::Call(_, arguments) => arguments.clone(),
            Expression::Component(of, _) | Expression::Quantity(of, _) => vec![*of],
            Expression::Entry { of, .. } => vec![*of],
            Expression::If { condition, then, otherwise } => {
                vec![condition.left, condition.right, *then, *otherwise]
            }
        }
    }

    /// Returns the leaves of a chain of sums or of products, in source order.
    pub(super) fn chain(&self, root: AstId) -> Vec<ChainLink> {
        let additive = match self.syntax(root) {
            Expression::Binary(operator, ..) => is_additive(*operator),
            _ => true,
        };
        let mut leaves = Vec::new();
        let mut pending = vec![ChainLink { operand: root, inverted: false }];
        while let Some(ChainLink { operand, inverted }) = pending.pop() {
            match self.syntax(operand) {
                Expression::Negate(inner) if additive => {
                    pending.push(ChainLink { operand: *inner, inverted: !inverted });
                }
                Expression::Binary(operator, _, left, right)
                    if *operator != BinaryOperator::Power && is_additive(*operator) == additive =>
                {
                    let flips = matches!(operator, BinaryOperator::Subtract | BinaryOperator::Divide);
                    pending.push(ChainLink { operand: *right, inverted: inverted != flips });
                    pending.push(ChainLink { operand: *left, inverted });
                }
                _ => leaves.push(ChainLink { operand, inverted }),
            }
        }
        leaves
    }

    /// Computes d/dt of an operand, and records which velocity is the rate of which position.
    pub(super) fn rate(&mut self, value: &Operand, origin: AstId) -> Option<Operand> {
        for &component in value.components() {
            let forces = Dependencies::MULTIPLIER | Dependencies::REACTION;
            if self.graph.dependencies(component).intersects(forces) {
                let (place, name) = self.blame(origin, forces);
                self.report.error(place, messages::rate_of_force(&name)).help(messages::RATE_OF_FORCE_HELP);
                return None;
            }
            if self.graph.dependencies(component).intersects(Dependencies::PLACEHOLDER) {
                let (place, name) = self.blame(origin, Dependencies::PLACEHOLDER);
                let error = self.report.error(place, messages::solve::rate_within(&name));
                error.help(messages::solve::RATE_HELP);
                return None;
            }
            if self.graph.dependencies(component).intersects(Dependencies::NOISE) {
                let (place, name) = self.blame(origin, Dependencies::NOISE);
                let error = self.report.error(place, messages::noise::rate(&name));
                error.help(messages::noise::MISPLACED_HELP);
                return None;
            }
            if self.graph.dependencies(component).intersects(Dependencies::INPUT) {
                let (place, name) = self.blame(origin, Dependencies::INPUT);
                let is_delayed = self.declaration.statements.iter().any(
                    |statement| matches!(&statement.kind, StatementKind::Delay { name: late, .. } if late.text == name),
                );
                let help =
                    if is_delayed { messages::delays::RATE_HELP } else { messages::RATE_OF_INPUT_HELP };
                self.report.error(place, messages::rate_of_input(&name)).help(help);
                return None;
            }
            if self.lacks_state_rate(component, origin) {
                return None;
            }
        }
        Some(value.map(|component| {
            let rate = self.rates.of(&mut self.graph, component);
            self.remember_rate(component, rate);
            rate
        }))
    }

    /// True if the rate of an expression needs the rate of a state that is not yet defined. An
    /// equation further down is reported here, a missing one elsewhere.
    fn lacks_state_rate(&mut self, component: ExprId, origin: AstId) -> bool {
        if !self.graph.dependencies(component).intersects(Dependencies::STATE) {
            return false;
        }
        let is_state =
            |&id: &ExprId| matches!(self.graph.symbol_of(id).map(|symbol| symbol.role), Some(Role::State(_)));
        let mut states = self.graph.reachable(&[component]).into_iter().filter(is_state);
        let Some(missing) = states.find(|&id| self.graph.rate_of_position(id).is_none()) else {
            return false;
        };
        let name = self.graph.symbol_of(missing).map(|symbol| symbol.name.clone()).unwrap_or_default();
        if self.declaration.states_rate_of(&name) {
            let (place, _) = self.blame(origin, Dependencies::STATE);
            let error = self.report.error(place, messages::states::rate_too_early(&name));
            error.help(messages::states::rate_too_early_help(&name));
        }
        true
    }

    fn remember_rate(&mut self, position: ExprId, rate: ExprId) {
        // Quantities that depend on states have no position.
        if self.graph.dependencies(position).intersects(Dependencies::STATE) {
            return;
        }
        let (coefficient, velocity) = self.graph.split_coefficient(rate);
        if self.graph.as_number(velocity).is_some() || self.named_rates.contains(&velocity) {
            return;
        }
        if let Some(inverse) = coefficient.reciprocal() {
            let position = self.graph.scale(inverse, position);
            self.named_rates.insert(velocity, position);
        }
    }

    /// Returns the smallest part of an expression that depends on one of `kinds`, and its text if
    /// it is a name.
    pub(super) fn blame(&self, root: AstId, kinds: Dependencies) -> (Origin, String) {
        let guilty = |id: AstId| {
            let value = self.value(id);
            value.is_some_and(|value| {
                value.components().iter().any(|&c| self.graph.dependencies(c).intersects(kinds))
            })
        };
        let mut culprit = root;
        while let Some(inner) = self.constituents(culprit).into_iter().find(|&operand| guilty(operand)) {
            culprit = inner;
        }
        let name = match self.syntax(culprit) {
            Expression::Name(name) => self.symbol_behind(name, culprit, kinds),
            // The rate of a state.
            _ => self.symbol_behind("", culprit, kinds),
        };
        (self.origin(culprit), name)
    }

    /// Returns the smallest part of an expression that contains another one; `None` if the other
    /// one is not part of it.
    pub(super) fn place_of(&self, root: AstId, part: ExprId) -> Option<Origin> {
        let holds = |id: AstId| {
            let components = self.value(id).map_or_else(Vec::new, |value| value.components().to_vec());
            self.graph.reachable(&components).contains(&part)
        };
        let mut place = Some(root).filter(|&root| holds(root))?;
        while let Some(inner) = self.constituents(place).into_iter().find(|&operand| holds(operand)) {
            place = inner;
        }
        Some(self.origin(place))
    }

    /// Returns the name itself if it is a symbol, otherwise the name of a symbol of these kinds
    /// that it abbreviates.
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

/// True for a call whose arguments are not evaluated before it.
pub(super) fn reads_its_arguments(function: &str, arguments: &[AstId]) -> bool {
    function == "partial" && arguments.len() == 2
}

fn is_additive(operator: BinaryOperator) -> bool {
    matches!(operator, BinaryOperator::Add | BinaryOperator::Subtract)
}
