//! Ranges of parameters, and ranges and nominal values of entries of the state.

use proc_macro2::{Delimiter, Punct, Spacing, TokenTree};

use super::ast::{AllowedRange, AstId, Limit, LimitedEntry, Name};
use super::cursor::Cursor;
use super::messages::forms::form;
use super::messages::ranges as words;
use super::parser::{Parsed, Parser, Reported};
use lagrange_expr::units::meaning;

/// A bound, and true if it is the lower one.
type Comparison = (bool, Limit);

impl Parser<'_> {
    /// Reads `in 0..=1 nominal 0.1` after the name that this keyword declares; nothing if
    /// neither follows. Inputs and constants have neither, and parameters no nominal values.
    pub(super) fn limits_behind(
        &mut self,
        name: &Parsed<Name>,
        keyword: &str,
        cursor: &mut Cursor,
    ) -> (AllowedRange, Option<AstId>) {
        let name = name.as_ref().map_or("x", |name| name.text.as_str());
        self.range_and_nominal(name, keyword, cursor).unwrap_or_else(|Reported| {
            cursor.skip_to(|cursor| cursor.at(',') || cursor.equals_past(0) || cursor.at_statement_end());
            (AllowedRange::default(), None)
        })
    }

    /// Reads `x in 0..=1 nominal 0.1, dot(x) nominal 10`.
    pub(super) fn ranges(&mut self, cursor: &mut Cursor) -> Vec<LimitedEntry> {
        let help = form("range");
        self.settings(help, cursor, |parser, cursor| {
            let (target, start) = (parser.before_range(cursor)?, cursor.position());
            let (range, nominal) = parser.range_and_nominal("x", "coord", cursor)?;
            if cursor.position() == start {
                return Err(parser.fail_with_help(cursor.here(), words::NO_RANGE, help));
            }
            if cursor.equals_past(0) {
                return Err(parser.fail_with_help(cursor.here(), words::VALUE_BEHIND_RANGE, help));
            }
            Ok(LimitedEntry { target, range, nominal })
        })
    }

    fn range_and_nominal(
        &mut self,
        name: &str,
        keyword: &str,
        cursor: &mut Cursor,
    ) -> Parsed<(AllowedRange, Option<AstId>)> {
        let range = self.range(name, keyword, cursor)?;
        let Some(origin) = cursor.eat_word("nominal") else { return Ok((range, None)) };
        let value = self.before_default(Self::before_range, cursor)?;
        if cursor.at_word("in") || cursor.at('>') || cursor.at('<') {
            let help = words::RANGE_BEHIND_NOMINAL_HELP;
            return Err(self.fail_with_help(cursor.here(), words::RANGE_BEHIND_NOMINAL, help));
        }
        if !matches!(keyword, "coord" | "state" | "discrete") {
            self.fail_with_help(origin, words::not_in_state(keyword), words::NOT_IN_STATE_HELP);
            return Ok((range, None));
        }
        Ok((range, Some(value)))
    }

    fn range(&mut self, name: &str, keyword: &str, cursor: &mut Cursor) -> Parsed<AllowedRange> {
        let start = cursor.position();
        let range = match cursor.eat_word("in") {
            Some(_) => self.range_between_dots(cursor)?,
            None => self.range_of_comparisons(cursor)?,
        };
        if cursor.position() > start && cursor.at(':') {
            return Err(self.fail_with_help(cursor.here(), words::UNIT_BEHIND, words::UNIT_BEHIND_HELP));
        }
        let is_limited = !matches!(keyword, "input" | "const");
        if is_limited && (cursor.at_pair('=', '>') || cursor.at_pair('=', '<')) {
            return Err(self.fail_with_help(cursor.here_to_pair(), words::NO_SIGN, words::RANGE_HELP));
        }
        if is_limited || cursor.position() == start {
            return Ok(range);
        }
        self.fail_with_help(cursor.since(start), words::without_range(keyword), words::limit(keyword, name));
        Ok(AllowedRange::default())
    }

    /// Reads `0..`, `..1` or `0..=1`.
    fn range_between_dots(&mut self, cursor: &mut Cursor) -> Parsed<AllowedRange> {
        let (start, here) = (cursor.position(), cursor.here());
        if let Some(TokenTree::Group(group)) = cursor.peek()
            && group.delimiter() != Delimiter::Brace
            && let Some((lower, upper)) = group.stream().to_string().split_once(',')
        {
            let help = words::write_interval(lower.trim(), upper.trim());
            return Err(self.fail_with_help(here, words::INTERVAL, help));
        }
        let lower = match cursor.at_pair('.', '.') {
            true => None,
            false => Some(self.limit(true, cursor)?),
        };
        if !cursor.at_pair('.', '.') {
            let unit = match cursor.taken_since(start) {
                [TokenTree::Ident(word)] => Some(word.to_string()).filter(|word| meaning(word).is_some()),
                _ => None,
            };
            let help = unit.map_or_else(|| words::RANGE_HELP.to_owned(), words::range_or_unit);
            return Err(self.fail_with_help(cursor.since(start), words::NO_DOTS, help));
        }
        cursor.skip_one();
        // The equals sign belongs to the range if it follows immediately.
        let is_included = matches!(cursor.peek(), Some(TokenTree::Punct(dot)) if is_joint(dot));
        cursor.skip_one();
        let is_included = is_included && cursor.eat('=').is_some();
        let is_bare = cursor.at('=') || cursor.at(',') || cursor.at_statement_end();
        if is_bare && (is_included || lower.is_none()) {
            return Err(self.fail_with_help(cursor.since(start), words::NO_BOUND, words::RANGE_HELP));
        }
        let upper = match is_bare {
            true => None,
            false => Some(self.limit(is_included, cursor)?),
        };
        Ok(AllowedRange { lower, upper })
    }

    /// Reads `> 0` or `> 0 <= 1`.
    fn range_of_comparisons(&mut self, cursor: &mut Cursor) -> Parsed<AllowedRange> {
        let Some(first) = self.bound_by_comparison(cursor)? else { return Ok(AllowedRange::default()) };
        let origin = cursor.here_to_pair();
        let second = self.bound_by_comparison(cursor)?;
        if second.is_some_and(|(is_lower, _)| is_lower == first.0) {
            return Err(self.fail_with_help(origin, words::SAME_SIDE, words::RANGE_HELP));
        }
        let bound = |is_lower| {
            let mut given = [Some(first), second].into_iter().flatten();
            given.find(|(lower, _)| *lower == is_lower).map(|(_, limit)| limit)
        };
        Ok(AllowedRange { lower: bound(true), upper: bound(false) })
    }

    fn bound_by_comparison(&mut self, cursor: &mut Cursor) -> Parsed<Option<Comparison>> {
        let is_lower = cursor.at('>');
        if !is_lower && !cursor.at('<') {
            return Ok(None);
        }
        let is_included = matches!(cursor.pair(), Some((">=" | "<=", _)));
        cursor.skip_one();
        if is_included {
            cursor.skip_one();
        }
        Ok(Some((is_lower, self.limit(is_included, cursor)?)))
    }

    fn limit(&mut self, is_included: bool, cursor: &mut Cursor) -> Parsed<Limit> {
        Ok(Limit { value: self.before_default(Self::expression, cursor)?, is_included })
    }

    /// Reads an expression that may be followed by a default.
    fn before_default(
        &mut self,
        read: fn(&mut Self, &mut Cursor) -> Parsed<AstId>,
        cursor: &mut Cursor,
    ) -> Parsed<AstId> {
        self.precedes_default = true;
        let value = read(self, cursor);
        self.precedes_default = false;
        value
    }
}

fn is_joint(punct: &Punct) -> bool {
    punct.spacing() == Spacing::Joint
}
