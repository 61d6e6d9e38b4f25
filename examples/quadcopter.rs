//! A quadcopter that takes off, moves aside while it turns, and flips over.
//!
//! A free body has no singular orientation: upside down is an orientation like any other. It
//! consists of a block, two rods across and four disks, the rotors. The thrusts f along the body's
//! Z-axis are its inputs, and each rotor exerts a reaction moment d f on the frame. The equations
//! about the centre of mass are
//!
//! ```text
//! m r̈ = −m g e_z + R e_z Σf,   J ω̇ + ω × J ω = (a (f₂ − f₄), a (f₃ − f₁), d (f₁ − f₂ + f₃ − f₄)).
//! ```
//!
//! The reference is the solution of these equations under scripted thrusts, with twenty digits
//! (`tools/quadcopter.py`). Then a geometric controller (Lee, Leok, McClamroch, "Geometric tracking
//! control of a quadrotor UAV on SE(3)", 2010) computes the thrusts 250 times a second. They
//! combine the force along R e_z that leads back to the path, and moments that turn R e_z into its
//! direction. During the flip it follows a rotation about its own X-axis instead.
//!
//! Look for thrusts that point downwards while it is upside down, and end at m g/4 each.
//!
//! First, a linear–quadratic regulator returns it from a position to the side, rotated by 0.4 rad,
//! to hovering. SciPy computes the same gain from a handwritten linear model, and the state after 2
//! s from the nonlinear equations above (`tools/optimal.py`).
//!
//! `cargo run --example quadcopter --features draw,linear,plot`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};

use common::compare;
use lagrange::Simulate;
use lagrange::body::SpatialMotion;
use lagrange::draw::Drawing;
use lagrange::linear::{DenseMatrix, Linearise};
use lagrange::simulate::Trajectory;
use lagrange::system::MechanicalSystem;

lagrange::system! {
    /// A block on crossed rods, with a rotor at each end.
    #[derive(Clone, Debug)]
    pub struct Quadcopter;

    /// Distance of the rotors from the middle and their height above it, and moment by thrust.
    param a: m = 0.25, h: m = 0.04, d: m = 0.02, g: m/s^2 = 9.81;
    /// Thrusts ahead, to the left, behind, and to the right.
    input f1: N, f2: N, f3: N, f4: N;

    gravity = (0, 0, -g);
    body copter {
        compound {
            cuboid(0.16, 0.16, 0.06), mass: 0.9;
            slender_rod(2*a), mass: 0.1;
            slender_rod(2*a), mass: 0.1, turned: (0, 0, pi/2);
            disk(0.11), mass: 0.03, at: (a, 0, h);
            disk(0.11), mass: 0.03, at: (0, a, h);
            disk(0.11), mass: 0.03, at: (-a, 0, h);
            disk(0.11), mass: 0.03, at: (0, -a, h);
        }
    }
    free copter;

    force copter.vector(0, 0, f1) at copter.point(a, 0, h);
    force copter.vector(0, 0, f2) at copter.point(0, a, h);
    force copter.vector(0, 0, f3) at copter.point(-a, 0, h);
    force copter.vector(0, 0, f4) at copter.point(0, -a, h);
    torque copter.vector(0, 0, d * (f1 - f2 + f3 - f4)) on copter;
    output center = copter.center;
    emit { motion, drawing, system_matrix }
}

/// Mass, height of its centre above the centre of the block, and principal moments of inertia.
const BODY: [f64; 5] =
    [1.22, 0.003934426229508197, 0.008559448087431695, 0.008559448087431695, 0.016232666666666666];
/// The centre of mass, orientation, velocity and angular velocity after 1.5 s of scripted thrusts.
const SCRIPTED: [f64; 13] = [
    -0.8352206116086041,
    2.2181069814126997,
    -7.095112654535997,
    -0.145323779559975,
    -0.5769151591456154,
    -0.6626140089664683,
    0.4549643649383741,
    -1.782148847738871,
    2.2617264730302393,
    -12.714942138071622,
    0.4064413162453598,
    -7.077507796594062,
    0.43835788234875944,
];

