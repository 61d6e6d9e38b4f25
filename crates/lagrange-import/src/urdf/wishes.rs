//! Requested limits, friction and contacts that have no counterpart in the robot.

use lagrange_core::diagnostics::nearest;
use lagrange_core::emit::MAX_CONTACT_EVENTS;

use super::collector::Source;
use super::{Options, messages};
use crate::decimal::Decimal;
use crate::declaration::Declared;
use crate::robot::{Joint, Kind, Link, Robot, Solid};

pub(super) fn report(source: &mut Source<'_>, robot: &Robot, options: &Options) {
    robot.joints.iter().for_each(|joint| report_joint(source, joint, options));
    let at_rest = if options.is_free { vec![false; robot.links.len()] } else { robot.fixed_in_root() };
    let moving = robot.links.iter().zip(at_rest).filter(|(_, at_rest)| !at_rest).map(|(link, _)| link);
    let has = |link: &Link, solid| link.collisions().any(|shape| shape.solid == solid);
    let has_edges = |link: &Link| has(link, Solid::Box) || has(link, Solid::Cylinder);
    let has_corners = |link: &Link| options.corners.contains(&link.name);
    if options.has_contacts {
        moving.clone().for_each(|link| report_left_out(source, link, has_corners(link)));
        if !moving.clone().any(|link| has(link, Solid::Sphere)) {
            source.warning_at(link_place(&robot.links[robot.root]), messages::NOTHING_TOUCHES);
        }
    }
    for name in &options.corners {
        let Some(link) = robot.links.iter().find(|link| link.name == *name) else {
            let near = nearest(name, robot.links.iter().map(|link| link.name.as_str()));
            let mistake = source.error_at((0, String::new()), messages::unknown_cornered(name));
            near.into_iter().for_each(|near| mistake.help(messages::did_you_mean(near)));
            continue;
        };
        if !moving.clone().any(|moving| moving.name == *name && has_edges(moving)) {
            source.error_at(link_place(link), messages::NO_CORNERS);
        }
    }
}

fn report_joint(source: &mut Source<'_>, joint: &Joint, options: &Options) {
    let is_not_positive = |effort: &Decimal| effort.value() <= 0.0;
    let is_driven = joint.kind.is_simple() && joint.mimic.is_none() && options.has_inputs;
    if options.has_limits && is_driven && joint.limit.effort.as_ref().is_some_and(is_not_positive) {
        source.warning_at(joint_place(joint), messages::NO_EFFORT);
    }
    let Some(friction) = joint.friction.as_ref().filter(|_| options.has_friction) else { return };
    if matches!(joint.kind, Kind::Planar | Kind::Floating) {
        source.warning_at(joint_place(joint), messages::FRICTION_LEFT_OUT);
    } else if friction.value() < 0.0 {
        source.error_at(joint_place(joint), messages::NEGATIVE_FRICTION);
    }
}

fn report_left_out(source: &mut Source<'_>, link: &Link, has_corners: bool) {
    let has = |solid| link.collisions().any(|shape| shape.solid == solid);
    for (solid, message) in
        [(Solid::Box, messages::BOX_LEFT_OUT), (Solid::Cylinder, messages::CYLINDER_LEFT_OUT)]
    {
        if has(solid) && !has_corners {
            source.warning_at(link_place(link), message).help(messages::LEFT_OUT_HELP);
        }
    }
    if link.collides_as_mesh {
        source.warning_at(link_place(link), messages::SHAPE_LEFT_OUT).help(messages::SHAPE_LEFT_OUT_HELP);
    }
}

/// Reports joints without stops, links that cannot touch, and more contacts than runs locate.
pub(super) fn report_written(source: &mut Source<'_>, robot: &Robot, declared: &Declared) {
    for &joint in &declared.rangeless {
        source.warning_at(joint_place(&robot.joints[joint]), messages::NO_RANGE);
    }
    let mut level = declared.level.clone();
    level.dedup();
    for link in level {
        source.warning_at(link_place(&robot.links[link]), messages::LEVEL);
    }
    if declared.event_count > MAX_CONTACT_EVENTS {
        let message = messages::many_events(declared.event_count, MAX_CONTACT_EVENTS);
        let root = link_place(&robot.links[robot.root]);
        source.warning_at(root, message).help(messages::FEWER_EVENTS_HELP);
    }
}

fn link_place(link: &Link) -> (usize, String) {
    (link.place, messages::element("link", &link.name))
}

fn joint_place(joint: &Joint) -> (usize, String) {
    (joint.place, messages::element("joint", &joint.name))
}
