//! A walking machine with four legs, moved by formulas: thirteen bodies and twelve joints.

use lagrange_runtime::scene::{Item, Part, Scene, Solid, Spatial, SpatialJoint, SpatialJointKind};
use lagrange_runtime::system::{MechanicalSystem, OdeSystem, Unnamed};

use super::{UPRIGHT, motion};
use crate::geometry::add;
use crate::space::vector::{Rotation, Vector, apply};

pub(super) struct Walker;

type Visit<'v> = dyn FnMut(Item<'_, f64, Spatial>) + 'v;

impl OdeSystem for Walker {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [_, rate]: &[f64; 2]) -> [f64; 2] {
        [*rate, 0.0]
    }
}

impl MechanicalSystem for Walker {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x"];

    fn acceleration(&self, _t: f64, _q: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }
}

pub(super) const LEGS: [(&str, f64, f64); 4] = [
    ("front_left", 0.25, 0.14),
    ("front_right", 0.25, -0.14),
    ("rear_left", -0.25, 0.14),
    ("rear_right", -0.25, -0.14),
];
const THIGH: f64 = 0.28;
const SHANK: f64 = 0.27;

/// Returns a rotation about y, from z towards x.
fn about_y(angle: f64) -> Rotation {
    let (sin, cos) = angle.sin_cos();
    [[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]]
}

/// Returns hip, knee and foot of a leg, and the rotations of thigh and shank.
pub(super) fn leg(leg: usize, x: f64) -> ([Vector; 3], [Rotation; 2]) {
    let (_, ahead, aside) = LEGS[leg];
    let phase = 9.0 * x + if leg == 0 || leg == 3 { 0.0 } else { std::f64::consts::PI };
    let thigh = about_y(0.5 + 0.35 * phase.sin());
    let shank = about_y(-0.6 + 0.35 * (phase - 1.2).sin());
    let hip = add(trunk(x), [ahead, aside, 0.0]);
    let knee = add(hip, apply(&thigh, [0.0, 0.0, -THIGH]));
    ([hip, knee, add(knee, apply(&shank, [0.0, 0.0, -SHANK]))], [thigh, shank])
}

fn trunk(x: f64) -> Vector {
    [x, 0.05 * (4.0 * x).sin(), 0.5 + 0.01 * (18.0 * x).sin()]
}

impl Scene for Walker {
    type Space = Spatial;

    fn items(
        &self,
        _t: f64,
        [x]: &[f64; 1],
        [rate]: &[f64; 1],
        visit: &mut dyn FnMut(Item<'_, f64, Spatial>),
    ) {
        let rate = *rate;
        let body = |name: &str, rotation, center, (shape, at), visit: &mut Visit<'_>| {
            let motion = motion(rotation, center, [rate, 0.0, 0.0]);
            let parts = &[Part { shape, at, rotation: UPRIGHT, is_hole: false }];
            visit(Item::Body { name, motion, parts });
        };
        body("trunk", UPRIGHT, trunk(*x), (Solid::Cuboid(0.6, 0.2, 0.14), [0.0; 3]), visit);
        for (index, (name, ..)) in LEGS.iter().enumerate() {
            let ([hip, knee, _], [thigh, shank]) = leg(index, *x);
            body(&format!("{name}_hip"), UPRIGHT, hip, (Solid::Sphere(0.05), [0.0; 3]), visit);
            let cuboid = (Solid::Cuboid(0.05, 0.04, THIGH), [0.0, 0.0, -0.5 * THIGH]);
            body(&format!("{name}_thigh"), thigh, hip, cuboid, visit);
            let rod = (Solid::Cylinder(0.018, SHANK), [0.0, 0.0, -0.5 * SHANK]);
            body(&format!("{name}_shank"), shank, knee, rod, visit);
            let pins = [
                ("roll", hip, [1.0, 0.0, 0.0]),
                ("pitch", hip, [0.0, 1.0, 0.0]),
                ("knee", knee, [0.0, 1.0, 0.0]),
            ];
            for (joint, at, axis) in pins {
                let name = format!("{name}_{joint}");
                let kind = SpatialJoint { kind: SpatialJointKind::Revolute, axis, bodies: [None, None] };
                visit(Item::Joint { name: &name, kind, at });
            }
        }
    }
}
