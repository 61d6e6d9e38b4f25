//! An integration problem: start, end, the state at the end, and the solvers that can handle it.

/// The outcome of a run.
pub(crate) struct Run {
    pub(crate) state: [f64; 4],
    /// Evaluations of the right-hand side.
    pub(crate) evaluations: u64,
}

/// A program that integrates a case to a tolerance, relative and absolute.
pub(crate) struct Solver {
    pub(crate) name: &'static str,
    /// True if it is another crate.
    pub(crate) is_peer: bool,
    /// `None` if it gives up.
    pub(crate) run: Box<dyn Fn(f64) -> Option<Run>>,
}

/// The start and the duration of a motion.
#[derive(Clone, Copy)]
pub(crate) struct Motion {
    pub(crate) start: [f64; 4],
    pub(crate) end: f64,
}

/// A motion with all its solvers.
pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) reference: [f64; 4],
    /// Errors to be reached.
    pub(crate) goals: &'static [f64],
    pub(crate) solvers: Vec<Solver>,
}

impl Case {
    /// Returns the largest error of a component.
    pub(crate) fn error(&self, run: &Run) -> f64 {
        let errors = run.state.iter().zip(&self.reference).map(|(found, exact)| (found - exact).abs());
        errors.fold(0.0, |largest, error| if error <= largest { largest } else { error })
    }
}
