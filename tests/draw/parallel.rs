//! Springs and dampers between the same points, and what `forces` shows.

use lagrange::draw::{Drawing, Picture};

use crate::marks::paths;

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
