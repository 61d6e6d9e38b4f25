//! Conversion of scenes to elements: the marks and labels of each item.

use crate::anchored::Anchored;
use crate::colour::{self, ACCELERATION, CENTER, FORCE, INK, PALE, REST, VELOCITY};
use crate::element::{Element, Layer, Measure, Shape};
use crate::geometry::{add, direction, dot, length, subtract, times, turned};
use crate::load::{Load, Value};
use crate::load_label::load_label;
use crate::look::Wanted;
use crate::parallel::Lanes;
use crate::picture::{Colour, Point};
use crate::plane::Body;
use crate::remainder::{MOMENT, REMAINDER, Remainder};
use crate::snapshot::{Cone, Form, Snapshot, Span, Support};
use crate::stretch::{self, Stretches};
use lagrange_plot::notation::{formula, symbol};
use lagrange_runtime::scene::{Connector, Joint, LoadOrigin};

/// The data that remain constant throughout a film.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Fixed {
    pub(super) stretches: Stretches,
    pub(super) anchored: Anchored,
    pub(super) lanes: Lanes,
}

/// Length of the axes of a body in pixels.
const AXIS: f64 = 42.0;
/// Fraction of a film's fastest rotation below which a body has no drawable centre of rotation.
const TURNING: f64 = 1e-9;

/// Returns all elements of a scene.
pub(super) fn elements(snapshot: &Snapshot, wanted: Wanted, fixed: &Fixed, fastest: f64) -> Vec<Element> {
    let mut elements = surfaces(snapshot, &fixed.stretches);
    elements.extend(walls(snapshot, &fixed.anchored));
    for body in &snapshot.bodies {
        let label = if wanted.names && !wanted.is_free { formula(&body.name) } else { String::new() };
        let shape =
            Shape::Body { place: body.place(), center: body.motion.center, pieces: body.pieces.clone() };
        elements.push(element(&body.name, label, colour::body(body.index), Layer::Body, shape));
    }
    elements.extend(snapshot.connectors.iter().map(|Span { name, kind, ends }| {
        let lane = fixed.lanes.get(name).copied().unwrap_or_default();
        connector(name, *kind, *ends, lane, wanted)
    }));
    if !wanted.is_free {
        elements.extend(snapshot.joints.iter().map(|held| joint(&held.name, held.kind, held.at)));
    }
    for body in &snapshot.bodies {
        elements.extend(kinematics(body, wanted, snapshot.bodies.len() > 1, fastest));
    }
    if wanted.forces {
        elements.extend(snapshot.cones.iter().filter_map(|one| cone(one, snapshot, wanted.is_free)));
        elements.extend(snapshot.loads.iter().enumerate().map(|(index, item)| {
            let before = &snapshot.loads[..index];
            load(item, before, snapshot, wanted.is_free)
        }));
        elements.extend(snapshot.remainder.iter().flat_map(|rest| remainder(rest, snapshot)));
    }
    elements
}

fn element(name: &str, label: String, colour: Colour, layer: Layer, shape: Shape) -> Element {
    Element { name: name.to_owned(), label, colour, layer, shape }
}

fn surfaces(snapshot: &Snapshot, stretches: &Stretches) -> Vec<Element> {
    let of = |support: &Support| {
        let stretches = stretches.get(&support.name).cloned().unwrap_or_default();
        let pieces = stretch::curve(support, &stretches);
        let seen = stretch::seen(support, snapshot, &stretches, &pieces);
        let shape = match support.form {
            Form::Flat => Shape::Ground { place: support.place(), stretches, seen },
            _ => Shape::Curve { pieces, seen },
        };
        element(&support.name, String::new(), INK, Layer::Ground, shape)
    };
    snapshot.supports.iter().map(of).collect()
}

/// Returns the walls that hold connectors.
fn walls(snapshot: &Snapshot, anchored: &Anchored) -> Vec<Element> {
    let ends = snapshot.connectors.iter().flat_map(|Span { name, ends, .. }| {
        let walls =
            ends.iter().enumerate().map(move |(end, at)| (name, *at, anchored.get(&(name.clone(), end))));
        walls.filter_map(|(name, at, angle)| Some((name, at, *angle?)))
    });
    let wall = |(name, at, angle): (&String, Point, f64)| {
        element(name, String::new(), INK, Layer::Ground, Shape::Wall { at, angle })
    };
    ends.map(wall).collect()
}

fn connector(name: &str, kind: Connector, ends: [Point; 2], lane: f64, wanted: Wanted) -> Element {
    let shape = Shape::Connector { kind, ends, lane };
    let label = if wanted.names && !is_made_up(name, kind) { formula(name) } else { String::new() };
    element(name, label, INK, Layer::Connector, shape)
}

/// True if a connector was declared without a name. Its name then consists of its kind and a
/// number.
pub fn is_made_up(name: &str, kind: Connector) -> bool {
    let kind = match kind {
        Connector::Spring => "spring_",
        Connector::Damper => "damper_",
        Connector::TorsionSpring => "torsion_spring_",
        Connector::TorsionDamper => "torsion_damper_",
    };
    name.strip_prefix(kind).is_some_and(|number| number.bytes().all(|digit| digit.is_ascii_digit()))
}

