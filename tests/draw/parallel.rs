//! Springs and dampers between the same points, and what `forces` shows.

use lagrange::draw::{Drawing, Picture};

use crate::marks::{paths, texts};

lagrange::system! {
    /// A block between a spring and a damper, with a wheel on a torsion spring and a torsion damper.
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

/// The heights of what is drawn of a connector between its bars, and those of the other one.
fn heights(picture: &Picture) -> Vec<[f64; 2]> {
    let numbers = |d: &String| {
        let words = d.split(|c: char| c.is_ascii_alphabetic() || c == ' ').filter(|word| !word.is_empty());
        words.map(|word| word.parse().expect("a number")).collect::<Vec<f64>>()
    };
    // What starts with a bar, goes on elsewhere and ends with a bar.
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

lagrange::system! {
    /// An arm whose joints the coordinates fulfil by themselves.
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
