//! Runs over arbitrarily divided spans of time: frames of a real-time simulation, and spans far
//! from zero.
//!
//! A ball under gravity is the reference. Methods of order two and more are exact for it up to
//! rounding, and so are its bounces. Times are numbers of the scalar type, so that the distance
//! between neighbouring times determines rounding.

use lagrange::event::Direction;
use lagrange::integrate::{
    BlanesMoan4, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, RungeKutta4, StormerVerlet,
    SymplecticEuler, Variational, Verner98, integrate,
};
use lagrange::simulate::Trajectory;
use lagrange::system::{EventKind, OdeSystem};
use lagrange::{Scalar, Simulate};

lagrange::system! {
    struct Fall<S>;

    param g = 9.81;
    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    emit { momentum_rates }
}

lagrange::system! {
    struct Bounce<S>;

    param g = 9.81;
    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event floor = y, falling => { dot(y) = -dot(y); }
    emit { momentum_rates }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Ball;

    param e = 0.7;
    coord y;
    kinetic = kinetic_energy(1, dot(y));
    potential = 9.81 * y;
    event floor = y, falling => impact(e);
}

lagrange::system! {
    /// On a rough floor beside a kink, pulled by a controller.
    #[derive(Clone, Debug)]
    struct Block;

    coord x;
    input u;
    kinetic = kinetic_energy(1, dot(x));
    force x = u - 4 * x - abs(x - 1/2);
    friction slide = dot(x), 0.3 * 9.81;
    event half = x - 1, falling => record;
}

lagrange::system! {
    struct Swing;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    event up = x, rising => record;
    event down = x, falling => record;
}

const GRAVITY: f64 = 9.81;

/// A linear congruential generator after Knuth, MMIX.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Returns height and speed of a ball that rises from the floor to one metre, at a time after a
/// bounce.
fn bounced(time: f64) -> [f64; 2] {
    let speed = (2.0 * GRAVITY).sqrt();
    let since = time.rem_euclid(2.0 * speed / GRAVITY);
    [since * (speed - GRAVITY * since / 2.0), speed - GRAVITY * since]
}

/// Returns the same without a floor.
fn thrown(time: f64) -> [f64; 2] {
    let speed = (2.0 * GRAVITY).sqrt();
    [time * (speed - GRAVITY * time / 2.0), speed - GRAVITY * time]
}

/// Consecutive spans, the phase of the ball at their beginning, and the step of methods.
struct Spans<S> {
    times: Vec<S>,
    phase: f64,
    step: S,
}

impl<S: Scalar + Into<f64>> Spans<S> {
    /// Returns frames between multiples of the step, or of another period, from a random time on.
    fn random(random: &mut Random, index: usize) -> Self {
        let step = [1.0 / 60.0, 1.0 / 240.0, 0.01, 0.002 + 0.02 * random.next()][index % 4];
        let period = if index.is_multiple_of(3) { step * (0.3 + 3.0 * random.next()) } else { step };
        // Far enough that times are rounded coarsely, while steps remain much longer than that.
        let farthest = step / (256.0 * period * S::epsilon().into());
        let first = (random.next() * farthest.powf(random.next())).floor() - 3.0;
        let times = (0..=4 + index % 3).map(|k| S::from_f64((first + k as f64) * period)).collect();
        let phase = if index.is_multiple_of(7) { 0.0 } else { 0.9 * random.next() };
        Spans { times, phase, step: S::from_f64(step) }
    }

    /// Returns the effect of rounding on a height or a speed: from the times of each step and
    /// bounce, and from the numbers themselves.
    fn rounding(&self) -> f64 {
        let farthest = self.times.iter().fold(0.0_f64, |most, time| most.max((*time).into().abs()));
        32.0 * self.times.len() as f64 * S::epsilon().into() * (2.0 + 10.0 * farthest)
    }

