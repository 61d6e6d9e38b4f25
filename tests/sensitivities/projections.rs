//! Gradients backwards through projections onto constraints and of unit quaternions.

use lagrange::Simulate;
use lagrange::integrate::{RungeKutta4, Verner98};
use lagrange::system::{OdeSystem, ParametricSystem};

use crate::beside::compare_with_differences;

lagrange::system! {
    /// A pendulum in Cartesian coordinates.
    #[derive(Clone, Debug)]
    struct Rod<S>;
    param l = 1.0, g = 9.81, c = 0.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    dissipation = 1/2 * c * (dot(x)^2 + dot(y)^2);
    constraint length = x^2 + y^2 - l^2;
    emit { jacobian }
}

/// Returns the first position, and its slope.
macro_rules! first {
    () => {
        |_, y, slope| {
            slope[0] = 1.0;
            y[0]
        }
    };
}

/// Returns the sum of half the squares of all entries, and its slope.
fn energy<const N: usize>(_: f64, y: &[f64; N], slope: &mut [f64; N]) -> f64 {
    *slope = *y;
    y.iter().map(|entry| 0.5 * entry * entry).sum()
}

/// Released at rest, the angle is a function of t √(g/l): ∂φ/∂g = φ̇ t/(2 g), ∂φ/∂l = −φ̇ t/(2 l).
/// The start moves along the rod when its length changes.
#[test]
fn a_pendulum_in_cartesian_coordinates_has_the_slopes_of_its_scales() {
    let rod = Rod::<f64>::default();
    let start = [0.6, -0.8, 0.0, 0.0];
    for t in [0.3, 2.0, 5.0] {
        let run = || rod.simulate(start).until(t).tolerance(1e-12);
        let [x, y, u, v] = run().run().expect("a motion").last();
        let gradient = run().gradient(["g", "l"], first!()).expect("a gradient");
        // x = l sin φ, y = −l cos φ
        let rate = (u * -y + v * x) / rod.l / rod.l;
        let by_angle = -y;
        let wanted = [by_angle * rate * t / (2.0 * rod.g), x / rod.l - by_angle * rate * t / (2.0 * rod.l)];
        for (found, wanted) in gradient.by.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-10, "{t}: {found} {wanted}");
        }
        // A start off the circle is brought back.
        let [x, y, ..] = start;
        assert!((x * gradient.by_start[0] + y * gradient.by_start[1]).abs() < 1e-10);
    }
}

#[test]
fn constraints_turn_adjoints_as_forward_derivatives() {
    let rod = Rod::<f64> { c: 0.2, ..Rod::default() };
    let run = || rod.simulate([0.6, -0.8, 0.4, 0.3]).until(3.0).every(0.4).tolerance(1e-13);
    compare!(run(), ["l", "g", "c"], ["x", "y", "x_dot", "y_dot"], 1e-9);
}

/// Steps are long, so that projections change the states noticeably.
#[test]
fn the_projection_itself_is_differentiated() {
    let rod = Rod::<f64>::default();
    let names = ["l", "g", "c"];
    for step in [0.02, 0.1] {
        let cost = |rod: &Rod<f64>| {
            let scale = rod.l / 1.0;
            let start = [0.6 * scale, -0.8 * scale, 0.0, 0.0];
            let run = rod.simulate(start).until(2.0).every(0.5).method(RungeKutta4 { step });
            run.run().expect("a motion").states().map(|y| energy(0.0, &y, &mut [0.0; 4])).sum()
        };
        let run = rod.simulate([0.6, -0.8, 0.0, 0.0]).until(2.0).every(0.5).method(RungeKutta4 { step });
        let gradient = run.gradient(names, energy).expect("a gradient");
        compare_with_differences(&rod, &names, &gradient, cost, 1e-9);
    }
}

#[test]
fn no_steps_leave_the_projection_of_the_start() {
    let rod = Rod::<f64>::default();
    let gradient = rod.simulate([0.6, -0.8, 0.4, 0.3]).until(0.0).gradient(["l", "g"], first!()).unwrap();
    assert_eq!((gradient.value, gradient.steps), (0.6, 0));
    assert!((gradient.by[0] - 0.6).abs() < 1e-11 && gradient.by[1].abs() < 1e-11);
    // The tangential part of the direction of x.
    let wanted = [0.64, 0.48, 0.0, 0.0];
    for (found, wanted) in gradient.by_start.iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-11, "{:?}", gradient.by_start);
    }
}

