//! Statements to a model.

use proc_macro2::Span;

use super::expression::Evaluator;
use super::messages;
use super::numbers::{holds, largest};
use super::operand::Operand;
use super::scene::Staged;
use super::scope::Kind;
use crate::bodies::Plain;
use crate::calculus::evaluate;
use crate::diagnostics::{Report, nearest};
use crate::expr::{Dependencies, ExprId};
use crate::model::{
    Constraint, Coordinate, Event, Load, Output, Parameter, Product, Reaction, Reduction, Scene,
};
use crate::symbol::Role;
use crate::syntax::ast::{AstId, Declaration, Definition, EmitItem, Name, Statement, StatementKind};

/// Methods that every system has; no output may take their names.
const GENERATED_METHODS: [&str; 7] =
    ["acceleration", "rhs", "multipliers", "constraints", "EQUATIONS_LATEX", "PARAMETERS", "STATEMENTS"];
/// Products that later versions will emit.
const PLANNED_PRODUCTS: [&str; 2] = ["hamiltonian", "taylor"];

/// What only the equations of motion determine.
pub(super) const UNKNOWNS: &[Dependencies] =
    &[Dependencies::ACCELERATION, Dependencies::MULTIPLIER, Dependencies::REACTION];

/// An expression of a statement and where it stands.
pub(super) struct Term {
    pub(super) value: ExprId,
    pub(super) syntax: AstId,
    pub(super) keyword: Span,
}

/// The model under construction.
pub(super) struct Elaborator<'a> {
    pub(super) evaluator: Evaluator<'a>,
    pub(super) declaration: &'a Declaration,
    pub(super) parameters: Vec<Parameter>,
    pub(super) inputs: Vec<Parameter>,
    pub(super) coordinates: Vec<(Coordinate, Span)>,
    pub(super) kinetic: Vec<Term>,
    pub(super) potential: Vec<Term>,
    pub(super) lagrangian: Vec<Term>,
    pub(super) dissipation: Vec<Term>,
    pub(super) loads: Vec<Load>,
    /// Names of the constraints of joints.
    pub(super) joints: &'a [Name],
    /// Names of `let`s that are places, with what they are places of.
    places: &'a [(String, String)],
    /// Those of them that the coordinates fulfil by themselves.
    pub(super) implied: Vec<String>,
    /// Constraints, with where their names stand.
    pub(super) constraints: Vec<(Constraint, Span)>,
    /// The rate of stabilisation, with where it is given.
    pub(super) stabilisation: Option<(ExprId, Span)>,
    /// Events, with where their names stand.
    pub(super) events: Vec<(Event, Span)>,
    /// Contacts and friction, with where their names stand.
    pub(super) reactions: Vec<(Reaction, Span)>,
    pub(super) outputs: Vec<Output>,
    /// What there is of rigid bodies.
    pub(super) staged: Staged,
    pub(super) scene: Scene,
    pub(super) labels: Vec<(ExprId, String)>,
    /// Entries of `emit`, with where they stand.
    pub(super) wanted: Vec<(Product, bool, Span)>,
    pub(super) reductions: Vec<Reduction>,
}

