//! A disk that slides and spins on 24 points, beside handwritten equations and a published ratio.

use lagrange::Simulate;

use crate::assert_near;

lagrange::system! {
    /// A disk of mass 1 and radius 1, seen from above, with μ g = 1. Points on three rings bear
    /// what Gauss' quadrature over the area assigns to them.
    #[derive(Clone, Debug)]
    struct Disk;

    const radii[3] = [sqrt((1 - sqrt(3/5))/2), sqrt(1/2), sqrt((1 + sqrt(3/5))/2)];
    const loads[3] = [5/144, 8/144, 5/144];
    coord x, y, phi;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2) + 1/4 * dot(phi)^2;
    for i in 0..3 {
        for k in 0..8 {
            let foot[i][k] = (x + radii[i] * cos(phi + k * pi/4), y + radii[i] * sin(phi + k * pi/4));
            friction rub[i][k] = dot(foot[i][k]), loads[i];
        }
    }
}

/// Returns the rates of the disk on its points, as long as all of them slip.
fn rates([_, _, phi, vx, vy, omega]: [f64; 6]) -> [f64; 6] {
    let root = 0.6_f64.sqrt();
    let mut force = [0.0; 3];
    for (square, load) in [(0.5 - 0.5 * root, 5.0), (0.5, 8.0), (0.5 + 0.5 * root, 5.0)] {
        for k in 0..8 {
            let (sin, cos) = (phi + f64::from(k) * std::f64::consts::FRAC_PI_4).sin_cos();
            let [a, b] = [cos, sin].map(|part| part * f64::sqrt(square));
            let [sx, sy] = [vx - omega * b, vy + omega * a];
            let share = load / 144.0 / sx.hypot(sy);
            force = [force[0] - share * sx, force[1] - share * sy, force[2] - share * (a * sy - b * sx)];
        }
    }
    [vx, vy, omega, force[0], force[1], 2.0 * force[2]]
}

/// Returns the state at a time by the classical method of Runge and Kutta.
fn by_hand(mut y: [f64; 6], until: f64) -> [f64; 6] {
    let (count, moved) =
        (20_000, |y: &[f64; 6], h: f64, r: &[f64; 6]| std::array::from_fn(|i| y[i] + h * r[i]));
    let h = until / f64::from(count);
    for _ in 0..count {
        let first = rates(y);
        let second = rates(moved(&y, 0.5 * h, &first));
        let third = rates(moved(&y, 0.5 * h, &second));
        let fourth = rates(moved(&y, h, &third));
        let mean = std::array::from_fn(|i| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0);
        y = moved(&y, h, &mean);
    }
    y
}

/// Sliding and spinning end together. Before that, the speed of a uniform disk tends to 0.653 ω,
/// and eight points on each of three rings are close to it. Source: Farkas, Bartels, Unger, Wolf,
/// *Physical Review Letters* 90 (2003) 248302.
#[test]
fn disks_slide_and_spin_until_both_end_together() {
    for [v, w] in [[1.0, 0.5], [1.0, 1.0], [1.0, 2.0]] {
        let start = [0.0, 0.0, 0.1, v, 0.0, w];
        let run = |until: f64| {
            let run = Disk::default().simulate(start).until(until).tolerance(1e-11).run();
            run.unwrap_or_else(|error| panic!("{v} {w}: {error}"))
        };
        let rest = run(4.0);
        assert!(rest.last()[3..].iter().all(|speed| speed.abs() < 1e-12), "{:?}", rest.last());
        let time = rest.events().last().expect("it stops").time;
        assert_near(run(0.8 * time).last(), by_hand(start, 0.8 * time), 1e-8);
        let [.., along, _, omega] = run(0.99 * time).last();
        println!("{v} {w}: at rest after {time}, with {} before", along / omega);
        assert!((along / omega / 0.653 - 1.0).abs() < 0.1, "{along} {omega}");
    }
}
