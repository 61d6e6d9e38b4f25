//! Ensembles in lanes, which several motions share.

use std::boxed::Box;
use std::string::{String, ToString};

use super::Trade;
use super::contestant::{self, Contestant, Knob, VectorEnd};
use super::digits::split_all;
use crate::ensemble::{Ensembles, SharedSystem};
use crate::integrate::{Method, Taylor, Verner98, Work};
use crate::run::RunEnd;
use crate::scalar::Number;
use crate::system::TaylorSystem;

/// Number of motions of an ensemble: enough to hide its start, and a multiple of any number of
/// lanes.
const MOTIONS: usize = 64;

impl<'a> Trade<'a> {
    /// Adds an ensemble of equal motions in lanes, on one thread. Its times are those of one
    /// motion.
    ///
    /// # Panics
    /// As [`variant`](Self::variant).
    #[must_use]
    pub fn lanes<M>(self, name: &str, system: &'a M) -> Self
    where
        M: SharedSystem,
        M::Scalar: Into<f64>,
    {
        self.in_lanes(name, system, Verner98::tolerance)
    }

    /// Adds an ensemble of equal motions in lanes along Taylor series, as [`lanes`](Self::lanes)
    /// does.
    ///
    /// # Panics
    /// As [`variant`](Self::variant).
    #[must_use]
    pub fn taylor_lanes<M>(self, name: &str, system: &'a M) -> Self
    where
        M: SharedSystem + TaylorSystem,
        M::Scalar: Into<f64>,
    {
        self.in_lanes(name, system, Taylor::tolerance)
    }

    fn in_lanes<M, K>(mut self, name: &str, system: &'a M, method: fn(M::Scalar) -> K) -> Self
    where
        M: SharedSystem,
        M::Scalar: Into<f64>,
        K: Method<M> + Clone + Sync + 'a,
    {
        assert_eq!(contestant::length::<M>(), self.start.len(), "{name} has a state of another length");
        let run = move |tolerance, start: &[f64], end| {
            first_end(system, method(M::Scalar::from_f64(tolerance)), start, end)
        };
        let title = method(M::Scalar::ONE).name();
        let contestant = Contestant::new::<M, K>(name, Knob::Tolerance, MOTIONS, Box::new(run), title);
        self.contestants.push(contestant);
        self
    }
}

/// Runs equal motions, and returns the end of the first.
fn first_end<M, K>(system: &M, method: K, start: &[f64], end: f64) -> Result<VectorEnd, String>
where
    M: SharedSystem,
    M::Scalar: Into<f64>,
    K: Method<M> + Clone + Sync,
{
    let (start, until) = (contestant::rounded::<M>(start), M::Scalar::from_f64(end));
    let motions = system.ensemble(MOTIONS).start(move |_, _| start).until(until).method(method).threads(1);
    if !motions.is_in_lanes() {
        return Err("the system does not run in lanes".to_string());
    }
    let ends = motions.run().map_err(|error| error.to_string())?;
    let first = ends.state(0).ok_or("the motion fails")?;
    Ok(RunEnd { time: end, state: split_all(first.as_ref()), work: Work::default() })
}
