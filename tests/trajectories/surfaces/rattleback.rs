//! A rattleback: an ellipsoid whose principal axes are turned against those of its inertia.
//!
//! Its gap is the height of the lowest point, by the support function of the ellipsoid. Its slip
//! velocity is that of the material point there. Both are formulas of the declaration. Spun in
//! one sense it goes on, in the other it rattles until it spins back.
//!
//! References are by `tools/rattleback.py`: equations of rolling without slipping in body axes.

use lagrange::Simulate;
use lagrange::contact::{Contact, Friction, Stepped};

use crate::{assert_near, distance};

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Rattleback;

    param mu = 2, low = 0.01;
    const a = 0.2, b = 0.03, c = 0.02;
    gravity = (0, 0, -9.81);
    body stone { mass: 1; centroid: (0, 0, -low); inertia: (2e-4, 1.6e-3, 1.7e-3, -2e-5, 0, 0); }
    free stone;
    // Half axes, squared, times the vertical in body axes.
    let up = ((0, 0, 1) in stone);
    let reach = sqrt(a^2 * up.x^2 + b^2 * up.y^2 + c^2 * up.z^2);
    let arm = stone.vector(-a^2 * up.x / reach, -b^2 * up.y / reach, -c^2 * up.z / reach);
    let slip = velocity(stone.origin) + cross(angular_velocity(stone), arm);
    event touch = stone.origin.z - reach, falling => impact(0);
    friction rub = (slip.x, slip.y), mu * touch;
    output vertical = up;
    output around = angular_velocity(stone).z;
}

/// Spin, time, vertical and angular velocity in body axes.
const REFERENCES: &str = include_str!("rattleback.csv");
const END: f64 = 8.0;

/// Returns the start of the references for this spin: tilted by half a degree, without slip.
fn spun(spin: f64) -> [f64; 13] {
    let tilt = 0.5_f64.to_radians();
    let (sin, cos) = tilt.sin_cos();
    let reach = (0.03 * sin).hypot(0.02 * cos);
    let slip = spin * 0.03 * 0.03 * sin / reach;
    let (half, real) = (0.5 * tilt).sin_cos();
    [0.0, 0.0, reach, real, half, 0.0, 0.0, -slip, 0.0, 0.0, 0.0, 0.0, spin]
}

/// Returns times and states of the references for this spin.
fn references(spin: f64) -> Vec<(f64, [f64; 6])> {
    let numbers = |row: &str| row.split(',').map(|word| word.parse().expect("a number")).collect::<Vec<_>>();
    let rows = REFERENCES.lines().skip(1).map(numbers).filter(|row: &Vec<f64>| row[0] == spin);
    let rows = rows.map(|row| (row[1], std::array::from_fn(|i| row[2 + i]))).collect::<Vec<_>>();
    assert_eq!(rows.len(), 17);
    rows
}

#[test]
fn it_spins_back_in_one_sense_only_as_equations_of_rolling_tell() {
    let ends = [5.0, -5.0].map(|spin| {
        let stone = Rattleback::default();
        let run = stone.simulate(spun(spin)).until(END).every(0.5).tolerance(1e-12).outputs().energy();
        let run = run.run().expect("it rolls");
        let energy = run.column("energy").expect("recorded");
        assert!(distance(energy, &vec![energy[0]; energy.len()]) < 1e-10 * energy[0]);
        let modes = run.system_at_end().map(|stone| (stone.touch, stone.rub));
        assert_eq!(modes, Some((Contact::Closed, Friction::Sticks)));
        let column = |name: &str| run.column(name).expect("recorded");
        let vertical = ["vertical.x", "vertical.y", "vertical.z"].map(column);
        for (k, ((t, y), (time, wanted))) in run.iter().zip(references(spin)).enumerate() {
            assert!((t - time).abs() < 1e-12);
            assert_near(&vertical.map(|column| column[k]), &wanted[..3], 1e-8);
            assert_near(&y[10..], &wanted[3..], 1e-7);
        }
        run.last()[12]
    });
    assert!(ends[0] > 4.9 && ends[1] > 4.9, "{ends:?}");
}

/// Steps treat the point of contact and gyroscopic moments explicitly, so that rattling gains
/// energy in proportion to the step.
#[test]
fn steps_converge_to_it_at_first_order() {
    let wanted = references(-5.0)[3];
    let errors = [2e-4, 1e-4, 5e-5].map(|h| {
        let stone = Rattleback::default();
        let run = stone.simulate(spun(-5.0)).until(wanted.0).method(Stepped::every(h)).energy();
        let run = run.run().expect("it rolls");
        let energy = run.column("energy").expect("recorded");
        [distance(&run.last()[10..], &wanted.1[3..]), energy[energy.len() - 1] - energy[0]]
    });
    for pair in errors.windows(2) {
        for (coarse, fine) in pair[0].iter().zip(pair[1]) {
            assert!((1.8..2.3).contains(&(coarse / fine)), "first order: {errors:?}");
        }
    }
}
