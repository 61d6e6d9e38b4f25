//! Motions as text, for comparisons bit by bit.

use std::fmt::Debug;

use lagrange::simulate::{SimulationError, Trajectory};
use lagrange::system::MechanicalSystem;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::DeclaredSystem;

/// The content of a motion as text, with all digits of numbers.
#[derive(PartialEq)]
pub(crate) struct Record(pub(crate) Vec<String>);

impl Debug for Record {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0.join("\n"))
    }
}

/// Returns the content of a motion, complete or not.
pub(crate) fn record<M: MechanicalSystem<Scalar = f64>>(
    motion: Result<Trajectory<M>, SimulationError<M>>,
) -> Record
where
    M::State: Debug,
{
    let (motion, failure) = match motion {
        Ok(motion) => (motion, None),
        Err(failure) => (*failure.trajectory.clone(), Some(failure.to_string())),
    };
    let mut lines = vec![format!("{:?} {:?} {:?}", motion.ending(), motion.work(), failure)];
    let mut csv = Vec::new();
    motion.write_csv(&mut csv).expect("memory");
    lines.extend(String::from_utf8(csv).expect("text").lines().map(str::to_owned));
    let events = motion.events().iter();
    lines.extend(
        events.map(|event| format!("{} {:?} {:?} {:?}", event.name, event.time, event.state, event.kind)),
    );
    Record(lines)
}

/// Returns the system of a text.
pub(crate) fn declared(text: &str) -> DeclaredSystem {
    let derived = parse(text).unwrap_or_else(|report| panic!("{report}")).derive(StrategyChoice::Cheapest);
    let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    DeclaredSystem::new(programs).unwrap_or_else(|refusal| panic!("{refusal}"))
}
