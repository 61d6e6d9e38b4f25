//! Trees of bodies in space, with springs, dampers, pins and loads.

use crate::tree::{Body, Expr, Joint, Pose, Statement, number};

use super::quantities::Dimension;
use super::{Generator, Level};

/// Joints with their relative frequencies and the number of their coordinates.
const KINDS: [(&str, usize); 12] = [
    ("revolute", 1),
    ("revolute", 1),
    ("revolute", 1),
    ("prismatic", 1),
    ("prismatic", 1),
    ("screw", 1),
    ("cylindrical", 2),
    ("universal", 2),
    ("planar", 3),
    ("ball", 3),
    ("ball", 3),
    ("weld", 0),
];
/// Number of velocities above which no joint is added.
const ENOUGH: usize = 5;
/// Degrees of freedom from which on a joint leaves some to a pin.
const LOOSE: usize = 4;
const QUARTERS: [&str; 4] = ["0", "1.5707963267948966", "-1.5707963267948966", "3.141592653589793"];

impl Generator {
    /// Declares bodies in space.
    pub(super) fn space_scene(&mut self) {
        // Labels of bodies take plain numbers in SI units.
        self.with_units = false;
        let gravity = (0..3).map(|_| self.signed(Dimension::GRAVITY, 6.0)).collect();
        self.say(Statement::Gravity(gravity));
        let (mut links, mut velocities, mut freedoms) = (Vec::new(), 0, Vec::new());
        let count = 1 + self.random.below(4);
        while links.len() < count && velocities < ENOUGH || velocities == 0 {
            let added = self.link(&mut links);
            velocities += added;
            freedoms.push(added);
        }
        for _ in 0..self.random.below(3) {
            self.connector(&links, 3);
        }
        if velocities > 4 && self.chance(4) {
            let name = self.fresh("pin");
            let from = self.place(&links, 3);
            let to = Expr::Vector(self.vector(3, 2.0));
            // Other bodies would be overconstrained.
            let held = links.iter().position(|link| from.to_string().starts_with(&format!("{link}.")));
            if held.is_some_and(|held| freedoms[held] >= LOOSE) {
                self.say(Statement::Pin { name, from, to });
            }
        }
        for _ in 0..self.random.below(3) {
            self.space_load(&links);
        }
        if self.chance(2) {
            let body = self.random.choice(&links).clone();
            let point = self.own_point(&body, 3);
            let value = match self.random.below(3) {
                0 => crate::tree::rate(point),
                1 => crate::tree::rate(crate::tree::rate(point)),
                _ => Expr::Spin(body),
            };
            let output = self.fresh("out");
            self.say(Statement::Output(output, value));
        }
    }

    fn space_load(&mut self, links: &[String]) {
        let body = self.random.choice(links).clone();
        let own = (0..3).map(|_| self.scalar(Dimension::FORCE, Level::Force)).collect::<Vec<_>>();
        if self.chance(2) {
            let direction =
                if self.chance(2) { Expr::Vector(own) } else { Expr::Direction(body.clone(), own) };
            let point = self.own_point(&body, 3);
            self.say(Statement::ForceAt(direction, point));
        } else {
            self.say(Statement::TorqueOn(Expr::Vector(own), body));
        }
    }

    /// Declares a body with the joint that carries it, and returns the number of its velocities.
    fn link(&mut self, links: &mut Vec<String>) -> usize {
        let name = self.fresh("body");
        let by_hand = self.chance(8);
        let pose = by_hand.then(|| self.pose());
        let body = Body {
            name: name.clone(),
            mass: self.parameter(Dimension::MASS, 0.5, 2.0),
            centroid: self.chance(2).then(|| self.vector(3, 0.5)),
            inertia: self.tensor(),
            pose: pose.as_ref().map(|(pose, _)| pose.clone()),
        };
        self.say(Statement::Body(body));
        let velocities = match pose {
            Some((_, velocities)) => velocities,
            None if self.chance(8) => {
                self.say(Statement::Free(name.clone()));
                6
            }
            None => self.joint(links, &name),
        };
        links.push(name);
        velocities
    }

    /// Returns moments and products of inertia that a real body can have.
    fn tensor(&mut self) -> Vec<Expr> {
        let count = if self.chance(2) { 3 } else { 6 };
        let entry = |k: usize| {
            if k < 3 {
                self.parameter(Dimension::INERTIA, 0.4, 0.6)
            } else {
                self.signed(Dimension::INERTIA, 0.05)
            }
        };
        (0..count).map(entry).collect()
    }

    /// Declares a pose by coordinates of its own.
    fn pose(&mut self) -> (Pose, usize) {
        let place = (0..3).map(|_| self.coordinate("x", Dimension::LENGTH)).collect();
        let angles = (0..3).map(|_| self.coordinate("a", Dimension::NONE)).collect();
        let sequence = (*self.random.choice(&["zxz", "xyz", "zyx", "yxy", "xzy"])).to_owned();
        (Pose { is_center: self.chance(2), place, angles, sequence }, 6)
    }

    fn joint(&mut self, links: &[String], to: &str) -> usize {
        let (kind, count) = *self.random.choice(&KINDS);
        let kind_names = if kind == "ball" { 1 } else { count };
        let names = (0..kind_names).map(|_| self.fresh("j")).collect::<Vec<_>>();
        let from = (!links.is_empty() && !self.chance(5)).then(|| self.random.choice(links).clone());
        let at = self.chance(2).then(|| self.vector(3, 1.0));
        let turned = self.chance(2).then(|| self.angles());
        let has_axis = !matches!(kind, "universal" | "planar" | "ball" | "weld");
        let axis = (has_axis && self.chance(2)).then(|| self.direction());
        let pitch = (kind == "screw").then(|| self.quantity(Dimension::LENGTH, 0.2, 2.0));
        let is_damped = matches!(kind, "revolute" | "prismatic" | "screw" | "ball") && self.chance(4);
        let damping = is_damped.then(|| self.quantity(Dimension::NONE, 0.1, 1.0));
        let to = to.to_owned();
        for (k, name) in names.iter().enumerate().filter(|_| kind != "ball") {
            let is_length =
                kind == "prismatic" || kind == "cylindrical" && k == 1 || kind == "planar" && k < 2;
            let dimension = if is_length { Dimension::LENGTH } else { Dimension::NONE };
            // Loads, which come after all joints, may use the coordinate.
            self.remember_coordinate(&Expr::Name(name.clone()), dimension);
        }
        self.say(Statement::Joint(Joint { kind, names, from, to, at, turned, axis, pitch, damping }));
        count
    }

    /// Returns angles, mostly quarter turns.
    fn angles(&mut self) -> Vec<Expr> {
        (0..3)
            .map(|_| {
                if self.chance(3) {
                    self.signed(Dimension::NONE, 1.5)
                } else {
                    number(QUARTERS[self.random.below(4)])
                }
            })
            .collect()
    }

    /// Returns an axis of a frame, or any direction.
    fn direction(&mut self) -> Vec<Expr> {
        let first = self.random.below(3);
        let is_along = self.chance(2);
        (0..3)
            .map(|k| match (k == first, is_along) {
                (true, _) => number(["1", "-1", "2"][self.random.below(3)]),
                (false, true) => number("0"),
                (false, false) => self.signed(Dimension::NONE, 1.0),
            })
            .collect()
    }
}
