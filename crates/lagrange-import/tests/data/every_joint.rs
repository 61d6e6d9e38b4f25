lagrange::system! {
    /// Robot `odd-machine 2`.
    #[derive(Clone, Debug)]
    pub struct OddMachine2;

    gravity = (0, 0, -9.81);

    // Collides as it is seen.
    body sled {
        mass: 12.5;
        centroid: (0.05, -0.02, 0.11);
        inertia: (0.4, 0.5, 0.7, 0.01, -0.02, 0.03);
        visual { cuboid(0.6, 0.4, 0.2); }
    }
    // Joint `drift` of the file.
    planar (drift_x, drift_y, drift_angle) = ground to sled { at: (0.1, 0.2, 0.3); turned: (0.2, -0.3, 0.4); }

    body mast_1 {
        mass: 3;
        centroid: (0, 0, 0.4);
        inertia: (0.16407439075975544, 0.14781709367400223, 0.038108515566242396,
            0.0023705238316391684, 0.007839437037218828, 0.047661776316719646);
        visual { solid_cylinder(0.04, 0.8), at: (0, 0, 0.4); }
    }
    /// Joint `sled` of the file. From -1.2 to 2.5 rad; at most 87 N m and 2.175 rad/s; dry friction
    /// of 0.1 N m.
    revolute sled_joint = sled to mast_1 { at: (0.2, 0, 0.1); turned: (0.1, 0, pi/2); axis: (1, 2, -2); damping: 0.35; }

    frame bracket;
    weld mast_1 to bracket { at: (0, 0, 0.8); turned: (pi/2, 0, -pi/2); }

    body camera_head {
        mass: 0.75;
        centroid: (0.01, 0.02, 0.03);
        inertia: (0.002, 0.001, 0.0025, -0.0001, 0.0003, 0.0002);
        visual { solid_sphere(0.05); }
    }
    weld bracket to camera_head { at: (0.05, 0, 0); }

    frame optical_frame;
    weld camera_head to optical_frame { turned: (-pi/2, pi, 0); }

    // Link `type` of the file.
    body type_link { mass: 2.25; inertia: (0.03, 0.04, 0.05); }
    /// From 0 to 0.6 m; at most 200 N and 0.5 m/s.
    prismatic lift = mast_1 to type_link { at: (0.02, 0, 0.7); axis: (0, 0, -1); damping: 4; }

    frame rotor;
    /// Joint `t` of the file. At most 5 N m and 30 rad/s.
    revolute t_joint = type_link to rotor { at: (0.1, 0, 0); turned: (0, pi/2, 0); axis: (0, 1, 0); }

    body blade { mass: 0.4; centroid: (0.2, 0, 0); inertia: (0.00001, 0.0054, 0.0054); }
    weld rotor to blade;

    frame indicator;
    // Joint `indicator_turn` moves no mass: it is held.
    weld blade to indicator;

    // Link `1st finger` of the file.
    body link_1st_finger { mass: 0.2; centroid: (0, 0.06, 0); inertia: (0.00025, 0.00002, 0.00025); }
    /// From -0.5 to 0.5 rad; at most 3 N m and 1 rad/s.
    revolute finger_a = type_link to link_1st_finger { at: (0, 0.1, 0); axis: (1, 0, 0); }

    // Link `2nd finger` of the file.
    body link_2nd_finger { mass: 0.2; centroid: (0, -0.06, 0); inertia: (0.00025, 0.00002, 0.00025); }
    /// From -0.02 to 0.02 m; at most 3 N and 1 m/s.
    prismatic finger_b = type_link to link_2nd_finger { at: (0, -0.1, 0); axis: (0, 1, 0); }

    body drone { mass: 0.9; centroid: (0.01, 0, -0.02); inertia: (0.004, 0.005, 0.007, 0, 0.0005, 0); }
    // Joint `tether` of the file.
    frame tether_along_x;
    prismatic tether_x = type_link to tether_along_x { at: (0, 0, 0.5); turned: (0.5, 0, 0); axis: (1, 0, 0); }
    frame tether_along_y;
    prismatic tether_y = tether_along_x to tether_along_y { axis: (0, 1, 0); }
    frame tether_along_z;
    prismatic tether_z = tether_along_y to tether_along_z;
    ball tether = tether_along_z to drone;

    // Link `関節` of the file.
    // Collision: solid_sphere(0.0316).
    body link { mass: 0.05; inertia: (0.00002, 0.00002, 0.00002); }
    // Joint `loose` of the file.
    free link;

    constraint finger_b_mimic = finger_b + 0.2 * finger_a - 0.01;
}
