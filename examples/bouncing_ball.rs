//! A ball that bounces infinitely often and comes to rest.
//!
//! Dropped from the height h it hits the floor after sqrt(2 h/g), and each bounce takes e times as
//! long as the previous one. The durations form a geometric series, which ends at
//!
//! ```text
//! t = sqrt(2 h/g) (1 + e)/(1 − e).
//! ```
//!
//! Infinitely many events precede that time (Brogliato, *Nonsmooth Mechanics*, 3rd ed., §1.3). Look
//! for the last event: the contact closes there, and from then on the floor carries the weight.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;
use lagrange::contact::{Contact, EventKind};

lagrange::system! {
    /// A ball above a floor.
    #[derive(Clone, Debug)]
    pub struct Ball;

    param m: kg > 0 = 0.2, e in 0..1 = 0.8, g: m/s^2 = 9.81;
    coord y: m = 1;
    kinetic = 1/2 * m * dot(y)^2;
    potential = m * g * y;
    event floor = y, falling => impact(e);
    output load = floor;
}

fn main() -> Result<(), Box<dyn Error>> {
    let ball = Ball::default();
    let trajectory = ball.simulate(ball.start()).until(6.0).tolerance(1e-13).run()?;
    let fall = (2.0 * ball.start().y / ball.g).sqrt();
    let first = trajectory.events().first().ok_or("the ball hits nothing")?;
    let last = trajectory.events().last().ok_or("the ball hits nothing")?;
    let (EventKind::Impact(hit), EventKind::Closed { at: rest, .. }) = (first.kind, last.kind) else {
        return Err("the ball does not bounce and then rest".into());
    };

    let speed = ball.g * fall;
    let end = trajectory.system_at_end().unwrap_or(&ball);
    assert_eq!(end.floor, Contact::Closed);
    let [y, y_dot] = trajectory.last();
    let rows = [
        ("first hit, s", first.time, 0.451_523_640_985_73),
        ("impulse, N s", hit.impulse, ball.m * (1.0 + ball.e) * speed),
        ("energy lost, J", hit.energy_loss, 0.5 * ball.m * (1.0 - ball.e * ball.e) * speed * speed),
        ("at rest, s", rest, 4.063_712_768_871_58),
        ("y at 6 s, m", y, 0.0),
        ("y_dot at 6 s, m/s", y_dot, 0.0),
        ("load at 6 s, N", end.load(6.0, &[y], &[y_dot]), ball.m * ball.g),
    ];
    compare("a ball from 1 m, e = 0.8", 1e-11, &rows);
    assert!((rest - fall * (1.0 + ball.e) / (1.0 - ball.e)).abs() < 1e-11);
    println!("{} bounces one by one, {} steps", trajectory.events().len(), trajectory.work().steps);
    Ok(())
}
