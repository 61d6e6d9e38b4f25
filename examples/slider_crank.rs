//! A slider-crank whose crank is driven at a constant speed.
//!
//! The drive is a constraint that depends on time, crank − ω t = 0, and its multiplier is the
//! torque of the motor. The guide, and the pin that joins rod and slider, are two more constraints.
//! No degree of freedom remains, so everything is known in closed form. With λ = r/l and the rod's
//! angle φ, sin φ = −λ sin θ, the slider is at x = r cos θ + l cos φ. The reduced inertia I(θ) = Σ
//! m (x′² + y′²) + J φ′² gives the torque, ½ I′(θ) ω². The pin pushes the slider with m₃ ω² x″
//! (Dresig, Holzweißig, *Dynamics of Machinery*, chapter 2).
//!
//! Look for position, pin force and torque after slightly more than a hundred turns: they have not
//! drifted.

mod common;

use std::error::Error;
use std::f64::consts::TAU;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A uniform crank, a uniform connecting rod and a slider, without gravity.
    #[derive(Clone, Debug)]
    pub struct SliderCrank;

    param r: m = 0.05, l: m = 0.15, m1: kg = 0.5, m2: kg = 0.8, m3: kg = 0.6, omega: rad/s = 100.0;
    coord crank: rad, rod: rad, x: m;

    let (xs, ys) = (r * cos(crank) + l/2 * cos(rod), r * sin(crank) + l/2 * sin(rod));
    kinetic = 1/6 * m1 * r^2 * dot(crank)^2;
    kinetic = 1/2 * m2 * (dot(xs)^2 + dot(ys)^2) + 1/24 * m2 * l^2 * dot(rod)^2;
    kinetic = 1/2 * m3 * dot(x)^2;
    constraint pin = x - r * cos(crank) - l * cos(rod);
    constraint guide = r * sin(crank) + l * sin(rod);
    constraint motor = crank - omega * t;
}

/// Closed-form values at one angle of the crank.
struct ClosedForm {
    x: f64,
    x_dot: f64,
    /// Force of the pin on the slider.
    pin: f64,
    /// Torque of the motor.
    motor: f64,
}

impl ClosedForm {
    fn at(machine: &SliderCrank, angle: f64) -> ClosedForm {
        let &SliderCrank { r, l, m2, m3, omega, .. } = machine;
        let (sine, cosine) = angle.sin_cos();
        let (rod_sine, ratio) = (-r / l * sine, r / l);
        let rod_cosine = (1.0 - rod_sine * rod_sine).sqrt();
        // First and second derivatives with respect to the crank's angle.
        let rod1 = -ratio * cosine / rod_cosine;
        let rod2 = (ratio * sine + rod_sine * rod1 * rod1) / rod_cosine;
        let along = |part: f64| {
            [
                -r * sine - part * rod_sine * rod1,
                -r * cosine - part * (rod_cosine * rod1 * rod1 + rod_sine * rod2),
            ]
        };
        let ([x1, x2], [xs1, xs2], [ys1, ys2]) =
            (along(l), along(l / 2.0), [r / 2.0 * cosine, -r / 2.0 * sine]);
        let half_slope = m2 * (xs1 * xs2 + ys1 * ys2) + m2 * l * l / 12.0 * rod1 * rod2 + m3 * x1 * x2;
        ClosedForm {
            x: r * cosine + l * rod_cosine,
            x_dot: omega * x1,
            pin: m3 * omega * omega * x2,
            motor: omega * omega * half_slope,
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let machine = SliderCrank::default();
    let turn = TAU / machine.omega;
    let first = ClosedForm::at(&machine, 0.0);
    let rod_rate = -machine.omega * machine.r / machine.l;
    let start = SliderCrankState {
        crank: 0.0,
        rod: 0.0,
        x: first.x,
        crank_dot: machine.omega,
        rod_dot: rod_rate,
        x_dot: first.x_dot,
    };
    for (title, turns) in [("after an eighth of a turn", 0.125), ("after 100.3 turns", 100.3)] {
        let trajectory = machine.simulate(start).until(turns * turn).tolerance(1e-13).ends_only().run()?;
        let end = SliderCrankState::from(trajectory.last());
        let t = trajectory.end_time();
        let [pin, _, motor] = machine.multipliers(t, &end.coordinates(), &end.velocities());
        let wanted = ClosedForm::at(&machine, machine.omega * t);
        let rows = [
            ("x, m", end.x, wanted.x),
            ("x_dot, m/s", end.x_dot, wanted.x_dot),
            ("pin, N", pin, wanted.pin),
            ("motor, N m", motor, wanted.motor),
        ];
        compare(title, 1e-12, &rows);
    }
    Ok(())
}
