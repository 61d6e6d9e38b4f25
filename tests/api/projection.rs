//! Motions of declared systems stay on their constraints, from starts that satisfy these.

use lagrange::Simulate;
use lagrange::constraint::{Unprojected, Violated, Violation};
use lagrange::integrate::{RungeKutta4, StepFailure, Verner98, integrate};

lagrange::system! {
    /// A point mass on a rod that a motor swings.
    #[derive(Clone, Debug)]
    struct Driven;

    param g = 9.81, l = 0.5, w = 2.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint length = x^2 + y^2 - l^2;
    constraint motor = x - l * sin(w * t);
}

lagrange::system! {
    /// A point mass on a rod whose constraint is stabilised.
    #[derive(Clone, Debug)]
    struct Stabilised;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint rod = x^2 + y^2 - 1;
    stabilise = 5;
}

lagrange::system! {
    /// Three equal cranks that carry a coupler; one of them is redundant.
    #[derive(Clone, Debug)]
    struct Parallelogram;

    param j = 0.2, m = 1.5, g = 9.81;
    coord a, b, c, x, y, phi;
    kinetic = 1/2 * j * (dot(a)^2 + dot(b)^2 + dot(c)^2) + 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/5 * dot(phi)^2;
    potential = m * g * y;
    constraint x1 = x - cos(phi) + 1 - cos(a);
    constraint y1 = y - sin(phi) - sin(a);
    constraint x2 = x - cos(b);
    constraint y2 = y - sin(b);
    constraint x3 = x + cos(phi) - 1 - cos(c);
    constraint y3 = y + sin(phi) - sin(c);
}

lagrange::system! {
    /// The cranks and the coupler as a single body.
    struct Crank;

    param inertia = 2.1, moment = 9.81 * 1.5;
    coord a;
    kinetic = 1/2 * inertia * dot(a)^2;
    potential = moment * sin(a);
}

/// Returns the cranks at an angle, turning at a rate.
fn cranks(a: f64, rate: f64) -> [f64; 12] {
    let (sine, cosine) = a.sin_cos();
    [a, a, a, cosine, sine, 0.0, rate, rate, rate, -rate * sine, rate * cosine, 0.0]
}

#[test]
fn a_start_off_the_constraints_is_refused_by_name_with_what_is_left_of_them() {
    let rod = Driven::default();
    let refused = |start: [f64; 4]| {
        let method = Verner98::tolerance(1e-9);
        let failed = integrate(&rod, 0.0, start, 1.0, &method, |_, _| {}).expect_err("refused");
        assert_eq!(failed.state, start);
        let again = rod.simulate(start).until(1.0).run().expect_err("refused");
        assert_eq!(again.cause, failed.cause);
        failed.cause
    };
    let wanted = Violation { constraint: "length", residual: 0.36 - 0.25, of: Violated::Positions };
    assert_eq!(refused([0.0, -0.6, 1.0, 0.0]), StepFailure::Violated(wanted));
    let wanted = Violation { constraint: "motor", residual: -1.0, of: Violated::Velocities };
    assert_eq!(refused([0.0, -0.5, 0.0, 0.0]), StepFailure::Violated(wanted));
    assert_eq!(
        wanted.to_string(),
        "the velocities violate the constraint `motor`, which is -1.0 instead of 0"
    );
}

#[test]
fn a_start_that_is_nearly_right_is_mended_and_a_consistent_velocity_can_be_had() {
    let rod = Driven::default();
    let q = [0.0, -0.5];
    let v = rod.consistent_velocity(0.0, &q, &[0.0; 2]).expect("the motor demands one");
    assert_eq!(v, [1.0, 0.0]);
    let start = [1e-9, -0.5, v[0], v[1] + 1e-8];
    let mut largest = 0.0_f64;
    let end = integrate(&rod, 0.0, start, 0.7, &RungeKutta4 { step: 0.01 }, |t, y| {
        let residuals = rod.constraints(t, &[y[0], y[1]], &[y[2], y[3]]);
        largest = residuals.iter().fold(largest, |most, residual| most.max(residual.abs()));
    })
    .expect("follows the motor");
    assert!(largest < 1e-15, "{largest}");
    assert!(
        (end[0] - 0.5 * 1.4_f64.sin()).abs() < 1e-15 && (end[2] - 1.4_f64.cos()).abs() < 1e-14,
        "{end:?}"
    );
}

