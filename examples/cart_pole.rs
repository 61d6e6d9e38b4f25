//! A cart that carries a pendulum: first left alone, then balanced upright by a force on the cart.
//!
//! The reference state of the free motion, t = 5 s after release close to the upright position, was computed
//! in 160-bit arithmetic with two step counts that agree in all printed digits.
//!
//! The second run closes a loop: a linear feedback, whose gains put the poles of the linearised motion
//! at −2 s⁻¹ and −3 s⁻¹, sets the force on the cart, and friction acts in the joint. There is no reference for it, but there is the energy balance
//!
//! ```text
//! ΔE = ∫ u ẋ dt − ∫ c θ̇² dt,
//! ```
//!
//! whose integrals are computed along with the motion. Look for the tip, which ends above the cart's starting
//! point, and for the balance.

mod common;

use std::error::Error;
use std::f64::consts::PI;

use common::compare;
use lagrange::Simulate;
use lagrange::integrate::{Verner98, integrate};
use lagrange::system::Wrapper;

lagrange::system! {
    /// A cart that carries a pendulum, pushed by a force u; θ is measured from the lower position.
    #[derive(Clone, Debug)]
    pub struct CartPole;

    param mc = 1.0, mp = 0.1, l = 0.5, c = 0.0, g = 9.81;
    coord x, theta;
    input u;

    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
    dissipation = 1/2 * c * dot(theta)^2;
    force x = u;
    output tip = (px, py);
}

/// x θ ẋ θ̇ of the free motion at t = 5 s.
const REFERENCE: [f64; 4] =
    [0.020042933115664744, -2.8370839467698628, -0.05381218271021493, -1.2409591267549178];
/// Force on the cart per deviation of x, θ, ẋ, θ̇ from rest at the upright position.
const GAINS: [f64; 4] = [1.8, -30.8, 3.1, -6.3];

fn main() -> Result<(), Box<dyn Error>> {
    left_alone()?;
    balanced()
}

fn left_alone() -> Result<(), Box<dyn Error>> {
    let cart = CartPole::default();
    let trajectory = cart.simulate([0.0, 3.0, 0.0, 0.0]).until(5.0).tolerance(1e-13).run()?;
    let end = trajectory.last();
    let rows: [_; 4] = std::array::from_fn(|i| (trajectory.names()[i].as_str(), end[i], REFERENCE[i]));
    compare("left alone, t = 5 s", 1e-11, &rows);
    Ok(())
}

fn balanced() -> Result<(), Box<dyn Error>> {
    let system = Balanced { plant: CartPole { c: 0.01, ..CartPole::default() } };
    let start = [0.0, PI - 0.3, 0.0, 0.0, 0.0, 0.0];
    let end = integrate(&system, 0.0, start, 10.0, &Verner98::tolerance(1e-13), |_, _| {})?;
    let [.., work, heat] = end;
    let gained = system.energy(end) - system.energy(start);
    compare("balanced, t = 10 s", 1e-11, &[("energy gained", gained, work - heat)]);
    println!("work of the force {work:.6} J, heat in the joint {heat:.6} J");

    let state = CartPoleState::from(motion(end));
    let [x, y] = system.plant.tip(10.0, &state.coordinates(), &state.velocities());
    compare("tip", 1e-3, &[("x", x, 0.0), ("y", y, system.plant.l)]);
    Ok(())
}

/// The cart under feedback, with the work of the force and the heat in the joint after the state.
struct Balanced {
    plant: CartPole,
}

impl Wrapper for Balanced {
    type Inner = CartPole;
    type State = [f64; 6];

    fn inner(&self) -> &CartPole {
        &self.plant
    }

    fn around(&self, plant: CartPole) -> Balanced {
        Balanced { plant }
    }

    fn outer_rhs(&self, t: f64, y: &[f64; 6]) -> [f64; 6] {
        let [x, theta, x_dot, theta_dot, ..] = *y;
        let deviation = [x, theta - PI, x_dot, theta_dot];
        let u = GAINS.iter().zip(deviation).map(|(gain, deviation)| gain * deviation).sum::<f64>();
        let [v0, v1, a0, a1] = CartPole { u, ..self.plant.clone() }.rhs(t, &motion(*y));
        [v0, v1, a0, a1, u * x_dot, self.plant.c * theta_dot * theta_dot]
    }
}

impl Balanced {
    fn energy(&self, y: [f64; 6]) -> f64 {
        let state = CartPoleState::from(motion(y));
        self.plant.energy(0.0, &state.coordinates(), &state.velocities())
    }
}

/// The state of the cart alone.
fn motion([x, theta, x_dot, theta_dot, ..]: [f64; 6]) -> [f64; 4] {
    [x, theta, x_dot, theta_dot]
}