fn joint(name: &str, kind: Joint, at: Point) -> Element {
    let shape = match kind {
        Joint::Pin => Shape::Pin { at },
        Joint::Anchor => Shape::Anchor { at },
        Joint::Slide => Shape::Slider { at },
        Joint::Roll => Shape::Dot { at },
    };
    element(name, String::new(), INK, Layer::Joint, shape)
}

fn kinematics(body: &Body, wanted: Wanted, has_others: bool, fastest: f64) -> Vec<Element> {
    let motion = &body.motion;
    let mut elements = Vec::new();
    let mut arrow = |letter, colour, from, vector, measure| {
        let shape = Shape::Arrow { from, vector, measure, is_push: false };
        elements.push(element(
            &body.name,
            symbol(letter, &body.name, has_others),
            colour,
            Layer::Arrow,
            shape,
        ));
    };
    if wanted.frames {
        let place = body.place();
        for (letter, axis) in [("X", direction(place.angle)), ("Y", turned(direction(place.angle)))] {
            arrow(letter, PALE, place.at, times(AXIS, axis), Measure::Pixels);
        }
    }
    if wanted.velocities {
        arrow("v", VELOCITY, motion.center, motion.velocity, Measure::Velocity);
    }
    if wanted.accelerations {
        arrow("a", ACCELERATION, motion.center, motion.acceleration, Measure::Acceleration);
    }
    // Non-finite values are passed on and rejected later.
    let is_translating = motion.angular_velocity.abs() <= TURNING * fastest;
    if wanted.centers && !is_translating {
        // r_M = r_S + e_z × v_S/ω.
        let to = add(motion.center, times(1.0 / motion.angular_velocity, turned(motion.velocity)));
        let shape = Shape::Ray { from: motion.center, to };
        elements.push(element(&body.name, symbol("M", &body.name, has_others), CENTER, Layer::Arrow, shape));
    }
    elements
}

/// Returns the element of a force or moment after the loads `before`.
fn load(load: &Load, before: &[Load], snapshot: &Snapshot, is_free: bool) -> Element {
    let body = load.body.as_deref().and_then(|name| snapshot.body(name));
    let shape = match load.value {
        Value::Force(vector) => {
            let is_push = is_free && pushes(load, vector, body.map(|body| body.motion.center));
            Shape::Arrow { from: load.at, vector, measure: Measure::Force, is_push }
        }
        // A moment acts on the whole body, whatever its source.
        Value::Moment(moment) => {
            let at = body.map_or(load.at, |body| body.motion.center);
            Shape::Turn { at, moment, ring: moments(before, load.body.as_deref()) }
        }
    };
    element(&load.name, load_label(load, snapshot), FORCE, Layer::Arrow, shape)
}

/// Returns the friction cone of a contact that presses, on the side of the arrow of its force.
fn cone(cone: &Cone, snapshot: &Snapshot, is_free: bool) -> Option<Element> {
    let &Cone { at, normal, coefficient, .. } = cone;
    let body = cone.body.as_deref().and_then(|name| snapshot.body(name));
    let is_push = is_free && points_into(normal, at, body.map(|body| body.motion.center));
    let shape = Shape::Cone { at, normal: times(if is_push { -1.0 } else { 1.0 }, normal), coefficient };
    (length(normal) != 0.0).then(|| element(&cone.name, String::new(), FORCE, Layer::Arrow, shape))
}

/// Counts the moments on a body.
fn moments(loads: &[Load], body: Option<&str>) -> usize {
    loads.iter().filter(|load| load.is_moment() && load.body.as_deref() == body).count()
}

/// Returns the elements for the resultant of unnamed loads on a free body.
fn remainder(rest: &Remainder, snapshot: &Snapshot) -> Vec<Element> {
    let Remainder { at, force, moment } = *rest;
    let arrow = Shape::Arrow { from: at, vector: force, measure: Measure::Force, is_push: false };
    let turn =
        Shape::Turn { at, moment, ring: snapshot.loads.iter().filter(|load| load.is_moment()).count() };
    let of = |name: &str, shape| {
        let label = snapshot.letter(name).unwrap_or(name).to_owned();
        element(REMAINDER, label, REST, Layer::Arrow, shape)
    };
    vec![of(REMAINDER, arrow), of(MOMENT, turn)]
}

/// True if a contact or joint force points into the body. On a free body it is then drawn from
/// outside.
fn pushes(load: &Load, force: Point, center: Option<Point>) -> bool {
    let is_contact = matches!(load.cause, LoadOrigin::Joint | LoadOrigin::Contact);
    is_contact && points_into(force, load.at, center)
}

/// True if a force at a place points to the middle of a body.
fn points_into(force: Point, at: Point, center: Option<Point>) -> bool {
    const NARROW: f64 = 0.5;
    let inwards = center.map_or([0.0, 0.0], |center| subtract(center, at));
    dot(force, inwards) > NARROW * length(force) * length(inwards)
}

/// Returns the path of a point up to its current position, and a mark there.
pub(super) fn trace(label: &str, points: &[Point], colour: Colour) -> Vec<Element> {
    let path = Shape::Polyline { points: points.to_vec() };
    let mut elements = vec![element(label, String::new(), colour, Layer::Trace, path)];
    if let Some(at) = points.last() {
        elements.push(element(label, formula(label), colour, Layer::Trace, Shape::Dot { at: *at }));
    }
    elements
}