impl<'a> Elaborator<'a> {
    pub(super) fn new(plain: &'a Plain, report: &'a mut Report) -> Elaborator<'a> {
        let Plain { declaration, joints, places, .. } = plain;
        Elaborator {
            evaluator: Evaluator::new(declaration, report),
            declaration,
            parameters: Vec::new(),
            inputs: Vec::new(),
            coordinates: Vec::new(),
            kinetic: Vec::new(),
            potential: Vec::new(),
            lagrangian: Vec::new(),
            dissipation: Vec::new(),
            loads: Vec::new(),
            joints,
            places,
            implied: Vec::new(),
            constraints: Vec::new(),
            stabilisation: None,
            events: Vec::new(),
            reactions: Vec::new(),
            outputs: Vec::new(),
            staged: Staged::default(),
            scene: Scene::default(),
            labels: Vec::new(),
            wanted: Vec::new(),
            reductions: Vec::new(),
        }
    }

    pub(super) fn statement(&mut self, statement: &Statement) {
        let keyword = statement.origin.start;
        match &statement.kind {
            StatementKind::Parameters(list) => list.iter().for_each(|d| self.parameter(d, Kind::Parameter)),
            StatementKind::Inputs(list) => list.iter().for_each(|d| self.parameter(d, Kind::Input)),
            StatementKind::Constants(list) => list.iter().for_each(|d| self.constant(d)),
            StatementKind::Coordinates(names) => names.iter().for_each(|name| self.coordinate(name)),
            StatementKind::Let(name, value) => self.abbreviation(name, *value),
            StatementKind::LetTuple(names, value) => self.abbreviations(names, *value),
            StatementKind::Kinetic(value) => {
                let term = self.term(*value, keyword, "the kinetic energy");
                self.kinetic.extend(term);
            }
            StatementKind::Potential(value) => {
                let term = self.term(*value, keyword, "the potential energy");
                self.potential.extend(term);
            }
            StatementKind::Lagrangian(value) => {
                let term = self.term(*value, keyword, "the Lagrangian");
                self.lagrangian.extend(term);
            }
            StatementKind::Dissipation(value) => {
                let term = self.term(*value, keyword, "the dissipation function");
                self.dissipation.extend(term);
            }
            StatementKind::ForceOn(coordinate, value) => self.force_on(coordinate, *value),
            StatementKind::ForceAt { force, point } => self.force_at(*force, *point),
            StatementKind::Torque { moment, angle } => self.torque(*moment, *angle, keyword),
            StatementKind::Constraint(name, value) => self.constraint(name, *value),
            StatementKind::Stabilise(rate) => self.stabilise(*rate, keyword),
            StatementKind::Event(event) => self.event(event),
            StatementKind::Friction(friction) => self.friction(friction),
            StatementKind::Output(name, value) => self.output(name, *value),
            StatementKind::Emit(items) => items.iter().for_each(|item| self.emit(item)),
            StatementKind::Reduce(reduction) => self.reduction(reduction),
            // Plain statements have taken its place.
            StatementKind::Scene(_) => {}
        }
    }

    fn parameter(&mut self, definition: &Definition, kind: Kind) {
        let default = definition.value.and_then(|value| self.default_value(&definition.name, value));
        let name = &definition.name.text;
        let is_input = kind == Kind::Input;
        let list = if is_input { &mut self.inputs } else { &mut self.parameters };
        let index = list.len() as u32;
        let role = if is_input { Role::Input(index) } else { Role::Parameter(index) };
        let symbol = self.evaluator.graph.symbol(name, role);
        let default = match default {
            None if is_input => Some(self.evaluator.graph.number(0)),
            given => given,
        };
        list.push(Parameter { name: name.clone(), symbol, default });
        self.declare(&definition.name, kind, Some(Operand::Scalar(symbol)));
    }

    fn default_value(&mut self, name: &Name, syntax: AstId) -> Option<ExprId> {
        let value = self.constant_scalar(syntax, "a default")?;
        let numeric = evaluate(&self.evaluator.graph, &[value], |_| f64::NAN)[0];
        if !holds(&self.declaration.scalar, numeric) {
            let (scalar, largest) = largest(&self.declaration.scalar);
            let message = messages::number_too_large(&name.text, scalar);
            let error = self.evaluator.report.error(self.evaluator.origin(syntax), message);
            error.help(messages::largest_help(scalar, largest));
        }
        Some(value)
    }

    fn constant_scalar(&mut self, syntax: AstId, what: &str) -> Option<ExprId> {
        self.evaluator.evaluate(syntax)?;
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

    fn constant(&mut self, definition: &Definition) {
        let value = definition.value.and_then(|value| self.constant_scalar(value, "a constant"));
        self.declare(&definition.name, Kind::Constant, value.map(Operand::Scalar));
    }

    pub(super) fn declare(&mut self, name: &Name, kind: Kind, value: Option<Operand>) {
        self.evaluator.scope.declare(name, kind, value, self.evaluator.report);
    }

    fn coordinate(&mut self, name: &Name) {
        let index = self.coordinates.len() as u32;
        let graph = &mut self.evaluator.graph;
        let coordinate = Coordinate {
            name: name.text.clone(),
            position: graph.symbol(&name.text, Role::Coordinate(index)),
            velocity: graph.symbol(&name.text, Role::Velocity(index)),
            acceleration: graph.symbol(&name.text, Role::Acceleration(index)),
        };
        self.declare(name, Kind::Coordinate, Some(Operand::Scalar(coordinate.position)));
        self.coordinates.push((coordinate, name.span));
    }

    fn abbreviation(&mut self, name: &Name, syntax: AstId) {
        let value = self.evaluator.evaluate(syntax).filter(|value| self.is_sound_place(name, syntax, value));
        match &value {
            Some(Operand::Scalar(id)) => self.labels.push((*id, name.text.clone())),
            Some(Operand::Vector(components)) => {
                for (id, axis) in components.iter().zip(["x", "y", "z"]) {
                    self.labels.push((*id, format!("{}_{axis}", name.text)));
                }
            }
            None => {}
        }
        self.declare(name, Kind::Abbreviation, value);
    }

    /// Whether a name is that of no place, or of one made of coordinates and time.
    fn is_sound_place(&mut self, name: &Name, syntax: AstId, value: &Operand) -> bool {
        let Some((_, what)) = self.places.iter().find(|(place, _)| *place == name.text) else { return true };
        let moving = Dependencies::VELOCITY
            | Dependencies::ACCELERATION
            | Dependencies::MULTIPLIER
            | Dependencies::REACTION;
        let depends = |&id: &ExprId| self.evaluator.graph.dependencies(id).intersects(moving);
        if !value.components().iter().any(depends) {
            return true;
        }
        let (place, _) = self.evaluator.blame(syntax, moving);
        self.evaluator.report.error(place, messages::no_place(what)).help(messages::PLACE_HELP);
        false
    }

    fn abbreviations(&mut self, names: &[Name], syntax: AstId) {
        let components = match self.evaluator.evaluate(syntax) {
            Some(Operand::Vector(components)) if components.len() == names.len() => {
                components.into_iter().map(Some).collect()
            }
            Some(other) => {
                let message = messages::tuple_size(names.len(), &other.kind());
                let error = self.evaluator.report.error(self.evaluator.origin(syntax), message);
                error.help(messages::TUPLE_SIZE_HELP);
                vec![None; names.len()]
            }
            None => vec![None; names.len()],
        };
        for (name, component) in names.iter().zip(components) {
            self.labels.extend(component.map(|id| (id, name.text.clone())));
            self.declare(name, Kind::Abbreviation, component.map(Operand::Scalar));
        }
    }

    /// A scalar expression without accelerations.
    pub(super) fn term(&mut self, syntax: AstId, keyword: Span, what: &str) -> Option<Term> {
        self.evaluator.evaluate(syntax)?;
        let value = self.evaluator.scalar(syntax, what)?;
        self.forbid_accelerations(syntax, value, what)?;
        Some(Term { value, syntax, keyword })
    }

    pub(super) fn forbid_accelerations(&mut self, syntax: AstId, value: ExprId, what: &str) -> Option<()> {
        let help = messages::ONLY_OUTPUTS_HOLD_ACCELERATIONS;
        self.forbid(UNKNOWNS, (syntax, value), what, help)
    }

    /// Reports if an expression depends on one of these kinds.
    pub(super) fn forbid(
        &mut self,
        kinds: &[Dependencies],
        (syntax, value): (AstId, ExprId),
        what: &str,
        help: &str,
    ) -> Option<()> {
        let dependencies = self.evaluator.graph.dependencies(value);
        let Some(&kind) = kinds.iter().find(|&&kind| dependencies.intersects(kind)) else { return Some(()) };
        let (place, name) = self.evaluator.blame(syntax, kind);
        self.evaluator.report.error(place, messages::must_not_depend(what, kind, &name)).help(help);
        None
    }

    fn output(&mut self, name: &Name, syntax: AstId) {
        let value = self.evaluator.evaluate(syntax);
        let mut methods = Product::ALL.iter().filter(|product| !product.is_of_bodies());
        if methods.any(|method| method.name() == name.text) || GENERATED_METHODS.contains(&name.text.as_str())
        {
            let error = self.evaluator.report.error(name.span, messages::reserved_output(&name.text));
            error.help(messages::OTHER_NAME_HELP);
        }
        self.declare(name, Kind::Output, None);
        let Some(value) = value else { return };
        let graph = &self.evaluator.graph;
        let uses = |kind| value.components().iter().any(|&c| graph.dependencies(c).intersects(kind));
        let uses_accelerations = uses(Dependencies::ACCELERATION);
        let uses_multipliers = uses(Dependencies::MULTIPLIER);
        let uses_reactions = uses(Dependencies::REACTION);
        let components = value.components().to_vec();
        self.outputs.push(Output {
            name: name.text.clone(),
            components,
            uses_accelerations,
            uses_multipliers,
            uses_reactions,
        });
    }

    fn emit(&mut self, item: &EmitItem) {
        let name = item.product.text.as_str();
        if let Some(&product) = Product::ALL.iter().find(|product| product.name() == name) {
            self.wanted.push((product, item.wanted, item.product.span));
            return;
        }
        let message = match PLANNED_PRODUCTS.contains(&name) {
            true => messages::product_not_available(name),
            false => messages::unknown_product(name),
        };
        let help = match nearest(name, Product::ALL.iter().map(|product| product.name())) {
            Some(nearest) => messages::names::did_you_mean(nearest),
            None => messages::products(),
        };
        self.evaluator.report.error(item.product.span, message).help(help);
    }
}
