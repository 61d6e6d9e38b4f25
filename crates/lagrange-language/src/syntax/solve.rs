//! Statements that define a value by an equation.

use proc_macro2::TokenTree;

use super::ast::{AstId, Name, UnknownDefinition};
use super::cursor::Cursor;
use super::messages;
use super::messages::forms::form;
use super::messages::solve as words;
use super::options::StatementOptions;
use super::parser::{Parsed, Parser};
use super::units::at_unit;
use lagrange_expr::diagnostics::Origin;

/// Labels of what is said behind the equation.
const LABELS: [&str; 2] = ["start", "iterations"];
const OPTIONS: StatementOptions =
    StatementOptions { keyword: "solve", labels: LABELS, unknown: words::unknown_option };

/// A value, its label and where that stands.
type LabelledOption = (&'static str, AstId, Origin);

impl Parser<'_> {
    /// `y: unit: 0 = e, start: e, iterations: n`, where the unit may be missing.
    pub(super) fn unknown(&mut self, cursor: &mut Cursor) -> Parsed<UnknownDefinition> {
        let mut name = self.declared_name(cursor)?;
        if at_unit(cursor) && has_unit(cursor) {
            name.unit = self.unit_behind_colon(cursor);
        }
        let residual = self.equation(&name, cursor)?;
        let options = self.options_of_unknown(cursor)?;
        let said = |label| options.iter().find(|(known, ..)| *known == label).map(|(_, value, _)| *value);
        Ok(UnknownDefinition { name, residual, start: said(LABELS[0]), iterations: said(LABELS[1]) })
    }

    /// `: 0 = e`.
    fn equation(&mut self, name: &Name, cursor: &mut Cursor) -> Parsed<AstId> {
        if cursor.eat(':').is_none() {
            let message = messages::expected("`:`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, form("solve")));
        }
        let is_zero = matches!(cursor.peek(), Some(TokenTree::Literal(zero)) if zero.to_string() == "0");
        if !is_zero || !cursor.equals_past(1) {
            let help = words::zero_on_the_left(&name.text);
            return Err(self.fail_with_help(cursor.here(), words::NO_ZERO_ON_THE_LEFT, help));
        }
        cursor.skip_one();
        self.equals(form("solve"), cursor)?;
        Ok(self.item_value(cursor))
    }

    /// `, start: e, iterations: n`.
    fn options_of_unknown(&mut self, cursor: &mut Cursor) -> Parsed<Vec<LabelledOption>> {
        let mut options: Vec<LabelledOption> = Vec::new();
        self.labelled_options(&OPTIONS, cursor, |parser, label, here, cursor| {
            let first = options.iter().find(|(known, ..)| *known == label);
            parser.once(label, here, first.map(|(.., first)| *first));
            options.push((label, parser.item_value(cursor), here));
            Ok(())
        })?;
        Ok(options)
    }
}

/// True if what stands behind the colon ends in another one, in front of the equation.
fn has_unit(cursor: &Cursor) -> bool {
    let is = |token: &TokenTree, signs: &[char]| matches!(token, TokenTree::Punct(sign) if signs.contains(&sign.as_char()));
    let mut behind = cursor.rest().iter().skip(1);
    behind.find(|token| is(token, &[':', '=', ',', ';'])).is_some_and(|end| is(end, &[':']))
}
