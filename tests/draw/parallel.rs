//! Springs and dampers between the same points, and the option `forces`.

use std::f64::consts::TAU;

use lagrange::draw::{Drawing, Picture};
use lagrange::scene::{Connector, Item, Outline};

use crate::marks::{numbers, paths, texts};
use crate::scenes::{Puppet, line, part, still};

lagrange::system! {
    /// A block between a spring and a damper, with a wheel on a torsion spring and a torsion
    /// damper.
    struct Block;

    param k = 100, c = 2;
    coord x, phi;
    body block { mass: 1; center: (1 + x, 0); shape: rectangle(0.5, 0.5); }
    body wheel { mass: 1; center: (0.6, 1.2); angle: phi; shape: disk(0.3); }
    spring soft { from: (0, 0); to: block.point(-0.25, 0); stiffness: k; rest: 0.75; }
    damper slow { from: block.point(-0.25, 0); to: (0, 0); damping: c; }
    torsion_spring { from: ground; to: wheel; stiffness: k; }
    torsion_damper { from: ground; to: wheel; damping: c; }
    emit { drawing }
}

/// Returns the heights of a connector between its bars, and those of the other one.
fn heights(picture: &Picture) -> Vec<[f64; 2]> {
    // A path that starts with a bar, continues elsewhere and ends with a bar.
    let is_beside =
        |d: &&String| [3, 6].contains(&d.matches('M').count()) && !d.contains(['C', 'Z']) && d.len() > 60;
    let range = |points: Vec<f64>| {
        let middle = points.chunks(2).map(|p| p[1]).skip(3);
        let middle = middle.take(points.len() / 2 - 6);
        middle.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| [y.min(low), y.max(high)])
    };
    paths(&picture.svg()).iter().filter(is_beside).map(|d| range(numbers(d))).collect()
}

#[test]
fn a_spring_and_a_damper_are_drawn_side_by_side_throughout_a_film() {
    let block = Block::default();
    let film = [0.0, 0.1, -0.2].map(|x| (0.0, [x, 0.4, 0.0, 0.0]));
    let pictures = Drawing::of(&block).pictures(film).expect("draws");
    let alone = |hidden: &str| Drawing::of(&block).hide(hidden).picture(0.0, &film[0].1).expect("draws");
    for picture in &pictures {
        let found = heights(picture);
        let [spring, damper] = found[..] else { panic!("{found:?}") };
        assert!(spring[1] < damper[0] - 3.0 || damper[1] < spring[0] - 3.0, "{found:?}");
    }
    assert!(heights(&alone("slow")).is_empty() && heights(&alone("soft")).is_empty(), "one alone is no pair");
}

/// A spring and a damper from the origin to a point at this angle, 0.8 away, or in the reverse
/// order. Two far points give the picture a fixed size.
const PAIR: Puppet = Puppet(|angle, visit| {
    let tip = [0.8 * angle.cos(), 0.8 * angle.sin()];
    pair(tip, visit);
});
/// A pair whose ends meet where the coordinate is zero.
const MEETING: Puppet = Puppet(|s, visit| pair([0.6 * s, 0.8 * s], visit));