#[test]
fn single_precision_has_projected_gradients() {
    let run = || {
        Rod::<f64>::default()
            .simulate([0.6, -0.8, 0.0, 0.0])
            .until(1.0)
            .tolerance(1e-11)
            .gradient(["g", "l"], first!())
    };
    let small = Rod::<f32>::default();
    let gradient = small.simulate([0.6, -0.8, 0.0, 0.0]).until(1.0).gradient(["g", "l"], first!()).unwrap();
    for (found, wanted) in gradient.by.iter().zip(run().unwrap().by) {
        assert!((f64::from(*found) - wanted).abs() < 1e-3, "{found} {wanted}");
    }
}

lagrange::system! {
    /// A pendulum whose length is fixed twice.
    #[derive(Clone, Debug)]
    struct Twice;
    param l = 1.0, g = 9.81, c = 0.1;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    dissipation = 1/2 * c * (dot(x)^2 + dot(y)^2);
    constraint length = x^2 + y^2 - l^2;
    constraint again = hypot(x, y) - l;
}

/// Without emitted derivatives.
#[test]
fn redundant_constraints_have_the_gradient_of_the_independent_one() {
    let start = [0.6, -0.8, 0.4, 0.3];
    let (rod, twice) = (Rod::<f64> { c: 0.1, ..Rod::default() }, Twice::default());
    let method = Verner98::tolerance(1e-11);
    let one = rod.simulate(start).until(1.0).method(method).gradient(["l", "g", "c"], energy).unwrap();
    let two = twice.simulate(start).until(1.0).method(method).gradient(["l", "g", "c"], energy).unwrap();
    assert!((one.value - two.value).abs() < 1e-10);
    for (one, two) in one.by.iter().zip(&two.by).chain(one.by_start.iter().zip(&two.by_start)) {
        assert!((one - two).abs() < 1e-8, "{one} {two}");
    }
}

lagrange::system! {
    /// Two rods of equal length that hold a plate: with different lengths the mechanism cannot
    /// move.
    #[derive(Clone, Debug)]
    struct Apart;
    param l = 1.0, other = 1.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 9.81 * y;
    constraint length = x^2 + y^2 - l^2;
    constraint again = hypot(x, y) - other;
}

#[test]
fn constraints_that_contradict_each_other_have_no_gradient() {
    let apart = Apart::default();
    let run = apart.simulate([0.6, -0.8, 0.0, 0.0]).until(1.0);
    let refusal = run.gradient(["other"], first!()).expect_err("contradiction").to_string();
    assert!(refusal.contains("projection"), "{refusal}");
}

lagrange::system! {
    /// A sleigh on a blade, on a slope, with its centre of mass ahead of the blade.
    #[derive(Clone, Debug)]
    struct Sleigh;
    param m = 1.5, j = 0.3, a = 0.4, slope = 1.0;
    coord x, y, phi;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/2 * j * dot(phi)^2;
    potential = m * slope * y;
    constraint blade = dot(y) * cos(phi) - dot(x) * sin(phi) - a * dot(phi);
    emit { jacobian }
}

#[test]
fn constraints_on_velocities_turn_adjoints() {
    let sleigh = Sleigh::default();
    let (phi, turn) = (0.3_f64, 0.7);
    // Along the blade with speed one, turning about it.
    let start = [
        0.0,
        0.0,
        phi,
        phi.cos() - sleigh.a * turn * phi.sin(),
        phi.sin() + sleigh.a * turn * phi.cos(),
        turn,
    ];
    let run = || sleigh.simulate(start).until(2.0).every(0.5).tolerance(1e-13);
    let states = ["x", "y", "phi", "x_dot", "y_dot", "phi_dot"];
    compare!(run(), ["m", "j", "a", "slope"], states, 1e-9);
}

lagrange::system! {
    /// A free symmetric body in space.
    #[derive(Clone, Debug)]
    struct Top;
    param a = 0.02, c = 0.03;
    body top { mass: 1; inertia: (a, a, c); }
    free top;
    emit { jacobian }
}

