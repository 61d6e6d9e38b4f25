//! Coordinates at fixed values.

use crate::model::{Model, Pinned};
use lagrange_algebra::calculus::Expansion;
use lagrange_expr::expr::ExprId;

/// Replaces coordinates by their fixed values, at rest.
pub(super) fn holding(model: &Model, all: &[Pinned], zero: ExprId) -> Expansion {
    let mut held = Expansion::default();
    for pinned in all {
        held.hold(model.coordinates[pinned.coordinate].position, pinned.value);
        for speed in model.speeds.iter().filter(|speed| speed.coordinate == Some(pinned.coordinate)) {
            held.hold(speed.velocity, zero);
            held.hold(speed.acceleration, zero);
        }
    }
    held
}
