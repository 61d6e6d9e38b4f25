//! The extents of surfaces in a picture.
//!
//! Lines of a scene have no ends. However, if two of them cross, a floor ends at a wall, and a
//! plateau at the start of a slope. A line at rest is therefore cut at its crossings, and only the
//! stretches remain that an object touches at some time. Circles are drawn as a whole unless they
//! are far larger than everything else, and terrain reaches beyond the borders of most pictures.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use crate::geometry::{add, bounds, direction, dot, extent, length, subtract, times, turned};
use crate::outline::Piece;
use crate::picture::Point;
use crate::snapshot::{Form, Snapshot, Support, sampled};
use lagrange_runtime::scene::{Item, Joint};

/// Drawn stretches of each surface, by its name: lengths along lines, angles on circles, x on
/// terrain.
pub(super) type Stretches = BTreeMap<String, Vec<[f64; 2]>>;

const ENDLESS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
/// Distance from a line, as a fraction of the scene's size, below which points touch it.
const TOUCHING: f64 = 1e-6;
/// Relative excess length of a moving line over the objects that touch it, if nothing else
/// determines its length.
const LONGER: f64 = 0.2;
/// Radius of a circle relative to everything else beyond which only an arc of it is drawn.
const LARGE: f64 = 30.0;
/// Extent of arcs and terrain beyond bodies, relative to everything else.
const BEYOND: f64 = 2.0;
/// Extent of the terrain of live motions, in units of that of others.
const LIVE: f64 = 10.0;
/// Number of straight pieces of a circle.
const ROUND: usize = 120;
/// Number of straight pieces of terrain.
const PIECES: usize = 400;

/// Returns the drawn stretches of each surface throughout a film.
pub(super) fn stretches(film: &[Snapshot]) -> Stretches {
    let centers = film.iter().flat_map(|snapshot| &snapshot.bodies).map(|body| body.motion.center);
    let joints = film.iter().flat_map(|snapshot| &snapshot.joints).map(|joint| joint.at);
    let close = TOUCHING * extent(centers.chain(joints));
    let size = extent(film.iter().flat_map(places));
    let mut stretches = Stretches::new();
    for support in film.iter().flat_map(|snapshot| &snapshot.supports) {
        if !stretches.contains_key(&support.name) {
            let drawn = match support.form {
                Form::Flat => of_line(support, film, close),
                Form::Round(radius) | Form::Cylinder(radius) => vec![of_circle(support, radius, film, size)],
                Form::Terrain(_) => vec![of_terrain(support, film, size)],
            };
            stretches.insert(support.name.clone(), drawn);
        }
    }
    stretches
}

/// Returns the points of bodies that determine how large they are.
fn places(snapshot: &Snapshot) -> Vec<Point> {
    let bodies = || snapshot.bodies.iter();
    let rims = bodies().flat_map(|body| {
        let place = body.place();
        body.pieces.iter().flat_map(Piece::rim).map(move |p| place.of(p))
    });
    let centers = bodies().map(|body| body.motion.center);
    let ends = snapshot.connectors.iter().flat_map(|connector| connector.ends);
    rims.chain(centers).chain(ends).collect()
}

/// Returns the places of bodies in the coordinates of a surface throughout a film.
fn own_places(support: &Support, film: &[Snapshot]) -> Vec<Point> {
    let now =
        |snapshot: &Snapshot| snapshot.supports.iter().find(|other| other.name == support.name).cloned();
    let at = |snapshot| {
        now(snapshot)
            .map(|now| places(snapshot).into_iter().map(|p| coordinates(&now, p)).collect::<Vec<_>>())
    };
    film.iter().filter_map(at).flatten().collect()
}

/// Returns the drawn angles of a circle.
fn of_circle(support: &Support, radius: f64, film: &[Snapshot], size: f64) -> [f64; 2] {
    let places = own_places(support, film);
    let Some(&[x, y]) = places.first().filter(|_| size > 0.0 && radius > LARGE * size) else {
        return [0.0, TAU];
    };
    let first = y.atan2(x);
    let away = |[x, y]: &Point| (y.atan2(*x) - first + PI).rem_euclid(TAU) - PI;
    let (low, high) = places.iter().map(away).fold((0.0_f64, 0.0_f64), |(l, h), s| (l.min(s), h.max(s)));
    let more = BEYOND * size / radius;
    if high - low + 2.0 * more < TAU { [first + low - more, first + high + more] } else { [0.0, TAU] }
}

