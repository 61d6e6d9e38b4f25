//! Whipple's bicycle of four rigid bodies: the speeds at which it balances without a rider's hands.
//!
//! A rear frame with a rigid rider, a front frame and two wheels with sharp edges. The rear wheel's
//! point of contact is a coordinate. The front wheel touches the ground by one constraint on
//! positions, and both wheels roll by two constraints on velocities each. Of eight coordinates
//! seven are free, of eight velocities three.
//!
//! Rolling straight ahead is a steady motion at every speed. Its linear model is exact, with the
//! derivatives of the constraints that the turning of the wheels changes. Lean and steer separate
//! from the rest: M q̈ + v C₁ q̇ + (g K₀ + v² K₂) q = 0. These matrices are published to 14 digits.
//! So are the eigenvalues at 0 and at 5 m/s, and the speeds between which all decay. Source:
//! Meijaard, Papadopoulos, Ruina, Schwab, *Linearized dynamics equations for the balance and steer
//! of a bicycle: a benchmark and review*, Proc. R. Soc. A 463 (2007) 1955–1982, Tables 1 and 2.
//!
//! Look for the weave, an oscillation of lean and steer that grows below 4.3 m/s, and for the
//! capsize, a slow fall above 6.0 m/s.

mod common;

use std::error::Error;

use common::compare;
use lagrange::linear::{DenseMatrix, LinearModel, Linearise};

lagrange::system! {
    /// Whipple's bicycle; x ahead, y to the right, z down, as published.
    ///
    /// The rear wheel touches the ground at (x, y), its plane has the heading psi and leans by phi.
    /// The rear frame pitches by theta, the front frame is turned by delta about the steer axis.
    #[derive(Debug)]
    pub struct Bicycle;

    // Wheel base, trail, tilt of the steer axis, and radii of the wheels. Then masses, places and
    // moments of inertia: rear wheel r, rear frame with rider b, front frame h, front wheel f.
    const w: m = 1.02, c: m = 0.08, tilt: rad = pi/10, g: m/s^2 = 9.81, rr: m = 0.3, rf: m = 0.35;
    const mr: kg = 2, mb: kg = 85, mh: kg = 4, mf: kg = 3;
    const xb: m = 0.3, zb: m = -0.9, xh: m = 0.9, zh: m = -0.7;
    const irx: kg*m^2 = 0.0603, iry: kg*m^2 = 0.12, ifx: kg*m^2 = 0.1405, ify: kg*m^2 = 0.28;
    const ibx: kg*m^2 = 9.2, iby: kg*m^2 = 11, ibz: kg*m^2 = 2.8, ibxz: kg*m^2 = 2.4;
    const ihx: kg*m^2 = 0.05892, ihy: kg*m^2 = 0.06, ihz: kg*m^2 = 0.00708, ihxz: kg*m^2 = -0.00756;
    coord x: m, y: m, psi: rad, phi: rad, delta: rad, theta: rad, rear: rad, front: rad;

    // The plane of the rear wheel: ahead, across and downwards in it.
    let ahead = (cos(psi), sin(psi), 0);
    let across = (-sin(psi)*cos(phi), cos(psi)*cos(phi), sin(phi));
    let below = (sin(psi)*sin(phi), -cos(psi)*sin(phi), cos(phi));
    let hub = (x, y, 0) - rr * below;
    let turning = dot(psi) * (0, 0, 1) + dot(phi) * ahead;

    // Axes of the rear frame, and its place.
    let bx = cos(theta) * ahead - sin(theta) * below;
    let bz = sin(theta) * ahead + cos(theta) * below;
    let wb = turning + dot(theta) * across;
    let rider = hub + xb * bx + (rr + zb) * bz;

    // The steer axis, and axes that are turned about it.
    let steer = sin(tilt) * bx + cos(tilt) * bz;
    let level = cos(tilt) * bx - sin(tilt) * bz;
    let forward = cos(delta) * level + sin(delta) * across;
    let hy = cos(delta) * across - sin(delta) * level;
    let hx = cos(tilt) * forward + sin(tilt) * steer;
    let hz = cos(tilt) * steer - sin(tilt) * forward;
    let wh = wb + dot(delta) * steer;
    let foot = hub + (w + c) * bx + rr * bz;
    let fork = foot + (xh - w - c) * hx + zh * hz;
    let axle = foot - c * hx - rf * hz;

    kinetic = 1/2 * mr * inner(dot(hub), dot(hub)) + 1/2 * mb * inner(dot(rider), dot(rider));
    kinetic = 1/2 * mh * inner(dot(fork), dot(fork)) + 1/2 * mf * inner(dot(axle), dot(axle));
    let wr = turning + dot(rear) * across;
    kinetic = 1/2 * (irx * inner(wr, wr) + (iry - irx) * inner(wr, across)^2);
    let (b1, b2, b3) = (inner(wb, bx), inner(wb, across), inner(wb, bz));
    kinetic = 1/2 * (ibx * b1^2 + iby * b2^2 + ibz * b3^2) + ibxz * b1 * b3;
    let (h1, h2, h3) = (inner(wh, hx), inner(wh, hy), inner(wh, hz));
    kinetic = 1/2 * (ihx * h1^2 + ihy * h2^2 + ihz * h3^2) + ihxz * h1 * h3;
    let wf = wh + dot(front) * hy;
    kinetic = 1/2 * (ifx * inner(wf, wf) + (ify - ifx) * inner(wf, hy)^2);
    potential = -g * (mr * hub.z + mb * rider.z + mh * fork.z + mf * axle.z);

    // The wheels roll on their lowest points, in the plane of each wheel the farthest down.
    let rear_slip = dot(hub) + cross(wr, rr * below);
    constraint rear_x = rear_slip.x;
    constraint rear_y = rear_slip.y;
    let depth = sqrt(1 - hy.z^2);
    let down = ((0, 0, 1) - hy.z * hy) / depth;
    constraint touch = axle.z + rf * depth;
    let front_slip = dot(axle) + cross(wf, rf * down);
    constraint front_x = front_slip.x;
    constraint front_y = front_slip.y;
    emit { system_matrix, no latex }
}