/// The angular velocity precesses: ω = (Ω cos λ t, Ω sin λ t, ω₃) in axes of the body, with λ = (c
/// − a) ω₃/a.
#[test]
fn a_free_symmetric_body_has_the_slopes_of_its_precession() {
    let top = Top::default();
    let start: [f64; 13] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 5.0];
    let t = 3.0;
    let cost = |_: f64, y: &[f64; 13], slope: &mut [f64; 13]| {
        slope[10] = 1.0;
        y[10]
    };
    let gradient = top.simulate(start).until(t).tolerance(1e-12).gradient(["a", "c"], cost).unwrap();
    let angle = (top.c - top.a) / top.a * 5.0 * t;
    assert!((gradient.value - 2.0 * angle.cos()).abs() < 1e-9);
    let wanted = [top.c / top.a / top.a, -1.0 / top.a].map(|rate| 2.0 * angle.sin() * rate * 5.0 * t);
    for (found, wanted) in gradient.by.iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-8 * wanted.abs(), "{found} {wanted}");
    }
    let by_rate = -2.0 * angle.sin() * angle / 5.0;
    assert!((gradient.by_start[12] - by_rate).abs() < 1e-8, "{} {by_rate}", gradient.by_start[12]);
    assert!((gradient.by_start[10] - angle.cos()).abs() < 1e-9);
}

/// About the axis of symmetry the orientation is (cos ω t/2, 0, 0, sin ω t/2), and its length has
/// no effect.
#[test]
fn an_orientation_has_the_slopes_of_its_angle() {
    let top = Top::default();
    let start: [f64; 13] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0];
    let cost = |_: f64, y: &[f64; 13], slope: &mut [f64; 13]| {
        slope[3] = 1.0;
        y[3]
    };
    let gradient = top.simulate(start).until(1.5).tolerance(1e-12).gradient(["a", "c"], cost).unwrap();
    assert!((gradient.value - 1.5_f64.cos()).abs() < 1e-10);
    assert!(gradient.by.iter().all(|by| by.abs() < 1e-9), "{:?}", gradient.by);
    let by_start = &gradient.by_start;
    assert!((by_start[12] + 0.75 * 1.5_f64.sin()).abs() < 1e-10, "{by_start:?}");
    assert!(by_start[3].abs() < 1e-10 && (by_start[6] + 1.5_f64.sin()).abs() < 1e-10, "{by_start:?}");
}

lagrange::system! {
    /// A cart on a spring, with a pendulum on a ball joint.
    #[derive(Clone, Debug)]
    struct Crane;
    param k = 20.0, load_mass = 1.0;
    gravity = (0, 0, -9.81);
    body cart { mass: 2; inertia: (0.1, 0.1, 0.1); }
    prismatic s = ground to cart { axis: (1, 0, 0); }
    potential = spring_energy(k, s);
    body load { mass: load_mass; centroid: (0.02, 0, -0.5); inertia: (0.1, 0.105, 0.01, 0.002, 0, 0); }
    ball hook = cart to load { at: (0, 0, -0.1); damping: 0.05; }
    emit { jacobian }
}

const CRANE: [f64; 9] = [0.1, 0.8, 0.6, 0.0, 0.0, 0.2, 0.3, -0.4, 0.5];

#[test]
fn orientations_turn_adjoints_as_forward_derivatives() {
    let crane = Crane::default();
    let run = || crane.simulate(CRANE).until(2.0).every(0.5).tolerance(1e-13);
    compare!(run(), ["k", "load_mass"], ["s", "s_dot", "hook_wx"], 1e-9);
}

#[test]
fn the_normalisation_itself_is_differentiated() {
    let crane = Crane::default();
    let run = |crane: &Crane| {
        crane.clone().simulate(CRANE).until(1.0).method(RungeKutta4 { step: 0.05 }).run().unwrap().last()
    };
    let simulation = crane.simulate(CRANE).until(1.0).method(RungeKutta4 { step: 0.05 });
    let gradient = simulation.gradient(["k", "load_mass"], energy).expect("a gradient");
    let cost = |crane: &Crane| energy(0.0, &run(crane), &mut [0.0; 9]);
    compare_with_differences(&crane, &["k", "load_mass"], &gradient, cost, 1e-10);
}

