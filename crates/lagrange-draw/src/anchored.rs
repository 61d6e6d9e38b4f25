//! Detection of ends of springs and dampers that are fixed to the ground.
//!
//! A scene states where a connector ends, and on which bodies it pulls. An end on no body is at
//! rest if it never leaves its place, neither during the film nor in another configuration at
//! another time. Such an end needs a support, unless a line or a joint is drawn there already.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

use crate::geometry::{add, length, subtract, unit};
use crate::picture::Point;
use crate::snapshot::{Snapshot, Span};
use crate::stretch::coordinates;
use lagrange_runtime::scene::{Connector, LoadOrigin};

/// The angles of short walls at the ends of connectors, by name and number of the end. The
/// connector is on the left of its wall.
pub(super) type Anchored = BTreeMap<(String, usize), f64>;

/// Relative distance, in lengths of a connector, below which points coincide.
const TOUCHING: f64 = 1e-6;

/// The ends that are held throughout a film; the scene in another configuration is `elsewhere`.
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

/// True if the connector pulls on a body there at all times; where both ends meet that is not seen
/// at one time.
fn is_on_body(name: &str, end: usize, film: &[Snapshot], elsewhere: &Snapshot) -> bool {
    film.iter().chain([elsewhere]).all(|snapshot| {
        let at = snapshot.ends(name).map(|ends| ends[end]);
        let mut loads =
            snapshot.loads.iter().filter(|load| load.cause == LoadOrigin::Connector && load.name == name);
        loads.any(|load| Some(load.at) == at)
    })
}

/// True if a line or a joint is drawn there.
fn is_held(at: Point, ends: &[Point; 2], snapshot: &Snapshot) -> bool {
    let close = TOUCHING * length(subtract(ends[1], ends[0]));
    let on_line = snapshot.lines.iter().any(|line| coordinates(line, at)[1].abs() <= close);
    on_line || snapshot.joints.iter().any(|joint| length(subtract(joint.at, at)) <= close)
}

/// The direction of a level or upright wall from which a connector leads away on the left, as the
/// mean of the film has it.
fn wall(name: &str, end: usize, film: &[Snapshot]) -> Option<f64> {
    let away =
        film.iter().filter_map(|snapshot| snapshot.ends(name)).map(|ends| subtract(ends[1 - end], ends[end]));
    let [x, y] = away.fold([0.0, 0.0], add);
    // A connector that is not a number is refused later.
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
    use crate::geometry::Place;
    use crate::load::{Load, Value};
    use crate::picture::Point;
    use crate::snapshot::{Joint, Line, Snapshot, Span};
    use lagrange_runtime::scene::{self, Connector, LoadOrigin};

    /// A spring that pulls on a body at its second end.
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
        scene.lines =
            vec![Line { name: "top".to_string(), body: None, place: Place { at: [5.0, 2.0], angle: PI } }];
        assert!(anchored(&[scene], &elsewhere).is_empty());
    }
}