/// Returns the drawn range of terrain.
fn of_terrain(support: &Support, film: &[Snapshot], size: f64) -> [f64; 2] {
    let [low, high] = bounds(own_places(support, film));
    let more = if size > 0.0 { BEYOND * size } else { 1.0 };
    if low[0] <= high[0] { [low[0] - more, high[0] + more] } else { [-more, more] }
}

/// Returns the places over which terrain is sampled.
pub(super) fn samples(stretches: &[[f64; 2]]) -> Vec<Point> {
    let along = |[from, to]: &[f64; 2]| {
        let (from, step) = (*from, (to - from) / PIECES as f64);
        (0..=PIECES).map(move |k| [from + step * k as f64, 0.0])
    };
    stretches.iter().flat_map(along).collect()
}

/// Returns the pieces of each terrain in its own coordinates, for pages that compute motions
/// themselves. They extend far beyond the bodies of the visited scene. Each piece is a line through
/// points.
pub fn live_terrain(visit: impl Fn(&mut dyn FnMut(Item<'_, f64>))) -> Vec<Vec<Vec<[f64; 2]>>> {
    let snapshot = Snapshot::collected(&visit);
    let size = extent(places(&snapshot));
    let of = |support: &Support| {
        let [low, high] = of_terrain(support, std::slice::from_ref(&snapshot), LIVE * size);
        match sampled(&visit, &support.name, samples(&[[low, high]])) {
            Form::Terrain(heights) => pieces(&heights),
            _ => Vec::new(),
        }
    };
    let is_terrain = |support: &&Support| matches!(support.form, Form::Terrain(_));
    snapshot.supports.iter().filter(is_terrain).map(of).collect()
}

/// Splits terrain where its height is not finite.
fn pieces(heights: &[([f64; 2], f64)]) -> Vec<Vec<Point>> {
    let pieces = heights.split(|(_, height)| !height.is_finite()).filter(|piece| !piece.is_empty());
    pieces.map(|piece| piece.iter().map(|([x, _], height)| [*x, *height]).collect()).collect()
}

/// Returns the pieces of a circle or of terrain in the world, as lines through points. The solid
/// side is on their right. Terrain without any finite height is a point that is not finite.
pub(super) fn curve(support: &Support, stretches: &[[f64; 2]]) -> Vec<Vec<Point>> {
    let own = match &support.form {
        Form::Terrain(heights) => Some(pieces(heights))
            .filter(|pieces| !pieces.is_empty())
            .unwrap_or_else(|| vec![vec![[f64::NAN; 2]]]),
        Form::Round(radius) | Form::Cylinder(radius) => {
            let [from, to] = stretches.first().copied().unwrap_or([0.0, TAU]);
            let [from, to] = if support.is_inside { [from, to] } else { [to, from] };
            let step = (to - from) / ROUND as f64;
            vec![(0..=ROUND).map(|k| times(*radius, direction(from + step * k as f64))).collect()]
        }
        Form::Flat => Vec::new(),
    };
    let placed = |piece: Vec<Point>| piece.into_iter().map(|p| support.place().of(p)).collect();
    own.into_iter().map(placed).collect()
}

/// Returns the parts of a surface that must be visible. Those of a line without contacts are the
/// parts onto which bodies would fall. Those of terrain are below bodies, and those of arcs are the
/// nearest ones.
pub(super) fn seen(
    support: &Support,
    snapshot: &Snapshot,
    stretches: &[[f64; 2]],
    curve: &[Vec<Point>],
) -> Vec<Point> {
    match &support.form {
        Form::Flat => seen_line(support, snapshot, stretches),
        Form::Terrain(heights) => {
            let [low, high] = bounds(own_places(support, std::slice::from_ref(snapshot)));
            let drawn = heights.iter().filter(|(_, height)| height.is_finite()).zip(curve.iter().flatten());
            let below = drawn.filter(|(([x, _], _), _)| (low[0]..=high[0]).contains(x));
            below.map(|(_, point)| *point).collect()
        }
        _ if stretches == [[0.0, TAU]] => curve.concat(),
        _ => {
            let away = |at: Point, point: &Point| length(subtract(*point, at));
            let near = |at: Point| {
                curve.iter().flatten().copied().min_by(|a, b| away(at, a).total_cmp(&away(at, b)))
            };
            snapshot.bodies.iter().filter_map(|body| near(body.motion.center)).collect()
        }
    }
}

fn seen_line(line: &Support, snapshot: &Snapshot, stretches: &[[f64; 2]]) -> Vec<Point> {
    let has_contact = snapshot.joints.iter().any(|joint| matches!(joint.kind, Joint::Slide | Joint::Roll));
    if line.body.is_some() || has_contact {
        return Vec::new();
    }
    let along = snapshot.bodies.iter().map(|body| coordinates(line, body.motion.center)[0]);
    let drawn = along.filter(|s| stretches.iter().any(|[low, high]| (*low..=*high).contains(s)));
    drawn.map(|s| add(line.at, times(s, direction(line.rotation)))).collect()
}

fn of_line(line: &Support, film: &[Snapshot], close: f64) -> Vec<[f64; 2]> {
    let now = |snapshot: &Snapshot| snapshot.supports.iter().find(|other| other.name == line.name).cloned();
    let is_at_rest = line.body.is_none() && film.iter().all(|s| now(s).is_some_and(|other| other == *line));
    let touched = |snapshot| now(snapshot).map(|line| contacts(&line, snapshot, close)).unwrap_or_default();
    let mut marks: Vec<f64> = film.iter().flat_map(touched).collect();
    if !is_at_rest {
        let (count, bodies) = (marks.len(), film.iter().filter_map(|s| Some((now(s)?, s))));
        marks.extend(bodies.flat_map(|(line, snapshot)| rim(&line, snapshot)));
        return vec![moving(&marks, marks.len() > count)];
    }
    if marks.is_empty() {
        let centers = film.iter().flat_map(|snapshot| &snapshot.bodies);
        marks.extend(centers.map(|body| coordinates(line, body.motion.center)[0]));
    }
    let mut ends = crossings(line, film);
    ends.extend(ENDLESS);
    ends.sort_by(f64::total_cmp);
    let pieces = ends.windows(2).map(|ends| [ends[0], ends[1]]);
    let inside = |[low, high]: &[f64; 2]| marks.iter().any(|s| (low + close..=high - close).contains(s));
    let kept: Vec<_> = pieces.filter(inside).collect();
    if kept.is_empty() { vec![ENDLESS] } else { kept }
}

/// Returns the coordinates of a point along and across a line, or in those of another surface.
pub(super) fn coordinates(line: &Support, p: Point) -> [f64; 2] {
    let (along, from) = (direction(line.rotation), subtract(p, line.at));
    [dot(along, from), dot(turned(along), from)]
}

fn contacts(line: &Support, snapshot: &Snapshot, close: f64) -> Vec<f64> {
    let touching = snapshot.joints.iter().filter(|joint| matches!(joint.kind, Joint::Slide | Joint::Roll));
    let places = touching.map(|joint| coordinates(line, joint.at));
    places.filter(|[_, across]| across.abs() <= close).map(|[along, _]| along).collect()
}

/// Returns the coordinates along a line at which the rim of its carrier lies.
fn rim(line: &Support, snapshot: &Snapshot) -> Vec<f64> {
    let Some(body) = line.body.as_deref().and_then(|name| snapshot.body(name)) else { return Vec::new() };
    let points = body.pieces.iter().flat_map(Piece::rim);
    points.map(|p| coordinates(line, body.place().of(p))[0]).collect()
}

/// Returns the extent of a moving line, determined by the points on it.
fn moving(marks: &[f64], has_body: bool) -> [f64; 2] {
    let (low, high) =
        marks.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(*s), h.max(*s)));
    let more = if has_body { 0.0 } else { LONGER * (high - low) };
    if low < high { [low - more, high + more] } else { ENDLESS }
}

