//! Whipple's bicycle of four rigid bodies: the speeds at which it balances without a rider's hands.
//!
//! The model consists of a rear frame with a rigid rider, a front frame and two wheels with sharp
//! edges. The rear wheel's point of contact is a coordinate. The front wheel touches the ground by
//! one constraint on positions, and both wheels roll by two constraints on velocities each. Seven
//! of the eight coordinates are free, and three of the eight velocities.
//!
//! Rolling straight ahead is a steady motion at every speed. Its linear model is exact, including
//! derivatives of the constraints that change as the wheels turn. Lean and steer decouple from the
//! rest: M q̈ + v C₁ q̇ + (g K₀ + v² K₂) q = 0. These matrices are published to 14 digits. The same
//! is true of the eigenvalues at 0 and at 5 m/s, and of the range of speeds in which all modes
//! decay. Source: Meijaard, Papadopoulos, Ruina, Schwab, *Linearized dynamics equations for the
//! balance and steer of a bicycle: a benchmark and review*, Proc. R. Soc. A 463 (2007) 1955–1982,
//! Tables 1 and 2.
//!
//! Look for the weave, an oscillation of lean and steer that grows below 4.3 m/s, and for the
//! capsize, a slow fall above 6.0 m/s.
//!
//! `cargo run --example bicycle --features draw,linear`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;

use common::compare;
use lagrange::draw::{Drawing, Picture};
use lagrange::linear::{DenseMatrix, LinearModel, Linearise};

lagrange::system! {
    /// Whipple's bicycle; x ahead, y to the left, z up.
    ///
    /// The rear wheel touches the ground at (x, y), its plane has the heading psi and leans by phi.
    /// The rear frame pitches by theta, the front frame is turned by delta about the steer axis.
    #[derive(Debug)]
    pub struct Bicycle;

    // Wheel base, trail, tilt of the steer axis, and radii of the wheels. Then places and moments
    // of inertia as published, with z down: rear wheel r, rear frame with rider b, front frame h,
    // front wheel f.
    const w: m = 1.02, c: m = 0.08, tilt: rad = pi/10, g: m/s^2 = 9.81, rr: m = 0.3, rf: m = 0.35;
    const xb: m = 0.3, zb: m = -0.9, xh: m = 0.9, zh: m = -0.7;
    const irx: kg*m^2 = 0.0603, iry: kg*m^2 = 0.12, ifx: kg*m^2 = 0.1405, ify: kg*m^2 = 0.28;
    const ibx: kg*m^2 = 9.2, iby: kg*m^2 = 11, ibz: kg*m^2 = 2.8, ibxz: kg*m^2 = 2.4;
    const ihx: kg*m^2 = 0.05892, ihy: kg*m^2 = 0.06, ihz: kg*m^2 = 0.00708, ihxz: kg*m^2 = -0.00756;
    coord x: m, y: m, psi: rad, phi: rad, theta: rad;
    gravity = (0, 0, -g);

    // Upwards in the plane of the rear wheel.
    let up = (sin(psi)*sin(phi), -cos(psi)*sin(phi), cos(phi));
    body rider {
        mass: 85 kg;
        centroid: (xb, 0, -rr - zb);
        inertia: (ibx, iby, ibz, 0, -ibxz, 0);
        origin: (x, y, 0) + rr * up;
        angles: (psi, phi, theta);
        sequence: zxy;
        visual {
            cuboid(0.95, 0.04, 0.04), at: (0.42, 0, 0.15), turned: (0, -0.33, 0);
            cuboid(0.04, 0.04, 0.55), at: (0.25, 0, 0.3), turned: (0, -0.2, 0);
            ellipsoid(0.14, 0.2, 0.32), at: (0.32, 0, 0.85), turned: (0, 0.5, 0);
            solid_sphere(0.12), at: (0.55, 0, 1.25);
        }
    }
    body hind { mass: 2 kg; inertia: (irx, iry, irx); visual { thin_ring(rr), turned: (pi/2, 0, 0); cuboid(2*rr, 0.02, 0.02); } }
    revolute rear = rider to hind { axis: (0, 1, 0); }
    body fork {
        mass: 4 kg;
        centroid: (xh - w - c, 0, -zh);
        inertia: (ihx, ihy, ihz, 0, -ihxz, 0);
        visual {
            cuboid(0.03, 0.05, 0.75), at: (-0.2, 0, 0.68), turned: (0, -tilt, 0);
            cuboid(0.03, 0.5, 0.03), at: (-0.31, 0, 1.05);
        }
    }
    revolute delta = rider to fork { at: (w + c, 0, -rr); axis: (sin(tilt), 0, -cos(tilt)); }
    body wheel { mass: 3 kg; inertia: (ifx, ify, ifx); visual { thin_ring(rf), turned: (pi/2, 0, 0); cuboid(2*rf, 0.02, 0.02); } }
    revolute front = fork to wheel { at: (-c, 0, rf); axis: (0, 1, 0); }

    // The wheels roll on their lowest points, each the farthest down in the plane of its wheel.
    let rear_slip = velocity(hind) + cross(angular_velocity(hind), -rr * up);
    constraint rear_x = rear_slip.x;
    constraint rear_y = rear_slip.y;
    let hy = fork.vector(0, 1, 0);
    let depth = sqrt(1 - hy.z^2);
    let down = (hy.z * hy - (0, 0, 1)) / depth;
    constraint touch = wheel.origin.z - rf * depth;
    let front_slip = velocity(wheel) + cross(angular_velocity(wheel), rf * down);
    constraint front_x = front_slip.x;
    constraint front_y = front_slip.y;
    emit { system_matrix, drawing, no latex }
}

