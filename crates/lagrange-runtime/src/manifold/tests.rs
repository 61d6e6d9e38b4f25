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
