//! Written by `tools/spatial_benches.py`.

use std::f64::consts::FRAC_PI_2;

use crate::rigid_bodies::Joint;

lagrange::system! {
    /// `ur5` of `lagrange-core/tests/spatial/models`.
    pub(crate) struct Ur5;
    gravity = (0, 0, -9.81);
    body l1 { mass: 3.7; inertia: (0.010267495893, 0.010267495893, 0.00666, 0, 0, 0); }
    revolute q1 = ground to l1 { at: (0, 0, 0.089159); }
    body l2 { mass: 8.393; centroid: (0, 0, 0.28); inertia: (0.22689067591, 0.22689067591, 0.0151074, 0, 0, 0); }
    revolute q2 = l1 to l2 { at: (0, 0.13585, 0); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    body l3 { mass: 2.275; centroid: (0, 0, 0.24999999999999994); inertia: (0.049443313556, 0.049443313556, 0.004095, 0, 0, 0); }
    revolute q3 = l2 to l3 { at: (0, -0.1197, 0.425); axis: (0, 1, 0); }
    body l4 { mass: 1.219; inertia: (0.111172755531, 0.111172755531, 0.21942, 0, 0, 0); }
    revolute q4 = l3 to l4 { at: (0, 0, 0.39225); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    body l5 { mass: 1.219; inertia: (0.111172755531, 0.111172755531, 0.21942, 0, 0, 0); }
    revolute q5 = l4 to l5 { at: (0, 0.093, 0); }
    body l6 { mass: 0.1879; inertia: (0.0171364731454, 0.0171364731454, 0.033822, 0, 0, 0); }
    revolute q6 = l5 to l6 { at: (0, 0, 0.09465); axis: (0, 1, 0); }
}

lagrange::system! {
    /// `ur5` of `lagrange-core/tests/spatial/models`, with fast sines.
    #[accuracy(fast)]
    pub(crate) struct FastUr5;
    gravity = (0, 0, -9.81);
    body l1 { mass: 3.7; inertia: (0.010267495893, 0.010267495893, 0.00666, 0, 0, 0); }
    revolute q1 = ground to l1 { at: (0, 0, 0.089159); }
    body l2 { mass: 8.393; centroid: (0, 0, 0.28); inertia: (0.22689067591, 0.22689067591, 0.0151074, 0, 0, 0); }
    revolute q2 = l1 to l2 { at: (0, 0.13585, 0); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    body l3 { mass: 2.275; centroid: (0, 0, 0.24999999999999994); inertia: (0.049443313556, 0.049443313556, 0.004095, 0, 0, 0); }
    revolute q3 = l2 to l3 { at: (0, -0.1197, 0.425); axis: (0, 1, 0); }
    body l4 { mass: 1.219; inertia: (0.111172755531, 0.111172755531, 0.21942, 0, 0, 0); }
    revolute q4 = l3 to l4 { at: (0, 0, 0.39225); turned: (0, pi/2, 0); axis: (0, 1, 0); }
    body l5 { mass: 1.219; inertia: (0.111172755531, 0.111172755531, 0.21942, 0, 0, 0); }
    revolute q5 = l4 to l5 { at: (0, 0.093, 0); }
    body l6 { mass: 0.1879; inertia: (0.0171364731454, 0.0171364731454, 0.033822, 0, 0, 0); }
    revolute q6 = l5 to l6 { at: (0, 0, 0.09465); axis: (0, 1, 0); }
    emit { no mass_matrix, no momenta, no inverse_dynamics }
}

/// The robot for handwritten algorithms.
#[rustfmt::skip]
pub(crate) const JOINTS: [Joint; 6] = [
    Joint { at: [0.0, 0.0, 0.089159], turned: [0.0, 0.0, 0.0], axis: 2, mass: 3.7, centroid: [0.0, 0.0, 0.0], inertia: [0.010267495893, 0.010267495893, 0.00666, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.13585, 0.0], turned: [0.0, FRAC_PI_2, 0.0], axis: 1, mass: 8.393, centroid: [0.0, 0.0, 0.28], inertia: [0.22689067591, 0.22689067591, 0.0151074, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, -0.1197, 0.425], turned: [0.0, 0.0, 0.0], axis: 1, mass: 2.275, centroid: [0.0, 0.0, 0.24999999999999994], inertia: [0.049443313556, 0.049443313556, 0.004095, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, 0.39225], turned: [0.0, FRAC_PI_2, 0.0], axis: 1, mass: 1.219, centroid: [0.0, 0.0, 0.0], inertia: [0.111172755531, 0.111172755531, 0.21942, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.093, 0.0], turned: [0.0, 0.0, 0.0], axis: 2, mass: 1.219, centroid: [0.0, 0.0, 0.0], inertia: [0.111172755531, 0.111172755531, 0.21942, 0.0, 0.0, 0.0] },
    Joint { at: [0.0, 0.0, 0.09465], turned: [0.0, 0.0, 0.0], axis: 1, mass: 0.1879, centroid: [0.0, 0.0, 0.0], inertia: [0.0171364731454, 0.0171364731454, 0.033822, 0.0, 0.0, 0.0] },
];
