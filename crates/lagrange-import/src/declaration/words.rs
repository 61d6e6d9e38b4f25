//! Documentation and comments about links and joints.

use super::layout::vector;
use crate::decimal::Decimal;
use crate::robot::{Joint, Kind, Limit, Shape, Solid};
use crate::rotation::angle;

/// Returns the units of a coordinate, of the force on it and of its rate; empty for several
/// coordinates.
fn units(kind: Kind) -> [&'static str; 3] {
    match kind {
        Kind::Revolute => [" rad", " N m", " rad/s"],
        Kind::Prismatic => [" m", " N", " m/s"],
        Kind::Planar | Kind::Floating | Kind::Fixed | Kind::Held => [""; 3],
    }
}

/// Returns a sentence about limits in the file that do not affect the equations; empty if there are
/// none.
pub(super) fn limits(joint: &Joint) -> String {
    let Limit { lower, upper, effort, velocity } = &joint.limit;
    let [unit, force, rate] = units(joint.kind);
    let range = match (lower, upper) {
        (Some(lower), Some(upper)) => Some(format!("from {lower} to {upper}{unit}")),
        (Some(lower), None) => Some(format!("from {lower}{unit}")),
        (None, Some(upper)) => Some(format!("to {upper}{unit}")),
        (None, None) => None,
    };
    let measured = |value: &Option<Decimal>, unit: &str| value.as_ref().map(|value| format!("{value}{unit}"));
    let most = [measured(effort, force), measured(velocity, rate)].into_iter().flatten().collect::<Vec<_>>();
    let most = (!most.is_empty()).then(|| format!("at most {}", most.join(" and ")));
    let friction = measured(&joint.friction, force).map(|friction| format!("dry friction of {friction}"));
    sentence(&[range, most, friction].into_iter().flatten().collect::<Vec<_>>().join("; "))
}

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| format!("{}{}.", first.to_uppercase(), letters.as_str()))
}

/// Returns the visual of a link as a property of its body.
pub(super) fn visual(shapes: &[Shape]) -> Option<String> {
    let visuals = shapes.iter().filter(|shape| shape.is_visual);
    let parts =
        visuals.map(|shape| format!("{};", placed(shape, [", at: ", ", turned: "]))).collect::<Vec<_>>();
    (!parts.is_empty()).then(|| format!("visual {{ {} }}", parts.join(" ")))
}

/// Returns comments about primitives that do not become part of the declaration: collision shapes
/// and, without a body, visual shapes.
pub(super) fn shapes(shapes: &[Shape], has_body: bool) -> Vec<String> {
    let of = |is_visual: bool| {
        let shapes = shapes.iter().filter(move |shape| shape.is_visual == is_visual);
        shapes.map(|shape| placed(shape, [" at ", " turned "])).collect::<Vec<_>>()
    };
    let (visual, collision) = (of(true), of(false));
    if visual == collision {
        return match visual.is_empty() {
            true => Vec::new(),
            false if has_body => vec!["Collides as it is seen.".to_owned()],
            false => vec![format!("Visual and collision: {}.", visual.join(", "))],
        };
    }
    let named = [("Visual", if has_body { Vec::new() } else { visual }), ("Collision", collision)];
    let named = named.into_iter().filter(|(_, list)| !list.is_empty());
    named.map(|(name, list)| format!("{name}: {}.", list.join(", "))).collect()
}

/// Returns a primitive with its place. Position and orientation follow these words and are omitted
/// if zero.
fn placed(shape: &Shape, [at, turned]: [&str; 2]) -> String {
    let given = |word: &str, triple: &[Decimal; 3], text: String| match triple.iter().all(Decimal::is_zero) {
        true => String::new(),
        false => format!("{word}{text}"),
    };
    let at = given(at, &shape.at, vector(&shape.at));
    let turned = given(turned, &shape.turned, vector(shape.turned.each_ref().map(angle)));
    let solid = match shape.solid {
        Solid::Box => "cuboid",
        Solid::Cylinder => "solid_cylinder",
        Solid::Sphere => "solid_sphere",
    };
    format!("{solid}{}{at}{turned}", vector(&shape.dimensions))
}
