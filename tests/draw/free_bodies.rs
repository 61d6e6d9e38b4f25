//! Free-body diagrams show all loads, with or without a name.

use std::cell::Cell;

use lagrange::draw::{Drawing, Picture};

use crate::marks::{farthest, paths, texts};

lagrange::system! {
    /// A pole that hangs on a cart; the coordinates imply the hinge and the rail.
    struct CartPole;

    param m_cart = 2.0, m_pole = 1.0, l = 1.0, g = 9.81;
    coord x, theta;

    gravity = (0, -g);
    body cart { mass: m_cart; center: (x, 0); shape: rectangle(0.6, 0.3); }
    body pole {
        mass: m_pole;
        shape: slender_rod(l);
        center: (x + l / 2 * sin(theta), -l / 2 * cos(theta));
        angle: theta - pi / 2;
    }
    pin hinge = pole.point(-l / 2, 0) to cart;
    emit { motion, drawing }
}

lagrange::system! {
    /// The pole on a hinge with multipliers.
    struct Pole;

    param m = 1.0, l = 1.0, g = 9.81;
    coord x, y, theta;

    gravity = (0, -g);
    body pole { mass: m; shape: slender_rod(l); center: (x, y); angle: theta - pi / 2; }
    pin hinge = pole.point(-l / 2, 0) to (0, 0);
    emit { drawing }
}

lagrange::system! {
    /// Two wheels on fixed axes, connected by a torsion spring, each with a torque.
    struct Wheels;

    param j = 0.5, k = 3.0;
    coord a, b;

    body left { mass: 8 * j; center: (0, 0); angle: a; shape: disk(0.5); }
    body right { mass: 8 * j; center: (4, 0); angle: b; shape: disk(0.5); }
    torsion_spring { from: left; to: right; stiffness: k; }
    torque 2 on left;
    emit { drawing }
}

lagrange::system! {
    /// A block on a rail that is a handwritten constraint, pulled by a spring that is a handwritten
    /// energy.
    struct Block;

    param m = 2.0, k = 50.0, g = 9.81;
    coord x, y;

    gravity = (0, -g);
    body block { mass: m; center: (x, y); shape: rectangle(0.6, 0.3); }
    constraint rail = y;
    potential = 1/2 * k * x^2;
    emit { drawing }
}

const Q: [f64; 2] = [0.3, 0.7];
const V: [f64; 2] = [0.2, 1.5];
const STATE: [f64; 4] = [Q[0], Q[1], V[0], V[1]];

/// Returns the free-body diagram of the cart or its pole, and R.
fn free(body: &str) -> (Picture, [f64; 2]) {
    let system = CartPole::default();
    let rest = Cell::new([0.0; 2]);
    let picture = Drawing::of(&system).free_body(body).annotate(|_, moment| {
        rest.set(moment.force("R").expect("something has no name").1);
    });
    (picture.picture(0.0, &STATE).expect("draws"), rest.get())
}

/// Returns the force of the hinge on the cart, by Newton's law for the pole.
fn pull(system: &CartPole) -> [f64; 2] {
    let [x, theta] = system.acceleration(0.0, &Q, &V);
    let ((sin, cos), half) = (Q[1].sin_cos(), 0.5 * system.l);
    let square = V[1] * V[1];
    let center = [x + half * (theta * cos - square * sin), half * (theta * sin + square * cos)];
    [-system.m_pole * center[0], -system.m_pole * (system.g + center[1])]
}

fn close(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12
}

#[test]
fn the_forces_of_rail_and_pole_on_a_cart_are_shown_together() {
    let system = CartPole::default();
    let (picture, rest) = free("cart");
    let hinge = pull(&system);
    // The cart stays level: the rail carries its weight and the pull of the pole.
    let rail = [0.0, system.m_cart * system.g - hinge[1]];
    assert!(close(rest, [hinge[0] + rail[0], hinge[1] + rail[1]]), "{rest:?}");
    let labels = texts(&picture.svg());
    assert_eq!(labels, ["G", "R"], "rail and hinge act in the centre of mass: there is no moment");
}

