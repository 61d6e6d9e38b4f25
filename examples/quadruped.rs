//! A quadruped that is dropped, lands on its feet and stands.
//!
//! Masses, centres of mass and joints are taken from the public description of the Unitree Go2. A
//! free trunk and four legs of three links, with springs and dampers in their joints, have eighteen
//! degrees of freedom. The feet are rigid balls with friction on the ground, one line in the part
//! `Leg`. At rest, the normal forces carry the weight W, and balance its moments:
//!
//! ```text
//! Σ Nᵢ = W,    Σ Nᵢ xᵢ = W x,    Σ Nᵢ yᵢ = W y,    with the feet at xᵢ, yᵢ and the centre of mass at x, y.
//! ```
//!
//! Apart from springs and weights, only dampers, friction and impacts act, so the energy never
//! rises. Accelerations and energy of a state in the air are compared with Pinocchio's
//! (`tools/robots.py`), which applies joint torques. Look for the balances, and for forces within
//! Coulomb's cone at all times.
//!
//! `cargo run --example quadruped --features draw`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::contact::{Contact, Friction};
use lagrange::draw::Drawing;
use lagrange::integrate::Radau5;
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// A trunk with four legs on the ground: front and rear, left and right.
    #[derive(Clone, Debug)]
    pub struct Quadruped;

    /// Stiffness of the joints, roll, pitch and knee; angles at which they are relaxed; damping.
    param k1: N*m/rad = 60, k2: N*m/rad = 60, k3: N*m/rad = 60, pitch: rad = 0.8, knee: rad = -1.5, c: N*m*s/rad = 4;
    /// Coefficient of friction of the feet.
    param mu = 0.6;
    gravity = (0, 0, -9.81);

    body trunk { mass: 7.277000000000002; shape: cuboid(0.3762, 0.0935, 0.114); centroid: (0.020079174385048755, 0, -0.005103488525491267); inertia: (0.0257151774237163, 0.10295388328825997, 0.11264519436454368, 0.0001216600000000001, 0.001523257166511061, -0.000031200000000000006); }
    free trunk;

    /// A leg: `front` is 1 or −1, `left` is 1 or −1.
    part Leg(trunk, front, left, k1, k2, k3, pitch0, knee0, c, mu) {
        body hip { mass: 0.767; centroid: (-0.004773402868318123 [m] * front, 0.0016974837027379402 [m] * left, -0.0000928161668839635); inertia: (0.0005399915178106258, 0.0009981369647855932, 0.0006582847478620599, -0.0000021220993324641458 [kg*m^2] * front * left, 0.000001065392550195567 [kg*m^2] * front, -0.0000014027352647979139 [kg*m^2] * left); }
        body thigh { mass: 1.2409999999999999; centroid: (-0.0034717808219178084, -0.02302074939564867 [m] * left, -0.030354875100725223); inertia: (0.005996333341208702, 0.006001339409970024, 0.0010991471651674457, 0.00009030533435616439 [kg*m^2] * left, -0.00029910392372602736, 0.0008351509180338437 [kg*m^2] * left); }
        body calf { mass: 0.194; centroid: (0.004350103092783504, -0.0007739690721649483 [m] * left, -0.13520618556701028); inertia: (0.001394581937371134, 0.0014155052951752578, 0.00004348372739175258, 0.0000005096540206185566 [kg*m^2] * left, 0.00000014759587628866708, 0.000011313958762886598 [kg*m^2] * left); visual { solid_cylinder(0.012, 0.213), at: (0, 0, -0.1065); solid_sphere(0.022), at: (0, 0, -0.213); } }
        revolute roll = trunk to hip { at: (0.1934 [m] * front, 0.0465 [m] * left, 0); axis: (1, 0, 0); damping: c; }
        revolute pitch = hip to thigh { at: (0, 0.0955 [m] * left, 0); axis: (0, 1, 0); damping: c; }
        revolute knee = thigh to calf { at: (0, 0, -0.213); axis: (0, 1, 0); damping: c; }
        potential = 1/2 * (k1 * roll^2 + k2 * (pitch - pitch0)^2 + k3 * (knee - knee0)^2);
        contact foot = calf.point(0, 0, -0.213 [m]) on ground { friction: mu; radius: 0.022; }
        let moment = hip.center * 0.767 + thigh.center * 1.2409999999999999 + calf.center * 0.194;
        output normal = foot.normal;
        output friction = norm(foot.friction);
        output place = foot.point;
    }
    fl: Leg { trunk: trunk; front: 1; left: 1; k1: k1; k2: k2; k3: k3; pitch0: pitch; knee0: knee; c: c; mu: mu; }
    fr: Leg { trunk: trunk; front: 1; left: -1; k1: k1; k2: k2; k3: k3; pitch0: pitch; knee0: knee; c: c; mu: mu; }
    rl: Leg { trunk: trunk; front: -1; left: 1; k1: k1; k2: k2; k3: k3; pitch0: pitch; knee0: knee; c: c; mu: mu; }
    rr: Leg { trunk: trunk; front: -1; left: -1; k1: k1; k2: k2; k3: k3; pitch0: pitch; knee0: knee; c: c; mu: mu; }

    let mass = 7.277000000000002 + 4 * (0.767 + 1.2409999999999999 + 0.194);
    output center = (trunk.center * 7.277000000000002 + fl.moment + fr.moment + rl.moment + rr.moment) / mass;
    emit { drawing }
}

