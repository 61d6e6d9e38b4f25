//! Ten seconds of motion, compiled and interpreted: the minimum of interleaved runs, and the time
//! from text to programs. `cargo bench -p lagrange-dynamic`; `docs/command_line.md` has the table.

#[allow(dead_code, reason = "tests move all of them")]
#[path = "../tests/systems/mod.rs"]
mod systems;

use std::time::{Duration, Instant};

use lagrange::Simulate;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{DeclaredSystem, DynamicSystem, Visitor};
use systems::{DOUBLE_PENDULUM, DoublePendulum, FIVE_MASSES, FiveMasses, ROD, Rod, TOP, Top};

const ROUNDS: usize = 30;
const END: f64 = 10.0;

/// Runs once; returns the evaluations.
struct Once<'a>(&'a [f64]);

impl Visitor for Once<'_> {
    type Output = u64;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> u64 {
        let motion = system.simulate(system.state(self.0)).until(END).ends_only().run();
        motion.expect("a motion").work().evaluations
    }
}

fn timed<T>(run: impl FnOnce() -> T) -> (Duration, T) {
    let start = Instant::now();
    let result = run();
    (start.elapsed(), result)
}

macro_rules! compare {
    ($System:ident, $TEXT:ident, $start:expr) => {{
        let (start, compiled) = ($start, $System::default());
        let read = || {
            let derived = parse($TEXT).expect("a declaration").derive(StrategyChoice::Cheapest);
            DeclaredSystem::new(Programs::new(&derived.expect("regular"))).expect("runs")
        };
        let (mut fast, mut slow, mut made) = (Duration::MAX, Duration::MAX, Duration::MAX);
        let mut evaluations = 0;
        for _ in 0..ROUNDS {
            let (time, system) = timed(read);
            made = made.min(time);
            let (time, work) = timed(|| system.visit(Once(&start)));
            slow = slow.min(time);
            let (time, motion) = timed(|| compiled.simulate(start).until(END).ends_only().run());
            fast = fast.min(time);
            evaluations = motion.expect("a motion").work().evaluations;
            assert_eq!(evaluations, work);
        }
        let per = |time: Duration| time.as_secs_f64() * 1e9 / evaluations as f64;
        println!(
            "{:<15} {:>6} evaluations; compiled {:>6.0} ns each, interpreted {:>6.0} ns: {:>4.1} times; from text {:.1} ms",
            stringify!($System),
            evaluations,
            per(fast),
            per(slow),
            per(slow) / per(fast),
            made.as_secs_f64() * 1e3
        );
    }};
}

fn main() {
    compare!(DoublePendulum, DOUBLE_PENDULUM, [1.5, 1.5, 0.0, 0.0]);
    compare!(FiveMasses, FIVE_MASSES, [0.1, 0.2, 0.3, 0.4, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0]);
    compare!(Rod, ROD, [0.6, -0.8, 0.0, 0.0]);
    compare!(Top, TOP, [1.0, 0.0, 0.0, 0.0, 0.1, 3.0, 0.2]);
}
