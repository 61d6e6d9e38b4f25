//! Rims: coins against their nonholonomic equations, closed forms and conserved quantities.

use std::f64::consts::TAU;

use lagrange::Simulate;
use lagrange::contact::{Contact, EventKind, Friction, Stepped};
use lagrange::integrate::Radau5;

use crate::{G, assert_near, distance, drift, flat};

lagrange::system! {
    /// A coin of radius 1 on the ground.
    #[derive(Clone, Debug)]
    struct Coin<S>;

    param r = 1, tube = 0, mu = 20;
    gravity = (0, 0, -9.81);
    body coin { mass: 1; inertia: (1/4, 1/4, 1/2); }
    free coin;
    contact touch = coin on ground { rim: r; radius: tube; friction: mu; }
    output slip = touch.slip;
    output lowest = touch.point;
}

lagrange::system! {
    /// The coin with other axes, on a plane that is the ground, at a point that is the centre.
    #[derive(Clone, Debug)]
    struct Turned;

    gravity = (0, 0, -9.81);
    frame board;
    weld ground to board { turned: (0, 0, 1); }
    plane floor { on: board; normal: (0, 0, 2); }
    body coin { mass: 1; inertia: (1/2, 1/4, 1/4); }
    free coin;
    contact touch = coin.point(0, 0, 0) on floor { rim: 1; axis: (3, 0, 0); friction: 20; }
}

lagrange::system! {
    /// A coin on soft ground.
    #[derive(Clone, Debug)]
    struct Soft;

    param k = 1e5, v = 1e-4;
    gravity = (0, 0, -9.81);
    body coin { mass: 1; inertia: (1/4, 1/4, 1/2); }
    free coin;
    contact touch = coin on ground { rim: 1; stiffness: k; dissipation: 1; friction: 20; stiction: v; }
}

lagrange::system! {
    /// A coin that rolls by constraints, as in `examples/rolling_disk.rs`.
    #[derive(Clone, Debug)]
    struct Rolling;

    param m = 1, r = 1, a = 1/4, c = 1/2, g = 9.81;
    coord x, y, phi, theta, psi;

    let centre = (x - r * cos(theta) * sin(phi), y + r * cos(theta) * cos(phi), r * sin(theta));
    kinetic = 1/2 * m * inner(dot(centre), dot(centre));
    kinetic = 1/2 * a * (dot(theta)^2 + (dot(phi) * sin(theta))^2) + 1/2 * c * (dot(psi) + dot(phi) * cos(theta))^2;
    potential = m * g * centre.z;
    constraint rolling_x = dot(x) + r * dot(psi) * cos(phi);
    constraint rolling_y = dot(y) + r * dot(psi) * sin(phi);
    output place = centre;
    output velocity = dot(centre);
}

/// Returns heading, inclination and rotation of a coin at the origin, and their rates, while it
/// rolls.
fn rolling([phi, theta, psi]: [f64; 3], [phi_rate, theta_rate, psi_rate]: [f64; 3]) -> [f64; 10] {
    let (vx, vy) = (-psi_rate * phi.cos(), -psi_rate * phi.sin());
    [0.0, 0.0, phi, theta, psi, vx, vy, phi_rate, theta_rate, psi_rate]
}

/// Returns the state of a free coin in the same position: the angles are those of Euler's sequence
/// zxz.
fn free(state: [f64; 10]) -> [f64; 13] {
    let [x, y, phi, theta, psi, vx, vy, phi_rate, theta_rate, psi_rate] = state;
    let (q, v) = ([x, y, phi, theta, psi], [vx, vy, phi_rate, theta_rate, psi_rate]);
    let rolling = Rolling::default();
    let ([x, y, z], [vx, vy, vz]) = (rolling.place(0.0, &q, &v), rolling.velocity(0.0, &q, &v));
    let ((sum_s, sum_c), (rest_s, rest_c)) = ((0.5 * (phi + psi)).sin_cos(), (0.5 * (phi - psi)).sin_cos());
    let ((sin, cos), (turn_s, turn_c)) = ((0.5 * theta).sin_cos(), psi.sin_cos());
    let across = phi_rate * theta.sin();
    let spin = [
        across * turn_s + theta_rate * turn_c,
        across * turn_c - theta_rate * turn_s,
        psi_rate + phi_rate * theta.cos(),
    ];
    let [p, q, r] = spin;
    [x, y, z, cos * sum_c, sin * rest_c, sin * rest_s, cos * sum_s, vx, vy, vz, p, q, r]
}

