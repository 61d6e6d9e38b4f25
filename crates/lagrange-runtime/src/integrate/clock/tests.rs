//! Times in equal steps, compared with sums in sufficiently exact numbers.

use super::{Clock, check_step, least_step};
use crate::scalar::Scalar;

/// A linear congruential generator after Knuth, MMIX.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Distances between times, exact as the sum of a high and a low part.
#[derive(Clone, Copy)]
struct Sum(f64, f64);

impl Sum {
    fn add(self, x: f64) -> Self {
        let high = self.0 + x;
        let part = high - self.0;
        Sum(high, self.1 + ((self.0 - (high - part)) + (x - part)))
    }
}

/// Walks from one time to another and checks every step. Returns the number of steps.
fn walk<S: Scalar + Into<f64>>(start: S, limit: S, step: S) -> usize {
    let what = std::format!("from {start:?} to {limit:?} by {step:?}");
    let (mut clock, mut sum, mut steps) = (Clock::new(start, step), Sum(start.into(), 0.0), 0);
    while clock.time() != limit {
        let before = clock;
        sum = sum.add(clock.advance(limit).into());
        let [from, time, end] = [before.time(), clock.time(), limit].map(Into::<f64>::into);
        let is_ahead = if limit < start { end <= time && time < from } else { from < time && time <= end };
        assert!(is_ahead && !before.is_stopped(&clock), "{what}: {from:e}, {time:e}");
        let rounding = Into::<f64>::into(S::epsilon()) * (time.abs() * 0.5 + step.into());
        let lag = (sum.0 - time) + sum.1;
        assert!(lag.abs() <= rounding, "{what}: {lag:e} off at {time:e}, step {steps}");
        steps += 1;
        assert!(steps < 100_000, "{what}: never ends");
    }
    steps
}

/// Checks short walks between times that are multiples of the step, neighbours of multiples, or
/// arbitrary.
fn check_frames<S: Scalar + Into<f64>>(count: usize) {
    let mut random = Random(1);
    for frame in 0..count {
        let step = [1.0 / 60.0, 1e-3, 0.1 + random.next(), 1e-3 * random.next()][frame % 4];
        let most: f64 = if size_of::<S>() == 4 { 3e5 } else { 1e14 };
        let first = (random.next() * most.powf(random.next())).floor();
        let first = if frame % 3 == 0 { -first } else { first };
        let steps = 1.0 + (random.next() * 8.0).floor() + if frame % 5 == 0 { random.next() } else { 0.0 };
        let (start, limit) = (S::from_f64(first * step), S::from_f64((first + steps) * step));
        let nudge = S::ONE + S::from_f64((random.next() * 5.0).floor() - 2.0) * S::epsilon();
        let [start, limit] = if frame % 2 == 0 { [start, limit * nudge] } else { [limit * nudge, start] };
        let step = S::from_f64(step);
        let is_fine = [start, limit].into_iter().all(|time| step >= least_step(time));
        if is_fine && check_step(step, start, limit).is_ok() && start != limit {
            let (found, wanted) = (walk(start, limit, step) as f64, steps.ceil());
            assert!(
                (found - wanted).abs() <= 1.0,
                "{found} steps for {wanted}: {start:?} {limit:?} {step:?}"
            );
        }
    }
}

/// Ten thousand frames, or the number set by `LAGRANGE_FRAMES`.
#[test]
fn times_advance_and_belong_to_the_steps_that_lead_there() {
    let count = std::env::var("LAGRANGE_FRAMES").ok().and_then(|count| count.parse().ok()).unwrap_or(10_000);
    check_frames::<f64>(count);
    check_frames::<f32>(count);
}

#[test]
fn a_frame_is_one_step() {
    for frame in 0..20_000_u16 {
        let [start, limit] = [frame, frame + 1].map(|index| f32::from(index) / 60.0);
        assert_eq!(walk(start, limit, 1.0 / 60.0), 1, "frame {frame}");
    }
}

#[test]
fn steps_that_are_lost_are_found_at_either_end() {
    for (step, start, end) in [(1e-300, 0.0, 1.0), (1e-9, 1e9, 1e9 + 1.0), (0.1, -1e15 + 1.0, -1e16)] {
        assert!(check_step(step, start, end).is_err(), "{step} from {start}");
        assert!(check_step(-step, start, end).is_err(), "{step} from {start}");
        assert!(check_step(step, end, start).is_err(), "{step} to {start}");
    }
    assert!(check_step(0.01_f32, 0.0, 1e4).is_ok() && check_step(0.01_f32, 0.0, 1e6).is_err());
    assert!(check_step(1e-300, 0.0, 1e-290).is_ok());
}
