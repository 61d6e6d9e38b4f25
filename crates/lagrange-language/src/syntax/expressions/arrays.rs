//! Indices and the arrays, loops and sums that use them.

use proc_macro2::{Delimiter, Group, TokenTree};

use super::ReadOperand;
use crate::syntax::ast::{ArrayExpression, AstId, Expression, Fold, Name, Range};
use crate::syntax::cursor::{Cursor, group_origin};
use crate::syntax::messages;
use crate::syntax::messages::arrays;
use crate::syntax::parser::{Parsed, Parser};
use crate::syntax::recovery::Turn;
use crate::syntax::unexpected::at_range;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_INDICES;

impl Parser<'_> {
    /// Reads the indices after a name.
    pub(in crate::syntax) fn indexed(&mut self, name: Name, cursor: &mut Cursor) -> Parsed<Name> {
        let brackets = cursor.read_brackets();
        self.with_indices(name, &brackets)
    }

    /// Adds indices to a name.
    pub(in crate::syntax) fn with_indices(&mut self, name: Name, brackets: &[Group]) -> Parsed<Name> {
        if let Some(first) = brackets.get(MAX_INDICES) {
            let message = arrays::too_many_indices(&name.text, brackets.len(), MAX_INDICES);
            return Err(self.fail_with_help(group_origin(first), message, arrays::TOO_MANY_INDICES_HELP));
        }
        let indices = brackets.iter().map(|group| self.index(group)).collect::<Vec<_>>();
        Ok(Name { indices: indices.into_iter().collect::<Parsed<_>>()?, ..name })
    }

    /// Reads `[i + 1]`.
    fn index(&mut self, group: &Group) -> Parsed<AstId> {
        self.inside(group, |parser, cursor| {
            if cursor.at_end() {
                let help = arrays::INDEX_FORM_HELP;
                return Err(parser.fail_with_help(group_origin(group), arrays::EMPTY_BRACKETS, help));
            }
            let index = parser.counting(cursor, Self::expression)?;
            if cursor.at_end() {
                return Ok(index);
            }
            let message = messages::expected("`]`", cursor.peek());
            Err(parser.fail_with_help(cursor.here(), message, arrays::INDEX_FORM_HELP))
        })
    }

    /// Reads an expression of indices.
    pub(in crate::syntax) fn counting<T>(
        &mut self,
        cursor: &mut Cursor,
        read: impl FnOnce(&mut Self, &mut Cursor) -> Parsed<T>,
    ) -> Parsed<T> {
        let before = std::mem::replace(&mut self.counts, true);
        let result = read(self, cursor);
        self.counts = before;
        result
    }

    /// Creates an expression from a name; the cursor is after it.
    pub(in crate::syntax) fn named(&mut self, name: Name, cursor: &Cursor) -> Parsed<ReadOperand> {
        let origin = Origin::from(name.span);
        if name.indices.is_empty() {
            return Ok(self.add(Expression::Name(name.text), origin));
        }
        let origin = origin.to(cursor.before());
        Ok(self.add(Expression::Array(ArrayExpression::Element(name)), origin))
    }

    /// Reads `[a, b]` or `[[a, b], [c, d]]`.
    pub(in crate::syntax) fn elements_of(&mut self, group: &Group) -> Parsed<AstId> {
        let mut elements = Vec::new();
        self.inside(group, |parser, cursor| {
            parser.turns(cursor, |parser, cursor| {
                if cursor.at_end() {
                    return Ok(Turn::Last);
                }
                elements.push(match cursor.eat_group(Delimiter::Bracket) {
                    Some(group) => parser.elements_of(&group)?,
                    None => parser.expression(cursor)?,
                });
                if cursor.eat(',').is_none() && !cursor.at_end() {
                    let message = messages::expected(arrays::LIST_END, cursor.peek());
                    return Err(parser.fail_with_help(cursor.here(), message, arrays::LIST_HELP));
                }
                Ok(Turn::Next)
            })
        })?;
        Ok(self.add(Expression::Array(ArrayExpression::List(elements)), group_origin(group)).id)
    }

    /// Reads `[i][j]` after something other than a name.
    pub(in crate::syntax) fn entry(
        &mut self,
        of: ReadOperand,
        brackets: &[Group],
        cursor: &Cursor,
    ) -> Parsed<ReadOperand> {
        let indices = self.with_indices(Name::new("the value", of.origin.start), brackets)?.indices;
        let origin = of.origin.to(cursor.before());
        Ok(self.add(Expression::Entry { of: of.id, indices, shape: None }, origin))
    }

    /// Reads `(i in 0..n, e)` after the word `sum` or a similar one.
    pub(in crate::syntax) fn fold(&mut self, fold: Fold, group: &Group, word: Origin) -> Parsed<ReadOperand> {
        let help = arrays::fold_help(fold.word());
        let folded = self.inside(group, |parser, cursor| {
            let (variable, range) = parser.variable(&help, cursor)?;
            if cursor.eat(',').is_none() {
                let message = messages::expected("`,`", cursor.peek());
                return Err(parser.fail_with_help(cursor.here(), message, &help));
            }
            let term = parser.within(&variable, |parser| parser.expression(cursor))?;
            cursor.eat(',');
            match cursor.at_end() {
                true => Ok(ArrayExpression::Fold { fold, variable, range, term }),
                false => Err(parser.no_operator(cursor, "`)`")),
            }
        })?;
        Ok(self.add(Expression::Array(folded), word.to(group_origin(group))))
    }

    /// Reads an expression in which a variable has values.
    pub(in crate::syntax) fn within<T>(&mut self, variable: &Name, read: impl FnOnce(&mut Self) -> T) -> T {
        self.variables.push(variable.text.clone());
        let result = read(self);
        self.variables.pop();
        result
    }

    /// Reads `i in 0..n`.
    pub(in crate::syntax) fn variable(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<(Name, Range)> {
        let variable = self.free_name(cursor)?;
        if cursor.eat_word("in").is_none() {
            let message = messages::expected("`in`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, help));
        }
        let range = self.counting(cursor, |parser, cursor| {
            let from = parser.expression(cursor)?;
            if !cursor.at_pair('.', '.') {
                let origin = parser.expressions.origin(from);
                return Err(parser.fail_with_help(origin, arrays::RANGE, arrays::RANGE_HELP));
            }
            cursor.skip_one();
            cursor.skip_one();
            let is_inclusive = cursor.eat('=').is_some();
            Ok(Range { from, to: parser.expression(cursor)?, is_inclusive })
        })?;
        Ok((variable, range))
    }
}

/// True after the word `for` if a loop is written correctly.
pub(in crate::syntax) fn at_loop(cursor: &Cursor) -> bool {
    let is_in = matches!(cursor.peek_past(1), Some(TokenTree::Ident(word)) if word == "in");
    cursor.ident().is_some() && is_in
}

/// Returns advice for a function over a range without a range.
pub(in crate::syntax) fn fold_in_other_words(name: &Name, group: &Group) -> Option<(&'static str, String)> {
    let inside = Cursor::inside(group);
    // `norm(v in arm)` has components in the axes of a body.
    let behind = inside.peek_past(1);
    let is_counted = matches!(behind, Some(TokenTree::Punct(sign)) if "=,".contains(sign.as_char()));
    if ["sum", "product"].contains(&name.text.as_str()) && inside.ident().is_some() && is_counted {
        return Some((arrays::RANGE_OF_FOLD, arrays::fold_help(&name.text)));
    }
    (at_loop(&inside) && at_range(&inside)).then(|| (arrays::NO_FOLD, arrays::other_fold(&name.text)))
}

/// Returns the function over a range that is called, if it is one.
pub(in crate::syntax) fn at_fold(name: &Name, group: &Group) -> Option<Fold> {
    let fold = Fold::ALL.into_iter().find(|fold| fold.word() == name.text)?;
    at_loop(&Cursor::inside(group)).then_some(fold)
}
