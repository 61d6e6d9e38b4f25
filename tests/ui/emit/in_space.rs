lagrange::system! {
    struct Arm;

    gravity = (0, 0, -9.81);
    body arm { mass: 1; inertia: (1, 1, 2); shape: solid_sphere((1, 2, 3)); }
    frame wrist;
    revolute q = ground to arm { axis: (1, 0, 0); }
    weld arm to wrist { at: (0, 0, 1); }
    emit { drawing, motion, frames, frame_jacobians }
}

lagrange::system! {
    struct Rod;

    coord x, y;
    body rod { mass: 1; center: (x, y); }
    emit { motion, frames, frame_jacobians }
}

lagrange::system! {
    struct Named;

    body arm { mass: 1; inertia: (1, 1, 2); centroid: (0, 0, 0.5); }
    frame parameter;
    revolute q = ground to arm { axis: (1, 0, 0); }
    weld arm to parameter { at: (0, 0, 1); }
    output arm_frame = q;
    emit { frames, frame_jacobians, jacobian }
}

lagrange::system! {
    struct Point;

    coord x;
    body point { mass: 1; inertia: (0, 0, 0); center: (x, 0, 0); angles: (dot(x), 0, 0); sequence: zxz; }
    emit { frames, frame_jacobians }
}

fn main() {
    // Requested items exist nevertheless.
    let arm = Arm::default();
    let (_, place) = arm.wrist_frame(0.0, &[0.0]);
    let [_, _, _, along, ..] = arm.wrist_jacobian(0.0, &[0.0]);
    println!("{place:?} {along:?} {:?}", arm.arm_motion(0.0, &[0.0], &[0.0]).center);
}
