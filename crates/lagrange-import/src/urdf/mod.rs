//! URDF, the format in which robots are described for ROS: XML with `<link>` and `<joint>`
//! elements.
//!
//! [`import`] writes a declaration for `lagrange::system!`, as a starting point for editing:
//!
//! ```
//! use lagrange_import::urdf::{Options, import};
//!
//! let robot = r#"<robot name="pendulum">
//!   <link name="base"/>
//!   <link name="rod">
//!     <inertial>
//!       <origin xyz="0 0 -0.5"/> <mass value="1.50"/>
//!       <inertia ixx="0.125" iyy="0.125" izz="0.001" ixy="0" ixz="0" iyz="0"/>
//!     </inertial>
//!   </link>
//!   <joint name="Pivot" type="revolute">
//!     <parent link="base"/> <child link="rod"/> <axis xyz="0 1 0"/>
//!     <limit lower="-1.2" upper="1.2" effort="20" velocity="3"/> <dynamics damping="0.1"/>
//!   </joint>
//! </robot>"#;
//! let imported = import(robot, &Options::default()).expect("a robot");
//! assert_eq!(imported.declaration, "\
//! lagrange::system! {
//!     /// Robot `pendulum`.
//!     #[derive(Clone, Debug)]
//!     pub struct Pendulum;
//!
//!     gravity = (0, 0, -9.81);
//!
//!     body rod { mass: 1.5; centroid: (0, 0, -0.5); inertia: (0.125, 0.125, 0.001); }
//!     /// From -1.2 to 1.2 rad; at most 20 N m and 3 rad/s.
//!     revolute pivot = ground to rod { axis: (0, 1, 0); damping: 0.1; }
//! }
//! ");
//! ```
//!
//! # What becomes of a file
//!
//! | in the file | in the declaration |
//! |---|---|
//! | names | identifiers in small letters; the name of a joint is that of its coordinate. Where a name is taken, or a word of the language, `_link` or `_joint` is put to it |
//! | numbers | as they are, written short |
//! | the link that no joint places | `weld ground to base;`, or `free base;` with [`Options::is_free`]; without mass it is the ground |
//! | `<inertial>` | a `body`, its tensor in the axes of the link; a link without mass is a `frame` |
//! | `revolute`, `continuous`, `prismatic` | the joints of the language with these coordinates |
//! | `planar` | `planar` with the coordinates `NAME_x`, `NAME_y`, `NAME_angle` in the plane across the axis: x, y and z of the joint's frame after the smallest turn that takes z to the axis |
//! | `floating` | `free` if that is the same, otherwise three `prismatic` joints `NAME_x`, `NAME_y`, `NAME_z` and a `ball` joint `NAME` |
//! | `fixed` | `weld` |
//! | orientations, as `rpy` or as `quat_xyzw` of any length | `turned`; angles within 1e-9 of quarter turns are fractions of `pi`. Entries of rotations within 1e-9 of 0, 1 and −1 are these numbers where all of their row or column are |
//! | `<limit>`, friction of `<dynamics>` | documentation of the coordinate. `lower` and `upper` are zero if only the other one is given; continuous joints have none |
//! | `lower` and `upper`, with [`Options::has_limits`] | `event NAME_lower = q - lower, falling => impact(0);`, and a `start` between them if zero is not. Joints that mimic others have their stops there, as far as they are tighter |
//! | `effort`, with [`Options::has_limits`] and [`Options::has_inputs`] | bounds of the input within the force |
//! | friction of `<dynamics>`, with [`Options::has_friction`] | `friction NAME_friction = dot(q), value;` |
//! | spheres of `<collision>`, with [`Options::has_contacts`] | `contact LINK_touch = link.point(x, y, z) on ground { friction: mu; radius: r; }`, with a parameter for the coefficient of friction |
//! | boxes of `<collision>` of the links in [`Options::corners`] | `contact LINK_corner[0] = link.point(x, y, z) on ground { friction: mu; }`, and seven more |
//! | other boxes, cylinders and meshes of `<collision>`, with [`Options::has_contacts`] | a warning |
//! | damping of `<dynamics>` | `damping` |
//! | `<mimic>` | a constraint between the two coordinates |
//! | boxes, cylinders and spheres of `<visual>` and `<collision>` | `visual` of a body, which is what pictures show of it; what is collided with, and what is seen of a link without mass, are comments. Meshes are left out |
//! | `<material>`, `<transmission>`, `<gazebo>`, `<sensor>`, `<ros2_control>`, `<calibration>`, `<safety_controller>` | left out |
//!
//! Anything else is ignored with a warning, unless ignoring it may change the motion. Unknown
//! attributes of origins, axes, masses and inertia, and such elements that are misplaced or
//! misspelt, are errors. Elements and attributes of other namespaces, such as `<drake:joint>`, are
//! for other programs: they are ignored, with one warning for each prefix.
//!
//! A joint that moves no mass would have no equation of motion: it is held at zero, with a warning.
//! A link that can move without inertia otherwise, such as a free base without mass on which one
//! joint turns, is a mistake.
//!
//! Mistakes are collected, each with its line and element: nothing is written then.
//! [`listing`](crate::listing) shows the first of them. Characters of names that cannot be seen, or
//! that change the direction of text, are written as escapes.

mod collector;
mod inertia;
mod joints;
mod links;
mod messages;
mod source;
mod tree;
mod wishes;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::pipeline::parse;
use roxmltree::{Document, Node};

use crate::declaration::{Declared, Style, declaration};
use crate::mistakes::Mistake;
use crate::names::type_name;
use crate::robot::Robot;
use collector::Source;
use source::{attribute_of, tagged};

pub use crate::declaration::Motion;

