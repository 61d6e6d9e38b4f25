//! Contact points against distances and depths found in other ways, including parallel, touching
//! and coincident blocks.

use std::vec::Vec;

use super::{Block, Manifold, Touch, manifold, touches};
use crate::linalg::space::norm;
use crate::linalg::vector::{combined, difference, dot};

/// Data of `tools/manifold.py`, which has the same generator.
const GAPS: &str = include_str!("tests/gaps.csv");

const UPRIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

struct Random(u64);

impl Random {
    fn within(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn block(&mut self, reach: f64, is_aligned: bool) -> Block<f64> {
        let grid = |value: f64| if is_aligned { (10.0 * value).floor() / 10.0 } else { value };
        let is_cuboid = self.within(0.0, 1.0) < 0.6;
        let mut half = [0; 3].map(|_| grid(self.within(0.1, 1.1)));
        let radius = if is_cuboid { 0.0 } else { grid(self.within(0.1, 0.6)) };
        if !is_cuboid {
            (half[0], half[1]) = (0.0, 0.0);
        }
        let quaternion = [0; 4].map(|_| self.within(-1.0, 1.0));
        let axes = if is_aligned { UPRIGHT } else { turned(quaternion) };
        let center = [0; 3].map(|_| grid(self.within(-reach, reach)));
        Block { center, axes, half, radius }
    }
}

fn turned(quaternion: [f64; 4]) -> [[f64; 3]; 3] {
    let length = quaternion.iter().map(|part| part * part).sum::<f64>().sqrt();
    let [w, x, y, z] = quaternion.map(|part| part / length);
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
        [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

fn cube(center: [f64; 3]) -> Block<f64> {
    Block { center, axes: UPRIGHT, half: [1.0; 3], radius: 0.0 }
}

fn capsule(center: [f64; 3], axes: [[f64; 3]; 3]) -> Block<f64> {
    Block { center, axes, half: [0.0, 0.0, 1.0], radius: 0.25 }
}

/// Checks properties of all contact points: they lie in their blocks, normals are unit vectors,
/// gaps are distances along the normal, and depths separate.
fn check(first: &Block<f64>, second: &Block<f64>, found: &Manifold<f64>) {
    for Touch { on_first, on_second, normal, gap } in found.touches() {
        assert!((norm(normal) - 1.0).abs() < 1e-12);
        for (block, place) in [(first, on_first), (second, on_second)] {
            let own = block.own(place);
            let is_within = (0..3).all(|axis| own[axis].abs() < block.half[axis] + 1e-9 || *gap < 0.0);
            assert!(is_within || own.iter().all(|x| x.abs() < 4.0), "{own:?} {block:?}");
        }
        let apart = dot(normal, &difference(on_first, on_second)) - first.radius - second.radius;
        assert!((apart - gap).abs() < 1e-8, "{apart} {gap} {first:?} {second:?}");
    }
    let gap = found.gap();
    if gap < -1e-9 {
        let deepest = found.touches().iter().find(|touch| touch.gap == gap).expect("one is the deepest");
        let moved = Block { center: combined(&first.center, 1e-9 - gap, &deepest.normal), ..*first };
        assert!(manifold(&moved, second).gap() > -1e-8, "{first:?} {second:?}");
    }
}

#[test]
fn gaps_are_distances_and_depths() {
    let mut random = Random(1);
    let (mut worst, mut counts) = (0.0_f64, [0; 3]);
    for (number, line) in GAPS.lines().enumerate() {
        let expected = line.parse::<f64>().expect("a number");
        let is_aligned = number % 8 == 0;
        let (first, second) = (random.block(1.6, is_aligned), random.block(0.5, is_aligned));
        let found = manifold(&first, &second);
        let size = first.size() + second.size();
        if found.gap() + first.radius + second.radius > size {
            assert!(found.gap() <= expected + 1e-9, "a lower bound");
            counts[2] += 1;
            continue;
        }
        check(&first, &second, &found);
        let error = (found.gap() - expected).abs() / size;
        assert!(error < 1.1e-9, "{number}: {} {expected} {first:?} {second:?}", found.gap());
        worst = worst.max(error);
        counts[usize::from(expected < 0.0)] += 1;
        // In the reverse order, the normals are opposite.
        let other = manifold(&second, &first);
        assert!((other.gap() - found.gap()).abs() < 1.1e-9 * size, "{number}");
    }
    assert!(counts[0] > 3_000 && counts[1] > 3_000, "{counts:?} {worst}");
}

fn single(block: &Block<f64>) -> Block<f32> {
    let Block { center, axes, half, radius } = block;
    let single = |triple: &[f64; 3]| triple.map(|number| number as f32);
    Block {
        center: single(center),
        axes: axes.each_ref().map(single),
        half: single(half),
        radius: *radius as f32,
    }
}

/// Faces take precedence over edges by 2.2·10⁻⁵ of the size.
#[test]
fn gaps_in_single_precision_are_distances_and_depths() {
    let mut random = Random(1);
    let (mut worst, mut sum) = (0.0_f64, 0.0);
    for (number, line) in GAPS.lines().enumerate() {
        let expected = line.parse::<f64>().expect("a number");
        let is_aligned = number % 8 == 0;
        let (first, second) = (random.block(1.6, is_aligned), random.block(0.5, is_aligned));
        let gap = f64::from(manifold(&single(&first), &single(&second)).gap());
        let size = first.size() + second.size();
        if gap + first.radius + second.radius > size {
            assert!(gap <= expected + 1e-6 * size, "a lower bound");
            continue;
        }
        let error = (gap - expected).abs() / size;
        assert!(error < 2.4e-5, "{number}: {gap} {expected} {first:?} {second:?}");
        (worst, sum) = (worst.max(error), sum + error);
    }
    assert!(sum / 12_000.0 < 1e-6, "{sum} {worst}");
}

/// Two edges cross above each other at a small angle, away from their middles.
#[test]
fn edges_that_are_almost_parallel_are_apart_where_they_cross() {
    for exponent in 1..9 {
        let (sin, cos) = 10.0_f64.powi(-exponent).sin_cos();
        let turned = [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]];
        let rod = |center, [along, across, up]: [[f64; 3]; 3]| Block {
            center,
            axes: [across, up, along],
            half: [0.0, 0.0, 1.0],
            radius: 0.0,
        };
        let first = rod([0.5 * cos, 0.5 * sin, 1e-3], turned);
        let second = rod([0.2, 0.0, 0.0], UPRIGHT);
        let gap = manifold(&first, &second).gap();
        assert!((gap - 1e-3).abs() < 1e-9, "{exponent}: {gap}");
        let gap = manifold(&single(&first), &single(&second)).gap();
        assert!((gap - 1e-3).abs() < 2.4e-5 * 2.0, "{exponent}: {gap}");
    }
}

/// The distance of a ball from a cube, and if its centre is inside of the cube, from its faces.
#[test]
fn balls_are_as_far_from_cubes_as_closed_forms() {
    let mut random = Random(7);
    for _ in 0..2_000 {
        let place = [0; 3].map(|_| random.within(-1.6, 1.6));
        let axes = turned([0; 4].map(|_| random.within(-1.0, 1.0)));
        let center = [0; 3].map(|_| random.within(-1.0, 1.0));
        let block = Block { center, axes, half: [1.0, 0.8, 0.6], radius: 0.0 };
        let ball = Block { center: block.place(&place), axes: UPRIGHT, half: [0.0; 3], radius: 0.25 };
        let beyond: [f64; 3] = core::array::from_fn(|axis| place[axis].abs() - block.half[axis]);
        let expected = match beyond.iter().all(|distance| *distance < 0.0) {
            true => beyond.into_iter().fold(f64::NEG_INFINITY, f64::max),
            false => norm(&beyond.map(|distance| distance.max(0.0))),
        };
        for found in [manifold(&ball, &block), manifold(&block, &ball)] {
            assert_eq!(found.touches().len(), 1);
            assert!((found.gap() - (expected - 0.25)).abs() < 1e-9 * 2.65, "{place:?} {}", found.gap());
        }
        check(&ball, &block, &manifold(&ball, &block));
    }
}

#[test]
fn a_cube_on_another_has_four_corners_in_their_places() {
    let below = cube([0.0; 3]);
    let places = |x: f64, gap: f64| {
        let found = manifold(&cube([x, 0.0, 2.0 + gap]), &below);
        let touches = found.touches();
        assert_eq!(touches.len(), 4);
        assert!(touches.iter().all(|touch| touch.normal == [0.0, 0.0, 1.0]), "{touches:?}");
        assert!(touches.iter().all(|touch| (touch.gap - gap).abs() < 1e-15), "{touches:?}");
        touches.iter().map(|touch| touch.on_second).collect::<Vec<_>>()
    };
    for gap in [0.1, 0.0, -0.1] {
        let still = places(0.5, gap);
        let pushed = places(0.5 + 1e-6, gap);
        for (before, after) in still.iter().zip(&pushed) {
            assert!(norm(&difference(before, after)) < 2e-6, "{before:?} {after:?}");
        }
        assert!(still.iter().all(|[x, y, z]| (*x == 1.0 || *x == -0.5) && y.abs() == 1.0 && *z == 1.0));
    }
}

#[test]
fn capsules_lie_on_two_points() {
    let along_x = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    let lying = manifold(&capsule([0.5, 0.0, 1.2], along_x), &cube([0.0; 3]));
    let ends = lying.touches().iter().map(|touch| touch.on_second[0]).collect::<Vec<_>>();
    assert!(ends.len() == 2 && ends.contains(&1.0) && ends.contains(&-0.5), "{ends:?}");
    assert!((lying.gap() + 0.05).abs() < 1e-15);
    let parallel = manifold(&capsule([0.5, 0.0, 0.6], along_x), &capsule([0.0; 3], along_x));
    assert_eq!(parallel.touches().len(), 2);
    assert!((parallel.gap() - 0.1).abs() < 1e-15);
    let crossed = manifold(&capsule([0.5, 0.0, 0.6], along_x), &capsule([0.0; 3], UPRIGHT));
    assert_eq!(crossed.touches().len(), 1);
}

#[test]
fn coincident_and_touching_blocks_have_a_normal() {
    let tilted = turned([0.9, 0.1, 0.3, -0.2]);
    let of = [cube([0.0; 3]), Block { axes: tilted, ..cube([0.0; 3]) }, capsule([0.0; 3], UPRIGHT)];
    for first in &of {
        for second in &of {
            check(first, second, &manifold(first, second));
            for shift in [[2.0, 2.0, 2.0], [2.0, 2.0, 0.0], [0.0, 0.0, 2.25], [1e-300, 0.0, 0.0]] {
                let moved = Block { center: shift, ..*first };
                let found = manifold(&moved, second);
                check(&moved, second, &found);
                assert!(found.gap().is_finite());
            }
        }
    }
    let corner = manifold(&cube([2.0; 3]), &cube([0.0; 3]));
    assert!(corner.gap().abs() < 1e-15);
}

#[test]
fn a_number_that_is_nan_shows() {
    let mut numbers = [1.0; 32];
    numbers[4] = f64::NAN;
    assert!(touches::<f64, 13>(numbers).iter().any(|number| number.is_nan()));
    let nan = Block { center: [f64::NAN; 3], ..cube([0.0; 3]) };
    assert!(manifold(&nan, &cube([0.0; 3])).gap().is_nan());
}
