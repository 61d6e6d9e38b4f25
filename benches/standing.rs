//! Steps of a quadruped that stands, and of one that slides, on 4, 8 and 16 points.
//!
//! The quadruped is that of `examples/quadruped.rs`, with springs and dampers that carry its
//! weight. `tools/contact_peers.py` alternates these steps with those of MuJoCo. With the argument
//! `serve`, the benchmark answers lines, where CASE is 4, 8 or 16:
//!
//! - `start CASE SPEED` starts a motion;
//! - `CASE SPEED STEPS` continues it: the time in ns, the number of Newton steps and the state;
//! - `law CASE SPEED STEPS` measures on another motion how well steps obey the law;
//! - `check CASE` computes the accelerations of a state in the air.
//!
//! Without the tool, it prints times of its own:
//!
//! `cargo bench -p lagrange-benches --bench standing -- alone`

use std::collections::HashMap;
use std::error::Error;
use std::hint::black_box;
use std::io::{BufRead, stdin};
use std::time::Instant;

use lagrange::contact::{ContactSystem, Stepped, SteppedStepper};
use lagrange::integrate::{Method, Stepper};

const STEP: f64 = 2e-3;
/// Time of no step.
const END: f64 = 1e9;
/// Angles of roll, pitch and knee at which springs carry a quarter of the weight.
const JOINTS: [f64; 3] = [0.0, 0.8, -1.5];
/// Height of the trunk at which the lowest balls just touch.
const HEIGHT: f64 = 0.333_309_914_982_542_25;