#[test]
fn a_force_without_a_name_is_drawn_on_the_scale_of_all_others() {
    let (picture, rest) = free("cart");
    let drawn = paths(&picture.svg());
    let [.., weight, arrow] = &drawn[..] else { panic!("{drawn:?}") };
    let ratio = rest[0].hypot(rest[1]) / (2.0 * 9.81);
    assert!((farthest(arrow) / farthest(weight) - ratio).abs() < 1e-3, "{arrow} {weight}");
}

#[test]
fn the_force_of_a_hinge_out_of_the_centre_comes_with_its_moment() {
    let system = CartPole::default();
    let (picture, rest) = free("pole");
    let hinge = pull(&system);
    assert!(close(rest, [-hinge[0], -hinge[1]]), "{rest:?} {hinge:?}");
    assert_eq!(texts(&picture.svg()), ["G", "R", "MR"]);
}

#[test]
fn handwritten_loads_are_shown() {
    let system = Block::default();
    let rest = Cell::new([0.0; 2]);
    let drawing = Drawing::of(&system).free_body("block").annotate(|_, moment| {
        rest.set(moment.force("R").expect("something has no name").1);
    });
    drawing.picture(0.0, &[0.2, 0.0, 0.0, 0.0]).expect("draws");
    assert!(close(rest.get(), [-50.0 * 0.2, 2.0 * 9.81]), "{:?}", rest.get());
}

#[test]
fn nothing_is_added_where_every_force_has_a_name() {
    let system = Pole::default();
    let state = [0.5, 0.0, std::f64::consts::FRAC_PI_2, 0.0, 0.0, 0.0];
    let picture = Drawing::of(&system).free_body("pole").picture(0.0, &state).expect("draws");
    assert_eq!(texts(&picture.svg()), ["G", "F"]);
}

#[test]
fn letters_of_loads_can_be_replaced() {
    let system = Pole::default();
    let state = [0.5, 0.0, std::f64::consts::FRAC_PI_2, 0.0, 0.0, 0.0];
    let lettered = Drawing::of(&system).letter("hinge", "A_y").letter("gravity", "W");
    let picture = lettered.clone().free_body("pole").picture(0.0, &state).expect("draws");
    assert_eq!(texts(&picture.svg()), ["W", "Ay"]);
    // The last letter counts.
    let picture = lettered.letter("hinge", "S").free_body("pole").picture(0.0, &state).expect("draws");
    assert_eq!(texts(&picture.svg()), ["W", "S"]);

    let pair = CartPole::default();
    let resultants = Drawing::of(&pair).free_body("pole").letter("R", "H").letter("M_R", "M_S");
    let picture = resultants.picture(0.0, &STATE).expect("draws");
    assert_eq!(texts(&picture.svg()), ["G", "H", "MS"]);
    // Weights of several bodies share a letter.
    let both = |letter| {
        let drawing = Drawing::of(&pair).nameless().forces().letter("gravity", letter);
        texts(&drawing.picture(0.0, &STATE).expect("draws").svg())
    };
    for (letter, expected) in [("W", ["Wcart", "Wpole"]), ("P_0", ["P0", "P0"])] {
        let found = both(letter);
        assert!(expected.iter().all(|text| found.iter().any(|known| known == text)), "{found:?}");
    }
}

#[test]
fn moments_are_drawn_on_the_body_on_which_they_act_and_around_each_other() {
    let system = Wheels::default();
    let free =
        |body| Drawing::of(&system).free_body(body).picture(0.0, &[0.0, 1.0, 0.0, 0.0]).expect("draws");
    for (body, labels) in [("left", ["Mtorsion spring 1", "M"].as_slice()), ("right", &["Mtorsion spring 1"])]
    {
        let svg = free(body).svg();
        assert_eq!(texts(&svg), labels);
        // The disk fills the picture only if nothing is far outside.
        let drawn = paths(&svg);
        assert!(farthest(&drawn[0]) > 300.0, "{}", drawn[0]);
    }
}
