//! Written by `tools/spatial_benches.py`.

use crate::rigid_bodies::Joint;

lagrange::system! {
    /// `universal_5` of `lagrange-core/tests/spatial/models`.
    pub(crate) struct Universal5;
    gravity = (0, 0, -9.81);
    body l1 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a1, b1) = ground to l1;
    body l2 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a2, b2) = l1 to l2 { at: (0, 0, -1); }
    body l3 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a3, b3) = l2 to l3 { at: (0, 0, -1); }
    body l4 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a4, b4) = l3 to l4 { at: (0, 0, -1); }
    body l5 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a5, b5) = l4 to l5 { at: (0, 0, -1); }
}

lagrange::system! {
    /// `universal_5` of `lagrange-core/tests/spatial/models`, with fast sines.
    #[accuracy(fast)]
    pub(crate) struct FastUniversal5;
    gravity = (0, 0, -9.81);
    body l1 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a1, b1) = ground to l1;
    body l2 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a2, b2) = l1 to l2 { at: (0, 0, -1); }
    body l3 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a3, b3) = l2 to l3 { at: (0, 0, -1); }
    body l4 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a4, b4) = l3 to l4 { at: (0, 0, -1); }
    body l5 { mass: 1; centroid: (0, 0, -0.5); inertia: (1/12, 1/12, 0.005); }
    universal (a5, b5) = l4 to l5 { at: (0, 0, -1); }
    emit { no mass_matrix, no momenta, no inverse_dynamics }
}

/// The robot for handwritten algorithms.
#[rustfmt::skip]
pub(crate) const JOINTS: [Joint; 10] = [
    Joint { at: [0.0, 0.0, 0.0], turned: [0.0, 0.0, 0.0], axis: 0, mass: 0.0, centroid: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, 0.0], turned: [0.0, 0.0, 0.0], axis: 1, mass: 1.0, centroid: [0.0, 0.0, -0.5], inertia: [0.08333333333333333, 0.08333333333333333, 0.005, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, -1.0], turned: [0.0, 0.0, 0.0], axis: 0, mass: 0.0, centroid: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, 0.0], turned: [0.0, 0.0, 0.0], axis: 1, mass: 1.0, centroid: [0.0, 0.0, -0.5], inertia: [0.08333333333333333, 0.08333333333333333, 0.005, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, -1.0], turned: [0.0, 0.0, 0.0], axis: 0, mass: 0.0, centroid: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, 0.0], turned: [0.0, 0.0, 0.0], axis: 1, mass: 1.0, centroid: [0.0, 0.0, -0.5], inertia: [0.08333333333333333, 0.08333333333333333, 0.005, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, -1.0], turned: [0.0, 0.0, 0.0], axis: 0, mass: 0.0, centroid: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, 0.0], turned: [0.0, 0.0, 0.0], axis: 1, mass: 1.0, centroid: [0.0, 0.0, -0.5], inertia: [0.08333333333333333, 0.08333333333333333, 0.005, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, -1.0], turned: [0.0, 0.0, 0.0], axis: 0, mass: 0.0, centroid: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, 0.0], turned: [0.0, 0.0, 0.0], axis: 1, mass: 1.0, centroid: [0.0, 0.0, -0.5], inertia: [0.08333333333333333, 0.08333333333333333, 0.005, 0.0, 0.0, 0.0] },
];
