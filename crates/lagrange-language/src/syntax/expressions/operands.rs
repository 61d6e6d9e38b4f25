//! Operands: numbers, names, calls, vectors, parentheses, and members after a dot.

use lagrange_expr::keywords::is_rust_keyword;
use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use super::ReadOperand;
use super::arrays::{at_fold, fold_in_other_words};
use crate::syntax::ast::{AstId, Expression, Name};
use crate::syntax::cursor::{Cursor, group_origin};
use crate::syntax::keywords;
use crate::syntax::messages;
use crate::syntax::messages::habits;
use crate::syntax::parser::{Parsed, Parser, Reported};
use crate::syntax::recovery::Turn;
use lagrange_expr::diagnostics::Origin;

impl Parser<'_> {
    /// Reads an operand with the calls and components after it.
    pub(in crate::syntax) fn operand(&mut self, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        let mut operand = self.atom(cursor)?;
        self.turns(cursor, |parser, cursor| {
            let has_entries = parser.has_entries(operand);
            let next = || match has_entries && parser.is_index_ahead(cursor) {
                true => cursor.eat_group(Delimiter::Bracket),
                false => None,
            };
            let brackets = std::iter::from_fn(next).collect::<Vec<_>>();
            if !brackets.is_empty() {
                operand = parser.entry(operand, &brackets, cursor)?;
                return Ok(Turn::Next);
            }
            if cursor.at_pair('.', '.') || cursor.eat('.').is_none() {
                return Ok(Turn::Last);
            }
            operand = parser.behind_dot(operand, cursor)?;
            Ok(Turn::Next)
        })?;
        Ok(operand)
    }

    /// True if indices can follow. Indices of names and members belong to these, and units to
    /// numbers.
    fn has_entries(&self, operand: ReadOperand) -> bool {
        use Expression::{Invalid, Name, Number, Quantity};
        !matches!(self.expressions.get(operand.id), Name(_) | Number(_) | Quantity(..) | Invalid)
    }

    /// True if square brackets contain an index, which begins with a number or a known name, and
    /// not a unit.
    fn is_index_ahead(&self, cursor: &Cursor) -> bool {
        let Some(group) = cursor.group(Delimiter::Bracket) else { return false };
        match group.stream().into_iter().next() {
            Some(TokenTree::Ident(word)) => {
                let word = word.to_string();
                self.variables.contains(&word) || self.declared_names.contains(&word)
            }
            first => first.is_some(),
        }
    }

    fn atom(&mut self, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        let origin = cursor.here();
        match cursor.peek() {
            Some(TokenTree::Literal(literal)) => {
                let number = self.number(literal)?;
                cursor.skip_one();
                let number = self.add(Expression::Number(number), origin);
                self.quantity(number, cursor)
            }
            Some(TokenTree::Ident(word)) if word == "if" => self.conditional(cursor),
            Some(TokenTree::Ident(_)) if cursor.at_statement() => Err(self.no_operand(cursor)),
            Some(TokenTree::Ident(word)) => {
                let word = word.clone();
                if let Some((origin, message, help)) = self.habit(cursor) {
                    if message == messages::PATH && self.unreadable_words.contains(&word.to_string()) {
                        // It has been reported where the function was declared.
                        return Err(Reported);
                    }
                    return Err(self.fail_with_help(origin, message, help));
                }
                let name = self.used_name(&word)?;
                cursor.skip_one();
                self.name_or_call(name, cursor)
            }
            Some(TokenTree::Group(group)) if is_transparent(group) => {
                let group = group.clone();
                cursor.skip_one();
                Ok(self.parentheses(&group))
            }
            _ => Err(self.no_operand(cursor)),
        }
    }

    /// Reads a name in an expression. The existing names are not known here, but keywords are never
    /// names.
    fn used_name(&mut self, word: &Ident) -> Parsed<Name> {
        let name = self.plain(word)?;
        let is_keyword = keywords::begins_statement(&name.text) || is_rust_keyword(&name.text);
        if self.unreadable_words.contains(&name.text) && (is_keyword || !self.is_known(&name.text)) {
            // It has been reported where it was declared.
            return Err(Reported);
        }
        if keywords::begins_statement(&name.text) {
            let message = messages::keyword_as_value(&name.text);
            return Err(self.fail_with_help(name.span, message, messages::KEYWORD_AS_VALUE_HELP));
        }
        if is_rust_keyword(&name.text) {
            let help = if name.text == "self" { habits::SELF_HELP } else { habits::WORD_HELP };
            return Err(self.fail_with_help(name.span, messages::keyword_as_value(&name.text), help));
        }
        if name.text == "_" {
            let help = messages::OTHER_NAME_HELP;
            return Err(self.fail_with_help(name.span, messages::UNDERSCORE_AS_NAME, help));
        }
        Ok(name)
    }

    /// True if a name is defined, regardless of unreadable parts.
    fn is_known(&self, name: &str) -> bool {
        let is_built_in = keywords::is_function(name) || keywords::built_in(name).is_some();
        is_built_in || self.declared_names.contains(&name.to_owned())
    }

    fn name_or_call(&mut self, name: Name, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        let start = Origin::from(name.span);
        let name = self.indexed(name, cursor)?;
        match cursor.eat_group(Delimiter::Parenthesis) {
            None => self.named(name, cursor),
            Some(group) => {
                if let (Some(fold), []) = (at_fold(&name, &group), &name.indices[..]) {
                    return self.fold(fold, &group, start);
                }
                if let Some((message, help)) = fold_in_other_words(&name, &group) {
                    return Err(self.fail_with_help(start, message, help));
                }
                let arguments = self.arguments(&group, Vec::new());
                Ok(self.call(name, arguments, start.to(group_origin(&group))))
            }
        }
    }

    /// Reads `.x` or `.f(a, b)` after an operand.
    fn behind_dot(&mut self, receiver: ReadOperand, cursor: &mut Cursor) -> Parsed<ReadOperand> {
        if let Some(TokenTree::Literal(literal)) = cursor.peek() {
            let span = literal.span();
            return Err(self.fail_with_help(span, messages::NUMBERED_COMPONENT, messages::INDEX_HELP));
        }
        let name = self.name(cursor)?;
        match cursor.eat_group(Delimiter::Parenthesis) {
            None => {
                let name = self.indexed(name, cursor)?;
                let origin = receiver.origin.to(cursor.before());
                Ok(self.add(Expression::Component(receiver.id, name), origin))
            }
            Some(group) => {
                let arguments = self.arguments(&group, vec![receiver.id]);
                Ok(self.call(name, arguments, receiver.origin.to(group_origin(&group))))
            }
        }
    }

    fn call(&mut self, function: Name, arguments: Parsed<Vec<AstId>>, origin: Origin) -> ReadOperand {
        match arguments {
            Ok(arguments) => self.add(Expression::Call(function, arguments), origin),
            Err(Reported) => self.add(Expression::Invalid, origin),
        }
    }

    /// Reads arguments, and appends them to the given ones.
    pub(in crate::syntax) fn arguments(&mut self, group: &Group, given: Vec<AstId>) -> Parsed<Vec<AstId>> {
        self.inside(group, |parser, cursor| {
            let mut arguments = given;
            parser.each(cursor, |parser, cursor| {
                arguments.push(parser.element(cursor));
                cursor.eat(',');
            });
            Ok(arguments)
        })
    }

    /// Reads an expression in a list and skips unexpected tokens after it, up to the comma.
    fn element(&mut self, cursor: &mut Cursor) -> AstId {
        let start = cursor.position();
        match self.expression(cursor) {
            Ok(id) if cursor.at_end() || cursor.at(',') => return id,
            Ok(_) => self.no_operator(cursor, "`,` or `)`"),
            Err(reported) => reported,
        };
        cursor.skip_to(|cursor| cursor.at(','));
        self.unreadable(cursor, start)
    }

    /// Reads a vector, or an expression in parentheses.
    fn parentheses(&mut self, group: &Group) -> ReadOperand {
        let origin = match group.delimiter() {
            Delimiter::None => Origin::from(group.span()),
            _ => group_origin(group),
        };
        let content = self.inside(group, |parser, cursor| parser.elements(cursor, origin));
        match content {
            Ok(Elements::Single(id)) => ReadOperand { id, origin },
            Ok(Elements::Vector(components)) => self.add(Expression::Tuple(components), origin),
            Err(Reported) => self.add(Expression::Invalid, origin),
        }
    }

    fn elements(&mut self, cursor: &mut Cursor, origin: Origin) -> Parsed<Elements> {
        if cursor.at_end() {
            let help = habits::MISSING_EXPRESSION;
            return Err(self.fail_with_help(origin, messages::EMPTY_PARENTHESES, help));
        }
        let mut elements = Vec::new();
        let mut has_comma = false;
        self.each(cursor, |parser, cursor| {
            elements.push(parser.element(cursor));
            has_comma |= cursor.eat(',').is_some();
        });
        let is_read = |&id: &AstId| !matches!(self.expressions.get(id), Expression::Invalid);
        match elements.len() {
            1 if !has_comma => Ok(Elements::Single(elements[0])),
            // A missing operand may look like an additional component.
            _ if !elements.iter().all(is_read) => Err(Reported),
            1 => {
                let help = messages::ONE_COMPONENT_HELP;
                Err(self.fail_with_help(origin, messages::ONE_COMPONENT, help))
            }
            _ => Ok(Elements::Vector(elements)),
        }
    }
}

/// Contents of parentheses.
enum Elements {
    Single(AstId),
    Vector(Vec<AstId>),
}

/// True if a group is parentheses, or the invisible brackets around a fragment of a `macro_rules!`
/// macro.
fn is_transparent(group: &Group) -> bool {
    matches!(group.delimiter(), Delimiter::Parenthesis | Delimiter::None)
}
