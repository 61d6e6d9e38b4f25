//! Items to draw in space, from their numbers.

use lagrange_core::bodies::{DrawnKind, SpatialJointForm};
use lagrange_core::pipeline::{PlacedItem, PlacedPart};
use lagrange_core::syntax::ast::{ConnectorKind, MobilizerKind};
use lagrange_runtime::body::SpatialMotion;
use lagrange_runtime::scene::{Connector, Frame, Item, Part, Solid, Spatial, SpatialJoint, SpatialJointKind};

/// Numbers that are taken one after another; NaN beyond the last.
pub(crate) struct Numbers<'a>(pub(crate) &'a [f64]);

impl Numbers<'_> {
    fn take<const COUNT: usize>(&mut self) -> [f64; COUNT] {
        std::array::from_fn(|_| match self.0.split_first() {
            Some((first, rest)) => {
                self.0 = rest;
                *first
            }
            None => f64::NAN,
        })
    }

    fn rows(&mut self) -> [[f64; 3]; 3] {
        std::array::from_fn(|_| self.take())
    }

    fn part<'p>(&mut self, part: &PlacedPart) -> Part<'p, f64, Spatial> {
        let shape = match part.variant {
            "SlenderRod" => Solid::SlenderRod(self.one()),
            "Sphere" => Solid::Sphere(self.one()),
            "Ellipsoid" => Solid::Ellipsoid(self.one(), self.one(), self.one()),
            "Cuboid" => Solid::Cuboid(self.one(), self.one(), self.one()),
            "Disk" => Solid::Disk(self.one()),
            "Ring" => Solid::Ring(self.one()),
            "Cylinder" => Solid::Cylinder(self.one(), self.one()),
            "HollowCylinder" => Solid::HollowCylinder(self.one(), self.one(), self.one()),
            "Cone" => Solid::Cone(self.one(), self.one()),
            _ => Solid::PointMass,
        };
        Part { shape, at: self.take(), rotation: self.rows(), is_hole: part.is_hole }
    }

    fn one(&mut self) -> f64 {
        let [value] = self.take();
        value
    }

    /// Hands out an item.
    pub(crate) fn item(&mut self, item: &PlacedItem, visit: &mut dyn FnMut(Item<'_, f64, Spatial>)) {
        match &item.kind {
            DrawnKind::Body { .. } => {
                let motion = self.motion();
                let parts = item.parts.iter().map(|part| self.part(part)).collect::<Vec<_>>();
                visit(Item::Body { name: &item.body, motion, parts: &parts });
            }
            DrawnKind::Frame { name } => {
                visit(Item::Frame(Frame { name, rotation: self.rows(), origin: self.take() }));
            }
            DrawnKind::Connector { name, kind } => {
                let (from, to, tension) = (self.take(), self.take(), self.one());
                visit(Item::Connector { name, kind: connector(*kind), from, to, tension });
            }
            DrawnKind::SpatialJoint { name, kind, links } => {
                let (at, axis) = (self.take(), self.take());
                let kind =
                    SpatialJoint { kind: joint(*kind), axis, bodies: links.each_ref().map(Option::as_deref) };
                visit(Item::Joint { name, kind, at });
            }
            // Of the plane, or loads, which are not drawn.
            _ => {}
        }
    }

    /// A body with what a picture takes of its motion.
    fn motion(&mut self) -> SpatialMotion<f64> {
        let (centroid, center, rotation) = (self.take(), self.take(), self.rows());
        let none = [0.0; 3];
        SpatialMotion {
            mass: 0.0,
            inertia: [none; 3],
            centroid,
            center,
            rotation,
            velocity: none,
            angular_velocity: none,
            acceleration: none,
            angular_acceleration: none,
        }
    }
}

pub(crate) fn connector(kind: ConnectorKind) -> Connector {
    match kind {
        ConnectorKind::Spring => Connector::Spring,
        ConnectorKind::Damper => Connector::Damper,
        ConnectorKind::TorsionSpring => Connector::TorsionSpring,
        ConnectorKind::TorsionDamper => Connector::TorsionDamper,
    }
}

fn joint(form: SpatialJointForm) -> SpatialJointKind {
    match form {
        SpatialJointForm::Pin => SpatialJointKind::Pin,
        SpatialJointForm::Mobilizer(kind) => match kind {
            MobilizerKind::Revolute => SpatialJointKind::Revolute,
            MobilizerKind::Prismatic => SpatialJointKind::Prismatic,
            MobilizerKind::Cylindrical => SpatialJointKind::Cylindrical,
            MobilizerKind::Screw => SpatialJointKind::Screw,
            MobilizerKind::Universal => SpatialJointKind::Universal,
            MobilizerKind::Planar => SpatialJointKind::Planar,
            MobilizerKind::Ball => SpatialJointKind::Ball,
            MobilizerKind::Free => SpatialJointKind::Free,
            MobilizerKind::Weld => SpatialJointKind::Weld,
        },
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use lagrange_core::derive::StrategyChoice;
    use lagrange_core::pipeline::{NumericSystem, Programs, parse};
    use lagrange_runtime::scene::{Item, Solid};

    use super::Numbers;

    /// Every shape in space, with the solid that draws it.
    const SHAPES: [(&str, Solid<f64>); 11] = [
        ("point_mass()", Solid::PointMass),
        ("slender_rod(2)", Solid::SlenderRod(2.0)),
        ("solid_sphere(2)", Solid::Sphere(2.0)),
        ("thin_sphere(2)", Solid::Sphere(2.0)),
        ("ellipsoid(2, 3, 4)", Solid::Ellipsoid(2.0, 3.0, 4.0)),
        ("cuboid(2, 3, 4)", Solid::Cuboid(2.0, 3.0, 4.0)),
        ("disk(2)", Solid::Disk(2.0)),
        ("thin_ring(2)", Solid::Ring(2.0)),
        ("solid_cylinder(2, 3)", Solid::Cylinder(2.0, 3.0)),
        ("hollow_cylinder(2, 3, 4)", Solid::HollowCylinder(2.0, 3.0, 4.0)),
        ("cone(2, 3)", Solid::Cone(2.0, 3.0)),
    ];

    #[test]
    fn every_solid_takes_its_own_numbers() {
        for (shape, wanted) in SHAPES {
            let text = format!(
                "gravity = (0, 0, -1); body b {{ mass: 1; shape: {shape}; }} prismatic s = ground to b; emit {{ drawing }}"
            );
            let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
            let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{shape}: {report}")));
            let drawing = programs.drawing.clone().expect("a body is drawn");
            let system = NumericSystem::of(Arc::new(programs));
            let at = system.evaluate(&drawing.program, 0.0, &[0.5], &[0.0]);
            let (mut numbers, mut found) = (Numbers(&at), Vec::new());
            for item in &drawing.items {
                numbers.item(item, &mut |item| {
                    if let Item::Body { parts, .. } = item {
                        found.extend(parts.iter().map(|part| part.shape));
                    }
                });
            }
            assert!(numbers.0.is_empty() && found == [wanted], "{shape}: {found:?} and {:?}", numbers.0);
        }
    }
}
