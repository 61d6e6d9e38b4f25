//! Shape of an emitted system, determined by its declaration alone: names, fields, types.

mod spelling;

use proc_macro2::TokenStream;

use super::callees::callees;
use super::size::shares_event;
use crate::model::Product;
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::units::NamedUnits;
use lagrange_language::syntax::ast::{
    Action, AllowedRange, ArrayShape, AstId, BinaryOperator, Declaration, Direction, Event, Expression, Name,
    ScalarType, StateVelocity, Statement, StatementKind,
};
pub(in crate::emit) use spelling::{doc, identifier, length, local, method_of, motion_name};

/// Names and types of one system.
pub(in crate::emit) struct Shape<'a> {
    pub(in crate::emit) declaration: &'a Declaration,
    /// Path of the crate `lagrange`.
    pub(in crate::emit) krate: &'a TokenStream,
    /// Parameters and inputs in declaration order, parameters first.
    pub(in crate::emit) fields: Vec<&'a Name>,
    /// Names of the inputs among them.
    pub(in crate::emit) inputs: HashSet<&'a str>,
    /// Indices of delayed signals among the inputs.
    pub(in crate::emit) delays: Vec<usize>,
    /// True if the declaration states the past before the start.
    pub(in crate::emit) has_history: bool,
    /// Positions in state order.
    pub(in crate::emit) coordinates: Vec<&'a Name>,
    /// Number of first-order states, which are the last of the positions.
    pub(in crate::emit) states: usize,
    /// Velocities in state order.
    pub(in crate::emit) velocities: Vec<StateVelocity<'a>>,
    /// Indices of the scalar parts of unit quaternions among the positions.
    pub(in crate::emit) quaternions: Vec<usize>,
    /// Rigid bodies with a method for their motion.
    pub(in crate::emit) bodies: Vec<&'a Name>,
    /// Bodies and frames with a method for their placement.
    pub(in crate::emit) frames: Vec<&'a Name>,
    /// Bodies and frames with a method for their Jacobian.
    pub(in crate::emit) frames_with_jacobian: Vec<&'a Name>,
    pub(in crate::emit) constraints: Vec<&'a Name>,
    pub(in crate::emit) events: Vec<&'a Event>,
    /// True if constraints are stabilised instead of projected onto.
    pub(in crate::emit) is_stabilised: bool,
    /// Contacts and friction.
    pub(in crate::emit) touching: Vec<(&'a Name, Touch)>,
    /// True if there are too many contacts and friction for an event of each. One event then stands
    /// for all, and only steps can simulate the system.
    pub(in crate::emit) shares_event: bool,
    /// Names, in messages, of the switches whose sides are fixed during runs.
    pub(in crate::emit) switches: Vec<String>,
    /// Outputs, declared and derived, with their number of components; one for a scalar.
    pub(in crate::emit) outputs: Vec<(Name, usize)>,
    /// The names of functions of the user's crate, as written by the user.
    pub(in crate::emit) callees: Vec<Name>,
    /// The user's documentation of fields, coordinates and outputs.
    docs: HashMap<&'a str, &'a TokenStream>,
    /// Declared ranges of parameters.
    pub(in crate::emit) ranges: HashMap<&'a str, &'a AllowedRange>,
    /// Units of the numbers with these names; none if the declaration has none.
    pub(in crate::emit) units: NamedUnits,
    /// Spelling of array elements.
    written: HashMap<&'a str, &'a str>,
}

/// Kind of the field that stores the mode of a reaction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::emit) enum Touch {
    /// A field that is true if the contact is open.
    Contact,
    /// A field that is true if friction sticks.
    Friction,
    /// A field that is true if friction in a plane sticks; such friction has two reactions.
    Planar,
    /// No field.
    Smooth,
}

