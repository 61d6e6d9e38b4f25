//! Elements of a file: their required and optional content, with mistakes collected at their lines.

use lagrange_core::diagnostics::nearest;
use roxmltree::{Attribute, Node};

use super::collector::Source;
use super::messages;
use crate::decimal::Decimal;
use crate::mistakes::Mistake;
use crate::rotation::{angles_of, from_quaternion};

/// Elements that determine the motion of a robot. They are not ignored if misplaced or misspelt.
const MECHANICAL: [&str; 11] = [
    "link", "joint", "inertial", "origin", "mass", "inertia", "parent", "child", "axis", "mimic", "dynamics",
];
/// Elements without unknown attributes. Other programs add attributes to joints and their dynamics.
const EXACT: [&str; 7] = ["origin", "mass", "inertia", "parent", "child", "axis", "mimic"];

impl<'d> Source<'d> {
    pub(super) fn error(&mut self, node: Node<'_, '_>, message: impl Into<String>) -> &mut Mistake {
        self.error_at((node.range().start, described(node)), message)
    }

    pub(super) fn warning(&mut self, node: Node<'_, '_>, message: impl Into<String>) -> &mut Mistake {
        self.warning_at((node.range().start, described(node)), message)
    }

    pub(super) fn error_in(&mut self, node: Node<'_, '_>, name: &str, message: String) -> &mut Mistake {
        let written = attribute_node(node, name).map(|attribute| attribute.range().start);
        self.error_at((written.unwrap_or(node.range().start), described(node)), message)
    }

    /// Returns the child with this tag; a second one is a mistake.
    pub(super) fn child<'a>(&mut self, node: Node<'a, 'd>, tag: &str) -> Option<Node<'a, 'd>> {
        let mut children = tagged(node, tag);
        let first = children.next();
        for other in children {
            self.error(other, messages::TWICE);
        }
        first
    }

    /// Returns the required child; a missing one is a mistake.
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
        let text = attribute_of(node, attribute);
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
        let text = attribute_of(node, attribute)?.trim();
        let number = Decimal::parse(text);
        if number.is_none() {
            self.error_in(node, attribute, messages::no_number(attribute, text));
        }
        number
    }

    /// Reads three or four numbers; `None` without the attribute, or after a mistake.
    pub(super) fn numbers<const N: usize>(
        &mut self,
        node: Node<'_, 'd>,
        attribute: &str,
    ) -> Option<[Decimal; N]> {
        let text = attribute_of(node, attribute)?;
        let words = text.split_whitespace().take(N).collect::<Vec<_>>();
        let count = text.split_whitespace().count();
        let Some(words) = <[&str; N]>::try_from(words).ok().filter(|_| count == N) else {
            self.error_in(node, attribute, messages::wrong_count(attribute, N, count));
            return None;
        };
        let numbers = words.map(Decimal::parse);
        if let Some(wrong) =
            words.iter().zip(&numbers).find_map(|(word, number)| number.is_none().then_some(word))
        {
            self.error_in(node, attribute, messages::no_number(attribute, wrong));
        }
        let numbers = numbers.into_iter().collect::<Option<Vec<_>>>()?;
        numbers.try_into().ok()
    }

    /// Reads position and orientation of an `<origin>`, the latter as roll, pitch and yaw; zero by
    /// default.
    pub(super) fn origin(&mut self, node: Node<'_, 'd>) -> [[Decimal; 3]; 2] {
        let zero = || [Decimal::zero(), Decimal::zero(), Decimal::zero()];
        let Some(origin) = self.child(node, "origin") else { return [zero(), zero()] };
        self.allow_only(origin, &["xyz", "rpy", "quat_xyzw"], &[]);
        let turned = match (attribute_of(origin, "rpy"), attribute_of(origin, "quat_xyzw")) {
            (Some(_), Some(_)) => {
                self.error(origin, messages::TURNED_TWICE).help(messages::TURNED_TWICE_HELP);
                None
            }
            (None, Some(_)) => self.quaternion(origin, "quat_xyzw"),
            _ => self.numbers(origin, "rpy"),
        };
        [self.numbers(origin, "xyz").unwrap_or_else(zero), turned.unwrap_or_else(zero)]
    }

    /// Reads a quaternion of any length, real part last, as roll, pitch and yaw.
    fn quaternion(&mut self, node: Node<'_, 'd>, attribute: &str) -> Option<[Decimal; 3]> {
        let components = self.numbers::<4>(node, attribute)?;
        let rotation = from_quaternion(components.each_ref().map(Decimal::value));
        if rotation.is_none() {
            self.error_in(node, attribute, messages::QUATERNION_ZERO.to_owned())
                .help(messages::IDENTITY_HELP);
        }
        Some(angles_of(rotation?).map(Decimal::of))
    }

    /// Warns about attributes and elements that are not listed. Those that may change the motion
    /// are errors.
    pub(super) fn allow_only(&mut self, node: Node<'_, 'd>, attributes: &[&str], elements: &[&str]) {
        self.report_foreign(node);
        for attribute in node.attributes().filter(|attribute| attribute.namespace().is_none()) {
            if !attributes.contains(&attribute.name()) {
                self.report_attribute(node, attribute, attributes);
            }
        }
        for child in self::elements(node).filter(|child| !elements.contains(&child.tag_name().name())) {
            self.report_element(child, elements);
        }
    }

    fn report_attribute(&mut self, node: Node<'_, 'd>, attribute: Attribute<'_, 'd>, known: &[&str]) {
        let (place, name, tag) = (attribute.range().start, attribute.name(), node.tag_name().name());
        let near = nearest(name, known.iter().copied());
        let here = (place, described(node));
        if EXACT.contains(&tag) || tag == "dynamics" && near.is_some() {
            let help = near.map_or_else(|| messages::known_attributes(known), messages::did_you_mean);
            self.error_at(here, messages::unreadable_attribute(name)).help(help);
        } else {
            let warning = self.warning_at(here, messages::unknown_attribute(name));
            near.into_iter().for_each(|near| warning.help(messages::did_you_mean(near)));
        }
    }

    fn report_element(&mut self, child: Node<'_, 'd>, known: &[&str]) {
        let name = child.tag_name().name();
        let near = nearest(name, known.iter().copied());
        let is_misplaced = MECHANICAL.contains(&name) && !is_identity(child);
        let is_misspelt = near.is_some_and(|near| MECHANICAL.contains(&near)) && !MECHANICAL.contains(&name);
        let suggestion = near.map(|near| messages::did_you_mean(&format!("<{near}>")));
        if is_misplaced || is_misspelt {
            let help = suggestion.filter(|_| is_misspelt);
            let help = help.unwrap_or_else(|| messages::UNREADABLE_ELEMENT_HELP.to_owned());
            self.error(child, messages::UNREADABLE_ELEMENT).help(help);
        } else {
            let warning = self.warning(child, messages::UNKNOWN_ELEMENT);
            suggestion.into_iter().for_each(|suggestion| warning.help(suggestion));
        }
    }

    /// Warns about attributes and elements of other namespaces. Warnings of the same prefix are
    /// later merged.
    fn report_foreign(&mut self, node: Node<'_, 'd>) {
        let foreign = |namespace: &str| messages::foreign(node.lookup_prefix(namespace));
        for attribute in node.attributes() {
            if let Some(namespace) = attribute.namespace().filter(|namespace| !is_of_xml(namespace)) {
                let place = (attribute.range().start, String::new());
                self.warning_at(place, foreign(namespace));
            }
        }
        for child in node.children().filter(|child| child.is_element() && !is_own(*child)) {
            let prefix = child.tag_name().namespace().and_then(|namespace| child.lookup_prefix(namespace));
            self.warning_at((child.range().start, String::new()), messages::foreign(prefix));
        }
    }
}