const PERIOD: f64 = 4e-3;
const END: f64 = 7.0;
/// Maximum thrust of a rotor, in N.
const STRONGEST: f64 = 9.0;
/// Times at which it is up, has moved aside, flips, and holds its position again.
const PHASES: [f64; 4] = [1.5, 3.0, 3.6, 4.2];
const HEIGHT: f64 = 1.0;
const ASIDE: f64 = 1.5;
/// Speed at the start of the flip in m/s.
const JUMP: f64 = 2.5;

fn main() -> Result<(), Box<dyn Error>> {
    let copter = Quadcopter::default();
    check_body(&copter);
    check_scripted(&copter)?;
    hover(&copter)?;
    let run = fly(&copter)?;
    check_flight(&run);
    draw(&copter, &run)
}

fn check_body(copter: &Quadcopter) {
    let body = copter.copter_motion(0.0, &REST.coordinates(), &REST.velocities());
    let computed = [body.mass, body.center[2], body.inertia[0][0], body.inertia[1][1], body.inertia[2][2]];
    let names = ["mass, kg", "centre, m", "J_x, kg m^2", "J_y", "J_z"];
    compare("the body", 1e-15, &[0, 1, 2, 3, 4].map(|i| (names[i], computed[i], BODY[i])));
}

/// State at rest at the origin, upright.
const REST: QuadcopterState = QuadcopterState {
    copter_x: 0.0,
    copter_y: 0.0,
    copter_z: 0.0,
    copter_qw: 1.0,
    copter_qx: 0.0,
    copter_qy: 0.0,
    copter_qz: 0.0,
    copter_vx: 0.0,
    copter_vy: 0.0,
    copter_vz: 0.0,
    copter_wx: 0.0,
    copter_wy: 0.0,
    copter_wz: 0.0,
};

/// Compares the end of a fall under thrusts m g/4 (1 + c sin(s t)).
fn check_scripted(copter: &Quadcopter) -> Result<(), Box<dyn Error>> {
    let hover = BODY[0] * copter.g / 4.0;
    let thrusts = |_: &Quadcopter, t: f64, _: QuadcopterState| {
        let share = |c: f64, s: f64| hover * (1.0 + c * (s * t).sin());
        QuadcopterInputs {
            f1: share(0.2, 3.0),
            f2: share(-0.15, 5.0),
            f3: share(0.1, 7.0),
            f4: share(0.25, 4.0),
        }
    };
    let end = copter.simulate(REST).until(1.5).drive(thrusts).tolerance(1e-14).ends_only().run()?.last();
    let state = QuadcopterState::from(end);
    let body = copter.copter_motion(1.5, &state.coordinates(), &state.velocities());
    let names = [
        "x, m",
        "y",
        "z",
        "q_w",
        "q_x",
        "q_y",
        "q_z",
        "v_x, m/s",
        "v_y",
        "v_z",
        "omega_x, rad/s",
        "omega_y",
        "omega_z",
    ];
    let computed = [&body.center[..], &end[3..7], &body.velocity, &end[10..]].concat();
    let rows: [_; 13] = std::array::from_fn(|i| (names[i], computed[i], SCRIPTED[i]));
    compare("after 1.5 s of scripted thrusts", 1e-12, &rows);
    Ok(())
}

/// Gain of the regulator for the front rotor.
const GAIN: [f64; 12] = [
    -2.236067977499784,
    0.0,
    1.581138830084189,
    0.0,
    -5.420118908256069,
    1.0,
    -1.723629288908902,
    0.0,
    1.102041145489295,
    0.0,
    -0.8345975549581596,
    0.80982508399448,
];
/// Position, orientation, velocity and angular velocity after 2 s. The start is at (1, −0.5, 0.3),
/// rotated by 0.4 rad about (2, −1, 2)/3.
const REGULATED: [f64; 13] = [
    -0.004351801644371073,
    0.00823831347495289,
    -0.02152117463777356,
    0.9999757174078105,
    0.006462255606093576,
    0.002044398141190849,
    -0.00161996402933864,
    0.01592666432253694,
    -0.00230072561120388,
    0.01856226524951376,
    -0.07058706219603364,
    -0.05243797215062937,
    0.0009938460657340359,
];

