//! A crane simulated at the cost of its visible motion only. The whole crane is computed while it
//! travels, and two pendulums while the brake holds the trolley. Once they have nearly come to
//! rest, linear equations suffice until it travels again.
//!
//! The reference is the whole crane for the whole time, with its trolley held by the servo of its
//! drive instead of the brake. Look for the states, which agree except for the effects of the brake
//! and the linear equations. Look also for the energies at each change of type. The operations of
//! one evaluation are counted by a number type. Most of the savings are evaluations, since the
//! brake removes the servo, which is stiff.

mod common;
#[path = "common/counted.rs"]
mod counted;

use std::error::Error;

use common::compare;
use counted::{Counted, Counts, counted};
use lagrange::Number;
use lagrange::integrate::{Method, Stepper, Verner98};
use lagrange::system::{OdeSystem, Wrapper};

lagrange::system! {
    /// An overhead crane: a trolley, a hook on ropes and a load on slings; angles from the
    /// vertical.
    #[derive(Clone, Debug)]
    pub struct Crane<S>;

    /// Mass.
    param trolley: kg = 800, hook: kg = 50, load: kg = 400;
    /// Length.
    param ropes: m = 8, slings: m = 3;
    /// Friction in the joint.
    param upper: N*m*s = 6000, lower: N*m*s = 900;
    /// Gravity.
    param g: m/s^2 = 9.81;
    /// Position at which the trolley stops.
    param stop: m = 0;
    /// Force of the drive.
    input drive: N;
    coord x: m, theta: rad, phi: rad;

    let hung = (x + ropes * sin(theta), -ropes * cos(theta));
    let lifted = hung + (slings * sin(phi), -slings * cos(phi));
    kinetic = kinetic_energy(trolley, dot(x)) + kinetic_energy(hook, dot(hung)) + kinetic_energy(load, dot(lifted));
    potential = gravitational_energy(hook, g, hung.y) + gravitational_energy(load, g, lifted.y);
    dissipation = 1/2 * upper * dot(theta)^2 + 1/2 * lower * dot(phi - theta)^2;
    force x = drive;

    reduce Braked { freeze x = stop; }
    reduce Settled { freeze x = stop; small theta, phi; }
}

/// The trolley follows a velocity: drive = gain (v(t) − ẋ).
struct Driven {
    crane: Crane<f64>,
}

/// Newtons per m/s.
const GAIN: f64 = 2e5;
/// The trolley travels for six seconds at up to 1.5 m/s, then rests.
const TRAVEL: f64 = 6.0;
/// Deflections, in radians, and their rates below which the linear equations suffice.
const SMALL: f64 = 0.02;
/// Final time of the scene in seconds.
const END: f64 = 60.0;

impl Wrapper for Driven {
    type Inner = Crane<f64>;
    type State = [f64; 6];

    fn inner(&self) -> &Crane<f64> {
        &self.crane
    }

    fn around(&self, crane: Crane<f64>) -> Driven {
        Driven { crane }
    }