/// Returns the points at which other lines at rest cross a line.
fn crossings(line: &Support, film: &[Snapshot]) -> Vec<f64> {
    const PARALLEL: f64 = 1e-9;
    let lines = film.first().into_iter().flat_map(|snapshot| &snapshot.supports);
    let others = lines.filter(|other| other.form == Form::Flat);
    let along = direction(line.rotation);
    let crossing = |other: &Support| {
        let normal = turned(direction(other.rotation));
        let slope = dot(normal, along);
        let away = dot(normal, subtract(other.at, line.at));
        (slope.abs() > PARALLEL).then(|| away / slope)
    };
    others.filter(|other| other.body.is_none() && other.name != line.name).filter_map(crossing).collect()
}

#[cfg(test)]
mod tests {

    use super::{ENDLESS, curve, live_terrain, stretches};
    use crate::snapshot::{Form, Joint, Snapshot, Support};
    use lagrange_runtime::scene::{self, Height, Item, Surface, SurfaceShape};

    fn line(name: &str, rotation: f64) -> Support {
        let (name, body, at) = (name.to_string(), None, [0.0, 0.0]);
        Support { name, body, form: Form::Flat, at, rotation, is_inside: false }
    }

    fn slide(at: [f64; 2]) -> Joint {
        Joint { name: "foot".to_string(), kind: scene::Joint::Slide, at }
    }