/// Hovers by a regulator, whose thrusts are those of equilibrium minus K δ. The deviation δ of an
/// orientation is a rotation about the axes of the body.
fn hover(copter: &Quadcopter) -> Result<(), Box<dyn Error>> {
    let found = copter.equilibrium(REST).trim(&["f1", "f2", "f3", "f4"]).solve()?;
    let rows = [0, 1, 2, 3].map(|i| ("thrust, N", found.inputs[i], BODY[0] * copter.g / 4.0));
    compare("hovering", 1e-14, &rows);
    let model = found.system(copter).linearise(0.0, found.state)?;
    let weights = [[10.0; 3], [4.0; 3], [1.0; 3], [1.0; 3]].concat();
    let gain = model.lqr(&DenseMatrix::diagonal(&weights), &DenseMatrix::identity(4))?.gain;
    let rows: [_; 12] = std::array::from_fn(|i| (model.states()[i].as_str(), gain[(0, i)], GAIN[i]));
    compare("gain of the rotor ahead", 1e-10, &rows);

    let place = QuadcopterState::from(found.state);
    let law = move |copter: &Quadcopter, t: f64, state: QuadcopterState| {
        let displacement = copter.displacement(t, &place.coordinates(), &state.coordinates());
        let deviation = [displacement, state.velocities()].concat();
        let thrust = |i: usize| found.inputs[i] - (0..12).map(|j| gain[(i, j)] * deviation[j]).sum::<f64>();
        QuadcopterInputs::from([0, 1, 2, 3].map(thrust))
    };
    let (sine, cosine) = 0.2_f64.sin_cos();
    let start = QuadcopterState {
        copter_x: 1.0,
        copter_y: -0.5,
        copter_z: 0.3,
        copter_qw: cosine,
        copter_qx: 2.0 / 3.0 * sine,
        copter_qy: -sine / 3.0,
        copter_qz: 2.0 / 3.0 * sine,
        ..REST
    };
    let run = copter.simulate(start).drive(law).until(4.0).every(0.02).tolerance(1e-13).run()?;
    let state = run.state(100).ok_or("the motion is shorter")?;
    let rows: [_; 13] = std::array::from_fn(|i| (run.names()[i].as_str(), state[i], REGULATED[i]));
    compare("regulated, after 2 s", 1e-10, &rows);
    let thrusts = ["f1", "f2", "f3", "f4"].map(|name| run.column(name).unwrap_or_default());
    assert!(thrusts.iter().flat_map(|thrust| *thrust).all(|thrust| (0.0..STRONGEST).contains(thrust)));
    run.plot_columns(&["copter_x", "copter_y", "copter_z"], gallery::picture("quadcopter_lqr.svg")?)?;
    Ok(())
}

type Vector = [f64; 3];
type Matrix = [Vector; 3];

/// The target of the controller: the position of the centre of mass and the azimuth of the body's
/// X-axis, or a rotation about this axis.
#[derive(Clone, Copy)]
enum Wanted {
    Place { place: Vector, velocity: Vector, acceleration: Vector, heading: [f64; 2] },
    Turn { angle: f64, rate: f64, acceleration: f64 },
}

/// Returns a transition from 0 to 1 with minimum jerk, with its first two derivatives.
fn blend(from: f64, to: f64, t: f64) -> [f64; 3] {
    let (span, part) = (to - from, ((t - from) / (to - from)).clamp(0.0, 1.0));
    let rate = 30.0 * part * part * (1.0 - part).powi(2) / span;
    let bend = 60.0 * part * (1.0 - part) * (1.0 - 2.0 * part) / (span * span);
    [part.powi(3) * (10.0 - 15.0 * part + 6.0 * part * part), rate, bend]
}

