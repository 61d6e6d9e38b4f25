//! A quadruped that hangs from a spring, bounces, and swings its legs.
//!
//! Masses, centres of mass and joints are those of the Unitree Go2 as its public description has
//! them. A free trunk and four legs of three links, with springs and dampers in their joints, have
//! eighteen freedoms. The spring that holds the trunk ends in (0, 0, 1), so no force has a moment
//! about the vertical through there. The angular momentum about it is conserved, with damping or
//! without. The energy changes by the work of the dampers,
//!
//! ```text
//! E(t) + ∫ c Σ q̇ᵢ² dt = E(0),   Σ over the twelve joints.
//! ```
//!
//! Accelerations, energy and angular momentum of a state are compared with Pinocchio's
//! (`tools/robots.py`), where the spring is an external force and joints have torques. Look for
//! both balances.
//!
//! `cargo run --example quadruped --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::draw::Drawing;
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// A trunk on a spring with four legs: front and rear, left and right.
    #[derive(Clone, Debug)]
    pub struct Quadruped;

    /// Stiffness of the joints: roll, pitch, knee; angles at which they are relaxed, and damping.
    param k1: N*m = 3, k2: N*m = 6, k3: N*m = 3, pitch: rad = 0.8, knee: rad = -1.5, c: N*m*s = 0.2;
    /// Stiffness and relaxed length of the spring.
    param k: N/m = 400, rest: m = 0.3;
    gravity = (0, 0, -9.81);

    body trunk { mass: 7.277000000000002; shape: cuboid(0.3762, 0.0935, 0.114); centroid: (0.020079174385048755, 0, -0.005103488525491267); inertia: (0.0257151774237163, 0.10295388328825997, 0.11264519436454368, 0.0001216600000000001, 0.001523257166511061, -0.000031200000000000006); }
    body fl_hip { mass: 0.767; centroid: (-0.004773402868318123, 0.0016974837027379402, -0.0000928161668839635); inertia: (0.0005399915178106258, 0.0009981369647855932, 0.0006582847478620599, -0.0000021220993324641458, 0.000001065392550195567, -0.0000014027352647979139); }
    body fl_thigh { mass: 1.2409999999999999; centroid: (-0.0034717808219178084, -0.02302074939564867, -0.030354875100725223); inertia: (0.005996333341208702, 0.006001339409970024, 0.0010991471651674457, 0.00009030533435616439, -0.00029910392372602736, 0.0008351509180338437); }
    body fl_calf { mass: 0.194; centroid: (0.004350103092783504, -0.0007739690721649483, -0.13520618556701028); inertia: (0.001394581937371134, 0.0014155052951752578, 0.00004348372739175258, 0.0000005096540206185566, 0.00000014759587628866708, 0.000011313958762886598); }
    body fr_hip { mass: 0.767; centroid: (-0.004773402868318123, -0.0016974837027379402, -0.0000928161668839635); inertia: (0.0005399915178106258, 0.0009981369647855932, 0.0006582847478620599, 0.0000021220993324641458, 0.000001065392550195567, 0.0000014027352647979139); }
    body fr_thigh { mass: 1.2409999999999999; centroid: (-0.0034717808219178084, 0.02302074939564867, -0.030354875100725223); inertia: (0.005996333341208702, 0.006001339409970024, 0.0010991471651674457, -0.00009030533435616439, -0.00029910392372602736, -0.0008351509180338437); }
    body fr_calf { mass: 0.194; centroid: (0.004350103092783504, 0.0007739690721649483, -0.13520618556701028); inertia: (0.001394581937371134, 0.0014155052951752578, 0.00004348372739175258, -0.0000005096540206185566, 0.00000014759587628866708, -0.000011313958762886598); }
    body rl_hip { mass: 0.767; centroid: (0.004773402868318123, 0.0016974837027379402, -0.0000928161668839635); inertia: (0.0005399915178106258, 0.0009981369647855932, 0.0006582847478620599, 0.0000021220993324641458, -0.000001065392550195567, -0.0000014027352647979139); }
    body rl_thigh { mass: 1.2409999999999999; centroid: (-0.0034717808219178084, -0.02302074939564867, -0.030354875100725223); inertia: (0.005996333341208702, 0.006001339409970024, 0.0010991471651674457, 0.00009030533435616439, -0.00029910392372602736, 0.0008351509180338437); }
    body rl_calf { mass: 0.194; centroid: (0.004350103092783504, -0.0007739690721649483, -0.13520618556701028); inertia: (0.001394581937371134, 0.0014155052951752578, 0.00004348372739175258, 0.0000005096540206185566, 0.00000014759587628866708, 0.000011313958762886598); }
    body rr_hip { mass: 0.767; centroid: (0.004773402868318123, -0.0016974837027379402, -0.0000928161668839635); inertia: (0.0005399915178106258, 0.0009981369647855932, 0.0006582847478620599, -0.0000021220993324641458, -0.000001065392550195567, 0.0000014027352647979139); }
    body rr_thigh { mass: 1.2409999999999999; centroid: (-0.0034717808219178084, 0.02302074939564867, -0.030354875100725223); inertia: (0.005996333341208702, 0.006001339409970024, 0.0010991471651674457, -0.00009030533435616439, -0.00029910392372602736, -0.0008351509180338437); }
    body rr_calf { mass: 0.194; centroid: (0.004350103092783504, 0.0007739690721649483, -0.13520618556701028); inertia: (0.001394581937371134, 0.0014155052951752578, 0.00004348372739175258, -0.0000005096540206185566, 0.00000014759587628866708, -0.000011313958762886598); }
    frame fl_foot;
    frame fr_foot;
    frame rl_foot;
    frame rr_foot;

    free trunk;
    spring { from: trunk.point(0.02 m, 0, 0.06 m); to: (0, 0, 1); stiffness: k; rest: rest; }
    revolute fl_roll = trunk to fl_hip { at: (0.1934, 0.0465, 0); axis: (1, 0, 0); damping: c; }
    revolute fl_pitch = fl_hip to fl_thigh { at: (0, 0.0955, 0); axis: (0, 1, 0); damping: c; }
    revolute fl_knee = fl_thigh to fl_calf { at: (0, 0, -0.213); axis: (0, 1, 0); damping: c; }
    revolute fr_roll = trunk to fr_hip { at: (0.1934, -0.0465, 0); axis: (1, 0, 0); damping: c; }
    revolute fr_pitch = fr_hip to fr_thigh { at: (0, -0.0955, 0); axis: (0, 1, 0); damping: c; }
    revolute fr_knee = fr_thigh to fr_calf { at: (0, 0, -0.213); axis: (0, 1, 0); damping: c; }
    revolute rl_roll = trunk to rl_hip { at: (-0.1934, 0.0465, 0); axis: (1, 0, 0); damping: c; }
    revolute rl_pitch = rl_hip to rl_thigh { at: (0, 0.0955, 0); axis: (0, 1, 0); damping: c; }
    revolute rl_knee = rl_thigh to rl_calf { at: (0, 0, -0.213); axis: (0, 1, 0); damping: c; }
    revolute rr_roll = trunk to rr_hip { at: (-0.1934, -0.0465, 0); axis: (1, 0, 0); damping: c; }
    revolute rr_pitch = rr_hip to rr_thigh { at: (0, -0.0955, 0); axis: (0, 1, 0); damping: c; }
    revolute rr_knee = rr_thigh to rr_calf { at: (0, 0, -0.213); axis: (0, 1, 0); damping: c; }
    weld fl_calf to fl_foot { at: (0, 0, -0.213); }
    weld fr_calf to fr_foot { at: (0, 0, -0.213); }
    weld rl_calf to rl_foot { at: (0, 0, -0.213); }
    weld rr_calf to rr_foot { at: (0, 0, -0.213); }

    let fl = k1 * fl_roll^2 + k2 * (fl_pitch - pitch)^2 + k3 * (fl_knee - knee)^2;
    let fr = k1 * fr_roll^2 + k2 * (fr_pitch - pitch)^2 + k3 * (fr_knee - knee)^2;
    let rl = k1 * rl_roll^2 + k2 * (rl_pitch - pitch)^2 + k3 * (rl_knee - knee)^2;
    let rr = k1 * rr_roll^2 + k2 * (rr_pitch - pitch)^2 + k3 * (rr_knee - knee)^2;
    potential = 1/2 * (fl + fr + rl + rr);
    let fl_spin = angular_momentum(fl_hip) + angular_momentum(fl_thigh) + angular_momentum(fl_calf);
    let fr_spin = angular_momentum(fr_hip) + angular_momentum(fr_thigh) + angular_momentum(fr_calf);
    let rl_spin = angular_momentum(rl_hip) + angular_momentum(rl_thigh) + angular_momentum(rl_calf);
    let rr_spin = angular_momentum(rr_hip) + angular_momentum(rr_thigh) + angular_momentum(rr_calf);
    let all = angular_momentum(trunk) + fl_spin + fr_spin + rl_spin + rr_spin;
    output spin = all.z;
    emit { drawing }
}

