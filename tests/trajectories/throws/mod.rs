//! Bodies thrown onto rough ground at random: runs always continue.
//!
//! `LAGRANGE_THROWS=300 cargo motions throws` takes this many throws instead of a few.

mod random;
mod systems;

use std::env;

use lagrange::Simulate;
use lagrange::contact::ContactSystem;
use lagrange::system::{EnergyFunction, MechanicalSystem, split};

use self::random::Random;
use self::systems::{Board, Crate, Hexagon, Pentagon, Stack, Triangle, Walled};

/// Duration of a throw, in s.
const END: f64 = 4.0;
/// Largest number of steps per second of motion.
const MAX_STEPS: u64 = 5_000;
/// Number of throws by default.
const USUAL: u64 = 70;

/// The outcome of a throw.
struct Outcome {
    throw: String,
    failure: Option<String>,
    steps: u64,
    /// The largest rise of the energy anywhere, relative to its largest value.
    rise: f64,
    /// The largest depth of a corner below the ground, in m.
    depth: f64,
}

impl Outcome {
    fn is_as_it_should_be(&self) -> bool {
        let is_slow = self.steps <= (END as u64) * MAX_STEPS;
        self.failure.is_none() && is_slow && self.rise <= 1e-9 && self.depth <= 1e-10
    }
}

/// Throws a body and follows it. Rejected steps count.
fn throw<M, const L: usize, const N: usize, const K: usize>(
    throw: String,
    system: &M,
    start: [f64; L],
) -> Outcome
where
    M: ContactSystem<N, K> + EnergyFunction + Clone,
    M: MechanicalSystem<Scalar = f64, State = [f64; L], Velocities = [f64; N]>,
{
    let depth = |system: &M, t: f64, y: &[f64; L]| {
        let (q, v) = split::<M>(y);
        system.terms(t, &q, &v).gaps.iter().fold(0.0_f64, |depth, gap| depth.max(-gap))
    };
    let run = system.simulate(start).until(END).tolerance(1e-10).energy().observe("depth", depth);
    let (trajectory, failure) = match run.max_steps(END as u64 * MAX_STEPS).run() {
        Ok(trajectory) => (trajectory, None),
        Err(error) => (error.trajectory.as_ref().clone(), Some(error.to_string())),
    };
    let column = |name: &str| trajectory.column(name).expect("asked for");
    let energy = column("energy");
    let size = energy.iter().fold(0.0_f64, |size, energy| size.max(energy.abs()));
    let (rise, _) = energy.iter().fold((0.0_f64, energy[0]), |(rise, lowest), energy| {
        (rise.max((energy - lowest) / size), lowest.min(*energy))
    });
    let depth = column("depth").iter().fold(0.0_f64, |deepest, depth| deepest.max(*depth));
    let work = trajectory.work();
    Outcome { throw, failure, steps: work.steps + work.rejections, rise, depth }
}

/// Returns the outcome of the throw of this number.
fn thrown(number: u64) -> Outcome {
    let mut random = Random(number);
    let e = if random.within(0.0, 1.0) < 0.25 { 0.0 } else { random.within(0.0, 0.9) };
    let mu = if random.within(0.0, 1.0) < 0.1 { 0.0 } else { random.within(0.0, 2.0) };
    let tilt = if random.within(0.0, 1.0) < 0.5 { 0.0 } else { random.within(-0.5, 0.5) };
    let height = random.within(0.7, 1.5);
    let (phi, u, spin) = (random.within(-3.0, 3.0), random.within(-2.0, 2.0), random.within(-6.0, 6.0));
    let named = |body: &str| format!("{number}: {body}, e = {e:.3}, mu = {mu:.3}, tilt = {tilt:.3}");
    let start = [0.0, height, phi, u, 0.0, spin];
    match number % 7 {
        0 => {
            let start = [0.0, height, 0.1 * phi, u, 0.0, 0.1 * spin];
            throw::<_, 6, 3, 4>(named("board"), &Board { e, mu, tilt, ..Board::default() }, start)
        }
        1 => throw::<_, 6, 3, 6>(named("triangle"), &Triangle { e, mu, tilt, ..Triangle::default() }, start),
        2 => throw::<_, 6, 3, 8>(named("crate"), &Crate { e, mu, tilt, ..Crate::default() }, start),
        3 => throw::<_, 6, 3, 10>(named("pentagon"), &Pentagon { e, mu, tilt, ..Pentagon::default() }, start),
        4 => throw::<_, 6, 3, 12>(named("hexagon"), &Hexagon { e, mu, tilt, ..Hexagon::default() }, start),
        5 => {
            let start = [0.0, height, phi, u.abs() + 1.0, 0.0, spin];
            throw::<_, 6, 3, 16>(named("walled"), &Walled { e, mu, tilt, ..Walled::default() }, start)
        }
        _ => {
            // The lower box is released close to the slope, the upper one far enough above it to
            // turn.
            let (lift, (sin, cos)) = (0.3 + random.within(0.1, 0.4), tilt.sin_cos());
            let far = lift + height + 0.3;
            let (lower, upper) = ([lift * sin, lift * cos, 0.02 * phi - tilt], [far * sin, far * cos, phi]);
            let start =
                [lower[0], lower[1], lower[2], upper[0], upper[1], upper[2], 0.0, 0.0, 0.0, u, 0.0, spin];
            throw::<_, 12, 6, 12>(named("stack"), &Stack { e, mu, tilt, ..Stack::default() }, start)
        }
    }
}

#[test]
fn bodies_thrown_onto_rough_ground_keep_moving() {
    let count = env::var("LAGRANGE_THROWS").ok();
    let count = count.map_or(USUAL, |count| count.parse().expect("LAGRANGE_THROWS is a whole number"));
    let (mut failed, mut steps, mut rise, mut depth) = (Vec::new(), 0, 0.0_f64, 0.0_f64);
    for outcome in (0..count).map(thrown) {
        (steps, rise, depth) = (steps.max(outcome.steps), rise.max(outcome.rise), depth.max(outcome.depth));
        if !outcome.is_as_it_should_be() {
            let Outcome { throw, failure, steps, rise, depth } = outcome;
            failed.push(format!("{throw}: {failure:?}, {steps} steps, {rise:e} up, {depth:e} deep"));
        }
    }
    println!("{count} throws: at most {steps} steps, energy rises by {rise:e}, {depth:e} deep");
    assert!(failed.is_empty(), "{} of {count}: {failed:#?}", failed.len());
}
