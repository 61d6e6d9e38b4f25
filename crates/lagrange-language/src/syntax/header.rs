//! The head of a declaration: attributes, visibility and the struct.

use lagrange_expr::keywords::is_rust_keyword;
use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use quote::quote;
use syn::parse::Parse;
use syn::{GenericParam, Generics, Visibility, WhereClause};

use super::ast::{Declaration, Expressions, Name, ScalarType};
use super::attributes::Attributes;
use super::cursor::{Cursor, group_origin};
use super::messages;
use super::parser::{Parsed, Parser, Reported};
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::Origin;

/// Name of a system that consists of a bare list of statements.
const DEFAULT_NAME: &str = "System";
/// Number of tokens of `include "arm.lag";`.
const FILE_TOKENS: usize = 3;

/// Returns the declaration for a bare list of statements.
pub(super) fn default_header() -> Declaration {
    let name = Name::new(DEFAULT_NAME, Span::call_site());
    let head = declaration(Attributes::default(), (quote!(pub), Span::call_site()), name, ScalarType::F64);
    Declaration { has_header: false, ..head }
}

/// True if the only statement includes a file, which then contains the whole declaration.
pub(super) fn file_ahead(cursor: &Cursor) -> bool {
    cursor.at_word("include") && cursor.rest().len() <= FILE_TOKENS
}

/// True if a struct follows, possibly after attributes and a visibility.
pub(super) fn header_ahead(cursor: &Cursor) -> bool {
    let decides = |token: &TokenTree| match token {
        TokenTree::Ident(word) if word == "struct" => Some(true),
        TokenTree::Ident(word) => (word != "pub").then_some(false),
        TokenTree::Punct(punct) => (!matches!(punct.as_char(), '#' | '!')).then_some(false),
        TokenTree::Literal(_) => Some(false),
        TokenTree::Group(_) => None,
    };
    cursor.rest().iter().find_map(decides).unwrap_or(false)
}

fn declaration(
    attributes: Attributes,
    (visibility, keyword): (TokenStream, Span),
    name: Name,
    scalar: ScalarType,
) -> Declaration {
    Declaration {
        attributes: attributes.kept,
        derives: attributes.derives,
        visibility,
        keyword,
        name,
        scalar,
        accuracy: attributes.accuracy.map(|(level, _)| level).unwrap_or_default(),
        statements: Vec::new(),
        reduction: None,
        expressions: Expressions::default(),
        bodies: Vec::new(),
        is_in_space: false,
        arrays: Vec::new(),
        placed: Vec::new(),
        has_header: true,
        included: Vec::new(),
        unplaced: Vec::new(),
        counted: HashSet::default(),
        unreadable_words: HashSet::default(),
        lacks_names: false,
        has_units: false,
        has_dimensions: false,
    }
}

