//! Surfaces that bodies touch, and friction cones: their geometry in pictures.

use lagrange::draw::{DrawError, Drawing};

use crate::marks::{numbers, paths};

lagrange::system! {
    /// A ball on waves.
    #[derive(Clone, Debug)]
    struct Waves;

    param high = 0.2;
    coord x, y;
    gravity = (0, -9.81);
    terrain hills { height(s): high * sin(2 * s); }
    body ball { mass: 1; center: (x, y); shape: disk(0.1); }
    contact touch = ball on hills { friction: 0.5; }
    emit { drawing }
}

lagrange::system! {
    /// A ball in a hoop and on a wheel.
    #[derive(Clone, Debug)]
    struct Rounds;

    param size = 1, wheel = -0.4, r = 0.1;
    coord x, y;
    gravity = (0, -9.81);
    circle hoop { center: (0, 0); radius: size; }
    circle roller { center: (0, wheel); radius: 0.3 * size; }
    body ball { mass: 1; center: (x, y); shape: disk(r); }
    contact low = ball inside hoop;
    contact high = ball on roller;
    emit { drawing }
}

lagrange::system! {
    /// A box on an inclined plane.
    #[derive(Clone, Debug)]
    struct Incline<S>;

    param tilt = 0.4, mu = 0.6;
    gravity = (0, 0, -9.81);
    plane slope { normal: (sin(tilt), 0, cos(tilt)); }
    body case { mass: 2; shape: cuboid(0.4, 0.3, 0.2); }
    free case;
    for i in 0..4 { contact foot[i] = case.corner(i) on slope { friction: mu; } }
    emit { drawing }
}

/// Returns the middle and the radius of a ball in a picture, by its first circle of four curves.
fn ball(svg: &str, radius: f64) -> impl Fn([f64; 2], [f64; 2]) -> [f64; 2] {
    let circle = paths(svg).into_iter().filter(|path| path.matches('C').count() == 4);
    let smallest = circle.map(|path| numbers(&path)).min_by(|a, b| width(a).total_cmp(&width(b)));
    let circle = smallest.expect("a circle");
    let (scale, left) = (0.5 * width(&circle) / radius, xs(&circle).fold(f64::INFINITY, f64::min));
    let middle = [left + 0.5 * width(&circle), circle[1]];
    move |center, [x, y]| [center[0] + (x - middle[0]) / scale, center[1] - (y - middle[1]) / scale]
}

fn xs(numbers: &[f64]) -> impl Iterator<Item = f64> {
    numbers.chunks(2).map(|point| point[0])
}

fn width(numbers: &[f64]) -> f64 {
    let [low, high] = [f64::min, f64::max].map(|of| xs(numbers).reduce(of).unwrap_or(f64::NAN));
    high - low
}

/// Returns the points of the longest open path of straight lines in world coordinates.
fn longest(svg: &str, radius: f64, center: [f64; 2]) -> Vec<[f64; 2]> {
    let world = ball(svg, radius);
    let is_curve = |path: &String| path.matches('M').count() == 1 && !path.contains('C');
    let found = paths(svg).into_iter().filter(is_curve).map(|path| numbers(&path));
    let found = found.max_by(|a, b| width(a).total_cmp(&width(b))).expect("a curve");
    found.chunks(2).map(|point| world(center, [point[0], point[1]])).collect()
}

#[test]
fn terrain_in_the_plane_is_drawn_at_its_height() {
    let waves = Waves::default();
    let center = [0.3, 0.4];
    let picture = Drawing::of(&waves).picture(0.0, &[center[0], center[1], 0.0, 0.0]).expect("draws");
    let points = longest(&picture.svg(), 0.1, center);
    assert!(points.len() > 20, "{points:?}");
    for [x, y] in points {
        assert!((y - waves.high * (2.0 * x).sin()).abs() < 2e-3, "{x} {y}");
    }
    let high = Waves { high: f64::NAN, ..Waves::default() };
    let result = Drawing::of(&high).picture(0.0, &[0.3, 0.4, 0.0, 0.0]);
    assert!(matches!(result, Err(DrawError::NotFinite { item, .. }) if item == "hills"));
}

#[test]
fn circles_are_drawn_whole_unless_they_are_far_larger_than_all_else() {
    for size in [1e-6, 1.0, 1e6] {
        let rounds = Rounds { size, wheel: -0.4 * size, r: 0.1 * size, ..Rounds::default() };
        let center = [0.0, -0.9 * size];
        let picture = Drawing::of(&rounds).picture(0.0, &[center[0], center[1], 0.0, 0.0]).expect("draws");
        let points = longest(&picture.svg(), rounds.r, center);
        let is_on = |radius: f64, [x, y]: [f64; 2]| (x.hypot(y) - radius).abs() < 0.01 * size;
        assert!(points.len() > 100 && points.iter().all(|point| is_on(size, *point)), "{points:?}");
    }
    let planet = Rounds { size: 1e5, wheel: 0.0, r: 0.1, ..Rounds::default() };
    let center = [0.0, -1e5 + 0.1];
    let picture = Drawing::of(&planet).hide("roller").picture(0.0, &[center[0], center[1], 0.0, 0.0]);
    let points = longest(&picture.expect("draws").svg(), 0.1, center);
    assert!(points.iter().all(|[x, y]| x.abs() < 1.0 && (y + 1e5).abs() < 1e-3), "{points:?}");
}

#[test]
fn a_friction_cone_opens_by_the_coefficient_from_the_point_of_contact() {
    let waves = Waves { high: 0.0, ..Waves::default() };
    let state = [0.0, 0.1, 0.0, 0.0];
    let svg = Drawing::of(&waves).forces().picture(0.0, &state).expect("draws").svg();
    let without = Drawing::of(&waves).forces().hide("touch.cone").picture(0.0, &state).expect("draws").svg();
    let cone = paths(&svg).into_iter().find(|path| !paths(&without).contains(path)).expect("a cone");
    let [left, apex, right] = numbers(&cone).chunks(2).map(|p| [p[0], p[1]]).collect::<Vec<_>>()[..] else {
        panic!("three points: {cone}")
    };
    let height = apex[1] - left[1];
    assert!(height > 20.0 && (right[1] - left[1]).abs() < 0.02);
    assert!(((right[0] - left[0]).abs() - 2.0 * 0.5 * height).abs() < 0.05, "{cone}");
    let apart = [0.0, 0.2, 0.0, 0.0];
    let with = Drawing::of(&waves).forces().picture(0.0, &apart).expect("draws").svg();
    let without = Drawing::of(&waves).forces().hide("touch.cone").picture(0.0, &apart).expect("draws");
    assert_eq!(with, without.svg(), "an open contact has no cone");
}

#[test]
fn inclined_planes_have_the_same_picture_in_single_precision() {
    let (sin, cos) = 0.2_f64.sin_cos();
    let state = [0.2, 0.0, 0.3, cos, 0.0, sin, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let double = Drawing::of(&Incline::<f64>::default()).picture(0.0, &state).expect("draws").svg();
    let single = Incline::<f32>::default();
    let single = Drawing::of(&single).picture(0.0, &state.map(|part| part as f32)).expect("draws").svg();
    let [double, single] = [double, single].map(|svg| paths(&svg));
    assert_eq!(double.len(), single.len());
    for (a, b) in double.iter().zip(&single) {
        let (a, b) = (numbers(a), numbers(b));
        assert!(a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 0.05), "{a:?}");
    }
}