fn wanted(t: f64) -> Wanted {
    let [up, aside, flips, holds] = PHASES;
    let (rise, step) = (blend(0.0, up, t), blend(up, aside, t));
    if (flips..holds).contains(&t) {
        let [angle, rate, acceleration] = blend(flips, holds, t).map(|part| TAU * part);
        return Wanted::Turn { angle, rate, acceleration };
    }
    let push = JUMP / (flips - aside);
    let run_up = if (aside..flips).contains(&t) { t - aside } else { 0.0 };
    let [z, v, a] =
        [HEIGHT * rise[0] + 0.5 * push * run_up * run_up, HEIGHT * rise[1] + push * run_up, HEIGHT * rise[2]];
    Wanted::Place {
        place: [0.0, ASIDE * step[0], z],
        velocity: [0.0, ASIDE * step[1], v],
        acceleration: [0.0, ASIDE * step[2], if run_up > 0.0 { push } else { a }],
        heading: [FRAC_PI_2 * step[0], FRAC_PI_2 * step[1]],
    }
}

/// Rate of the position feedback in 1/s.
const PLACE_RATE: f64 = 5.0;
/// Rate of the orientation feedback in 1/s.
const TURN_RATE: f64 = 24.0;

/// Computes thrusts from the state: the force along the axis of the rotors, and moments from the
/// deviation of the orientation.
fn thrusts(copter: &Quadcopter, t: f64, body: &SpatialMotion<f64>) -> QuadcopterInputs {
    let (axes, weight) = (body.rotation, body.mass * copter.g);
    let (orientation, force, rates, accelerations) = match wanted(t) {
        Wanted::Place { place, velocity, acceleration, heading: [azimuth, rate] } => {
            let mut pull: Vector = std::array::from_fn(|i| {
                let [off, drift] = [place[i] - body.center[i], velocity[i] - body.velocity[i]];
                body.mass * (acceleration[i] + PLACE_RATE * (PLACE_RATE * off + 2.0 * drift))
            });
            pull[2] += weight;
            let along = inner(pull, column(&axes, 2));
            (upright(pull, azimuth), along, [0.0, 0.0, rate], [0.0; 3])
        }
        Wanted::Turn { angle, rate, acceleration } => {
            // Rotation about X, which points along the world's y after the preceding quarter turn.
            let (sin, cos) = angle.sin_cos();
            let orientation = [[0.0, -cos, sin], [1.0, 0.0, 0.0], [0.0, sin, cos]];
            (orientation, 0.6 * weight, [rate, 0.0, 0.0], [acceleration, 0.0, 0.0])
        }
    };
    let spin = body.to_body(body.angular_velocity);
    let off = deviation(&orientation, &axes);
    let turning: Vector = std::array::from_fn(|i| {
        accelerations[i] - TURN_RATE * (TURN_RATE * off[i] + 2.0 * (spin[i] - rates[i]))
    });
    let carried = cross(spin, product(&body.inertia, spin));
    let inertial = product(&body.inertia, turning);
    mixed(copter, force, std::array::from_fn(|i| inertial[i] + carried[i]))
}

/// Returns the thrusts that produce this force and these moments, within the limits of the rotors.
fn mixed(copter: &Quadcopter, force: f64, [mx, my, mz]: Vector) -> QuadcopterInputs {
    let (mean, x, y, z) = (force / 4.0, mx / (2.0 * copter.a), my / (2.0 * copter.a), mz / (4.0 * copter.d));
    QuadcopterInputs::from(
        [mean - y + z, mean + x - z, mean + y + z, mean - x - z].map(|f| f.clamp(0.0, STRONGEST)),
    )
}

/// Returns the orientation, in rows, with Z in this direction and X at this azimuth.
fn upright(direction: Vector, azimuth: f64) -> Matrix {
    let z = unit(direction);
    let y = unit(cross(z, [azimuth.cos(), azimuth.sin(), 0.0]));
    let x = cross(y, z);
    [0, 1, 2].map(|row| [x[row], y[row], z[row]])
}

