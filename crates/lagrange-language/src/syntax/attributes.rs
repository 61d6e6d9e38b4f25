//! Attributes of the struct: those of the language are consumed, all others kept.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser as _};
use syn::punctuated::Punctuated;
use syn::{Lit, Macro, MacroDelimiter, Meta, MetaList, Path, Token, bracketed};

use super::ast::Name;
use super::ast::ScalarType;
use super::cursor::Cursor;
use super::messages;
use super::parser::{Parsed, Parser, Reported};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::diagnostics::{Origin, nearest};

/// The attributes of the struct.
#[derive(Default)]
pub(super) struct Attributes {
    pub(super) kept: TokenStream,
    pub(super) derives: Vec<Name>,
    /// Argument of `#[scalar(…)]`, and its place.
    pub(super) scalar: Option<(ScalarType, Origin)>,
    /// Argument of `#[accuracy(…)]`, and its place.
    pub(super) accuracy: Option<(Accuracy, Origin)>,
}

impl Parser<'_> {
    /// Reads the attributes before the struct.
    pub(super) fn attributes(&mut self, cursor: &mut Cursor) -> Attributes {
        let mut attributes = Attributes::default();
        self.each_at('#', cursor, |parser, cursor| {
            let _ = parser.attribute_of_struct(cursor, &mut attributes);
        });
        attributes
    }

    /// Reads attributes before a statement. Returns the documentation among them, and their place
    /// if there are any.
    pub(super) fn documentation(&mut self, cursor: &mut Cursor) -> (TokenStream, Option<Origin>) {
        let mut first = None;
        let mut attributes = TokenStream::new();
        let mut only_docs = true;
        self.each_at('#', cursor, |parser, cursor| {
            let is_comment = !matches!(cursor.peek_past(1), Some(TokenTree::Group(_) | TokenTree::Punct(_)));
            if is_comment {
                return parser.comment(cursor);
            }
            let start = cursor.position();
            let Ok((meta, tokens)) = parser.attribute(cursor) else { return };
            first.get_or_insert(start);
            only_docs &= meta.path().is_ident("doc");
            attributes.extend(tokens);
        });
        let origin = first.map(|first| cursor.since(first));
        (if only_docs { attributes } else { TokenStream::new() }, origin)
    }

    fn attribute_of_struct(&mut self, cursor: &mut Cursor, attributes: &mut Attributes) -> Parsed<()> {
        let (meta, tokens) = self.attribute(cursor)?;
        match (meta.path().get_ident(), &meta) {
            (Some(name), _) if name == "scalar" => return self.scalar(name, &meta, attributes),
            (Some(name), _) if name == "accuracy" => return self.accuracy(name, &meta, attributes),
            (Some(name), Meta::List(list)) if name == "derive" => {
                attributes.derives.extend(self.traits(list)?);
            }
            _ => {}
        }
        attributes.kept.extend(tokens);
        Ok(())
    }

    /// Reads `#[…]`: its content and its tokens. A malformed attribute is not emitted, since it
    /// would make all emitted items unreadable.
    fn attribute(&mut self, cursor: &mut Cursor) -> Parsed<(Meta, TokenStream)> {
        let start = cursor.position();
        cursor.skip_one();
        let pound = cursor.taken_since(start).to_vec();
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
        let group = TokenTree::from(without_fragment(group));
        match in_brackets.parse2(group.clone().into()) {
            Ok(meta) => Ok((meta, pound.into_iter().chain([group]).collect())),
            Err(error) => Err(self.malformed_attribute(&error)),
        }
    }

    fn malformed_attribute(&mut self, error: &syn::Error) -> Reported {
        let message = messages::malformed_attribute(error);
        self.fail_with_help(error.span(), message, messages::ATTRIBUTE_FORM_HELP)
    }

    /// Returns the last segment of each path in a list of traits.
    fn traits(&mut self, list: &MetaList) -> Parsed<Vec<Name>> {
        let paths = Punctuated::<Path, Token![,]>::parse_terminated_with;
        let paths = list.parse_args_with(|input: ParseStream| paths(input, Path::parse_mod_style));
        let paths = paths.map_err(|error| self.malformed_attribute(&error))?;
        let names = paths.iter().filter_map(|path| path.segments.last());
        Ok(names.map(|name| Name::new(name.ident.to_string(), name.ident.span())).collect())
    }

    fn scalar(&mut self, name: &Ident, meta: &Meta, attributes: &mut Attributes) -> Parsed<()> {
        let (argument, origin) = self.argument(name, meta, messages::SCALAR_FORM, messages::SCALAR_HELP)?;
        let scalar = match argument.to_string().as_str() {
            "f32" => ScalarType::F32,
            "f64" => ScalarType::F64,
            _ => {
                let help = messages::SCALAR_HELP;
                return Err(self.fail_with_help(argument.span(), messages::SCALAR_FORM, help));
            }
        };
        match attributes.scalar.replace((scalar, origin)) {
            Some((_, first)) => Err(self.repeated(name, first)),
            None => Ok(()),
        }
    }

    fn accuracy(&mut self, name: &Ident, meta: &Meta, attributes: &mut Attributes) -> Parsed<()> {
        let (argument, origin) =
            self.argument(name, meta, messages::ACCURACY_FORM, &messages::levels_of_accuracy())?;
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

    /// Reads the single word in parentheses after an attribute's name.
    fn argument(&mut self, name: &Ident, meta: &Meta, form: &str, help: &str) -> Parsed<(Ident, Origin)> {
        let list = match meta {
            Meta::List(list) if matches!(list.delimiter, MacroDelimiter::Paren(_)) => Some(list),
            _ => None,
        };
        let end = list.map_or(name.span(), |list| list.delimiter.span().close());
        let origin = Origin { start: name.span(), end };
        match list.and_then(|list| list.parse_args_with(Ident::parse_any).ok()) {
            Some(word) => Ok((word, origin)),
            None => Err(self.fail_with_help(origin, form, help)),
        }
    }

    fn repeated(&mut self, name: &Ident, first: Origin) -> Reported {
        let message = messages::repeated_attribute(name.to_string());
        let error = self.report.error(name.span(), message).related(first, messages::FIRST_HERE);
        error.help(messages::REPEATED_ATTRIBUTE_HELP);
        Reported
    }
}