/// Declares a quadruped on these contacts of each leg.
macro_rules! quadruped {
    ($(#[$doc:meta])* $name:ident, $($contacts:tt)*) => {
        lagrange::system! {
            $(#[$doc])*
            #[derive(Clone, Debug)]
            pub struct $name;

            param mu = 0.8, k: N*m/rad = 60, c: N*m*s/rad = 2;
            gravity = (0, 0, -9.81);
            body trunk { mass: 7.277000000000002; centroid: (0.020079174385048755, 0, -0.005103488525491267); inertia: (0.0257151774237163, 0.10295388328825997, 0.11264519436454368, 0.0001216600000000001, 0.001523257166511061, -0.000031200000000000006); }
            free trunk;

            part Leg(trunk, front, left, k, c, mu) {
                body hip { mass: 0.767; centroid: (-0.004773402868318123 [m] * front, 0.0016974837027379402 [m] * left, -0.0000928161668839635); inertia: (0.0005399915178106258, 0.0009981369647855932, 0.0006582847478620599, -0.0000021220993324641458 [kg*m^2] * front * left, 0.000001065392550195567 [kg*m^2] * front, -0.0000014027352647979139 [kg*m^2] * left); }
                body thigh { mass: 1.2409999999999999; centroid: (-0.0034717808219178084, -0.02302074939564867 [m] * left, -0.030354875100725223); inertia: (0.005996333341208702, 0.006001339409970024, 0.0010991471651674457, 0.00009030533435616439 [kg*m^2] * left, -0.00029910392372602736, 0.0008351509180338437 [kg*m^2] * left); }
                body calf { mass: 0.194; centroid: (0.004350103092783504, -0.0007739690721649483 [m] * left, -0.13520618556701028); inertia: (0.001394581937371134, 0.0014155052951752578, 0.00004348372739175258, 0.0000005096540206185566 [kg*m^2] * left, 0.00000014759587628866708, 0.000011313958762886598 [kg*m^2] * left); }
                revolute roll = trunk to hip { at: (0.1934 [m] * front, 0.0465 [m] * left, 0); axis: (1, 0, 0); damping: c; }
                revolute pitch = hip to thigh { at: (0, 0.0955 [m] * left, 0); axis: (0, 1, 0); damping: c; }
                revolute knee = thigh to calf { at: (0, 0, -0.213); axis: (0, 1, 0); damping: c; }
                potential = 1/2 * k * ((roll + 0.0627 * left)^2 + (pitch - 0.7898)^2 + (knee + 1.41)^2);
                $($contacts)*
            }
            fl: Leg { trunk: trunk; front: 1; left: 1; k: k; c: c; mu: mu; }
            fr: Leg { trunk: trunk; front: 1; left: -1; k: k; c: c; mu: mu; }
            rl: Leg { trunk: trunk; front: -1; left: 1; k: k; c: c; mu: mu; }
            rr: Leg { trunk: trunk; front: -1; left: -1; k: k; c: c; mu: mu; }
        }
    };
}

quadruped! {
    /// On a ball at each foot.
    OnFour,
    contact foot = calf.point(0, 0, -0.213 [m]) on ground { friction: mu; radius: 0.022; }
}
quadruped! {
    /// On two balls at each foot, 4 cm apart. They are level at the start.
    OnEight,
    contact toe = calf.point(0.0152968437457 [m], 0, -0.2258843537447538 [m]) on ground { friction: mu; radius: 0.022; }
    contact heel = calf.point(-0.0152968437457 [m], 0, -0.2001156462552462 [m]) on ground { friction: mu; radius: 0.022; }
}
quadruped! {
    /// On four balls at each foot, at the corners of a square of 4 cm.
    OnSixteen,
    contact toe_left = calf.point(0.0152968437457 [m], 0.02 [m], -0.2258843537447538 [m]) on ground { friction: mu; radius: 0.022; }
    contact toe_right = calf.point(0.0152968437457 [m], -0.02 [m], -0.2258843537447538 [m]) on ground { friction: mu; radius: 0.022; }
    contact heel_left = calf.point(-0.0152968437457 [m], 0.02 [m], -0.2001156462552462 [m]) on ground { friction: mu; radius: 0.022; }
    contact heel_right = calf.point(-0.0152968437457 [m], -0.02 [m], -0.2001156462552462 [m]) on ground { friction: mu; radius: 0.022; }
}

type Outcome = Result<String, Box<dyn Error>>;

/// A quadruped that moves.
trait Walker {
    /// Takes steps, and returns a line of numbers.
    fn advance(&mut self, steps: usize) -> Outcome;

    /// Takes steps, and returns the largest residual, depth, slip velocity of sticking contacts and
    /// rise of the energy. The number of loaded contacts and the state are those at the end.
    fn law(&mut self, steps: usize) -> Outcome;

    /// Returns accelerations of a state in the air.
    fn accelerations(&self) -> String;
}

/// A system, its motion, and its coefficient of friction.
struct Walking<M: ContactSystem<18, K>, const K: usize> {
    system: M,
    stepper: SteppedStepper<M, 18, K>,
    mu: f64,
    acceleration: fn(&M, &[f64; 37]) -> [f64; 18],
    energy: fn(&M, &[f64; 37]) -> f64,
}

/// Returns the state in which the feet touch, with this speed.
fn start(speed: f64) -> [f64; 37] {
    let mut state = [0.0; 37];
    (state[2], state[3], state[19]) = (HEIGHT, 1.0, speed);
    state[7..19].chunks_mut(3).for_each(|leg| leg.copy_from_slice(&JOINTS));
    state
}

fn split(y: &[f64; 37]) -> ([f64; 19], [f64; 18]) {
    (std::array::from_fn(|i| y[i]), std::array::from_fn(|i| y[19 + i]))
}

fn listed(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!(" {number:?}")).collect()
}

impl<M, const K: usize> Walker for Walking<M, K>
where
    M: ContactSystem<18, K, Scalar = f64, State = [f64; 37], Coordinates = [f64; 19], Velocities = [f64; 18]>,
{
    fn advance(&mut self, steps: usize) -> Outcome {
        let before = self.stepper.work().iterations;
        let began = Instant::now();
        for _ in 0..steps {
            self.stepper.step(black_box(&self.system), END).map_err(|failure| failure.to_string())?;
        }
        let time = began.elapsed().as_nanos();
        let iterations = self.stepper.work().iterations - before;
        Ok(format!("{time} {iterations}{}", listed(self.stepper.state())))
    }

    fn law(&mut self, steps: usize) -> Outcome {
        let mut worst = [0.0_f64; 4];
        let mut loaded = 0;
        for step in 0..steps {
            let y = *self.stepper.state();
            let ((q, v), t) = (split(&y), self.stepper.time());
            let terms = self.system.step_terms(t, &q, &v, STEP).accelerated();
            self.stepper.step(&self.system, END).map_err(|failure| failure.to_string())?;
            let (end, r) = (*self.stepper.state(), *self.stepper.impulses());
            let change: [f64; 18] = std::array::from_fn(|i| end[19 + i] - v[i]);
            let product = |a: &[f64; 18], b: &[f64; 18]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let rate = |k: usize| terms.rates[k] + STEP * terms.drifts[k] + product(&terms.rows[k], &change);
            let own = |k: usize| product(&terms.rows[k], &terms.responses[k]);
            let rises = (self.energy)(&self.system, &end) - (self.energy)(&self.system, &y);
            loaded = 0;
            for k in (0..K).step_by(3) {
                let weight = (own(k) + own(k + 1) + own(k + 2)) / 3.0;
                let [n, a, b] = [0, 1, 2].map(|i| weight * r[k + i]);
                let closing = rate(k) + terms.gaps[k].max(0.0) / STEP;
                let [x, y] = [rate(k + 1), rate(k + 2)];
                worst[0] = worst[0].max(residual([n, a, b], [closing, x, y], self.mu));
                if n > 0.0 {
                    loaded += 1;
                }
                if step > steps / 2 {
                    worst[1] = worst[1].max(-terms.gaps[k]);
                    if a.hypot(b) < 0.999 * self.mu * n {
                        worst[2] = worst[2].max(x.hypot(y));
                    }
                }
            }
            worst[3] = worst[3].max(rises);
        }
        Ok(format!("{loaded}{}{}", listed(&worst), listed(self.stepper.state())))
    }

    fn accelerations(&self) -> String {
        let state = std::array::from_fn(|i| match i {
            3 => 0.5_f64.cos(),
            4 => 0.5_f64.sin(),
            5 | 6 => 0.0,
            _ => 0.3 + 0.1 * (i as f64).sin(),
        });
        listed(&(self.acceleration)(&self.system, &state))
    }
}

/// Returns by how much scaled impulses and velocities of a contact miss Coulomb's law, in m/s.
fn residual([n, a, b]: [f64; 3], [u, x, y]: [f64; 3], mu: f64) -> f64 {
    let pressing = (n - u).max(0.0);
    let (x, y) = (a - x, b - y);
    let part = (mu * pressing / x.hypot(y)).min(1.0);
    let part = if part.is_nan() { 0.0 } else { part };
    (pressing - n).abs().max((part * x - a).hypot(part * y - b))
}

/// Starts a case with this speed.
fn walker(case: &str, speed: f64) -> Result<Box<dyn Walker>, Box<dyn Error>> {
    let mu = if speed == 0.0 { 0.8 } else { 0.2 };
    macro_rules! walking {
        ($system:ident) => {{
            let system = $system { mu, ..$system::default() };
            let stepper = Method::<$system>::start(&Stepped::every(STEP), &system, 0.0, &start(speed), END);
            let stepper = stepper.map_err(|failure| failure.to_string())?;
            let acceleration = |system: &$system, y: &[f64; 37]| {
                let (q, v) = split(y);
                system.acceleration(0.0, &q, &v)
            };
            let energy = |system: &$system, y: &[f64; 37]| {
                let (q, v) = split(y);
                system.energy(0.0, &q, &v)
            };
            Ok(Box::new(Walking { system, stepper, mu, acceleration, energy }))
        }};
    }
    match case {
        "4" => walking!(OnFour),
        "8" => walking!(OnEight),
        "16" => walking!(OnSixteen),
        _ => Err(format!("no case {case}").into()),
    }
}

/// Prints the shortest times of a step while the quadruped stands and slides.
fn alone() -> Result<(), Box<dyn Error>> {
    for case in ["4", "8", "16"] {
        for speed in [0.0, 1.0] {
            let mut least = f64::INFINITY;
            let mut iterations = 0.0;
            for _ in 0..20 {
                let mut walker = walker(case, speed)?;
                for _ in 0..10 {
                    let line = walker.advance(50)?;
                    let mut numbers = line.split(' ').map(str::parse::<f64>);
                    let (Some(time), Some(steps)) = (numbers.next(), numbers.next()) else { continue };
                    least = least.min(time? / 50.0);
                    iterations = steps? / 50.0;
                }
            }
            let law = walker(case, speed)?.law(500)?;
            let law = law.split(' ').take(5).collect::<Vec<_>>().join(" ");
            println!("{case} contacts, speed {speed}: {least:.0} ns, {iterations} iterations; {law}");
        }
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    if !std::env::args().any(|argument| argument == "serve") {
        return alone();
    }
    let mut walkers = HashMap::new();
    for line in stdin().lock().lines() {
        let line = line?;
        let words = line.split(' ').collect::<Vec<_>>();
        let answer = match words[..] {
            ["check", case] => walker(case, 0.0)?.accelerations(),
            ["law", case, speed, steps] => walker(case, speed.parse()?)?.law(steps.parse()?)?,
            ["start", case, speed] => {
                walkers.insert([case, speed].map(String::from), walker(case, speed.parse()?)?);
                String::new()
            }
            [case, speed, steps] => match walkers.get_mut(&[case, speed].map(String::from)) {
                Some(walker) => walker.advance(steps.parse()?)?,
                None => return Err(format!("not started: {line}").into()),
            },
            _ => return Err(format!("unknown: {line}").into()),
        };
        println!("{answer}");
    }
    Ok(())
}
