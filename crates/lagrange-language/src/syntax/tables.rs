//! Statements that tabulate functions.

mod grid;

use proc_macro2::{Delimiter, Group, Span, TokenTree};

use super::ast::{AstId, Name, TableDefinition, TableSource};
use super::cursor::{Cursor, group_origin};
use super::messages;
use super::messages::forms::form;
use super::messages::tables as words;
use super::options::StatementOptions;
use super::parser::{Parsed, Parser};
use super::recovery::Turn;
use grid::{Row, TableValues};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_TABLE_ARGUMENTS;
use lagrange_expr::opaque::{Interpolation, Outside};

/// The options after the points, with their places.
#[derive(Default)]
struct TableOptions {
    interpolation: Option<(Interpolation, Span)>,
    outside: Option<(Outside, Span)>,
    /// Numbers of `rows` and `columns`.
    axes: [Option<Row>; 2],
}

/// Labels of the options after the points.
const LABELS: [&str; 4] = ["rows", "columns", "interpolation", "outside"];
const OPTIONS: StatementOptions =
    StatementOptions { keyword: "table", labels: &LABELS, unknown: words::unknown_option };

impl Parser<'_> {
    /// Reads `f(x) = [(a, b), (c, d)], interpolation: natural, outside: extend`.
    pub(super) fn table(&mut self, cursor: &mut Cursor) -> Parsed<TableDefinition> {
        let (name, parameters) = self.function_head("table", cursor)?;
        if let Some(beyond) = parameters.get(MAX_TABLE_ARGUMENTS) {
            let message = words::too_many_arguments(MAX_TABLE_ARGUMENTS);
            return Err(self.fail_with_help(beyond.span, message, form("table")));
        }
        self.equals(form("table"), cursor)?;
        let values = self.points_or_file(parameters.len() + 1, cursor)?;
        let options = self.options(cursor)?;
        let source = self.on_axes(values, options.axes, (&name, &parameters))?;
        let mut unsaid = |label: &'static str, help: String| {
            self.fail_with_help(name.span, words::unsaid(label, &name.text), help)
        };
        let Some((interpolation, place)) = options.interpolation else {
            return Err(unsaid(LABELS[2], words::ways(LABELS[2], &Interpolation::ALL.map(|(name, _)| name))));
        };
        let Some((outside, _)) = options.outside else {
            return Err(unsaid(LABELS[3], words::ways(LABELS[3], &Outside::ALL.map(|(name, _)| name))));
        };
        if interpolation == Interpolation::Monotone && parameters.len() > 2 {
            self.report.error(place, words::MONOTONE_VOLUME).help(words::MONOTONE_VOLUME_HELP);
        }
        Ok(TableDefinition { name, parameters, source, interpolation, outside })
    }

    fn points_or_file(&mut self, components: usize, cursor: &mut Cursor) -> Parsed<TableValues> {
        if let Some(group) = cursor.eat_group(Delimiter::Bracket) {
            return self.inside(&group, |parser, cursor| match cursor.group(Delimiter::Bracket) {
                Some(_) if components == 3 => parser.rows(cursor),
                _ => parser.points(components, cursor),
            });
        }
        let path = self.string(words::POINTS, form("table"), cursor)?;
        Ok(TableValues::Source(TableSource::File { path, contents: None }))
    }

    /// Reads a string; anything else is reported, with what was expected instead.
    pub(super) fn string(&mut self, expected: &str, help: &str, cursor: &mut Cursor) -> Parsed<Name> {
        let literal = match cursor.peek() {
            Some(TokenTree::Literal(literal)) => syn::parse2(TokenTree::Literal(literal.clone()).into()).ok(),
            _ => None,
        };
        let Some(string): Option<syn::LitStr> = literal else {
            let message = messages::expected(expected, cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, help));
        };
        cursor.skip_one();
        Ok(Name::new(string.value(), string.span()))
    }

    fn points(&mut self, components: usize, cursor: &mut Cursor) -> Parsed<TableValues> {
        let form = (words::POINT, words::point_help(components));
        let points = self.groups(Delimiter::Parenthesis, form, cursor, |parser, group| {
            Ok((parser.point(components, group)?, group_origin(group)))
        })?;
        Ok(TableValues::Source(TableSource::Points(points)))
    }

    /// Reads groups in these brackets, separated by commas; anything else is reported, with what
    /// was expected instead and its form.
    fn groups<T>(
        &mut self,
        delimiter: Delimiter,
        (expected, help): (&str, &str),
        cursor: &mut Cursor,
        mut read: impl FnMut(&mut Self, &Group) -> Parsed<T>,
    ) -> Parsed<Vec<T>> {
        let mut items = Vec::new();
        self.turns(cursor, |parser, cursor| {
            if cursor.at_end() {
                return Ok(Turn::Last);
            }
            let Some(group) = cursor.eat_group(delimiter) else {
                let message = messages::expected(expected, cursor.peek());
                return Err(parser.fail_with_help(cursor.here(), message, help));
            };
            items.push(read(parser, &group)?);
            if cursor.eat(',').is_none() && !cursor.at_end() {
                let message = messages::expected("`,` or `]`", cursor.peek());
                return Err(parser.fail_with_help(cursor.here(), message, form("table")));
            }
            Ok(Turn::Next)
        })?;
        Ok(items)
    }

    /// Reads `a, b` between parentheses.
    fn point(&mut self, components: usize, group: &Group) -> Parsed<Vec<AstId>> {
        let point = self.numbers(group, "`,` or `)`")?;
        if point.len() == components {
            return Ok(point);
        }
        let message = words::component_count(point.len());
        Err(self.fail_with_help(group_origin(group), message, words::point_help(components)))
    }

    /// Reads `a, b` between brackets; `ends` names what may follow a number.
    fn numbers(&mut self, group: &Group, ends: &str) -> Parsed<Vec<AstId>> {
        self.inside(group, |parser, cursor| {
            let mut numbers = Vec::new();
            parser.turns(cursor, |parser, cursor| {
                numbers.push(parser.expression(cursor)?);
                Ok(Turn::next_if(cursor.eat(',').is_some() && !cursor.at_end()))
            })?;
            match cursor.at_end() {
                true => Ok(numbers),
                false => Err(parser.no_operator(cursor, ends)),
            }
        })
    }

    /// Reads `, interpolation: natural, outside: extend`.
    fn options(&mut self, cursor: &mut Cursor) -> Parsed<TableOptions> {
        let mut options = TableOptions::default();
        self.labelled_options(&OPTIONS, cursor, |parser, label, here, cursor| {
            parser.option(label, here, &mut options, cursor)
        })?;
        if !cursor.at_statement_end() {
            return Err(self.no_operator(cursor, "`,` or `;`"));
        }
        Ok(options)
    }

    fn option(
        &mut self,
        label: &'static str,
        place: Origin,
        options: &mut TableOptions,
        cursor: &mut Cursor,
    ) -> Parsed<()> {
        let place_of = |axis: &Option<Row>| axis.as_ref().map(|(_, first)| *first);
        let first = match label {
            "rows" => place_of(&options.axes[0]),
            "columns" => place_of(&options.axes[1]),
            "interpolation" => options.interpolation.map(|(_, first)| first.into()),
            _ => options.outside.map(|(_, first)| first.into()),
        };
        self.once(label, place, first);
        let span = cursor.here().start;
        match label {
            "rows" => options.axes[0] = Some(self.axis(cursor)?),
            "columns" => options.axes[1] = Some(self.axis(cursor)?),
            "interpolation" => {
                options.interpolation = Some((self.way(label, Interpolation::ALL, cursor)?, span));
            }
            _ => options.outside = Some((self.way(label, Outside::ALL, cursor)?, span)),
        }
        Ok(())
    }

    /// Reads one of several variants, by name.
    fn way<T>(&mut self, label: &str, ways: [(&'static str, T); 3], cursor: &mut Cursor) -> Parsed<T> {
        let names = ways.each_ref().map(|(name, _)| *name);
        let (here, word) = (cursor.here(), cursor.ident().map(ToString::to_string));
        let found = ways.into_iter().find(|(name, _)| word.as_deref() == Some(*name));
        let Some((_, way)) = found else {
            let help = words::ways_beside(label, &names, word.as_deref().unwrap_or_default());
            let message = match word {
                Some(word) => words::unknown_way(label, &word),
                None => messages::expected("a name", cursor.peek()),
            };
            return Err(self.fail_with_help(here, message, help));
        };
        cursor.skip_one();
        Ok(way)
    }
}
