//! Statements that name functions of the user's crate.

use lagrange_expr::keywords::is_rust_keyword;
use proc_macro2::{Delimiter, Group};

use super::ast::{ExternalDerivative, ExternalFunction, Name};
use super::cursor::Cursor;
use super::keywords;
use super::messages;
use super::messages::forms::form;
use super::messages::functions as words;
use super::parser::{Parsed, Parser};
use super::recovery::Turn;
use super::units::at_unit;
use lagrange_expr::diagnostics::{Origin, nearest};

/// Labels of derivatives of functions of one argument, by ascending order.
const DERIVATIVES: [&str; 3] = ["derivative", "second_derivative", "third_derivative"];

/// Functions that emitted code brings into scope and that are not words of the language.
const OF_EMITTED_CODE: [&str; 3] = ["sin_cos", "sin_cos_each", "multiply_add"];

impl Parser<'_> {
    /// Reads `f(x, y)`, with or without derivatives between braces.
    pub(super) fn external(&mut self, cursor: &mut Cursor) -> Parsed<ExternalFunction> {
        let (name, parameters) = self.function_head("function", cursor)?;
        self.refuse_elements(std::slice::from_ref(&name))?;
        if let Some(equals) = cursor.eat_equals() {
            let help = words::defined_function(&name.text);
            let reported = self.fail_with_help(equals, words::VALUE_OF_EXTERNAL, help);
            self.skip_statement(cursor);
            return Err(reported);
        }
        let derivatives = cursor.eat_group(Delimiter::Brace);
        let derivatives = derivatives.map(|group| self.derivatives(&name, &parameters, &group));
        Ok(ExternalFunction { name, parameters, derivatives })
    }

    /// Reads `f(x, y)`.
    pub(super) fn function_head(&mut self, keyword: &str, cursor: &mut Cursor) -> Parsed<(Name, Vec<Name>)> {
        if let Some((origin, message, _)) = self.path(cursor) {
            return Err(self.fail_with_help(origin, message, words::PATH_HELP));
        }
        let mut name = self.declared_name(cursor)?;
        self.check_callee(&name);
        let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
            let message = messages::expected("`(`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, form(keyword)));
        };
        let parameters = self.inside(&group, |parser, cursor| parser.component_names(keyword, cursor))?;
        self.refuse_elements(&parameters)?;
        for (i, parameter) in parameters.iter().enumerate() {
            if let Some(first) = parameters[..i].iter().find(|first| first.text == parameter.text) {
                let error = self.report.error(parameter.span, words::repeated_argument(&parameter.text));
                error.related(first.span.into(), messages::FIRST_HERE).help(messages::OTHER_NAME_HELP);
            }
        }
        if at_unit(cursor) {
            name.unit = self.unit_behind_colon(cursor);
        }
        Ok((name, parameters))
    }

    /// Reports a name that functions of the user's crate cannot have, or for which emitted code
    /// would call another function.
    fn check_callee(&mut self, name: &Name) {
        let message = match name.text.as_str() {
            text if OF_EMITTED_CODE.contains(&text) => words::of_emitted_code(text),
            text if keywords::is_function(text) => messages::function_as_name(text),
            text if is_rust_keyword(text) => messages::rust_keyword_as_name(text),
            _ => return,
        };
        self.report.error(name.span, message).help(messages::OTHER_NAME_HELP);
    }

    /// Reads the lines between braces, one for each derivative.
    fn derivatives(&mut self, name: &Name, parameters: &[Name], group: &Group) -> Vec<ExternalDerivative> {
        let mut derivatives: Vec<(ExternalDerivative, Origin)> = Vec::new();
        self.lines(group, |parser, cursor| {
            let start = cursor.position();
            let orders = parser.orders(name, parameters, cursor)?;
            let place = cursor.since(start);
            parser.colon("derivative", cursor)?;
            // Words that begin statements may be names in the user's crate.
            let of_crate = parser.name(cursor)?;
            parser.check_callee(&of_crate);
            if let Some((_, first)) = derivatives.iter().find(|(known, _)| known.orders == orders) {
                let error = parser.report.error(place, words::REPEATED_DERIVATIVE);
                error.related(*first, messages::FIRST_HERE).help(messages::REPEATED_ATTRIBUTE_HELP);
                return Ok(());
            }
            derivatives.push((ExternalDerivative { orders, name: of_crate }, place));
            Ok(())
        });
        derivatives.into_iter().map(|(derivative, _)| derivative).collect()
    }

    /// Reads `derivative` or `by x, y`: the order of differentiation with respect to each argument.
    fn orders(&mut self, function: &Name, parameters: &[Name], cursor: &mut Cursor) -> Parsed<Vec<u8>> {
        if cursor.at_word("by") {
            cursor.skip_one();
            return self.by_arguments(function, parameters, cursor);
        }
        let help = words::derivatives_are(parameters);
        let (here, label) = (cursor.here(), cursor.ident().map(ToString::to_string));
        let Some(label) = label else {
            let message = messages::expected(words::DERIVATIVE, cursor.peek());
            return Err(self.fail_with_help(here, message, help));
        };
        cursor.skip_one();
        match DERIVATIVES.iter().position(|known| *known == label) {
            Some(position) if parameters.len() == 1 => Ok(vec![position as u8 + 1]),
            Some(_) => {
                Err(self.fail_with_help(here, words::by_which(&function.text, parameters.len()), help))
            }
            None => {
                let meant = nearest(&label, DERIVATIVES).filter(|_| parameters.len() == 1);
                let help = meant.map_or(help, messages::meant);
                Err(self.fail_with_help(here, words::no_derivative(&label), help))
            }
        }
    }

    /// Reads `x, y` after `by`.
    fn by_arguments(&mut self, function: &Name, parameters: &[Name], cursor: &mut Cursor) -> Parsed<Vec<u8>> {
        let mut orders = vec![0_u8; parameters.len()];
        self.turns(cursor, |parser, cursor| {
            let name = parser.name(cursor)?;
            match parameters.iter().position(|parameter| parameter.text == name.text) {
                Some(position) => orders[position] = orders[position].saturating_add(1),
                None => {
                    let message = words::no_argument(&function.text, &name.text);
                    let help = words::derivatives_are(parameters);
                    return Err(parser.fail_with_help(name.span, message, help));
                }
            }
            Ok(Turn::next_if(cursor.eat(',').is_some()))
        })?;
        Ok(orders)
    }
}
