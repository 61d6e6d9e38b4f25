//! Products that rigid contacts refuse: lanes, Taylor series, derivatives, and single precision.

use lagrange::Simulate;
use lagrange::integrate::{Radau5, RungeKutta4, Taylor, integrate};
use lagrange::scalar::Lanes;
use lagrange::system::{Equations, LanesSystem};

use crate::assert_near;

lagrange::system! {
    /// A disk thrown onto a slope.
    #[derive(Clone, Debug)]
    struct Disk<S>;

    param k = 5000, d = 0.4, mu = 0.3, v = 0.01, tilt = 0.2, g = 9.81;
    coord x, y, phi;
    line slope { angle: -tilt; }
    gravity = (0, -g);
    body disk { mass: 0.5; center: (x, y); angle: phi; shape: disk(0.1); }
    contact touch = disk on slope { friction: mu; stiffness: k; dissipation: d; stiction: v; }
    output load = touch.normal;
    emit { lanes, taylor, jacobian, kernel }
}

lagrange::system! {
    /// Two boxes on their corners, with 16 contacts.
    #[derive(Clone, Debug)]
    struct Boxes;

    param k = 2e5;
    gravity = (0, 0, -9.81);
    for i in 0..2 {
        body case[i] { mass: 1; shape: cuboid(0.3, 0.2, 0.1); }
        free case[i];
        contact foot[i] = case[i] on ground { friction: 0.5; stiffness: k; dissipation: 1; stiction: 1e-3; }
    }
    emit { jacobian }
}

const START: [f64; 6] = [0.0, 0.3, 0.0, 1.0, 0.0, -2.0];

#[test]
fn a_lane_has_the_bits_of_a_motion_by_itself() {
    let disks = [0, 1, 2, 3].map(|i| {
        let i = f64::from(i);
        Disk { k: 3000.0 + 1000.0 * i, mu: 0.1 * i, d: 0.3 * i, ..Disk::<f64>::default() }
    });
    let mut lanes = disks[0].lanes(|parameter| Lanes::<f64, 4>([parameter; 4]));
    for (lane, disk) in disks.iter().enumerate() {
        disk.set_lane(&mut lanes, lane);
    }
    // Steps cross the surfaces, since the sides are free.
    let step = RungeKutta4 { step: 2.5e-4 };
    let side_by_side = START.map(|entry| Lanes([entry; 4]));
    let found = (0..4000).fold(side_by_side, |y, _| runge_kutta(|y| lanes.rhs(Lanes([0.0; 4]), y), y));
    for (lane, disk) in disks.iter().enumerate() {
        let alone = (0..4000).fold(START, |y, _| runge_kutta(|y| disk.rhs(0.0, y), y));
        assert_eq!(found.map(|entry| entry.0[lane].to_bits()), alone.map(f64::to_bits));
        // The result is close to that of runs, which stop at the surfaces.
        let run = disk.simulate(START).until(1.0).method(step).run().unwrap();
        assert_near(alone, run.last(), 5e-3);
    }
}

/// Integrates a quarter of a millisecond by the classical method, for single numbers or lanes.
fn runge_kutta<S: lagrange::Number>(rhs: impl Fn(&[S; 6]) -> [S; 6], y: [S; 6]) -> [S; 6] {
    let ahead = |k: &[S; 6], h: f64| std::array::from_fn::<S, 6, _>(|i| y[i] + S::from_f64(h) * k[i]);
    let a = rhs(&y);
    let b = rhs(&ahead(&a, 1.25e-4));
    let c = rhs(&ahead(&b, 1.25e-4));
    let d = rhs(&ahead(&c, 2.5e-4));
    let (two, sixth) = (S::from_f64(2.0), S::from_f64(2.5e-4 / 6.0));
    std::array::from_fn(|i| y[i] + sixth * (a[i] + two * (b[i] + c[i]) + d[i]))
}

