//! Ranges of parameters.

use proc_macro2::{Delimiter, Punct, Spacing, TokenTree};

use super::ast::{AllowedRange, Limit, Name};
use super::cursor::Cursor;
use super::messages::ranges as words;
use super::parser::{Parsed, Parser, Reported};
use lagrange_expr::units::meaning;

/// A bound, and true if it is the lower one.
type Comparison = (bool, Limit);

impl Parser<'_> {
    /// Reads `in 0..=1`, `> 0` or `> 0 <= 1` after the name of a parameter; no bounds if no range
    /// follows. Other names have no range.
    pub(super) fn range_behind(
        &mut self,
        name: &Parsed<Name>,
        keyword: &str,
        cursor: &mut Cursor,
    ) -> AllowedRange {
        let name = name.as_ref().map_or("x", |name| name.text.as_str());
        self.range(name, keyword, cursor).unwrap_or_else(|Reported| {
            cursor.skip_to(|cursor| cursor.at(',') || cursor.equals_past(0) || cursor.at_statement_end());
            AllowedRange::default()
        })
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
        if keyword == "param" && (cursor.at_pair('=', '>') || cursor.at_pair('=', '<')) {
            return Err(self.fail_with_help(cursor.here_to_pair(), words::NO_SIGN, words::RANGE_HELP));
        }
        if keyword == "param" || cursor.position() == start {
            return Ok(range);
        }
        self.fail_with_help(
            cursor.since(start),
            words::not_a_parameter(keyword),
            words::limit(keyword, name),
        );
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
        self.precedes_default = true;
        let value = self.expression(cursor);
        self.precedes_default = false;
        Ok(Limit { value: value?, is_included })
    }
}

fn is_joint(punct: &Punct) -> bool {
    punct.spacing() == Spacing::Joint
}
