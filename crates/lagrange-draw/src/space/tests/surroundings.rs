//! Surfaces that bodies touch, and friction cones, by the places of their corners.

use super::{UPRIGHT, motion};
use crate::geometry::{dot, length, subtract, times};
use crate::load::{Load, Value};
use crate::look::Wanted;
use crate::snapshot::{Cone, Form, Snapshot, Support};
use crate::space::mesh::normal;
use crate::space::recording::MovingMesh;
use crate::space::size::Size;
use crate::space::snapshot::{Link, SolidPart};
use crate::space::stage;
use crate::space::surroundings::{Surroundings, sample_terrain};
use crate::space::vector::{Rotation, Vector, apply_back};
use lagrange_runtime::scene::{Height, Item, LoadOrigin, Solid, Spatial, Surface, SurfaceShape};

/// A plane whose normal is x.
const WALL: Rotation = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
const SCALES: [f64; 3] = [1e-6, 1.0, 1e6];

/// Returns a cube at a place on a surface.
fn scene(center: Vector, side: f64, form: Form, rotation: Rotation) -> Snapshot<Spatial> {
    let shape = Solid::Cuboid(side, side, side);
    let parts: Vec<SolidPart> = vec![SolidPart { shape, at: [0.0; 3], rotation: UPRIGHT, is_hole: false }];
    let motion = Some(motion(UPRIGHT, center, [0.0; 3]));
    let body = Link { name: "cube".to_owned(), origin: center, rotation: UPRIGHT, motion, parts };
    Snapshot { bodies: vec![body], supports: vec![support(form, rotation)], ..Snapshot::default() }
}

fn support(form: Form, rotation: Rotation) -> Support<Spatial> {
    Support { name: "surface".to_owned(), body: None, form, at: [0.0; 3], rotation, is_inside: false }
}

fn drawn(film: &[Snapshot<Spatial>]) -> Option<MovingMesh> {
    Surroundings { film, size: &Size::of(film), is_live: false }.surfaces(0).pop()
}

fn corners(thing: &MovingMesh) -> Vec<Vector> {
    thing.mesh.corners.iter().map(|corner| thing.track[0].of(corner)).collect()
}

#[test]
fn planes_in_any_direction_reach_as_far_as_what_moves_near_them() {
    for (scale, rotation) in SCALES.into_iter().flat_map(|scale| [UPRIGHT, WALL].map(|r| (scale, r))) {
        // Far from the point that the plane is given by, in the plane.
        let normal = rotation.map(|row| row[2]);
        let center = |along: f64| times(scale, [along, along, along].map(|x| x + 0.5));
        let film = [0.0, 3.0].map(|along| scene(center(along), scale, Form::Flat, rotation));
        let grid = drawn(&film).expect("it is near");
        let corners = corners(&grid);
        assert!(corners.iter().all(|place| dot(*place, normal).abs() < 1e-9 * scale), "{corners:?}");
        let own = corners.iter().map(|place| apply_back(&rotation, *place));
        let [low, high] = crate::geometry::bounds(own);
        assert!(
            low[0] <= 0.0 && high[0] >= 4.0 * scale && high[0] - low[0] < 8.0 * scale,
            "{low:?} {high:?}"
        );
    }
}

#[test]
fn planes_far_away_are_left_out() {
    for scale in SCALES {
        let at = |height: f64| scene([0.0, 0.0, scale * height], scale, Form::Flat, UPRIGHT);
        for near in [0.5, 2.0, -0.5, -3.0, 0.0] {
            assert!(drawn(&[at(near)]).is_some(), "{near}");
        }
        for far in [50.0, -50.0] {
            assert!(drawn(&[at(far)]).is_none(), "{far}");
            assert!(drawn(&[at(far), at(0.5)]).is_some(), "it comes near");
            let film = [at(far)];
            let size = Size::of(&film);
            assert!(!Surroundings { film: &film, size: &size, is_live: true }.surfaces(0).is_empty());
        }
    }
}

