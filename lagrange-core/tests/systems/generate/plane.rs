//! Bodies in the plane, placed by hand, with springs, dampers and pins between them.

use crate::tree::{Body, Expr, Pose, Statement, add, divide, multiply, number};

use super::quantities::Dimension;
use super::{Generator, Level};

impl Generator {
    /// Declares bodies in the plane.
    pub(super) fn plane_scene(&mut self) {
        let gravity = vec![self.signed(Dimension::GRAVITY, 1.0), self.signed(Dimension::GRAVITY, 9.8)];
        self.say(Statement::Gravity(gravity));
        let count = 1 + self.random.below(3);
        let bodies = (0..count).map(|_| self.plane_body()).collect::<Vec<_>>();
        for _ in 0..self.random.below(4) {
            self.connector(&bodies, 2);
        }
        if count > 1 && self.chance(2) {
            let name = self.fresh("pin");
            let from = self.place(&bodies[..1], 2);
            let to = self.place(&bodies[1..], 2);
            self.say(Statement::Pin { name, from, to });
        }
        if self.chance(2) {
            let body = self.random.choice(&bodies).clone();
            let force = (0..2).map(|_| self.scalar(Dimension::FORCE, Level::Force)).collect();
            let point = self.own_point(&body, 2);
            self.say(Statement::ForceAt(Expr::Vector(force), point));
        }
    }

    fn plane_body(&mut self) -> String {
        let [x, y] = [0, 1].map(|_| self.coordinate("x", Dimension::LENGTH));
        let a = self.coordinate("a", Dimension::NONE);
        let shift = divide(a.clone(), number("3"));
        let size = self.quantity(Dimension::LENGTH, 0.2, 0.5);
        let place = match self.random.below(3) {
            0 => vec![add(x, multiply(size, shift)), y],
            _ => vec![x, y],
        };
        let name = self.fresh("body");
        let body = Body {
            name: name.clone(),
            mass: self.parameter(Dimension::MASS, 0.5, 2.0),
            centroid: self.chance(2).then(|| self.vector(2, 0.5)),
            inertia: vec![self.parameter(Dimension::INERTIA, 0.3, 1.0)],
            pose: Some(Pose { is_center: self.chance(2), place, angles: vec![a], sequence: String::new() }),
        };
        self.say(Statement::Body(body));
        name
    }

    /// Returns a fixed vector.
    pub(super) fn vector(&mut self, dimension: usize, size: f64) -> Vec<Expr> {
        (0..dimension)
            .map(|_| if self.chance(4) { number("0") } else { self.signed(Dimension::LENGTH, size) })
            .collect()
    }

    pub(super) fn own_point(&mut self, body: &str, dimension: usize) -> Expr {
        match self.random.below(3) {
            0 => Expr::Center(body.to_owned()),
            _ => Expr::Point(body.to_owned(), self.vector(dimension, 1.0)),
        }
    }

    /// Returns a point of a body or of the ground.
    pub(super) fn place(&mut self, bodies: &[String], dimension: usize) -> Expr {
        let body = self.random.choice(bodies).clone();
        self.own_point(&body, dimension)
    }

    /// Returns a spring or a damper.
    pub(super) fn connector(&mut self, bodies: &[String], dimension: usize) {
        let from = match self.random.below(2) {
            0 => Expr::Vector(self.vector(dimension, 2.0)),
            _ => self.place(bodies, dimension),
        };
        let to = self.place(bodies, dimension);
        let stiffness = Dimension::FORCE.over(Dimension::LENGTH);
        if self.chance(2) {
            let damping = self.parameter(stiffness.times(Dimension::TIME), 0.1, 1.0);
            self.say(Statement::Damper { from, to, damping });
        } else {
            let stiffness = self.parameter(stiffness, 1.0, 5.0);
            let rest = self.chance(2).then(|| self.quantity(Dimension::LENGTH, 0.5, 1.0));
            self.say(Statement::Spring { from, to, stiffness, rest });
        }
    }
}