impl<'a> Shape<'a> {
    pub(in crate::emit) fn new(declaration: &'a Declaration, krate: &'a TokenStream) -> Shape<'a> {
        let mut shape = Shape {
            declaration,
            krate,
            fields: Vec::new(),
            inputs: HashSet::default(),
            delays: Vec::new(),
            has_history: false,
            coordinates: declaration.coordinates(),
            states: 0,
            velocities: declaration.velocities(),
            quaternions: Vec::new(),
            bodies: Vec::new(),
            frames: Vec::new(),
            frames_with_jacobian: Vec::new(),
            constraints: Vec::new(),
            events: Vec::new(),
            is_stabilised: false,
            touching: Vec::new(),
            shares_event: shares_event(declaration),
            switches: Vec::new(),
            outputs: Vec::new(),
            callees: callees(declaration),
            docs: documentation(declaration),
            ranges: declaration.ranges().map(|(name, range)| (name.text.as_str(), range)).collect(),
            units: NamedUnits::default(),
            written: written_names(declaration),
        };
        let (mut inputs, shapes) = (Vec::new(), shapes_of_expressions(declaration));
        for statement in &declaration.statements {
            match &statement.kind {
                StatementKind::Parameters(list) => shape.fields.extend(list.iter().map(|d| &d.name)),
                StatementKind::Inputs(list) => inputs.extend(list.iter().map(|d| &d.name)),
                StatementKind::Delay { name, .. } => {
                    shape.delays.push(inputs.len());
                    inputs.push(name);
                }
                StatementKind::History(_) => shape.has_history = true,
                StatementKind::Constraint(name, _) => shape.constraints.push(name),
                StatementKind::Event(event) => shape.add_event(event),
                StatementKind::Stabilise(_) => shape.is_stabilised = true,
                StatementKind::Friction(friction) => {
                    let is_planar = shapes.get(&friction.slip) == Some(&ArrayShape::Vector(2));
                    let touch = match friction.width {
                        Some(_) => Touch::Smooth,
                        None if is_planar => Touch::Planar,
                        None => Touch::Friction,
                    };
                    shape.touching.push((&friction.name, touch));
                }
                StatementKind::Output(name, value) => {
                    let count = shapes.get(value).map_or(1, |shape| shape.count());
                    shape.outputs.push((name.clone(), count));
                }
                // Part of the state, of the equations or of other types, or removed from the plain
                // declaration.
                StatementKind::Coordinates(_)
                | StatementKind::States(..)
                | StatementKind::Mode(_)
                | StatementKind::Every(_)
                | StatementKind::Noises(_)
                | StatementKind::Quaternion(_)
                | StatementKind::Velocity(..)
                | StatementKind::Start(_)
                | StatementKind::Ranges(_)
                | StatementKind::Constants(_)
                | StatementKind::Let(..)
                | StatementKind::LetTuple(..)
                | StatementKind::Function(_)
                | StatementKind::External(_)
                | StatementKind::Table(_)
                | StatementKind::Solve(_)
                | StatementKind::StateRate(..)
                | StatementKind::RateEquation(_)
                | StatementKind::Kinetic(_)
                | StatementKind::Potential(_)
                | StatementKind::Lagrangian(_)
                | StatementKind::Gibbs { .. }
                | StatementKind::Dissipation(_)
                | StatementKind::ForceOn(..)
                | StatementKind::ForceAt { .. }
                | StatementKind::ForceAlong { .. }
                | StatementKind::Torque { .. }
                | StatementKind::Emit(_)
                | StatementKind::Reduce(_)
                | StatementKind::Block(_)
                | StatementKind::Scene(_) => {}
            }
        }
        shape.inputs = inputs.iter().map(|input| input.text.as_str()).collect();
        shape.fields.extend(inputs);
        shape.add_bodies();
        shape.drop_repeated_names();
        shape.quaternions = scalar_parts(declaration, &shape.coordinates);
        shape
    }

    fn add_bodies(&mut self) {
        let bodies = &self.declaration.bodies;
        if self.asks_for(Product::Motion) {
            let bodies = bodies.iter().filter(|body| !body.is_frame);
            self.bodies.extend(bodies.map(|body| &body.name));
        }
        if self.declaration.is_in_space && self.asks_for(Product::Frames) {
            self.frames.extend(bodies.iter().map(|body| &body.name));
        }
        if self.declaration.is_in_space && self.asks_for(Product::FrameJacobians) {
            self.frames_with_jacobian.extend(bodies.iter().map(|body| &body.name));
        }
    }

    fn add_event(&mut self, event: &'a Event) {
        let is_contact = matches!(event.action, Action::Impact(_));
        if is_contact {
            self.touching.push((&event.name, Touch::Contact));
        }
        if !(is_contact && self.shares_event) {
            self.events.push(event);
        }
    }

    /// Returns names and directions of all events: declared ones, then those of friction. Events
    /// that switch modes have no direction.
    pub(in crate::emit) fn event_names(&self) -> Vec<(&'a Name, Option<Direction>)> {
        let declared = self.events.iter().map(|event| match event.action {
            Action::Impact(_) => (&event.name, None),
            _ => (&event.name, Some(event.direction)),
        });
        let has_event = |touch: Touch| match self.shares_event {
            true => touch != Touch::Smooth,
            false => matches!(touch, Touch::Friction | Touch::Planar),
        };
        let others = self.touching.iter().filter(|(_, touch)| has_event(*touch));
        let most = if self.shares_event { 1 } else { usize::MAX };
        declared.chain(others.take(most).map(|(name, _)| (*name, None))).collect()
    }

    /// Returns the names of the fields that store modes.
    pub(in crate::emit) fn fields_of_modes(&self) -> impl Iterator<Item = &'a Name> {
        let with_mode = self.touching.iter().filter(|(_, touch)| *touch != Touch::Smooth);
        with_mode.map(|(name, _)| *name)
    }

    /// Returns the index of the event that changes the mode of each contact or friction, if it has
    /// one.
    pub(in crate::emit) fn events_of_reactions(&self) -> Vec<Option<usize>> {
        let names = self.event_names();
        let event = |(name, touch): &(&Name, Touch)| match self.shares_event {
            true => (*touch != Touch::Smooth).then_some(names.len() - 1),
            false => names.iter().position(|(other, _)| other.text == name.text),
        };
        self.touching.iter().map(event).collect()
    }

    /// Returns the index of the contact or friction of each reaction: friction in a plane has two
    /// reactions.
    pub(in crate::emit) fn reactions(&self) -> Vec<usize> {
        let count = |touch: Touch| if touch == Touch::Planar { 2 } else { 1 };
        let places = self.touching.iter().enumerate();
        places.flat_map(|(place, (_, touch))| std::iter::repeat_n(place, count(*touch))).collect()
    }

    /// True if a product emitted on demand is requested.
    pub(in crate::emit) fn asks_for(&self, product: Product) -> bool {
        self.declaration.asks_for(product.name())
    }

    /// Drops names declared twice. They are reported elsewhere; duplicate fields would be reported
    /// again.
    fn drop_repeated_names(&mut self) {
        let mut seen = HashSet::default();
        let mut velocities: HashSet<String> = HashSet::default();
        let mut first = |name: &Name| seen.insert(name.text.clone());
        self.fields.retain(|name| first(name));
        self.coordinates.retain(|name| first(name));
        let states = self.declaration.states().map(|name| name.text.as_str()).collect::<HashSet<_>>();
        self.states = self.coordinates.iter().filter(|name| states.contains(&name.text.as_str())).count();
        self.velocities.retain(|velocity| {
            let is_kept = |name: &Name| self.coordinates.iter().any(|kept| std::ptr::eq(*kept, name));
            velocity.coordinate.is_none_or(is_kept) && velocities.insert(velocity.name.text.clone())
        });
        self.touching.retain(|(name, _)| first(name));
        self.outputs.retain(|(name, _)| first(name));
        for list in [&mut self.bodies, &mut self.frames, &mut self.frames_with_jacobian] {
            let mut seen = seen.clone();
            list.retain(|name| seen.insert(name.text.clone()));
        }
    }

    /// Returns the kind of a field as text.
    pub(in crate::emit) fn kind_of_field(&self, name: &Name) -> &'static str {
        if self.is_input(name) { "Input" } else { "Parameter" }
    }

    /// True if a field is an input.
    pub(in crate::emit) fn is_input(&self, name: &Name) -> bool {
        self.inputs.contains(name.text.as_str())
    }

    /// Returns the user's documentation of a declared name, if there is any.
    pub(in crate::emit) fn users_docs(&self, name: &Name) -> Option<&'a TokenStream> {
        self.docs.get(&name.text.as_str()).copied()
    }

    /// True for a declared name documented by the user.
    pub(in crate::emit) fn is_documented(&self, name: &Name) -> bool {
        self.docs.contains(&name.text.as_str())
    }

    /// Returns the user's documentation of a body, or a default line.
    pub(in crate::emit) fn body_docs(&self, name: &Name, line: &str) -> TokenStream {
        self.user_docs(name).map_or_else(|| doc(line), Clone::clone)
    }

    /// Returns the user's documentation of a body or frame, if there is any.
    pub(in crate::emit) fn user_docs(&self, name: &Name) -> Option<&'a TokenStream> {
        let mut documented = self.declaration.bodies.iter().filter(|body| !body.docs.is_empty());
        documented.find(|body| body.name.text == name.text).map(|body| &body.docs)
    }

    /// Returns a name as written by the user: `theta[2]` for an element of an array.
    pub(in crate::emit) fn written<'n>(&'n self, name: &'n Name) -> &'n str {
        self.written.get(&name.text.as_str()).copied().unwrap_or(&name.text)
    }

    /// Returns the unit of a variable for messages; empty for plain numbers and unknown units.
    pub(in crate::emit) fn shown_unit(&self, name: &str) -> &str {
        let unit = self.units.get(name).map(|unit| unit.unit.as_str());
        unit.filter(|unit| *unit != "1").unwrap_or_default()
    }

    /// True if the struct needs a field only to mention its type parameter.
    pub(in crate::emit) fn needs_marker(&self) -> bool {
        self.fields.is_empty() && matches!(self.declaration.scalar, ScalarType::Generic(_))
    }

    /// Returns the user's names that occur in the methods' bodies in addition to the arguments.
    pub(in crate::emit) fn user_names(&self) -> Vec<String> {
        let velocities = self.velocities.iter().map(|velocity| velocity.name.text.clone());
        self.fields.iter().chain(&self.coordinates).map(|name| name.text.clone()).chain(velocities).collect()
    }
}