#[test]
fn scenes_without_bodies_and_broken_numbers_have_surfaces_of_some_size() {
    let empty = Snapshot { supports: vec![support(Form::Flat, UPRIGHT)], ..Snapshot::default() };
    assert!(corners(&drawn(&[empty]).expect("it is drawn")).iter().flatten().all(|part| part.abs() < 1.0));
    for broken in [f64::NAN, f64::INFINITY, 1e300] {
        let scene = scene([broken, 0.0, 0.5], 1.0, Form::Flat, UPRIGHT);
        assert!(drawn(&[scene]).is_none_or(|grid| grid.mesh.lines.len() < 40), "{broken}");
    }
}

#[test]
fn a_bowl_is_seen_from_inside_and_a_huge_sphere_is_a_plane_below_the_motion() {
    for scale in SCALES {
        let mut bowl = scene([0.0, 0.0, -0.5 * scale], 0.5 * scale, Form::Round(scale), UPRIGHT);
        bowl.supports[0].is_inside = true;
        let thing = drawn(&[bowl]).expect("it is drawn");
        let places = corners(&thing);
        assert!(places.iter().all(|place| (length(*place) - scale).abs() < 1e-9 * scale));
        for face in &thing.mesh.faces {
            let points: Vec<Vector> = face.iter().map(|&corner| places[corner]).collect();
            let normal = normal(&points).expect("has an area");
            assert!(dot(normal, points[0]) < 0.0, "inwards");
        }
        let radius = 1e4 * scale;
        let [x, z] = [0.6, 0.8].map(|part| part * (radius + 0.5 * scale));
        let earth = drawn(&[scene([x, 0.0, z], scale, Form::Round(radius), UPRIGHT)]).expect("it is near");
        assert!(earth.mesh.faces.is_empty());
        let foot = [0.6 * radius, 0.0, 0.8 * radius];
        for place in corners(&earth) {
            let away = subtract(place, foot);
            assert!(
                length(away) < 5.0 * scale && dot(away, [0.6, 0.0, 0.8]).abs() < 1e-6 * scale,
                "{away:?}"
            );
        }
    }
}

/// Returns terrain of a height below a cube.
fn terrain(height: &dyn Fn([f64; 2]) -> f64) -> MovingMesh {
    moving_terrain(&[height]).pop().expect("it is drawn")
}

/// Returns terrain of a different height at each moment.
fn moving_terrain(heights: &[&dyn Fn([f64; 2]) -> f64]) -> Vec<MovingMesh> {
    let moment = |_| scene([1.0, 2.0, 0.5], 1.0, Form::Terrain(Vec::new()), UPRIGHT);
    let mut film = heights.iter().map(moment).collect::<Vec<_>>();
    let size = Size::of(&film);
    sample_terrain(&mut film, &size, false, |moment, visit: &mut dyn FnMut(Item<'_, f64, Spatial>)| {
        visit(Item::Surface(Surface {
            name: "surface",
            body: None,
            shape: SurfaceShape::Terrain(Height(heights[moment])),
            at: [0.0; 3],
            rotation: UPRIGHT,
            is_inside: false,
        }));
    });
    Surroundings { film: &film, size: &size, is_live: false }.surfaces(0)
}

#[test]
fn terrain_that_moves_has_a_mesh_for_each_of_its_shapes() {
    let (low, high) = (|[x, _]: [f64; 2]| 0.1 * x, |[x, y]: [f64; 2]| 0.3 + 0.2 * x * y);
    let bowl = |[x, y]: [f64; 2]| 0.6 - (0.36 - (x - 1.0).powi(2) - (y - 2.0).powi(2)).sqrt();
    let heights: [&dyn Fn([f64; 2]) -> f64; 6] = [&low, &low, &high, &bowl, &bowl, &low];
    let things = moving_terrain(&heights);
    assert_eq!(things.len(), 4);
    for (moment, height) in heights.iter().enumerate() {
        let seen = things.iter().filter(|thing| thing.track[moment].scale > 0.0).collect::<Vec<_>>();
        let [thing] = seen[..] else { panic!("one shape at moment {moment}, not {}", seen.len()) };
        for corner in &thing.mesh.corners {
            let [x, y, z] = thing.track[moment].of(corner);
            assert!((z - height([x, y])).abs() < 1e-12, "{moment}");
        }
    }
}

