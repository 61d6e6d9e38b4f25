//! Rigid bodies with all products.

lagrange::system! {
    /// A rod on a hinge, tied to a wheel on a slope.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Tied;

    param m = 1.0, l = 2.0, k = 3.0, Slope = 0.1;
    coord x, y, a, X, Y, phi;
    gravity = (0, -9.81);
    line Ramp { through: (0, -2); angle: Slope; }
    body rod { mass: m; shape: slender_rod(l); center: (x, y); angle: a; }
    body Wheel {
        compound {
            disk(l / 4), mass: m;
            hole polygon((0, 0), (l / 10, 0), (0, l / 10)), mass: m / 50;
        }
        center: (X, Y);
        angle: phi;
    }
    pin hinge = rod.point(-l / 2, 0) to (0, 0);
    roll contact = Wheel on Ramp, radius: l / 4;
    spring { from: rod.point(l / 2, 0); to: Wheel; stiffness: k; rest: l; }
    torsion_damper { from: rod; to: Wheel; damping: k / 10; }
    output grip = hinge.force;
    emit { motion, drawing, statements }
}

lagrange::system! {
    /// A body with a position that does not turn, in any number type.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Box<S>;

    coord x;
    body crate_ { mass: 1; center: (x, 0); }
    emit { motion, drawing }
}

lagrange::system! {
    /// A link in space with a tool, in any number type.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Arm<S>;

    param l = 1.0;
    gravity = (0, 0, -9.81);
    /// The link.
    body link { mass: 2; inertia: (0.1, 0.1, 0.01); centroid: (0, 0, l / 2); }
    /// Frame of the tool.
    frame Tool;
    revolute q = ground to link { axis: (1, 0, 0); }
    weld link to Tool { at: (0, 0, l); }
    emit { motion, frames, frame_jacobians, statements }
}