/// Returns the difference of two states of a coin; quaternions of either sign are the same.
fn difference(found: [f64; 13], wanted: [f64; 13]) -> f64 {
    let mut other = wanted;
    other[3..7].iter_mut().for_each(|entry| *entry = -*entry);
    distance(&found, &wanted).min(distance(&found, &other))
}

const WOBBLES: [([f64; 3], [f64; 3]); 3] = [
    ([0.0, 1.2, 0.0], [0.8, 0.1, -4.0]),
    ([0.5, 1.8, 0.2], [-0.5, 0.2, 5.0]),
    ([0.4, 0.3, 0.0], [2.0, 0.3, 1.0]),
];

#[test]
fn a_coin_that_sticks_moves_as_by_constraints() {
    for (angles, rates) in WOBBLES {
        let start = rolling(angles, rates);
        for time in [1.0, 5.0] {
            let wanted =
                Rolling::default().simulate(start).until(time).tolerance(1e-13).run().expect("rolls");
            let coin = Coin::<f64>::default();
            let run = coin.simulate(free(start)).until(time).tolerance(1e-13).outputs().energy().run();
            let run = run.expect("rolls");
            assert_eq!(run.system_at_end().map(|end| end.touch_friction), Some(Friction::Sticks));
            let difference = difference(run.last(), free(wanted.last()));
            assert!(difference < 1e-9, "{angles:?} {time} {difference:e}");
            assert!(drift(run.column("energy")) < 1e-10);
            let [x, y, ..] = wanted.last();
            let last = ["lowest.x", "lowest.y", "lowest.z"]
                .map(|name| run.column(name).expect("recorded")[run.len() - 1]);
            assert_near(&last, &[x, y, 0.0], 1e-9);
        }
    }
}

#[test]
fn axis_and_plane_are_any() {
    let start = free(rolling(WOBBLES[0].0, WOBBLES[0].1));
    let wanted = Coin::<f64>::default().simulate(start).until(1.0).tolerance(1e-12).run().expect("rolls");
    // The axis of the other coin is x: q' = q ⊗ p with p, which turns x to z, and ω' = pᵀ ω p.
    let half = 0.5_f64.sqrt();
    let turned = |s: [f64; 13]| {
        let [x, y, z, w, i, j, k, vx, vy, vz, p, q, r] = s;
        [x, y, z, half * (w + j), half * (i + k), half * (j - w), half * (k - i), vx, vy, vz, r, q, -p]
    };
    let found = Turned::default().simulate(turned(start)).until(1.0).tolerance(1e-12).run().expect("rolls");
    let difference = difference(found.last(), turned(wanted.last()));
    assert!(difference < 1e-9, "{difference:e}");
}

/// A coin of moments A and C leans by θ, with the rate n of its heading and the spin ω₃ about its
/// axis. It runs in a circle if `A n² sin θ cos θ − (C + m r²) n sin θ ω₃ = m g r cos θ` (Neimark,
/// Fufaev, *Dynamics of Nonholonomic Systems*).
#[test]
fn leaning_coins_run_in_circles() {
    for (theta, n) in [(1.2_f64, 1.5), (0.5, 4.0), (0.3, 6.0), (0.05, 14.0), (1e-3, 99.0)] {
        let (sin, cos) = theta.sin_cos();
        let spin = (0.25 * n * n * sin * cos - G * cos) / (1.5 * n * sin);
        let start = free(rolling([0.0, theta, 0.0], [n, 0.0, spin - n * cos]));
        let coin = Coin::<f64> { mu: 1e6, ..Coin::default() };
        let run = coin.simulate(start).until(TAU / n).tolerance(1e-12).energy().run().expect("rolls");
        assert_near(&run.last()[..3], &start[..3], 1e-8);
        assert_near(&run.last()[7..10], &start[7..10], 1e-6);
        assert!(drift(run.column("energy")) < 1e-9);
        assert!(run.events().iter().all(|event| event.kind != EventKind::Opened));
    }
}

