lagrange::system! {
    /// Robot `walker`.
    #[derive(Clone, Debug)]
    pub struct Walker;

    gravity = (0, 0, -9.81);

    // Collision: cuboid(0.16, 0.4, 0.08) at (0, 0, 0.01) turned (0, 0, pi/2).
    body trunk { mass: 4; centroid: (0.01, 0, 0); inertia: (0.02, 0.05, 0.06); }
    free trunk;

    // Collision: solid_sphere(0.02) at (0, 0, -0.2).
    body fl_leg { mass: 0.3; centroid: (0, 0, -0.1); inertia: (0.0011, 0.0011, 0.0001); }
    /// From -0.3 to 0.25 rad; at most 6 N m and 10 rad/s.
    revolute fl_hip = trunk to fl_leg { at: (0.18, 0.1, -0.03); axis: (0, 1, 0); damping: 0.5; }

    // Collision: solid_sphere(0.02) at (0, 0, -0.2).
    body fr_leg { mass: 0.3; centroid: (0, 0, -0.1); inertia: (0.0011, 0.0011, 0.0001); }
    /// From -0.3 to 0.25 rad; at most 6 N m and 10 rad/s.
    revolute fr_hip = trunk to fr_leg { at: (0.18, -0.1, -0.03); axis: (0, 1, 0); damping: 0.5; }

    // Collision: solid_sphere(0.02) at (0, 0, -0.2).
    body rl_leg { mass: 0.3; centroid: (0, 0, -0.1); inertia: (0.0011, 0.0011, 0.0001); }
    /// From 0.1 to 0.35 rad; at most 6 N m and 10 rad/s.
    revolute rl_hip = trunk to rl_leg { at: (-0.18, 0.1, -0.03); axis: (0, 1, 0); damping: 0.5; }

    // Collision: solid_sphere(0.02) at (0, 0, -0.2).
    body rr_leg { mass: 0.3; centroid: (0, 0, -0.1); inertia: (0.0011, 0.0011, 0.0001); }
    /// From 0.1 to 0.35 rad; at most 6 N m and 10 rad/s.
    revolute rr_hip = trunk to rr_leg { at: (-0.18, -0.1, -0.03); axis: (0, 1, 0); damping: 0.5; }

    body mast { mass: 0.5; centroid: (0, 0, 0.1); inertia: (0.002, 0.002, 0.0001); }
    /// From -0.05 to 0.08 m; at most 20 N and 1 m/s; dry friction of 0.5 N.
    prismatic lift = trunk to mast { at: (0, 0, 0.05); }

    body weight { mass: 0.2; inertia: (0.0002, 0.0002, 0.0002); }
    /// From -0.02 to 0.05 m; at most 20 N and 1 m/s; dry friction of 0.2 N.
    prismatic belt = trunk to weight { at: (-0.1, 0, 0); axis: (1, 0, 0); }

    constraint belt_mimic = belt + 0.5 * lift - 0.02;

    input u_fl_hip, u_fr_hip, u_rl_hip, u_rr_hip, u_lift;
    force fl_hip = max(-6, min(6, u_fl_hip));
    force fr_hip = max(-6, min(6, u_fr_hip));
    force rl_hip = max(-6, min(6, u_rl_hip));
    force rr_hip = max(-6, min(6, u_rr_hip));
    force lift = max(-20, min(20, u_lift));

    event fl_hip_lower = fl_hip + 0.3, falling => impact(0);
    event fl_hip_upper = 0.25 - fl_hip, falling => impact(0);
    event fr_hip_lower = fr_hip + 0.3, falling => impact(0);
    event fr_hip_upper = 0.25 - fr_hip, falling => impact(0);
    event rl_hip_lower = rl_hip - 0.1, falling => impact(0);
    event rl_hip_upper = 0.35 - rl_hip, falling => impact(0);
    event rr_hip_lower = rr_hip - 0.1, falling => impact(0);
    event rr_hip_upper = 0.35 - rr_hip, falling => impact(0);
    event lift_lower = lift + 0.05, falling => impact(0);
    event lift_upper = 0.08 - lift, falling => impact(0);
    start rl_hip = 0.225;
    start rr_hip = 0.225;
    start belt = 0.02;

    friction lift_friction = dot(lift), 0.6;

    /// Coefficient of friction on the ground; the file states none.
    param mu >= 0 = 0.6;
    contact fl_leg_touch = fl_leg.point(0, 0, -0.2) on ground { friction: mu; radius: 0.02; }
    contact fr_leg_touch = fr_leg.point(0, 0, -0.2) on ground { friction: mu; radius: 0.02; }
    contact rl_leg_touch = rl_leg.point(0, 0, -0.2) on ground { friction: mu; radius: 0.02; }
    contact rr_leg_touch = rr_leg.point(0, 0, -0.2) on ground { friction: mu; radius: 0.02; }
}