/// Returns half the vector of the antisymmetric part of Dᵀ R. For small rotations it is the angle
/// from D to R, along the axes of the body.
fn deviation(wanted: &Matrix, axes: &Matrix) -> Vector {
    let entry = |i: usize, j: usize| inner(column(wanted, i), column(axes, j));
    [entry(2, 1) - entry(1, 2), entry(0, 2) - entry(2, 0), entry(1, 0) - entry(0, 1)].map(|twice| 0.5 * twice)
}

fn fly(copter: &Quadcopter) -> Result<Trajectory<Quadcopter>, Box<dyn Error>> {
    let control = |copter: &Quadcopter, t: f64, state: QuadcopterState| {
        thrusts(copter, t, &copter.copter_motion(t, &state.coordinates(), &state.velocities()))
    };
    let run = copter.simulate(REST).until(END).sampled(PERIOD, control).every(0.04).tolerance(1e-10);
    Ok(run.record("center").dense().run()?)
}

/// Checks that the copter hovers upright at its target again.
fn check_flight(run: &Trajectory<Quadcopter>) {
    let thrusts = ["f1", "f2", "f3", "f4"].map(|name| run.column(name).unwrap_or_default());
    let strongest = thrusts.iter().flat_map(|thrust| thrust.iter()).fold(0.0_f64, |a, b| a.max(*b));
    let lowest = run.copter_qw().iter().zip(run.copter_qx()).zip(run.copter_qy()).zip(run.copter_qz());
    let tilted = lowest.map(|(((w, x), y), z)| w * w - x * x - y * y + z * z).fold(1.0, f64::min);
    println!("strongest thrust {strongest:.3} N; upside down: Z is downwards by {:.4}\n", -tilted);
    let last = |name: &str| run.column(name).and_then(|column| column.last().copied()).unwrap_or(f64::NAN);
    let hover = BODY[0] * 9.81 / 4.0;
    let rows = ["f1", "f2", "f3", "f4"].map(|name| (name, last(name), hover));
    compare("hovering, N", 1e-4, &rows);
    let rows = [("center.x", 0.0), ("center.y", ASIDE), ("center.z", HEIGHT)]
        .map(|(name, at)| (name, last(name), at));
    compare("in its place, m", 1e-4, &rows);
}

/// Draws the flight with the thrusts at the beginning of the flip, and a film.
fn draw(copter: &Quadcopter, run: &Trajectory<Quadcopter>) -> Result<(), Box<dyn Error>> {
    let shown = PHASES[2] + 0.16;
    let y = run.at(shown)?;
    let state = QuadcopterState::from(y);
    let QuadcopterInputs { f1, f2, f3, f4 } =
        thrusts(copter, shown, &copter.copter_motion(shown, &state.coordinates(), &state.velocities()));
    let driven = Quadcopter { f1, f2, f3, f4, ..*copter };
    let drawing = Drawing::of(&driven)
        .title("A quadcopter flips")
        .view(0.5, 0.3)
        .nameless()
        .floor(0.0)
        .forces()
        .hide("torque")
        .hide("gravity");
    let drawing = drawing.trace("", |copter, t, y| {
        let state = QuadcopterState::from(*y);
        copter.center(t, &state.coordinates(), &state.velocities())
    });
    let still = drawing.clone().past(run.iter().filter(|(t, _)| *t < shown)).picture(shown, &y)?;
    still.save(gallery::picture("quadcopter.png")?)?;
    drawing.clone().film_at(30.0, run)?.save(gallery::picture("quadcopter.html")?)?;
    drawing.size(360.0, 360.0).film_at(10.0, run)?.save(gallery::picture("quadcopter.gif")?)?;
    Ok(())
}

fn inner(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Vector) -> Vector {
    a.map(|part| part / inner(a, a).sqrt())
}

fn product(matrix: &Matrix, vector: Vector) -> Vector {
    matrix.map(|row| inner(row, vector))
}

fn column(matrix: &Matrix, index: usize) -> Vector {
    matrix.map(|row| row[index])
}
