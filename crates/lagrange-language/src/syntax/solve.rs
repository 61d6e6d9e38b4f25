//! Statements that define values by equations.

use proc_macro2::{Delimiter, TokenTree};

use super::ast::{AstId, Expression, Name, UnknownDefinition};
use super::cursor::Cursor;
use super::messages;
use super::messages::forms::form;
use super::messages::solve as words;
use super::options::StatementOptions;
use super::parser::{Parsed, Parser, Reported};
use super::recovery::Turn;
use super::units::at_unit;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_COUPLED;

/// Labels of the options after the equation.
const LABELS: [&str; 2] = ["start", "iterations"];
const OPTIONS: StatementOptions =
    StatementOptions { keyword: "solve", labels: &LABELS, unknown: words::unknown_option };

/// A value, its label and the place of the label.
type LabelledOption = (&'static str, AstId, Origin);

impl Parser<'_> {
    /// Reads `y: unit: 0 = e, start: e, iterations: n`, where the unit may be missing, or
    /// `(y: unit, z: unit): 0 = e, 0 = f, start: (e, f), iterations: n`.
    pub(super) fn unknowns(&mut self, cursor: &mut Cursor) -> Parsed<UnknownDefinition> {
        let here = cursor.here();
        let names = match cursor.eat_group(Delimiter::Parenthesis) {
            Some(group) => {
                let names = self.inside(&group, |parser, cursor| parser.component_names("solve", cursor))?;
                self.several("solve", names, &group)?
            }
            None => vec![self.single_unknown(cursor)?],
        };
        let residuals = self.equations(&names, cursor)?;
        if names.len() > MAX_COUPLED {
            let message = words::too_many(names.len(), MAX_COUPLED);
            return Err(self.fail_with_help(here, message, words::TOO_MANY_HELP));
        }
        if residuals.len() != names.len() {
            let message = words::unequal(names.len(), residuals.len());
            return Err(self.fail_with_help(here, message, words::UNEQUAL_HELP));
        }
        let options = self.options_of_unknowns(cursor)?;
        let said = |label| options.iter().find(|(known, ..)| *known == label).map(|(_, value, _)| *value);
        let starts = match said(LABELS[0]) {
            Some(start) => self.starts_of(&names, start)?,
            None => Vec::new(),
        };
        Ok(UnknownDefinition { names, residuals, starts, iterations: said(LABELS[1]) })
    }

    /// Reads `y: unit`.
    fn single_unknown(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        let mut name = self.declared_name(cursor)?;
        if at_unit(cursor) && has_unit(cursor) {
            name.unit = self.unit_behind_colon(cursor);
        }
        Ok(name)
    }

    /// Reads `: 0 = e, 0 = f`.
    fn equations(&mut self, names: &[Name], cursor: &mut Cursor) -> Parsed<Vec<AstId>> {
        if cursor.eat(':').is_none() {
            let message = messages::expected("`:`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, form("solve")));
        }
        let mut residuals = vec![self.equation(names, cursor)?];
        self.turns(cursor, |parser, cursor| {
            let is_due = residuals.len() < names.len() && cursor.equals_past(2);
            if !cursor.at(',') || !(is_due || is_zero(cursor.peek_past(1))) {
                return Ok(Turn::Last);
            }
            cursor.skip_one();
            residuals.push(parser.equation(names, cursor)?);
            Ok(Turn::Next)
        })?;
        Ok(residuals)
    }

    /// Reads `0 = e`.
    fn equation(&mut self, names: &[Name], cursor: &mut Cursor) -> Parsed<AstId> {
        if !is_zero(cursor.peek()) || !cursor.equals_past(1) {
            let help = words::zero_on_the_left(names);
            return Err(self.fail_with_help(cursor.here(), words::NO_ZERO_ON_THE_LEFT, help));
        }
        cursor.skip_one();
        self.equals(form("solve"), cursor)?;
        Ok(self.item_value(cursor))
    }

    /// Returns the parts of `(s, t)`, one for each name.
    fn starts_of(&mut self, names: &[Name], start: AstId) -> Parsed<Vec<AstId>> {
        match self.expressions.get(start) {
            _ if names.len() == 1 => Ok(vec![start]),
            Expression::Invalid => Err(Reported),
            Expression::Tuple(parts) if parts.len() == names.len() => Ok(parts.clone()),
            _ => {
                let place = self.expressions.origin(start);
                Err(self.fail_with_help(place, words::unequal_starts(names.len()), words::starts_help(names)))
            }
        }
    }

    /// Reads `, start: e, iterations: n`.
    fn options_of_unknowns(&mut self, cursor: &mut Cursor) -> Parsed<Vec<LabelledOption>> {
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

fn is_zero(token: Option<&TokenTree>) -> bool {
    matches!(token, Some(TokenTree::Literal(zero)) if zero.to_string() == "0")
}

/// True if another colon follows before the equation.
fn has_unit(cursor: &Cursor) -> bool {
    let is = |token: &TokenTree, signs: &[char]| matches!(token, TokenTree::Punct(sign) if signs.contains(&sign.as_char()));
    let mut behind = cursor.rest().iter().skip(1);
    behind.find(|token| is(token, &[':', '=', ',', ';'])).is_some_and(|end| is(end, &[':']))
}