/// A state in the air: position and orientation of the trunk, then the joints; velocities are in
/// the same order.
const Q: [f64; 19] = [
    0.0625, -0.125, 0.5, 0.8, 0.2, -0.4, 0.4, 0.25, 0.75, -1.25, -0.125, 1.0, -1.5, 0.125, 0.5, -1.75, -0.25,
    0.875, -1.0,
];
const V: [f64; 18] =
    [0.25, -0.5, 0.125, 0.75, -0.25, 1.5, 1.0, -2.0, 3.0, -1.0, 0.5, 2.0, -0.75, 1.25, -3.0, 1.5, -0.5, 0.25];
/// Accelerations and energy in this state by Pinocchio 4.1.
const ACCELERATIONS: [f64; 18] = [
    2.657782262826317,
    -2.0263151930916274,
    -13.398705069375877,
    170.17975439630197,
    11.092416757455325,
    78.47537834748464,
    -1877.6795398001682,
    3579.138516206441,
    -10699.136996824407,
    348.9866360245204,
    -77.86543079645679,
    -1652.6248293611252,
    315.6411943979915,
    -692.3339528756406,
    6216.900317352676,
    1145.8898405411906,
    3896.2246903452096,
    -12447.272662149844,
];
const ENERGY: f64 = 100.70918679961733;

const WEIGHT: f64 = 9.81 * (7.277000000000002 + 4.0 * (0.767 + 1.2409999999999999 + 0.194));
/// Height of the drop.
const DROP: f64 = 0.05;
/// Final time of the film.
const LANDED: f64 = 1.5;
/// Time at which the quadruped is at rest.
const END: f64 = 8.0;
/// Columns of normal forces and of the magnitudes of friction forces.
const FORCES: [[&str; 2]; 4] = [
    ["fl.normal", "fl.friction"],
    ["fr.normal", "fr.friction"],
    ["rl.normal", "rl.friction"],
    ["rr.normal", "rr.friction"],
];

fn main() -> Result<(), Box<dyn Error>> {
    let quadruped = Quadruped::default();
    check_state(&quadruped);
    let run = drop(&quadruped)?;
    check_run(&quadruped, &run);
    check_rest(&run)?;
    draw(&quadruped, &run)
}

fn check_state(quadruped: &Quadruped) {
    let accelerations = quadruped.acceleration(0.0, &Q, &V);
    let names = [
        "trunk x", "trunk y", "trunk z", "omega_x", "omega_y", "omega_z", "fl roll", "fl pitch", "fl knee",
        "fr roll", "fr pitch", "fr knee", "rl roll", "rl pitch", "rl knee", "rr roll", "rr pitch", "rr knee",
    ];
    let rows: [_; 18] = std::array::from_fn(|i| (names[i], accelerations[i], ACCELERATIONS[i]));
    compare("accelerations", 1e-12, &rows);
    compare("of the same state", 1e-13, &[("energy, J", quadruped.energy(0.0, &Q, &V), ENERGY)]);
}