/// A torus stands on its tube: a wheel rolls straight on at R + r.
#[test]
fn a_tube_carries_the_rim() {
    let (sin, cos) = (0.25 * std::f64::consts::PI).sin_cos();
    let mut start = flat([0.0, 0.0, 1.2], [2.4, 0.0, 0.0]);
    start[3..7].copy_from_slice(&[cos, -sin, 0.0, 0.0]);
    start[12] = 2.0;
    let coin = Coin::<f64> { tube: 0.2, ..Coin::default() };
    let run = coin.simulate(start).until(1.0).tolerance(1e-12).outputs().run().expect("rolls");
    assert_near(&run.last()[..3], &[2.4, 0.0, 1.2], 1e-10);
    assert!(drift(run.column("slip.x")) < 1e-11 && drift(run.column("lowest.z")) < 1e-11);
}

#[test]
fn flat_coins_have_finite_motions() {
    // Released higher than a rim that lies flat, it falls and lies on its centre.
    let mut start = flat([0.0, 0.0, 0.1], [0.3, 0.0, 0.0]);
    start[12] = 1.0;
    let run = Coin::<f64>::default().simulate(start).until(1.0).run().expect("falls");
    assert_eq!(run.system_at_end().map(|end| end.touch), Some(Contact::Closed));
    assert_near(&[run.last()[2]], &[1e-9], 1e-15);
    assert!(run.last().iter().all(|entry| entry.is_finite()));
    // A little lower it overlaps.
    start[2] = -1e-8;
    let failure = Coin::<f64>::default().simulate(start).until(1.0).run().expect_err("it overlaps");
    assert!(failure.to_string().contains("`touch`") && failure.to_string().contains("overlap"), "{failure}");
    start[2] = 0.1;
    let single = Coin::<f32>::default().simulate(start.map(|entry| entry as f32)).until(1.0).run();
    assert!(single.expect("falls").last().iter().all(|entry| entry.is_finite()));
}

/// It is dropped leaning and slides: energy only decreases.
#[test]
fn sliding_coins_lose_energy() {
    let mut start = flat([0.0, 0.0, 1.2], [0.3, 0.0, 0.0]);
    start[3..5].copy_from_slice(&[0.35_f64.cos(), 0.35_f64.sin()]);
    start[12] = 1.0;
    for mu in [0.0, 0.3] {
        let coin = Coin::<f64> { mu, ..Coin::default() };
        let run = coin.simulate(start).until(2.0).tolerance(1e-10).energy().run().expect("slides");
        let energy = run.column("energy").expect("an energy");
        assert!(energy.windows(2).all(|pair| pair[1] < pair[0] + 1e-8), "{mu}");
    }
}

#[test]
fn steps_converge_to_sliding() {
    let mut start = free(rolling(WOBBLES[0].0, WOBBLES[0].1));
    start[7] += 1.0;
    for mu in [0.0, 0.2] {
        let coin = Coin::<f64> { mu, ..Coin::default() };
        let wanted = coin.simulate(start).until(0.5).tolerance(1e-11).run().expect("slides").last();
        let stepped = [1e-2, 1e-3, 1e-4].map(|step| {
            let run = coin.simulate(start).until(0.5).method(Stepped::every(step)).run().expect("slides");
            assert_eq!(run.work().inexact, 0);
            distance(&run.last()[..3], &wanted[..3])
        });
        assert!(stepped[1] < 0.2 * stepped[0] && stepped[2] < 0.2 * stepped[1], "{mu} {stepped:?}");
    }
}

#[test]
fn other_ways_converge_to_rolling() {
    let start = free(rolling(WOBBLES[0].0, WOBBLES[0].1));
    let coin = Coin::<f64>::default();
    let wanted = coin.simulate(start).until(1.0).tolerance(1e-12).run().expect("rolls").last();
    let stepped = [1e-2, 1e-3, 1e-4].map(|step| {
        let run = coin.simulate(start).until(1.0).method(Stepped::every(step)).run().expect("rolls");
        distance(&run.last()[..3], &wanted[..3])
    });
    assert!(stepped[1] < 0.15 * stepped[0] && stepped[2] < 0.15 * stepped[1], "{stepped:?}");
    let soft = [(1e4, 1e-3), (1e5, 1e-4)].map(|(k, v)| {
        let run =
            Soft { k, v, ..Soft::default() }.simulate(start).until(1.0).method(Radau5::tolerance(1e-9)).run();
        distance(&run.expect("rolls").last()[..3], &wanted[..3])
    });
    assert!(soft[1] < 0.2 * soft[0] && soft[1] < 1e-3, "{soft:?}");
    let single = Coin::<f32>::default().simulate(start.map(|entry| entry as f32)).until(1.0).run();
    assert_near(&single.expect("rolls").last().map(f64::from)[..3], &wanted[..3], 1e-3);
}
