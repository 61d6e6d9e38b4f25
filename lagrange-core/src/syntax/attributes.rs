//! Attributes of the struct: those of the language are consumed, all others are kept.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

use super::ast::{Accuracy, Name};
use super::cursor::{Cursor, group_origin};
use super::keywords;
use super::messages;
use super::parser::{Parsed, Parser, Reported};
use crate::diagnostics::{Origin, nearest};

/// What the attributes of the struct say.
#[derive(Default)]
pub(super) struct Attributes {
    pub(super) kept: TokenStream,
    pub(super) derives: Vec<Name>,
    /// Whether `#[scalar(…)]` asks for `f32`, and where it stands.
    pub(super) scalar: Option<(bool, Origin)>,
    /// What `#[accuracy(…)]` asks for, and where it stands.
    pub(super) accuracy: Option<(Accuracy, Origin)>,
}

impl Parser<'_> {
    /// Reads the attributes before the struct.
    pub(super) fn attributes(&mut self, cursor: &mut Cursor) -> Attributes {
        let mut attributes = Attributes::default();
        self.each_at('#', cursor, |parser, cursor| {
            let _ = parser.attribute(cursor, &mut attributes);
        });
        attributes
    }

    /// Reads attributes before a statement: the documentation among them, and where they stand if there are
    /// any.
    pub(super) fn documentation(&mut self, cursor: &mut Cursor) -> (TokenStream, Option<Origin>) {
        let mut start = None;
        let mut attributes = TokenStream::new();
        let mut only_docs = true;
        self.each_at('#', cursor, |parser, cursor| {
            let is_comment = !matches!(cursor.peek_past(1), Some(TokenTree::Group(_) | TokenTree::Punct(_)));
            if is_comment {
                return parser.comment(cursor);
            }
            start.get_or_insert(cursor.position());
            attributes.extend(cursor.advance());
            only_docs &= cursor.eat('!').is_none();
            let group = cursor.eat_group(Delimiter::Bracket);
            let is_doc = |group: &Group| Cursor::inside(group).at_word("doc") && is_attribute(group);
            only_docs &= group.as_ref().is_some_and(is_doc);
            attributes.extend(group.map(TokenTree::Group));
        });
        let origin = start.map(|start| cursor.since(start));
        (if only_docs { attributes } else { TokenStream::new() }, origin)
    }

    fn attribute(&mut self, cursor: &mut Cursor, attributes: &mut Attributes) -> Parsed<()> {
        let pound = cursor.advance();
        let inner = cursor.eat('!');
        let Some(group) = cursor.eat_group(Delimiter::Bracket) else {
            return Err(self.fail_with_help(
                cursor.before(),
                messages::ATTRIBUTE,
                messages::ATTRIBUTE_FORM_HELP,
            ));
        };
        if let Some(span) = inner {
            let help = messages::INNER_ATTRIBUTE_HELP;
            return Err(self.fail_with_help(span, messages::INNER_ATTRIBUTE, help));
        }
        self.inside(&group, Self::shallow)?;
        if !is_attribute(&group) {
            let origin = group_origin(&group);
            return Err(self.fail_with_help(origin, messages::ATTRIBUTE_FORM, messages::ATTRIBUTE_FORM_HELP));
        }
        let mut content = Cursor::inside(&group);
        match content.eat_ident() {
            Some(name) if name == "scalar" => self.scalar(&name, &mut content, attributes),
            Some(name) if name == "accuracy" => self.accuracy(&name, &mut content, attributes),
            name => {
                let list = content.eat_group(Delimiter::Parenthesis);
                if let Some(list) = list.filter(|_| name.is_some_and(|name| name == "derive")) {
                    attributes.derives.extend(traits(&list));
                }
                attributes.kept.extend(pound.into_iter().chain([TokenTree::Group(group)]));
                Ok(())
            }
        }
    }

    fn scalar(&mut self, name: &Ident, content: &mut Cursor, attributes: &mut Attributes) -> Parsed<()> {
        let (argument, origin) =
            self.argument(name, content, messages::SCALAR_FORM, messages::SCALAR_HELP)?;
        let single = match argument.to_string().as_str() {
            "f32" => true,
            "f64" => false,
            _ => {
                let help = messages::SCALAR_HELP;
                return Err(self.fail_with_help(argument.span(), messages::SCALAR_FORM, help));
            }
        };
        match attributes.scalar.replace((single, origin)) {
            Some((_, first)) => Err(self.repeated(name, first)),
            None => Ok(()),
        }
    }

    fn accuracy(&mut self, name: &Ident, content: &mut Cursor, attributes: &mut Attributes) -> Parsed<()> {
        let (argument, origin) =
            self.argument(name, content, messages::ACCURACY_FORM, &messages::levels_of_accuracy())?;
        let accuracy = self.level(&argument)?;
        match attributes.accuracy.replace((accuracy, origin)) {
            Some((_, first)) => Err(self.repeated(name, first)),
            None => Ok(()),
        }
    }

    fn level(&mut self, argument: &Ident) -> Parsed<Accuracy> {
        let text = argument.to_string();
        let names = Accuracy::ALL.map(Accuracy::name);
        let known = Accuracy::ALL.into_iter().find(|level| level.name() == text);
        known.ok_or_else(|| {
            let help = match nearest(&text, names) {
                Some(level) => messages::meant(level),
                None => messages::levels_of_accuracy(),
            };
            self.fail_with_help(argument.span(), messages::unknown_accuracy(&text), help)
        })
    }

    /// The only word in the parentheses behind an attribute's name.
    fn argument(
        &mut self,
        name: &Ident,
        content: &mut Cursor,
        form: &str,
        help: &str,
    ) -> Parsed<(Ident, Origin)> {
        let group = content.eat_group(Delimiter::Parenthesis).filter(|_| content.at_end());
        let origin = Origin::from(name.span()).to(group.as_ref().map_or(content.before(), group_origin));
        match group.as_ref().and_then(only_word) {
            Some(word) => Ok((word, origin)),
            None => Err(self.fail_with_help(origin, form, help)),
        }
    }

    fn repeated(&mut self, name: &Ident, first: Origin) -> Reported {
        let message = messages::repeated_attribute(&name.to_string());
        let error = self.report.error(name.span(), message).related(first, messages::FIRST_HERE);
        error.help(messages::REPEATED_ATTRIBUTE_HELP);
        Reported
    }
}