/// A state: position and orientation of the trunk, then the joints, and velocities in the same
/// order.
const Q: [f64; 19] = [
    0.0625, -0.125, 0.25, 0.8, 0.2, -0.4, 0.4, 0.25, 0.75, -1.25, -0.125, 1.0, -1.5, 0.125, 0.5, -1.75,
    -0.25, 0.875, -1.0,
];
const V: [f64; 18] =
    [0.25, -0.5, 0.125, 0.75, -0.25, 1.5, 1.0, -2.0, 3.0, -1.0, 0.5, 2.0, -0.75, 1.25, -3.0, 1.5, -0.5, 0.25];
/// Its accelerations, energy and angular momentum about the vertical, by Pinocchio 4.1.
const ACCELERATIONS: [f64; 18] = [
    -0.99080426989099,
    1.912451422284759,
    1.1906856526506882,
    -40.59810741998459,
    22.38127024120917,
    2.4620266301799676,
    -59.43620615521651,
    202.26390507170953,
    -553.5249258558529,
    74.28359937875013,
    -57.56064866750812,
    4.905909216399081,
    12.614284698567491,
    41.93117687455205,
    265.51974891740053,
    147.7403099104742,
    136.25520120309636,
    -506.9351472874331,
];
const ENERGY: f64 = 76.98742884627436;
const SPIN: f64 = 0.5269741501857148;

