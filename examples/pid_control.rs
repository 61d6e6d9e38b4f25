//! A slide moved against a spring by a sampled PID controller, whose actuator saturates.
//!
//! Every 0.05 s the controller computes the force
//!
//! ```text
//! u = Kp e + I − Kd ẋ,   I ← I + Ki h e,   e = 1 − x,
//! ```
//!
//! which the actuator limits to ±15 N. During saturation, the integral is frozen: otherwise it
//! would continue to grow and the slide would overshoot (Åström, Hägglund, *Advanced PID Control*,
//! §3.5, "windup"). Three results are known:
//!
//! - during the initial saturation, the slide is a damped oscillator under a constant force;
//! - the integral leaves no error at rest: the slide comes to rest at 1 m, where the spring takes k
//!   · 1 m = 10 N;
//! - the state at 6 s, by `tools/control.py` in multi-precision arithmetic.

mod common;

use std::error::Error;

use common::compare;
use lagrange::Simulate;

lagrange::system! {
    /// A slide between a spring, a damper and an actuator.
    #[derive(Clone, Debug)]
    pub struct Slide;

    param m: kg = 2, c: N*s/m = 0.5, k: N/m = 10;
    coord x: m;
    input u: N;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * c * dot(x)^2;
    force x = u;
}

const PERIOD: f64 = 0.05;
const LIMIT: f64 = 15.0;
/// Values of x and ẋ at 6 s.
const REFERENCE: [f64; 2] = [0.999812453222426, 0.001210234314642701];

/// A controller with its integral.
#[derive(Default)]
struct Pid {
    integral: f64,
}

impl Pid {
    fn force(&mut self, state: SlideState) -> f64 {
        let deviation = 1.0 - state.x;
        let wanted = 40.0 * deviation + self.integral - 8.0 * state.x_dot;
        let force = wanted.clamp(-LIMIT, LIMIT);
        if force == wanted {
            self.integral += 60.0 * PERIOD * deviation;
        }
        force
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let slide = Slide::default();
    let mut pid = Pid::default();
    let control = |_: &Slide, _, state| SlideInputs { u: pid.force(state) };
    let run = slide.simulate([0.0, 0.0]).until(12.0).sampled(PERIOD, control).every(PERIOD).tolerance(1e-13);
    let motion = run.run()?;
    let (times, x, u) = (motion.times(), motion.x(), motion.column("u").unwrap_or_default());

    let free = u.iter().position(|force| *force < LIMIT).ok_or("the force stays at its limit")?;
    println!("the actuator is at its limit for {} s", times[free]);
    compare("when the force leaves its limit", 1e-12, &[("x", x[free], step_response(&slide, times[free]))]);
    let at_six = motion.state(120).ok_or("no sample at 6 s")?;
    compare("t = 6 s", 1e-12, &[("x", at_six[0], REFERENCE[0]), ("x_dot", at_six[1], REFERENCE[1])]);
    let force = u.last().copied().unwrap_or(f64::NAN);
    compare("t = 12 s", 1e-6, &[("x", motion.last()[0], 1.0), ("force", force, slide.k)]);
    Ok(())
}

/// Returns the position of the slide under the largest force since rest: the step response of a
/// damped oscillator.
fn step_response(slide: &Slide, t: f64) -> f64 {
    let decay = slide.c / (2.0 * slide.m);
    let rate = (slide.k / slide.m - decay * decay).sqrt();
    let ringing = (rate * t).cos() + decay / rate * (rate * t).sin();
    LIMIT / slide.k * (1.0 - (-decay * t).exp() * ringing)
}