    #[test]
    fn a_floor_and_a_wall_end_where_they_meet() {
        let supports = vec![line("floor", 0.0), line("wall", -std::f64::consts::FRAC_PI_2)];
        let scene =
            Snapshot { supports, joints: vec![slide([1.0, 0.0]), slide([0.0, 2.0])], ..Snapshot::default() };
        let found = stretches(&[scene]);
        let [[low, high]] = found["floor"][..] else { panic!("{found:?}") };
        assert!(low.abs() < 1e-12 && high == f64::INFINITY);
        let [[low, high]] = found["wall"][..] else { panic!("{found:?}") };
        assert!(low == f64::NEG_INFINITY && high.abs() < 1e-12, "its direction is downwards");
    }

    #[test]
    fn a_line_that_is_touched_on_both_sides_of_a_crossing_goes_on() {
        let supports = vec![line("floor", 0.0), line("other", 1.0)];
        let joints = vec![slide([1.0, 0.0]), slide([-1.0, 0.0])];
        let found = stretches(&[Snapshot { supports, joints, ..Snapshot::default() }]);
        assert_eq!(found["floor"].len(), 2);
        assert_eq!(found["other"], [ENDLESS], "nothing is known about it");
    }

    #[test]
    fn terrain_breaks_where_its_height_is_not_finite() {
        let over = |heights: [f64; 7]| {
            let samples = heights.iter().enumerate().map(|(x, height)| ([x as f64, 0.0], *height));
            let form = Form::Terrain(samples.collect());
            curve(&Support { form, at: [10.0, 0.0], ..line("hills", 0.0) }, &[])
        };
        let (nan, infinite) = (f64::NAN, f64::INFINITY);
        let pieces = over([nan, 1.0, 2.0, infinite, nan, 3.0, 4.0]);
        assert_eq!(pieces, [[[11.0, 1.0], [12.0, 2.0]], [[15.0, 3.0], [16.0, 4.0]]]);
        assert_eq!(over([0.0; 7])[0].len(), 7);
        let nowhere = over([nan; 7]).concat();
        assert!(!nowhere.is_empty() && nowhere.as_flattened().iter().all(|part| part.is_nan()));
    }

    #[test]
    fn live_terrain_has_finite_points_only() {
        let live = |height: &dyn Fn([f64; 2]) -> f64| {
            live_terrain(|visit: &mut dyn FnMut(Item<'_, f64>)| {
                let shape = SurfaceShape::Terrain(Height(height));
                let (at, rotation) = ([0.0, 0.0], 0.0);
                visit(Item::Surface(Surface {
                    name: "hills",
                    body: None,
                    shape,
                    at,
                    rotation,
                    is_inside: false,
                }));
            })
        };
        let [pieces] = &live(&|[x, _]| (x * x - 0.25).sqrt())[..] else { panic!("one terrain") };
        let [left, right] = &pieces[..] else { panic!("a gap: {pieces:?}") };
        assert!(left.iter().all(|[x, height]| *x <= -0.5 && height.is_finite()));
        assert!(right.iter().all(|[x, height]| *x >= 0.5 && height.is_finite()));
        assert_eq!(live(&|_| f64::NAN), [Vec::<Vec<[f64; 2]>>::new()], "it is not drawn");
    }
}