impl Parser<'_> {
    /// Reads the head up to its semicolon; the declaration has no statements yet.
    pub(super) fn header(&mut self, cursor: &mut Cursor) -> Parsed<Declaration> {
        let mistakes = self.report.diagnostics().len();
        let attributes = self.attributes(cursor);
        let visibility = self.visibility(cursor).unwrap_or_else(|Reported| quote!(pub));
        let Some(keyword) = cursor.eat_word("struct") else {
            let message = match cursor.peek() {
                None => messages::EMPTY_DECLARATION.to_owned(),
                token => messages::expected(messages::HEADER, token),
            };
            return Err(self.fail_with_help(cursor.here(), message, messages::HEADER_HELP));
        };
        let name = self.type_name(cursor)?;
        let parameter = self.type_parameter(cursor);
        let scalar = self.scalar_type(&attributes, parameter);
        self.where_clause(cursor);
        self.end_of_header(cursor);
        self.refuse_brackets(cursor, mistakes);
        Ok(declaration(attributes, (visibility, keyword), name, scalar))
    }

    /// Reads the name of an emitted type.
    pub(super) fn type_name(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        let name = self.name(cursor)?;
        self.no_keyword(name)
    }

    fn no_keyword(&mut self, name: Name) -> Parsed<Name> {
        if is_rust_keyword(&name.text) || name.text == "_" {
            let message = messages::keyword_as_type(&name.text);
            return Err(self.fail_with_help(name.span, message, messages::OTHER_NAME_HELP));
        }
        Ok(name)
    }

    /// Reads `<S>`; any other type parameters are reported and skipped.
    fn type_parameter(&mut self, cursor: &mut Cursor) -> Option<Name> {
        if !cursor.at('<') {
            return None;
        }
        let start = cursor.position();
        let generics = cursor.read(Generics::parse).ok();
        if generics.is_none() {
            cursor.skip_head();
        }
        let name = match generics.as_ref().and_then(|generics| generics.type_params().next()) {
            Some(first) => Some(self.plain(&first.ident).and_then(|name| self.no_keyword(name)).ok()?),
            None => None,
        };
        if !generics.is_some_and(|generics| is_one_name(&generics)) {
            let error = self.report.error(cursor.since(start), messages::TYPE_PARAMETERS);
            error.help(messages::TYPE_PARAMETERS_HELP);
        }
        name
    }

    fn where_clause(&mut self, cursor: &mut Cursor) {
        if !cursor.at_word("where") {
            return;
        }
        let start = cursor.position();
        if cursor.read(WhereClause::parse).is_err() {
            cursor.skip_head();
        }
        self.fail_with_help(cursor.since(start), messages::WHERE_CLAUSE, messages::TYPE_PARAMETERS_HELP);
    }

    fn scalar_type(&mut self, attributes: &Attributes, parameter: Option<Name>) -> ScalarType {
        let number_types = [("f32", ScalarType::F32), ("f64", ScalarType::F64)];
        let number_type = |name: &Name| number_types.into_iter().find(|(number, _)| *number == name.text);
        if let Some((name, (number, scalar))) =
            parameter.as_ref().and_then(|name| Some((name, number_type(name)?)))
        {
            let message = messages::number_type_as_parameter(number);
            self.report.error(name.span, message).help(messages::number_type_help(number));
            return scalar;
        }
        match (parameter, &attributes.scalar) {
            (None, Some((scalar, _))) => scalar.clone(),
            (None, None) => ScalarType::F64,
            (Some(name), None) => ScalarType::Generic(name),
            (Some(name), Some((_, attribute))) => {
                let error = self.report.error(*attribute, messages::SCALAR_WITH_PARAMETER);
                error.related(Origin::from(name.span), messages::TYPE_PARAMETER_HERE);
                error.help(messages::SCALAR_WITH_PARAMETER_HELP);
                ScalarType::Generic(name)
            }
        }
    }

    fn end_of_header(&mut self, cursor: &mut Cursor) {
        let body = match cursor.eat_group(Delimiter::Brace) {
            None => cursor.eat_group(Delimiter::Parenthesis),
            brace => brace,
        };
        if let Some(body) = &body {
            self.report.error(group_origin(body), messages::STRUCT_BODY).help(messages::HEADER_HELP);
        }
        if cursor.eat(';').is_some() || body.is_some() {
            return;
        }
        if cursor.at_end() || cursor.statement_keyword().is_some() {
            self.missing_semicolon(cursor);
        } else {
            let message = messages::expected("`;`", cursor.peek());
            self.fail_with_help(cursor.here(), message, messages::HEADER_HELP);
            cursor.skip_statement();
            cursor.eat(';');
        }
    }

    /// Reads `pub`, `pub(…)`, a visibility passed on by a `macro_rules!` macro, or nothing.
    fn visibility(&mut self, cursor: &mut Cursor) -> Parsed<TokenStream> {
        let start = cursor.position();
        let fragment = cursor.eat_group(Delimiter::None);
        if fragment.is_none() && cursor.eat_word("pub").is_some() {
            cursor.eat_group(Delimiter::Parenthesis);
        }
        let tokens = cursor.taken_since(start).iter().cloned().collect::<TokenStream>();
        self.shallow(&mut Cursor::new(tokens.clone()))?;
        match syn::parse2::<Visibility>(tokens.clone()) {
            Ok(_) => Ok(fragment.map_or(tokens, |fragment| fragment.stream())),
            Err(_) => {
                Err(self.fail_with_help(cursor.before(), messages::VISIBILITY, messages::VISIBILITY_HELP))
            }
        }
    }
}

fn is_one_name(generics: &Generics) -> bool {
    let is_name = |parameter: &GenericParam| match parameter {
        GenericParam::Type(parameter) => {
            parameter.attrs.is_empty() && parameter.colon_token.is_none() && parameter.default.is_none()
        }
        _ => false,
    };
    generics.params.len() == 1 && generics.params.iter().all(is_name)
}
