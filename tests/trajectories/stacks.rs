//! Bodies that lie and roll on each other, in steps.

use lagrange::Simulate;
use lagrange::contact::Stepped;

use super::{G, at, state};

/// Ten cubes on each other.
mod tower {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Tower;
        param mu = 0.5;
        gravity = (0, 0, -9.81);
        for i in 0..10 { body cube[i] { mass: 1; shape: cuboid(0.2, 0.2, 0.2); } free cube[i]; }
        for i in 0..4 { contact foot[i] = cube[0].corner(i) on ground { friction: mu; } }
        for i in 0..9 { contact touch[i] = cube[i + 1] on cube[i] { friction: mu; } }
        output load = sum(k in 0..8, touch[0][k].normal);
    }
}
use tower::Tower;

/// A ball on a block, which the ground holds.
mod rolling {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Rolling;
        param slope = 0;
        gravity = (slope, 0, -9.81);
        body chest { mass: 50; shape: cuboid(2, 1, 0.4); }
        body ball { mass: 1; shape: solid_sphere(0.1); }
        free chest; free ball;
        for k in 0..4 { contact foot[k] = chest.corner(k) on ground { friction: 0.9; } }
        contact touch = ball on chest { friction: 0.6; }
    }
}
use rolling::Rolling;

/// The acceleration 5/7 g along a slope, with an error that falls as the step.
#[test]
fn a_ball_rolls_on_a_face() {
    for h in [2e-3, 1e-3] {
        let start: [f64; 26] = state::<2, 26>([at(0.0, 0.0, 0.2), at(-0.5, 0.0, 0.5)]);
        let rolling = Rolling { slope: 1.0, ..Rolling::default() };
        let run = rolling.simulate(start).until(0.5).method(Stepped::every(h)).run().expect("it rolls");
        let path = 0.5 * 0.25 * 5.0 / 7.0;
        assert!((run.last()[7] + 0.5 - path).abs() < 0.5 * h, "{} {path}", run.last()[7]);
        assert!((run.last()[9] - 0.5).abs() < 1e-9, "{}", run.last()[9]);
        assert!(run.last()[0].abs() < 1e-9, "{}", run.last()[0]);
    }
}

/// `LAGRANGE_SECONDS=60` lets the tower stand for longer.
#[test]
fn a_tower_of_ten_stands() {
    let seconds = std::env::var("LAGRANGE_SECONDS").ok().and_then(|count| count.parse().ok()).unwrap_or(2.0);
    let start: [f64; 130] = state::<10, 130>(std::array::from_fn(|i| at(0.0, 0.0, 0.1 + 0.2 * i as f64)));
    let tower = Tower::default();
    let run = tower.simulate(start).until(seconds).method(Stepped::every(1e-2)).record("load");
    let run = run.run().expect("it stands");
    let creep = run.last().iter().zip(&start).map(|(end, start)| (end - start).abs()).fold(0.0, f64::max);
    println!("creep {creep:e} in {seconds} s; {:?}", run.work());
    assert!(creep < 1e-9, "{creep}");
    assert_eq!(run.work().inexact, 0);
    let load = run.column("load").expect("recorded");
    assert!((load[load.len() - 1] - 9.0 * G).abs() < 1e-6, "{}", load[load.len() - 1]);
}
