//! The statements of a declaration, one by one, in plain words.

use super::messages;
use super::names::SceneNames;
use super::object::{Body, Line, Object};
use super::plain::{Drawn, DrawnKind, LoadOrigin, Motion, Obligation, Plain};
use super::terms::{Pair, TermWriter};
use crate::collections::HashMap;
use crate::diagnostics::{Origin, Report};
use crate::syntax::ast::{
    Action, AstId, Declaration, Definition, Event, Expression, Expressions, Friction, Name, SceneStatement,
    Statement, StatementKind,
};

/// A translation in progress.
pub(super) struct Translation<'a> {
    pub(super) report: &'a mut Report,
    pub(super) expressions: Expressions,
    pub(super) names: SceneNames,
    pub(super) bodies: Vec<Body>,
    pub(super) lines: Vec<Line>,
    /// Plain statements so far.
    pub(super) statements: Vec<Statement>,
    /// The statement that is being translated.
    pub(super) origin: Origin,
    gravity: Option<(Pair, Origin)>,
    /// Bodies to which points belong that `let` names.
    pub(super) points: HashMap<String, usize>,
    /// Names of which it was reported that they are used too early.
    pub(super) early: HashMap<String, ()>,
    /// What expressions became.
    pub(super) translated: HashMap<AstId, AstId>,
    pub(super) motions: Vec<Motion>,
    pub(super) drawing: Vec<Drawn>,
    /// Forces and moments, which are drawn last.
    pub(super) loads: Vec<Drawn>,
    pub(super) obligations: Vec<Obligation>,
    pub(super) joints: Vec<Name>,
    /// Names of `let`s that are places, with what they are places of.
    pub(super) places: Vec<(String, String)>,
    /// Where the declaration gives a Lagrangian.
    lagrangian: Option<Origin>,
    /// Everything the user wrote in statements about bodies.
    pub(super) mentioned: Vec<AstId>,
}

