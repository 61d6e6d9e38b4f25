lagrange::system! {
    /// Robot `two_link`.
    #[derive(Clone, Debug)]
    pub struct TwoLink;

    gravity = (0, 0, -9.81);

    body upper { mass: 2; centroid: (0, 0, -0.25); inertia: (0.042, 0.042, 0.002); }
    /// From -2 to 2 rad; at most 40 N m and 5 rad/s.
    revolute shoulder = ground to upper { at: (0, 0, 1); axis: (0, 1, 0); damping: 0.1; }

    body lower { mass: 1; centroid: (0, 0, -0.2); inertia: (0.014, 0.014, 0.001); }
    /// From -2.5 to 0 rad; at most 20 N m and 5 rad/s.
    revolute elbow = upper to lower { at: (0, 0, -0.5); axis: (0, 1, 0); damping: 0.1; }

    input u_shoulder, u_elbow;
    force shoulder = u_shoulder;
    force elbow = u_elbow;
}
