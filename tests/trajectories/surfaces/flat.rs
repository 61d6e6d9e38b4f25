//! Rims that lie flat: disks and cans fall on their faces and rest, in steps.

use lagrange::Simulate;
use lagrange::contact::{Contact, Stepped};
use lagrange::integrate::{Method, Stepper};

use crate::{G, assert_near, flat};

lagrange::system! {
    /// A disk of 1 kg.
    #[derive(Clone, Debug)]
    struct Disk<S>;

    param mu = 0.4;
    gravity = (0, 0, -9.81);
    body disk { mass: 1; shape: solid_cylinder(0.1, 0.02); }
    free disk;
    contact touch = disk on ground { friction: mu; rim: 0.1; }
}

lagrange::system! {
    /// A can of 1 kg.
    #[derive(Clone, Debug)]
    struct Can;

    gravity = (0, 0, -9.81);
    body can { mass: 1; shape: solid_cylinder(0.1, 0.3); }
    free can;
    contact low = can.point(0, 0, -0.15) on ground { friction: 0.6; rim: 0.1; }
    contact high = can.point(0, 0, 0.15) on ground { friction: 0.6; rim: 0.1; }
}

/// Returns a disk at rest or turning about x, without an inclination.
fn turning(height: f64, rate: f64) -> [f64; 13] {
    let mut start = flat([0.0, 0.0, height], [0.0; 3]);
    start[10] = rate;
    start
}

fn largest_rise(energy: &[f64]) -> f64 {
    energy.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
}

/// Height, inclination and rates vanish, up to the length R ε that rounds the kink.
#[test]
fn disks_fall_on_their_faces_and_rest() {
    let mut spinning = turning(0.12, 0.0);
    spinning[3..5].copy_from_slice(&[(std::f64::consts::PI / 8.0).cos(), (std::f64::consts::PI / 8.0).sin()]);
    spinning[12] = 1.0;
    for start in [turning(0.3, 0.0), turning(0.3, 1e-3), turning(0.3, 3.0), turning(1.0, 30.0), spinning] {
        let run =
            Disk::<f64>::default().simulate(start).until(1.5).method(Stepped::every(1e-3)).energy().run();
        let run = run.expect("falls");
        let [_, _, z, w, i, j, k, _, _, along, p, q, _] = run.last();
        assert_near(&[z, w.hypot(k), i, j], &[0.0, 1.0, 0.0, 0.0], 1e-8);
        assert_near(&[along, p, q], &[0.0; 3], 1e-5);
        assert_eq!(run.system_at_end().map(|end| end.touch), Some(Contact::Closed));
        let rise = largest_rise(run.column("energy").expect("an energy"));
        assert!(rise < 1e-6, "{start:?} {rise:e}");
    }
}

#[test]
fn a_disk_at_rest_presses_with_its_weight() {
    let disk = Disk::<f64>::default();
    let mut stepper = Stepped::every(1e-3).start(&disk, 0.0, &turning(0.01, 0.5), 2.0).expect("starts");
    let mut impulse = 0.0;
    while stepper.time() < 1.0 - 1e-9 {
        stepper.step(&disk, 2.0).expect("a step");
        impulse += if stepper.time() > 0.9 + 1e-9 { stepper.impulses()[0] } else { 0.0 };
    }
    assert!((impulse - 0.1 * G).abs() < 1e-6, "{impulse}");
}

/// A can that is pushed less than it takes to tip rocks back. Its tilt is at most that at which the
/// whole energy lifts its centre.
#[test]
fn cans_stand() {
    let run =
        Can::default().simulate(turning(0.15, 0.3)).until(1.0).method(Stepped::every(1e-3)).energy().run();
    let run = run.expect("stands");
    assert!(run.iter().all(|(_, state)| (state[2] - 0.15).abs() < 2e-4 && state[4].abs() < 2e-3));
    assert_near(&run.last()[2..7], &[0.15, 1.0, 0.0, 0.0, 0.0], 1e-8);
    assert_near(&run.last()[7..], &[0.0; 6], 1e-6);
    let rise = largest_rise(run.column("energy").expect("an energy"));
    assert!(rise < 1e-9, "{rise:e}");
}

#[test]
fn spinning_coins_gain_no_energy() {
    let mut start = turning(0.12, 0.0);
    let (sin, cos) = (std::f64::consts::PI / 8.0).sin_cos();
    start[3..5].copy_from_slice(&[cos, sin]);
    start[12] = 10.0;
    let run = Disk::<f64>::default().simulate(start).until(1.5).method(Stepped::every(1e-3)).energy().run();
    let rise = largest_rise(run.expect("spins").column("energy").expect("an energy"));
    assert!(rise < 1e-7, "{rise:e}");
}