    /// Integrates all spans one after the other, or the whole at once, and checks every observed
    /// state.
    fn check<M, K>(&self, name: &str, method: &K, system: &M, exact: fn(f64) -> [f64; 2], slack: f64)
    where
        M: OdeSystem<Scalar = S, State = [S; 2]>,
        K: Method<M>,
    {
        let start: f64 = self.times[0].into();
        let tolerance = self.rounding() + slack;
        let first = exact(self.phase).map(S::from_f64);
        for times in [self.times.clone(), vec![self.times[0], self.times[self.times.len() - 1]]] {
            let mut state = first;
            for span in times.windows(2) {
                let what = format!("{name} from {:?} to {:?} by {:?}", span[0], span[1], self.step);
                let mut last: Option<(S, [S; 2])> = None;
                let end = integrate(system, span[0], state, span[1], method, |t, y| {
                    let [found, wanted] = [(*y).map(Into::into), exact(self.phase + (t.into() - start))];
                    let error = (found[0] - wanted[0]).abs().max((found[1].abs() - wanted[1].abs()).abs());
                    assert!(error <= tolerance, "{what}: {found:?} at {t:?}, not {wanted:?} ({error:e})");
                    // An event shows the state before and after it, and the latter belongs to the
                    // same time.
                    let advances =
                        last.is_none_or(|(before, [_, v])| before < t || (before == t && v == -y[1]));
                    assert!(advances && t <= span[1], "{what}: {t:?} after {last:?}");
                    last = Some((t, *y));
                });
                state = end.unwrap_or_else(|error| panic!("{what}: {error}"));
                assert_eq!(last.map(|(t, _)| t), Some(span[1]), "{what}");
            }
        }
    }

    fn check_all(&self) {
        let step = self.step;
        let h: f64 = step.into();
        let (fall, bounce) = (Fall::<S>::default(), Bounce::<S>::default());
        macro_rules! check {
            ($($method:expr, $slack:expr, $between:expr;)*) => {
                $(
                    let (name, method) = (stringify!($method), $method);
                    self.check(name, &method, &fall, thrown, $slack);
                    self.check(name, &method, &bounce, bounced, $slack + $between);
                )*
            };
        }
        // Errors of the methods themselves, and of their dense output.
        let (line, first_order) = (8.0 * GRAVITY * h * h, 16.0 * GRAVITY * h);
        check! {
            RungeKutta4 { step }, 0.0, 0.0;
            StormerVerlet { step }, 0.0, 0.0;
            BlanesMoan4 { step }, 0.0, 0.0;
            SymplecticEuler { step }, first_order, first_order;
            ImplicitMidpoint { step }, 0.0, line;
            GaussLegendre4 { step }, 0.0, 0.0;
            GaussLegendre6 { step }, 0.0, 0.0;
            GaussLegendre4 { step }.plain(), 0.0, 0.0;
            Variational { step }, 0.0, 0.0;
            Verner98::tolerance(S::from_f64(1e-6)), 0.0, 0.0;
        }
    }
}

/// The ball reaches the floor one rounding before the end of a step, where single precision cannot
/// resolve it.
#[test]
fn a_zero_at_the_end_of_a_step_is_found_in_short_numbers() {
    let (start, end) = (f32::from_bits(0x4013_3333), f32::from_bits(0x4014_4444));
    for down in 0..400 {
        let height = f32::from_bits(0x3d99_7930 + down);
        let state = [height, f32::from_bits(0xc08d_4390)];
        let method = RungeKutta4 { step: 1.0 / 60.0 };
        let [y, v] =
            integrate(&Bounce::<f32>::default(), start, state, end, &method, |_, _| {}).expect("ends");
        assert!(y.abs() < 2e-5 && (v.abs() - 4.578).abs() < 1e-4, "from {height}: {y} {v}");
    }
}