#[test]
fn a_start_must_satisfy_stabilised_constraints_too_and_those_that_are_not_projected() {
    let method = RungeKutta4 { step: 0.01 };
    let off = [1.1, 0.0, 0.0, 1.0];
    let failed = integrate(&Stabilised {}, 0.0, off, 1.0, &method, |_, _| {}).expect_err("refused");
    assert!(matches!(failed.cause, StepFailure::Violated(Violation { constraint: "rod", .. })), "{failed}");
    let failed =
        integrate(&Unprojected(Stabilised {}), 0.0, off, 1.0, &method, |_, _| {}).expect_err("refused");
    assert!(matches!(failed.cause, StepFailure::Violated(Violation { constraint: "rod", .. })), "{failed}");
}

#[test]
fn a_loop_with_a_crank_too_many_turns_all_around() {
    let start = cranks(0.4, 7.0);
    let method = Verner98::tolerance(1e-9);
    let [angle, rate] =
        integrate(&Crank::default(), 0.0, [0.4, 7.0], 3.0, &Verner98::tolerance(1e-13), |_, _| {})
            .expect("turns");
    let end = integrate(&Parallelogram::default(), 0.0, start, 3.0, &method, |_, _| {}).expect("turns");
    assert!(angle > 3.0 * std::f64::consts::TAU, "{angle}");
    for (found, wanted) in end.into_iter().zip(cranks(angle, rate)) {
        assert!((found - wanted).abs() < 1e-7, "{found} for {wanted}");
    }
}

lagrange::system! {
    /// A point mass in polar coordinates on the line x = d.
    #[derive(Clone, Debug)]
    struct Polar;

    param m = 3.0, d = 1.0;
    coord r, theta;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(theta)^2);
    constraint line = r * cos(theta) - d;
}

lagrange::system! {
    /// A point mass on an ellipse.
    #[derive(Clone, Debug)]
    struct Ellipse<S>;

    param m = 1.0, a = 2.0, b = 1/2, rest = 1.0;
    coord x, y;
    kinetic = kinetic_energy(m, dot((x, y)));
    constraint ellipse = (x / a)^2 + (y / b)^2 - rest;
    emit { no momenta, no mass_matrix, no energy }
}

#[test]
fn the_way_to_the_projected_state_is_normal_to_the_constraint_by_the_mass_there() {
    let polar = Polar::default();
    for (r, theta) in [(3.0, 0.4), (0.5, -0.9), (2.0, 1.2), (1.5, 0.1)] {
        let (mut q, mut v) = ([r, theta], [0.3, -0.2]);
        polar.project(0.0, &mut q, &mut v).expect("a line can be reached");
        let (sin, cos) = q[1].sin_cos();
        assert!((q[0] * cos - 1.0).abs() < 1e-14, "{q:?}");
        // M δ beside the gradient (cos θ, −r sin θ).
        let product = (q[0] - r) * -q[0] * sin - q[0] * q[0] * (q[1] - theta) * cos;
        assert!(product.abs() < 1e-12, "{product} at {q:?} from {r}, {theta}");
        assert!((v[0] * cos - q[0] * sin * v[1]).abs() < 1e-14);
    }
}

lagrange::system! {
    /// A body in space, one point of which is held.
    struct Held;

    param m = 2, a = 0.03, b = 0.04, c = 0.02;
    body load { mass: m; inertia: (a, b, c); }
    free load;
    pin hook = load.point(0.05, 0.1, 0.3) to (0, 0, 0);
    emit { no momenta, no mass_matrix, no energy }
}

const HELD_POINT: [f64; 3] = [0.05, 0.1, 0.3];

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

/// Rotates a vector by a unit quaternion.
fn rotated([w, x, y, z]: [f64; 4], vector: [f64; 3]) -> [f64; 3] {
    let (axis, along) = ([x, y, z], cross([x, y, z], vector));
    let twice = cross(axis, along);
    std::array::from_fn(|k| vector[k] + 2.0 * (w * along[k] + twice[k]))
}

