//! Joints as statements.

use super::layout::vector;
use super::{Motion, Writer, free_motion, is_plainly_floating, plain, words};
use crate::decimal::Decimal;
use crate::names::{FREE, GROUND, tells};
use crate::robot::{Joint, Kind};
use crate::rotation::{Rotation, angle, angles_of, coordinate_axis, direction, from_z_to, transposed};

/// A joint with the identifiers of the links that it connects.
pub(super) struct Placed<'r> {
    pub(super) joint: &'r Joint,
    pub(super) parent: String,
    pub(super) child: String,
}

impl Placed<'_> {
    /// Writes the pose of the joint's frame in its carrier.
    fn frame(&self) -> Vec<String> {
        [at(&self.joint.at), turned(&self.joint.turned)].into_iter().flatten().collect()
    }

    fn direction(&self) -> [f64; 3] {
        direction(self.joint.axis.each_ref().map(Decimal::value))
    }
}

fn at(place: &[Decimal; 3]) -> Option<String> {
    place.iter().any(|component| !component.is_zero()).then(|| format!("at: {};", vector(place)))
}

fn turned(angles: &[Decimal; 3]) -> Option<String> {
    let angles = angles.each_ref().map(angle);
    angles.iter().any(|angle| angle != "0").then(|| format!("turned: {};", vector(angles)))
}

fn turned_by(rotation: Rotation) -> Option<String> {
    turned(&angles_of(rotation).map(Decimal::of))
}

/// Returns the axis unless it is z, in the simple form of a coordinate axis if it is along one.
fn axis(placed: &Placed<'_>) -> Option<String> {
    match coordinate_axis(placed.direction()) {
        Some((2, false)) => None,
        Some((axis, is_negative)) => {
            let mut components = ["0"; 3];
            components[axis] = if is_negative { "-1" } else { "1" };
            Some(format!("axis: {};", vector(components)))
        }
        None => Some(format!("axis: {};", vector(&placed.joint.axis))),
    }
}

impl Writer<'_> {
    pub(super) fn weld(&mut self, placed: &Placed<'_>) {
        self.page.block(&format!("weld {} to {}", placed.parent, placed.child), &placed.frame());
    }

    /// Writes `revolute` or `prismatic`. Returns the name of its coordinate.
    pub(super) fn simple(&mut self, placed: &Placed<'_>) -> String {
        let name = self.identifiers.take(&placed.joint.name, "joint", &["dot"]);
        let word = if placed.joint.kind == Kind::Prismatic { "prismatic" } else { "revolute" };
        let mut properties = placed.frame();
        properties.extend(axis(placed));
        properties.extend(placed.joint.damping.iter().map(|damping| format!("damping: {damping};")));
        let is_named = tells(&name, &placed.joint.name);
        let called = if is_named {
            String::new()
        } else {
            format!("Joint `{}` of the file. ", plain(&placed.joint.name))
        };
        let documentation = format!("{called}{}", words::limits(placed.joint));
        if !documentation.is_empty() {
            self.page.comment("///", &documentation);
        }
        self.page.block(&format!("{word} {name} = {} to {}", placed.parent, placed.child), &properties);
        self.motion(placed, vec![name.clone()], 1);
        name
    }

    /// Writes `planar`, in the plane normal to the axis; links have the axes of the joint's frame.
    pub(super) fn planar(&mut self, placed: &Placed<'_>) {
        let names = self.component_names(placed, ["x", "y", "angle"]);
        self.document(placed.joint);
        let head = |from: &str, to: &str| format!("planar {} = {from} to {to}", vector(&names));
        let to_axis = from_z_to(placed.direction());
        if coordinate_axis(placed.direction()) == Some((2, false)) {
            self.page.block(&head(&placed.parent, &placed.child), &placed.frame());
        } else {
            let [fixed, moved] = ["plane", "in_plane"].map(|ending| self.frame_name(placed, ending));
            [&fixed, &moved].into_iter().for_each(|frame| self.page.line(&format!("frame {frame};")));
            self.page.block(&format!("weld {} to {fixed}", placed.parent), &placed.frame());
            self.page.block(&head(&fixed, &moved), &Vec::from_iter(turned_by(to_axis)));
            let back = Vec::from_iter(turned_by(transposed(to_axis)));
            self.page.block(&format!("weld {moved} to {}", placed.child), &back);
        }
        self.motion(placed, names.to_vec(), 3);
    }

    /// Writes `free` if the joint's frame is that of the world, otherwise three translations and a
    /// ball joint.
    pub(super) fn floating(&mut self, placed: &Placed<'_>) {
        self.document(placed.joint);
        if placed.parent == GROUND && is_plainly_floating(placed.joint) {
            self.page.line(&format!("free {};", placed.child));
            let motion = free_motion(Some(&placed.joint.name), &placed.child);
            return self.declared.motions.push(motion);
        }
        let moves = self.component_names(placed, ["x", "y", "z"]);
        let ball = self.identifiers.take(&placed.joint.name, "joint", &FREE[6..]);
        let mut carrier = placed.parent.clone();
        for (index, name) in moves.iter().enumerate() {
            let frame = self.frame_name(placed, ["along_x", "along_y", "along_z"][index]);
            self.page.line(&format!("frame {frame};"));
            let mut properties = if index == 0 { placed.frame() } else { Vec::new() };
            properties
                .extend(["axis: (1, 0, 0);", "axis: (0, 1, 0);"].get(index).map(|axis| (*axis).to_owned()));
            self.page.block(&format!("prismatic {name} = {carrier} to {frame}"), &properties);
            carrier = frame;
        }
        self.page.line(&format!("ball {ball} = {carrier} to {};", placed.child));
        let orientation = ["qw", "qx", "qy", "qz"].map(|ending| format!("{ball}_{ending}"));
        self.motion(placed, [&moves[..], &orientation].concat(), 6);
    }

    /// Documents a joint whose coordinates are named after it.
    fn document(&mut self, joint: &Joint) {
        let text = format!("Joint `{}` of the file. {}", plain(&joint.name), words::limits(joint));
        self.page.comment("//", &text);
    }

    fn motion(&mut self, placed: &Placed<'_>, positions: Vec<String>, velocities: usize) {
        let joint = Some(placed.joint.name.clone());
        self.declared.motions.push(Motion { joint, positions, velocities });
    }

    fn component_names(&mut self, placed: &Placed<'_>, endings: [&str; 3]) -> [String; 3] {
        endings.map(|ending| {
            self.identifiers.take(&format!("{}_{ending}", placed.joint.name), "joint", &["dot"])
        })
    }

    fn frame_name(&mut self, placed: &Placed<'_>, ending: &str) -> String {
        self.identifiers.take(&format!("{}_{ending}", plain(&placed.joint.name)), "frame", &[])
    }
}