/// Tests forty runs of frames by all methods, or the number in `LAGRANGE_FRAMES`.
#[test]
fn frames_advance_time_with_the_state_and_add_up() {
    let count = std::env::var("LAGRANGE_FRAMES").ok().and_then(|count| count.parse().ok()).unwrap_or(40);
    let mut random = Random(1);
    for index in 0..count {
        Spans::<f64>::random(&mut random, index).check_all();
        Spans::<f32>::random(&mut random, index).check_all();
    }
}

/// At the farthest start of runs of some seconds, neighbouring times are two milliseconds apart.
const STARTS: [f64; 8] = [0.0, -2.0, 1e3, -1e6, 1e9, 1.7e9, 1e12, 1e13];

/// Returns the allowed error of a motion that starts there: rates of this size over a few roundings
/// of time.
fn coarseness(start: f64, rate: f64) -> f64 {
    1e-8 + 40.0 * f64::EPSILON * start.abs() * rate
}

fn assert_near<const N: usize>(found: [f64; N], wanted: [f64; N], tolerance: f64, what: &str) {
    let is_near = found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() <= tolerance);
    assert!(is_near, "{what}: {found:?}, not {wanted:?} to {tolerance:e}");
}

/// Returns the times of the impacts of a ball since the start, and its end.
fn fallen(ball: &Ball, start: f64, method: impl Method<Ball>) -> (Vec<f64>, Trajectory<Ball>) {
    let run =
        ball.simulate([1.0, 0.0]).from(start).until(start + 3.0).method(method).max_steps(100_000).dense();
    let run = run.run().unwrap_or_else(|error| panic!("from {start}: {error}"));
    (run.events().iter().map(|event| event.time - start).collect(), run)
}

#[test]
fn impacts_do_not_depend_on_where_time_is_counted_from() {
    for e in [0.0, 0.5, 0.7, 0.95, 1.0] {
        let ball = Ball { e, ..Ball::default() };
        // For a series of bounces that ends, its end.
        let flight = 2.0 * (2.0 / GRAVITY).sqrt();
        let rest = flight * (0.5 + e / (1.0 - e));
        for start in STARTS {
            let what = format!("e = {e} from {start}");
            for (impacts, run) in [
                fallen(&ball, start, Verner98::tolerance(1e-10)),
                fallen(&ball, start, RungeKutta4 { step: 1.0 / 64.0 }),
            ] {
                let (mut time, mut hop) = (flight / 2.0, e * flight);
                // A hop shorter than this is indistinguishable from those after it.
                let shortest = 1e-5 + 200.0 * f64::EPSILON * start.abs();
                for found in &impacts {
                    if hop <= shortest && e > 0.0 {
                        break;
                    }
                    assert_near([*found], [time], coarseness(start, 4.0), &what);
                    (time, hop) = (time + hop, e * hop);
                }
                let is_closed =
                    matches!(run.events().last().map(|event| event.kind), Some(EventKind::Closed { .. }));
                assert_eq!(is_closed, rest < 3.0, "{what}");
                if is_closed {
                    assert_eq!(run.last(), [0.0, 0.0], "{what}");
                    let last = impacts.last().copied().unwrap_or_default();
                    assert!(last <= rest + 1e-6 && impacts.len() > 1 || e == 0.0, "{what}: {impacts:?}");
                }
                let [y, v] = run.at(start + 0.3).expect("dense");
                assert_near([y, v], [1.0 - 0.045 * GRAVITY, -0.3 * GRAVITY], coarseness(start, 10.0), &what);
                if e == 1.0 {
                    let energy = GRAVITY * run.last()[0] + 0.5 * run.last()[1].powi(2);
                    assert_near([energy], [GRAVITY], coarseness(start, 100.0), &what);
                }
            }
        }
    }
}

