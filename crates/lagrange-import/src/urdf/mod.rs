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
//! # Conversion of a file
//!
//! | in the file | in the declaration |
//! |---|---|
//! | names | lower-case identifiers; the name of a joint becomes that of its coordinate. If a name is in use, or is a word of the language, `_link` or `_joint` is appended |
//! | numbers | unchanged, in short form |
//! | the link that no joint places | `weld ground to base;`, or `free base;` with [`Options::is_free`]; if it has no mass, it becomes the ground |
//! | `<inertial>` | a `body` with its tensor in the axes of the link; a massless link becomes a `frame` |
//! | `revolute`, `continuous`, `prismatic` | the joints of the language with these coordinates |
//! | `planar` | `planar` with the coordinates `NAME_x`, `NAME_y`, `NAME_angle` in the plane normal to the axis: x, y and z of the joint's frame after the smallest rotation that maps z to the axis |
//! | `floating` | `free` if equivalent, otherwise three `prismatic` joints `NAME_x`, `NAME_y`, `NAME_z` and a `ball` joint `NAME` |
//! | `fixed` | `weld` |
//! | orientations, as `rpy` or as `quat_xyzw` of any length | `turned`; angles within 1e-9 of quarter turns are fractions of `pi`. Entries of rotations within 1e-9 of 0, 1 and −1 are rounded to these numbers if this applies to their whole row or column |
//! | `<limit>`, friction of `<dynamics>` | documentation of the coordinate. `lower` and `upper` default to zero if only the other one is specified; continuous joints have none |
//! | `lower` and `upper`, with [`Options::has_limits`] | `event NAME_lower = q - lower, falling => impact(0);`, and a `start` between them if they exclude zero. Stops of joints that mimic others act on the other joint if they are tighter |
//! | `effort`, with [`Options::has_limits`] and [`Options::has_inputs`] | bounds on the input in the expression of the force |
//! | friction of `<dynamics>`, with [`Options::has_friction`] | `friction NAME_friction = dot(q), value;` |
//! | spheres of `<collision>`, with [`Options::has_contacts`] | `contact LINK_touch = link.point(x, y, z) on ground { friction: mu; radius: r; }`, with a parameter for the coefficient of friction |
//! | boxes of `<collision>` of the links in [`Options::corners`] | `contact LINK_corner[0] = link.point(x, y, z) on ground { friction: mu; }`, and seven others |
//! | cylinders of `<collision>` of these links | `contact LINK_rim[0] = link.point(x, y, z) on ground { friction: mu; rim: r; axis: (a, b, c); }`, and another one for the other end |
//! | other boxes, cylinders and meshes of `<collision>`, with [`Options::has_contacts`] | a warning |
//! | damping of `<dynamics>` | `damping` |
//! | `<mimic>` | a constraint between the two coordinates |
//! | boxes, cylinders and spheres of `<visual>` and `<collision>` | `visual` of a body, its appearance in pictures; collision shapes, and visual shapes of a massless link, become comments. Meshes are omitted |
//! | `<material>`, `<transmission>`, `<gazebo>`, `<sensor>`, `<ros2_control>`, `<calibration>`, `<safety_controller>` | omitted |
//!
//! Anything else is ignored with a warning, unless ignoring it may change the motion. Unknown
//! attributes of origins, axes, masses and inertia are errors, and so are misplaced or misspelt
//! elements of this kind. Elements and attributes of other namespaces, such as `<drake:joint>`, are
//! intended for other programs. They are ignored, with one warning for each prefix.
//!
//! A joint that moves no mass would have no equation of motion: it is held at zero, with a warning.
//! Any other link that can move without inertia is a mistake, such as a massless free base that
//! carries a single revolute joint.
//!
//! Mistakes are collected, each with its line and element; nothing is written if there are any.
//! [`listing`](crate::listing) shows the first of them. Invisible characters in names, and those
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

/// Options of an import.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Name of the struct; by default it is derived from the name of the robot.
    pub name: Option<String>,
    /// True if the base moves freely instead of being fixed to the ground.
    pub is_free: bool,
    /// True if each coordinate gets an input that acts as a force on it, like a motor.
    pub has_inputs: bool,
    /// True if limits of joints become stops, contacts of the coordinate without restitution. If
    /// there are inputs, limits of efforts clamp them.
    pub has_limits: bool,
    /// True if dry friction of joints becomes `friction`.
    pub has_friction: bool,
    /// True if collision spheres become contacts with the ground.
    pub has_contacts: bool,
    /// Names of links in the file. The corners of their collision boxes, and the rims of their
    /// collision cylinders, become contacts with the ground.
    pub corners: Vec<String>,
    /// True if impossible inertia becomes parameters, about which the compiler warns, instead of a
    /// mistake.
    pub trusts_inertia: bool,
}

/// A declaration from a file.
#[derive(Clone, Debug)]
pub struct Import {
    /// The declaration, formatted for reading.
    pub declaration: String,
    /// Moving parts, in the order of the state.
    pub motions: Vec<Motion>,
    /// Warnings about omitted elements.
    pub warnings: Vec<Mistake>,
}

/// Writes the declaration of the robot in a URDF file.
///
/// # Errors
/// If the file has mistakes; warnings are included.
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
    // The result is parsed, so that a declaration that the language rejects is never returned.
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

/// Parses statements. If a link may move without inertia, the equations of motion are derived, too,
/// since only they reveal it.
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

/// Reads the robot; `None` after a mistake.
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

/// Checks the version, since elements may have other meanings in future versions.
fn check_version<'d>(source: &mut Source<'d>, root: Node<'_, 'd>) {
    let Some(version) = attribute_of(root, "version") else { return };
    if !["1", "1.0", "1.1", "1.2"].contains(&version.trim()) {
        source.error_in(root, "version", messages::unknown_version(version)).help(messages::VERSION_HELP);
    }
}

/// Known elements of a robot; those from the third on do not affect motion.
const KNOWN: [&str; 7] = ["link", "joint", "material", "transmission", "gazebo", "sensor", "ros2_control"];
