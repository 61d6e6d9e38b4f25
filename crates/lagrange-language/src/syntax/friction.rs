//! Statements that declare dry friction.

use proc_macro2::TokenTree;

use super::ast::{AstId, Friction, Name};
use super::cursor::Cursor;
use super::foreign;
use super::messages;
use super::messages::forms::form;
use super::parser::{Parsed, Parser, Reported};
use super::recovery::Turn;
use lagrange_expr::diagnostics::{Origin, nearest};

/// Labels after the slip velocity.
const LABELS: [&str; 3] = ["kinetic", "static", "smooth"];
/// Label of a value without a label.
const LIMIT: &str = "";

/// A value, its label and its place, from the label on.
type Labelled = (&'static str, AstId, Origin);

impl Parser<'_> {
    /// Reads `name = slip, limit`, with `kinetic:` and `static:` limits, or with `smooth: width`.
    pub(super) fn friction(&mut self, cursor: &mut Cursor) -> Parsed<Friction> {
        let name = self.declared_name(cursor)?;
        self.equals(form("friction"), cursor)?;
        let slip = self.expression(cursor)?;
        if cursor.eat(',').is_none() && !cursor.at_statement_end() {
            return Err(self.no_operator(cursor, "`,`"));
        }
        let values = self.labelled_values(cursor)?;
        if self.has_said(messages::EQUALS_BEHIND_LABEL) {
            return Err(Reported);
        }
        if let (Some(_), Some((.., origin))) = (find(&values, "smooth"), find(&values, "static")) {
            return Err(self.fail_with_help(*origin, messages::SMOOTH_WITH_STATIC, messages::SMOOTH_HELP));
        }
        let (kinetic, fixed) = self.limits(&name, &values, cursor)?;
        let width = find(&values, "smooth").map(|(_, width, _)| *width);
        Ok(Friction { name, slip, kinetic, fixed, width, is_moment: false })
    }

    /// Reads the values after the slip velocity.
    fn labelled_values(&mut self, cursor: &mut Cursor) -> Parsed<Vec<Labelled>> {
        let mut values = Vec::new();
        self.turns(cursor, |parser, cursor| {
            if cursor.at(';') || cursor.at_end() || cursor.at_statement() && !is_behind_comma(cursor) {
                return Ok(Turn::Last);
            }
            let value = parser.labelled(cursor)?;
            if find(&values, value.0).is_some() {
                return Err(parser.repeated_value(value.0, value.2));
            }
            values.push(value);
            Ok(Turn::next_if(cursor.eat(',').is_some()))
        })?;
        Ok(values)
    }

    /// Reads `e` or `label: e`, up to the next comma or the end of the statement.
    fn labelled(&mut self, cursor: &mut Cursor) -> Parsed<Labelled> {
        let start = cursor.position();
        let label = match is_labelled(cursor) || is_behind_comma(cursor) {
            true => self.label(cursor)?,
            false => LIMIT,
        };
        let value = self.item_value(cursor);
        Ok((label, value, cursor.since(start)))
    }

    fn label(&mut self, cursor: &mut Cursor) -> Parsed<&'static str> {
        let here = cursor.here();
        let word = cursor.eat_ident().map(|word| word.to_string()).unwrap_or_default();
        if cursor.eat(':').is_none() {
            self.fail_once(cursor.here(), messages::EQUALS_BEHIND_LABEL, form("friction"));
            cursor.skip_one();
        }
        if let Some(label) = LABELS.into_iter().find(|label| *label == word) {
            return Ok(label);
        }
        let help = match foreign::label(&word, LABELS).or_else(|| nearest(&word, LABELS)) {
            Some(known) => messages::meant(known),
            None => form("friction").to_owned(),
        };
        Err(self.fail_with_help(here, messages::unknown_label(&word), help))
    }

    fn repeated_value(&mut self, label: &str, origin: Origin) -> Reported {
        let message = match label {
            LIMIT => messages::SECOND_LIMIT.to_owned(),
            label => messages::repeated_label(label),
        };
        self.fail_with_help(origin, message, form("friction"))
    }

    /// Returns the kinetic limit, and the static one if it differs.
    fn limits(
        &mut self,
        name: &Name,
        values: &[Labelled],
        cursor: &Cursor,
    ) -> Parsed<(AstId, Option<AstId>)> {
        let (origin, message, help) = match [LIMIT, "kinetic", "static"].map(|label| find(values, label)) {
            [Some((_, limit, _)), None, None] => return Ok((*limit, None)),
            [None, Some((_, kinetic, _)), Some((_, fixed, _))] => return Ok((*kinetic, Some(*fixed))),
            [None, None, None] => {
                let message = messages::friction_without_limit(&name.text);
                (cursor.here(), message, form("friction"))
            }
            [Some((.., origin)), ..] => {
                (*origin, messages::UNLABELLED_LIMIT.to_owned(), messages::ONE_LIMIT_HELP)
            }
            [None, Some((.., origin)), None] => {
                (*origin, messages::lonely_limit("kinetic", "static"), messages::ONE_LIMIT_HELP)
            }
            [None, None, Some((.., origin))] => {
                (*origin, messages::lonely_limit("static", "kinetic"), messages::ONE_LIMIT_HELP)
            }
        };
        Err(self.fail_with_help(origin, message, help))
    }
}

fn find<'a>(values: &'a [Labelled], label: &str) -> Option<&'a Labelled> {
    values.iter().find(|(known, ..)| *known == label)
}

/// True if a label with an equals sign follows, which does not begin a statement after a comma.
fn is_behind_comma(cursor: &Cursor) -> bool {
    let is_comma = matches!(cursor.previous(), Some(TokenTree::Punct(punct)) if punct.as_char() == ',');
    let is_label = LABELS.iter().any(|label| cursor.at_word(label));
    is_comma && is_label && cursor.equals_past(1)
}

/// True if a word and a colon follow, not the two colons of a path.
fn is_labelled(cursor: &Cursor) -> bool {
    let is_colon = matches!(cursor.peek_past(1), Some(TokenTree::Punct(punct)) if punct.as_char() == ':');
    let is_path = matches!(cursor.peek_past(2), Some(TokenTree::Punct(punct)) if punct.as_char() == ':');
    cursor.ident().is_some() && is_colon && !is_path
}
