//! Labelled options at the end of statements: `, interpolation: natural, outside: extend`.

use super::cursor::Cursor;
use super::foreign;
use super::messages;
use super::messages::forms::form;
use super::parser::{Parsed, Parser};
use super::recovery::Turn;
use lagrange_expr::diagnostics::{Origin, nearest};

/// The options of a kind of statement.
pub(super) struct StatementOptions {
    /// The keyword of the statement.
    pub(super) keyword: &'static str,
    pub(super) labels: &'static [&'static str],
    /// Message about a word that is not a label.
    pub(super) unknown: fn(&str) -> String,
}

impl Parser<'_> {
    /// Reads options as long as there are any; `read` reads the value after a label and receives
    /// the place of the label.
    pub(super) fn labelled_options(
        &mut self,
        options: &StatementOptions,
        cursor: &mut Cursor,
        mut read: impl FnMut(&mut Self, &'static str, Origin, &mut Cursor) -> Parsed<()>,
    ) -> Parsed<()> {
        self.turns(cursor, |parser, cursor| {
            if cursor.eat(',').is_none() {
                return Ok(Turn::Last);
            }
            let here = cursor.here();
            let label = parser.option_label(options, cursor)?;
            if cursor.eat(':').is_none() {
                let message = messages::expected("`:`", cursor.peek());
                return Err(parser.fail_with_help(cursor.here(), message, form(options.keyword)));
            }
            read(parser, label, here, cursor)?;
            Ok(Turn::Next)
        })
    }

    fn option_label(&mut self, options: &StatementOptions, cursor: &mut Cursor) -> Parsed<&'static str> {
        let (here, word) = (cursor.here(), cursor.eat_ident().map(|word| word.to_string()));
        let word = word.unwrap_or_default();
        let labels = || options.labels.iter().copied();
        if let Some(label) = labels().find(|label| *label == word) {
            return Ok(label);
        }
        let meant = foreign::label(&word, labels()).or_else(|| nearest(&word, labels()));
        let help = meant.map_or(form(options.keyword).to_owned(), messages::meant);
        Err(self.fail_with_help(here, (options.unknown)(&word), help))
    }

    /// Reports a label that has already occurred.
    pub(super) fn once(&mut self, label: &str, place: Origin, first: Option<Origin>) {
        if let Some(first) = first {
            let error = self.report.error(place, messages::repeated_label(label));
            error.related(first, messages::FIRST_HERE).help(messages::REPEATED_ATTRIBUTE_HELP);
        }
    }
}