/// Published values of M, C₁, K₀ and K₂ in M q̈ + v C₁ q̇ + (g K₀ + v² K₂) q = 0 for lean and
/// steer.
const M: [[f64; 2]; 2] = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]];
const C1: [[f64; 2]; 2] = [[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]];
const K0: [[f64; 2]; 2] = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]];
const K2: [[f64; 2]; 2] = [[0.0, 76.59734589573222], [0.0, 2.65431523794604]];

/// Names of lean, steer and their rates.
const LATERAL: [&str; 4] = ["phi", "delta", "phi_dot", "delta_dot"];

fn main() -> Result<(), Box<dyn Error>> {
    for speed in [0.0, 1.0, 5.0] {
        matrices(speed)?;
    }
    let eigenvalues = lateral(0.0)?.eigenvalues().unwrap_or_default();
    let largest = eigenvalues.iter().map(|(real, _)| *real).fold(f64::NEG_INFINITY, f64::max);
    compare("standing: the faster fall", 1e-12, &[("real", largest, 5.530943717653933)]);
    let ((decay, frequency), fall) = (weave(5.0)?, capsize(5.0)?);
    compare(
        "at 5 m/s",
        1e-12,
        &[
            ("weave", decay, -0.775341882195845),
            ("its frequency", frequency, 4.464867713788229),
            ("capsize", fall, -0.322866429004087),
        ],
    );
    let stable = zero(|speed| Ok(weave(speed)?.0), 3.0, 6.0)?;
    let unstable = zero(capsize, 5.0, 8.0)?;
    compare(
        "self-stable between",
        1e-12,
        &[("weave", stable, 4.29238253634111), ("capsize", unstable, 6.02426201538837)],
    );
    println!("{}", rolling(5.0)?.1.modes()?);
    draw(5.0)
}

