//! Statements, one by one.

mod loops;

use proc_macro2::{Delimiter, Ident, TokenTree};

use super::ast::{
    Action, AstId, BinaryOperator, Block, ConnectorKind, Expression, MobilizerKind, Quaternion,
    SceneStatement, StateKind, Statement, StatementKind, SurfaceKind,
};
use super::cursor::Cursor;
use super::expressions::at_loop;
use super::header::header_ahead;
use super::identifiers::{at_equals_past, at_relation};
use super::keywords;
use super::messages;
use super::messages::forms::form;
use super::parser::{Declared, Parsed, Parser, Reported};
use super::parts::{at_placement, path_length};

impl Parser<'_> {
    /// Reads statements up to the end of the input. Unreadable ones are reported and omitted.
    pub(super) fn statements(&mut self, cursor: &mut Cursor) -> Vec<Statement> {
        let mut statements = Vec::new();
        self.each(cursor, |parser, cursor| statements.extend(parser.documented_statement(cursor)));
        statements
    }

    pub(super) fn documented_statement(&mut self, cursor: &mut Cursor) -> Option<Statement> {
        let (docs, attributes) = self.documentation(cursor);
        if cursor.at('%') {
            self.comment(cursor);
            return None;
        }
        let start = cursor.position();
        if header_ahead(cursor) {
            self.second_system(cursor);
            return None;
        }
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
            self.declared_names.insert(name.text.clone(), Declared::by(&kind));
        }
        Some(Statement { kind, origin: cursor.since(start), docs })
    }

    /// Reads one statement with its semicolon; consumes at least one token, if there is one.
    fn statement(&mut self, cursor: &mut Cursor) -> Option<StatementKind> {
        if cursor.at_end() || cursor.eat(';').is_some() {
            return None;
        }
        self.begin_statement();
        let mistakes = self.report.diagnostics().len();
        let kind = self.statement_kind(cursor);
        if kind.is_err() {
            self.skip_statement(cursor);
        }
        let complete = self.skipped || kind.as_ref().is_ok_and(ends_in_braces);
        if cursor.eat(';').is_none() && !complete {
            self.missing_semicolon(cursor);
        }
        self.refuse_brackets(cursor, mistakes);
        kind.ok()
    }

    fn statement_kind(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        if cursor.statement_keyword().is_some_and(|word| word == "contacts") {
            return Ok(StatementKind::Scene(SceneStatement::Contacts(Box::new(
                self.contact_defaults(cursor)?,
            ))));
        }
        if at_placement(cursor) {
            return self.placement(cursor);
        }
        if self.at_rate_equation(cursor) {
            return self.rate_equation(cursor);
        }
        let Some(keyword) = cursor.eat_ident() else {
            return Err(self.no_statement(cursor));
        };
        let text = keyword.to_string();
        self.accepts_accelerations = keywords::accepts_accelerations(&text);
        let help = form(&text);
        match text.as_str() {
            "param" => Ok(StatementKind::Parameters(self.definitions("param", cursor))),
            "input" => Ok(StatementKind::Inputs(self.definitions("input", cursor))),
            "noise" => Ok(StatementKind::Noises(vec![self.noise(cursor)?])),
            "const" => Ok(StatementKind::Constants(self.constants(cursor))),
            "coord" => Ok(StatementKind::Coordinates(self.coordinates("coord", cursor))),
            "state" => Ok(StatementKind::States(StateKind::FirstOrder, self.coordinates("state", cursor))),
            "discrete" => {
                Ok(StatementKind::States(StateKind::Discrete, self.coordinates("discrete", cursor)))
            }
            "mode" => Ok(StatementKind::Mode(self.mode(cursor)?)),
            "range" if !cursor.equals_past(0) => Ok(StatementKind::Ranges(self.ranges(cursor))),
            "start" => Ok(StatementKind::Start(self.starts("start", cursor))),
            "history" => Ok(StatementKind::History(self.starts("history", cursor))),
            "dot" if at_state_rate(cursor) => self.state_rate(cursor),
            "quaternion" => {
                let name = self.declared_name(cursor)?;
                Ok(StatementKind::Quaternion(Box::new(Quaternion::named(name))))
            }
            "velocity" => {
                let name = self.leading_name("velocity", cursor)?;
                Ok(StatementKind::Velocity(name, self.assigned(help, cursor)?))
            }
            "let" => self.binding(cursor),
            "table" => Ok(StatementKind::Table(Box::new(self.table(cursor)?))),
            "solve" if at_unknowns(cursor) || cursor.group(Delimiter::Parenthesis).is_none() => {
                Ok(StatementKind::Solve(self.unknowns(cursor)?))
            }
            "function" => Ok(StatementKind::External(Box::new(self.external(cursor)?))),
            "kinetic" => Ok(StatementKind::Kinetic(self.assigned(help, cursor)?)),
            "potential" => Ok(StatementKind::Potential(self.assigned(help, cursor)?)),
            "lagrangian" => Ok(StatementKind::Lagrangian(self.assigned(help, cursor)?)),
            "gibbs" => self.gibbs(cursor),
            "dissipation" => Ok(StatementKind::Dissipation(self.assigned(help, cursor)?)),
            "force" => self.force(cursor),
            "torque" => self.torque(cursor),
            "constraint" => self.constraint(cursor),
            "stabilise" => Ok(StatementKind::Stabilise(self.assigned(help, cursor)?)),
            "event" => Ok(StatementKind::Event(self.event(cursor)?)),
            "every" => Ok(StatementKind::Every(self.clock(cursor)?)),
            "friction" => Ok(StatementKind::Friction(self.friction(cursor)?)),
            "output" => {
                let name = self.leading_name("output", cursor)?;
                Ok(StatementKind::Output(name, self.assigned(help, cursor)?))
            }
            "emit" => Ok(StatementKind::Emit(self.emit(cursor)?)),
            "reduce" => Ok(StatementKind::Reduce(self.reduction(cursor)?)),
            "for" if at_loop(cursor) => self.repetition(cursor),
            "if" => self.selection(cursor),
            "part" if cursor.ident().is_some() => self.part_definition(cursor),
            "include" if matches!(cursor.peek(), Some(TokenTree::Literal(_))) => self.include(cursor),
            _ => match self.scene_statement(&keyword, cursor) {
                Some(statement) => Ok(StatementKind::Scene(statement?)),
                // An error says why the statement that declares it is unreadable.
                None if self.unreadable_words.contains(&keyword.to_string()) => Err(Reported),
                None => Err(self.unknown_statement(&keyword, cursor)),
            },
        }
    }

    /// Reads a statement about rigid bodies, if the word begins one.
    fn scene_statement(&mut self, keyword: &Ident, cursor: &mut Cursor) -> Option<Parsed<SceneStatement>> {
        let text = keyword.to_string();
        if let Some(kind) = ConnectorKind::named(&text) {
            return Some(self.connector(kind, cursor).map(SceneStatement::Connector));
        }
        if let Some(kind) = MobilizerKind::named(&text) {
            let joint = self.mobilizer(kind, cursor);
            return Some(joint.map(|joint| SceneStatement::Mobilizer(Box::new(joint))));
        }
        if let Some(kind) = SurfaceKind::named(&text) {
            return Some(self.surface(kind, cursor).map(SceneStatement::Surface));
        }
        Some(match text.as_str() {
            "gravity" => self.assigned(form("gravity"), cursor).map(SceneStatement::Gravity),
            "body" => self.body(cursor).map(|body| SceneStatement::Body(Box::new(body))),
            "contact" => self.contact(cursor).map(|contact| SceneStatement::Contact(Box::new(contact))),
            "pin" => self.pin(cursor).map(SceneStatement::Joint),
            "slide" => self.slide(cursor).map(SceneStatement::Joint),
            "roll" => self.roll(cursor).map(SceneStatement::Joint),
            "frame" => self.declared_name(cursor).map(SceneStatement::Frame),
            _ => return None,
        })
    }

    /// Reads `= e, for: e`.
    fn gibbs(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        self.equals(form("gibbs"), cursor)?;
        let function = self.expression(cursor)?;
        if cursor.eat(',').is_none() && !cursor.at_statement_end() {
            return Err(self.no_operator(cursor, "`,`"));
        }
        self.connective("for", form("gibbs"), cursor)?;
        if cursor.eat(':').is_none() {
            let message = messages::expected("`:`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, form("gibbs")));
        }
        Ok(StatementKind::Gibbs { function, stated: self.value(cursor) })
    }

    /// Reads `name = e`, where e stays zero.
    fn constraint(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let name = self.leading_name("constraint", cursor)?;
        let mistakes = self.report.diagnostics().len();
        self.equals(form("constraint"), cursor)?;
        let (start, is_wrong) = (cursor.position(), self.report.diagnostics().len() > mistakes);
        let value = match self.expression(cursor) {
            // An equation after a colon is a single error.
            Ok(_) if at_relation(cursor) && is_wrong => Err(Reported),
            Ok(_) if at_relation(cursor) => Err(self.relation_in_constraint(&name.text, cursor)),
            Ok(id) if cursor.at_statement_end() => Ok(id),
            Ok(_) => Err(self.no_operator(cursor, "`;`")),
            Err(reported) => Err(reported),
        };
        let value = value.unwrap_or_else(|Reported| {
            self.skip_statement(cursor);
            self.unreadable(cursor, start)
        });
        Ok(StatementKind::Constraint(name, value))
    }

    /// Reads `x = e`, `e at e` or `e along e`.
    fn force(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        if cursor.ident().is_some() && at_equals_past(path_length(cursor), cursor) {
            let name = self.mentioned(form("force"), cursor)?;
            return Ok(StatementKind::ForceOn(name, self.assigned(form("force"), cursor)?));
        }
        let force = self.loading("force", cursor)?;
        if cursor.eat_word("along").is_some() {
            return Ok(StatementKind::ForceAlong { force, velocity: self.value(cursor) });
        }
        self.connective("at", form("force"), cursor)?;
        Ok(StatementKind::ForceAt { force, point: self.value(cursor) })
    }

    /// Reads `e on e`.
    fn torque(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let moment = self.loading("torque", cursor)?;
        self.connective("on", form("torque"), cursor)?;
        Ok(StatementKind::Torque { moment, angle: self.value(cursor) })
    }

    /// Reads `(a) = e`, the equation of a state.
    fn state_rate(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
            return Err(self.no_name(form("state"), cursor));
        };
        let name = self.inside(&group, |parser, cursor| {
            let name = parser.mentioned(form("state"), cursor)?;
            match cursor.at_end() {
                true => Ok(name),
                false => Err(parser.misplaced("`)`", form("state"), cursor)),
            }
        })?;
        Ok(StatementKind::StateRate(name, self.assigned(form("state"), cursor)?))
    }

    /// Reads `e = e`, an equation for rates of states.
    fn rate_equation(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let start = cursor.position();
        let (left, equals) = (self.expression(cursor)?, cursor.here());
        let right = self.assigned(form("state"), cursor)?;
        let difference = Expression::Binary(BinaryOperator::Subtract, equals.start, left, right);
        Ok(StatementKind::RateEquation(self.expressions.add(difference, cursor.since(start))))
    }

    /// True at an equation with the rate of a state that is not just `dot(a) = e`.
    fn at_rate_equation(&self, cursor: &Cursor) -> bool {
        let mut is_declared = true;
        match (cursor.peek(), cursor.peek_past(1)) {
            (Some(TokenTree::Ident(word)), _) if word == "dot" => {}
            (Some(TokenTree::Ident(_)), Some(TokenTree::Ident(_))) => return false,
            (Some(TokenTree::Ident(word)), _) => {
                let word = word.to_string();
                is_declared = self.declared(&word).is_some();
                // Most statements are decided here, before the remaining text is examined.
                if keywords::statement(&word).is_some() && !is_declared {
                    return false;
                }
            }
            _ => {}
        }
        let statement = cursor.rest_of_statement();
        let equals = (0..statement.len()).find(|&count| cursor.equals_past(count));
        let rates = match equals {
            None => return false,
            Some(1) if !is_declared => return false,
            Some(2) if cursor.at_word("dot") => &statement[2..],
            Some(_) => statement,
        };
        self.mentions_rate(rates)
    }

    /// True if `dot(…)` of a state, or of a member of a part, is among these tokens.
    fn mentions_rate(&self, tokens: &[TokenTree]) -> bool {
        let mut pending = vec![tokens.to_vec()];
        while let Some(tokens) = pending.pop() {
            for (index, token) in tokens.iter().enumerate() {
                let TokenTree::Group(group) = token else { continue };
                let is_dot = matches!(tokens[..index].last(), Some(TokenTree::Ident(word)) if word == "dot");
                let inside = group.stream().into_iter().collect::<Vec<_>>();
                if is_dot && self.mentions_state(&inside) {
                    return true;
                }
                pending.push(inside);
            }
        }
        false
    }

    /// True if a state, or a member of a part, is among these tokens.
    fn mentions_state(&self, tokens: &[TokenTree]) -> bool {
        let mut pending = tokens.to_vec();
        while let Some(token) = pending.pop() {
            match token {
                TokenTree::Group(group) => pending.extend(group.stream()),
                TokenTree::Punct(sign) if sign.as_char() == '.' => return true,
                token if self.declared(&token.to_string()) == Some(Declared::State) => return true,
                _ => {}
            }
        }
        false
    }

    /// Reads a force or moment; a missing one is reported.
    fn loading(&mut self, keyword: &str, cursor: &mut Cursor) -> Parsed<AstId> {
        if cursor.at('=') || cursor.at_statement_end() {
            let message = messages::expected(messages::OPERAND, cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, form(keyword)));
        }
        self.expression(cursor)
    }
}