/// True for namespaces of XML itself, which do not describe the robot.
fn is_of_xml(namespace: &str) -> bool {
    ["http://www.w3.org/XML/", "http://www.w3.org/2001/XMLSchema"]
        .iter()
        .any(|own| namespace.starts_with(own))
}

/// True if an element belongs to the namespace of the whole file; other namespaces are for other
/// programs.
fn is_own(node: Node<'_, '_>) -> bool {
    node.tag_name().namespace() == node.document().root_element().tag_name().namespace()
}

/// Returns the child elements in the namespace of the file.
pub(super) fn elements<'a, 'd>(node: Node<'a, 'd>) -> impl Iterator<Item = Node<'a, 'd>> {
    node.children().filter(|child| child.is_element() && is_own(*child))
}

/// Returns the value of an attribute of URDF. The XML library would also find attributes of other
/// namespaces.
pub(super) fn attribute_of<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    attribute_node(node, name).map(|attribute| attribute.value())
}

fn attribute_node<'a, 'd>(node: Node<'a, 'd>, name: &str) -> Option<Attribute<'a, 'd>> {
    node.attributes().find(|attribute| attribute.namespace().is_none() && attribute.name() == name)
}

/// Returns the nodes with a tag.
pub(super) fn tagged<'a, 'd>(node: Node<'a, 'd>, tag: &str) -> impl Iterator<Item = Node<'a, 'd>> {
    elements(node).filter(move |child| child.tag_name().name() == tag)
}

/// True for an `<origin>` without displacement and rotation, in any element.
fn is_identity(node: Node<'_, '_>) -> bool {
    let is_zero = |word: &str| Decimal::parse(word).is_some_and(|number| number.is_zero());
    node.tag_name().name() == "origin"
        && node.attributes().all(|attribute| {
            ["xyz", "rpy"].contains(&attribute.name()) && attribute.value().split_whitespace().all(is_zero)
        })
}

/// Returns the description of an element: `link "arm", <mass>`.
pub(super) fn described(node: Node<'_, '_>) -> String {
    let tag = messages::shortened(node.tag_name().name());
    let named =
        |node: Node<'_, '_>| Some(messages::element(node.tag_name().name(), attribute_of(node, "name")?));
    let is_part = |node: &Node<'_, '_>| ["link", "joint"].contains(&node.tag_name().name());
    let outer = node.ancestors().skip(1).find(is_part).and_then(named);
    match (is_part(&node).then(|| named(node)).flatten(), outer) {
        (Some(named), _) => named,
        (None, Some(outer)) => format!("{outer}, <{tag}>"),
        (None, None) => format!("<{tag}>"),
    }
}
