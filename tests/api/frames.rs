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

lagrange::system! {
    /// A diver whose arm turns about any axis in the shoulder.
    #[derive(Clone, Debug)]
    struct Diver;

    gravity = (0, 0, -9.81);
    body trunk { mass: 60; inertia: (12, 11, 1.5); }
    body arm { mass: 4; inertia: (0.2, 0.2, 0.01); centroid: (0, 0, -0.3); }
    frame hand;
    free trunk;
    ball shoulder = trunk to arm { at: (0.1, 0.2, 0.4); }
    revolute wrist = arm to hand { at: (0, 0, -0.6); axis: (0, 1, 0); damping: 0.1; }
    potential = 10 * wrist^2;
    body palm { mass: 0.5; shape: solid_sphere(0.05); }
    weld hand to palm { at: (0, 0, -0.1); }
    output alpha = angular_acceleration(palm);
    output a = acceleration(palm.origin);
    emit { frame_jacobians }
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
fn bias_accelerations_complete_jacobians() {
    let arm = Arm::<f64>::default();
    let twist = |q: &[f64; 2], v: &[f64; 2]| arm.tool_jacobian(0.0, q).map(|[a, b]| a * v[0] + b * v[1]);
    let bias = arm.tool_bias_acceleration(0.0, &Q, &V);
    let a = arm.acceleration(0.0, &Q, &V);
    let completed = |jacobian: [[f64; 2]; 6], bias: [f64; 6]| -> [f64; 6] {
        std::array::from_fn(|row| jacobian[row][0] * a[0] + jacobian[row][1] * a[1] + bias[row])
    };
    assert_near(completed(arm.tool_jacobian(0.0, &Q), bias), rate(twist), 1e-9);
    let motion = arm.rod_motion(0.0, &Q, &V);
    let rod = completed(arm.rod_jacobian(0.0, &Q), arm.rod_bias_acceleration(0.0, &Q, &V));
    assert_near([rod[0], rod[1], rod[2]], motion.angular_acceleration, 1e-14);
    assert_near([rod[3], rod[4], rod[5]], motion.acceleration_of([0.0; 3]), 1e-14);
    // ω₁ × ω₂, then the Coriolis and centripetal accelerations of the tool.
    let ((sin, cos), (lift_sin, lift_cos)) = (Q[0].sin_cos(), Q[1].sin_cos());
    let along = 2.0 * V[0] * V[1] * lift_cos;
    let inwards = (V[0] * V[0] + V[1] * V[1]) * lift_sin;
    let expected = [-along * sin - inwards * cos, along * cos - inwards * sin, -V[1] * V[1] * lift_cos];
    assert_near([bias[0], bias[1], bias[2]], [-V[0] * V[1] * cos, -V[0] * V[1] * sin, 0.0], 1e-15);
    assert_near([bias[3], bias[4], bias[5]], expected.map(|part| 0.8 * part), 1e-15);
    assert_eq!(arm.tool_bias_acceleration(0.0, &Q, &[0.0; 2]), [0.0; 6]);
}

/// The velocities of the trunk and of the shoulder are components along turning axes, and no rates.
#[test]
fn bias_accelerations_hold_for_orientations() {
    let (diver, half) = (Diver, 0.5_f64);
    let q = [0.3, -0.2, 4.0, half, -half, half, half, 0.1, 0.7, -0.5, half, 0.4];
    let v = [0.5, -0.25, 0.75, 1.0, -1.25, 0.5, 2.0, -0.75, 1.5, -0.5];
    let bias = diver.palm_bias_acceleration(0.0, &q, &v);
    let times = |q: &[f64; 12], by: &[f64; 10]| {
        diver.palm_jacobian(0.0, q).map(|row| row.iter().zip(by).map(|(entry, by)| entry * by).sum::<f64>())
    };
    let whole = times(&q, &diver.acceleration(0.0, &q, &v));
    let [x, y, z] = diver.a(0.0, &q, &v);
    let [alpha_x, alpha_y, alpha_z] = diver.alpha(0.0, &q, &v);
    let found: [f64; 6] = std::array::from_fn(|row| whole[row] + bias[row]);
    assert_near(found, [alpha_x, alpha_y, alpha_z, x, y, z], 1e-12);
    let rates = diver.position_rates(0.0, &q, &v);
    let [behind, ahead] =
        [-1e-5, 1e-5].map(|step: f64| times(&std::array::from_fn(|i| q[i] + step * rates[i]), &v));
    assert_near(std::array::from_fn(|row| (ahead[row] - behind[row]) / 2e-5), bias, 1e-8);
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
