//! The model under construction, with helpers for all statements.

use proc_macro2::Span;

use super::assigned::{Bounds, DeclaredLimits, EntryValues};
use super::evaluator::Evaluator;
use super::expression::value_of;
use super::messages;
use super::operand::Operand;
use super::scope::NameKind;
use super::staged::Staged;
use super::unknown_names::{is_declared_elsewhere, is_known_unresolved, report_unknown};
use crate::model::{
    Action, Availability, Clock, Constraint, Coordinate, Delay, Event, GibbsFunction, Load, Orientation,
    Output, Parameter, Product, Quantity, Reaction, Reduction, Scene, Speed,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::{Report, nearest};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_language::bodies::Plain;
use lagrange_language::syntax::ast::{self, AstId, Declaration, Name, StateKind};

/// Quantities determined only by the equations of motion.
pub(super) const UNKNOWNS: &[Dependencies] =
    &[Dependencies::ACCELERATION, Dependencies::MULTIPLIER, Dependencies::REACTION];

/// Dependencies that a constant value must not have, the most informative first.
pub(super) const CHANGING: [Dependencies; 10] = [
    Dependencies::MULTIPLIER,
    Dependencies::REACTION,
    Dependencies::ACCELERATION,
    Dependencies::VELOCITY,
    Dependencies::COORDINATE,
    Dependencies::STATE,
    Dependencies::DISCRETE,
    Dependencies::INPUT,
    Dependencies::NOISE,
    Dependencies::TIME,
];

/// An expression of a statement, with its position.
pub(super) struct SourceTerm {
    pub(super) value: ExprId,
    pub(super) syntax: AstId,
    pub(super) keyword: Span,
}

/// A declared first-order state.
pub(super) struct DeclaredState {
    pub(super) name: Name,
    pub(super) position: ExprId,
    pub(super) kind: StateKind,
    /// Position of its equation, if there is one.
    pub(super) equation: Option<Span>,
    /// Symbol for its rate in equations that do not yet determine it.
    pub(super) unknown_rate: Option<ExprId>,
    /// True if its equation has an error, which was reported.
    pub(super) is_given_up: bool,
    /// True if its rate was found together with others.
    pub(super) is_coupled: bool,
}

/// A declared noise.
pub(super) struct DeclaredNoise {
    pub(super) name: Name,
    pub(super) symbol: ExprId,
    pub(super) density: ExprId,
}

/// An equation for rates of states that is not yet solved.
#[derive(Clone, Debug)]
pub(super) struct RateEquation {
    pub(super) syntax: AstId,
    /// Difference of both sides.
    pub(super) residual: ExprId,
    /// Indices of the states with unknown rates.
    pub(super) unknowns: Vec<usize>,
}

/// The model under construction.
pub(super) struct Elaborator<'a> {
    pub(super) evaluator: Evaluator<'a>,
    pub(super) declaration: &'a Declaration,
    pub(super) parameters: Vec<Parameter>,
    pub(super) inputs: Vec<Parameter>,
    pub(super) noises: Vec<DeclaredNoise>,
    /// Inputs that are delayed signals, with the positions of the signals.
    pub(super) delays: Vec<(Delay, Span)>,
    /// Ranges of parameters so far, keyed by their bounds in the syntax tree.
    pub(super) ranges: Vec<([Option<ast::Limit>; 2], Bounds)>,
    /// Quantities of contacts that depend on parameters, with their ranges.
    pub(super) quantities: Vec<Quantity>,
    /// Distances of the centres of compliant contacts.
    pub(super) distances: Vec<(Name, ExprId)>,
    pub(super) coordinates: Vec<(Coordinate, Span)>,
    /// Ranges and nominal values of entries of the state.
    pub(super) limits: Vec<DeclaredLimits>,
    pub(super) states: Vec<DeclaredState>,
    /// Equations that do not yet determine rates of states.
    pub(super) rate_equations: Vec<RateEquation>,
    /// The names that `velocity` statements give to the rates of coordinates.
    pub(super) named_velocities: HashMap<String, &'a Name>,
    /// Number of positions that are not states, all of which precede the states.
    pub(super) first_state: usize,
    pub(super) speeds: Vec<(Speed, Span)>,
    pub(super) orientations: Vec<Orientation>,
    pub(super) start: EntryValues,
    /// Entries of the state before the start.
    pub(super) history: EntryValues,
    pub(super) kinetic: Vec<SourceTerm>,
    pub(super) potential: Vec<SourceTerm>,
    pub(super) lagrangian: Vec<SourceTerm>,
    pub(super) gibbs: Vec<GibbsFunction>,
    pub(super) dissipation: Vec<SourceTerm>,
    pub(super) loads: Vec<Load>,
    /// Names of loads, with the numbers of their statements.
    pub(super) load_statements: Vec<(String, usize)>,
    /// Names of the constraints of joints.
    pub(super) joints: &'a [Name],
    /// Names of `let`s that are positions, with the items that they position.
    pub(super) places: &'a [(String, String)],
    /// Heights of terrain.
    pub(super) heights: &'a [AstId],
    /// Constraints of joints that the coordinates fulfil by themselves.
    pub(super) implied: Vec<String>,
    /// Constraints, with the positions of their names.
    pub(super) constraints: Vec<(Constraint, Span)>,
    /// Index of the first constraint on each velocity expression, up to a factor and a number.
    pub(super) constrained: HashMap<ExprId, usize>,
    /// Rate of stabilisation, with its position.
    pub(super) stabilisation: Option<(ExprId, Span)>,
    /// Events, with the positions of their names.
    pub(super) events: Vec<(Event, Span)>,
    pub(super) clocks: Vec<(Clock, Span)>,
    /// Contacts and friction, with the positions of their names.
    pub(super) reactions: Vec<(Reaction, Span)>,
    pub(super) outputs: Vec<Output>,
    /// Rigid bodies of the declaration.
    pub(super) staged: Staged,
    pub(super) scene: Scene,
    pub(super) labels: Vec<(ExprId, String)>,
    /// Entries of `emit`, with their positions.
    pub(super) wanted: Vec<(Product, bool, Span)>,
    pub(super) reductions: Vec<Reduction>,
}

