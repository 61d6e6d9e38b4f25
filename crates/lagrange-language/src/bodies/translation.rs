//! Translation of the statements of a declaration, one by one, to the plain language.

use super::messages;
use super::names::SceneNames;
use super::object::{Body, Line, Object, WaitingBody};
use super::plain::{Drawn, Motion, Obligation};
use super::space::dimension::is_spatial;
use super::space::scene::Space;
use super::terms::{Pair, TermWriter};
use crate::syntax::ast::AstId;
use crate::syntax::ast::Compliance;
use crate::syntax::ast::Declaration;
use crate::syntax::ast::Expression;
use crate::syntax::ast::Expressions;
use crate::syntax::ast::Name;
use crate::syntax::ast::Statement;
use crate::syntax::ast::StatementKind;
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::diagnostics::Report;

/// A translation in progress.
pub(super) struct Translation<'a> {
    pub(super) report: &'a mut Report,
    pub(super) expressions: Expressions,
    pub(super) names: SceneNames,
    pub(super) bodies: Vec<Body>,
    pub(super) lines: Vec<Line>,
    /// Additional data of a scene in space.
    pub(super) space: Option<Space>,
    /// Bodies and frames in the plane that have not yet been placed by a joint.
    pub(super) waiting: Vec<WaitingBody>,
    /// Plain statements so far.
    pub(super) statements: Vec<Statement>,
    /// Labels of contacts that have none of their own.
    pub(super) compliance: Compliance,
    /// The statement that is being translated.
    pub(super) origin: Origin,
    pub(super) gravity: Option<(Pair, Origin)>,
    /// Bodies of points that are named by `let`.
    pub(super) points: HashMap<String, usize>,
    /// Names that have been reported as used too early.
    pub(super) early: HashSet<String>,
    /// Words of unreadable statements, which may declare them.
    pub(super) unreadable: HashSet<String>,
    /// Translations of expressions, each computed once.
    pub(super) translated: HashMap<AstId, AstId>,
    pub(super) motions: Vec<Motion>,
    /// True if a drawing is requested.
    pub(super) is_drawn: bool,
    pub(super) drawing: Vec<Drawn>,
    /// Forces and moments, which are drawn last.
    pub(super) loads: Vec<Drawn>,
    pub(super) obligations: Vec<Obligation>,
    pub(super) joints: Vec<Name>,
    /// Names of `let`s that are places, with their owners.
    pub(super) places: Vec<(String, String)>,
    /// The level of accuracy of the emitted code.
    pub(super) accuracy: Accuracy,
    /// Place of the Lagrangian, if the declaration has one.
    pub(super) lagrangian: Option<Origin>,
    /// Expressions that the user wrote in statements about bodies.
    pub(super) mentioned: Vec<AstId>,
    /// Heights of terrain, which are among the mentioned expressions.
    pub(super) heights: Vec<AstId>,
    /// Names of `let`s that are omitted if nothing needs them.
    pub(super) optional: HashSet<String>,
}

impl<'a> Translation<'a> {
    pub(super) fn new(declaration: &mut Declaration, report: &'a mut Report) -> Translation<'a> {
        Translation {
            report,
            names: SceneNames::new(declaration),
            space: is_spatial(declaration).then(Space::default),
            expressions: std::mem::take(&mut declaration.expressions),
            bodies: Vec::new(),
            lines: Vec::new(),
            waiting: Vec::new(),
            statements: Vec::new(),
            origin: declaration.name.span.into(),
            compliance: Compliance::default(),
            gravity: None,
            points: HashMap::default(),
            early: HashSet::default(),
            unreadable: declaration.unreadable_words.clone(),
            translated: HashMap::default(),
            motions: Vec::new(),
            is_drawn: declaration.asks_for("drawing"),
            drawing: Vec::new(),
            loads: Vec::new(),
            obligations: Vec::new(),
            joints: Vec::new(),
            places: Vec::new(),
            accuracy: declaration.accuracy,
            lagrangian: lagrangian(declaration),
            mentioned: Vec::new(),
            heights: Vec::new(),
            optional: HashSet::default(),
        }
    }

    /// Reports something that never turns where a turning object is needed.
    pub(super) fn report_no_turning(&mut self, what: AstId, purpose: &str) {
        let name = match self.expressions.get(what) {
            Expression::Name(name) => format!("`{name}`"),
            _ => messages::THIS.to_owned(),
        };
        let origin = self.expressions.origin(what);
        let error = self.report.error(origin, messages::does_not_turn(&name, purpose));
        error.help(messages::DOES_NOT_TURN_HELP);
    }

    /// Returns the number of components of vectors in the scene.
    pub(super) fn dimension(&self) -> usize {
        if self.space.is_some() { 3 } else { 2 }
    }

    /// Writes expressions for the current statement.
    pub(super) fn terms(&mut self) -> TermWriter<'_> {
        TermWriter::new(&mut self.expressions, self.origin)
    }