impl<'a> Translation<'a> {
    pub(super) fn new(declaration: &mut Declaration, report: &'a mut Report) -> Translation<'a> {
        Translation {
            report,
            names: SceneNames::new(declaration),
            expressions: std::mem::take(&mut declaration.expressions),
            bodies: Vec::new(),
            lines: Vec::new(),
            statements: Vec::new(),
            origin: declaration.name.span.into(),
            gravity: None,
            points: HashMap::default(),
            early: HashMap::default(),
            translated: HashMap::default(),
            motions: Vec::new(),
            drawing: Vec::new(),
            loads: Vec::new(),
            obligations: Vec::new(),
            joints: Vec::new(),
            places: Vec::new(),
            lagrangian: lagrangian(declaration),
            mentioned: Vec::new(),
        }
    }

    /// Translates all statements.
    pub(super) fn finish(mut self, mut declaration: Declaration) -> Plain {
        for statement in std::mem::take(&mut declaration.statements) {
            self.origin = statement.origin;
            self.statement(statement);
        }
        self.report_idle_gravity();
        self.drawing.append(&mut self.loads);
        Plain {
            declaration: Declaration {
                statements: self.statements,
                expressions: self.expressions,
                ..declaration
            },
            motions: self.motions,
            drawing: self.drawing,
            obligations: self.obligations,
            joints: self.joints,
            places: self.places,
            mentioned: self.mentioned,
        }
    }

    fn statement(&mut self, statement: Statement) {
        match statement.kind {
            StatementKind::Scene(scene) => self.scene(scene),
            StatementKind::ForceAt { force, point } => self.force_at(force, point, statement),
            StatementKind::Torque { moment, angle } => self.torque(moment, angle, statement),
            kind => {
                if let StatementKind::Let(name, value) = &kind
                    && let Some(body) = self.body_of(*value)
                {
                    self.points.insert(name.text.clone(), body);
                }
                let kind = self.with_plain_expressions(kind);
                self.statements.push(Statement { kind, ..statement });
            }
        }
    }

    fn scene(&mut self, statement: SceneStatement) {
        self.report_beside_lagrangian(&statement);
        match statement {
            SceneStatement::Gravity(value) => self.gravity(value),
            SceneStatement::Body(body) => self.body(&body),
            SceneStatement::Line(line) => self.line(line),
            SceneStatement::Connector(connector) => self.connector(&connector),
            SceneStatement::Joint(joint) => self.joint(&joint),
        }
    }

    /// A Lagrangian says it all: no energy can be added to it.
    fn report_beside_lagrangian(&mut self, statement: &SceneStatement) {
        let Some(lagrangian) = self.lagrangian else { return };
        let (what, origin) = match statement {
            SceneStatement::Body(body) => (format!("body `{}`", body.name.text), body.name.span.into()),
            SceneStatement::Connector(connector) => (format!("`{}`", connector.kind.name()), self.origin),
            _ => return,
        };
        let error = self.report.error(origin, messages::beside_lagrangian(&what));
        error.related(lagrangian, messages::FIRST_DECLARED).help(messages::BESIDE_LAGRANGIAN_HELP);
    }

    /// Every body feels gravity, wherever it is declared.
    fn gravity(&mut self, value: AstId) {
        let value = self.plain(value);
        if let Some((_, first)) = self.gravity {
            let error = self.report.error(self.origin, messages::GRAVITY_TWICE);
            error.related(first, messages::FIRST_DECLARED).help(messages::GRAVITY_TWICE_HELP);
            return;
        }
        self.obligations.push(Obligation::PlaneVector { what: "gravity".to_owned(), value });
        self.obligations.push(Obligation::Uniform { gravity: value });
        self.mentioned.push(value);
        let gravity = self.terms().pair(value);
        self.gravity = Some((gravity, self.origin));
        for body in 0..self.bodies.len() {
            self.weigh(body);
        }
    }

    /// Only bodies have weight: hand-written energies do not fall.
    fn report_idle_gravity(&mut self) {
        let Some((_, origin)) = self.gravity.filter(|_| self.bodies.is_empty()) else { return };
        if !self.report.has_errors() {
            self.report.error(origin, messages::IDLE_GRAVITY).help(messages::IDLE_GRAVITY_HELP);
        }
    }

    /// The potential −m g·c of a body and its weight, if there is gravity.
    pub(super) fn weigh(&mut self, index: usize) {
        let Some((gravity, _)) = self.gravity else { return };
        let Body { name, mass, center, .. } = self.bodies[index].clone();
        let mut terms = self.terms();
        let center_pair = terms.pair(center);
        let weighed = [0, 1].map(|axis| {
            let weight = terms.times(mass, gravity[axis]);
            terms.times(weight, center_pair[axis])
        });
        let sum = terms.plus(weighed[0], weighed[1]);
        let potential = terms.negative(sum);
        let force = terms.scale(mass, gravity);
        let force = terms.tuple(force);
        if !terms.is_zero(potential) {
            self.push(StatementKind::Potential(potential));
        }
        let kind = DrawnKind::Force {
            name: "gravity".to_owned(),
            cause: LoadOrigin::Gravity,
            body: Some(name.text),
        };
        self.loads.push(Drawn { kind, values: vec![center, force], needs: Vec::new() });
    }

    fn force_at(&mut self, force: AstId, point: AstId, statement: Statement) {
        let body = self.body_of(point);
        let (force, point) = (self.plain(force), self.place(point));
        if self.is_in_plane(force) && !self.bodies.is_empty() {
            let (name, body) = ("force".to_owned(), body.map(|body| self.bodies[body].name.text.clone()));
            let kind = DrawnKind::Force { name, cause: LoadOrigin::Applied, body };
            self.loads.push(Drawn { kind, values: vec![point, force], needs: Vec::new() });
        }
        self.statements.push(Statement { kind: StatementKind::ForceAt { force, point }, ..statement });
    }

    /// Not written as a vector in space.
    fn is_in_plane(&self, force: AstId) -> bool {
        !matches!(self.expressions.get(force), Expression::Tuple(components) if components.len() != 2)
    }

    fn torque(&mut self, moment: AstId, angle: AstId, statement: Statement) {
        let body = self.body_named(angle);
        let written = angle;
        let (moment, angle) = (self.plain(moment), self.turning(angle));
        if self.terms().is_zero(angle) {
            self.report_no_turning(written, messages::TURNED_BY_TORQUE);
        }
        if let Some(body) = body {
            let Body { name, center, .. } = self.bodies[body].clone();
            let kind = DrawnKind::Moment {
                name: "torque".to_owned(),
                cause: LoadOrigin::Applied,
                body: Some(name.text),
            };
            self.loads.push(Drawn { kind, values: vec![center, moment], needs: Vec::new() });
        } else if !self.bodies.is_empty() {
            let of = |id| match self.expressions.get(id) {
                Expression::Name(name) => format!("`{name}`"),
                _ => "an angle".to_owned(),
            };
            let kind = DrawnKind::Torque { name: format!("torque on {}", of(written)) };
            self.loads.push(Drawn { kind, values: vec![moment, angle], needs: Vec::new() });
        }
        self.statements.push(Statement { kind: StatementKind::Torque { moment, angle }, ..statement });
    }

    /// Reports something that never turns where something that does is needed.
    pub(super) fn report_no_turning(&mut self, what: AstId, purpose: &str) {
        let name = match self.expressions.get(what) {
            Expression::Name(name) => format!("`{name}`"),
            _ => messages::THIS.to_owned(),
        };
        let origin = self.expressions.origin(what);
        let error = self.report.error(origin, messages::does_not_turn(&name, purpose));
        error.help(messages::DOES_NOT_TURN_HELP);
    }

    /// The statement with every expression in plain words.
    fn with_plain_expressions(&mut self, kind: StatementKind) -> StatementKind {
        use StatementKind as Kind;
        let mut plain = |id: AstId| self.plain(id);
        match kind {
            Kind::Parameters(list) => Kind::Parameters(definitions(list, plain)),
            Kind::Inputs(list) => Kind::Inputs(definitions(list, plain)),
            Kind::Constants(list) => Kind::Constants(definitions(list, plain)),
            Kind::Let(name, value) => Kind::Let(name, plain(value)),
            Kind::LetTuple(names, value) => Kind::LetTuple(names, plain(value)),
            Kind::Kinetic(value) => Kind::Kinetic(plain(value)),
            Kind::Potential(value) => Kind::Potential(plain(value)),
            Kind::Lagrangian(value) => Kind::Lagrangian(plain(value)),
            Kind::Dissipation(value) => Kind::Dissipation(plain(value)),
            Kind::ForceOn(name, value) => Kind::ForceOn(name, plain(value)),
            Kind::Constraint(name, value) => Kind::Constraint(name, plain(value)),
            Kind::Stabilise(value) => Kind::Stabilise(plain(value)),
            Kind::Output(name, value) => Kind::Output(name, plain(value)),
            Kind::Event(event) => Kind::Event(with_plain_event(event, plain)),
            Kind::Friction(friction) => Kind::Friction(Friction {
                slip: plain(friction.slip),
                kinetic: plain(friction.kinetic),
                fixed: friction.fixed.map(&mut plain),
                width: friction.width.map(&mut plain),
                ..friction
            }),
            Kind::Reduce(mut reduction) => {
                for item in &mut reduction.items {
                    item.value = item.value.map(&mut plain);
                }
                Kind::Reduce(reduction)
            }
            // These have been translated before.
            Kind::ForceAt { .. } | Kind::Torque { .. } | Kind::Scene(_) => kind,
            Kind::Coordinates(_) | Kind::Emit(_) => kind,
        }
    }

    /// Writes expressions for the current statement.
    pub(super) fn terms(&mut self) -> TermWriter<'_> {
        TermWriter::new(&mut self.expressions, self.origin)
    }