/// Returns the products of M δ with the turns about the held point: for the axis e, its origin
/// moves by −R (e × p). The imaginary part of q̄₀ ⊗ q is half of the turn δ.
fn along_turns(held: &Held, from: [f64; 7], to: [f64; 7]) -> [f64; 3] {
    let [origin, start] = [to, from].map(|[x, y, z, ..]| [x, y, z]);
    let [[w, x, y, z], [w0, x0, y0, z0]] = [to, from].map(|[.., w, x, y, z]| [w, x, y, z]);
    let apart = cross([x0, y0, z0], [x, y, z]);
    let turn = [(x, x0, 0), (y, y0, 1), (z, z0, 2)].map(|(x, x0, k)| 2.0 * (w0 * x - w * x0 - apart[k]));
    std::array::from_fn(|k| {
        let axis = std::array::from_fn(|j| f64::from(u8::from(j == k)));
        let way = rotated([w, x, y, z], cross(axis, HELD_POINT));
        let product = (0..3).map(|j| -held.m * way[j] * (origin[j] - start[j])).sum::<f64>();
        product + [held.a, held.b, held.c][k] * turn[k]
    })
}

/// From 1 mm, 1 cm and 10 cm away; a body that cannot be turned would miss the point by as much.
#[test]
fn bodies_end_normal_to_the_turns_that_their_constraints_allow() {
    let held = Held::default();
    for distance in [1e-3, 1e-2, 0.1] {
        let unit = rotated([0.5, 0.5, -0.5, 0.5], HELD_POINT);
        let from: [f64; 7] =
            [distance - unit[0], 0.7 * distance - unit[1], -0.4 * distance - unit[2], 0.5, 0.5, -0.5, 0.5];
        let (mut q, mut v) = (from, [0.0; 6]);
        held.project(0.0, &mut q, &mut v).expect("the point can be reached");
        let [x, y, z, quaternion @ ..] = q;
        let point = rotated(quaternion, HELD_POINT);
        assert!([x + point[0], y + point[1], z + point[2]].iter().all(|apart| apart.abs() < 1e-15), "{q:?}");
        let products = along_turns(&held, from, q);
        assert!(products.iter().all(|product| product.abs() < 1e-15), "{distance}: {products:?}");
    }
}

#[test]
fn a_point_far_from_an_ellipse_is_projected_to_its_nearest_point() {
    let ellipse = Ellipse::<f64>::default();
    let (p, mut v) = ([1.5, 1.0], [0.0; 2]);
    let mut q = p;
    ellipse.project(0.0, &mut q, &mut v).expect("an ellipse can be reached");
    // No other point of the ellipse is nearer.
    let square = |q: [f64; 2]| (q[0] - p[0]).powi(2) + (q[1] - p[1]).powi(2);
    let points = (0..100_000).map(|k| {
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 1e5).sin_cos();
        square([2.0 * cos, 0.5 * sin])
    });
    let least = points.fold(f64::INFINITY, f64::min);
    assert!((0.0..1e-8).contains(&(least - square(q))), "{least} {q:?}");
    // (q − p) beside the gradient.
    let product = (q[0] - p[0]) * q[1] / 0.25 - (q[1] - p[1]) * q[0] / 4.0;
    assert!(product.abs() < 1e-13, "{product}");
    let (mut single, mut rest) = ([1.5_f32, 1.0], [0.0; 2]);
    Ellipse::<f32>::default().project(0.0, &mut single, &mut rest).expect("the same");
    assert!((f64::from(single[0]) - q[0]).abs() < 1e-5 && (f64::from(single[1]) - q[1]).abs() < 1e-5);
}

#[test]
fn unsatisfiable_constraints_change_nothing() {
    let nothing = Ellipse { rest: -1.0, ..Ellipse::<f64>::default() };
    let (mut q, mut v) = ([1.5, 1.0], [0.1, 0.2]);
    let violation = nothing.project(0.0, &mut q, &mut v).expect_err("no point at all");
    assert_eq!((violation.constraint, q, v), ("ellipse", [1.5, 1.0], [0.1, 0.2]));
}
