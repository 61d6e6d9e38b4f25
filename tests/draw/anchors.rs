//! Fixed ends of springs and dampers are drawn with an anchor.

use lagrange::draw::Drawing;

use crate::marks::paths;

lagrange::system! {
    /// Two masses that hang below each other, and a cart between a wall, a fixed point and a driven
    /// point.
    struct Springs;

    param m = 1.0, k = 30.0, c = 0.5, g = 9.81;
    coord y1, y2, x;

    gravity = (0, -g);
    body upper { mass: m; center: (0, y1); shape: rectangle(0.4, 0.2); }
    body lower { mass: m; center: (0, y2); shape: rectangle(0.4, 0.2); }
    body cart { mass: m; center: (x, 0); shape: rectangle(0.4, 0.2); }
    line wall { through: (3, 0); angle: pi / 2; }
    spring hanger { from: (0, 2); to: upper; stiffness: k; rest: 0.5; }
    spring link { from: upper; to: lower; stiffness: k; rest: 0.5; }
    spring base { from: cart; to: (3, 0); stiffness: k; rest: 0.5; }
    spring back { from: cart; to: (0.7, 0); stiffness: k; rest: 0.5; }
    damper drive { from: (1.5 + 0.1 * sin(t), 1); to: cart.point(0, 0.1); damping: c; }
    emit { drawing }
}

const STATE: [f64; 6] = [1.2, 0.4, 1.6, 0.0, 0.0, 0.0];

fn count(hidden: &[&str]) -> usize {
    let system = Springs::default();
    let drawing = hidden.iter().fold(Drawing::of(&system), |drawing, name| drawing.hide(name));
    paths(&drawing.picture(0.0, &STATE).expect("draws").svg()).len()
}

#[test]
fn only_ends_at_rest_that_touch_nothing_are_anchored() {
    // Each spring and each damper is a single path; an anchor is a line and its hatching.
    for (name, paths) in [("hanger", 1 + 2), ("back", 1 + 2), ("link", 1), ("base", 1), ("drive", 1)] {
        assert_eq!(count(&[]) - count(&[name]), paths, "{name}");
    }
}

#[test]
fn a_line_holds_what_ends_on_it_and_leaves_it_to_an_anchor_where_it_is_hidden() {
    assert_eq!(count(&["wall"]) - count(&["wall", "base"]), 1 + 2);
}

#[test]
fn anchors_stay_where_they_are_in_a_film() {
    let system = Springs::default();
    let states = (0..20)
        .map(|k| 0.1 * f64::from(k))
        .map(|t| (t, [1.2 - 0.3 * t.sin(), 0.4, 1.6 + 0.3 * t, 0.0, 0.0, 0.0]));
    let pictures = Drawing::of(&system).hide("wall").pictures(states).expect("draws");
    // Hatching and lines of three anchors come first.
    let grounds = |index: usize| paths(&pictures[index].svg())[..6].to_vec();
    assert!((1..20).all(|index| grounds(index) == grounds(0)));
}
