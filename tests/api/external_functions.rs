//! Functions of the user's crate, called by emitted code.

use lagrange::integrate::RungeKutta4;
use lagrange::system::MechanicalSystem;
use lagrange::{Scalar, Simulate};

/// Returns y = x²/2 + cos x.
fn road<S: Scalar>(x: S) -> S {
    x * x * S::from_f64(0.5) + x.cos()
}

fn road_derivative<S: Scalar>(x: S) -> S {
    x - x.sin()
}

fn road_second_derivative<S: Scalar>(x: S) -> S {
    S::ONE - x.cos()
}

lagrange::system! {
    /// A bead on a road defined by the crate.
    #[derive(Clone, Debug)]
    struct Bead;
    function road(x);
    param m = 2, g = 9.81;
    coord x;
    kinetic = kinetic_energy(m, dot((x, road(x))));
    potential = m * g * road(x);
}

lagrange::system! {
    /// The bead with the formula of the road.
    #[derive(Clone, Debug)]
    struct Written;
    let road(x) = x^2 / 2 + cos(x);
    param m = 2, g = 9.81;
    coord x;
    kinetic = kinetic_energy(m, dot((x, road(x))));
    potential = m * g * road(x);
}

lagrange::system! {
    /// The bead in any number type.
    struct AnyBead<S>;
    function road(x) { derivative: road_derivative; second_derivative: road_second_derivative; }
    param m = 2, g = 9.81;
    coord x;
    kinetic = kinetic_energy(m, dot((x, road(x))));
    potential = m * g * road(x);
}

fn lift(alpha: f64, speed: f64) -> f64 {
    speed * speed * alpha.sin()
}

fn lift_slope(alpha: f64, speed: f64) -> f64 {
    speed * speed * alpha.cos()
}

fn lift_by_speed(alpha: f64, speed: f64) -> f64 {
    2.0 * speed * alpha.sin()
}

/// Computes a function with the name of a variable in emitted code.
fn vel_0(x: f64) -> f64 {
    x
}

lagrange::system! {
    /// A wing with a function of two arguments, with its Jacobian.
    struct Wing;
    function lift(alpha, speed) { by alpha: lift_slope; by speed: lift_by_speed; }
    function vel_0(x);
    function vel_0_derivative(x);
    param m = 3, k = 5;
    coord z, x;
    kinetic = kinetic_energy(m, dot((x, z)));
    force z = lift(-atan2(dot(z), dot(x)), hypot(dot(x), dot(z))) - k * vel_0(z);
    output twice = vel_0(z) * vel_0_derivative(x);
    emit { jacobian, no inverse_dynamics }
}

fn vel_0_derivative(_: f64) -> f64 {
    1.0
}

#[test]
fn a_function_of_the_crate_moves_as_its_formula_does() {
    let (bead, written, any) = (Bead::default(), Written::default(), AnyBead::<f64>::default());
    for (x, v) in [(0.0, 1.0), (0.7, -0.3), (-2.0, 4.0)] {
        let of_bead = bead.acceleration(0.0, &[x], &[v])[0];
        crate::assert_close(of_bead, written.acceleration(0.0, &[x], &[v])[0]);
        assert_eq!(any.acceleration(0.0, &[x], &[v]), [of_bead]);
        crate::assert_close(bead.energy(0.0, &[x], &[v]), written.energy(0.0, &[x], &[v]));
    }
    let after = bead.simulate([1.0, 0.0]).until(3.0).tolerance(1e-10).run().expect("a motion");
    let expected = written.simulate([1.0, 0.0]).until(3.0).tolerance(1e-10).run().expect("a motion");
    assert!((after.last()[0] - expected.last()[0]).abs() < 1e-9);
}

#[test]
fn single_precision_calls_the_same_function() {
    let single = AnyBead::<f32>::default().acceleration(0.0, &[0.7], &[-0.3])[0];
    let double = AnyBead::<f64>::default().acceleration(0.0, &[0.7], &[-0.3])[0];
    assert!((f64::from(single) - double).abs() < 1e-5, "{single} {double}");
}

#[test]
fn jacobians_go_through_functions_of_two_arguments() {
    let wing = Wing::default();
    let (q, v) = ([0.3, 0.1], [0.5, 7.0]);
    let jacobian = wing.jacobian(0.0, &[0.3, 0.1, 0.5, 7.0]);
    let h = 1e-6;
    for column in 0..4 {
        let at = |step: f64| {
            let (mut q, mut v) = (q, v);
            if column < 2 {
                q[column] += step;
            } else {
                v[column - 2] += step;
            }
            wing.acceleration(0.0, &q, &v)
        };
        let (after, before) = (at(h), at(-h));
        for row in 0..2 {
            let difference = (after[row] - before[row]) / (2.0 * h);
            let error = (jacobian[2 + row][column] - difference).abs();
            assert!(error < 1e-7, "{row} {column}: {} or {difference}", jacobian[2 + row][column]);
        }
    }
    assert_eq!(wing.twice(0.0, &q, &v), 0.3);
}

/// Returns depth^(3/2), undefined below zero.
fn three_halves(depth: f64) -> f64 {
    depth.powf(1.5)
}

fn five_thirds(speed: f64) -> f64 {
    speed.powf(5.0 / 3.0)
}

lagrange::system! {
    /// Balls that bounce on soft ground in air, and one between two walls.
    struct Bouncing;
    function three_halves(x);
    function five_thirds(x);
    param k = 1000, g = 9.81, c = 0.1, gap = 0.3;
    coord x, y, z;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    potential = g * (x + y);
    force x = if x < 0 { k * three_halves(-x) } else { 0 };
    force y = k * three_halves(max(0, -y)) - c * sign(dot(y)) * five_thirds(abs(dot(y)));
    force z = (if z > gap { -k * three_halves(z - gap) } else { 0 })
        + (if 2*z < -gap { k * three_halves(-gap - 2*z) } else { 0 });
}

lagrange::system! {
    /// The bouncing balls with the formulas.
    struct BouncingByFormulas;
    let three_halves(x) = x^(3/2);
    let five_thirds(x) = x^(5/3);
    param k = 1000, g = 9.81, c = 0.1, gap = 0.3;
    coord x, y, z;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    potential = g * (x + y);
    force x = if x < 0 { k * three_halves(-x) } else { 0 };
    force y = k * three_halves(max(0, -y)) - c * sign(dot(y)) * five_thirds(abs(dot(y)));
    force z = (if z > gap { -k * three_halves(z - gap) } else { 0 })
        + (if 2*z < -gap { k * three_halves(-gap - 2*z) } else { 0 });
}

/// Returns the end of a motion with many bounces, in adaptive and in equal steps.
fn ends<M: MechanicalSystem<Scalar = f64, State = [f64; 6]>>(system: &M) -> [[f64; 6]; 2] {
    let run = || system.simulate([0.5, 0.4, 0.0, 0.0, 0.1, 1.0]).until(3.0).ends_only();
    let adaptive = run().tolerance(1e-12).run().expect("adaptive steps cross");
    let fixed = run().method(RungeKutta4 { step: 1e-3 }).run().expect("equal steps cross");
    [adaptive.last(), fixed.last()]
}

#[test]
fn functions_without_values_beyond_a_surface_are_crossed() {
    let (called, written) = (ends(&Bouncing::default()), ends(&BouncingByFormulas::default()));
    for ((called, written), bound) in called.iter().zip(written).zip([1e-9, 1e-5]) {
        for (called, written) in called.iter().zip(written) {
            assert!((called - written).abs() < bound, "{called} for {written}");
        }
    }
}
