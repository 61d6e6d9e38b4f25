//! Joints: their frames, kinds and limits.

use lagrange_core::diagnostics::nearest;
use roxmltree::Node;

use super::collector::Source;
use super::messages;
use super::source::attribute_of;
use crate::decimal::Decimal;
use crate::robot::{KINDS, Kind, Limit};

/// Minimum length of an axis. Shorter ones are attributed to cancellation.
const SHORTEST_AXIS: f64 = 1e-6;

/// A joint with links and leader given by names.
pub(super) struct NamedJoint<'a> {
    pub(super) name: &'a str,
    pub(super) kind: Kind,
    pub(super) parent: NameAt<'a>,
    pub(super) child: NameAt<'a>,
    pub(super) at: [Decimal; 3],
    pub(super) turned: [Decimal; 3],
    pub(super) axis: [Decimal; 3],
    pub(super) limit: Limit,
    pub(super) damping: Option<Decimal>,
    pub(super) friction: Option<Decimal>,
    pub(super) mimic: Option<NamedMimic<'a>>,
    pub(super) place: usize,
}

/// A name with its place, and the description of its element.
pub(super) struct NameAt<'a> {
    pub(super) name: &'a str,
    pub(super) place: (usize, String),
}

pub(super) struct NamedMimic<'a> {
    pub(super) joint: NameAt<'a>,
    pub(super) multiplier: Decimal,
    pub(super) offset: Decimal,
}

/// Elements of a joint that are intended for other programs.
const LEFT_OUT: [&str; 2] = ["calibration", "safety_controller"];

/// Reads a joint; `None` if the file does not specify the links that it connects.
pub(super) fn joint<'a, 'd>(source: &mut Source<'d>, node: Node<'a, 'd>) -> Option<NamedJoint<'a>> {
    let known = ["origin", "parent", "child", "axis", "limit", "dynamics", "mimic", LEFT_OUT[0], LEFT_OUT[1]];
    source.allow_only(node, &["name", "type"], &known);
    let kind = kind(source, node);
    let [at, turned] = source.origin(node);
    let parent = end(source, node, "parent");
    let child = end(source, node, "child");
    let axis = axis(source, node);
    let (limit, (damping, friction)) = (limit(source, node), dynamics(source, node));
    let mimic = mimic(source, node);
    let (parent, child) = (parent?, child?);
    if damping.is_some() && matches!(kind, Kind::Planar | Kind::Floating) {
        source.warning(node, messages::DAMPING_LEFT_OUT);
    }
    let name = attribute_of(node, "name").unwrap_or_default();
    let place = node.range().start;
    Some(NamedJoint { name, kind, parent, child, at, turned, axis, limit, damping, friction, mimic, place })
}

/// Reads the kind of a joint; `Fixed` after a mistake.
fn kind<'d>(source: &mut Source<'d>, node: Node<'_, 'd>) -> Kind {
    let Some(word) = source.text(node, "type") else { return Kind::Fixed };
    if let Some((_, kind)) = KINDS.into_iter().find(|(known, _)| *known == word) {
        return kind;
    }
    let help = messages::kinds_help(nearest(word, KINDS.map(|(known, _)| known)));
    source.error(node, messages::unknown_kind(word)).help(help);
    Kind::Fixed
}

fn end<'a, 'd>(source: &mut Source<'d>, node: Node<'a, 'd>, tag: &str) -> Option<NameAt<'a>> {
    let end = source.required_child(node, tag, &format!("<{tag} link=\"NAME\"/>"))?;
    source.allow_only(end, &["link"], &[]);
    name_at(source, end, "link")
}

fn name_at<'a, 'd>(source: &mut Source<'d>, node: Node<'a, 'd>, attribute: &str) -> Option<NameAt<'a>> {
    let name = source.text(node, attribute)?;
    Some(NameAt { name, place: (node.range().start, super::source::described(node)) })
}

/// Reads the axis; x by default.
fn axis<'d>(source: &mut Source<'d>, node: Node<'_, 'd>) -> [Decimal; 3] {
    let x = || [Decimal::of(1.0), Decimal::zero(), Decimal::zero()];
    let Some(child) = source.child(node, "axis") else { return x() };
    source.allow_only(child, &["xyz"], &[]);
    let Some(axis) = source.text(child, "xyz").and_then(|_| source.numbers(child, "xyz")) else { return x() };
    let is_unused = ["fixed", "floating"].contains(&attribute_of(node, "type").unwrap_or_default());
    if axis.iter().all(|component| component.value().abs() < SHORTEST_AXIS) && !is_unused {
        source.error(child, messages::AXIS_ZERO);
        return x();
    }
    axis
}

fn limit<'d>(source: &mut Source<'d>, node: Node<'_, 'd>) -> Limit {
    let Some(child) = source.child(node, "limit") else { return Limit::default() };
    let attributes = ["lower", "upper", "effort", "velocity"];
    source.allow_only(child, &attributes, &[]);
    let [lower, upper, effort, velocity] =
        attributes.map(|attribute| source.optional_number(child, attribute));
    let mut limit = Limit { lower, upper, effort, velocity };
    match attribute_of(node, "type") {
        Some("continuous") if limit.lower.is_some() || limit.upper.is_some() => {
            source.warning(child, messages::CONTINUOUS_LIMITS);
            (limit.lower, limit.upper) = (None, None);
        }
        // If only one is specified, the other defaults to zero.
        Some("revolute" | "prismatic") if limit.lower.is_some() != limit.upper.is_some() => {
            limit.lower.get_or_insert_with(Decimal::zero);
            limit.upper.get_or_insert_with(Decimal::zero);
        }
        _ => {}
    }
    if let (Some(lower), Some(upper)) = (&limit.lower, &limit.upper)
        && lower.value() > upper.value()
    {
        source.warning(child, messages::LIMITS_CROSSED);
    }
    limit
}

/// Reads damping and dry friction, unless they are zero.
fn dynamics<'d>(source: &mut Source<'d>, node: Node<'_, 'd>) -> (Option<Decimal>, Option<Decimal>) {
    let Some(child) = source.child(node, "dynamics") else { return (None, None) };
    source.allow_only(child, &["damping", "friction"], &[]);
    let [damping, friction] =
        ["damping", "friction"].map(|attribute| source.optional_number(child, attribute));
    if damping.as_ref().is_some_and(|damping| damping.value() < 0.0) {
        source.error(child, messages::NEGATIVE_DAMPING);
    }
    let not_zero = |number: &Decimal| !number.is_zero();
    (damping.filter(not_zero), friction.filter(not_zero))
}

fn mimic<'a, 'd>(source: &mut Source<'d>, node: Node<'a, 'd>) -> Option<NamedMimic<'a>> {
    let child = source.child(node, "mimic")?;
    source.allow_only(child, &["joint", "multiplier", "offset"], &[]);
    let joint = name_at(source, child, "joint");
    let mut number = |attribute: &str, default: f64| match attribute_of(child, attribute) {
        None => Some(Decimal::of(default)),
        Some(_) => source.optional_number(child, attribute),
    };
    let (multiplier, offset) = (number("multiplier", 1.0), number("offset", 0.0));
    Some(NamedMimic { joint: joint?, multiplier: multiplier?, offset: offset? })
}