const END: f64 = 3.0;
/// Time between samples: those of what dampers dissipate are integrated by Simpson's rule.
const SAMPLE: f64 = 1e-3;

fn main() -> Result<(), Box<dyn Error>> {
    let quadruped = Quadruped::default();
    check_state(&quadruped);
    balance("without damping", &Quadruped { c: 0.0, ..quadruped })?;
    let run = balance("with damping", &quadruped)?;
    draw(&quadruped, &run)
}

fn check_state(quadruped: &Quadruped) {
    let accelerations = quadruped.acceleration(0.0, &Q, &V);
    let names = [
        "trunk x", "trunk y", "trunk z", "omega_x", "omega_y", "omega_z", "fl_roll", "fl_pitch", "fl_knee",
        "fr_roll", "fr_pitch", "fr_knee", "rl_roll", "rl_pitch", "rl_knee", "rr_roll", "rr_pitch", "rr_knee",
    ];
    let rows: [_; 18] = std::array::from_fn(|i| (names[i], accelerations[i], ACCELERATIONS[i]));
    compare("accelerations", 1e-12, &rows);
    let rows = [
        ("energy, J", quadruped.energy(0.0, &Q, &V), ENERGY),
        ("momentum, N m s", quadruped.spin(0.0, &Q, &V), SPIN),
    ];
    compare("of the same state", 1e-13, &rows);
}

/// A motion, with the balances of energy and angular momentum.
fn balance(title: &str, quadruped: &Quadruped) -> Result<Trajectory<Quadruped>, Box<dyn Error>> {
    let mut start = [0.0; 37];
    // Pulled down and aside and turning, with its legs where they are relaxed.
    start[..7].copy_from_slice(&[0.02, 0.0, 0.15, 1.0, 0.0, 0.0, 0.0]);
    (0..4)
        .for_each(|leg| start[8 + 3 * leg..10 + 3 * leg].copy_from_slice(&[quadruped.pitch, quadruped.knee]));
    start[24] = 1.5;
    let run = quadruped
        .simulate(start)
        .until(END)
        .every(SAMPLE)
        .tolerance(1e-11)
        .energy()
        .record("spin")
        .dense()
        .run()?;
    let column = |name: &str| run.column(name).unwrap_or_default();
    let (energy, spin, last) = (column("energy"), column("spin"), run.times().len() - 1);
    let power: Vec<f64> =
        run.iter().map(|(_, y)| quadruped.c * y[25..].iter().map(|rate| rate * rate).sum::<f64>()).collect();
    let lost =
        SAMPLE / 3.0 * power.windows(3).step_by(2).map(|part| part[0] + 4.0 * part[1] + part[2]).sum::<f64>();
    println!("{title}: {lost:.6} J are dissipated in {END} s");
    let rows = [("energy, J", energy[last] + lost, energy[0]), ("momentum, N m s", spin[last], spin[0])];
    compare("at the end and at the start", 1e-9, &rows);
    Ok(run)
}

/// A still picture and a film.
fn draw(quadruped: &Quadruped, run: &Trajectory<Quadruped>) -> Result<(), Box<dyn Error>> {
    let drawing = Drawing::of(quadruped).title("A quadruped on a spring").view(-0.8, 0.3).nameless();
    let still = drawing.clone().picture(1.0, &run.at(1.0)?)?;
    still.save(gallery::picture("quadruped.png")?)?;
    drawing.clone().film_at(30.0, run)?.save(gallery::picture("quadruped.html")?)?;
    drawing.size(360.0, 400.0).film_at(10.0, run)?.save(gallery::picture("quadruped.gif")?)?;
    Ok(())
}