/// Published: M, C₁, K₀ and K₂ of M q̈ + v C₁ q̇ + (g K₀ + v² K₂) q = 0 for lean and steer.
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
    println!("{}", ahead(5.0)?.modes()?);
    Ok(())
}

/// The linear model of rolling straight ahead.
fn ahead(speed: f64) -> Result<LinearModel, Box<dyn Error>> {
    let (rear_dot, front_dot) = (-speed / 0.3, -speed / 0.35);
    let near = BicycleState::from([0.0; 16]);
    let rolling = Bicycle.equilibrium(BicycleState { x_dot: speed, rear_dot, front_dot, ..near }).solve()?;
    Ok(Bicycle.linearise(0.0, rolling.state)?)
}

/// The rows and columns of lean, steer and their rates.
fn lateral(speed: f64) -> Result<DenseMatrix, Box<dyn Error>> {
    let model = ahead(speed)?;
    let place = |name: &str| model.states().iter().position(|state| state == name).ok_or("it is not free");
    let places = LATERAL.iter().map(|name| place(name)).collect::<Result<Vec<_>, _>>()?;
    Ok(DenseMatrix::from_fn(4, 4, |i, j| model.a()[(places[i], places[j])]))
}

/// M times the rates of the rates of lean and steer, beside what is published.
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

/// The eigenvalue of the oscillation.
fn weave(speed: f64) -> Result<(f64, f64), Box<dyn Error>> {
    let eigenvalues = lateral(speed)?.eigenvalues().unwrap_or_default();
    Ok(eigenvalues.into_iter().find(|(_, imaginary)| *imaginary > 0.0).ok_or("nothing oscillates")?)
}

/// The largest real eigenvalue.
fn capsize(speed: f64) -> Result<f64, Box<dyn Error>> {
    let eigenvalues = lateral(speed)?.eigenvalues().unwrap_or_default();
    let real = eigenvalues.into_iter().filter(|(_, imaginary)| *imaginary == 0.0).map(|(real, _)| real);
    Ok(real.fold(f64::NEG_INFINITY, f64::max))
}

/// The speed between these two at which a rate of growth passes zero, by bisection.
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
