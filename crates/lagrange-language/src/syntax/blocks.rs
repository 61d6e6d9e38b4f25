//! `{ label: e; label: e; }`: the description of a body, a line or a spring.

use proc_macro2::{Delimiter, Group, TokenTree};

use super::ast::{AstId, Expression, Name};
use super::cursor::Cursor;
use super::foreign;
use super::messages;
use super::messages::habits;
use super::messages::scenes;
use super::parser::{Parsed, Parser, Reported};
use lagrange_expr::diagnostics::{Origin, nearest};

/// The labels that an object can have, and those that have been read.
pub(super) struct BlockLabels {
    /// The described object, with its article.
    owner: &'static str,
    known: Vec<&'static str>,
    given: Vec<(&'static str, Origin)>,
}

impl BlockLabels {
    pub(super) fn new(owner: &'static str, known: &[&'static str]) -> BlockLabels {
        BlockLabels { owner, known: known.to_vec(), given: Vec::new() }
    }

    fn place(&self, label: &str) -> Option<Origin> {
        self.given.iter().find(|(given, _)| *given == label).map(|(_, origin)| *origin)
    }
}

impl Parser<'_> {
    /// Reads the name of an object that is followed by braces.
    pub(super) fn scene_name(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<Name> {
        let name = match cursor.group(Delimiter::Brace) {
            None => self.declared_name(cursor),
            Some(_) => Err(self.no_name(help, cursor)),
        };
        if name.is_err() {
            self.skip_braces(cursor);
        }
        name
    }

    /// Consumes the braces of a statement. If they are missing, the probable content is skipped.
    pub(super) fn braces(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<Group> {
        if let Some(group) = cursor.eat_group(Delimiter::Brace) {
            return Ok(group);
        }
        let message = messages::expected("`{`", cursor.peek());
        let reported = self.fail_with_help(cursor.here(), message, help);
        self.skip_braces(cursor);
        Err(reported)
    }

    /// Skips a statement up to its braces, so that these are not read separately.
    pub(super) fn skip_braces(&mut self, cursor: &mut Cursor) {
        self.skipped = true;
        let is_brace = |cursor: &Cursor| cursor.group(Delimiter::Brace).is_some();
        cursor.skip_to(|cursor| cursor.at(';') || cursor.at_statement() || is_brace(cursor));
        cursor.eat_group(Delimiter::Brace);
    }

    /// Reads lines `label: e;` between braces into the places for their values; true if all could
    /// be read.
    pub(super) fn values<T>(
        &mut self,
        group: &Group,
        mut labels: BlockLabels,
        object: &mut T,
        place: for<'a> fn(&'a mut T, &'static str) -> &'a mut Option<AstId>,
    ) -> bool {
        self.lines(group, |parser, cursor| {
            let label = parser.label_of(&mut labels, cursor)?;
            parser.colon(label, cursor)?;
            *place(object, label) = Some(parser.line_value(cursor));
            Ok(())
        })
    }

    /// Reads lines between braces, each up to its semicolon; true if all could be read.
    pub(super) fn lines(
        &mut self,
        group: &Group,
        mut read: impl FnMut(&mut Self, &mut Cursor) -> Parsed<()>,
    ) -> bool {
        let mistakes = self.report.diagnostics().len();
        let complete = self.inside(group, |parser, cursor| {
            parser.each(cursor, |parser, cursor| {
                if cursor.eat(';').is_none() {
                    parser.line(&mut read, cursor);
                }
            });
            Ok(())
        });
        complete.is_ok() && self.report.diagnostics().len() == mistakes
    }

    fn line(&mut self, read: &mut impl FnMut(&mut Self, &mut Cursor) -> Parsed<()>, cursor: &mut Cursor) {
        self.skipped = false;
        if read(self, cursor).is_err() {
            self.skip_line(cursor);
        }
        if !self.skipped && at_comma_line(cursor) {
            self.fail_once(cursor.here(), messages::LINE_END, habits::LINE_END_HELP);
            cursor.skip_one();
            return;
        }
        let is_end_without_comma = cursor.at_end() && self.has_said(messages::LINE_END);
        let ended = cursor.eat(';').is_some() || self.skipped || is_end_without_comma;
        if ended || is_brace(cursor.previous()) {
            return;
        }
        if cursor.at_end() {
            let before = cursor.before().end;
            self.fail_with_help(before, messages::MISSING_SEMICOLON, scenes::LINE_HELP_END);
        } else if at_label(cursor) {
            let error = self.report.error(cursor.before().end, messages::MISSING_SEMICOLON);
            error.related(cursor.here(), scenes::NEXT_LABEL).help(scenes::LINE_HELP_END);
        } else {
            self.no_operator(cursor, "`;`");
            self.skip_line(cursor);
        }
    }

    fn skip_line(&mut self, cursor: &mut Cursor) {
        self.skipped = true;
        cursor.skip_to(|cursor| cursor.at(';') || at_label(cursor));
        cursor.eat(';');
    }

    /// Reads a label with its colon. A misspelt label is replaced by the intended one.
    pub(super) fn label_of(&mut self, labels: &mut BlockLabels, cursor: &mut Cursor) -> Parsed<&'static str> {
        let (here, found) = (cursor.here(), cursor.peek().cloned());
        let Some(word) = cursor.eat_ident().map(|word| word.to_string()) else {
            let message = messages::expected(&scenes::label(labels.owner), found.as_ref());
            let help = scenes::labels_are(labels.owner, &labels.known);
            return Err(self.fail_with_help(here, message, help));
        };
        let label = match labels.known.iter().find(|known| **known == word) {
            Some(label) => label,
            None => self.unknown_label(&word, here, labels)?,
        };
        if let Some(first) = labels.place(label) {
            let error = self.report.error(here, messages::repeated_label(label));
            error.related(first, messages::FIRST_HERE).help(messages::REPEATED_ATTRIBUTE_HELP);
            return Err(Reported);
        }
        labels.given.push((label, here));
        Ok(label)
    }

    /// Returns the label that was intended by a misspelt one.
    fn unknown_label(&mut self, word: &str, here: Origin, labels: &BlockLabels) -> Parsed<&'static str> {
        let known = || labels.known.iter().copied();
        let meant = foreign::label(word, known()).or_else(|| nearest(word, known()));
        let beside = scenes::beside_a_joint(word).filter(|_| labels.owner == "a joint");
        let help = match (meant, beside) {
            (Some(label), _) => messages::meant(label),
            (None, Some(help)) => help.to_owned(),
            (None, None) => scenes::labels_are(labels.owner, &labels.known),
        };
        let reported = self.fail_with_help(here, scenes::unknown_label(word, labels.owner), help);
        let meant = labels.known.iter().copied().find(|label| Some(*label) == meant);
        meant.filter(|label| labels.place(label).is_none()).ok_or(reported)
    }

    /// Consumes the colon after a label. If there is another sign, the value is still read.
    pub(super) fn colon(&mut self, label: &str, cursor: &mut Cursor) -> Parsed<()> {
        if cursor.at_same_word() {
            self.fail_with_help(cursor.skip_one(), habits::TWICE_IN_A_ROW, messages::REPEATED_ATTRIBUTE_HELP);
        }
        if cursor.eat(':').is_some() {
            return Ok(());
        }
        let message = messages::expected("`:`", cursor.peek());
        let reported = self.fail_once(cursor.here(), &message, &scenes::labelled(label));
        cursor.eat('=').map(|_| ()).ok_or(reported)
    }

    /// Reads the expression after a label. An unreadable one still counts as a value.
    pub(super) fn line_value(&mut self, cursor: &mut Cursor) -> AstId {
        let start = cursor.position();
        match self.expression(cursor) {
            Ok(id) if cursor.at(';') || cursor.at_end() || at_label(cursor) || at_comma_line(cursor) => {
                return id;
            }
            Ok(_) => self.no_operator(cursor, "`;`"),
            Err(reported) => reported,
        };
        self.skip_line(cursor);
        self.unreadable(cursor, start)
    }

    /// Fills in a placeholder for a value that is missing because it could not be read.
    pub(super) fn missing(&mut self, value: &mut Option<AstId>, origin: Origin) {
        if value.is_none() {
            *value = Some(self.add(Expression::Invalid, origin).id);
        }
    }
}

/// True if a word and a colon follow, not the two colons of a path.
pub(super) fn at_label(cursor: &Cursor) -> bool {
    let is_colon =
        |ahead| matches!(cursor.peek_past(ahead), Some(TokenTree::Punct(punct)) if punct.as_char() == ':');
    cursor.ident().is_some() && is_colon(1) && !is_colon(2)
}

/// True if there is a comma at the end of a line.
fn at_comma_line(cursor: &Cursor) -> bool {
    let is_sign = |ahead: usize, signs: &str| matches!(cursor.peek_past(ahead), Some(TokenTree::Punct(punct)) if signs.contains(punct.as_char()));
    let begins_line = matches!(cursor.peek_past(1), Some(TokenTree::Ident(_))) && is_sign(2, ":=");
    cursor.at(',') && (begins_line || cursor.peek_past(1).is_none())
}

fn is_brace(token: Option<&TokenTree>) -> bool {
    matches!(token, Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace)
}