#[test]
fn friction_switches_controllers_and_samples_do_not_depend_on_where_time_is_counted_from() {
    let block = Block::default();
    let pulled = |start: f64| {
        let pull =
            |_: &Block, _: f64, state: BlockState| BlockInputs { u: if state.x > 1.2 { 1.0 } else { -1.0 } };
        let run = block.simulate([2.0, 0.0]).from(start).until(start + 4.0).tolerance(1e-10);
        run.sampled(0.25, pull).every(0.125).dense().run().unwrap_or_else(|error| panic!("{start}: {error}"))
    };
    let near = pulled(0.0);
    assert!(near.events().len() >= 2 && near.len() == 33);
    for start in STARTS {
        let (far, what) = (pulled(start), format!("from {start}"));
        let tolerance = coarseness(start, 10.0);
        assert_near(far.last(), near.last(), tolerance, &what);
        assert_eq!(far.column("u"), near.column("u"), "{what}");
        for (index, (time, state)) in far.iter().enumerate() {
            assert_near([time - start], [near.times()[index]], tolerance, &what);
            assert_near(state, near.state(index).expect("a sample"), tolerance, &what);
        }
        assert_eq!(far.events().len(), near.events().len(), "{what}");
        for (far, near) in far.events().iter().zip(near.events()) {
            assert_eq!((&far.name, far.kind), (&near.name, near.kind), "{what}");
            assert_near([far.time - start], [near.time], coarseness(start, 40.0), &what);
        }
        for time in [0.1, 0.77, 1.9, 3.3] {
            let [far, near] = [far.at(start + time), near.at(time)].map(|state| state.expect("dense"));
            assert_near(far, near, tolerance, &what);
        }
    }
}

#[test]
fn steps_that_times_so_far_from_zero_cannot_tell_are_refused() {
    for start in [1e15, -1e15, 1e16] {
        let ball = Ball::default();
        let run = || ball.simulate([1.0, 0.0]).from(start).until(start + 64.0);
        for refused in [
            run().method(RungeKutta4 { step: 1.0 / 64.0 }).run(),
            run().longest_step(0.01).run(),
            run().every(0.1).run(),
        ] {
            let error = refused.err().unwrap_or_else(|| panic!("from {start}"));
            assert!(error.to_string().contains("below the rounding error of"), "{error}");
            assert_eq!(error.trajectory.last(), [1.0, 0.0]);
        }
    }
}

/// Runs backwards have the same instants. A function that increases in time decreases along them.
#[test]
fn directions_of_events_are_those_along_the_run() {
    let system = Swing;
    let swing = |direction, [from, until]: [f64; 2]| -> Vec<(String, f64)> {
        let phase = |t: f64| [-t.cos(), t.sin()];
        let run = system.simulate(phase(from)).from(from).until(until).tolerance(1e-12);
        let run = run.event("given", direction, |_, _, state| state[0]).run().expect("swings");
        run.events().iter().map(|event| (event.name.clone(), event.time)).collect()
    };
    let times = |found: &[(String, f64)], wanted: &str| -> Vec<f64> {
        found.iter().filter(|(name, _)| name == wanted).map(|(_, time)| *time).collect()
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    // The coordinate −cos t passes zero upwards at π/2 and 5π/2, downwards at 3π/2.
    let (up, down) = (vec![quarter, 5.0 * quarter], vec![3.0 * quarter]);
    for (direction, forwards, backwards) in
        [(Direction::Rising, &up, &down), (Direction::Falling, &down, &up)]
    {
        for (span, wanted, declared) in
            [([0.0, 9.0], forwards, ("up", "down")), ([9.0, 0.0], backwards, ("down", "up"))]
        {
            let found = swing(direction, span);
            for (name, wanted) in [("given", wanted), (declared.0, &up), (declared.1, &down)] {
                let mut found = times(&found, name);
                if span[1] < span[0] {
                    found.reverse();
                }
                assert_eq!(found.len(), wanted.len(), "{direction:?} {span:?} {name}");
                found
                    .iter()
                    .zip(wanted)
                    .for_each(|(time, wanted)| assert!((time - wanted).abs() < 1e-9, "{name}"));
            }
        }
    }
}
