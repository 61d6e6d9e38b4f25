//! Statements that declare names or list products.

use proc_macro2::{Delimiter, Group, Span, TokenTree};

use super::ast::{
    Assignment, AstId, Definition, EmitItem, Expression, FunctionDefinition, Mode, Name, StatementKind,
};
use super::cursor::{Cursor, as_group, group_origin};
use super::identifiers::{at_equals_past, at_relation};
use super::lists::{at_item_end, is_definition};
use super::messages;
use super::messages::arrays;
use super::messages::forms::form;
use super::messages::habits;
use super::messages::ranges;
use super::messages::units;
use super::parser::{Declared, Parsed, Parser, Reported};
use super::recovery::Turn;
use super::units::at_unit;
use lagrange_expr::keywords::is_rust_keyword;
use lagrange_expr::limits::MAX_INDICES;
use lagrange_expr::number::Number;

impl Parser<'_> {
    /// Reads `a, b > 0 = 1.0` after this keyword.
    pub(super) fn definitions(&mut self, keyword: &str, cursor: &mut Cursor) -> Vec<Definition> {
        let help = form(keyword);
        self.items(help, cursor, |parser, cursor| {
            let mut name = parser.declared_name(cursor);
            if let Ok(name) = &mut name {
                parser.no_unit(name);
                // Values after it may contain it.
                parser.declared_names.insert(name.text.clone(), Declared::Parameter);
                parser.annotation(name, "param", cursor);
            }
            let (range, nominal) = parser.limits_behind(&name, keyword, cursor);
            let value = parser.value_behind(&mut name, help, cursor);
            Ok(Definition { name: name?, range, nominal, value })
        })
    }

    /// Reads `= 1.0` or, for an array, `= [1.0, 2.0]`; nothing if no value follows.
    fn value_behind(&mut self, name: &mut Parsed<Name>, help: &str, cursor: &mut Cursor) -> Option<AstId> {
        if !at_equals_past(0, cursor) {
            return None;
        }
        self.equals(help, cursor).ok()?;
        let is_array = name.as_ref().map_or(true, |name| !name.indices.is_empty());
        let is_array = is_array || self.sized_by_list(name, cursor);
        Some(self.default(is_array, cursor))
    }

    /// True if a list follows a name without numbers of elements, which is reported: the list
    /// determines them.
    fn sized_by_list(&mut self, name: &mut Parsed<Name>, cursor: &Cursor) -> bool {
        let (Ok(name), Some(group)) = (name, cursor.group(Delimiter::Bracket)) else { return false };
        let sizes = sizes_of_list(group);
        if sizes.contains(&0) {
            return false;
        }
        self.fail_with_help(name.span, arrays::NO_SIZE, arrays::size_help(&name.text, &sizes));
        let sizes = sizes.into_iter().map(|size| Expression::Number(Number::from(size)));
        name.indices = sizes.map(|size| self.add(size, name.span.into()).id).collect();
        true
    }

    /// Reports a unit of measurement in brackets after the name of a parameter.
    fn no_unit(&mut self, name: &mut Name) {
        let [size] = name.indices[..] else { return };
        let Expression::Name(word) = self.expressions.get(size) else { return };
        if self.is_free_unit(word) {
            let help = units::behind_name(&name.text, word);
            self.fail_once(self.expressions.origin(size), units::BEHIND_NAME, &help);
            name.indices.clear();
        }
    }

    /// Reads `a = 1, b = 2`.
    pub(super) fn constants(&mut self, cursor: &mut Cursor) -> Vec<Definition> {
        let definitions = self.definitions("const", cursor);
        for Definition { name, .. } in definitions.iter().filter(|definition| definition.value.is_none()) {
            let message = messages::constant_without_value(&name.text);
            self.report.error(name.span, message).help(messages::CONSTANT_WITHOUT_VALUE_HELP);
        }
        definitions
    }

    /// Reads `clutch = open | closed`.
    pub(super) fn mode(&mut self, cursor: &mut Cursor) -> Parsed<Mode> {
        let name = self.declared_name(cursor)?;
        self.equals(form("mode"), cursor)?;
        let mut values = vec![self.free_name(cursor)?];
        self.turns(cursor, |parser, cursor| {
            if cursor.eat('|').is_none() {
                return Ok(Turn::Last);
            }
            values.push(parser.free_name(cursor)?);
            Ok(Turn::Next)
        })?;
        if !cursor.at_statement_end() {
            return Err(self.misplaced("`|`", form("mode"), cursor));
        }
        if values.len() < 2 {
            let help = form("mode");
            return Err(self.fail_with_help(values[0].span, messages::one_value(&name.text), help));
        }
        Ok(Mode { name, values })
    }

    /// Reads `x, theta = 0.1` after this keyword. A word that cannot be a name also counts, so that
    /// vectors have the length that the user expects. If it cannot be a field either, it is
    /// replaced by a name that cannot be written.
    pub(super) fn coordinates(&mut self, keyword: &str, cursor: &mut Cursor) -> Vec<Definition> {
        self.items(form(keyword), cursor, |parser, cursor| {
            let start = cursor.position();
            if let Some(rate) = rate_ahead(cursor) {
                let (origin, help) =
                    (cursor.reaching(2), habits::start_of(format!("dot({})", rate.stream())));
                return Err(parser.fail_with_help(origin, habits::RATE_AMONG_COORDINATES, help));
            }
            let word = cursor.ident().filter(|word| can_be_field(&word.to_string())).cloned();
            let mut name = parser.declared_name(cursor);
            if let Ok(name) = &mut name {
                parser.annotation(name, keyword, cursor);
            }
            let name = name.unwrap_or_else(|Reported| {
                parser.skip_item(cursor);
                parser.leave_out(cursor, start);
                match word {
                    Some(word) => Name::new(word.to_string(), word.span()),
                    None => Name::new(format!("__coordinate_{start}"), Span::call_site()),
                }
            });
            let mut name = Ok(name);
            let (range, nominal) = parser.limits_behind(&name, keyword, cursor);
            let value = parser.value_behind(&mut name, form(keyword), cursor);
            Ok(Definition { name: name?, range, nominal, value })
        })
    }

    /// Reads `x = 1, dot(theta) = 2` after this keyword.
    pub(super) fn starts(&mut self, keyword: &str, cursor: &mut Cursor) -> Vec<Assignment> {
        let help = form(keyword);
        self.settings(help, cursor, |parser, cursor| {
            let name = cursor.ident().map(ToString::to_string).unwrap_or_default();
            if parser.declared(&name) == Some(Declared::Coordinate) && at_call_with_value(cursor) {
                let origin = cursor.reaching(2);
                let (message, help) = match keyword {
                    "history" => (habits::TIME_OF_HISTORY, habits::history_of(name)),
                    _ => (habits::TIME_OF_START, habits::start_of(name)),
                };
                return Err(parser.fail_with_help(origin, message, help));
            }
            let target = parser.expression(cursor)?;
            parser.equals(help, cursor)?;
            Ok(Assignment::new(target, parser.item_value(cursor)))
        })
    }

    /// Reads an expression up to the next comma or the end of the statement.
    pub(super) fn item_value(&mut self, cursor: &mut Cursor) -> AstId {
        let start = cursor.position();
        match self.expression(cursor) {
            Ok(id) if at_item_end(cursor) || is_definition(cursor) => return id,
            Ok(_) if at_relation(cursor) || cursor.at_pair('.', '.') => self.range_behind_value(cursor),
            Ok(_) if cursor.at_word("nominal") => {
                let help = ranges::NOMINAL_BEHIND_VALUE_HELP;
                self.fail_with_help(cursor.here(), ranges::NOMINAL_BEHIND_VALUE, help)
            }
            Ok(_) => self.no_operator(cursor, "`,` or `;`"),
            Err(reported) => reported,
        };
        self.skip_item(cursor);
        self.unreadable(cursor, start)
    }

    /// Reads a value after the equals sign of a definition. Only arrays have lists as values.
    pub(super) fn default(&mut self, is_array: bool, cursor: &mut Cursor) -> AstId {
        let group = cursor.group(Delimiter::Bracket).filter(|_| is_array).cloned();
        let Some(group) = group else { return self.item_value(cursor) };
        let start = cursor.position();
        cursor.skip_one();
        self.elements_of(&group).unwrap_or_else(|Reported| self.unreadable(cursor, start))
    }

    /// Reads `n = e` or `(a, b) = e`.
    pub(super) fn binding(&mut self, cursor: &mut Cursor) -> Parsed<StatementKind> {
        if let Some(origin) = cursor.eat_word("mut") {
            self.fail_with_help(origin, habits::MUTABLE, habits::MUTABLE_HELP);
        }
        let help = form("let");
        match cursor.eat_group(Delimiter::Parenthesis) {
            None if cursor.ident().is_none() => Err(self.no_name(help, cursor)),
            None => {
                let mut name = self.declared_name(cursor)?;
                if let Some(group) = cursor.eat_group(Delimiter::Parenthesis) {
                    return self.function(name, &group, cursor);
                }
                self.annotation(&mut name, "let", cursor);
                let value = self.assigned(help, cursor)?;
                if matches!(self.expressions.get(value), Expression::Invalid) {
                    self.unreadable_words.insert(name.text.clone());
                }
                Ok(StatementKind::Let(name, value))
            }
            Some(group) => {
                let names = self.inside(&group, |parser, cursor| parser.component_names("let", cursor));
                let value = self.assigned(help, cursor)?;
                Ok(StatementKind::LetTuple(self.several("let", names?, &group)?, value))
            }
        }
    }

    /// Reports square brackets after names of functions of the crate and of parameters.
    pub(super) fn refuse_elements(&mut self, names: &[Name]) -> Parsed<()> {
        let Some(indexed) = names.iter().find(|name| !name.indices.is_empty()) else { return Ok(()) };
        let help = arrays::FUNCTIONS_HELP;
        Err(self.fail_with_help(indexed.span, arrays::FUNCTIONS, help))
    }

    /// Reads `(x, y) = e` after the name of a function.
    fn function(&mut self, name: Name, group: &Group, cursor: &mut Cursor) -> Parsed<StatementKind> {
        let parameters = self.inside(group, |parser, cursor| parser.component_names("let", cursor))?;
        self.refuse_elements(&parameters)?;
        self.refuse_units(&parameters);
        let value = self.assigned(form("let"), cursor)?;
        Ok(StatementKind::Function(Box::new(FunctionDefinition { name, parameters, value })))
    }

    /// Reads `x, y` in parentheses.
    pub(super) fn component_names(&mut self, keyword: &str, cursor: &mut Cursor) -> Parsed<Vec<Name>> {
        let mut names = Vec::new();
        self.turns(cursor, |parser, cursor| {
            let mut name = parser.declared_name(cursor)?;
            if at_unit(cursor) {
                name.unit = parser.unit_behind_colon(cursor);
            }
            names.push(name);
            Ok(Turn::next_if(cursor.eat(',').is_some() && !cursor.at_end()))
        })?;
        if cursor.at_end() {
            return Ok(names);
        }
        let message = messages::expected("`,` or `)`", cursor.peek());
        Err(self.fail_with_help(cursor.here(), message, form(keyword)))
    }

    /// Reports a single name in parentheses.
    pub(super) fn several(&mut self, keyword: &str, names: Vec<Name>, group: &Group) -> Parsed<Vec<Name>> {
        match names.len() {
            1 => Err(self.fail_with_help(group_origin(group), messages::ONE_COMPONENT, form(keyword))),
            _ => Ok(names),
        }
    }

    /// Reads `{ a, no b }`.
    pub(super) fn emit(&mut self, cursor: &mut Cursor) -> Parsed<Vec<EmitItem>> {
        let Some(group) = cursor.eat_group(Delimiter::Brace) else {
            let message = messages::expected("`{`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, form("emit")));
        };
        // An error in the braces does not affect the end of the statement.
        Ok(self.inside(&group, Self::emit_items).unwrap_or_default())
    }

    fn emit_items(&mut self, cursor: &mut Cursor) -> Parsed<Vec<EmitItem>> {
        let mut items = Vec::new();
        self.turns(cursor, |parser, cursor| {
            items.extend(parser.emit_item(cursor)?);
            Ok(Turn::next_if(!cursor.at_end()))
        })?;
        Ok(items)
    }

    /// Reads `a,` or `no b,`, with an optional comma after the last one; `None` at the end.
    fn emit_item(&mut self, cursor: &mut Cursor) -> Parsed<Option<EmitItem>> {
        if cursor.at_end() {
            return Ok(None);
        }
        // Without a name after it, `no` is the name.
        let wanted =
            !matches!(cursor.peek_past(1), Some(TokenTree::Ident(_))) || cursor.eat_word("no").is_none();
        let item = EmitItem { product: self.name(cursor)?, wanted };
        if cursor.eat(',').is_none() && !cursor.at_end() {
            let message = messages::expected("`,` or `}`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, form("emit")));
        }
        Ok(Some(item))
    }
}

/// True at `x(0) =`.
fn at_call_with_value(cursor: &Cursor) -> bool {
    as_group(cursor.peek_past(1), Delimiter::Parenthesis).is_some() && cursor.equals_past(2)
}

/// Returns the brackets after the word `dot`, if both follow.
fn rate_ahead(cursor: &Cursor) -> Option<&Group> {
    as_group(cursor.peek_past(1), Delimiter::Parenthesis).filter(|_| cursor.at_word("dot"))
}

/// True if Rust accepts the word as the name of a field, regardless of its meaning in the language.
fn can_be_field(word: &str) -> bool {
    word != "_" && !word.starts_with("r#") && !is_rust_keyword(word)
}

/// Returns the numbers of elements of a list and of the first list in it, up to the maximum number
/// of indices.
fn sizes_of_list(list: &Group) -> Vec<i64> {
    let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    let inner =
        |list: &Group| as_group(list.stream().into_iter().next().as_ref(), Delimiter::Bracket).cloned();
    let lists = std::iter::successors(Some(list.clone()), inner).take(MAX_INDICES);
    let size = |list: Group| {
        let tokens = list.stream().into_iter().collect::<Vec<_>>();
        tokens.split(is_comma).filter(|element| !element.is_empty()).count() as i64
    };
    lists.map(size).collect()
}
