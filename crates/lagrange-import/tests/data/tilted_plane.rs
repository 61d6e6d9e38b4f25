lagrange::system! {
    /// Robot `tilted_plane`.
    #[derive(Clone, Debug)]
    pub struct TiltedPlane;

    gravity = (0, 0, -9.81);

    body plate { mass: 2; centroid: (0.1, 0.02, 0.03); inertia: (0.02, 0.03, 0.04, 0.001, 0, -0.002); }
    // Joint `slope` of the file.
    frame slope_plane;
    frame slope_in_plane;
    weld ground to slope_plane { at: (0.1, 0, 0.2); turned: (0.3, 0, 0.5); }
    planar (slope_x, slope_y, slope_angle) = slope_plane to slope_in_plane { turned: (0.6435011087932843, 0, 0); }
    weld slope_in_plane to plate { turned: (-0.6435011087932843, 0, 0); }

    body tile { mass: 0.5; centroid: (0, 0.2, 0); inertia: (0.003, 0.002, 0.004); }
    // Joint `wall` of the file.
    frame wall_plane;
    frame wall_in_plane;
    weld plate to wall_plane { at: (0, 0, 0.1); }
    planar (wall_x, wall_y, wall_angle) = wall_plane to wall_in_plane { turned: (0, pi/2, 0); }
    weld wall_in_plane to tile { turned: (0, -pi/2, 0); }
}
