//! Statements that declare reduced types.

use proc_macro2::Delimiter;

use super::ast::{Reduction, ReductionItem, ReductionKind};
use super::cursor::Cursor;
use super::foreign;
use super::messages;
use super::messages::forms::form;
use super::parser::{Parsed, Parser};
use lagrange_expr::diagnostics::nearest;

/// The words that can begin a line of a reduction.
const WORDS: [(&str, ReductionKind); 3] =
    [("freeze", ReductionKind::Frozen), ("small", ReductionKind::Small), ("ignore", ReductionKind::Ignored)];

impl Parser<'_> {
    /// Reads `Name { freeze x = e; small theta, phi = e; ignore psi; }`.
    pub(super) fn reduction(&mut self, cursor: &mut Cursor) -> Parsed<Reduction> {
        let name = self.type_name(cursor)?;
        let Some(group) = cursor.eat_group(Delimiter::Brace) else {
            let message = messages::expected("`{`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, form("reduce")));
        };
        let nothing = (messages::NOTHING_REDUCED, form("reduce"));
        Ok(Reduction { name, items: self.some_lines(&group, nothing, Self::reduction_line) })
    }

    fn reduction_line(&mut self, cursor: &mut Cursor) -> Parsed<Vec<ReductionItem>> {
        let (here, found) = (cursor.here(), cursor.peek().cloned());
        let word = cursor.eat_ident().map(|word| word.to_string()).unwrap_or_default();
        let Some((_, kind)) = WORDS.iter().find(|(known, _)| *known == word) else {
            let message = messages::expected(messages::REDUCTION_ITEM, found.as_ref());
            let known = WORDS.map(|(known, _)| known);
            let help = match foreign::label(&word, known).or_else(|| nearest(&word, known)) {
                Some(known) => messages::meant(known),
                None => form("reduce").to_owned(),
            };
            return Err(self.fail_with_help(here, message, help));
        };
        Ok(self.items(form("reduce"), cursor, |parser, cursor| parser.reduction_item(*kind, cursor)))
    }

    fn reduction_item(&mut self, kind: ReductionKind, cursor: &mut Cursor) -> Parsed<ReductionItem> {
        let coordinate = self.name(cursor)?;
        let coordinate = self.indexed(coordinate, cursor)?;
        let coordinate = self.with_members(coordinate, cursor)?;
        let (here, value) = (cursor.here(), cursor.eat_equals().map(|_| self.item_value(cursor)));
        if value.is_none() && kind == ReductionKind::Frozen {
            let message = messages::frozen_without_value(&coordinate.text);
            let help = messages::frozen_without_value_help(&coordinate.text);
            self.report.error(coordinate.span, message).help(help);
        }
        if value.is_some() && kind == ReductionKind::Ignored {
            let message = messages::ignored_with_value(&coordinate.text);
            self.report.error(here, message).help(messages::IGNORED_WITH_VALUE_HELP);
        }
        Ok(ReductionItem { coordinate, kind, value, enclosures: Vec::new() })
    }
}
