//! Bodies, lines, springs and joints in expressions.

use super::messages;
use super::object::{Body, Joint, Line, Object};
use super::plain::Obligation;
use super::translation::Translation;
use crate::syntax::ast::{AstId, Expression, Name};
use crate::syntax::foreign;

/// Functions whose first argument is a body, with the names of all of them; those in brackets may be left out.
const OF_BODIES: [(&str, &[&str]); 9] = [
    ("point", &["X", "Y"]),
    ("vector", &["X", "Y"]),
    ("angular_velocity", &[]),
    ("angular_acceleration", &[]),
    ("instant_center", &[]),
    ("linear_momentum", &[]),
    ("angular_momentum", &["[P]"]),
    ("tangential_acceleration", &["Q", "[P]"]),
    ("radial_acceleration", &["Q", "[P]"]),
];
/// Functions whose first argument is a line.
const OF_LINES: [(&str, &[&str]); 2] = [("distance", &["P"]), ("along", &["P"])];
/// Functions of points, with the function of the plain language that they are.
const OF_POINTS: [(&str, &str); 2] = [("velocity", "dot"), ("acceleration", "ddot")];

impl Translation<'_> {
    /// An expression in plain words.
    pub(super) fn plain(&mut self, root: AstId) -> AstId {
        let mut pending = vec![root];
        while let Some(&id) = pending.last() {
            let before = pending.len();
            if !self.translated.contains(&id) {
                // Reversed, so that mistakes are reported from left to right.
                let parts = self.parts(id).into_iter().rev();
                pending.extend(parts.filter(|part| !self.translated.contains(part)));
            }
            if pending.len() == before {
                pending.pop();
                if !self.translated.contains(&id) {
                    let plain = self.plain_node(id);
                    self.translated.insert(id, plain);
                }
            }
        }
        self.become_of(root)
    }

    /// A point: where a body's name stands, its centre of mass is meant.
    pub(super) fn place(&mut self, id: AstId) -> AstId {
        match self.body_named(id) {
            Some(body) => self.bodies[body].center,
            None => self.plain(id),
        }
    }

    /// A point in the plane.
    pub(super) fn plane_point(&mut self, id: AstId, what: &str) -> AstId {
        let value = self.place(id);
        self.obligations.push(Obligation::PlaneVector { what: what.to_owned(), value });
        value
    }

    /// An angle: that of a body, zero for the ground, or any expression but a point.
    pub(super) fn turning(&mut self, id: AstId) -> AstId {
        if let Some(body) = self.body_named(id) {
            return self.bodies[body].angle;
        }
        if self.is_ground(id) {
            return self.terms().number(0);
        }
        let angle = self.plain(id);
        match self.is_point(id) {
            true => {
                let origin = self.expressions.origin(id);
                self.report.error(origin, messages::NO_ANGLE).help(messages::NO_ANGLE_HELP);
                self.terms().invalid()
            }
            false => angle,
        }
    }

    /// Whether the ground is meant: nothing was given its name but a line.
    pub(super) fn is_ground(&self, id: AstId) -> bool {
        let Expression::Name(name) = self.expressions.get(id) else { return false };
        name == "ground" && !self.names.is_declared(name)
    }

    /// Whether an expression shows by its form that it is a point.
    fn is_point(&self, id: AstId) -> bool {
        matches!(self.expressions.get(id), Expression::Tuple(_)) || self.body_of(id).is_some()
    }

    /// Whether an expression, as the user wrote it, is made of parameters and numbers only.
    pub(super) fn is_at_rest(&self, id: AstId) -> bool {
        let mut pending = vec![id];
        while let Some(id) = pending.pop() {
            match self.expressions.get(id) {
                Expression::Name(name) if !self.names.is_fixed(name) => return false,
                other => pending.extend(operands(other)),
            }
        }
        true
    }

    fn become_of(&self, id: AstId) -> AstId {
        self.translated.get(&id).copied().unwrap_or(id)
    }

    /// The parts of an expression that are translated before it: not the names of bodies where these belong.
    fn parts(&self, id: AstId) -> Vec<AstId> {
        let is_object = |id: &AstId| matches!(self.expressions.get(*id), Expression::Name(name) if self.names.find(name).is_some());
        match self.expressions.get(id) {
            Expression::Call(function, arguments) if is_of_scene(&function.text) => {
                arguments.iter().copied().filter(|argument| !is_object(argument)).collect()
            }
            Expression::Component(of, _) if is_object(of) => Vec::new(),
            other => operands(other),
        }
    }

    fn plain_node(&mut self, id: AstId) -> AstId {
        let before = std::mem::replace(&mut self.origin, self.expressions.origin(id));
        let plain = match self.expressions.get(id).clone() {
            Expression::Name(name) => self.plain_name(&name, id),
            Expression::Component(of, part) => match self.object(of) {
                Some((name, object)) => self.part_of(&name, &object, &part),
                None => self.rebuilt(id),
            },
            Expression::Call(function, arguments) if is_of_scene(&function.text) => {
                self.plain_call(&function, &arguments, id)
            }
            _ => self.rebuilt(id),
        };
        self.origin = before;
        plain
    }

    /// A name on its own must have a value.
    fn plain_name(&mut self, name: &str, id: AstId) -> AstId {
        if let Some(object) = self.names.find(name) {
            let message = messages::no_value(name, object.describe());
            self.report.error(self.origin, message).help(messages::value_help(name, object));
            return self.terms().invalid();
        }
        match self.report_early(name) {
            true => self.terms().invalid(),
            false => id,
        }
    }

    /// Reports a name that is declared further down.
    pub(super) fn report_early(&mut self, name: &str) -> bool {
        let Some(declared) = self.names.anywhere(name).filter(|_| self.names.find(name).is_none()) else {
            return false;
        };
        let declared = declared.span;
        if self.early.insert(name.to_owned(), ()).is_some() {
            return true;
        }
        let error = self.report.error(self.origin, messages::used_too_early(name)).help(messages::ORDER_HELP);
        error.related(declared.into(), messages::DECLARED_HERE);
        true
    }

    /// The same expression of what became of its parts.
    fn rebuilt(&mut self, id: AstId) -> AstId {
        let expression = self.expressions.get(id).clone();
        let parts = operands(&expression);
        let plain = parts.iter().map(|&part| self.become_of(part)).collect::<Vec<_>>();
        if plain == parts {
            return id;
        }
        let expression = with_operands(expression, &plain);
        self.terms().add_node(expression)
    }

    /// The object that an expression names.
    fn object(&self, id: AstId) -> Option<(String, Object)> {
        let Expression::Name(name) = self.expressions.get(id) else { return None };
        self.names.find(name).map(|object| (name.clone(), object.clone()))
    }

    /// `rod.center` and its kin.
    fn part_of(&mut self, name: &str, object: &Object, part: &Name) -> AstId {
        let found = match object {
            Object::Body(body) => self.part_of_body(*body, &part.text),
            Object::Line(line) => self.part_of_line(*line, &part.text),
            Object::Connector(connector) => match part.text.as_str() {
                "length" => Some(connector.length),
                "force" => Some(connector.tension),
                _ => None,
            },
            Object::Joint(Joint { force, parts }) => {
                let found = match part.text.as_str() {
                    "force" => Some(*force),
                    part => parts.iter().find(|(name, _)| *name == part).map(|(_, id)| *id),
                };
                // Here, and not at the joint, it is missed if the coordinates fulfil the joint by themselves.
                found.map(|force| self.terms().repeated(force))
            }
        };
        found.unwrap_or_else(|| {
            let message = messages::no_part(name, object.describe(), &part.text);
            let meant = object.owner().and_then(|owner| foreign::part((owner, name), &part.text));
            let help =
                meant.map_or_else(|| messages::value_help(name, object), |part| messages::write(&part));
            self.report.error(part.span, message).help(help);
            self.terms().invalid()
        })
    }

    fn part_of_body(&mut self, body: usize, part: &str) -> Option<AstId> {
        let Body { mass, inertia, center, origin, angle, .. } = self.bodies[body].clone();
        match part {
            "mass" => Some(mass),
            "inertia" => Some(inertia),
            "center" => Some(center),
            "origin" => Some(self.terms().tuple(origin)),
            "angle" => Some(angle),
            _ => None,
        }
    }

    fn part_of_line(&mut self, line: usize, part: &str) -> Option<AstId> {
        let Line { angle, .. } = self.lines[line];
        let mut terms = self.terms();
        let [tangent, normal] = terms.axes(angle);
        match part {
            "tangent" => Some(terms.tuple(tangent)),
            "normal" => Some(terms.tuple(normal)),
            "angle" => Some(angle),
            _ => None,
        }
    }

    fn plain_call(&mut self, function: &Name, arguments: &[AstId], id: AstId) -> AstId {
        if let Some((_, plain)) = OF_POINTS.iter().find(|(name, _)| *name == function.text) {
            if let [point] = arguments
                && self.is_at_rest(*point)
            {
                let message = messages::point_at_rest(&function.text);
                self.report.error(self.origin, message).help(messages::POINT_AT_REST_HELP);
                return self.terms().invalid();
            }
            let arguments = arguments.iter().map(|&point| self.place(point)).collect::<Vec<_>>();
            return self.terms().call(plain, &arguments);
        }
        let row = OF_BODIES.iter().chain(&OF_LINES).find(|(name, _)| *name == function.text);
        let Some((_, wanted)) = row else { return self.rebuilt(id) };
        let Some((first, rest)) = arguments.split_first() else {
            return self.wrong_count(function, wanted, 0);
        };
        let needed = wanted.iter().filter(|name| !name.starts_with('[')).count();
        if !(needed..=wanted.len()).contains(&rest.len()) {
            return self.wrong_count(function, wanted, rest.len());
        }
        let is_of_lines = OF_LINES.iter().any(|(name, _)| *name == function.text);
        match self.object(*first) {
            Some((_, Object::Body(body))) if !is_of_lines => self.of_body(body, &function.text, rest),
            Some((_, Object::Line(line))) if is_of_lines => self.of_line(line, &function.text, rest),
            _ => self.not_an_object(function, *first, is_of_lines),
        }
    }

    fn wrong_count(&mut self, function: &Name, wanted: &[&str], count: usize) -> AstId {
        let message = messages::wrong_arguments(&function.text, count);
        self.report.error(self.origin, message).help(messages::usage(&function.text, wanted));
        self.terms().invalid()
    }

    /// `point` of something that is no body.
    fn not_an_object(&mut self, function: &Name, first: AstId, is_of_lines: bool) -> AstId {
        let what = if is_of_lines { "a line" } else { "a body" };
        let name = match self.expressions.get(first) {
            Expression::Name(name) => Some(name.clone()),
            _ => None,
        };
        let was_reported = matches!(self.expressions.get(self.become_of(first)), Expression::Invalid);
        if !was_reported {
            let accept = |object: &Object| matches!(object, Object::Line(_)) == is_of_lines;
            let nearest = name.as_ref().and_then(|name| self.names.nearest(name, accept));
            let help = messages::object_help(&function.text, what, nearest);
            let message = messages::not_an_object(&function.text, what, name.as_deref());
            self.report.error(self.expressions.origin(first), message).help(help);
        }
        self.terms().invalid()
    }
}

