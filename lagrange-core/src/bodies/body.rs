//! `body` and `line` statements.

use super::messages;
use super::object::{Body, Line, Object};
use super::plain::{Drawn, DrawnKind, Motion, Obligation, Outline};
use super::terms::{Pair, TermWriter};
use super::translation::Translation;
use crate::diagnostics::Origin;
use crate::solids;
use crate::solids::Solid;
use crate::syntax::ast::{AstId, Shape, StatementKind};
use crate::syntax::{ast, foreign};

/// How the mass of a body is distributed.
pub(super) struct MassGeometry {
    pub(super) mass: AstId,
    /// `None` if nothing says it.
    pub(super) inertia: Option<AstId>,
    pub(super) centroid: Pair,
    pub(super) outlines: Vec<Outline>,
    pub(super) radius: Option<AstId>,
}

impl Translation<'_> {
    pub(super) fn body(&mut self, statement: &ast::Body) {
        let name = &statement.name;
        let angle = self.body_angle(statement);
        let geometry = match statement.parts.is_empty() {
            true => self.simple(statement),
            false => self.compound(statement),
        };
        let MassGeometry { mass, inertia, centroid, outlines, radius } = geometry;
        let (center, origin) = self.body_place(statement, centroid, angle);
        self.push_translation(mass, center);
        let inertia = inertia.unwrap_or_else(|| self.terms().number(0));
        self.obligations.push(Obligation::Inertia { body: name.clone(), inertia });
        if statement.angle.is_some() {
            self.push_rotation(inertia, angle);
        }
        let index = self.bodies.len();
        let centroid_vector = self.terms().tuple(centroid);
        self.motions.push(Motion {
            body: name.clone(),
            center,
            centroid: centroid_vector,
            angle,
            mass,
            inertia,
        });
        let kind = DrawnKind::Body { body: index, outlines };
        self.drawing.push(Drawn { kind, values: Vec::new(), needs: Vec::new() });
        self.bodies.push(Body { name: name.clone(), mass, inertia, center, origin, angle, radius });
        self.names.declare(&name.text, Object::Body(index));
        self.weigh(index);
    }

    /// The angle, under a name of its own unless it is one.
    fn body_angle(&mut self, statement: &ast::Body) -> AstId {
        let Some(angle) = statement.angle else { return self.terms().number(0) };
        let angle = self.turning(angle);
        self.mentioned.push(angle);
        match self.expressions.get(angle) {
            ast::Expression::Name(_) | ast::Expression::Number(_) | ast::Expression::Invalid => angle,
            _ => self.bind(&format!("{}_angle", statement.name.text), angle),
        }
    }

    /// What the user wrote, in plain words; it is looked at, whether or not it is needed.
    pub(super) fn mention(&mut self, id: AstId) -> AstId {
        let plain = self.plain(id);
        self.mentioned.push(plain);
        plain
    }

    /// What the user wrote of how mass is distributed.
    pub(super) fn property(&mut self, id: AstId, what: &str) -> AstId {
        let value = self.mention(id);
        self.obligations.push(Obligation::Fixed { what: what.to_owned(), value });
        value
    }

    fn simple(&mut self, statement: &ast::Body) -> MassGeometry {
        let name = &statement.name;
        let mass = self.mass(statement);
        let shape = statement.shape.as_ref().and_then(|shape| self.shape(shape));
        let place = statement.shape.as_ref().map_or(self.origin, |shape| shape.origin);
        let of_shape =
            shape.as_ref().map(|(solid, dimensions)| self.inertia_of(solid, mass, dimensions, place));
        let stated = statement.inertia.map(|j| self.property(j, &messages::inertia_of(&name.text)));
        if let (Some(stated), Some(of_shape), Some(shape)) = (stated, of_shape, &statement.shape) {
            let obligation =
                Obligation::SameInertia { body: name.clone(), stated, of_shape, shape: shape.origin };
            self.obligations.push(obligation);
        }
        if stated.is_none() && statement.angle.is_some() {
            self.report_unknown_inertia(statement);
        }
        let centroid = match statement.centroid {
            Some(centroid) => self.fixed_vector(centroid, &messages::centroid_of(&name.text)),
            None => self.named_centroid(&name.text, shape.as_ref(), place),
        };
        let radius = shape.as_ref().and_then(|(solid, dimensions)| Some(dimensions[solid.radius?]));
        let outlines = shape.map(|(solid, dimensions)| self.outline(solid, dimensions)).into_iter().collect();
        MassGeometry { mass, inertia: stated.or(of_shape), centroid, outlines, radius }
    }

    /// Reports a body that turns and states no moment of inertia, unless that of its shape is the one about its centre of mass.
    fn report_unknown_inertia(&mut self, statement: &ast::Body) {
        let name = &statement.name;
        match (&statement.shape, statement.centroid) {
            (None, _) => {
                let error = self.report.error(name.span, messages::no_inertia(&name.text));
                error.help(messages::NO_INERTIA_HELP);
            }
            (Some(_), Some(centroid)) => {
                let origin = self.expressions.origin(centroid);
                let error = self.report.error(origin, messages::unknown_inertia(&name.text));
                error.help(messages::UNKNOWN_INERTIA_HELP);
            }
            (Some(_), None) => {}
        }
    }

    fn mass(&mut self, statement: &ast::Body) -> AstId {
        let name = &statement.name;
        let Some(mass) = statement.mass else {
            let error = self.report.error(name.span, messages::no_mass(&name.text));
            error.help(messages::NO_MASS_HELP);
            return self.terms().invalid();
        };
        let mass = self.property(mass, &messages::mass_of(&name.text));
        self.obligations.push(Obligation::PositiveMass { body: name.clone(), mass });
        mass
    }

    /// A known solid with its dimensions, as many as it has; anything else is reported.
    pub(super) fn shape(&mut self, shape: &Shape) -> Option<(&'static Solid, Vec<AstId>)> {
        let what = messages::dimension_of(&shape.solid.text);
        let dimensions = shape.dimensions.iter().map(|&id| self.property(id, &what)).collect::<Vec<_>>();
        let Some(solid) = solids::by_name(&shape.solid.text) else {
            let known = foreign::solid(&shape.solid.text).or_else(|| solids::nearest(&shape.solid.text));
            let help = match known {
                Some(known) => messages::did_you_mean(known),
                None => messages::solids_are(),
            };
            self.report.error(shape.solid.span, messages::unknown_solid(&shape.solid.text)).help(help);
            return None;
        };
        if !solid.dimensions.accept(dimensions.len()) {
            let message = messages::wrong_dimensions(&shape.solid.text, dimensions.len());
            self.report.error(shape.origin, message).help(messages::shape_usage(&solid.shape_usage()));
            return None;
        }
        Some((solid, dimensions))
    }

    /// The call that stands for the moment of inertia of a solid about its centre of mass, blamed on `place`.
    pub(super) fn inertia_of(
        &mut self,
        solid: &Solid,
        mass: AstId,
        dimensions: &[AstId],
        place: Origin,
    ) -> AstId {
        let arguments = [&[mass], dimensions].concat();
        TermWriter::new(&mut self.expressions, place).call(solid.name, &arguments)
    }

    /// The centre of mass of a solid in its own coordinates, blamed on `place`.
    fn centroid_of(&mut self, shape: Option<&(&'static Solid, Vec<AstId>)>, place: Origin) -> Pair {
        let center = shape.and_then(|(solid, dimensions)| Some((solid.center_function()?, dimensions)));
        let mut terms = TermWriter::new(&mut self.expressions, place);
        match center {
            Some((function, dimensions)) => {
                let center = terms.call(&function, dimensions);
                terms.pair(center)
            }
            None => terms.zero_pair(),
        }
    }

    /// The centre of mass of a solid, under a name of its own where it is computed.
    pub(super) fn named_centroid(
        &mut self,
        name: &str,
        shape: Option<&(&'static Solid, Vec<AstId>)>,
        place: Origin,
    ) -> Pair {
        let centroid = self.centroid_of(shape, place);
        match *self.expressions.get(centroid[0]) {
            ast::Expression::Component(center, _) => {
                let center = self.bind(&format!("{name}_centroid"), center);
                self.terms().pair(center)
            }
            _ => centroid,
        }
    }

    fn outline(&mut self, solid: &'static Solid, dimensions: Vec<AstId>) -> Outline {
        let mut terms = self.terms();
        let (at, angle) = (terms.zero_pair(), terms.number(0));
        Outline { solid: solid.name.to_owned(), dimensions, at: terms.tuple(at), angle, is_hole: false }
    }

    /// The centre of mass under a name of its own, and the origin of the own coordinates.
    fn body_place(&mut self, statement: &ast::Body, centroid: Pair, angle: AstId) -> (AstId, Pair) {
        let name = &statement.name.text;
        let stated = match (statement.center, statement.origin) {
            (Some(center), None) => Some((self.vector(center, &messages::center_of(name)), true)),
            (None, Some(origin)) => Some((self.own_origin(name, origin), false)),
            (given, _) => {
                let message = messages::one_place(name, given.is_some());
                self.report.error(statement.name.span, message).help(messages::ONE_PLACE_HELP);
                None
            }
        };
        let mut terms = self.terms();
        let Some((place, is_center)) = stated else {
            let invalid = terms.invalid();
            return (invalid, [invalid, invalid]);
        };
        let arm = terms.turned(centroid, angle);
        let center = if is_center { place } else { terms.plus_pair(place, arm) };
        let center = terms.tuple(center);
        let center = self.bind(&format!("{name}_center"), center);
        self.note_place(center, &messages::place_of(name));
        let mut terms = self.terms();
        let origin = match is_center {
            true => {
                let center = terms.pair(center);
                terms.minus_pair(center, arm)
            }
            false => place,
        };
        self.obligations.push(Obligation::Moves { body: statement.name.clone(), center, angle });
        (center, origin)
    }

    /// The components of a vector of own coordinates, which does not change.
    pub(super) fn fixed_vector(&mut self, id: AstId, what: &str) -> Pair {
        let components = self.vector(id, what);
        let value = self.plain(id);
        self.obligations.push(Obligation::Fixed { what: what.to_owned(), value });
        components
    }

    /// The components of what the user wrote as a vector in the plane.
    pub(super) fn vector(&mut self, id: AstId, what: &str) -> Pair {
        let value = self.mention(id);
        self.obligations.push(Obligation::PlaneVector { what: what.to_owned(), value });
        self.terms().pair(value)
    }

    /// Where the own coordinates begin, under a name of its own if it is not written by components.
    fn own_origin(&mut self, name: &str, origin: AstId) -> Pair {
        let components = self.vector(origin, &messages::origin_of(name));
        match self.expressions.get(components[0]) {
            ast::Expression::Component(..) => {
                let origin = self.plain(origin);
                let origin = self.bind(&format!("{name}_origin"), origin);
                self.note_place(origin, &messages::place_of(name));
                self.terms().pair(origin)
            }
            _ => components,
        }
    }

    fn push_translation(&mut self, mass: AstId, center: AstId) {
        let mut terms = self.terms();
        let velocity = terms.call("dot", &[center]);
        let kinetic = terms.call("kinetic_energy", &[mass, velocity]);
        self.push(StatementKind::Kinetic(kinetic));
    }

    fn push_rotation(&mut self, inertia: AstId, angle: AstId) {
        let mut terms = self.terms();
        let rate = terms.rate(angle);
        if !terms.is_zero(rate) && !terms.is_zero(inertia) {
            let kinetic = terms.call("kinetic_energy", &[inertia, rate]);
            self.push(StatementKind::Kinetic(kinetic));
        }
    }

    pub(super) fn line(&mut self, statement: ast::Line) {
        let through = match statement.through {
            Some(through) => self.vector(through, &messages::through_of(&statement.name.text)),
            None => self.terms().zero_pair(),
        };
        let angle = match statement.angle {
            Some(angle) => self.mention(angle),
            None => self.terms().number(0),
        };
        let body = statement.on.as_ref().and_then(|on| self.carrier(on));
        let (through, angle) = match body {
            Some(body) => {
                let turned = self.bodies[body].angle;
                (self.point(body, through), self.terms().plus(turned, angle))
            }
            None => (through, angle),
        };
        let name = statement.name.text;
        let point = self.terms().tuple(through);
        let carrier = body.map(|body| self.bodies[body].name.text.clone());
        let kind = DrawnKind::Line { name: name.clone(), body: carrier };
        self.drawing.push(Drawn { kind, values: vec![point, angle], needs: Vec::new() });
        self.names.declare(&name, Object::Line(self.lines.len()));
        self.lines.push(Line { body, through, angle });
    }

    /// The body of a name that must be one's.
    pub(super) fn carrier(&mut self, name: &ast::Name) -> Option<usize> {
        match self.names.find(&name.text) {
            Some(Object::Body(body)) => Some(*body),
            other => {
                let found = other.map(Object::describe);
                self.report_no_object(name, "a body", found, |object| matches!(object, Object::Body(_)));
                None
            }
        }
    }

    /// The line of a name that must be one's.
    pub(super) fn track(&mut self, name: &ast::Name) -> Option<usize> {
        match self.names.find(&name.text) {
            Some(Object::Line(line)) => Some(*line),
            other => {
                let found = other.map(Object::describe);
                self.report_no_object(name, "a line", found, |object| matches!(object, Object::Line(_)));
                None
            }
        }
    }

    fn report_no_object(
        &mut self,
        name: &ast::Name,
        wanted: &str,
        found: Option<&str>,
        accept: impl Fn(&Object) -> bool,
    ) {
        let before = std::mem::replace(&mut self.origin, name.span.into());
        if !self.report_early(&name.text) {
            let help = match self.names.nearest(&name.text, accept) {
                Some(nearest) => messages::did_you_mean(nearest),
                None => messages::declare_object(wanted),
            };
            let message = messages::other_object(&name.text, wanted, found);
            self.report.error(name.span, message).help(help);
        }
        self.origin = before;
    }
}