/// Returns the group without the wrapper that a `macro_rules!` macro puts around a fragment.
fn without_fragment(group: Group) -> Group {
    let mut content = Cursor::inside(&group);
    match content.eat_group(Delimiter::None).filter(|_| content.at_end()) {
        None => group,
        Some(fragment) => {
            let mut plain = Group::new(group.delimiter(), fragment.stream());
            plain.set_span(group.span());
            plain
        }
    }
}

/// Reads the bracket group of an attribute.
fn in_brackets(input: ParseStream) -> syn::Result<Meta> {
    let content;
    bracketed!(content in input);
    require_plain_value(&content.fork())?;
    content.parse()
}

/// Checks that any value after `=` is a literal or a macro. The compiler accepts nothing else, and
/// syn reads other expressions recursively.
fn require_plain_value(input: ParseStream) -> syn::Result<()> {
    let is_unsafe = input.parse::<Option<Token![unsafe]>>()?.is_some();
    let is_path = is_unsafe || input.call(Path::parse_mod_style).is_ok();
    if !is_path || input.parse::<Option<Token![=]>>()?.is_none() {
        return Ok(());
    }
    let value = input.fork();
    if input.parse::<Option<Lit>>()?.is_none() && input.parse::<Macro>().is_err() {
        return Err(value.error("expected a literal or a macro"));
    }
    match input.is_empty() {
        true => Ok(()),
        false => Err(input.error("unexpected token")),
    }
}