impl<'a> Elaborator<'a> {
    pub(super) fn new(plain: &'a Plain, report: &'a mut Report) -> Elaborator<'a> {
        let Plain { declaration, joints, places, heights, .. } = plain;
        Elaborator {
            evaluator: Evaluator::new(declaration, report),
            declaration,
            heights,
            parameters: Vec::new(),
            inputs: Vec::new(),
            noises: Vec::new(),
            delays: Vec::new(),
            ranges: Vec::new(),
            quantities: Vec::new(),
            distances: Vec::new(),
            coordinates: Vec::new(),
            limits: Vec::new(),
            states: Vec::new(),
            rate_equations: Vec::new(),
            named_velocities: declaration.named_velocities(),
            first_state: declaration.coordinates().len() - declaration.states().count(),
            speeds: Vec::new(),
            orientations: Vec::new(),
            start: EntryValues::default(),
            history: EntryValues::default(),
            kinetic: Vec::new(),
            potential: Vec::new(),
            lagrangian: Vec::new(),
            gibbs: Vec::new(),
            dissipation: Vec::new(),
            loads: Vec::new(),
            load_statements: Vec::new(),
            joints,
            places,
            implied: Vec::new(),
            constraints: Vec::new(),
            constrained: HashMap::default(),
            stabilisation: None,
            events: Vec::new(),
            clocks: Vec::new(),
            reactions: Vec::new(),
            outputs: Vec::new(),
            staged: Staged::default(),
            scene: Scene::default(),
            labels: Vec::new(),
            wanted: Vec::new(),
            reductions: Vec::new(),
        }
    }

    pub(super) fn declare(&mut self, name: &Name, kind: NameKind, value: Option<Operand>) {
        self.evaluator.scope.declare(name, kind, value, self.evaluator.report);
    }

    /// True if the state has neither orientations nor first-order states. With them, momenta do not
    /// determine velocities.
    pub(super) fn velocities_are_rates(&self) -> bool {
        self.orientations.is_empty() && self.states.is_empty()
    }

    pub(super) fn products(&self) -> Vec<Product> {
        let last_word = |product| self.wanted.iter().rev().find(|(named, ..)| *named == product);
        let asked =
            |product: Product, otherwise| last_word(product).map_or(otherwise, |(_, wanted, _)| *wanted);
        let wanted = |&product: &Product| {
            let otherwise = match product.row().when {
                Availability::Always | Availability::SeparateEnergies | Availability::Constraints => true,
                Availability::Demand | Availability::Events | Availability::Bodies => false,
                Availability::With(other) => asked(other, false),
            };
            asked(product, otherwise) && !self.is_undefined(product)
        };
        Product::ALL.into_iter().filter(wanted).collect()
    }

    pub(super) fn is_undefined(&self, product: Product) -> bool {
        match product.row().when {
            Availability::SeparateEnergies => !self.lagrangian.is_empty(),
            Availability::Constraints => self.constraints.is_empty(),
            Availability::Events => self.events.is_empty(),
            Availability::Bodies => self.staged.lacks(product),
            Availability::Always | Availability::Demand | Availability::With(_) => false,
        }
    }

    pub(super) fn push_event(&mut self, event: &ast::Event, value: ExprId, action: Action) {
        let name = event.name.text.clone();
        self.events.push((Event { name, value, direction: event.direction, action }, event.name.span));
    }

    /// Evaluates a scalar expression without accelerations.
    pub(super) fn term(&mut self, syntax: AstId, keyword: Span, what: &str) -> Option<SourceTerm> {
        value_of(&mut self.evaluator, syntax)?;
        let value = self.evaluator.scalar(syntax, what)?;
        self.forbid_accelerations(syntax, value, what)?;
        Some(SourceTerm { value, syntax, keyword })
    }

    /// Returns the name of the coordinate whose rate is a velocity, or else of the velocity itself.
    pub(super) fn name_of_freedom<'s>(&'s self, speed: &'s Speed) -> &'s str {
        let coordinate = speed.coordinate.and_then(|index| self.coordinates.get(index));
        coordinate.map_or(&speed.name, |(coordinate, _)| &coordinate.name)
    }

    /// Returns the index of the velocity with a name, or of the coordinate with that name.
    pub(super) fn speed_of(&self, name: &str) -> Option<usize> {
        let is_velocity = self.evaluator.scope.is_velocity(name);
        self.speeds.iter().position(|(speed, _)| match is_velocity {
            true => speed.name == name,
            false => self.name_of_freedom(speed) == name,
        })
    }

    /// Evaluates a scalar of numbers and constants.
    pub(super) fn constant_scalar(&mut self, syntax: AstId, what: &str) -> Option<ExprId> {
        value_of(&mut self.evaluator, syntax)?;
        let value = self.evaluator.scalar(syntax, what)?;
        let dependencies = self.evaluator.graph.dependencies(value);
        if dependencies != Dependencies::NONE {
            let (place, _) = self.evaluator.blame(syntax, dependencies);
            let error = self.evaluator.report.error(place, messages::not_constant(what));
            error.help(messages::NOT_CONSTANT_HELP);
            return None;
        }
        Some(value)
    }

    /// Evaluates a scalar that is constant during the motion.
    pub(super) fn constant_in_motion(&mut self, syntax: AstId, what: &str) -> Option<ExprId> {
        value_of(&mut self.evaluator, syntax)?;
        let value = self.evaluator.scalar(syntax, what)?;
        for kind in CHANGING {
            if self.evaluator.graph.dependencies(value).intersects(kind) {
                let (place, _) = self.evaluator.blame(syntax, kind);
                self.evaluator
                    .report
                    .error(place, messages::not_constant(what))
                    .help(messages::CONSTANT_IN_MOTION_HELP);
                return None;
            }
        }
        Some(value)
    }

    /// Returns the value of an expression if it is the same number in every motion of every system.
    pub(super) fn numeric(&self, value: ExprId) -> Option<f64> {
        let graph = &self.evaluator.graph;
        let is_number = graph.dependencies(value) == Dependencies::NONE;
        is_number.then(|| evaluate(graph, &[value], |_| f64::NAN)[0])
    }

    pub(super) fn forbid_accelerations(&mut self, syntax: AstId, value: ExprId, what: &str) -> Option<()> {
        let help = messages::ONLY_OUTPUTS_HOLD_ACCELERATIONS;
        self.forbid(UNKNOWNS, (syntax, value), what, help)
    }

    /// Returns the places where a product is requested.
    pub(super) fn demands(&self, product: Product) -> Vec<Span> {
        let wanted = self.wanted.iter().filter(|(named, wanted, _)| *named == product && *wanted);
        wanted.map(|(.., span)| *span).collect()
    }

    /// Returns a scalar, which may depend on time, positions, velocities, states and inputs.
    pub(super) fn known_scalar(&mut self, syntax: AstId, what: &str, help: &str) -> Option<ExprId> {
        value_of(&mut self.evaluator, syntax)?;
        let value = self.evaluator.scalar(syntax, what)?;
        self.forbid(UNKNOWNS, (syntax, value), what, help)?;
        Some(value)
    }

    /// Reports an expression that depends on one of these kinds.
    pub(super) fn forbid(
        &mut self,
        kinds: &[Dependencies],
        (syntax, value): (AstId, ExprId),
        what: &str,
        help: &str,
    ) -> Option<()> {
        let dependencies = self.evaluator.graph.dependencies(value);
        let Some(&kind) = kinds.iter().find(|&&kind| dependencies.intersects(kind)) else { return Some(()) };
        let (syntax, what, help) = match self.height_with(kind) {
            Some(height) => (height, messages::events::HEIGHT, messages::events::GAP_HELP),
            None => (syntax, what, help),
        };
        let (place, name) = self.evaluator.blame(syntax, kind);
        self.evaluator.report.error(place, messages::must_not_depend(what, kind, &name)).help(help);
        None
    }

    /// Returns the height of a terrain that depends on what no height may depend on. It is the
    /// cause of errors in gaps and potentials of contacts.
    fn height_with(&mut self, kind: Dependencies) -> Option<AstId> {
        if kind != Dependencies::VELOCITY && !UNKNOWNS.contains(&kind) {
            return None;
        }
        let evaluator = &mut self.evaluator;
        let mut depends = |height: AstId| match value_of(evaluator, height) {
            Some(Operand::Scalar(value)) => evaluator.graph.dependencies(value).intersects(kind),
            _ => false,
        };
        self.heights.iter().copied().find(|&height| depends(height))
    }

    /// Reports a name that should be that of a coordinate; `usage` is the help if it is that of
    /// something else.
    pub(super) fn report_no_coordinate(&mut self, name: &Name, usage: &str) {
        let (text, origin) = (&name.text, name.span.into());
        if self.coordinates.iter().any(|(coordinate, _)| coordinate.name == *text) {
            let message = messages::names::component_of_quaternion(text);
            self.evaluator.report.error(name.span, message).help(messages::names::QUATERNION_HELP);
            return;
        }
        let is_unknown = self.evaluator.scope.find(text).is_none();
        let is_told = |evaluator: &mut Evaluator| {
            is_known_unresolved(evaluator, text, origin) || is_declared_elsewhere(evaluator, text, origin)
        };
        if is_unknown && is_told(&mut self.evaluator) {
            return;
        }
        if self.evaluator.scope.is_velocity(text) {
            let message = messages::names::velocity_as_coordinate(text);
            self.evaluator.report.error(name.span, message).help(usage.to_owned());
            return;
        }
        let scope = &self.evaluator.scope;
        let freedoms = self.speeds.iter().map(|(speed, _)| self.name_of_freedom(speed)).collect::<Vec<_>>();
        let help = match nearest(text, freedoms.iter().copied()) {
            Some(nearest) => messages::names::did_you_mean(nearest),
            None if scope.find(text).is_some() => usage.to_owned(),
            None => messages::coordinates_are(&freedoms, usage),
        };
        match is_unknown {
            true => report_unknown(&mut self.evaluator, text, origin, help),
            false => {
                self.evaluator.report.error(name.span, messages::not_a_coordinate(text)).help(help);
            }
        }
    }
}
