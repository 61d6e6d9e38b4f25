//! Declarations of robots, for reading and editing.
//!
//! The order follows the tree: each link precedes the joint that places it. The printer of the
//! language supports no comments and writes one line per statement, so this module has its own
//! [`layout`]. The caller checks that the text is parsed as intended.

mod contacts;
mod joints;
mod layout;
mod stops;
mod words;

use crate::decimal::Decimal;
use crate::names::{FREE, GROUND, Identifiers, tells};
use crate::robot::{Inertial, Joint, Kind, Link, Robot};
use joints::Placed;
use layout::{Page, vector};

/// The choices that the robot does not determine.
pub(crate) struct Style {
    /// Name of the struct.
    pub(crate) name: String,
    /// True if the base moves freely.
    pub(crate) is_free: bool,
    /// True if each coordinate gets an input that acts as a force on it.
    pub(crate) has_inputs: bool,
    /// True if limits of joints become stops, and limits of efforts clamp inputs.
    pub(crate) has_limits: bool,
    /// True if joints have their dry friction.
    pub(crate) has_friction: bool,
    /// True if collision spheres touch the ground.
    pub(crate) has_contacts: bool,
    /// Links whose corners of collision boxes and rims of collision cylinders touch the ground.
    pub(crate) cornered: Vec<usize>,
}

/// A moving part: a joint, or the base.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Motion {
    /// The name of the joint in the file; `None` for a base that moves freely.
    pub joint: Option<String>,
    /// Names of its positions in the state.
    pub positions: Vec<String>,
    /// Number of its velocities.
    pub velocities: usize,
}

/// A declaration.
#[derive(Default)]
pub(crate) struct Declared {
    /// The declaration, including the macro.
    pub(crate) text: String,
    /// Statements within the macro.
    pub(crate) statements: String,
    pub(crate) motions: Vec<Motion>,
    /// Joints whose limits leave no range.
    pub(crate) rangeless: Vec<usize>,
    /// Links with a collision shape that stays at a constant height.
    pub(crate) level: Vec<usize>,
    /// Number of events and dry frictions.
    pub(crate) event_count: usize,
}

/// The statements written so far, and their names.
struct Writer<'r> {
    robot: &'r Robot,
    page: Page,
    identifiers: Identifiers,
    /// Identifiers of links, including [`GROUND`].
    links: Vec<String>,
    /// Coordinates of joints with a single coordinate.
    coordinates: Vec<Option<String>>,
    declared: Declared,
    /// True for each link that never moves.
    at_rest: Vec<bool>,
}

pub(crate) fn declaration(robot: &Robot, style: &Style) -> Declared {
    let mut writer = Writer::new(robot, style);
    writer.head(style);
    writer.base(style);
    for (index, joint) in robot.joints.iter().enumerate() {
        writer.page.gap();
        writer.placed_by(index, joint);
    }
    writer.mimics();
    if style.has_inputs {
        writer.inputs(style.has_limits);
    }
    if style.has_limits {
        writer.stops();
    }
    if style.has_friction {
        writer.friction();
    }
    writer.contacts(style);
    let Writer { page, declared, .. } = writer;
    let statements = page.text();
    Declared { text: format!("lagrange::system! {{\n{statements}}}\n"), statements, ..declared }
}

