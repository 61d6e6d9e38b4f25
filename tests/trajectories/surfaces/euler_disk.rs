//! Euler's disk with rolling friction, beside the law of its quasi-steady motion.

use lagrange::Simulate;
use lagrange::contact::{Contact, Friction};

use crate::G;

lagrange::system! {
    /// A thin disk of 1 kg and radius 1 that does not slip.
    #[derive(Clone, Debug)]
    struct Disk;

    param a = 3e-3;
    gravity = (0, 0, -9.81);
    body coin { mass: 1; shape: disk(1); }
    free coin;
    contact touch = coin on ground { friction: 20; rolling: a; }
}

/// Returns a disk of this inclination whose centre is at rest. It turns about the diameter through
/// its lowest point at Ω sin α, with Ω² = 4 g/(R sin α).
fn steady(sin: f64) -> [f64; 13] {
    let half = 0.5 * sin.asin();
    let mut start = [0.0; 13];
    start[2..5].copy_from_slice(&[sin, half.cos(), half.sin()]);
    start[11] = 2.0 * (G * sin).sqrt();
    start
}

/// The energy is 3/2 m g R sin α, and rolling friction takes a N Ω sin α cos α of it. The root of
/// the height therefore decreases at 2/3 a/R √(g/R) cos α: the height is a parabola that ends in
/// finite time. Source of energy and precession: Leine, *Archive of Applied Mechanics* 79 (2009)
/// 1063–1082.
#[test]
fn the_height_of_eulers_disk_is_a_parabola() {
    let disk = Disk::default();
    let run = disk.simulate(steady(0.1)).until(12.0).every(0.5).tolerance(1e-9).run().expect("rolls");
    let roots = run.states().map(|state| state[2].sqrt()).collect::<Vec<_>>();
    // The sudden start adds a small nutation, which windows of 4 s average out.
    let slope = -2.0 / 3.0 * disk.a * G.sqrt();
    for window in roots.windows(9) {
        let (found, wanted) = (window[8] - window[0], 4.0 * slope * (1.0 - window[4].powi(4)).sqrt());
        assert!((found / wanted - 1.0).abs() < 0.05, "{found} instead of {wanted} at {}", window[4]);
    }
    let whole = (roots[24] - roots[0]) / (12.0 * slope);
    println!("Euler's disk: {whole} of the slope");
    assert!((whole - 1.0).abs() < 0.01, "{whole}");
    let end = run.system_at_end().expect("it rolls");
    assert_eq!((end.touch, end.touch_friction), (Contact::Closed, Friction::Sticks));
}

/// Without rolling friction it keeps its height.
#[test]
fn eulers_disk_without_losses_keeps_its_height() {
    let disk = Disk { a: 0.0, ..Disk::default() };
    let run = disk.simulate(steady(0.1)).until(5.0).every(0.1).tolerance(1e-11).run();
    for (_, state) in run.expect("rolls").iter() {
        assert!((state[2] - 0.1).abs() < 1e-7, "{state:?}");
    }
}