    fn outer_rhs(&self, t: f64, y: &[f64; 6]) -> [f64; 6] {
        let wanted = if t < TRAVEL { 1.5 * (std::f64::consts::PI * t / TRAVEL).sin().powi(2) } else { 0.0 };
        Crane { drive: GAIN * (wanted - y[3]), ..self.crane.clone() }.rhs(t, y)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let driven = Driven { crane: Crane::default() };
    let (arrived, travelling) = advance(&driven, 0.0, [0.0; 6], TRAVEL)?;
    let arrived = CraneState::from(arrived);

    // The brake closes at the current position of the trolley, where the reduced type holds it.
    let crane = Crane { stop: arrived.x, ..driven.crane.clone() };
    let braked = Braked::from(&crane);
    let lost = braked.deviation(arrived);
    println!("brake at {:.3} m, what it takes away: {:.1e} m/s\n", arrived.x, lost.x_dot);
    let start = BrakedState::from(arrived);
    check_energy(
        "energy at the brake",
        1e-13,
        &crane,
        braked.expand(start),
        braked.energy(0.0, &start.coordinates(), &start.velocities()),
    );

    // The scene checks once a second whether the swing is small.
    let settled = Settled::from(&crane);
    let (mut t, mut state, mut swinging) = (TRAVEL, <[f64; 4]>::from(start), 0);
    while !is_small(settled.deviation(braked.expand(state.into()))) {
        let (next, evaluations) = advance(&braked, t, state, t + 1.0)?;
        (t, state, swinging) = (t + 1.0, next, swinging + evaluations);
    }
    println!("small from {t} s on");
    let small = SettledState::from(braked.expand(state.into()));
    // The difference is of fourth order: about m g l θ⁴/24.
    let linear = settled.energy(0.0, &small.coordinates(), &small.velocities());
    check_energy("energy where it is small", 1e-8, &crane, settled.expand(small), linear);
    let (end, resting) = advance(&settled, t, <[f64; 4]>::from(small), END)?;

    let (whole, throughout) = advance(&driven, TRAVEL, <[f64; 6]>::from(arrived), END)?;
    let end = settled.expand(end.into());
    let whole = CraneState::from(whole);
    // The servo yields by a few millimetres, unlike the brake.
    compare(
        "end of the scene",
        5e-3,
        &[("x", end.x, whole.x), ("theta", end.theta, whole.theta), ("phi", end.phi, whole.phi)],
    );

    println!("{:>12} {:>12} {:>12} {:>12}", "", "arithmetic", "functions", "evaluations");
    let evaluations = [travelling + throughout, swinging, resting];
    let counts = costs();
    for ((name, counts), evaluations) in ["whole", "braked", "settled"].iter().zip(counts).zip(evaluations) {
        println!("{name:>12} {:>12} {:>12} {evaluations:>12}", counts.arithmetic, counts.functions);
    }
    let [whole, braked, settled] = counts;
    println!(
        "{:>12} operations from the brake on {}, instead of {}",
        "",
        swinging * u64::from(braked.total()) + resting * u64::from(settled.total()),
        throughout * u64::from(whole.total())
    );
    assert!(braked.arithmetic < whole.arithmetic && settled.arithmetic < braked.arithmetic);
    assert_eq!(settled.functions, 0, "linear equations need no sines");
    Ok(())
}

/// Returns the state at `end`, and the number of evaluations of the equations.
fn advance<M: OdeSystem<Scalar = f64>>(
    system: &M,
    t: f64,
    state: M::State,
    end: f64,
) -> Result<(M::State, u64), Box<dyn Error>> {
    // The servo is stiff relative to the swing, but not enough to justify an implicit method.
    let method = Verner98 { refuses_stiff: false, ..Verner98::tolerance(1e-10) };
    let mut stepper = method.start(system, t, &state, end)?;
    while stepper.time() != end {
        stepper.step(system, end)?;
    }
    Ok((*stepper.state(), stepper.work().evaluations))
}

/// True if the terms missing from the linear equations are small; frozen coordinates have no
/// deviation.
fn is_small(deviation: CraneState<f64>) -> bool {
    <[f64; 6]>::from(deviation).iter().all(|deviation| deviation.abs() < SMALL)
}

/// Compares the energy of the whole crane with the energy of a reduced type.
fn check_energy(title: &str, tolerance: f64, crane: &Crane<f64>, state: CraneState<f64>, reduced: f64) {
    let whole = crane.energy(0.0, &state.coordinates(), &state.velocities());
    compare(title, tolerance, &[("in joules", reduced, whole)]);
}

/// Counts the operations of one evaluation of the accelerations: whole crane, braked and settled.
fn costs() -> [Counts; 3] {
    let crane = Crane::<Counted>::default();
    let (braked, settled) = (Braked::from(&crane), Settled::from(&crane));
    let number = Counted::from_f64;
    let (two, three) = ([0.1, 0.2].map(number), [1.0, 0.1, 0.2].map(number));
    let zero = number(0.0);
    [
        counted(|| crane.acceleration(zero, &three, &three)),
        counted(|| braked.acceleration(zero, &two, &two)),
        counted(|| settled.acceleration(zero, &two, &two)),
    ]
}