/// The options of an import.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Name of the struct; by default it follows from the robot's.
    pub name: Option<String>,
    /// True if the base moves freely instead of being fixed to the ground.
    pub is_free: bool,
    /// True if each coordinate gets an input that is a force on it, as of a motor.
    pub has_inputs: bool,
    /// True if limits of joints become stops, contacts of the coordinate without restitution. With
    /// inputs, limits of efforts clamp these.
    pub has_limits: bool,
    /// True if dry friction of joints becomes `friction`.
    pub has_friction: bool,
    /// True if spheres that collide become contacts with the ground.
    pub has_contacts: bool,
    /// Names of links in the file. The corners of the boxes that they collide as become contacts
    /// with the ground.
    pub corners: Vec<String>,
    /// True if inertia that no body has becomes parameters, of which the compiler warns, instead of
    /// a mistake.
    pub trusts_inertia: bool,
}

/// A declaration from a file.
#[derive(Clone, Debug)]
pub struct Import {
    /// The declaration as a person would write it.
    pub declaration: String,
    /// Moving parts, in the order of the state.
    pub motions: Vec<Motion>,
    /// Warnings about omitted elements.
    pub warnings: Vec<Mistake>,
}

/// Writes the declaration of the robot in a URDF file.
///
/// # Errors
/// Everything that is wrong with the file, with the warnings.
pub fn import(text: &str, options: &Options) -> Result<Import, Vec<Mistake>> {
    let document = Document::parse(text).map_err(|error| vec![malformed(&error)])?;
    let mut source = Source::new(text);
    let Some(robot) = robot(&mut source, document.root_element(), options) else {
        return Err(source.into_mistakes());
    };
    let cornered = robot.links.iter().enumerate().filter(|(_, link)| options.corners.contains(&link.name));
    let style = Style {
        name: options.name.clone().unwrap_or_else(|| type_name(&robot.name)),
        is_free: options.is_free,
        has_inputs: options.has_inputs,
        has_limits: options.has_limits,
        has_friction: options.has_friction,
        has_contacts: options.has_contacts,
        cornered: cornered.map(|(link, _)| link).collect(),
    };
    let declared = declaration(&robot, &style);
    wishes::report_written(&mut source, &robot, &declared);
    let Declared { text, statements, motions, .. } = declared;
    // What is written is read once, so that nobody is handed what the language refuses.
    let without_moment = robot.first_without_moment(options.is_free);
    if source.error_count() == 0
        && let Err(report) = accepted(&statements, without_moment.is_some())
    {
        match without_moment {
            Some(link) => inertia::report_missing(&mut source, &robot, link, &report),
            None => source.error(document.root_element(), messages::not_accepted(report.to_string())),
        };
    }
    let is_accepted = source.error_count() == 0;
    let mistakes = source.into_mistakes();
    if is_accepted { Ok(Import { declaration: text, motions, warnings: mistakes }) } else { Err(mistakes) }
}

/// Reads statements, and derives the equations of motion where a link may move without inertia,
/// which only they show.
fn accepted(statements: &str, is_doubtful: bool) -> Result<(), Report> {
    let system = parse(statements)?;
    if is_doubtful { system.derive(StrategyChoice::Cheapest).map(drop) } else { Ok(()) }
}

fn malformed(error: &roxmltree::Error) -> Mistake {
    let position = error.pos();
    let (line, column) = (position.row, position.col);
    let help = match error {
        roxmltree::Error::UnknownNamespace(prefix, _) => Some(messages::undeclared_prefix(prefix)),
        _ => None,
    };
    Mistake { line, column, element: String::new(), message: error.to_string(), help, is_error: true }
}

/// `None` after a mistake.
fn robot<'d>(source: &mut Source<'d>, root: Node<'_, 'd>, options: &Options) -> Option<Robot> {
    if !root.has_tag_name("robot") {
        source.error(root, messages::NOT_A_ROBOT);
        return None;
    }
    let is_xacro =
        |node: &Node<'_, '_>| node.tag_name().namespace().is_some_and(|name| name.contains("xacro"));
    if let Some(macros) = root.descendants().find(is_xacro) {
        source.error(macros, messages::XACRO).help(messages::XACRO_HELP);
        return None;
    }
    source.allow_only(root, &["name", "version"], &KNOWN);
    check_version(source, root);
    let name = source.text(root, "name").unwrap_or_default().to_owned();
    let links = tagged(root, "link").map(|node| links::link(source, node)).collect::<Vec<_>>();
    let joints = tagged(root, "joint").map(|node| joints::joint(source, node)).collect::<Vec<_>>();
    if links.is_empty() {
        source.error(root, messages::NO_LINKS);
    }
    let is_complete = joints.iter().all(Option::is_some);
    let joints = joints.into_iter().flatten().collect();
    let mut robot = tree::tree(source, name, (links, joints), is_complete)?;
    inertia::report_impossible(source, &robot, options);
    if source.error_count() > 0 {
        return None;
    }
    tree::settle(source, &mut robot, options.is_free);
    wishes::report(source, &robot, options);
    (source.error_count() == 0).then_some(robot)
}

/// Elements mean other things in versions to come.
fn check_version<'d>(source: &mut Source<'d>, root: Node<'_, 'd>) {
    let Some(version) = attribute_of(root, "version") else { return };
    if !["1", "1.0", "1.1", "1.2"].contains(&version.trim()) {
        source.error_in(root, "version", messages::unknown_version(version)).help(messages::VERSION_HELP);
    }
}

/// Elements of a robot; from the third on, they do not concern motion.
const KNOWN: [&str; 7] = ["link", "joint", "material", "transmission", "gazebo", "sensor", "ros2_control"];
