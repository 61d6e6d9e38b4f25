//! Parts, their placements, and the files that contain them.

use proc_macro2::{Delimiter, Group, TokenTree};

use super::ast::{AstId, Block, Name, PartArgument, PartDefinition, Placement, Range, StatementKind};
use super::cursor::Cursor;
use super::messages;
use super::messages::forms::form;
use super::messages::parts as words;
use super::parser::{Declared, Parsed, Parser, Reported};

/// An array of parts: the variable and its values.
type Count = Option<(Name, Range)>;

impl Parser<'_> {
    /// Reads `Leg(side, l = 0.2 m) { … }` after the word `part`.
    pub(super) fn part_definition(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let start = cursor.position().saturating_sub(1);
        let name = self.free_name(cursor)?;
        // Names inside are only known inside, and outer names are not.
        let outside = std::mem::take(&mut self.declared_names);
        let arguments = match cursor.eat_group(Delimiter::Parenthesis) {
            Some(group) if group.stream().is_empty() => Ok(Vec::new()),
            Some(group) => self
                .inside(&group, |parser, cursor| Ok(parser.items(form("part"), cursor, Self::part_argument))),
            None => Ok(Vec::new()),
        };
        let body = self.statements_between_braces(form("part"), cursor);
        self.declared_names = outside;
        let (arguments, body, origin) = (arguments?, body?, cursor.since(start));
        let part = PartDefinition { name, arguments, body, origin, is_included: false };
        Ok(StatementKind::Block(Block::Part(Box::new(part))))
    }

    fn part_argument(&mut self, cursor: &mut Cursor) -> Parsed<PartArgument> {
        let name = self.free_name(cursor)?;
        if cursor.at(':') {
            self.fail_with_help(cursor.here(), words::UNIT, words::unit_help(&name.text));
            cursor.skip_to(|cursor| cursor.equals_past(0) || cursor.at(','));
        }
        self.declared_names.insert(name.text.clone(), Declared::Other);
        let default = cursor.eat_equals().map(|_| self.item_value(cursor));
        Ok(PartArgument { name, default })
    }

    /// Reads `leg[i in 0..4]: Leg { side: e; }`.
    pub(super) fn placement(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let name = self.free_name(cursor)?;
        let (name, count) = self.placed_name(name, cursor)?;
        cursor.eat(':');
        self.declared_names.insert(name.text.clone(), Declared::Other);
        let part = self.name(cursor)?;
        let variable = count.as_ref().map(|(variable, _)| variable.clone());
        let arguments = match variable {
            Some(variable) => self.within(&variable, |parser| parser.given_arguments(&part, cursor)),
            None => self.given_arguments(&part, cursor),
        };
        let placement = Placement { name, count, part, arguments: arguments? };
        Ok(StatementKind::Block(Block::Place(Box::new(placement))))
    }

    /// Reads the indices after the name of a placed part, and the range of the last one.
    fn placed_name(&mut self, name: Name, cursor: &mut Cursor) -> Parsed<(Name, Count)> {
        let mut brackets = cursor.read_brackets();
        let Some(last) = brackets.last().filter(|group| is_range(group)).cloned() else {
            return Ok((self.with_indices(name, &brackets)?, None));
        };
        brackets.pop();
        let count = self.inside(&last, |parser, cursor| {
            let count = parser.variable(words::ARRAY_HELP, cursor)?;
            match cursor.at_end() {
                true => Ok(count),
                false => Err(parser.no_operator(cursor, "`]`")),
            }
        })?;
        Ok((self.with_indices(name, &brackets)?, Some(count)))
    }

    fn given_arguments(&mut self, part: &Name, cursor: &mut Cursor) -> Parsed<Vec<(Name, AstId)>> {
        let Some(group) = cursor.eat_group(Delimiter::Brace) else {
            let message = messages::expected("`{`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, words::placed(&part.text)));
        };
        let mut given: Vec<(Name, AstId)> = Vec::new();
        let is_readable = self.lines(&group, |parser, cursor| {
            let name = parser.argument_name(cursor)?;
            if cursor.equals_past(0) {
                let help = words::argument(&name.text);
                parser.fail_once(cursor.skip_one(), messages::EQUALS_BEHIND_LABEL, &help);
            } else {
                parser.colon(&name.text, cursor)?;
            }
            let value = match cursor.eat_group(Delimiter::Bracket) {
                Some(group) => parser.elements_of(&group)?,
                None => parser.line_value(cursor),
            };
            match given.iter().find(|(other, _)| other.text == name.text) {
                None => given.push((name, value)),
                Some((first, _)) => {
                    let error = parser.report.error(name.span, messages::repeated_label(&name.text));
                    error
                        .related(first.span.into(), messages::FIRST_HERE)
                        .help(messages::REPEATED_ATTRIBUTE_HELP);
                }
            }
            Ok(())
        });
        self.skipped = false;
        if is_readable { Ok(given) } else { Err(Reported) }
    }

    /// Reads the name of an argument, which precedes a colon.
    fn argument_name(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        let is_value = match cursor.peek_past(1) {
            None => true,
            Some(TokenTree::Punct(sign)) => !":=".contains(sign.as_char()),
            Some(_) => false,
        };
        if cursor.ident().is_none() || is_value {
            let help = words::POSITIONAL_HELP;
            return Err(self.fail_with_help(cursor.here(), words::POSITIONAL, help));
        }
        self.name(cursor)
    }

    /// Reads `"parts/leg.lag"` after the word `include`.
    pub(super) fn include(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        Ok(StatementKind::Block(Block::Include(self.string(words::PATH, form("include"), cursor)?)))
    }
}

/// True at `leg[0]: Leg {`, with any indices. Other brackets are an error there.
pub(super) fn at_placement(cursor: &Cursor) -> bool {
    let is_colon =
        |ahead| matches!(cursor.peek_past(ahead), Some(TokenTree::Punct(punct)) if punct.as_char() == ':');
    let is_word = |ahead| matches!(cursor.peek_past(ahead), Some(TokenTree::Ident(_)));
    let is_group = |ahead| matches!(cursor.peek_past(ahead), Some(TokenTree::Group(group)) if group.delimiter() != Delimiter::None);
    cursor.ident().is_some() && is_colon(1) && is_word(2) && is_group(3)
}

/// Returns the number of tokens in `leg[0].hip`, if a path begins here.
pub(super) fn path_length(cursor: &Cursor) -> usize {
    let is_dot =
        |ahead| matches!(cursor.peek_past(ahead), Some(TokenTree::Punct(punct)) if punct.as_char() == '.');
    let is_word = |ahead| matches!(cursor.peek_past(ahead), Some(TokenTree::Ident(_)));
    let mut length = 1;
    while is_dot(length) && is_word(length + 1) {
        length += 2;
    }
    length
}

/// True for `[i in 0..4]`.
fn is_range(group: &Group) -> bool {
    let mut tokens = group.stream().into_iter();
    let (variable, word) = (tokens.next(), tokens.next());
    matches!(variable, Some(TokenTree::Ident(_)))
        && matches!(word, Some(TokenTree::Ident(word)) if word == "in")
}
