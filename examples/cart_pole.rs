//! A cart that carries a pendulum. At first it moves freely, then a force on the cart balances the
//! pendulum upright. Finally a computer sets the force fifty times a second.
//!
//! The reference state of the free motion is at t = 5 s after release close to the upright
//! position. It was computed in 160-bit arithmetic with two step counts that agree in all printed
//! digits. The states of the controlled motions are computed by `tools/control.py` from handwritten
//! equations.
//!
//! Last, a linear–quadratic regulator balances the pendulum from half a radian. SciPy computes the
//! same gain from a handwritten linear model, and the state after 3 s (`tools/optimal.py`).
//!
//! The first feedback is also linear. Without friction in the joint, the poles of the linearised
//! motion about the upright are at −1.29 ± 0.50 i s⁻¹ and −3.46 ± 2.55 i s⁻¹. Look for the tip,
//! which ends above the cart's starting point.
//!
//! `cargo run --example cart_pole --features linear,plot`

#[path = "common/gallery.rs"]
mod gallery;

mod common;

use std::error::Error;
use std::f64::consts::PI;

use common::compare;
use lagrange::Simulate;
use lagrange::linear::{DenseMatrix, Linearise};
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// A cart that carries a pendulum, pushed by a force u; θ is measured from the lower position.
    #[derive(Clone, Debug)]
    pub struct CartPole;

    param mc: kg = 1.0, mp: kg = 0.1, l: m = 0.5, c: N*m*s = 0.0, g: m/s^2 = 9.81;
    coord x: m, theta: rad;
    input u: N;

    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
    dissipation = 1/2 * c * dot(theta)^2;
    force x = u;
    output tip = (px, py);
    emit { system_matrix }
}

/// State x, θ, ẋ, θ̇ of the free motion at t = 5 s.
const LEFT_ALONE: [f64; 4] =
    [0.020042933115664744, -2.8370839467698628, -0.05381218271021493, -1.2409591267549178];
/// The state of the balanced motion at t = 10 s.
const BALANCED: [f64; 4] =
    [3.987874796614518e-6, 3.1415917136241155, -5.820280178610964e-6, 1.3717771826411104e-6];
/// State of the balanced motion at t = 5 s with a force that is held for 0.02 s.
const SAMPLED: [f64; 4] =
    [0.005362136575171383, 3.140247872338255, -0.008284798264675425, 0.001887956563467874];
/// Gain of the regulator.
const GAIN: [f64; 4] = [-10.00000000000008, 61.826287306606105, -10.679301319372048, 13.31957913758945];
/// State of the regulated motion at t = 3 s.
const REGULATED: [f64; 4] = [-0.006632214669527, 3.137311500244631, 0.004273844542225, 0.016085254450864];
/// Initial state at rest, 0.3 rad from upright.
const TILTED: [f64; 4] = [0.0, PI - 0.3, 0.0, 0.0];

/// Returns the force that balances the pendulum.
fn feedback(_: &CartPole, _: f64, state: CartPoleState) -> CartPoleInputs {
    CartPoleInputs {
        u: 1.8 * state.x - 30.8 * (state.theta - PI) + 3.1 * state.x_dot - 6.3 * state.theta_dot,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let cart = CartPole::default();
    let free = cart.simulate([0.0, 3.0, 0.0, 0.0]).until(5.0).tolerance(1e-13).run()?;
    report("left alone, t = 5 s", &free, LEFT_ALONE);

    let rusty = CartPole { c: 0.01, ..cart };
    let balanced = rusty.simulate(TILTED).until(10.0).drive(feedback).outputs().tolerance(1e-13).run()?;
    report("balanced, t = 10 s", &balanced, BALANCED);
    let last =
        |name: &str| balanced.column(name).and_then(|column| column.last().copied()).unwrap_or(f64::NAN);
    compare(
        "tip",
        1e-5,
        &[("x", last("tip.x"), 0.0), ("y", last("tip.y"), rusty.l), ("force", last("u"), 0.0)],
    );

    let sampled = rusty.simulate(TILTED).until(5.0).sampled(0.02, feedback).tolerance(1e-13).run()?;
    report("force held for 0.02 s, t = 5 s", &sampled, SAMPLED);
    regulated(&rusty)
}

/// Balances the pendulum by a regulator with weights of ten for the squares of x and θ.
fn regulated(cart: &CartPole) -> Result<(), Box<dyn Error>> {
    let upright: [f64; 4] = cart.equilibrium([0.0, 3.0, 0.0, 0.0]).solve()?.state;
    let model = cart.linearise(0.0, upright)?;
    let states = DenseMatrix::diagonal(&[10.0, 10.0, 1.0, 1.0]);
    let regulator = model.lqr(&states, &DenseMatrix::diagonal(&[0.1]))?;
    let gain = regulator.gain.row(0).to_vec();
    let rows: [_; 4] = std::array::from_fn(|i| (model.states()[i].as_str(), gain[i], GAIN[i]));
    compare("gain of the regulator", 1e-10, &rows);

    let law = move |_: &CartPole, _: f64, state: CartPoleState| {
        let state: [f64; 4] = state.into();
        CartPoleInputs { u: -(0..4).map(|i| gain[i] * (state[i] - upright[i])).sum::<f64>() }
    };
    let start = [0.0, PI - 0.5, 0.0, 0.0];
    let run = cart.simulate(start).drive(law).until(3.0).every(0.01).tolerance(1e-13).run()?;
    report("regulated, t = 3 s", &run, REGULATED);
    run.plot_columns(&["x", "theta"], gallery::picture("cart_pole_lqr.svg")?)?;
    Ok(())
}

fn report(title: &str, motion: &Trajectory<CartPole>, expected: [f64; 4]) {
    let end = motion.last();
    let rows: [_; 4] = std::array::from_fn(|i| (motion.names()[i].as_str(), end[i], expected[i]));
    compare(title, 1e-11, &rows);
}
