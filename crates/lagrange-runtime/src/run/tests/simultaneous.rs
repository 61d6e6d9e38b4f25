//! Switches that change their sides together, or nearly so.

use core::cell::Cell;
use std::vec::Vec;

use crate::event::{SwitchedSystem, Switches, change_side, choose_sides, side_values};
use crate::integrate::{RungeKutta4, Verner98};
use crate::run::integrate;
use crate::system::{DeclaredEvent, OdeSystem, Reacted, StepFailure};

/// N oscillators ẍ = −x − |x|/2, with L = 2 N entries of the state. Evaluations of event functions
/// are counted.
#[derive(Clone, Copy)]
struct Row<'a, const N: usize, const L: usize> {
    switches: Switches,
    evaluations: &'a Cell<usize>,
}

impl<const N: usize, const L: usize> OdeSystem for Row<'_, N, L> {
    type Scalar = f64;
    type State = [f64; L];

    const EVENTS: &'static [DeclaredEvent] = &[DeclaredEvent::side("x"); N];

    fn rhs(&self, _t: f64, y: &[f64; L]) -> [f64; L] {
        let sides: [f64; N] = self.switches.signs(|| core::array::from_fn(|k| y[k]));
        core::array::from_fn(|k| if k < N { y[N + k] } else { -y[k - N] - sides[k - N] * y[k - N] / 2.0 })
    }

    fn event_values(&self, t: f64, y: &[f64; L], values: &mut [f64]) {
        self.evaluations.set(self.evaluations.get() + 1);
        side_values(self, t, y, values);
    }

    fn react(&self, event: usize, t: f64, _elapsed: f64, y: &[f64; L]) -> Reacted<Self> {
        change_side(self, event, t, y)
    }

    fn begin(&self, t: f64, y: &[f64; L]) -> Result<Option<Self>, StepFailure<f64>> {
        Ok(choose_sides(self, t, y))
    }
}

impl<const N: usize, const L: usize> SwitchedSystem for Row<'_, N, L> {
    const FIRST: usize = 0;

    fn switches(&self) -> Switches {
        self.switches
    }

    fn with_switches(&self, switches: Switches) -> Self {
        Row { switches, ..*self }
    }

    fn switch_values(&self, _t: f64, y: &[f64; L], values: &mut [f64]) {
        values.copy_from_slice(&y[..N]);
    }
}

const HALVES: [f64; 2] = [1.5, 0.5];

/// Returns the motion from rest at x = 1: cosines and sines with ω² = 3/2 above zero and 1/2 below.
fn exact(t: f64) -> f64 {
    let [above, below] = HALVES.map(f64::sqrt);
    let [first, second] = [above, below].map(|w| core::f64::consts::PI / w);
    let since = (t + first / 2.0) % (first + second);
    let speed = above;
    if since < first {
        speed / above * (above * since).sin()
    } else {
        -speed / below * (below * (since - first)).sin()
    }
}

/// Returns the number of evaluations of event functions in a run from these amplitudes, and its
/// largest error relative to them.
fn run<const N: usize, const L: usize>(amplitude: impl Fn(usize) -> f64, is_fixed: bool) -> (usize, f64) {
    let evaluations = Cell::new(0);
    let row = Row::<N, L> { switches: Switches::FREE, evaluations: &evaluations };
    let start = core::array::from_fn(|k| if k < N { amplitude(k) } else { 0.0 });
    let (end, mut count) = (8.0, 0);
    let mut seen = |_: f64, _: &[f64; L]| count += 1;
    let last = match is_fixed {
        true => integrate(&row, 0.0, start, end, &RungeKutta4 { step: 0.05 }, &mut seen),
        false => integrate(&row, 0.0, start, end, &Verner98::tolerance(1e-11), &mut seen),
    };
    let last = last.unwrap_or_else(|error| panic!("{N}: {error}"));
    let errors = (0..N).map(|k| (last[k] / amplitude(k) - exact(end)).abs());
    assert!(count > 0);
    (evaluations.get(), errors.fold(0.0, f64::max))
}

/// Runs with as many oscillators as there are switches to be looked for, and with few.
fn runs(amplitude: impl Fn(usize) -> f64 + Copy, is_fixed: bool) -> Vec<(usize, f64)> {
    let runs = [
        run::<5, 10>(amplitude, is_fixed),
        run::<10, 20>(amplitude, is_fixed),
        run::<20, 40>(amplitude, is_fixed),
        run::<40, 80>(amplitude, is_fixed),
        run::<64, 128>(amplitude, is_fixed),
    ];
    runs.to_vec()
}

#[test]
fn many_switches_that_change_together_take_hardly_more_evaluations_than_few() {
    let amplitudes: [fn(usize) -> f64; 3] = [
        |_| 1.0,
        // The same phase, up to rounding.
        |k| 1.0 + k as f64 / 7.0,
        |k| if k % 2 == 0 { 1e-3 } else { 1e3 },
    ];
    for (case, amplitude) in amplitudes.into_iter().enumerate() {
        for is_fixed in [false, true] {
            let runs = runs(amplitude, is_fixed);
            let allowed = if is_fixed { 1e-5 } else { 1e-8 };
            for &(evaluations, error) in &runs {
                assert!(evaluations < 5 * runs[0].0, "{case}, {is_fixed}: {runs:?}");
                assert!(error < allowed, "{case}, {is_fixed}: {runs:?}");
            }
        }
    }
}
