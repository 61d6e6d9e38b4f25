//! A coin that rolls on a table without slipping.
//!
//! Coordinates are the point of contact x, y, the heading φ of the track, and the tilt θ of the
//! axis from the vertical. The last, ψ, is the coin's rotation about its own axis. Rolling is two
//! constraints on velocities that cannot be integrated to functions of the coordinates, so the coin
//! can reach any position in any orientation. Their multipliers are the friction of the table.
//!
//! Two motions are known. Leaning at a constant tilt the coin rolls in a circle if its spin ψ̇
//! matches the rate n of the heading,
//!
//! ```text
//! A n² sin θ cos θ − (C + m r²) n sin θ ω₃ = m g r cos θ,    ω₃ = ψ̇ + n cos θ
//! ```
//!
//! (Neimark, Fufaev, *Dynamics of Nonholonomic Systems*). Any other start wobbles; the reference
//! for one of them comes from Newton's and Euler's equations in 40-digit arithmetic.
//!
//! Look for the position after a full circle, which equals the initial one, and for the energy,
//! which rolling conserves.

mod common;

use std::error::Error;
use std::f64::consts::TAU;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A thin disk on a rough horizontal plane.
    #[derive(Clone, Debug)]
    pub struct Coin;

    param m: kg = 1.0, r: m = 1.0, a: kg*m^2 = 0.25, c: kg*m^2 = 0.5, g: m/s^2 = 9.81;
    coord x: m, y: m, phi: rad, theta: rad, psi: rad;

    let centre = (x - r * cos(theta) * sin(phi), y + r * cos(theta) * cos(phi), r * sin(theta));
    kinetic = 1/2 * m * inner(dot(centre), dot(centre));
    kinetic = 1/2 * a * (dot(theta)^2 + (dot(phi) * sin(theta))^2) + 1/2 * c * (dot(psi) + dot(phi) * cos(theta))^2;
    potential = m * g * centre.z;
    constraint rolling_x = dot(x) + r * dot(psi) * cos(phi);
    constraint rolling_y = dot(y) + r * dot(psi) * sin(phi);
    output normal_force = m * (g + ddot(centre.z));
}

/// Tilt of the axis; the coin is 69° from lying flat.
const TILT: f64 = 1.2;
/// Wobbling coin at t = 10 s: coordinates and the rates of heading, tilt and spin.
const WOBBLED: [f64; 8] = [
    3.920_410_792_797_404,
    1.493_740_698_031_011,
    7.053_596_825_713_759,
    1.181_923_221_783_248_5,
    -41.011_738_907_882_51,
    0.657_138_727_535_314_5,
    0.123_802_420_144_527_16,
    -4.074_443_161_865_263,
];

fn main() -> Result<(), Box<dyn Error>> {
    let coin = Coin::default();
    circle(&coin)?;
    wobble(&coin)
}

/// Returns the state of a coin that initially rolls along x, with these rates of heading and spin.
fn rolling(coin: &Coin, phi_dot: f64, psi_dot: f64) -> CoinState {
    let (x_dot, theta) = (-coin.r * psi_dot, TILT);
    CoinState {
        x: 0.0,
        y: 0.0,
        phi: 0.0,
        theta,
        psi: 0.0,
        x_dot,
        y_dot: 0.0,
        phi_dot,
        theta_dot: 0.0,
        psi_dot,
    }
}

fn circle(coin: &Coin) -> Result<(), Box<dyn Error>> {
    let &Coin { m, r, a, c, g } = coin;
    let (sine, cosine) = TILT.sin_cos();
    let rate = 1.5;
    let axial = (a * rate * rate * sine * cosine - m * g * r * cosine) / ((c + m * r * r) * rate * sine);
    let start = rolling(coin, rate, axial - rate * cosine);
    let trajectory = coin.simulate(start).until(TAU / rate).tolerance(1e-13).ends_only().run()?;
    let end = CoinState::from(trajectory.last());
    let (q, v) = (end.coordinates(), end.velocities());
    let t = trajectory.end_time();
    let [friction_x, friction_y] = coin.multipliers(t, &q, &v);
    // The force that keeps the centre on its circle about the centre of the track, towards which
    // the coin leans.
    let radius = r * (start.psi_dot / rate).abs() - r * cosine;
    let rows = [
        ("x, m", end.x, 0.0),
        ("y, m", end.y, 0.0),
        ("heading", end.phi, TAU),
        ("tilt", end.theta, TILT),
        ("friction x, N", friction_x, 0.0),
        ("friction y, N", friction_y, m * radius * rate * rate),
        ("normal force, N", coin.normal_force(t, &q, &v), m * g),
    ];
    compare("a full circle", 1e-11, &rows);
    Ok(())
}

fn wobble(coin: &Coin) -> Result<(), Box<dyn Error>> {
    let start = rolling(coin, 0.5, -4.0);
    let trajectory = coin.simulate(start).until(10.0).tolerance(1e-13).energy().run()?;
    let end = CoinState::from(trajectory.last());
    let found = [end.x, end.y, end.phi, end.theta, end.psi, end.phi_dot, end.theta_dot, end.psi_dot];
    let names = ["x, m", "y, m", "heading", "tilt", "turns", "heading, rad/s", "tilt, rad/s", "turns, rad/s"];
    let rows: [_; 8] = std::array::from_fn(|i| (names[i], found[i], WOBBLED[i]));
    compare("a wobbling coin, t = 10 s", 1e-11, &rows);
    let energies = trajectory.column("energy").unwrap_or_default();
    let drift = energies.iter().map(|energy| (energy / energies[0] - 1.0).abs()).fold(0.0, f64::max);
    println!("largest drift of the energy {drift:.1e}; {} steps", trajectory.work().steps);
    assert!(drift < 1e-12);
    Ok(())
}
