//! What documentation and comments say of links and joints.

use super::layout::vector;
use crate::decimal::Decimal;
use crate::robot::{Joint, Kind, Limit, Shape};
use crate::rotation::angle;

/// Units of a coordinate, of the force on it and of its rate, where there is a single one.
fn units(kind: Kind) -> [&'static str; 3] {
    match kind {
        Kind::Revolute => [" rad", " N m", " rad/s"],
        Kind::Prismatic => [" m", " N", " m/s"],
        Kind::Planar | Kind::Floating | Kind::Fixed | Kind::Held => [""; 3],
    }
}

/// What a file says of a coordinate that has no part in the equations, as a sentence; empty if that is nothing.
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

/// Primitives as the language would write them, those that are both drawn and collided with once.
pub(super) fn shapes(shapes: &[Shape]) -> Vec<String> {
    let text = |shape: &Shape| {
        let is_zero = |triple: &[Decimal; 3]| triple.iter().all(Decimal::is_zero);
        let at = if is_zero(&shape.at) { String::new() } else { format!(" at {}", vector(&shape.at)) };
        let turned = if is_zero(&shape.turned) {
            String::new()
        } else {
            format!(" turned {}", vector(shape.turned.each_ref().map(angle)))
        };
        format!("{}{at}{turned}", shape.solid)
    };
    let of = |is_visual: bool| {
        shapes.iter().filter(move |shape| shape.is_visual == is_visual).map(text).collect::<Vec<_>>()
    };
    let (visual, collision) = (of(true), of(false));
    if visual == collision {
        return if visual.is_empty() {
            Vec::new()
        } else {
            vec![format!("Visual and collision: {}.", visual.join(", "))]
        };
    }
    let named =
        [("Visual", visual), ("Collision", collision)].into_iter().filter(|(_, list)| !list.is_empty());
    named.map(|(name, list)| format!("{name}: {}.", list.join(", "))).collect()
}
