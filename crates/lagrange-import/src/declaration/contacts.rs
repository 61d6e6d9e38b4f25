//! Dry friction of joints, and contacts with the ground.

use super::layout::vector;
use super::{Style, Writer};
use crate::decimal::Decimal;
use crate::mobility::Mobility;
use crate::robot::{Shape, Solid};
use crate::rotation::roll_pitch_yaw;

/// Coefficient of friction on the ground, which files do not specify.
const FRICTION: &str = "0.6";

/// A contact point, or the centre of a ball or of a rim in contact.
struct Point<'r> {
    name: String,
    link: usize,
    at: [Decimal; 3],
    radius: Option<&'r Decimal>,
    /// The axis, if it is the centre of a rim.
    axis: Option<[Decimal; 3]>,
}

impl Writer<'_> {
    /// Writes the friction of joints. The friction of a joint that mimics another one acts on the
    /// other one. With q₂ = −2 q₁, a limit f₂ on q₂ is 2 f₂ on q₁, since both dissipate f₂ |q̇₂|.
    pub(super) fn friction(&mut self) {
        let robot = self.robot;
        let mut limits = vec![None::<Decimal>; robot.joints.len()];
        for (index, joint) in robot.joints.iter().enumerate().filter(|(_, joint)| joint.kind.is_simple()) {
            let (Some(friction), following) = (&joint.friction, robot.following(index)) else { continue };
            let limit = &mut limits[following.leader];
            *limit = Some(match (limit.take(), following.factor.abs()) {
                (None, 1.0) => friction.clone(),
                (before, factor) => {
                    Decimal::rounded(before.map_or(0.0, |before| before.value()) + factor * friction.value())
                }
            });
        }
        self.page.gap();
        for (limit, coordinate) in limits.into_iter().zip(self.coordinates.clone()) {
            let (Some(limit), Some(coordinate)) = (limit.filter(|limit| !limit.is_zero()), coordinate) else {
                continue;
            };
            let name = self.identifiers.take(&format!("{coordinate}_friction"), "joint", &[]);
            self.page.line(&format!("friction {name} = dot({coordinate}), {limit};"));
            self.declared.event_count += 1;
        }
    }

    /// Writes contacts of spheres, box corners and rims of cylinders with the ground, for links
    /// that move.
    pub(super) fn contacts(&mut self, style: &Style) {
        let robot = self.robot;
        let moving = robot.links.iter().enumerate().filter(|(link, _)| !self.at_rest[*link]);
        let shapes = moving.flat_map(|(index, link)| {
            let touches = move |shape: &&Shape| match shape.solid {
                Solid::Sphere => style.has_contacts,
                Solid::Box | Solid::Cylinder => style.cornered.contains(&index),
            };
            link.collisions().filter(touches).map(move |shape| (index, shape))
        });
        let shapes = shapes.collect::<Vec<_>>();
        if shapes.is_empty() {
            return;
        }
        let points = shapes.iter().flat_map(|(link, shape)| self.points(*link, shape)).collect::<Vec<_>>();
        let mobility = Mobility::new(robot, style.is_free);
        let moves = points
            .iter()
            .map(|point| mobility.moves(point.link, &point.at, point.radius.map_or(0.0, Decimal::value)));
        let moves = moves.collect::<Vec<_>>();
        self.page.gap();
        let friction = self.identifiers.take("mu", "ground", &[]);
        if moves.contains(&[true; 2]) {
            self.page.comment("///", "Coefficient of friction on the ground; the file states none.");
            self.page.line(&format!("param {friction} >= 0 = {FRICTION};"));
        }
        for (point, [moves_up, slips]) in points.iter().zip(moves) {
            match moves_up {
                true => self.contact(point, slips.then_some(&friction)),
                false => self.declared.level.push(point.link),
            }
        }
    }

    /// Returns the centre of a sphere, the corners of a box, or the centres of the ends of a
    /// cylinder.
    fn points<'s>(&mut self, link: usize, shape: &'s Shape) -> Vec<Point<'s>> {
        let (name, radius) = (&self.links[link], shape.dimensions.first());
        let (kind, places, axis) = match shape.solid {
            Solid::Sphere => {
                let name = self.identifiers.take(&format!("{name}_touch"), "contact", &["friction"]);
                return vec![Point { name, link, at: shape.at.clone(), radius, axis: None }];
            }
            Solid::Box => ("corner", corners(shape), None),
            Solid::Cylinder => ("rim", ends(shape), Some(placed(shape, [0.0, 0.0, 1.0], 0.0))),
        };
        let radius = radius.filter(|_| axis.is_some());
        let endings = (0..places.len()).flat_map(|i| [format!("{i}"), format!("{i}_friction")]);
        let endings = endings.collect::<Vec<_>>();
        let endings = endings.iter().map(String::as_str).collect::<Vec<_>>();
        let name = self.identifiers.take(&format!("{name}_{kind}"), "contact", &endings);
        let point = |(i, at)| Point { name: format!("{name}[{i}]"), link, at, radius, axis: axis.clone() };
        places.into_iter().enumerate().map(point).collect()
    }

    fn contact(&mut self, Point { name, link, at, radius, axis }: &Point<'_>, friction: Option<&String>) {
        let size = if axis.is_some() { "rim" } else { "radius" };
        let properties = [
            friction.map(|mu| format!("friction: {mu};")),
            radius.map(|r| format!("{size}: {r};")),
            axis.as_ref().map(|axis| format!("axis: {};", vector(axis))),
        ];
        let properties = properties.into_iter().flatten().collect::<Vec<_>>();
        let head = format!("contact {name} = {}.point{} on ground", self.links[*link], vector(at));
        self.page.block(&head, &properties);
        self.declared.event_count += 1 + usize::from(friction.is_some());
    }
}

/// Returns the corners of a box in the axes of the link, with X changing fastest.
fn corners(shape: &Shape) -> Vec<[Decimal; 3]> {
    let corner = |i: usize| {
        let half = |axis: usize| 0.5 * shape.dimensions.get(axis).map_or(0.0, Decimal::value);
        placed(shape, [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -half(axis) } else { half(axis) }), 1.0)
    };
    (0..8).map(corner).collect()
}

/// Returns the centres of the ends of a cylinder in the axes of the link.
fn ends(shape: &Shape) -> Vec<[Decimal; 3]> {
    let half = 0.5 * shape.dimensions.get(1).map_or(0.0, Decimal::value);
    [-half, half].map(|along| placed(shape, [0.0, 0.0, along], 1.0)).to_vec()
}

/// Returns coordinates of a shape in the axes of the link. The share of its place is 1 for a point
/// and 0 for a direction.
fn placed(shape: &Shape, local: [f64; 3], share: f64) -> [Decimal; 3] {
    let rotation = roll_pitch_yaw(shape.turned.each_ref().map(Decimal::value));
    [0, 1, 2].map(|row| {
        let turned = (0..3).map(|axis| rotation[row][axis] * local[axis]).sum::<f64>();
        Decimal::rounded(share * shape.at[row].value() + turned)
    })
}
