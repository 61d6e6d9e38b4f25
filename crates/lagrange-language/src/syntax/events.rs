//! Statements that declare events.

use proc_macro2::{Delimiter, Group, Span, TokenTree};

use super::ast::{Action, Assignment, AstId, Clock, Direction, Event, Name};
use super::cursor::Cursor;
use super::foreign;
use super::identifiers::at_relation;
use super::messages;
use super::messages::forms::form;
use super::messages::habits;
use super::parser::{Parsed, Parser, Reported};
use lagrange_expr::diagnostics::nearest;

/// The words for directions.
const DIRECTIONS: [(&str, Direction); 3] =
    [("rising", Direction::Rising), ("falling", Direction::Falling), ("crossing", Direction::Crossing)];
/// The words for actions.
const ACTIONS: [&str; 3] = ["stop", "record", "impact"];

impl Parser<'_> {
    /// Reads `name = e, falling => action`.
    pub(super) fn event(&mut self, cursor: &mut Cursor) -> Parsed<Event> {
        let name = self.leading_name("event", cursor)?;
        let value = self.event_function(&name, cursor)?;
        let (direction, direction_span) = self.direction(&name, cursor)?;
        if !eat_arrow(cursor) {
            let (message, origin) = match cursor.pair() {
                _ if cursor.at_statement_end() => (messages::event_without_action(&name.text), cursor.here()),
                Some((pair, origin)) => (messages::expected_instead("`=>`", pair), origin),
                None => (messages::expected("`=>`", cursor.peek()), cursor.here()),
            };
            return Err(self.fail_with_help(origin, message, messages::ACTION_HELP));
        }
        let action = self.action(&name, cursor)?;
        Ok(Event { name, value, direction, direction_span, action })
    }

    /// Reads `0.01 => { a = e; }` after the word `every`.
    pub(super) fn clock(&mut self, cursor: &mut Cursor) -> Parsed<Clock> {
        let period = self.expression(cursor)?;
        if !eat_arrow(cursor) {
            return Err(self.misplaced("`=>`", form("every"), cursor));
        }
        let Some(group) = cursor.eat_group(Delimiter::Brace) else {
            let is_action = ACTIONS.iter().any(|action| cursor.at_word(action));
            let help = if is_action { messages::CLOCK_ACTION_HELP } else { form("every") };
            return Err(self.misplaced("`{`", help, cursor));
        };
        Ok(Clock { period, assignments: self.assigned_in(&group) })
    }

    /// Reads `= e,`.
    fn event_function(&mut self, name: &Name, cursor: &mut Cursor) -> Parsed<AstId> {
        let mistakes = self.report.diagnostics().len();
        self.equals(form("event"), cursor)?;
        let is_wrong = self.report.diagnostics().len() > mistakes;
        let value = self.expression(cursor)?;
        let is_condition = at_relation(cursor) && !at_arrow(cursor);
        if is_condition || at_combination(cursor) {
            if is_wrong {
                // A condition after a colon is reported only once.
                return Err(Reported);
            }
            let origin = cursor.here_to_pair();
            let help = match combines_conditions(cursor) {
                true => habits::several_conditions(&name.text),
                false => habits::zero_and_direction(&name.text),
            };
            return Err(self.fail_with_help(origin, habits::CONDITION_IN_EVENT, help));
        }
        if cursor.eat(',').is_some() {
            return Ok(value);
        }
        if cursor.at_statement_end() {
            let message = messages::event_without_action(&name.text);
            return Err(self.fail_with_help(cursor.here(), message, form("event")));
        }
        if at_arrow(cursor) || cursor.ident().is_some_and(|word| direction_of(&word.to_string()).is_some()) {
            return Err(self.no_direction(name, cursor));
        }
        Err(self.no_operator(cursor, "`,`"))
    }

    fn direction(&mut self, name: &Name, cursor: &mut Cursor) -> Parsed<(Direction, Span)> {
        let Some(word) = cursor.ident().cloned().filter(|_| !cursor.at_statement()) else {
            return Err(self.no_direction(name, cursor));
        };
        let text = word.to_string();
        if let Some(direction) = direction_of(&text) {
            cursor.skip_one();
            return Ok((direction, word.span()));
        }
        let message = messages::expected(messages::DIRECTION, cursor.peek());
        let known = DIRECTIONS.map(|(known, _)| known);
        let help = match foreign::label(&text, known).or_else(|| nearest(&text, known)) {
            Some(known) => messages::meant(known),
            None => messages::DIRECTION_HELP.to_owned(),
        };
        Err(self.fail_with_help(word.span(), message, help))
    }

    fn no_direction(&mut self, name: &Name, cursor: &Cursor) -> Reported {
        let message = messages::event_without_direction(&name.text);
        self.fail_with_help(cursor.here(), message, messages::DIRECTION_HELP)
    }

    fn action(&mut self, name: &Name, cursor: &mut Cursor) -> Parsed<Action> {
        if let Some(group) = cursor.eat_group(Delimiter::Brace) {
            return Ok(Action::Assign(self.assigned_in(&group)));
        }
        let (here, word) = (cursor.here(), cursor.ident().map(ToString::to_string).unwrap_or_default());
        if cursor.at_statement_end() {
            let message = messages::event_without_action(&name.text);
            return Err(self.fail_with_help(here, message, messages::ACTION_HELP));
        }
        if !ACTIONS.contains(&word.as_str()) {
            let message = messages::expected(messages::ACTION, cursor.peek());
            let help = match foreign::label(&word, ACTIONS).or_else(|| nearest(&word, ACTIONS)) {
                Some("impact") => messages::RESTITUTION_HELP.to_owned(),
                Some(known) => messages::meant(known),
                None => messages::ACTION_HELP.to_owned(),
            };
            return Err(self.fail_with_help(here, message, help));
        }
        cursor.skip_one();
        let action = match word.as_str() {
            "stop" => Action::Stop,
            "record" => Action::Record,
            _ => Action::Impact(self.restitution(cursor)?),
        };
        match cursor.at_statement_end() {
            true => Ok(action),
            false => {
                let message = messages::expected("`;`", cursor.peek());
                Err(self.fail_with_help(cursor.here(), message, messages::ACTION_HELP))
            }
        }
    }

    /// Reads the assignments between braces; there must be at least one.
    fn assigned_in(&mut self, group: &Group) -> Vec<Assignment> {
        self.some_lines(
            group,
            (messages::NOTHING_ASSIGNED, messages::NOTHING_ASSIGNED_HELP),
            Self::assignment,
        )
    }

    /// Reads `(e)`.
    fn restitution(&mut self, cursor: &mut Cursor) -> Parsed<AstId> {
        let group = cursor.eat_group(Delimiter::Parenthesis);
        let Some(group) = group.filter(|group| !group.stream().is_empty()) else {
            let before = cursor.before();
            return Err(self.fail_with_help(before, messages::RESTITUTION, messages::RESTITUTION_HELP));
        };
        self.inside(&group, |parser, cursor| {
            let value = parser.expression(cursor)?;
            match cursor.at_end() {
                true => Ok(value),
                false => Err(parser.no_operator(cursor, "`)`")),
            }
        })
    }

    /// Reports a statement between the braces and skips it. The names that it declares are not
    /// reported as unknown.
    fn statement_in_event(&mut self, cursor: &mut Cursor) -> Reported {
        let start = cursor.position();
        if let Some(keyword) = cursor.eat_ident()
            && !(cursor.at('=') && self.unreadable_words.contains(&keyword.to_string()))
        {
            let help = messages::statement_in_event_help(keyword.to_string());
            self.fail_with_help(keyword.span(), messages::STATEMENT_IN_EVENT, help);
        }
        self.skip_statement(cursor);
        self.leave_out(cursor, start);
        Reported
    }

    /// Reads `dot(x) = e`.
    fn assignment(&mut self, cursor: &mut Cursor) -> Parsed<Vec<Assignment>> {
        if cursor.at_statement() {
            return Err(self.statement_in_event(cursor));
        }
        let target = self.expression(cursor)?;
        Ok(vec![Assignment::new(target, self.assigned(messages::ASSIGNMENT_HELP, cursor)?)])
    }
}

fn direction_of(word: &str) -> Option<Direction> {
    DIRECTIONS.iter().find(|(known, _)| *known == word).map(|(_, direction)| *direction)
}

fn at_combination(cursor: &Cursor) -> bool {
    cursor.at_pair('&', '&') || cursor.at_pair('|', '|')
}

/// True if `&&` or `||` precedes the action.
fn combines_conditions(cursor: &Cursor) -> bool {
    let signs = |token: &TokenTree| match token {
        TokenTree::Punct(punct) => punct.as_char(),
        _ => ' ',
    };
    let signs = cursor.rest().iter().map(signs).collect::<String>();
    let condition = signs.split("=>").next().unwrap_or_default();
    condition.contains("&&") || condition.contains("||")
}

fn at_arrow(cursor: &Cursor) -> bool {
    cursor.at_pair('=', '>')
}

fn eat_arrow(cursor: &mut Cursor) -> bool {
    let found = at_arrow(cursor);
    if found {
        cursor.skip_one();
        cursor.skip_one();
    }
    found
}
