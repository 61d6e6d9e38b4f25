//! A block on a running belt, held by a spring: it sticks, is carried along, slips back, and sticks
//! again.
//!
//! Friction holds up to μₛ N, and is μₖ N during slip. Let ω² = k/m. The block slips when the
//! spring force reaches μₛ N. It then oscillates about the position with spring force μₖ N until it
//! is as fast as the belt again. One period takes
//!
//! ```text
//! 2 A/v + (2 π − 2 arctan(A ω/v))/ω,    A = (μₛ − μₖ) N/k
//! ```
//!
//! (Den Hartog, *Mechanical Vibrations*, 4th ed., §7.7). N is the multiplier of the constraint that
//! keeps the block on the belt. Look for the times at which it sticks and slips, found as events,
//! and for the positions at these times.

mod common;

use std::error::Error;
use std::f64::consts::TAU;

use common::compare;
use lagrange::Simulate;
use lagrange::contact::EventKind;

lagrange::system! {
    /// A block on a belt; x is the extension of its spring.
    #[derive(Clone, Debug)]
    pub struct Block;

    param m: kg > 0 = 1.5, k: N/m > 0 = 40.0, v: m/s > 0 = 0.3, g: m/s^2 = 9.81;
    param kinetic_mu in 0..=1 = 0.2, static_mu in 0..=1 = 0.35;
    coord x: m, y: m;
    start dot(x) = v;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = 1/2 * k * x^2 + m * g * y;
    constraint belt = y;
    friction rub = dot(x) - v, kinetic: kinetic_mu * belt, static: static_mu * belt;
}

fn main() -> Result<(), Box<dyn Error>> {
    let block = Block::default();
    let &Block { m, k, v, kinetic_mu, static_mu, g, .. } = &block;
    let (weight, omega) = (m * g, (k / m).sqrt());
    let amplitude = (static_mu - kinetic_mu) * weight / k;
    let slipping = (TAU - 2.0 * (amplitude * omega / v).atan()) / omega;
    let period = 2.0 * amplitude / v + slipping;
    let (given_way, middle) = (static_mu * weight / k, kinetic_mu * weight / k);

    let trajectory = block.simulate(block.start()).until(10.0).tolerance(1e-13).run()?;
    for (index, event) in trajectory.events().iter().enumerate() {
        let turn = (index / 2) as f64 * period;
        let first = given_way / v;
        let (name, time, place) = match event.kind {
            EventKind::Slipped if index % 2 == 0 => ("slips", first + turn, given_way),
            EventKind::Stuck if index % 2 == 1 => ("sticks", first + slipping + turn, middle - amplitude),
            other => return Err(format!("{other:?} is not expected here").into()),
        };
        let rows = [
            ("time, s", event.time, time),
            ("place, m", event.state[0], place),
            ("speed, m/s", event.state[2], v),
        ];
        compare(name, 1e-10, &rows);
    }
    assert_eq!(trajectory.events().len() as f64, 2.0 * ((10.0 - given_way / v) / period).floor() + 1.0);
    Ok(())
}