#[test]
fn disks_in_single_precision_fall_on_their_faces() {
    for rate in [1e-3, 3.0] {
        let start = turning(0.3, rate).map(|entry| entry as f32);
        let run = Disk::<f32>::default().simulate(start).until(1.0).method(Stepped::every(1e-3)).run();
        let [_, _, z, _, i, j, .., p, q, _] = run.expect("falls").last().map(f64::from);
        assert_near(&[z, i, j], &[0.0; 3], 1e-3);
        assert_near(&[p, q], &[0.0; 2], 0.1);
    }
}

lagrange::system! {
    /// A disk without thickness, and a can, with the rims of their shapes.
    #[derive(Clone, Debug)]
    struct Shapes<S>;

    param r = 0.1, h = 0.3;
    gravity = (0, 0, -9.81);
    body plate { mass: 1; shape: disk(r); }
    free plate;
    contact face = plate on ground { friction: 0.4; }
    body can { mass: 2; shape: solid_cylinder(r, h); }
    free can;
    contact end = can on ground { friction: 0.6; }
}

/// Returns both bodies at rest, the plate at `height` with the inclination `tilt`.
fn shapes<S: lagrange::Scalar>([height, tilt]: [f64; 2]) -> [S; 26] {
    let (sin, cos) = (0.5 * tilt).sin_cos();
    let mut start = [0.0; 26];
    start[..7].copy_from_slice(&[0.0, 0.0, height, cos, sin, 0.0, 0.0]);
    start[7..14].copy_from_slice(&[1.0, 0.0, 0.15, 1.0, 0.0, 0.0, 0.0]);
    start.map(S::from_f64)
}

/// At the exact height the rounded kink is no overlap, whatever the number type and the
/// inclination. Further down, bodies overlap.
#[test]
fn event_driven_runs_start_at_the_exact_height_of_a_rim() {
    for tilt in [0.0, 1e-12, 1e-9, 1e-8, 1e-6, 1e-4, 1e-2, 0.3] {
        let height = 0.1 * f64::sin(tilt);
        let system = Shapes::<f64>::default();
        let run = system.simulate(shapes([height, tilt])).until(1e-3).run().expect("starts");
        let closed = run.system_at_end().map(|end| (end.face, end.end_0, end.end_1));
        assert_eq!(closed, Some((Contact::Closed, Contact::Closed, Contact::Open)), "{tilt}");
        let lower = [height - 1e-9, tilt];
        let said = system.simulate(shapes(lower)).until(1e-3).run().map(drop).expect_err("overlaps");
        assert!(said.to_string().contains("the gap of the contact `face` is -1."), "{said}");
    }
    for tilt in [0.0, 0.01, 0.3] {
        let height = 0.1 * f64::sin(tilt);
        let run = Shapes::<f32>::default().simulate(shapes([height, tilt])).until(1e-3).run();
        assert!(run.is_ok(), "{tilt} {:?}", run.err());
    }
}

/// A flat plate and a standing can remain where they are, and press with their weights.
#[test]
fn flat_rims_rest_in_event_driven_runs() {
    let start = shapes::<f64>([0.0; 2]);
    let run = Shapes::<f64>::default().simulate(start).until(1.0).run().expect("rests");
    assert_near(&run.last(), &start, 1e-9);
    let end = run.system_at_end().expect("both rest");
    let last = run.last();
    let forces = end.reactions(1.0, &last[..14].try_into().unwrap(), &last[14..].try_into().unwrap());
    assert_near(&[forces[0], forces[3]], &[G, 2.0 * G], 1e-9);
    let single = Shapes::<f32>::default().simulate(shapes([0.0; 2])).until(0.5).run().expect("rests");
    assert_near(&single.last().map(f64::from), &start, 1e-5);
}

lagrange::system! {
    /// The bodies of `Shapes` with rims that are written out.
    #[derive(Clone, Debug)]
    struct Written;

    param r = 0.1, h = 0.3;
    gravity = (0, 0, -9.81);
    body plate { mass: 1; shape: disk(r); }
    free plate;
    contact face = plate on ground { friction: 0.4; rim: r; }
    body can { mass: 2; shape: solid_cylinder(r, h); }
    free can;
    contact low = can.point(0, 0, -h/2) on ground { friction: 0.6; rim: r; }
    contact high = can.point(0, 0, h/2) on ground { friction: 0.6; rim: r; }
}

#[test]
fn shapes_give_the_rims_that_could_be_written() {
    let mut start = shapes::<f64>([0.2, 0.7]);
    start[9] = 0.3;
    start[17..20].copy_from_slice(&[3.0, 1.0, -2.0]);
    start[23..26].copy_from_slice(&[2.0, 1.0, 0.5]);
    let by_shape = Shapes::<f64>::default().simulate(start).until(1.0).method(Stepped::every(1e-3)).run();
    let written = Written::default().simulate(start).until(1.0).method(Stepped::every(1e-3)).run();
    assert_eq!(by_shape.expect("falls").last(), written.expect("falls").last());
}
