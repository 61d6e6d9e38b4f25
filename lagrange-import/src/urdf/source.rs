//! Elements of a file: what they must and may hold, with mistakes collected at their lines.

use lagrange_core::diagnostics::nearest;
use roxmltree::{Document, Node};

use super::messages;
use crate::decimal::Decimal;
use crate::mistakes::Mistake;

/// A document, and what is wrong with it so far.
pub(super) struct Source<'d> {
    document: &'d Document<'d>,
    mistakes: Vec<Mistake>,
}

impl<'d> Source<'d> {
    pub(super) fn new(document: &'d Document<'d>) -> Source<'d> {
        Source { document, mistakes: Vec::new() }
    }

    /// The line of a place.
    pub(super) fn line(&self, place: usize) -> u32 {
        self.document.text_pos_at(place).row
    }

    /// Mistakes and warnings, from the first line to the last; warnings that say the same of elements of one tag are one.
    pub(super) fn into_mistakes(mut self) -> Vec<Mistake> {
        self.mistakes.sort_by_key(|mistake| (mistake.line, mistake.column));
        let mut told = Vec::<(Mistake, usize)>::new();
        for mistake in self.mistakes {
            let is_same = |other: &Mistake| (tag(other), &other.message) == (tag(&mistake), &mistake.message);
            match told.iter_mut().find(|(other, _)| !mistake.is_error && !other.is_error && is_same(other)) {
                Some((_, others)) => *others += 1,
                None => told.push((mistake, 0)),
            }
        }
        let counted = told.into_iter().map(|(mut mistake, others)| {
            mistake.message.push_str(&messages::and_others(others));
            mistake
        });
        counted.collect()
    }

    pub(super) fn error_count(&self) -> usize {
        self.mistakes.iter().filter(|mistake| mistake.is_error).count()
    }

    pub(super) fn error(&mut self, node: Node<'_, '_>, message: impl Into<String>) -> &mut Mistake {
        self.add((node.range().start, described(node)), message.into(), true)
    }

    pub(super) fn warning(&mut self, node: Node<'_, '_>, message: impl Into<String>) -> &mut Mistake {
        self.add((node.range().start, described(node)), message.into(), false)
    }

    /// A mistake at a place of which the element is known in words.
    pub(super) fn error_at(&mut self, place: (usize, String), message: impl Into<String>) -> &mut Mistake {
        self.add(place, message.into(), true)
    }

    pub(super) fn warning_at(&mut self, place: (usize, String), message: impl Into<String>) -> &mut Mistake {
        self.add(place, message.into(), false)
    }

    fn error_in(&mut self, node: Node<'_, '_>, attribute: &str, message: String) -> &mut Mistake {
        let written = node.attribute_node(attribute).map(|attribute| attribute.range().start);
        self.add((written.unwrap_or(node.range().start), described(node)), message, true)
    }

    fn add(&mut self, (place, element): (usize, String), message: String, is_error: bool) -> &mut Mistake {
        let position = self.document.text_pos_at(place);
        let (line, column) = (position.row, position.col);
        self.mistakes.push(Mistake { line, column, element, message, help: None, is_error });
        let last = self.mistakes.len() - 1;
        &mut self.mistakes[last]
    }

    /// The child of that tag; a second one is a mistake.
    pub(super) fn child<'a>(&mut self, node: Node<'a, 'd>, tag: &str) -> Option<Node<'a, 'd>> {
        let mut children = node.children().filter(|child| child.has_tag_name(tag));
        let first = children.next();
        for other in children {
            self.error(other, messages::TWICE);
        }
        first
    }

    /// The same, but without it there is a mistake.
    pub(super) fn required_child<'a>(
        &mut self,
        node: Node<'a, 'd>,
        tag: &str,
        form: &str,
    ) -> Option<Node<'a, 'd>> {
        let child = self.child(node, tag);
        if child.is_none() {
            self.error(node, messages::missing_element(tag)).help(messages::write(form));
        }
        child
    }

    pub(super) fn text<'a>(&mut self, node: Node<'a, 'd>, attribute: &str) -> Option<&'a str> {
        let text = node.attribute(attribute);
        if text.is_none() {
            self.error(node, messages::missing_attribute(attribute));
        }
        text
    }

    pub(super) fn number(&mut self, node: Node<'_, 'd>, attribute: &str) -> Option<Decimal> {
        self.text(node, attribute)?;
        self.optional_number(node, attribute)
    }

    pub(super) fn optional_number(&mut self, node: Node<'_, 'd>, attribute: &str) -> Option<Decimal> {
        let text = node.attribute(attribute)?.trim();
        let number = Decimal::parse(text);
        if number.is_none() {
            self.error_in(node, attribute, messages::no_number(attribute, text));
        }
        number
    }

    /// Three numbers; `None` if there is no such attribute, or after a mistake.
    pub(super) fn triple(&mut self, node: Node<'_, 'd>, attribute: &str) -> Option<[Decimal; 3]> {
        let words = node.attribute(attribute)?.split_whitespace().collect::<Vec<_>>();
        let Ok(words) = <[&str; 3]>::try_from(words.as_slice()) else {
            self.error_in(node, attribute, messages::no_triple(attribute, words.len()));
            return None;
        };
        let numbers = words.map(Decimal::parse);
        if let Some(wrong) =
            words.iter().zip(&numbers).find_map(|(word, number)| number.is_none().then_some(word))
        {
            self.error_in(node, attribute, messages::no_number(attribute, wrong));
        }
        let [x, y, z] = numbers;
        Some([x?, y?, z?])
    }

    /// Place and orientation of an `<origin>`: zero where nothing is said.
    pub(super) fn origin(&mut self, node: Node<'_, 'd>) -> [[Decimal; 3]; 2] {
        let zero = || [Decimal::zero(), Decimal::zero(), Decimal::zero()];
        let Some(origin) = self.child(node, "origin") else { return [zero(), zero()] };
        self.allow_only(origin, &["xyz", "rpy"], &[]);
        ["xyz", "rpy"].map(|attribute| self.triple(origin, attribute).unwrap_or_else(zero))
    }

    /// Warns of attributes and elements that are none of these: what is misspelt would go unnoticed.
    pub(super) fn allow_only(&mut self, node: Node<'_, 'd>, attributes: &[&str], elements: &[&str]) {
        for attribute in node.attributes().filter(|attribute| !attributes.contains(&attribute.name())) {
            let (place, name) = (attribute.range().start, attribute.name());
            let warning = self.warning_at((place, described(node)), messages::unknown_attribute(name));
            nearest(name, attributes.iter().copied())
                .into_iter()
                .for_each(|near| warning.help(messages::did_you_mean(near)));
        }
        let children = node.children().filter(Node::is_element);
        for child in children.filter(|child| !elements.contains(&child.tag_name().name())) {
            let name = child.tag_name().name();
            let warning = self.warning(child, messages::UNKNOWN_ELEMENT);
            nearest(name, elements.iter().copied())
                .into_iter()
                .for_each(|near| warning.help(messages::did_you_mean(&format!("<{near}>"))));
        }
    }
}

/// The last part of an element in words, without names: `<axis>` of `joint "elbow", <axis>`.
fn tag(mistake: &Mistake) -> &str {
    let last = mistake.element.rsplit(", ").next().unwrap_or_default();
    if last.starts_with('<') { last } else { last.split(' ').next().unwrap_or_default() }
}

/// An element in words: `link "arm", <mass>`.
pub(super) fn described(node: Node<'_, '_>) -> String {
    let tag = node.tag_name().name();
    let named = |node: Node<'_, '_>| Some(messages::element(node.tag_name().name(), node.attribute("name")?));
    let is_part = |node: &Node<'_, '_>| ["link", "joint"].contains(&node.tag_name().name());
    let outer = node.ancestors().skip(1).find(is_part).and_then(named);
    match (is_part(&node).then(|| named(node)).flatten(), outer) {
        (Some(named), _) => named,
        (None, Some(outer)) => format!("{outer}, <{tag}>"),
        (None, None) => format!("<{tag}>"),
    }
}