/// True at `(…) =`.
fn at_state_rate(cursor: &Cursor) -> bool {
    cursor.group(Delimiter::Parenthesis).is_some() && at_equals_past(1, cursor)
}

/// True at `(…):`.
fn at_unknowns(cursor: &Cursor) -> bool {
    cursor.group(Delimiter::Parenthesis).is_some()
        && matches!(cursor.peek_past(1), Some(TokenTree::Punct(colon)) if colon.as_char() == ':')
}

/// True if a statement needs no semicolon.
fn ends_in_braces(kind: &StatementKind) -> bool {
    match kind {
        StatementKind::Emit(_) | StatementKind::Reduce(_) | StatementKind::Every(_) => true,
        StatementKind::External(function) => function.derivatives.is_some(),
        StatementKind::Block(block) => !matches!(block, Block::Include(_)),
        StatementKind::Event(event) => matches!(event.action, Action::Assign(_)),
        StatementKind::Scene(statement) => {
            use SceneStatement::{Body, Connector, Contact, Contacts, Mobilizer, Surface};
            match statement {
                Contacts(defaults) => defaults.compliance.way().is_some(),
                statement => {
                    matches!(statement, Body(_) | Surface(_) | Connector(_) | Contact(_) | Mobilizer(_))
                }
            }
        }
        _ => false,
    }
}