#[test]
fn all_methods_find_the_same_motion() {
    let disk = Disk::<f64>::default();
    let wanted = disk.simulate(START).until(1.0).tolerance(1e-13).run().unwrap().last();
    let radau = disk.simulate(START).until(1.0).method(Radau5::tolerance(1e-11)).run().unwrap().last();
    assert_near(radau, wanted, 1e-8);
    let taylor = disk.simulate(START).until(1.0).method(Taylor::tolerance(1e-13)).run().unwrap().last();
    assert_near(taylor, wanted, 1e-10);
    let single = Disk::<f32>::default();
    let run = single.simulate(START.map(|entry| entry as f32)).until(1.0).run().unwrap();
    assert_near(run.last().map(f64::from), wanted, 1e-3);
    // Without stops at the surfaces.
    let across = integrate(&disk, 0.0, START, 1.0, &RungeKutta4 { step: 1e-4 }, |_, _| {}).unwrap();
    assert_near(across, wanted, 1e-4);
}

/// At a stiction speed of 0.1 mm/s the implicit method takes few steps even at rest.
#[test]
fn implicit_steps_are_long_at_rest() {
    let disk = Disk::<f64> { v: 1e-4, tilt: 0.0, d: 5.0, mu: 0.5, ..Disk::default() };
    let start = [0.0, 0.1, 0.0, 1.0, 0.0, 0.0];
    let run = disk.simulate(start).until(5.0).method(Radau5::tolerance(1e-8)).run().unwrap();
    // It slides until it rolls, at 2/3 of its speed.
    assert_near([run.last()[3]], [2.0 / 3.0], 1e-3);
    let evaluations = run.work().evaluations;
    println!("Radau5 at 1e-4 m/s: {evaluations} evaluations for 5 s");
    assert!(evaluations < 20_000);
}

#[test]
fn sensitivities_are_the_derivatives_of_runs() {
    let disk = Disk::<f64>::default();
    let run = |disk: &Disk<f64>| disk.simulate(START).until(0.6).tolerance(1e-13).run().unwrap().last();
    let found =
        disk.simulate(START).until(0.6).tolerance(1e-12).sensitivities(["k", "mu", "d"]).run().unwrap();
    let found = found.sensitivities(found.len() - 1).unwrap();
    let moved: [fn(f64) -> Disk<f64>; 3] = [
        |by| Disk { k: 5000.0 * (1.0 + by), ..Disk::default() },
        |by| Disk { mu: 0.3 * (1.0 + by), ..Disk::default() },
        |by| Disk { d: 0.4 * (1.0 + by), ..Disk::default() },
    ];
    for ((found, moved), size) in found.into_iter().zip(moved).zip([5000.0, 0.3, 0.4]) {
        let (ahead, behind) = (run(&moved(1e-4)), run(&moved(-1e-4)));
        for i in 0..6 {
            let wanted = (ahead[i] - behind[i]) / 2e-4;
            assert!(
                (size * found[i] - wanted).abs() < 1e-5 * (1.0 + wanted.abs()),
                "{i}: {} {wanted}",
                size * found[i]
            );
        }
    }
}

/// Both boxes fall on an edge, tumble and come to rest on a face.
#[test]
fn sixteen_contacts_come_to_rest() {
    let boxes = Boxes::default();
    let at = |x: f64, tilt: f64| [x, 0.0, 0.3, (0.5 * tilt).cos(), 0.0, (0.5 * tilt).sin(), 0.0];
    let flying = |spin: f64| [0.5, 0.2, 0.0, spin, 1.0, 0.5];
    let start = [&at(0.0, 0.3)[..], &at(1.0, 0.8), &flying(1.0), &flying(-2.0)].concat();
    let start: [f64; 26] = start.try_into().unwrap();
    let run = boxes.simulate(start).until(3.0).method(Radau5::tolerance(1e-6)).run().unwrap();
    let end = run.last();
    println!("16 contacts: {} evaluations for 3 s", run.work().evaluations);
    for velocity in &end[14..] {
        assert!(velocity.abs() < 0.02, "{end:?}");
    }
    for z in [end[2], end[9]] {
        assert!([0.05, 0.1, 0.15].iter().any(|half| (z - half).abs() < 1e-3), "{z}");
    }
}