/// Drops the quadruped onto its feet, slightly rotated.
fn drop(quadruped: &Quadruped) -> Result<Trajectory<Quadruped>, Box<dyn Error>> {
    let mut start = [0.0; 37];
    let legs = 0.213 * (quadruped.pitch.cos() + (quadruped.pitch + quadruped.knee).cos());
    let (sin, cos) = 0.05_f64.sin_cos();
    start[2..7].copy_from_slice(&[legs + 0.022 + DROP, cos, 0.6 * sin, 0.8 * sin, 0.0]);
    for leg in 0..4 {
        start[8 + 3 * leg..10 + 3 * leg].copy_from_slice(&[quadruped.pitch, quadruped.knee]);
    }
    let run = quadruped.simulate(start).until(LANDED).every(1e-2).tolerance(1e-7).energy().dense();
    Ok(FORCES.iter().flatten().fold(run, |run, force| run.record(force)).run()?)
}

/// Checks that forces press and stay within the cone, and that the energy never rises.
fn check_run(quadruped: &Quadruped, run: &Trajectory<Quadruped>) {
    let column = |name: &str| run.column(name).unwrap_or_default();
    for [normal, friction] in FORCES.map(|forces| forces.map(column)) {
        let is_within = |(n, f): (&f64, &f64)| *n >= 0.0 && *f <= quadruped.mu * n + 1e-9;
        assert!(normal.len() == run.times().len() && normal.iter().zip(friction).all(is_within));
    }
    let energy = column("energy");
    assert!(energy.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9), "the energy rises");
    println!("{} events, {:.3} J are lost", run.events().len(), energy[0] - energy[energy.len() - 1]);
}

/// Checks that all feet stick, and that their forces balance the weight and its moments.
fn check_rest(run: &Trajectory<Quadruped>) -> Result<(), Box<dyn Error>> {
    let landed = run.system_at_end().ok_or("it has landed")?;
    let run = landed.simulate(run.last()).from(LANDED).until(END).method(Radau5::tolerance(1e-7)).run()?;
    let end = run.system_at_end().unwrap_or(landed);
    let contacts = [end.fl_foot, end.fr_foot, end.rl_foot, end.rr_foot];
    assert_eq!(contacts, [Contact::Closed; 4]);
    let frictions = [end.fl_foot_friction, end.fr_foot_friction, end.rl_foot_friction, end.rr_foot_friction];
    assert_eq!(frictions, [Friction::Sticks; 4]);
    let y = run.last();
    let (Some(q), Some(v)) = (y.first_chunk(), y.last_chunk()) else { return Err("a state".into()) };
    let normal = [
        end.fl_normal(END, q, v),
        end.fr_normal(END, q, v),
        end.rl_normal(END, q, v),
        end.rr_normal(END, q, v),
    ];
    let place =
        [end.fl_place(END, q, v), end.fr_place(END, q, v), end.rl_place(END, q, v), end.rr_place(END, q, v)];
    let moment = |axis: usize| (0..4).map(|leg| normal[leg] * place[leg][axis]).sum::<f64>();
    let center = end.center(END, q, v);
    let rows = [
        ("forces, N", normal.iter().sum(), WEIGHT),
        ("moment x, N m", moment(0), WEIGHT * center[0]),
        ("moment y, N m", moment(1), WEIGHT * center[1]),
    ];
    compare("at rest", 1e-6, &rows);
    Ok(())
}

/// Draws a still picture and a film.
fn draw(quadruped: &Quadruped, run: &Trajectory<Quadruped>) -> Result<(), Box<dyn Error>> {
    let drawing = Drawing::of(quadruped).title("A quadruped on its feet").view(-0.8, 0.3).nameless();
    let still = drawing.clone().picture(1.0, &run.at(1.0)?)?;
    still.save(gallery::picture("quadruped.png")?)?;
    drawing.clone().film_at(30.0, run)?.save(gallery::picture("quadruped.html")?)?;
    drawing.size(360.0, 400.0).film_at(10.0, run)?.save(gallery::picture("quadruped.gif")?)?;
    Ok(())
}
