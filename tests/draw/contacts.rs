//! Forces of contacts are drawn on both bodies, and equal those of a motion from the state.

use std::cell::RefCell;

use lagrange::Simulate;
use lagrange::draw::Drawing;

use crate::marks::texts;

lagrange::system! {
    /// A block that slides down a slope.
    #[derive(Clone, Debug)]
    struct Block;

    param m = 2, mu = 0.2, tilt = 0.5, g = 9.81;
    coord x, y;
    gravity = (0, -g);
    line slope { angle: -tilt; }
    body block { mass: m; center: (x, y); angle: -tilt; shape: rectangle(0.4, 0.2); }
    contact touch = block.point(0, -0.1) on slope { friction: mu; }
    emit { drawing, motion }
}

lagrange::system! {
    /// A ball that rests on a plate, which is pushed upwards.
    #[derive(Clone, Debug)]
    struct Stack;

    param m = 1, push = 50, g = 9.81;
    coord y1, y2;
    gravity = (0, -g);
    body plate { mass: m; center: (0, y1); shape: rectangle(2, 0.2); }
    body ball { mass: m; center: (0, y2); shape: disk(0.3); }
    line top { through: (0, 0.1); on: plate; }
    force y1 = push;
    contact rest = ball on top;
    emit { drawing }
}

lagrange::system! {
    /// A ball that sinks into soft ground.
    #[derive(Clone, Debug)]
    struct Soft;

    param k = 1e4;
    coord x, y;
    gravity = (0, -9.81);
    body ball { mass: 1; center: (x, y); shape: disk(0.1); }
    contact touch = ball on ground { stiffness: k; friction: 0.5; stiction: 0.001; }
    emit { drawing }
}

lagrange::system! {
    /// A box on its four lower corners.
    #[derive(Clone, Debug)]
    struct Case;

    gravity = (0, 0, -9.81);
    body case { mass: 2; shape: cuboid(0.4, 0.4, 0.2); }
    free case;
    for i in 0..4 { contact foot[i] = case.corner(i) on ground { friction: 0.3; } }
    emit { drawing }
}

/// Collects the forces with these names in a picture, with their points.
macro_rules! forces {
    ($system:expr, $state:expr, $names:expr) => {{
        let found = RefCell::new(Vec::new());
        let drawing = Drawing::of($system).forces().annotate(|_, moment| {
            *found.borrow_mut() = $names.map(|name| moment.force(name).expect("it is drawn")).to_vec();
        });
        let picture = drawing.picture(0.0, &$state).expect("draws");
        (texts(&picture.svg()), found.take())
    }};
}

fn close(one: [f64; 2], other: [f64; 2]) -> bool {
    (one[0] - other[0]).hypot(one[1] - other[1]) < 1e-9
}

/// Returns the block on the slope, moving along it at 1 m/s.
fn sliding(block: &Block) -> [f64; 4] {
    let (sin, cos) = block.tilt.sin_cos();
    [0.1 * sin, 0.1 * cos, cos, -sin]
}

#[test]
fn normal_force_and_friction_of_a_block_are_those_of_newton() {
    let block = Block::default();
    let (sin, cos) = block.tilt.sin_cos();
    let normal = block.m * block.g * cos;
    let (labels, found) = forces!(&block, sliding(&block), ["touch.normal", "touch.friction"]);
    assert!(close(found[0].1, [normal * sin, normal * cos]), "{found:?}");
    assert!(close(found[1].1, [-block.mu * normal * cos, block.mu * normal * sin]), "{found:?}");
    assert!(found.iter().all(|(at, _)| close(*at, [0.0, 0.0])), "{found:?}");
    assert!(["G", "N", "H"].iter().all(|label| labels.iter().any(|text| text == label)), "{labels:?}");
}

#[test]
fn all_forces_on_a_free_body_have_names() {
    let block = Block::default();
    let picture = Drawing::of(&block).free_body("block").picture(0.0, &sliding(&block)).expect("draws");
    let mut labels = texts(&picture.svg());
    labels.sort_unstable();
    // The angle is not a coordinate, so a moment holds it.
    assert_eq!(labels, ["G", "H", "MR", "N"]);
}