/// Draws the weave as seen by a passing rider, without its decay.
fn draw(speed: f64) -> Result<(), Box<dyn Error>> {
    let (state, model) = rolling(speed)?;
    let modes = model.modes()?;
    let weave = modes.modes().iter().find(|mode| mode.imaginary > 1.0).ok_or("nothing oscillates")?;
    let weaving = Bicycle.mode_motion(0.0, state, weave, 0.3).level().periods(1.0);
    let drawing = Drawing::of(&Bicycle).nameless().hide("delta").view(-0.6, 0.35).floor(0.0);
    Picture::beside(&drawing.clone().size(420.0, 420.0).pictures(weaving.extremes()?)?)
        .save(gallery::picture("bicycle.png")?)?;
    let drawing = drawing.title("The weave of a bicycle at 5 m/s");
    drawing.clone().timed_film(weaving.moments(30.0)?)?.save(gallery::picture("bicycle.html")?)?;
    drawing.size(360.0, 360.0).timed_film(weaving.moments(15.0)?)?.save(gallery::picture("bicycle.gif")?)?;
    Ok(())
}

/// Returns the state of rolling straight ahead, and its linear model.
fn rolling(speed: f64) -> Result<([f64; 16], LinearModel), Box<dyn Error>> {
    let (rear_dot, front_dot) = (speed / 0.3, speed / 0.35);
    let near = BicycleState::from([0.0; 16]);
    let rolling = Bicycle.equilibrium(BicycleState { x_dot: speed, rear_dot, front_dot, ..near }).solve()?;
    Ok((rolling.state, Bicycle.linearise(0.0, rolling.state)?))
}

/// Returns the rows and columns of lean, steer and their rates.
fn lateral(speed: f64) -> Result<DenseMatrix, Box<dyn Error>> {
    let (_, model) = rolling(speed)?;
    let place = |name: &str| model.states().iter().position(|state| state == name).ok_or("it is not free");
    let places = LATERAL.iter().map(|name| place(name)).collect::<Result<Vec<_>, _>>()?;
    Ok(DenseMatrix::from_fn(4, 4, |i, j| model.a()[(places[i], places[j])]))
}

/// Compares M times the rates of the rates of lean and steer with published values.
fn matrices(speed: f64) -> Result<(), Box<dyn Error>> {
    let a = lateral(speed)?;
    let mut rows = Vec::new();
    for (i, row) in M.iter().enumerate() {
        for j in 0..2 {
            let times = |column: usize| -(row[0] * a[(2, column)] + row[1] * a[(3, column)]);
            rows.push((STIFFNESS[i][j], times(j), 9.81 * K0[i][j] + speed * speed * K2[i][j]));
            rows.push((DAMPING[i][j], times(2 + j), speed * C1[i][j]));
        }
    }
    compare(&format!("matrices at {speed} m/s"), 1e-12, &rows);
    Ok(())
}

const STIFFNESS: [[&str; 2]; 2] = [["K lean, lean", "K lean, steer"], ["K steer, lean", "K steer, steer"]];
const DAMPING: [[&str; 2]; 2] = [["C lean, lean", "C lean, steer"], ["C steer, lean", "C steer, steer"]];

/// Returns the eigenvalue of the oscillation.
fn weave(speed: f64) -> Result<(f64, f64), Box<dyn Error>> {
    let eigenvalues = lateral(speed)?.eigenvalues().unwrap_or_default();
    Ok(eigenvalues.into_iter().find(|(_, imaginary)| *imaginary > 0.0).ok_or("nothing oscillates")?)
}

/// Returns the largest real eigenvalue.
fn capsize(speed: f64) -> Result<f64, Box<dyn Error>> {
    let eigenvalues = lateral(speed)?.eigenvalues().unwrap_or_default();
    let real = eigenvalues.into_iter().filter(|(_, imaginary)| *imaginary == 0.0).map(|(real, _)| real);
    Ok(real.fold(f64::NEG_INFINITY, f64::max))
}

/// Returns the speed between two others at which a growth rate crosses zero, by bisection.
fn zero(
    rate: impl Fn(f64) -> Result<f64, Box<dyn Error>>,
    mut low: f64,
    mut high: f64,
) -> Result<f64, Box<dyn Error>> {
    let is_growing = rate(low)? > 0.0;
    while high - low > 1e-15 * high {
        let middle = low.midpoint(high);
        if middle == low || middle == high {
            break;
        }
        *(if (rate(middle)? > 0.0) == is_growing { &mut low } else { &mut high }) = middle;
    }
    Ok(low)
}
