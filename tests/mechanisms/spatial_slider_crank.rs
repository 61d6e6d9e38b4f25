//! A slider-crank whose crank rotates about the direction of the slider's motion.

lagrange::system! {
    /// The rod hangs from the slider by a universal joint; the ball joint at the crank closes the
    /// loop.
    ///
    /// Dimensions are those of the spatial slider-crank of the IFToMM library (Haug,
    /// *Computer-Aided Kinematics and Dynamics of Mechanical Systems*, 1989).
    #[derive(Clone, Debug)]
    pub(crate) struct SpatialSliderCrank;

    param r = 0.08, l = 0.3, beside = 0.1, above = 0.12, g = 9.81;
    gravity = (0, 0, -g);

    body wheel { mass: 0.12; inertia: (1e-4, 1e-5, 1e-4); }
    body slider { mass: 2; inertia: (1e-4, 1e-4, 1e-4); }
    body rod { mass: 0.5; inertia: (4e-4, 4e-3, 4e-3); centroid: (-l/2, 0, 0); }
    revolute crank = ground to wheel { at: (0, beside, above); axis: (1, 0, 0); }
    prismatic x = ground to slider { axis: (1, 0, 0); }
    universal (a, b) = slider to rod;
    pin rod.point(-l, 0, 0) to wheel.point(0, 0, r);
}

lagrange::system! {
    /// The slider-crank with the ball joint in the tree: the orientation of the rod is a unit
    /// quaternion. The universal joint closes the loop.
    #[derive(Clone, Debug)]
    pub(crate) struct BallSliderCrank;

    param r = 0.08, l = 0.3, beside = 0.1, above = 0.12, g = 9.81;
    gravity = (0, 0, -g);

    body wheel { mass: 0.12; inertia: (1e-4, 1e-5, 1e-4); }
    body slider { mass: 2; inertia: (1e-4, 1e-4, 1e-4); }
    body rod { mass: 0.5; inertia: (4e-4, 4e-3, 4e-3); centroid: (l/2, 0, 0); }
    revolute crank = ground to wheel { at: (0, beside, above); axis: (1, 0, 0); }
    prismatic x = ground to slider { axis: (1, 0, 0); }
    ball joint = wheel to rod { at: (0, 0, r); }
    pin rod.point(l, 0, 0) to slider;
    constraint no_twist = rod.vector(0, 1, 0).x;
}
