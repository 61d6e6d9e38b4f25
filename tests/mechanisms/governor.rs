//! A flyball governor.

lagrange::system! {
    /// Two rods with balls on a rotating shaft; stiff springs and dampers hold them to a slider.
    ///
    /// Benchmark A05 of the IFToMM library (González, Dopico, Naya, Cuadrado, *A benchmarking
    /// system for MBS simulation software*, Multibody System Dynamics 16, 2006).
    #[derive(Clone, Debug)]
    pub(crate) struct Governor;

    param m = 0.3, ball = 5, block = 3, e = 0.05, h = 0.01, w = 0.1, k = 8e5, c = 4e4, g = 9.81;
    gravity = (0, 0, -g);

    body shaft { mass: m; shape: cuboid(h, h, 1); centroid: (0, 0, 1/2); }
    body slider { mass: block; shape: cuboid(w, w, w); }
    body right_rod { compound { cuboid(1, h, h), mass: m, at: (1/2, 0, 0); point_mass(), mass: ball, at: (1, 0, 0); } }
    body left_rod { compound { cuboid(1, h, h), mass: m, at: (-1/2, 0, 0); point_mass(), mass: ball, at: (-1, 0, 0); } }
    revolute turn = ground to shaft;
    prismatic s = shaft to slider;
    revolute right = shaft to right_rod { at: (e, 0, 1); axis: (0, 1, 0); }
    revolute left = shaft to left_rod { at: (-e, 0, 1); axis: (0, -1, 0); }

    spring { from: right_rod.point(1/2, 0, 0); to: slider.point(e, 0, 0); stiffness: k; rest: 1/2; }
    spring { from: left_rod.point(-1/2, 0, 0); to: slider.point(-e, 0, 0); stiffness: k; rest: 1/2; }
    damper { from: right_rod.point(1/2, 0, 0); to: slider.point(e, 0, 0); damping: c; }
    damper { from: left_rod.point(-1/2, 0, 0); to: slider.point(-e, 0, 0); damping: c; }
    emit { jacobian }

    output momentum = (angular_momentum(shaft) + angular_momentum(slider) + angular_momentum(right_rod) + angular_momentum(left_rod)).z;
}