fn is_of_scene(function: &str) -> bool {
    let rows = OF_BODIES.iter().chain(&OF_LINES).map(|(name, _)| *name);
    rows.chain(OF_POINTS.iter().map(|(name, _)| *name)).any(|name| name == function)
}

fn operands(expression: &Expression) -> Vec<AstId> {
    match expression {
        Expression::Number(_) | Expression::Name(_) | Expression::Invalid => Vec::new(),
        Expression::Tuple(parts) | Expression::Call(_, parts) => parts.clone(),
        Expression::Negate(of) | Expression::Component(of, _) => vec![*of],
        Expression::Binary(_, _, a, b) => vec![*a, *b],
        Expression::If { condition, then, otherwise } => {
            vec![condition.left, condition.right, *then, *otherwise]
        }
    }
}

/// The expression with other operands, in the order of [`operands`].
fn with_operands(expression: Expression, parts: &[AstId]) -> Expression {
    match expression {
        Expression::Tuple(_) => Expression::Tuple(parts.to_vec()),
        Expression::Call(function, _) => Expression::Call(function, parts.to_vec()),
        Expression::Negate(_) => Expression::Negate(parts[0]),
        Expression::Component(_, name) => Expression::Component(parts[0], name),
        Expression::Binary(operator, span, ..) => Expression::Binary(operator, span, parts[0], parts[1]),
        Expression::If { mut condition, .. } => {
            (condition.left, condition.right) = (parts[0], parts[1]);
            Expression::If { condition, then: parts[2], otherwise: parts[3] }
        }
        leaf => leaf,
    }
}
