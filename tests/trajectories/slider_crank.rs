//! A slider-crank whose rod bends and stretches, by Radau's method.
//!
//! `tools/stiff.py` computes the reference states from accelerations and forces in the joints; here
//! they follow from energies and a constraint.

use crate::damped::{TOLERANCES, assert_keeps};

lagrange::system! {
    /// A crank that turns steadily, an elastic rod and a slider, with the damping of the rod.
    ///
    /// Two sines across the rod and two quadratic functions along it, over its ends. Sources:
    /// Mazzia and Magherini, *Test Set for Initial Value Problem Solvers*, 2.4, problem CRANK.
    /// Simeon, *Mathematical Modelling of Systems* 2 (1996) 1–18.
    #[derive(Clone, Debug)]
    pub(crate) struct SliderCrank;

    param turn = 150.0, short = 0.15, long = 0.3;
    param rod_mass = 0.151104, rod_inertia = 0.0045339259, slider_mass = 0.075552;
    param density = 7870.0, young = 2e11, width = 0.008;
    // As in the source.
    const circle = 3.1415927;
    coord rod, q[4];
    let crank = turn * t;
    let slider = short * cos(crank) + (long + q[3]) * cos(rod);
    constraint joint = short * sin(crank) + (long + q[3]) * sin(rod);

    // Of the deflections, without the density: volume, moments and couplings.
    let volume = width^2 * long;
    let along(x3, x4) = volume * (2/3 * x3 + 1/6 * x4);
    let across(x1) = volume * 2 / circle * x1;
    let turning_along = volume * long * (1/3 * q[2] + 1/6 * q[3]);
    let turning_across = volume * long * (dot(q[0]) - 1/2 * dot(q[1])) / circle;
    let a = 16 / circle^3;
    let b = 8 / circle^3 - 1 / circle;
    let c = 1 / (2 * circle);
    let coupling = volume * (
        a * (q[2] * dot(q[0]) - q[0] * dot(q[2]))
        + b * (q[0] * dot(q[3]) - q[3] * dot(q[0]))
        + c * (q[1] * dot(q[3]) - q[3] * dot(q[1]))
    );
    let square(x1, x2, x3, x4) = volume * (1/2 * (x1^2 + x2^2) + 8 * x3^2 + 2 * x3 * x4 + 2 * x4^2);

    let lead = crank - rod;
    kinetic = 1/2 * rod_inertia * dot(rod)^2 + 1/2 * slider_mass * dot(slider)^2;
    kinetic = short * turn * dot(rod) * cos(lead) * (1/2 * long * rod_mass + density * along(q[2], q[3]));
    kinetic = density * short * turn * dot(rod) * sin(lead) * across(q[0]);
    kinetic = density * short * turn * (cos(lead) * across(dot(q[0])) - sin(lead) * along(dot(q[2]), dot(q[3])));
    kinetic = density * dot(rod)^2 * (1/2 * square(q[0], q[1], q[2], q[3]) + turning_along);
    kinetic = density * dot(rod) * (turning_across + coupling);
    kinetic = 1/2 * density * square(dot(q[0]), dot(q[1]), dot(q[2]), dot(q[3]));

    let springs = young * width^2 / long;
    let bending = circle^4 * (width / long)^2;
    potential = 1/2 * springs * (bending * (q[0]^2 / 24 + 2/3 * q[1]^2) + 16/3 * q[2]^2 - 16/3 * q[2] * q[3] + 7/3 * q[3]^2);
    dissipation = 1/2 * (5 * dot(q[0])^2 + 25 * dot(q[1])^2);
    dissipation = 1/4 * (230.8375455264791 * dot(q[2])^2 + 421.7421837156818 * dot(q[3])^2);
    dissipation = -1/2 * 262.688487992052 * dot(q[2]) * dot(q[3]);
}

/// The start of the source, without vibrations at first.
pub(crate) const START: [f64; 10] = [
    0.0,
    0.0,
    0.0,
    0.103_339_863e-4,
    0.169_327_969e-4,
    -75.0 * 0.3 / (0.3 + 0.169_327_969e-4),
    0.444_896_105,
    0.463_434_311e-2,
    -0.178_591_076e-5,
    -0.268_938_672e-5,
];

#[test]
fn an_elastic_slider_crank_keeps_its_tolerance() {
    let sizes = [1.0, 1e-4, 1e-4, 1e-4, 1e-4, 0.1, 0.1, 0.1, 0.1];
    let compared = |t: f64, [_, q0, q1, q2, q3, _, u0, u1, u2, u3]: &[f64; 10]| {
        [150.0 * t, *q0, *q1, *q2, *q3, *u0, *u1, *u2, *u3]
    };
    assert_keeps(&SliderCrank::default(), ("slider_crank", START, sizes), compared, &TOLERANCES);
}
