//! Detection of ends of springs and dampers that are fixed to the ground.
//!
//! A scene specifies the ends of each connector and the bodies it acts on. An end on no body counts
//! as fixed if it never moves, neither during the film nor in a different configuration at a
//! different time. It then needs a support, unless a line or a joint is already drawn there.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

use crate::geometry::{add, length, subtract, unit};
use crate::picture::Point;
use crate::snapshot::{Form, Snapshot, Span};
use crate::stretch::coordinates;
use lagrange_runtime::scene::{Connector, LoadOrigin};

/// Angles of the short walls at the ends of connectors, by name and end index. The connector is on
/// the left of its wall.
pub(super) type Anchored = BTreeMap<(String, usize), f64>;

/// Distance, relative to the length of a connector, below which points coincide.
const TOUCHING: f64 = 1e-6;

/// Returns the fixed ends throughout a film; `elsewhere` is the scene in a different configuration.
pub(super) fn anchored(film: &[Snapshot], elsewhere: &Snapshot) -> Anchored {
    let mut anchored = Anchored::new();
    for Span { name, kind, ends } in film.first().into_iter().flat_map(|snapshot| &snapshot.connectors) {
        if !matches!(kind, Connector::Spring | Connector::Damper) {
            continue;
        }
        for (end, at) in ends.iter().enumerate() {
            let is_free = is_at_rest(name, end, *at, film, elsewhere)
                && !is_on_body(name, end, film, elsewhere)
                && !film.iter().any(|snapshot| is_held(*at, ends, snapshot));
            if let (true, Some(angle)) = (is_free, wall(name, end, film)) {
                anchored.insert((name.clone(), end), angle);
            }
        }
    }
    anchored
}

fn is_at_rest(name: &str, end: usize, at: Point, film: &[Snapshot], elsewhere: &Snapshot) -> bool {
    film.iter().chain([elsewhere]).all(|snapshot| snapshot.ends(name).is_some_and(|ends| ends[end] == at))
}

/// True if the connector acts on a body at this end at all times. At times at which both ends
/// coincide, this cannot be decided.
fn is_on_body(name: &str, end: usize, film: &[Snapshot], elsewhere: &Snapshot) -> bool {
    film.iter().chain([elsewhere]).all(|snapshot| {
        let at = snapshot.ends(name).map(|ends| ends[end]);
        let mut loads =
            snapshot.loads.iter().filter(|load| load.cause == LoadOrigin::Connector && load.name == name);
        loads.any(|load| Some(load.at) == at)
    })
}

/// True if a line or a joint is drawn at this point.
fn is_held(at: Point, ends: &[Point; 2], snapshot: &Snapshot) -> bool {
    let close = TOUCHING * length(subtract(ends[1], ends[0]));
    let on_line = snapshot
        .supports
        .iter()
        .any(|line| line.form == Form::Flat && coordinates(line, at)[1].abs() <= close);
    on_line || snapshot.joints.iter().any(|joint| length(subtract(joint.at, at)) <= close)
}

/// Returns the direction of a horizontal or vertical wall with the connector on its left, averaged
/// over the film.
fn wall(name: &str, end: usize, film: &[Snapshot]) -> Option<f64> {
    let away =
        film.iter().filter_map(|snapshot| snapshot.ends(name)).map(|ends| subtract(ends[1 - end], ends[end]));
    let [x, y] = away.fold([0.0, 0.0], add);
    // Non-finite connectors are rejected later.
    unit([x, y])?;
    let quarters: [(f64, f64); 4] = [(x, 0.0), (y, 1.0), (-x, 2.0), (-y, 3.0)];
    let best = quarters
        .into_iter()
        .fold((f64::NEG_INFINITY, 0.0), |best, one| if one.0 > best.0 { one } else { best });
    Some(FRAC_PI_2 * (best.1 - 1.0))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::anchored;
    use crate::load::{Load, Value};
    use crate::picture::Point;
    use crate::snapshot::{Form, Joint, Snapshot, Span, Support};
    use lagrange_runtime::scene::{self, Connector, LoadOrigin};

    /// Creates a spring that acts on a body at its second end.
    fn spring(from: Point, to: Point) -> Snapshot {
        let (name, body) = ("k".to_string(), Some("mass".to_string()));
        let value = Value::Force([0.0, 1.0]);
        Snapshot {
            connectors: vec![Span { name: name.clone(), kind: Connector::Spring, ends: [from, to] }],
            loads: vec![Load { name, cause: LoadOrigin::Connector, body, at: to, value }],
            ..Snapshot::default()
        }
    }

    #[test]
    fn a_spring_that_hangs_is_held_by_a_ceiling() {
        let film = [spring([0.0, 2.0], [0.1, 0.0]), spring([0.0, 2.0], [-0.2, 0.5])];
        let found = anchored(&film, &spring([0.0, 2.0], [1.0, 1.0]));
        assert_eq!(found.len(), 1);
        let angle = found[&("k".to_string(), 0)];
        assert!(
            (angle.rem_euclid(2.0 * PI) - PI).abs() < 1e-12,
            "the left of a ceiling that goes to the left is below"
        );
    }

    #[test]
    fn an_end_that_could_move_is_not_held() {
        let still = [spring([0.0, 2.0], [0.0, 0.0])];
        assert!(anchored(&still, &spring([0.5, 2.0], [1.0, 1.0])).is_empty());
        let moving = [spring([0.0, 2.0], [0.0, 0.0]), spring([0.1, 2.0], [0.0, 0.0])];
        assert!(anchored(&moving, &spring([0.0, 2.0], [1.0, 1.0])).is_empty());
    }

    #[test]
    fn lines_and_joints_hold_what_ends_on_them() {
        let elsewhere = spring([0.0, 2.0], [1.0, 1.0]);
        let mut scene = spring([0.0, 2.0], [0.0, 0.0]);
        assert_eq!(anchored(&[scene.clone()], &elsewhere).len(), 1);
        scene.joints = vec![Joint { name: "pin".to_string(), kind: scene::Joint::Anchor, at: [0.0, 2.0] }];
        assert!(anchored(&[scene.clone()], &elsewhere).is_empty());
        scene.joints.clear();
        let (name, body, at) = ("top".to_string(), None, [5.0, 2.0]);
        scene.supports = vec![Support { name, body, form: Form::Flat, at, rotation: PI, is_inside: false }];
        assert!(anchored(&[scene], &elsewhere).is_empty());
    }
}