fn pair(tip: [f64; 2], visit: &mut dyn FnMut(Item<'_, f64>)) {
    visit(line("floor", [0.0, -2.0], 0.0));
    let parts = [part(Outline::Disk(0.05))];
    visit(Item::Body { name: "tip", motion: still(tip, 0.0), parts: &parts });
    visit(Item::Body { name: "far", motion: still([2.0, 2.0], 0.0), parts: &parts });
    visit(Item::Connector { name: "k", kind: Connector::Spring, from: [0.0, 0.0], to: tip, tension: 0.0 });
    visit(Item::Connector { name: "d", kind: Connector::Damper, from: tip, to: [0.0, 0.0], tension: 0.0 });
}

/// Returns the points of the connectors of a picture: the last two paths that vanish when both are
/// hidden.
fn drawn(system: &Puppet, s: f64) -> [Vec<[f64; 2]>; 2] {
    let svg = |hidden: &[&str]| {
        let drawing = hidden.iter().fold(Drawing::of(system).nameless(), |drawing, name| drawing.hide(name));
        drawing.picture(0.0, &[s, 0.0]).expect("draws").svg()
    };
    let without = paths(&svg(&["k", "d"]));
    let of = |d: &String| numbers(d).chunks(2).map(|p| [p[0], p[1]]).collect::<Vec<_>>();
    let shown: Vec<_> = paths(&svg(&[])).iter().filter(|d| !without.contains(d)).map(of).collect();
    // Walls come before connectors.
    let [.., spring, damper] = &shown[..] else { panic!("{shown:?}") };
    [spring.clone(), damper.clone()]
}

/// Returns the smallest and largest distances of points to the left of the line between two others.
fn aside(points: &[[f64; 2]], [from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length = along[0].hypot(along[1]).max(1e-9);
    let left = points.iter().map(|p| (along[0] * (p[1] - from[1]) - along[1] * (p[0] - from[0])) / length);
    left.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| [low.min(y), high.max(y)])
}

#[test]
fn a_pair_lies_side_by_side_in_every_direction() {
    for k in 0..16 {
        let [spring, damper] = drawn(&PAIR, 0.1 + TAU * f64::from(k) / 16.0);
        let ends = [spring[0], spring[spring.len() - 1]];
        assert!((ends[0][0] - ends[1][0]).hypot(ends[0][1] - ends[1][1]) > 30.0, "{spring:?}");
        for (own, other) in [(damper[0], ends[1]), (damper[damper.len() - 1], ends[0])] {
            assert!((own[0] - other[0]).hypot(own[1] - other[1]) < 0.02, "the same ends at {k}");
        }
        let [one, other] = [&spring, &damper].map(|points| aside(&points[3..points.len() - 3], ends));
        assert!(one[1] < other[0] - 3.0 || other[1] < one[0] - 3.0, "{one:?} {other:?} at {k}");
        let all = aside(&[spring, damper].concat(), ends);
        assert!(all[0] > -20.0 && all[1] < 20.0 && (all[0] + all[1]).abs() < 1.0, "about the line: {all:?}");
    }
}

#[test]
fn a_pair_whose_ends_meet_is_drawn_within_the_picture() {
    for s in [0.0, 1e-17, -1e-3] {
        let [spring, damper] = drawn(&MEETING, s);
        let at = spring[0];
        let far = |points: &[[f64; 2]]| {
            points.iter().map(|p| (p[0] - at[0]).hypot(p[1] - at[1])).fold(0.0, f64::max)
        };
        assert!(far(&spring) < 30.0 && far(&damper) < 30.0, "{spring:?} {damper:?}");
        assert!(far(&spring) >= 10.0 && far(&damper) >= 10.0, "still side by side: {spring:?} {damper:?}");
    }
}

lagrange::system! {
    /// An arm whose coordinates imply its joints.
    struct Arm;

    param l = 1, g = 9.81;
    coord q1, q2;
    input u, w;
    gravity = (0, -g);
    let (x, y) = (l * sin(q1), -l * cos(q1));
    body upper { mass: 1; center: (x / 2, y / 2); angle: q1; shape: rectangle(l / 9, l); }
    body lower { mass: 1; origin: (x, y); angle: q1 + q2; shape: disk(l / 4); }
    pin shoulder = upper.point(0, l / 2) to (0, 0);
    pin elbow_2 = lower to upper.point(0, -l / 2);
    torque u on q2;
    torque w on 2 * q1;
    emit { drawing }
}

#[test]
fn pictures_of_forces_name_what_they_leave_out() {
    let arm = Arm { u: 1.0, w: 0.5, ..Arm::default() };
    let written = |drawing: Drawing<'_, Arm>| {
        let svg = drawing.picture(0.0, &[0.7, 0.6, 0.1, 0.2]).expect("draws").svg();
        texts(&svg).into_iter().find(|text| text.starts_with("not drawn"))
    };
    let note = written(Drawing::of(&arm).forces()).expect("a note");
    assert_eq!(note, "not drawn: force of shoulder, force of elbow 2, torque on an angle");
    let hidden = written(Drawing::of(&arm).forces().hide("shoulder").hide("torque on an angle"));
    assert_eq!(hidden.expect("a note"), "not drawn: force of elbow 2");
    assert_eq!(written(Drawing::of(&arm)), None, "no forces are drawn");
    assert_eq!(written(Drawing::of(&arm).free_body("lower")), None, "they are part of R");
}

#[test]
fn a_note_takes_no_place_of_the_picture() {
    let arm = Arm { u: 1.0, w: 0.5, ..Arm::default() };
    let svg = Drawing::of(&arm).forces().picture(0.0, &[0.0, 0.6, 0.1, 0.2]).expect("draws").svg();
    let document = roxmltree::Document::parse(&svg).expect("is well formed");
    let height = |node: roxmltree::Node<'_, '_>| node.attribute("y").and_then(|y| y.parse::<f64>().ok());
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    let heights: Vec<f64> = texts.filter_map(height).collect();
    let lowest = heights.iter().copied().fold(0.0, f64::max);
    assert!((380.0..400.0).contains(&lowest), "{heights:?}");
    assert!(heights.iter().filter(|height| **height > lowest - 10.0).count() == 1, "{heights:?}");
}