    /// Adds a plain statement that replaces the current one.
    pub(super) fn push(&mut self, kind: StatementKind) {
        if self.lagrangian.is_some()
            && matches!(kind, StatementKind::Kinetic(_) | StatementKind::Potential(_))
        {
            // This has been reported.
            return;
        }
        let docs = proc_macro2::TokenStream::new();
        self.statements.push(Statement { kind, origin: self.origin, docs });
    }

    /// Adds a `let` with a new name like `wish`; returns the name.
    pub(super) fn bind(&mut self, wish: &str, value: AstId) -> AstId {
        let name = self.new_name(wish);
        let mentioned = self.terms().name(&name.text);
        self.push(StatementKind::Let(name, value));
        mentioned
    }

    /// Adds a `let` with a new name like `wish`, which is omitted later if nothing needs it;
    /// returns the name.
    pub(super) fn bind_optionally(&mut self, wish: &str, value: AstId) -> AstId {
        let name = self.bind(wish, value);
        if let Expression::Name(name) = self.expressions.get(name) {
            self.optional.insert(name.clone());
        }
        name
    }

    /// Records that a `let` is a place, which may only depend on coordinates and time.
    pub(super) fn note_place(&mut self, name: AstId, what: &str) {
        if let Expression::Name(name) = self.expressions.get(name) {
            self.places.push((name.clone(), what.to_owned()));
        }
    }

    pub(super) fn new_name(&mut self, wish: &str) -> Name {
        Name::new(self.names.fresh(wish), self.origin.start)
    }

    /// Returns the body that an expression names, if it is only a name.
    pub(super) fn body_named(&self, id: AstId) -> Option<usize> {
        let Expression::Name(name) = self.expressions.get(id) else { return None };
        match self.names.find(name)? {
            Object::Body(body) => Some(*body),
            _ => None,
        }
    }

    /// True for an expression of the user that consists of only parameters and numbers.
    pub(super) fn is_at_rest(&self, id: AstId) -> bool {
        self.expressions.all_names(id, |name| self.names.is_fixed(name))
    }

    /// True for an expression of the user that may have a rate, if a mass may depend on its names.
    pub(super) fn may_change(&self, id: AstId) -> bool {
        !self.expressions.all_names(id, |name| self.names.is_steady(name))
            && self.expressions.all_names(id, |name| !self.names.is_unsuited(name))
    }

    /// True if all of these expressions could be read, so that their number is the intended one.
    pub(super) fn are_read(&self, ids: &[AstId]) -> bool {
        ids.iter().all(|&id| !matches!(self.expressions.get(id), Expression::Invalid))
    }

    /// Returns the translation of an expression whose parts have been translated.
    pub(super) fn plain_of(&self, id: AstId) -> AstId {
        self.translated.get(&id).copied().unwrap_or(id)
    }

    /// Returns the name of a body in the plane or a link in space.
    pub(super) fn name_of(&self, body: usize) -> &str {
        match &self.space {
            Some(space) => space.name_of(body),
            None => &self.bodies[body].name.text,
        }
    }

    /// Returns the body or frame in space that an expression names.
    pub(super) fn link_named(&self, id: AstId) -> Option<usize> {
        let Expression::Name(name) = self.expressions.get(id) else { return None };
        match self.names.find(name)? {
            Object::Link { index, .. } => Some(*index),
            _ => None,
        }
    }

    /// Returns the body to which a point belongs, if this follows from its form.
    pub(super) fn body_of(&self, id: AstId) -> Option<usize> {
        match self.expressions.get(id) {
            Expression::Name(name) => self.body_named(id).or_else(|| self.points.get(name).copied()),
            Expression::Component(of, part) if part.text == "center" => self.body_named(*of),
            Expression::Call(function, arguments) if matches!(function.text.as_str(), "point" | "corner") => {
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