#[test]
fn accelerations_are_those_under_the_forces_of_contacts() {
    let block = Block::default();
    let (sin, cos) = block.tilt.sin_cos();
    let drawing = Drawing::of(&block).annotate(|_, moment| {
        let [x, y] = moment.motion("block").expect("a body").acceleration;
        let along = block.g * (sin - block.mu * cos);
        assert!(close([x, y], [along * cos, -along * sin]), "{x} {y}");
    });
    drawing.picture(0.0, &sliding(&block)).expect("draws");
}

#[test]
fn nothing_presses_where_nothing_touches() {
    let block = Block::default();
    let state = [0.0, 1.0, 0.0, 0.0];
    let (labels, found) = forces!(&block, state, ["touch.normal", "touch.friction"]);
    assert!(found.iter().all(|(_, force)| *force == [0.0, 0.0]), "{found:?}");
    assert!(!labels.iter().any(|text| text == "N" || text == "H"), "{labels:?}");
}

#[test]
fn overlapping_contacts_are_reported() {
    let block = Block::default();
    let state = [0.0, 0.0, 0.0, 0.0];
    let svg = |drawing: Drawing<'_, Block>| drawing.picture(0.0, &state).expect("draws").svg();
    let note = "not drawn: forces of contacts that overlap";
    assert!(texts(&svg(Drawing::of(&block).forces())).contains(&note.to_owned()));
    assert!(!texts(&svg(Drawing::of(&block))).contains(&note.to_owned()));
}

#[test]
fn films_pass_through_overlapping_contacts() {
    let case = Case::default();
    let at = |height| [0.0, 0.0, height, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let film = Drawing::of(&case).forces().film_of([(0.0, at(0.2)), (1.0, at(0.09))]).expect("draws");
    assert!(film.html().contains("not drawn: forces of contacts that overlap"));
}

#[test]
fn both_bodies_get_opposite_forces() {
    let stack = Stack::default();
    let free = |body: &str| {
        let force = RefCell::new([0.0; 2]);
        let drawing = Drawing::of(&stack).free_body(body).annotate(|_, moment| {
            *force.borrow_mut() = moment.force("rest.normal").expect("it is drawn").1;
        });
        drawing.picture(0.0, &[0.0, 0.4, 0.0, 0.0]).expect("draws");
        force.take()
    };
    // Both are pushed together, and each takes half of the force.
    assert!(close(free("ball"), [0.0, 25.0]) && close(free("plate"), [0.0, -25.0]));
}

#[test]
fn a_compliant_contact_presses_by_its_depth() {
    let soft = Soft::default();
    let (_, found) = forces!(&soft, [0.0, 0.099, 0.0, 0.0], ["touch.normal", "touch.friction"]);
    assert!(close(found[0].1, [0.0, 10.0]) && close(found[1].1, [0.0, 0.0]), "{found:?}");
}

#[test]
fn the_ground_is_drawn_once_under_all_contacts() {
    let soft = Soft::default();
    let state = [0.0, 0.099, 0.0, 0.0];
    let svg = |drawing: Drawing<'_, Soft>| drawing.picture(0.0, &state).expect("draws").svg();
    let (with, without) = (svg(Drawing::of(&soft)), svg(Drawing::of(&soft).hide("ground")));
    assert!(with.matches("<path").count() > without.matches("<path").count(), "{with}\n{without}");
}

#[test]
fn forces_of_a_film_follow_its_motion() {
    let block = Block::default();
    let run = block.simulate(sliding(&block)).until(0.5).every(0.1).run().expect("slides");
    let count = RefCell::new(0);
    let drawing = Drawing::of(&block).forces().annotate(|_, moment| {
        let (at, force) = moment.force("touch.normal").expect("it is drawn");
        let expected = block.m * block.g * block.tilt.cos();
        assert!((force[0].hypot(force[1]) - expected).abs() < 1e-9, "{force:?}");
        assert!((at[0] * block.tilt.sin() + at[1] * block.tilt.cos()).abs() < 1e-9, "{at:?}");
        *count.borrow_mut() += 1;
    });
    drawing.film(&run).expect("draws");
    assert!(count.take() >= 6);
}

#[test]
fn corners_of_a_box_have_arrows_in_space() {
    let case = Case::default();
    let state = [0.0, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let picture = Drawing::of(&case).forces().picture(0.0, &state).expect("draws");
    let labels = texts(&picture.svg());
    for letter in ["N", "H"] {
        let arrows = labels.iter().filter(|text| text.starts_with(letter)).count();
        assert_eq!(arrows, 4, "{labels:?}");
    }
}
