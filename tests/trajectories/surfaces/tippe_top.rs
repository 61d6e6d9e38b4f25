//! A tippe top: a ball whose centre of mass is below its centre turns over, and spins on its head.
//!
//! The contact force passes through the point of contact. Jellett's constant therefore holds for
//! any law of friction. It is the angular momentum about the centre of mass times the vector from
//! there to the point of contact.
//!
//! Source: Jellett, *A Treatise on the Theory of Friction*, ch. 8.

use lagrange::Simulate;
use lagrange::contact::Stepped;

use crate::{G, assert_near, drift};

/// Declares a top of radius 2 cm with this contact.
macro_rules! top {
    ($name:ident, $($law:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;

            param r = 0.02, a = 0.004, m = 0.02, j = 3.2e-6, mu = 0.3;
            gravity = (0, 0, -9.81);
            body top { mass: m; centroid: (0, 0, -a); inertia: (j, j, j); }
            free top;
            contact touch = top.point(0, 0, 0) on ground { radius: r; friction: mu; $($law)* }
            output jellett = inner(angular_momentum(top, top.center), touch.point - top.center);
            output height = top.center.z - top.origin.z;
        }
    };
}

top!(Rigid,);
top!(Soft, stiffness: 2e3; dissipation: 20; stiction: 0.1;);

/// Returns a top that spins about its axis, which is tilted.
fn tilted(angle: f64, spin: f64) -> [f64; 13] {
    let (sin, cos) = (0.5 * angle).sin_cos();
    [0.0, 0.0, 0.02, cos, sin, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, spin]
}

/// Friction of a top is smooth here: dry friction would let it roll without slipping.
#[test]
fn it_turns_over() {
    let top = Soft::default();
    let run = top.simulate(tilted(0.1, 180.0)).until(3.0).tolerance(1e-9).outputs().run().expect("spins");
    let height = run.column("height").expect("recorded");
    assert!(height[0] < -0.99 * top.a, "{}", height[0]);
    assert!(height[height.len() - 1] > 0.999 * top.a, "{}", height[height.len() - 1]);
    let jellett = run.column("jellett").expect("recorded");
    assert!(drift(Some(jellett)) < 1e-9 * jellett[0].abs());
    // On its head it spins about the vertical, with the centre of mass above the centre. It still
    // wobbles a little.
    let arm = top.r + top.a - top.m * G / 2e3;
    assert_near(&run.last()[12..], &[jellett[0] / (top.j * arm)], 1.0);
}

#[test]
fn its_constant_survives_sticking_and_slipping() {
    let top = Rigid { mu: 0.1, ..Rigid::default() };
    let run = top.simulate(tilted(0.3, 300.0)).until(0.5).tolerance(1e-10);
    let run = run.outputs().energy().run().expect("spins");
    let jellett = run.column("jellett").expect("recorded");
    assert!(drift(Some(jellett)) < 1e-10 * jellett[0].abs());
    let energy = run.column("energy").expect("recorded");
    assert!(energy.windows(2).all(|pair| pair[1] <= pair[0] + 1e-10 * energy[0].abs()));
    assert!(energy[energy.len() - 1] < 0.999 * energy[0]);
    let stepped = top.simulate(tilted(0.3, 300.0)).until(0.5);
    let stepped = stepped.method(Stepped::every(1e-5)).outputs().run().expect("spins");
    assert!(drift(stepped.column("jellett")) < 1e-2 * jellett[0].abs());
}
