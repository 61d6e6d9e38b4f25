//! Settings that runs and ensembles have in common, each written once for both builders.

/// Writes the setters of tolerances, for builders whose method is the default one.
macro_rules! tolerance_setters {
    () => {
        /// Sets the error tolerance of a step. It is relative for components of the state that are
        /// larger than one, and absolute for smaller ones. The default is 1e-9 for `f64` and 1.2e-6
        /// for `f32`.
        ///
        /// The error at the end is the sum of these errors, as propagated by the motion.
        pub fn tolerance(mut self, tolerance: M::Scalar) -> Self {
            self.method.relative = tolerance;
            self.method.absolute = tolerance;
            self
        }

        /// Sets the absolute error tolerance of a step, in the units of the state. Call it after
        /// [`tolerance`](Self::tolerance), which then applies only to the relative error.
        pub fn absolute_tolerance(mut self, tolerance: M::Scalar) -> Self {
            self.method.absolute = tolerance;
            self
        }
    };
}
pub(crate) use tolerance_setters;

/// Writes the setters of steps. The argument is the path from the builder to its plan.
macro_rules! run_setters {
    ($($plan:ident).+) => {
        /// Sets the maximum number of steps, including rejected ones, after which a motion fails.
        /// The default method is limited to a hundred million steps; other methods have no limit.
        pub fn max_steps(mut self, limit: u64) -> Self {
            self.$($plan).+.settings.max_steps = Some(limit);
            self
        }

        /// Sets the maximum length of a step, so that steps do not skip effects that last about a
        /// quarter of it. By default, steps are at most a twentieth of the run, and a quarter with
        /// Taylor series. While the system is at rest, they are at most a two-hundredth. Methods
        /// with a fixed step length report an error.
        pub fn longest_step(mut self, longest: M::Scalar) -> Self {
            self.$($plan).+.settings.longest_step = Some(longest);
            self
        }

        /// Ends a step at each of these times and starts the next one there, for forces with jumps
        /// or kinks at known times. Times outside the run have no effect; further calls add times.
        ///
        /// Nothing is evaluated exactly at such a time, so it does not matter which side a jump
        /// belongs to.
        pub fn restart_at(mut self, times: impl IntoIterator<Item = M::Scalar>) -> Self {
            self.$($plan).+.settings.restarts.extend(times);
            self
        }
    };
}
pub(crate) use run_setters;