/// Whether an attribute has the shape that Rust asks for: a path alone, before brackets or before `=` and a literal
/// or a macro. Emitted as it stands, any other would make all emitted items unreadable.
fn is_attribute(group: &Group) -> bool {
    let content = Cursor::inside(group);
    let tokens = content.rest();
    let Some(length) = path_length(tokens) else { return false };
    match &tokens[length..] {
        [] | [TokenTree::Group(_)] => true,
        [equals, value @ ..] => is_punct(equals, '=') && is_attribute_value(value),
    }
}

fn is_attribute_value(tokens: &[TokenTree]) -> bool {
    match (tokens, path_length(tokens)) {
        ([TokenTree::Literal(_)], _) => true,
        (_, Some(length)) => {
            matches!(&tokens[length..], [exclamation, TokenTree::Group(_)] if is_punct(exclamation, '!'))
        }
        _ => false,
    }
}

/// How many tokens the path takes with which these begin.
fn path_length(tokens: &[TokenTree]) -> Option<usize> {
    let is_colon = |token: &TokenTree| is_punct(token, ':');
    let (first, rest) = tokens.split_first()?;
    let links =
        rest.chunks_exact(3).take_while(|link| link[..2].iter().all(is_colon) && is_segment(&link[2]));
    is_segment(first).then(|| 1 + 3 * links.count())
}

/// Whether a token can stand in a path.
fn is_segment(token: &TokenTree) -> bool {
    let TokenTree::Ident(word) = token else { return false };
    let word = word.to_string();
    let is_name = word != "_" && !keywords::is_rust_keyword(&word);
    is_name || ["crate", "self", "super", "unsafe"].contains(&word.as_str())
}

fn is_punct(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}

/// Whether what stands behind `pub` restricts it as Rust allows.
pub(super) fn is_restriction(group: &Group) -> bool {
    let content = Cursor::inside(group);
    match content.rest() {
        [TokenTree::Ident(word)] => word == "crate" || word == "self" || word == "super",
        [TokenTree::Ident(word), path @ ..] => word == "in" && path_length(path) == Some(path.len()),
        _ => false,
    }
}

fn only_word(group: &Group) -> Option<Ident> {
    let mut content = Cursor::inside(group);
    content.eat_ident().filter(|_| content.at_end())
}

/// The last segment of each path in a list of traits.
fn traits(list: &Group) -> Vec<Name> {
    let content = Cursor::inside(list);
    let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    let last_word = |path: &[TokenTree]| {
        path.iter().rev().find_map(|token| match token {
            TokenTree::Ident(word) => Some(Name { text: word.to_string(), span: word.span() }),
            _ => None,
        })
    };
    content.rest().split(is_comma).filter_map(last_word).collect()
}