/// Returns the indices of the scalar parts of unit quaternions among the positions.
fn scalar_parts(declaration: &Declaration, positions: &[&Name]) -> Vec<usize> {
    let parts = declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Quaternion(quaternion) => {
            positions.iter().position(|name| std::ptr::eq(*name, &quaternion.positions[0]))
        }
        _ => None,
    });
    parts.collect()
}

/// Returns the shapes of expressions, judged by their syntax; scalars for invalid ones.
fn shapes_of_expressions(declaration: &Declaration) -> HashMap<AstId, ArrayShape> {
    let mut named = HashMap::default();
    for statement in &declaration.statements {
        if let StatementKind::Let(name, value) = &statement.kind {
            named.insert(name.text.clone(), *value);
        }
    }
    let mut shapes = HashMap::default();
    for (id, expression) in declaration.expressions.iter() {
        let known = |id: &AstId| shapes.get(id).copied().unwrap_or(ArrayShape::Scalar);
        let entry = |of: &AstId, indices: &[AstId]| {
            known(of).entry(&declaration.expressions.places(indices)?).map(|(_, shape)| shape)
        };
        let shape = match expression {
            Expression::Name(name) => named.get(name).map(known),
            Expression::Tuple(rows) => ArrayShape::stacked(&rows.iter().map(known).collect::<Vec<_>>()),
            Expression::Entry { of, indices, .. } => entry(of, indices),
            Expression::Negate(operand) => Some(known(operand)),
            Expression::Binary(BinaryOperator::Multiply, _, left, right) => known(left).times(known(right)),
            Expression::Binary(BinaryOperator::Power, ..) => None,
            Expression::Binary(_, _, left, _) => Some(known(left)),
            Expression::If { then, .. } => Some(known(then)),
            Expression::Call(function, arguments) => match (function.text.as_str(), arguments.first()) {
                ("dot" | "ddot", Some(argument)) => Some(known(argument)),
                ("cross", Some(argument)) if known(argument) == ArrayShape::Vector(3) => {
                    Some(known(argument))
                }
                ("transpose", Some(argument)) => known(argument).transposed(),
                _ => None,
            },
            Expression::Number(_)
            | Expression::Quantity(..)
            | Expression::Component(..)
            | Expression::Array(_)
            | Expression::Invalid => None,
        };
        shapes.insert(id, shape.unwrap_or(ArrayShape::Scalar));
    }
    shapes
}

fn written_names(declaration: &Declaration) -> HashMap<&str, &str> {
    let elements = declaration.arrays.iter().flat_map(|array| &array.elements);
    elements.map(|element| (element.name.as_str(), element.written.as_str())).collect()
}

fn documentation(declaration: &Declaration) -> HashMap<&str, &TokenStream> {
    let documented = declaration.statements.iter().filter(|statement| !statement.docs.is_empty());
    let names = documented.flat_map(|Statement { kind, docs, .. }| {
        kind.member_names().into_iter().map(move |name| (name.text.as_str(), docs))
    });
    names.collect()
}