    /// Adds a plain statement in the place of the current one.
    pub(super) fn push(&mut self, kind: StatementKind) {
        if self.lagrangian.is_some()
            && matches!(kind, StatementKind::Kinetic(_) | StatementKind::Potential(_))
        {
            // That was reported.
            return;
        }
        let docs = proc_macro2::TokenStream::new();
        self.statements.push(Statement { kind, origin: self.origin, docs });
    }

    /// `let` of a new name like `wish`; the name.
    pub(super) fn bind(&mut self, wish: &str, value: AstId) -> AstId {
        let name = self.new_name(wish);
        let mentioned = self.terms().name(&name.text);
        self.push(StatementKind::Let(name, value));
        mentioned
    }

    /// Remembers that a `let` is a place, which is a matter of coordinates and time.
    pub(super) fn note_place(&mut self, name: AstId, what: &str) {
        if let Expression::Name(name) = self.expressions.get(name) {
            self.places.push((name.clone(), what.to_owned()));
        }
    }

    pub(super) fn new_name(&mut self, wish: &str) -> Name {
        Name { text: self.names.fresh(wish), span: self.origin.start }
    }

    /// The body that an expression names, be it only that.
    pub(super) fn body_named(&self, id: AstId) -> Option<usize> {
        let Expression::Name(name) = self.expressions.get(id) else { return None };
        match self.names.find(name)? {
            Object::Body(body) => Some(*body),
            _ => None,
        }
    }

    /// The body to which a point belongs, if that shows.
    pub(super) fn body_of(&self, id: AstId) -> Option<usize> {
        match self.expressions.get(id) {
            Expression::Name(name) => self.body_named(id).or_else(|| self.points.get(name).copied()),
            Expression::Component(of, part) if part.text == "center" => self.body_named(*of),
            Expression::Call(function, arguments) if function.text == "point" => {
                arguments.first().and_then(|&body| self.body_named(body))
            }
            _ => None,
        }
    }
}

fn lagrangian(declaration: &Declaration) -> Option<Origin> {
    let is_lagrangian = |statement: &&Statement| matches!(statement.kind, StatementKind::Lagrangian(_));
    declaration.statements.iter().find(is_lagrangian).map(|statement| statement.origin.start.into())
}

fn definitions(list: Vec<Definition>, mut plain: impl FnMut(AstId) -> AstId) -> Vec<Definition> {
    let plain = |definition: Definition| Definition { value: definition.value.map(&mut plain), ..definition };
    list.into_iter().map(plain).collect()
}

fn with_plain_event(mut event: Event, mut plain: impl FnMut(AstId) -> AstId) -> Event {
    event.value = plain(event.value);
    match &mut event.action {
        Action::Impact(restitution) => *restitution = plain(*restitution),
        Action::Assign(assignments) => {
            for assignment in assignments {
                assignment.value = plain(assignment.value);
                assignment.target = plain(assignment.target);
            }
        }
        Action::Stop | Action::Record => {}
    }
    event
}
