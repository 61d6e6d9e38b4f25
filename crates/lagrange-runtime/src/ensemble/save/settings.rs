//! The identity of an ensemble as lines of text, so that parts of different ensembles are never
//! mixed.

use core::fmt::Debug;
use std::any::type_name;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::ensemble::builder::{Ensemble, Keep};
use crate::ensemble::error::EnsembleError;
use crate::ensemble::lanes::is_fused;
use crate::ensemble::motion::caught;
use crate::ensemble::plan::SharedSystem;
use crate::ensemble::rows::samples;
use crate::integrate::Method;
use crate::scalar::Scalar;
use crate::simulate::ClosedLoop;
use crate::simulate::{Drive, RunSettings, Sampling};
use crate::system::OdeSystem;

/// Version of the format below, to be incremented when the format changes.
const FORMAT: u32 = 4;

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    M::Scalar: Into<f64>,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Debug + Sync,
    P: Keep,
{
    /// Returns the identity of this ensemble as lines of text, independent of threads and shards.
    ///
    /// # Errors
    /// If a closure of the user panics.
    pub(super) fn settings(&self) -> Result<String, EnsembleError> {
        let (batch, [from, until]) = (&self.batch, self.batch.span());
        let mut lines = Vec::from([
            format!("ensemble of lagrange {}, format {FORMAT}", env!("CARGO_PKG_VERSION")),
            format!("system {}", type_name::<M>()),
            format!("equations, constants, events and tables with the fingerprint {:016x}", M::FINGERPRINT),
            format!("motions {}", batch.number),
            format!("motions per part {}", batch.motions_per_part),
            format!("seed {}", batch.seed),
            format!("from {from:?} until {until:?}"),
            format!("method {} {:?}", self.method.name(), self.method),
        ]);
        // Runs and lanes yield different bits, and the bits of lanes depend on the processor.
        if self.is_in_lanes() {
            lines.push(format!("in lanes, products {}", if is_fused() { "fused" } else { "rounded" }));
        }
        lines.extend(words(&batch.plan.settings).into_iter().map(|words| format!("run {words}")));
        let further = self.drive.close(batch.system, ClosedLoop::further_columns);
        lines.extend(further.into_iter().map(|name| format!("column {name}")));
        for index in [0, batch.number / 2, batch.number - 1] {
            lines.extend(caught(index, || [self.probe(index), self.outset(index)])?);
        }
        Ok(lines.join("\n"))
    }

    /// Returns a line with the bits of state, rates and parameters at the start of a motion.
    fn probe(&self, index: usize) -> String {
        let (varied, state) = self.batch.origin(index);
        let system = varied.as_ref().unwrap_or(self.batch.system);
        let t = self.batch.span()[0];
        let rates = self.drive.close(system, |closed| closed.rhs(t, &closed.extended(t, &state)));
        let parameters: Vec<_> =
            (0..).map_while(|index| system.parameter(index)).map(|(_, value)| value).collect();
        let [start, rates, parameters] = [state.as_ref(), rates.as_ref(), &parameters].map(bits);
        format!("motion {index} starts at {start} with rates {rates} and parameters {parameters}")
    }

    /// Returns a line with the bits of time and columns of a motion after its first steps.
    fn outset(&self, index: usize) -> String {
        let (varied, state) = self.batch.origin(index);
        let system = varied.as_ref().unwrap_or(self.batch.system);
        let run = self.run_of(index, (system, state), Sampling::EveryStep).max_steps(STEPS).run();
        let (table, _) = samples(&run);
        let row = [table.times()].into_iter().chain(table.columns()).filter_map(<[_]>::last).copied();
        let row: Vec<_> = row.collect();
        format!("motion {index} comes to {} in its first steps", bits(&row))
    }
}

/// Returns the settings of runs as text.
fn words<S: Scalar>(settings: &RunSettings<S>) -> Vec<String> {
    let RunSettings { max_steps, longest_step, restarts, columns, events, periods, .. } = settings;
    let mut words = Vec::new();
    words.extend(settings.interval().map(|interval| format!("every {interval:?}")));
    words.extend(max_steps.map(|limit| format!("at most {limit} steps")));
    words.extend(longest_step.as_ref().map(|longest| format!("no step longer than {longest:?}")));
    words.extend(columns.iter().map(|name| format!("column {}", name.escape_debug())));
    words.extend(
        events.iter().map(|(name, direction)| format!("event {} {direction:?}", name.escape_debug())),
    );
    words.extend(periods.iter().map(|period| format!("sampled every {period:?}")));
    words.extend((!restarts.is_empty()).then(|| format!("restarts at {restarts:?}")));
    words
}

/// Returns the bits of numbers in hexadecimal.
fn bits<S: Copy + Into<f64>>(values: &[S]) -> String {
    let bits = values.iter().map(|value| format!("{:016x}", Into::<f64>::into(*value).to_bits()));
    bits.collect::<Vec<_>>().join(" ")
}

/// Number of steps whose bits identify methods, functions of the user's crate, inputs and columns,
/// beyond their names.
const STEPS: u64 = 8;

/// Prefix of lines about single motions. If other lines differ too, those are reported, being more
/// informative.
const MOTION: &str = "motion ";

/// Returns the first line of each identity that is missing from the other, or an empty text if none
/// is missing. `None` if the identities are equal.
pub(super) fn difference(there: &str, here: &str) -> Option<[String; 2]> {
    let differing = |is_motion: bool| {
        let lines = |text| str::lines(text).filter(|line| line.starts_with(MOTION) == is_motion).collect();
        let [there, here]: [Vec<&str>; 2] = [lines(there), lines(here)];
        let only = |one: &[&str], other: &[&str]| {
            one.iter().find(|line| !other.contains(line)).map(ToString::to_string).unwrap_or_default()
        };
        // The same lines in another order are a different ensemble, with columns in another order.
        (there != here).then(|| [only(&there, &here), only(&here, &there)])
    };
    differing(false).or_else(|| differing(true))
}
