//! A flyball governor: balls on rods, a rotating shaft, and a slider on stiff springs and dampers.
//!
//! It is benchmark A05 of the IFToMM library of multibody systems: rods of 1 m with balls of 5 kg,
//! released at 2π rad/s. The declaration has four bodies and four joints. The handwritten reference
//! has two degrees of freedom, the angle β of the rods and the height s of the slider. The angular
//! momentum H = J(β) ω about the shaft is conserved:
//!
//! ```text
//! 2 I β̈ = ½ ω² J′(β) + gravity − 2 F ∂l/∂β, m s̈ = −m g − 2 F ∂l/∂s,
//! F = k (l − l₀) + c l̇ for springs of length l(β, s).
//! ```
//!
//! The reference is their solution with twenty digits (`tools/spatial_mechanisms.py`). The dampers
//! make the system stiff: explicit steps must stay below 0.4 ms for stability, where accuracy alone
//! would allow more. Gauss's method of order six uses 2 ms.
//!
//! Look for the height of the slider after ten seconds of a motion that hardly decays, and for the
//! angular momentum, conserved up to rounding.

mod common;

use std::error::Error;
use std::f64::consts::{FRAC_PI_6, TAU};

use common::compare;
use lagrange::Simulate;
use lagrange::integrate::PlainGaussLegendre;

lagrange::system! {
    /// Shaft, slider, and two rods with balls.
    #[derive(Clone, Debug)]
    pub struct Governor;

    /// Masses of a rod or the shaft, of a ball, and of the slider.
    param m: kg = 0.3, ball: kg = 5, block: kg = 3;
    /// Distance of the rods' joints from the axis, and widths of rods and slider.
    param e: m = 0.05, h: m = 0.01, w: m = 0.1;
    param k: N/m = 8e5, c: N*s/m = 4e4, g: m/s^2 = 9.81;
    gravity = (0, 0, -g);

    body shaft { mass: m; shape: cuboid(h, h, 1); centroid: (0, 0, 1/2); }
    body slider { mass: block; shape: cuboid(w, w, w); }
    body right_rod { compound { cuboid(1, h, h), mass: m, at: (1/2, 0, 0); point_mass(), mass: ball, at: (1, 0, 0); } }
    body left_rod { compound { cuboid(1, h, h), mass: m, at: (-1/2, 0, 0); point_mass(), mass: ball, at: (-1, 0, 0); } }

    revolute turn = ground to shaft;
    prismatic s = shaft to slider;
    /// The angles by which the rods point down.
    revolute right = shaft to right_rod { at: (e, 0, 1); axis: (0, 1, 0); }
    revolute left = shaft to left_rod { at: (-e, 0, 1); axis: (0, -1, 0); }

    spring { from: right_rod.point(0.5 [m], 0, 0); to: slider.point(e, 0, 0); stiffness: k; rest: 1/2; }
    spring { from: left_rod.point(-0.5 [m], 0, 0); to: slider.point(-e, 0, 0); stiffness: k; rest: 1/2; }
    damper { from: right_rod.point(0.5 [m], 0, 0); to: slider.point(e, 0, 0); damping: c; }
    damper { from: left_rod.point(-0.5 [m], 0, 0); to: slider.point(-e, 0, 0); damping: c; }

    let all = angular_momentum(shaft) + angular_momentum(slider) + angular_momentum(right_rod) + angular_momentum(left_rod);
    output momentum = all.z;
    emit { jacobian }
}

/// Time, angle of the shaft, height of the slider, angle of the rods, and rate of the shaft.
const REFERENCE: [[f64; 5]; 3] = [
    [0.1, 0.622_106_681_402_687_5, 0.523_836_475_569_575_7, 0.496_173_869_075_900_3, 6.103_717_808_830_862],
    [1.0, 5.586_346_965_869_005, 0.501_420_922_379_567_6, 0.521_833_301_625_546_3, 6.271_125_741_876_554_5],
    [10.0, 55.935_409_909_102_376, 0.619_622_917_061_365_6, 0.390_073_701_844_645_1, 5.548_203_622_654_927],
];

fn main() -> Result<(), Box<dyn Error>> {
    let governor = Governor::default();
    let start = GovernorState {
        turn: 0.0,
        s: 0.5,
        right: FRAC_PI_6,
        left: FRAC_PI_6,
        turn_dot: TAU,
        s_dot: 0.0,
        right_dot: 0.0,
        left_dot: 0.0,
    };
    let momentum = |state: GovernorState| governor.momentum(0.0, &state.coordinates(), &state.velocities());
    for [end, turn, s, angle, rate] in REFERENCE {
        let motion = governor
            .simulate(start)
            .until(end)
            .method(PlainGaussLegendre::<f64, 3> { step: 2e-3 })
            .ends_only()
            .run()?;
        let state = GovernorState::from(motion.last());
        let rows = [
            ("turn, rad", state.turn, turn),
            ("s, m", state.s, s),
            ("right, rad", state.right, angle),
            ("left, rad", state.left, angle),
            ("turn_dot, rad/s", state.turn_dot, rate),
            ("momentum, N m s", momentum(state), momentum(start)),
        ];
        compare(&format!("after {end} s"), 1e-11, &rows);
    }
    Ok(())
}