/// Requires that corners have a height and faces point upwards.
fn check_terrain(thing: &MovingMesh, height: impl Fn([f64; 2]) -> f64) {
    let places = corners(thing);
    assert!(places.iter().all(|&[x, y, z]| (z - height([x, y])).abs() < 1e-12));
    for face in &thing.mesh.faces {
        let points: Vec<Vector> = face.iter().map(|&corner| places[corner]).collect();
        assert!(normal(&points).is_some_and(|normal| normal[2] > 0.0), "upwards");
    }
}

#[test]
fn terrain_has_its_height_over_every_corner() {
    let height = |[x, y]: [f64; 2]| 0.2 * x * x - 0.1 * y;
    let thing = terrain(&height);
    check_terrain(&thing, height);
    let [low, high] = crate::geometry::bounds(corners(&thing));
    assert!(low[0] < 0.5 && high[0] > 1.5 && low[1] < 1.5 && high[1] > 2.5, "{low:?} {high:?}");
}

#[test]
fn terrain_ends_where_its_height_is_not_finite() {
    let bowl = |[x, y]: [f64; 2]| 0.6 - (0.36 - (x - 1.0).powi(2) - (y - 2.0).powi(2)).sqrt();
    let (whole, thing) = (terrain(&|_| 0.0), terrain(&bowl));
    check_terrain(&thing, bowl);
    // The faces cover the disc but for a border of one field.
    let area = |thing: &MovingMesh| thing.mesh.faces.len() as f64;
    let [low, high] = crate::geometry::bounds(corners(&whole));
    let share = std::f64::consts::PI * 0.36 / ((high[0] - low[0]) * (high[1] - low[1]));
    let found = area(&thing) / area(&whole);
    assert!(found < share && found > 0.75 * share, "{found} of {share}");
    assert!(corners(&terrain(&|_| f64::NAN)).is_empty());
    assert!(!terrain(&|_| f64::NAN).track[0].is_finite(), "it is an error");
}

#[test]
fn a_cone_is_as_high_as_the_normal_force_and_as_wide_as_the_largest_friction() {
    let (at, normal, coefficient) = ([1.0, 0.0, 0.0], [0.0, 0.0, 3.0], 0.5);
    let mut pressed = scene([0.0, 0.0, 0.5], 1.0, Form::Flat, UPRIGHT);
    let (name, body) = ("touch.normal".to_owned(), Some("cube".to_owned()));
    pressed.loads =
        vec![Load { name, cause: LoadOrigin::Contact, body: body.clone(), at, value: Value::Force(normal) }];
    pressed.cones = vec![Cone { name: "touch.cone".to_owned(), body, at, normal, coefficient }];
    let mut open = pressed.clone();
    (open.loads[0].value, open.cones[0].normal) = (Value::Force([0.0; 3]), [0.0; 3]);
    let mut rougher = pressed.clone();
    (rougher.cones[0].coefficient, rougher.cones[0].normal[2]) = (0.8, 2.0);
    let film = [pressed, open, rougher];
    let size = Size::of(&film);
    let wanted = Wanted { forces: true, ..Wanted::default() };
    let things = stage::things(&Surroundings { film: &film, size: &size, is_live: false }, wanted);
    let named = |name: &str| things.iter().find(|thing| thing.name == name).expect("it is drawn");
    let (arrow, cone) = (named("touch.normal"), named("touch.cone"));
    for (moment, coefficient, height) in [(0, 0.5, 1.0), (2, 0.8, 2.0 / 3.0)] {
        let height = height * arrow.track[0].stretch;
        let places = cone.mesh.corners.iter().map(|corner| cone.track[moment].of(corner));
        let (apex, rim): (Vec<Vector>, _) = places.partition(|place| place[2] < 0.5 * height);
        assert_eq!(apex, [at]);
        for place in rim {
            let [x, y, z] = subtract(place, at);
            assert!((z - height).abs() < 1e-12 && (x.hypot(y) - coefficient * height).abs() < 1e-12);
        }
    }
    assert_eq!(cone.track[1].scale, 0.0, "an open contact has none");
}
