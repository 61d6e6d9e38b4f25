//! Bricard's mechanism: six revolute joints in a ring.

lagrange::system! {
    /// Five rods along the edges of a cube. Six joints, each at right angles to both neighbours,
    /// close them to a loop with the ground.
    ///
    /// Benchmark A04 of the IFToMM library (González, Dopico, Naya, Cuadrado, *A benchmarking
    /// system for MBS simulation software*, Multibody System Dynamics 16, 2006). The sixth joint
    /// takes five degrees of freedom from five angles; one remains nevertheless.
    #[derive(Clone, Debug)]
    pub(crate) struct Bricard;

    param m = 1, l = 1, d = 0.1, g = 9.81;
    gravity = (0, -g, 0);

    body rod1 { mass: m; shape: cuboid(l, d, d); centroid: (l/2, 0, 0); }
    body rod2 { mass: m; shape: cuboid(d, l, d); centroid: (0, -l/2, 0); }
    body rod3 { mass: m; shape: cuboid(d, d, l); centroid: (0, 0, l/2); }
    body rod4 { mass: m; shape: cuboid(l, d, d); centroid: (-l/2, 0, 0); }
    body rod5 { mass: m; shape: cuboid(d, l, d); centroid: (0, l/2, 0); }
    revolute q1 = ground to rod1 { axis: (0, 1, 0); }
    revolute q2 = rod1 to rod2 { at: (l, 0, 0); axis: (0, 0, 1); }
    revolute q3 = rod2 to rod3 { at: (0, -l, 0); axis: (1, 0, 0); }
    revolute q4 = rod3 to rod4 { at: (0, 0, l); axis: (0, 1, 0); }
    revolute q5 = rod4 to rod5 { at: (-l, 0, 0); axis: (0, 0, 1); }

    pin rod5.point(0, l, 0) to (0, 0, l);
    let axis = rod5.vector(1, 0, 0);
    constraint level = axis.y;
    constraint straight = axis.z;

    output p3 = rod3.origin;
}