lagrange::system! {
    /// A body in space, one point of which is held.
    #[derive(Clone, Debug)]
    struct Held;
    param m = 2.0, long = 0.3, a = 0.03, pull = 9.81;
    gravity = (0, 0, -pull);
    body load { mass: m; inertia: (a, 0.04, 0.02); }
    free load;
    pin hook = load.point(0.05, 0.1, long) to (0, 0, 0);
    emit { jacobian }
}

/// Returns a start at rest in translation, which turns about the held point.
fn held_start(held: &Held) -> [f64; 13] {
    let point = [0.05, 0.1, held.long];
    let turn = [1.5, -0.7, 2.0];
    let cross = |k: usize| turn[(k + 1) % 3] * point[(k + 2) % 3] - turn[(k + 2) % 3] * point[(k + 1) % 3];
    let ([x, y, z], [u, v, w]) = (point, [0, 1, 2].map(cross));
    [-x, -y, -z, 1.0, 0.0, 0.0, 0.0, -u, -v, -w, 1.5, -0.7, 2.0]
}

/// Forward derivatives begin with differences of a search for the nearest positions.
#[test]
fn constraints_on_orientations_turn_adjoints() {
    let held = Held::default();
    let run = || held.simulate(held_start(&held)).until(1.0).every(0.25).tolerance(1e-13);
    let states = ["load_x", "load_qx", "load_vy", "load_wz"];
    compare!(run(), ["m", "long", "a", "pull"], states, 1e-9);
}

/// Steps are long, so that corrections depend on the state noticeably.
#[test]
fn corrections_of_orientations_are_differentiated() {
    let held = Held::default();
    let start = held_start(&held);
    for step in [0.005, 0.05] {
        let run = |held: &Held| {
            let run = held.clone().simulate(start).until(1.0).method(RungeKutta4 { step }).run();
            run.expect("a motion").last()
        };
        let gradient =
            held.simulate(start).until(1.0).method(RungeKutta4 { step }).gradient(["m", "a", "pull"], energy);
        let cost = |held: &Held| energy(0.0, &run(held), &mut [0.0; 13]);
        compare_with_differences(&held, &["m", "a", "pull"], &gradient.expect("a gradient"), cost, 1e-9);
    }
}

/// The projection of a state near the circle, by the definition of derivatives.
#[test]
fn adjoints_of_projections_are_those_of_small_corrections() {
    let rod = Rod::<f64>::default();
    let after = [0.3, -0.5, 0.7, 0.2];
    let projected = |rod: &Rod<f64>, mut y: [f64; 4]| {
        rod.correct(0.0, &mut y).expect("a projection");
        y.iter().zip(after).map(|(entry, slope)| entry * slope).sum::<f64>()
    };
    for (off, tolerance) in [(0.0, 1e-11), (1e-7, 1e-11), (4e-6, 1e-10)] {
        let near = [0.6 + off, -0.8, 0.4 + 0.1 * off, 0.3 - 1e3 * off];
        let (mut slope, mut by) = (after, [9.0; 2]);
        assert!(rod.correct_adjoint(0.0, &near, &mut slope, &[0, 1], &mut by));
        let central = |change: &dyn Fn(f64) -> f64| {
            let [wide, narrow] = [2e-3, 1e-3].map(|h| (change(h) - change(-h)) / (2.0 * h));
            (4.0 * narrow - wide) / 3.0
        };
        for entry in 0..4 {
            let wanted = central(&|h| {
                let mut moved = near;
                moved[entry] += h;
                projected(&rod, moved)
            });
            assert!((slope[entry] - wanted).abs() < tolerance, "{off} {entry}: {} {wanted}", slope[entry]);
        }
        let wanted = central(&|h| projected(&Rod { l: rod.l + h, ..rod.clone() }, near));
        assert!((by[0] - wanted).abs() < tolerance && by[1] == 0.0, "{off}: {by:?} {wanted}");
    }
    let mut slope = after;
    assert!(!rod.correct_adjoint(0.0, &[0.601, -0.8, 0.4, 0.3], &mut slope, &[0], &mut [0.0]));
    assert_eq!(slope, after);
    assert!(!rod.correct_adjoint(0.0, &[0.0, 0.0, 0.4, 0.3], &mut slope, &[0], &mut [0.0]));
    assert!(!rod.correct_adjoint(0.0, &[0.6, f64::NAN, 0.4, 0.3], &mut slope, &[0], &mut [0.0]));
    assert_eq!(slope, after);
}
