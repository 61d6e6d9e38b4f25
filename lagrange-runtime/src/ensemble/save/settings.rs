//! What an ensemble is, in lines of text, so that its parts are not mixed with those of another.

use core::fmt::Debug;
use std::any::type_name;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::ensemble::asked::SharedSystem;
use crate::ensemble::builder::{Ensemble, Keep};
use crate::ensemble::error::EnsembleError;
use crate::ensemble::lanes::is_fused;
use crate::ensemble::motion::caught;
use crate::integrate::Method;
use crate::simulate::Drive;
use crate::system::OdeSystem;

/// The number of what follows, to be raised when it changes.
const FORMAT: u32 = 2;

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    M::Scalar: Into<f64>,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Debug + Sync,
    P: Keep,
{
    /// What this ensemble is, but for how it is computed: lines of text.
    ///
    /// # Errors
    /// If a closure that was given panics.
    pub(super) fn settings(&self) -> Result<String, EnsembleError> {
        let asked = &self.asked;
        let mut lines = Vec::from([
            format!("ensemble of lagrange {}, format {FORMAT}", env!("CARGO_PKG_VERSION")),
            format!("system {}", type_name::<M>()),
            format!("motions {}", asked.number),
            format!("motions per part {}", asked.motions_per_part),
            format!("seed {}", asked.seed),
            format!("from {:?} until {:?}", asked.from, asked.end),
            format!("method {} {:?}", self.method.name(), self.method),
        ]);
        // Bits of runs are another matter than bits of lanes, and these depend on the processor.
        if self.is_in_lanes() {
            lines.push(format!("in lanes, products {}", if is_fused() { "fused" } else { "rounded" }));
        }
        lines.extend(asked.words.iter().map(|words| format!("run {}", words.escape_debug())));
        for index in [0, asked.number / 2, asked.number - 1] {
            lines.push(caught(index, || self.probe(index))?);
        }
        Ok(lines.join("\n"))
    }

    /// The bits of state, rates and parameters with which a motion starts.
    fn probe(&self, index: usize) -> String {
        let (varied, state) = self.asked.origin(index);
        let system = varied.as_ref().unwrap_or(self.asked.system);
        let rates = self.drive.close(system, |closed| closed.rhs(self.asked.from, &state));
        let parameters: Vec<_> =
            (0..).map_while(|index| system.parameter(index)).map(|(_, value)| value).collect();
        let bits = [state.as_ref(), rates.as_ref(), &parameters].map(|values| {
            let bits = values.iter().map(|value| format!("{:016x}", Into::<f64>::into(*value).to_bits()));
            bits.collect::<Vec<_>>().join(" ")
        });
        format!("motion {index} starts at {} with rates {} and parameters {}", bits[0], bits[1], bits[2])
    }
}

/// The first line of each that the other has not, if there are such; nothing if the other has all.
pub(super) fn difference(there: &str, here: &str) -> Option<[String; 2]> {
    let only = |one: &str, other: &str| {
        let line = one.lines().find(|line| other.lines().all(|known| known != *line));
        line.unwrap_or_default().to_string()
    };
    // The same lines in another order are another ensemble: columns have another order.
    (there != here).then(|| [only(there, here), only(here, there)])
}
