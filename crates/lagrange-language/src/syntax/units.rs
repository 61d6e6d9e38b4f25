//! Units of measurement after names and numbers.

use lagrange_expr::keywords::is_rust_keyword;
use proc_macro2::{Delimiter, TokenTree};

use super::ast::{Expression, Name};
use super::cursor::Cursor;
use super::expressions::ReadOperand;
use super::keywords;
use super::literals::TYPES;
use super::messages;
use super::messages::units as words;
use super::parser::{Parsed, Parser, Reported};
use super::recovery::Turn;
use lagrange_expr::diagnostics::{Origin, nearest};
use lagrange_expr::limits::MAX_UNIT_EXPONENT;
use lagrange_expr::number::Number;
use lagrange_expr::units::{Unit, UnitFactor, meaning, meant, names};

impl Parser<'_> {
    /// Reads a colon and the unit after it. Unreadable tokens are skipped up to the value or the
    /// next name.
    pub(super) fn unit_behind_colon(&mut self, cursor: &mut Cursor) -> Option<Box<Unit>> {
        cursor.skip_one();
        let unit = self.unit(cursor).ok();
        if unit.is_none() {
            let ends = |cursor: &Cursor| {
                cursor.equals_past(0) || cursor.at(',') || cursor.at(';') || cursor.at_statement()
            };
            cursor.skip_to(ends);
        }
        unit
    }

    /// Reads the unit after a number: a named unit, possibly with an exponent, or any unit in
    /// square brackets.
    pub(super) fn quantity(&mut self, number: ReadOperand, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        let unit = match cursor.peek() {
            Some(TokenTree::Ident(word)) if self.is_unit_here(&word.to_string(), cursor) => {
                self.short_unit(cursor)?
            }
            Some(TokenTree::Punct(percent)) if percent.as_char() == '%' && self.is_percent_here(cursor) => {
                self.short_unit(cursor)?
            }
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket && !self.counts => {
                let group = group.clone();
                cursor.skip_one();
                self.inside(&group, |parser, cursor| {
                    let unit = parser.unit(cursor)?;
                    match cursor.at_end() {
                        true => Ok(unit),
                        false => Err(parser.no_unit_sign(cursor)),
                    }
                })?
            }
            _ => return Ok(number),
        };
        let origin = number.origin.to(cursor.before());
        Ok(self.add(Expression::Quantity(number.id, unit), origin))
    }

    /// True if the sign here is a percent unit rather than the remainder operator.
    fn is_percent_here(&self, cursor: &Cursor) -> bool {
        let is_operand = matches!(
            cursor.peek_past(1),
            Some(TokenTree::Ident(_) | TokenTree::Literal(_) | TokenTree::Group(_))
        );
        !self.counts && !is_operand
    }

    /// True if the word here is a unit rather than a defined name or a called function.
    fn is_unit_here(&self, word: &str, cursor: &Cursor) -> bool {
        let is_call = matches!(cursor.peek_past(1), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis);
        let is_word = is_rust_keyword(word) || keywords::is_connective(word);
        meaning(word).is_some()
            && self.is_free_unit(word)
            && !is_call
            && !is_word
            && (self.precedes_default || !cursor.equals_past(1))
            && !cursor.at_statement()
    }

    /// Reads `deg` or `m^2` after a number. Several factors are reported, since names of the
    /// declaration follow `*` and `/`.
    fn short_unit(&mut self, cursor: &mut Cursor) -> Parsed<Box<Unit>> {
        if let Some(quotation) = self.several_factors(cursor) {
            let (place, help) = quotation;
            return Err(self.fail_with_help(place, words::SEVERAL_FACTORS, help));
        }
        let (start, mut factors) = (cursor.position(), Vec::new());
        self.unit_factor(&Number::ONE, &mut factors, cursor)?;
        self.unit_of(factors, cursor.since(start))
    }

    /// Reads a unit up to the first token that cannot continue it.
    pub(super) fn unit(&mut self, cursor: &mut Cursor) -> Parsed<Box<Unit>> {
        let (start, mut factors) = (cursor.position(), Vec::new());
        self.unit_factors(&Number::ONE, &mut factors, cursor)?;
        self.unit_of(factors, cursor.since(start))
    }

    fn unit_of(&mut self, factors: Vec<UnitFactor>, origin: Origin) -> Parsed<Box<Unit>> {
        self.has_units = true;
        let is_alone = matches!(&factors[..], [factor] if factor.exponent == Number::ONE);
        if let Some(point) = factors.iter().find(|factor| has_offset(&factor.name)).filter(|_| !is_alone) {
            return Err(self.fail_with_help(origin, words::offset_in_unit(&point.name), words::OFFSET_HELP));
        }
        match Unit::of(factors, origin) {
            Some(unit) => {
                self.has_dimensions |= !unit.dimension.is_none();
                Ok(Box::new(unit))
            }
            None => Err(self.fail_with_help(origin, words::NOT_EXACT, words::NOT_EXACT_HELP)),
        }
    }

    /// Reads `a*b/c` to a power.
    fn unit_factors(
        &mut self,
        power: &Number,
        factors: &mut Vec<UnitFactor>,
        cursor: &mut Cursor,
    ) -> Parsed<()> {
        let mut power = power.clone();
        let over = -&power;
        let above = power.clone();
        self.turns(cursor, |parser, cursor| {
            parser.unit_factor(&power, factors, cursor)?;
            power = if cursor.at('/') { over.clone() } else { above.clone() };
            let goes_on = cursor.pair().is_none() && (cursor.eat('/').is_some() || cursor.eat('*').is_some());
            Ok(Turn::next_if(goes_on))
        })
    }

    /// Reads `m`, `1` or `(…)`, with an exponent or without.
    fn unit_factor(
        &mut self,
        power: &Number,
        factors: &mut Vec<UnitFactor>,
        cursor: &mut Cursor,
    ) -> Parsed<()> {
        let mut own = match cursor.peek() {
            Some(TokenTree::Ident(word)) => {
                let (name, here) = (word.to_string(), cursor.here());
                if meaning(&name).is_none() {
                    return Err(self.unknown_unit(&name, here));
                }
                cursor.skip_one();
                vec![UnitFactor { name, exponent: Number::ONE }]
            }
            Some(TokenTree::Punct(percent)) if percent.as_char() == '%' => {
                cursor.skip_one();
                vec![UnitFactor { name: "%".to_owned(), exponent: Number::ONE }]
            }
            Some(TokenTree::Literal(one)) if one.to_string() == "1" => {
                cursor.skip_one();
                Vec::new()
            }
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => {
                let group = group.clone();
                cursor.skip_one();
                self.inside(&group, |parser, cursor| {
                    let mut inner = Vec::new();
                    parser.unit_factors(&Number::ONE, &mut inner, cursor)?;
                    match cursor.at_end() {
                        true => Ok(inner),
                        false => Err(parser.no_unit_sign(cursor)),
                    }
                })?
            }
            _ => return Err(self.no_unit_sign(cursor)),
        };
        let exponent = match cursor.eat('^') {
            Some(_) => power * &self.unit_exponent(cursor)?,
            None => power.clone(),
        };
        own.iter_mut().for_each(|factor| factor.exponent = &factor.exponent * &exponent);
        factors.extend(own);
        Ok(())
    }

    /// Reads `2`, `-1`, `(1/2)` or `(-1/2)` after `^`.
    fn unit_exponent(&mut self, cursor: &mut Cursor) -> Parsed<Number> {
        let here = cursor.here();
        let exponent = match cursor.eat_group(Delimiter::Parenthesis) {
            None => self.signed_number(cursor)?,
            Some(group) => self.inside(&group, |parser, cursor| {
                let above = parser.signed_number(cursor)?;
                let below = match cursor.eat('/') {
                    Some(_) => parser.signed_number(cursor)?,
                    None => Number::ONE,
                };
                match below.reciprocal().filter(|_| cursor.at_end()) {
                    Some(over) => Ok(&above * &over),
                    None => Err(parser.no_unit_sign(cursor)),
                }
            })?,
        };
        match exponent.abs() <= Number::from(MAX_UNIT_EXPONENT) {
            true => Ok(exponent),
            false => Err(self.fail_with_help(here, words::LARGE_EXPONENT, words::UNIT_HELP)),
        }
    }

    fn signed_number(&mut self, cursor: &mut Cursor) -> Parsed<Number> {
        let is_negative = cursor.eat('-').is_some();
        let Some(TokenTree::Literal(literal)) = cursor.peek() else {
            return Err(self.no_unit_sign(cursor));
        };
        let number = self.number(&literal.clone())?;
        cursor.skip_one();
        Ok(if is_negative { -&number } else { number })
    }

    /// Reports a token that is invalid in a unit.
    fn no_unit_sign(&mut self, cursor: &Cursor) -> Reported {
        let message = messages::expected(words::UNIT, cursor.peek());
        self.fail_with_help(cursor.here(), message, words::UNIT_HELP)
    }

    pub(super) fn unknown_unit(&mut self, word: &str, place: Origin) -> Reported {
        let known = names();
        let help = match (meant(word), nearest(word, known.iter().map(String::as_str))) {
            (Some(unit), _) => words::write_unit(unit),
            (None, Some(unit)) => words::did_you_mean(unit),
            (None, None) => words::UNIT_HELP.to_owned(),
        };
        self.fail_with_help(place, words::unknown(word), help)
    }

    /// Reports units of the parameters of a function defined by `let`, which adopts the units of
    /// its arguments.
    pub(super) fn refuse_units(&mut self, names: &[Name]) {
        if let Some(unit) = names.iter().find_map(|name| name.unit.as_ref()) {
            self.fail_with_help(unit.origin, words::ON_LET_FUNCTION, words::ON_LET_FUNCTION_HELP);
        }
    }
}

fn has_offset(unit: &str) -> bool {
    meaning(unit).is_some_and(|meaning| !meaning.offset.is_zero())
}

/// True if a colon and a unit follow, but not the name of a Rust type.
pub(super) fn at_unit(cursor: &Cursor) -> bool {
    let begins_unit = match cursor.peek_past(1) {
        Some(TokenTree::Ident(word)) => !TYPES.contains(&word.to_string().as_str()),
        Some(TokenTree::Literal(literal)) => literal.to_string() == "1",
        Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Parenthesis,
        Some(TokenTree::Punct(percent)) => percent.as_char() == '%',
        _ => false,
    };
    cursor.at(':') && begins_unit
}
