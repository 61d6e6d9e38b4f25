//! The price of every digit: comparison of methods, number types and variants of a system.
//!
//! A [`Trade`] runs each method from coarse to fine settings, and measures the error at the end and
//! the computing time. It reports the fastest method for each accuracy, as the line to write.
//! `cargo run --release --features trade --example trade` does this for nine known systems. For
//! your own system, write:
//!
//! ```no_run
//! use lagrange::Double;
//!
//! lagrange::system! {
//!     pub struct Pendulum<S>;
//!     coord theta;
//!     kinetic = 1/2 * dot(theta)^2;
//!     potential = -9.81 * cos(theta);
//!     emit { jacobian, taylor }
//! }
//!
//! let (pendulum, wide) = (Pendulum::default(), Pendulum::<Double>::default());
//! let trade = lagrange::trade::Trade::new("my pendulum", &pendulum, [1.0, 0.0], 10.0);
//! let report = trade.taylor("standard", &pendulum).taylor("standard", &wide).run();
//! print!("{}", report.recommendation());
//! if let Some((row, _)) = report.fastest(1e-9) {
//!     println!("pendulum.simulate([1.0, 0.0]).until(10.0){}.run()?", row.line);
//! }
//! report.save("trade")?;
//! # Ok::<(), lagrange::simulate::PlotError>(())
//! ```
//!
//! A [`Taylor`](crate::integrate::Taylor) method needs `emit { taylor }`, and implicit methods are
//! faster with `emit { jacobian }`. With `Double`, the reference is accurate to rounding in `f64`.
//!
//! Times depend on the machine and its load; errors, evaluations and steps do not.

mod contestant;
mod diagram;
mod digits;
mod files;
mod ladder;
#[cfg(feature = "ensemble")]
mod lanes;
mod measurement;
mod methods;
mod report;

use std::string::{String, ToString};
use std::time::Instant;
use std::vec::Vec;

use self::contestant::Contestant;
use self::digits::{Digits, split_all};
use self::ladder::{Course, climb};
use crate::scalar::Scalar;
use crate::system::OdeSystem;

pub use self::contestant::Knob;
pub use self::measurement::{MeasuredRun, Measurement};
pub use self::report::Report;

/// A motion, and all contestants that compute it.
pub struct Trade<'a> {
    title: String,
    start: Vec<f64>,
    end: f64,
    reference: Option<Vec<Digits>>,
    sizes: Vec<f64>,
    longest: f64,
    contestants: Vec<Contestant<'a>>,
}

/// Default number of seconds after which finer settings of a method are not tried.
const LONGEST: f64 = 0.2;
/// Tolerances of the reference. Methods of low order do not reach the finest ones in a reasonable
/// time.
const FINEST: [f64; 9] = [1e-8, 1e-10, 1e-12, 1e-13, 1e-14, f64::EPSILON, 1e-20, 1e-25, 1e-30];
/// Maximum duration of a run for the reference, relative to that of other runs; finer ones are not
/// tried.
const PATIENCE: f64 = 10.0;

impl<'a> Trade<'a> {
    /// Creates the comparison of all methods that accept any system. The motion of `system` starts
    /// from the state `start` at time zero and lasts until the time `end`.
    pub fn new<M>(title: &str, system: &'a M, start: M::State, end: M::Scalar) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
    {
        let start = start.as_ref().iter().map(|component| (*component).into()).collect();
        Trade::without_methods(title, start, end.into()).variant("standard", system)
    }

    /// Creates the comparison of a motion from these entries of the state at time zero, without any
    /// methods yet.
    pub fn without_methods(title: &str, start: Vec<f64>, end: f64) -> Self {
        Trade {
            title: title.to_string(),
            start,
            end,
            reference: None,
            sizes: Vec::new(),
            longest: LONGEST,
            contestants: Vec::new(),
        }
    }

    /// Sets the state at the end, in any number type. The default is the end of the finest run of a
    /// method with a tolerance, in the finest number type. Errors close to its rounding are then
    /// not reliable.
    ///
    /// # Panics
    /// If its length differs from that of the state at the start.
    #[must_use]
    pub fn reference<S: Scalar + Into<f64>>(mut self, state: &[S]) -> Self {
        assert_eq!(state.len(), self.start.len(), "the reference is a state of another system");
        self.reference = Some(split_all(state));
        self
    }

    /// Sets the sizes in which errors of the components are measured: one by default. Components of
    /// extreme units need them.
    ///
    /// # Panics
    /// If their number differs from that of the components.
    #[must_use]
    pub fn sizes(mut self, sizes: &[f64]) -> Self {
        assert_eq!(sizes.len(), self.start.len(), "the sizes are those of another system");
        self.sizes = sizes.to_vec();
        self
    }

    /// Sets the number of seconds after which finer settings are not tried.
    #[must_use]
    pub fn longest(mut self, seconds: f64) -> Self {
        self.longest = seconds;
        self
    }

    /// Runs all contestants, one after the other.
    pub fn run(&self) -> Report {
        let (reference, was_cut) = match &self.reference {
            Some(state) => (Some(state.clone()), false),
            None => self.finest(),
        };
        let contestants = if reference.is_some() { &self.contestants[..] } else { &[] };
        let reference = reference.unwrap_or_default();
        let Trade { start, end, sizes, longest, .. } = self;
        let course = Course { start, end: *end, reference: &reference, sizes, longest: *longest };
        let climbs = contestants.iter().map(|contestant| climb(contestant, &course)).collect::<Vec<_>>();
        let is_cut = if climbs.is_empty() { was_cut } else { climbs.iter().any(|climb| climb.is_cut) };
        Report {
            title: self.title.clone(),
            has_own_reference: self.reference.is_none(),
            epsilon: self
                .contestants
                .iter()
                .map(|contestant| contestant.epsilon)
                .fold(f64::EPSILON, f64::min),
            rows: climbs.into_iter().flat_map(|climb| climb.rows).collect(),
            is_cut,
        }
    }

    /// Returns the end of the finest run of the first method with a tolerance that reaches it, in
    /// the finest number type that does. The second value is true if finer runs would take too
    /// long.
    fn finest(&self) -> (Option<Vec<Digits>>, bool) {
        let is_adaptive = |contestant: &&Contestant<'_>| contestant.knob == Knob::Tolerance;
        let mut adaptive = self.contestants.iter().filter(is_adaptive).collect::<Vec<_>>();
        adaptive.sort_by(|a, b| a.epsilon.total_cmp(&b.epsilon));
        let mut is_cut = false;
        let finest = adaptive.into_iter().find_map(|contestant| {
            let mut finest = None;
            let resolution = contestant.epsilon.min(f64::EPSILON);
            for tolerance in FINEST.into_iter().filter(|tolerance| *tolerance >= resolution) {
                let began = Instant::now();
                let run = (contestant.run)(tolerance, &self.start, self.end).ok();
                finest = run.map(|run| run.state).or(finest);
                if began.elapsed().as_secs_f64() > PATIENCE * self.longest {
                    is_cut = true;
                    break;
                }
            }
            finest
        });
        (finest, is_cut)
    }
}

#[cfg(test)]
mod tests;
