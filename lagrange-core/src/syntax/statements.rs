//! Statements, one by one.

use proc_macro2::Ident;

use super::ast::{Action, AstId, ConnectorKind, SceneStatement, Statement, StatementKind};
use super::cursor::Cursor;
use super::messages;
use super::parser::{Parsed, Parser};

impl Parser<'_> {
    /// Reads statements up to the end of the input. Those that cannot be read are reported and left out.
    pub(super) fn statements(&mut self, cursor: &mut Cursor) -> Vec<Statement> {
        let mut statements = Vec::new();
        self.each(cursor, |parser, cursor| statements.extend(parser.documented_statement(cursor)));
        statements
    }

    fn documented_statement(&mut self, cursor: &mut Cursor) -> Option<Statement> {
        let (docs, attributes) = self.documentation(cursor);
        let start = cursor.position();
        let kind = self.statement(cursor);
        let documents_nothing = match &kind {
            Some(kind) => !kind.is_documented(),
            None => cursor.position() == start,
        };
        if let Some(origin) = attributes.filter(|_| docs.is_empty() || documents_nothing) {
            let error = self.report.error(origin, messages::ATTRIBUTE_ON_STATEMENT);
            error.help(messages::ATTRIBUTE_ON_STATEMENT_HELP);
        }
        let Some(kind) = kind else {
            self.leave_out(cursor, start);
            return None;
        };
        for name in kind.declared_names() {
            self.declared_names.insert(name.text.clone(), ());
        }
        Some(Statement { kind, origin: cursor.since(start), docs })
    }

    /// Reads one statement with its semicolon; takes at least one token, if there is one.
    fn statement(&mut self, cursor: &mut Cursor) -> Option<StatementKind> {
        if cursor.at_end() || cursor.eat(';').is_some() {
            return None;
        }
        self.skipped = false;
        let kind = self.statement_kind(cursor);
        if kind.is_err() {
            self.skip_statement(cursor);
        }
        let complete = self.skipped || kind.as_ref().is_ok_and(ends_in_braces);
        if cursor.eat(';').is_none() && !complete {
            self.missing_semicolon(cursor);
        }
        kind.ok()
    }

    fn statement_kind(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let Some(keyword) = cursor.eat_ident() else {
            return Err(self.fail(cursor.here(), messages::expected(messages::STATEMENT, cursor.peek())));
        };
        match keyword.to_string().as_str() {
            "param" => Ok(StatementKind::Parameters(self.definitions(cursor))),
            "input" => Ok(StatementKind::Inputs(self.definitions(cursor))),
            "const" => Ok(StatementKind::Constants(self.constants(cursor))),
            "coord" => Ok(StatementKind::Coordinates(self.coordinates(cursor))),
            "let" => self.binding(cursor),
            "kinetic" => Ok(StatementKind::Kinetic(self.assigned(cursor)?)),
            "potential" => Ok(StatementKind::Potential(self.assigned(cursor)?)),
            "lagrangian" => Ok(StatementKind::Lagrangian(self.assigned(cursor)?)),
            "dissipation" => Ok(StatementKind::Dissipation(self.assigned(cursor)?)),
            "force" => self.force(cursor),
            "torque" => self.torque(cursor),
            "constraint" => {
                Ok(StatementKind::Constraint(self.declared_name(cursor)?, self.assigned(cursor)?))
            }
            "stabilise" => Ok(StatementKind::Stabilise(self.assigned(cursor)?)),
            "event" => Ok(StatementKind::Event(self.event(cursor)?)),
            "friction" => Ok(StatementKind::Friction(self.friction(cursor)?)),
            "output" => Ok(StatementKind::Output(self.declared_name(cursor)?, self.assigned(cursor)?)),
            "emit" => Ok(StatementKind::Emit(self.emit(cursor)?)),
            "reduce" => Ok(StatementKind::Reduce(self.reduction(cursor)?)),
            _ => match self.scene_statement(&keyword, cursor) {
                Some(statement) => Ok(StatementKind::Scene(statement?)),
                None => Err(self.unknown_statement(&keyword, cursor)),
            },
        }
    }

    /// A statement about plane rigid bodies, if the word begins one.
    fn scene_statement(&mut self, keyword: &Ident, cursor: &mut Cursor) -> Option<Parsed<SceneStatement>> {
        let text = keyword.to_string();
        if let Some(kind) = ConnectorKind::named(&text) {
            return Some(self.connector(kind, cursor).map(SceneStatement::Connector));
        }
        Some(match text.as_str() {
            "gravity" => self.assigned(cursor).map(SceneStatement::Gravity),
            "body" => self.body(cursor).map(|body| SceneStatement::Body(Box::new(body))),
            "line" => self.line_statement(cursor).map(SceneStatement::Line),
            "pin" => self.pin(cursor).map(SceneStatement::Joint),
            "slide" => self.slide(cursor).map(SceneStatement::Joint),
            "roll" => self.roll(cursor).map(SceneStatement::Joint),
            _ => return None,
        })
    }

    /// `= e`, up to the end of the statement.
    pub(super) fn assigned(&mut self, cursor: &mut Cursor) -> Parsed<AstId> {
        match cursor.eat_equals() {
            Some(_) => Ok(self.value(cursor)),
            None if cursor.at_pair('=', '=') => {
                let origin = cursor.skip_one().to(cursor.here());
                Err(self.fail(origin, messages::DOUBLE_EQUALS))
            }
            None => Err(self.fail(cursor.here(), messages::expected("`=`", cursor.peek()))),
        }
    }

    /// Reads the expression that ends the statement. What is unreadable is still a value, so that a name
    /// stays declared although its value is wrong.
    pub(super) fn value(&mut self, cursor: &mut Cursor) -> AstId {
        let start = cursor.position();
        match self.expression(cursor) {
            Ok(id) if cursor.at_statement_end() => return id,
            Ok(_) => self.no_operator(cursor, "`;`"),
            Err(reported) => reported,
        };
        self.skip_statement(cursor);
        self.unreadable(cursor, start)
    }

    /// `x = e` or `e at e`.
    fn force(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        if cursor.ident().is_some() && cursor.equals_past(1) {
            let name = self.name(cursor)?;
            return Ok(StatementKind::ForceOn(name, self.assigned(cursor)?));
        }
        let force = self.expression(cursor)?;
        self.connective("at", messages::FORCE_HELP, cursor)?;
        Ok(StatementKind::ForceAt { force, point: self.value(cursor) })
    }

    /// `e on e`.
    fn torque(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let moment = self.expression(cursor)?;
        self.connective("on", messages::TORQUE_HELP, cursor)?;
        Ok(StatementKind::Torque { moment, angle: self.value(cursor) })
    }

    pub(super) fn connective(&mut self, word: &str, help: &str, cursor: &mut Cursor) -> Parsed<()> {
        if cursor.eat_word(word).is_some() {
            return Ok(());
        }
        let wanted = format!("`{word}`");
        let is_other = cursor.at('=') || ["at", "on", "to"].iter().any(|word| cursor.at_word(word));
        if is_other || cursor.at_statement_end() {
            let message = messages::expected(&wanted, cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, help));
        }
        Err(self.no_operator(cursor, &wanted))
    }
}

/// Whether a statement needs no semicolon.
fn ends_in_braces(kind: &StatementKind) -> bool {
    match kind {
        StatementKind::Emit(_) | StatementKind::Reduce(_) => true,
        StatementKind::Event(event) => matches!(event.action, Action::Assign(_)),
        StatementKind::Scene(statement) => {
            use SceneStatement::{Body, Connector, Line};
            matches!(statement, Body(_) | Line(_) | Connector(_))
        }
        _ => false,
    }
}
