//! Motions, frames and Jacobians of bodies in space, by emitted code.

use lagrange::Scalar;
use lagrange::body::SpatialMotion;

lagrange::system! {
    /// A rod on a turning column, with a tool at its end.
    #[derive(Clone, Debug)]
    struct Arm<S>;

    param h = 0.3, l = 0.8;
    gravity = (0, 0, -9.81);
    body column { mass: 4; inertia: (0.2, 0.2, 0.1); centroid: (0, 0, h/2); }
    body rod { mass: 1.5; inertia: (0.08, 0.08, 0.001); centroid: (0, 0, l/2); }
    frame tool;
    revolute turn = ground to column { }
    revolute lift = column to rod { at: (0, 0, h); axis: (0, 1, 0); }
    weld rod to tool { at: (0, 0, l); turned: (pi/2, 0, 0); }
    output hand = tool.origin;
    output hand_velocity = velocity(tool.origin);
    emit { motion, frames, frame_jacobians }
}

const Q: [f64; 2] = [0.7, -0.4];
const V: [f64; 2] = [1.3, 0.6];

#[track_caller]
fn assert_near<const N: usize>(found: [f64; N], expected: [f64; N], tolerance: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{found} is not {expected}");
    }
}

/// Returns the rate along a motion of constant acceleration, by differences of fourth order.
fn rate<const N: usize>(f: impl Fn(&[f64; 2], &[f64; 2]) -> [f64; N]) -> [f64; N] {
    const STEP: f64 = 1e-3;
    let a = Arm::<f64>::default().acceleration(0.0, &Q, &V);
    let at = |t: f64| {
        let q = [0, 1].map(|i| Q[i] + t * (V[i] + 0.5 * t * a[i]));
        f(&q, &[0, 1].map(|i| V[i] + t * a[i]))
    };
    let [far_behind, behind, ahead, far_ahead] = [-2.0, -1.0, 1.0, 2.0].map(|k| at(k * STEP));
    std::array::from_fn(|i| (8.0 * (ahead[i] - behind[i]) - (far_ahead[i] - far_behind[i])) / (12.0 * STEP))
}

#[test]
fn frames_are_where_geometry_puts_them() {
    let arm = Arm::<f64>::default();
    let ((sin, cos), (sin_lift, cos_lift)) = (Q[0].sin_cos(), Q[1].sin_cos());
    let (rotation, origin) = arm.tool_frame(0.0, &Q);
    let along = [sin_lift * cos, sin_lift * sin, cos_lift];
    assert_near(origin, [0.8 * along[0], 0.8 * along[1], 0.3 + 0.8 * along[2]], 1e-15);
    // A quarter turn about x: its y-axis is the rod, its z-axis is opposite to the y-axis of the
    // rod.
    assert_near(rotation.map(|row| row[1]), along, 1e-15);
    assert_near(rotation.map(|row| row[2]), [sin, -cos, 0.0], 1e-15);
    assert_eq!(arm.column_frame(0.0, &Q).1, [0.0; 3]);
    assert_eq!(origin, arm.hand(0.0, &Q, &V));
}

#[test]
fn jacobians_times_velocities_are_velocities() {
    let arm = Arm::<f64>::default();
    let velocities = |jacobian: [[f64; 2]; 6]| jacobian.map(|row| row[0] * V[0] + row[1] * V[1]);
    let [.., x, y, z] = velocities(arm.tool_jacobian(0.0, &Q));
    assert_near([x, y, z], arm.hand_velocity(0.0, &Q, &V), 1e-15);
    for (jacobian, motion) in [
        (arm.column_jacobian(0.0, &Q), arm.column_motion(0.0, &Q, &V)),
        (arm.rod_jacobian(0.0, &Q), arm.rod_motion(0.0, &Q, &V)),
    ] {
        let [wx, wy, wz, x, y, z] = velocities(jacobian);
        assert_near([wx, wy, wz], motion.angular_velocity, 1e-15);
        assert_near([x, y, z], motion.velocity_of([0.0; 3]), 1e-15);
    }
    // Raising the rod does not move the column, exactly.
    assert!(arm.column_jacobian(0.0, &Q).iter().all(|row| row[1] == 0.0));
}

#[test]
fn motions_are_rates_of_each_other() {
    let arm = Arm::<f64>::default();
    let motion = arm.rod_motion(0.0, &Q, &V);
    let at = |q: &[f64; 2], v: &[f64; 2]| arm.rod_motion(0.0, q, v);
    assert_near(rate(|q, v| at(q, v).center), motion.velocity, 1e-9);
    assert_near(rate(|q, v| at(q, v).velocity), motion.acceleration, 1e-9);
    assert_near(rate(|q, v| at(q, v).angular_velocity), motion.angular_acceleration, 1e-9);
    let tip = [0.0, 0.0, 0.8];
    assert_near(rate(|q, v| at(q, v).point(tip)), motion.velocity_of(tip), 1e-9);
    assert_near(rate(|q, v| at(q, v).velocity_of(tip)), motion.acceleration_of(tip), 1e-9);
    assert_near(motion.point(tip), arm.hand(0.0, &Q, &V), 1e-15);
    let (rotation, origin) = arm.rod_frame(0.0, &Q);
    assert_eq!(motion.rotation, rotation);
    assert_near(motion.point([0.0; 3]), origin, 1e-15);
}

#[test]
fn energy_and_momentum_are_those_of_the_system() {
    let arm = Arm::<f64>::default();
    let motions = [arm.column_motion(0.0, &Q, &V), arm.rod_motion(0.0, &Q, &V)];
    let energy = motions.iter().map(SpatialMotion::kinetic_energy).sum::<f64>();
    assert_near([energy], [arm.kinetic_energy(0.0, &Q, &V)], 1e-14);
    // The generalised momentum of a rotation about a vertical axis is the angular momentum about
    // it.
    let momentum = motions.iter().map(|motion| motion.angular_momentum()[2]).sum::<f64>();
    assert_near([momentum], [arm.momenta(0.0, &Q, &V)[0]], 1e-14);
    let rate_of_momentum = rate(|q, v| {
        let motions = [arm.column_motion(0.0, q, v), arm.rod_motion(0.0, q, v)];
        [motions.iter().map(|motion| motion.angular_momentum()[2]).sum::<f64>()]
    });
    assert_near(rate_of_momentum, [0.0], 1e-9);
}

/// Returns the position of the tool in any scalar.
fn tool<S: Scalar>(arm: &Arm<S>) -> [S; 3] {
    arm.tool_frame(S::ZERO, &Q.map(S::from_f64)).1
}

#[test]
fn frames_are_generic_over_numbers() {
    let (double, single) = (tool(&Arm::<f64>::default()), tool(&Arm::<f32>::default()));
    assert_near(single.map(f64::from), double, 1e-6);
}