impl<'r> Writer<'r> {
    fn new(robot: &'r Robot, style: &Style) -> Writer<'r> {
        let mut identifiers = Identifiers::default();
        let is_ground = robot.links[robot.root].inertial.is_none() && !style.is_free;
        let mut is_freed = vec![false; robot.links.len()];
        is_freed[robot.root] = style.is_free;
        for joint in robot.joints.iter().filter(|joint| is_ground && joint.parent == robot.root) {
            is_freed[joint.child] |= is_plainly_floating(joint);
        }
        let links = robot.links.iter().enumerate().map(|(index, link)| {
            if index == robot.root && is_ground {
                return GROUND.to_owned();
            }
            identifiers.take(&link.name, "link", if is_freed[index] { &FREE } else { &[] })
        });
        let links = links.collect();
        let at_rest = match style.is_free {
            true => vec![false; robot.links.len()],
            false => robot.fixed_in_root(),
        };
        let coordinates = vec![None; robot.joints.len()];
        let (page, declared) = (Page::default(), Declared::default());
        Writer { robot, page, identifiers, links, coordinates, declared, at_rest }
    }

    fn head(&mut self, style: &Style) {
        self.page.comment("///", &format!("Robot `{}`.", plain(&self.robot.name)));
        self.page.line("#[derive(Clone, Debug)]");
        self.page.line(&format!("pub struct {};", style.name));
        self.page.gap();
        self.page.line("gravity = (0, 0, -9.81);");
        self.page.gap();
    }

    /// Writes the link that no joint places.
    fn base(&mut self, style: &Style) {
        let (root, name) = (self.robot.root, self.links[self.robot.root].clone());
        if name == GROUND {
            return;
        }
        self.link(root);
        if !style.is_free {
            self.page.comment("//", &format!("With `free {name};` in the position of this it moves freely."));
            return self.page.line(&format!("weld {GROUND} to {name};"));
        }
        self.page.line(&format!("free {name};"));
        self.declared.motions.push(free_motion(None, &name));
    }

    /// Writes a link, and the joint that places it.
    fn placed_by(&mut self, index: usize, joint: &'r Joint) {
        self.link(joint.child);
        let placed = Placed {
            joint,
            parent: self.links[joint.parent].clone(),
            child: self.links[joint.child].clone(),
        };
        match joint.kind {
            Kind::Revolute | Kind::Prismatic => self.coordinates[index] = Some(self.simple(&placed)),
            Kind::Planar => self.planar(&placed),
            Kind::Floating => self.floating(&placed),
            Kind::Fixed => self.weld(&placed),
            Kind::Held => {
                self.page
                    .comment("//", &format!("Joint `{}` moves no mass: it is held.", plain(&joint.name)));
                self.weld(&placed);
            }
        }
    }

    /// Writes `body` or `frame`. A link at rest with impossible inertia becomes a frame.
    fn link(&mut self, index: usize) {
        let (link, name) = (&self.robot.links[index], self.links[index].clone());
        if !tells(&name, &link.name) {
            self.page.comment("//", &format!("Link `{}` of the file.", plain(&link.name)));
        }
        let is_body =
            link.inertial.as_ref().is_some_and(|inertial| !self.at_rest[index] || inertial.is_physical);
        let written = words::shapes(&link.shapes, is_body);
        written.iter().for_each(|shapes| self.page.comment("//", shapes));
        match &link.inertial {
            None => self.page.line(&format!("frame {name};")),
            Some(inertial) if self.at_rest[index] && !inertial.is_physical => {
                let comment =
                    format!("At rest, with a mass of {} kg and inertia that no body has.", inertial.mass);
                self.page.comment("//", &comment);
                self.page.line(&format!("frame {name};"));
            }
            Some(inertial) => self.body(link, &name, inertial),
        }
    }

    fn body(&mut self, link: &Link, name: &str, inertial: &Inertial) {
        let Inertial { mass, centroid, tensor, is_physical, .. } = inertial;
        let mut properties = vec![format!("mass: {mass};")];
        if centroid.iter().any(|component| !component.is_zero()) {
            properties.push(format!("centroid: {};", vector(centroid)));
        }
        let mut moments = tensor[..3].iter().map(ToString::to_string).collect::<Vec<_>>();
        if !is_physical {
            moments = self.impossible_moments(link, name, &moments);
        }
        if tensor[3..].iter().any(|product| !product.is_zero()) {
            moments.extend(tensor[3..].iter().map(ToString::to_string));
        }
        properties.push(format!("inertia: {};", vector(moments)));
        properties.extend(words::visual(&link.shapes));
        self.page.block(&format!("body {name}"), &properties);
    }

    /// Declares moments of inertia as parameters. Impossible numbers are an error, but impossible
    /// defaults of parameters are only a warning.
    fn impossible_moments(&mut self, link: &Link, name: &str, moments: &[String]) -> Vec<String> {
        let names =
            ["xx", "yy", "zz"].map(|axes| self.identifiers.take(&format!("{name}_{axes}"), "inertia", &[]));
        self.page.comment(
            "///",
            &format!("No body has the inertia that the file states of `{}`.", plain(&link.name)),
        );
        let definitions = names.iter().zip(moments).map(|(name, moment)| format!("{name} = {moment}"));
        self.page.list("param", &definitions.collect::<Vec<_>>());
        names.to_vec()
    }

    /// Writes the constraints of coordinates that follow others.
    fn mimics(&mut self) {
        let robot = self.robot;
        self.page.gap();
        for (index, joint) in robot.joints.iter().enumerate() {
            let Some(mimic) = &joint.mimic else { continue };
            let (Some(follower), Some(leader)) = (&self.coordinates[index], &self.coordinates[mimic.joint])
            else {
                continue;
            };
            let residual = residual(follower, leader, &mimic.multiplier, &mimic.offset);
            let name = self.identifiers.take(&format!("{follower}_mimic"), "constraint", &[]);
            self.page.line(&format!("constraint {name} = {residual};"));
        }
    }

    /// Writes motors for all coordinates that do not follow others. If requested, efforts limit
    /// their forces.
    fn inputs(&mut self, are_limited: bool) {
        let joints = self.robot.joints.iter().zip(self.coordinates.clone());
        let driven = joints
            .filter(|(joint, _)| joint.mimic.is_none())
            .filter_map(|(joint, coordinate)| Some((coordinate?, joint.limit.effort.as_ref())));
        let driven = driven.map(|(coordinate, effort)| {
            let input = self.identifiers.take(&format!("u_{coordinate}"), "input", &[]);
            let force = match effort.filter(|effort| are_limited && effort.value() > 0.0) {
                Some(effort) => format!("max(-{effort}, min({effort}, {input}))"),
                None => input.clone(),
            };
            (input, format!("force {coordinate} = {force};"))
        });
        let driven = driven.collect::<Vec<_>>();
        if driven.is_empty() {
            return;
        }
        self.page.gap();
        self.page.list("input", &driven.iter().map(|(input, _)| input.clone()).collect::<Vec<_>>());
        driven.iter().for_each(|(_, force)| self.page.line(force));
    }
}

/// Writes the residual of follower = multiplier · leader + offset.
fn residual(follower: &str, leader: &str, multiplier: &Decimal, offset: &Decimal) -> String {
    let sign = |number: &Decimal| if number.value() < 0.0 { "+" } else { "-" };
    let mut text = follower.to_owned();
    if !multiplier.is_zero() {
        let factor = multiplier.magnitude();
        let factor = if factor.value() == 1.0 { String::new() } else { format!("{factor} * ") };
        text.push_str(&format!(" {} {factor}{leader}", sign(multiplier)));
    }
    if !offset.is_zero() {
        text.push_str(&format!(" {} {}", sign(offset), offset.magnitude()));
    }
    text
}

fn free_motion(joint: Option<&str>, name: &str) -> Motion {
    let positions = ["x", "y", "z", "qw", "qx", "qy", "qz"].map(|ending| format!("{name}_{ending}"));
    Motion { joint: joint.map(str::to_owned), positions: positions.to_vec(), velocities: 6 }
}

/// True if a floating joint places a link without a displaced or rotated frame of its own.
fn is_plainly_floating(joint: &Joint) -> bool {
    joint.kind == Kind::Floating && joint.at.iter().chain(&joint.turned).all(Decimal::is_zero)
}

/// Returns a name of the file for a comment: on one line, with escapes for invisible characters.
fn plain(name: &str) -> String {
    let mut plain = String::new();
    for character in name.split_whitespace().collect::<Vec<_>>().join(" ").chars() {
        match character {
            '`' => plain.push('\''),
            _ if is_invisible(character) => plain.extend(character.escape_unicode()),
            _ => plain.push(character),
        }
    }
    plain
}

/// True for characters that are invisible or change the display of others; the compiler rejects
/// some of them in comments.
fn is_invisible(character: char) -> bool {
    character.is_control()
        || matches!(
            character,
            '\u{ad}'
                | '\u{61c}'
                | '\u{180e}'
                | '\u{200b}'..='\u{200f}'
                | '\u{2028}'..='\u{202e}'
                | '\u{2060}'..='\u{206f}'
                | '\u{feff}'
                | '\u{fff0}'..='\u{fffb}'
                | '\u{e0000}'..='\u{e0fff}'
        )
}
