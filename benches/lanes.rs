//! Right-hand sides of motions in lanes: nanoseconds per motion, as rows of a Markdown table.
//!
//! Every row is a number type and a number of lanes. Columns are the target of the build, with
//! products fused where it has that. Then follow levels of instructions that are detected at run
//! time, as in ensembles. 64 states are evaluated one after the other, each group of lanes
//! separately, all cells in alternation; times are minima. Another column is the time of an
//! ensemble relative to a handwritten loop over lanes, as the median of ratios.

use std::hint::black_box;
use std::time::Instant;

use lagrange::ensemble::SharedSystem;
use lagrange::integrate::{LanesMethod, LanesStepper, RungeKutta4};
use lagrange::scalar::Lanes;
use lagrange::system::{Domain, Equations, LanesSystem, OdeSystem, SideBySide, StateVector};
use lagrange::{Ensembles, Number, Scalar};
use pulp::NullaryFnOnce;

lagrange::system! {
    #[derive(Clone)]
    pub struct CartPole;

    param m_cart = 1.0, m = 0.1, l = 0.5, g = 9.81;
    coord x, theta;

    let (x_bob, y_bob) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * m_cart * dot(x)^2 + 1/2 * m * (dot(x_bob)^2 + dot(y_bob)^2);
    potential = m * g * y_bob;
    emit { lanes }
}

/// Declares chains of pendulums in absolute angles, each with its number of links.
macro_rules! chains {
    ($($name:ident $links:literal;)*) => {
        $(lagrange::system! {
            #[derive(Clone)]
            pub struct $name;

            const n = $links;
            param m[n] = 1.0, l[n] = 1.0, g = 9.81;
            coord q[n];
            for i in 0..n {
                let p[i] = if i > 0 { p[i-1] + l[i] * (sin(q[i]), -cos(q[i])) } else { l[i] * (sin(q[i]), -cos(q[i])) };
                kinetic = kinetic_energy(m[i], dot(p[i]));
                potential = gravitational_energy(m[i], g, p[i].y);
            }
            emit { lanes, no momenta, no mass_matrix, no forcing, no inverse_dynamics }
        })*
    };
}

chains! {
    Chain2 2;
    Chain5 5;
    Chain10 10;
    Chain30 30;
}

/// Number of states evaluated one after the other.
const STATES: usize = 64;
const ROUNDS: usize = 60;
/// Approximate nanoseconds of a cell per round.
const ROUND: f64 = 2e5;
/// True if the build has fused products.
const FUSED: bool = cfg!(target_feature = "fma");

/// The level of instructions.
#[derive(Clone, Copy)]
enum Level {
    Build,
    Avx2,
    Avx512,
}

/// Evaluates all states several times.
struct Evaluations<'a, S: SideBySide, E: Equations<S>> {
    equations: &'a E,
    states: &'a [E::State],
    rates: &'a mut E::State,
    times: usize,
}

impl<S: SideBySide, E: Equations<S>> NullaryFnOnce for Evaluations<'_, S, E> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for _ in 0..self.times {
            for state in black_box(self.states) {
                *self.rates = self.equations.rhs(S::ZERO, state);
                black_box(&mut *self.rates);
            }
        }
    }
}

impl Level {
    /// True if the processor has these instructions.
    fn run(self, task: impl NullaryFnOnce<Output = ()>) -> bool {
        match self {
            Level::Build => task.call(),
            #[cfg(target_arch = "x86_64")]
            Level::Avx2 => {
                let Some(level) = pulp::x86::V3::try_new() else { return false };
                level.vectorize(task);
            }
            #[cfg(target_arch = "x86_64")]
            Level::Avx512 => {
                let Some(level) = pulp::x86::V4::try_new() else { return false };
                level.vectorize(task);
            }
            #[cfg(not(target_arch = "x86_64"))]
            _ => return false,
        }
        true
    }
}

/// A measurement taken in every round.
type Cell = Box<dyn FnMut() -> f64>;

/// Returns nanoseconds per motion of a system in numbers of the type S.
fn cell<S, M>(level: Level) -> Cell
where
    S: SideBySide,
    S::Element: Scalar,
    M: LanesSystem<Lanes<S>: Equations<S, State: 'static> + 'static>,
    M: OdeSystem<Scalar = f64> + Default,
{
    let equations = black_box(M::default().lanes(S::from_f64));
    let states: Vec<_> = (0..STATES / S::LANES).map(state::<S, M>).collect();
    let mut rates = states[0];
    let mut times = 1;
    Box::new(move || {
        let task = Evaluations { equations: &equations, states: &states, rates: &mut rates, times };
        let began = Instant::now();
        if !level.run(task) {
            return f64::NAN;
        }
        let taken = began.elapsed().as_nanos() as f64;
        let each = taken / times as f64;
        times = (ROUND / each).ceil() as usize;
        each / STATES as f64
    })
}

/// Returns a state whose lanes differ.
fn state<S, M>(group: usize) -> <M::Lanes<S> as Equations<S>>::State
where
    S: SideBySide,
    S::Element: Scalar,
    M: LanesSystem,
{
    let mut state = <M::Lanes<S> as Equations<S>>::State::ZERO;
    for (component, lanes) in state.as_mut().iter_mut().enumerate() {
        for lane in 0..S::LANES {
            let value = 0.1 + 0.37 * component as f64 + 0.01 * group as f64 + 0.001 * lane as f64;
            lanes.set_lane(lane, S::Element::from_f64(value));
        }
    }
    state
}

fn measure(system: &str, rows: Vec<(&str, [Cell; 3])>) {
    let (names, cells): (Vec<_>, Vec<_>) = rows.into_iter().unzip();
    let mut cells: Vec<_> = cells.into_iter().flatten().map(|cell| (cell, f64::INFINITY)).collect();
    for _ in 0..ROUNDS {
        for (cell, least) in &mut cells {
            *least = least.min(cell());
        }
    }
    for (name, least) in names.into_iter().zip(cells.chunks(3)) {
        println!("| {system} | {name} | {:.2} | {:.2} | {:.2} |", least[0].1, least[1].1, least[2].1);
    }
}

/// Measures a system with some types of numbers and numbers of lanes, each at all levels.
macro_rules! measure {
    ($system:ident, $name:literal, $($number:ident x $lanes:literal),*) => {
        let rows = vec![$((concat!(stringify!($number), " × ", $lanes), [
            cell::<Lanes<$number, $lanes, FUSED>, $system>(Level::Build),
            cell::<Lanes<$number, $lanes, true>, $system>(Level::Avx2),
            cell::<Lanes<$number, $lanes, true>, $system>(Level::Avx512),
        ])),*];
        measure($name, rows);
    };
}

const MOTIONS: usize = 1024;
const UNTIL: f64 = 10.0;
const METHOD: RungeKutta4<f64> = RungeKutta4 { step: 0.01 };

fn start(motion: usize) -> [f64; 4] {
    [2.0 + 1e-3 * motion as f64, 1.0, 0.0, 0.0]
}

/// Ends of all motions, eight at a time, by a loop without the other work of an ensemble.
struct Loop<'a, M>(&'a M, &'a mut f64);

impl<M> NullaryFnOnce for Loop<'_, M>
where
    M: LanesSystem<
        Lanes<Lanes<f64, 8, true>>: Equations<Lanes<f64, 8, true>, State = [Lanes<f64, 8, true>; 4]>,
    >,
    M: OdeSystem<Scalar = f64>,
{
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Loop(system, sum) = self;
        let equations = system.lanes(|parameter| Lanes([parameter; 8]));
        for first in (0..MOTIONS).step_by(8) {
            let starts: [_; 8] = std::array::from_fn(|lane| start(first + lane));
            let state = std::array::from_fn(|component| Lanes(starts.map(|start| start[component])));
            let mut motions = METHOD.start(&equations, &state, [0.0, UNTIL], &Domain::EVERYWHERE);
            *sum += run_to_end(&mut motions, &equations);
        }
    }
}

/// Returns the sum of the ends of motions in equal steps.
#[inline(always)]
fn run_to_end<S, E, L>(motions: &mut L, equations: &E) -> f64
where
    S: SideBySide<Element = f64>,
    E: Equations<S, State = [S; 4]>,
    L: LanesStepper<S, E>,
{
    let mut workspace = L::workspace();
    while motions.time().lane(0) < UNTIL {
        motions.step(equations, &mut workspace);
    }
    (0..S::LANES).map(|lane| motions.state()[0].lane(lane)).sum()
}

/// Prints microseconds per motion of that loop and of an ensemble on one thread, in alternation.
fn beside_builder<M>(name: &str)
where
    M: LanesSystem<
        Lanes<Lanes<f64, 8, true>>: Equations<Lanes<f64, 8, true>, State = [Lanes<f64, 8, true>; 4]>,
    >,
    M: SharedSystem<Scalar = f64, State = [f64; 4]> + Default,
{
    let system = black_box(M::default());
    let time = |compute: &mut dyn FnMut() -> f64| {
        let began = Instant::now();
        let sum = compute();
        (began.elapsed().as_secs_f64() * 1e6 / MOTIONS as f64, sum)
    };
    let mut by_hand = || {
        let mut sum = 0.0;
        let is_run = [Level::Avx512, Level::Avx2].into_iter().any(|level| level.run(Loop(&system, &mut sum)));
        assert!(is_run, "the processor has neither AVX-512 nor AVX2");
        sum
    };
    let mut by_ensemble = || {
        let motions = system.ensemble(MOTIONS).start(|motion, _| start(motion)).until(UNTIL);
        let ends = motions.method(METHOD).threads(1).run().expect("runs");
        let groups = (0..MOTIONS).step_by(8);
        let sum = |first| (first..first + 8).map(|motion| ends.state(motion).expect("ended")[0]).sum::<f64>();
        groups.map(sum).sum()
    };
    let rounds: Vec<_> = (0..ROUNDS).map(|_| (time(&mut by_hand), time(&mut by_ensemble))).collect();
    assert!(rounds.iter().all(|((_, one), (_, other))| one == other), "other motions");
    let least = |times: &dyn Fn(usize) -> f64| (0..ROUNDS).map(times).fold(f64::INFINITY, f64::min);
    let (one, other) = (least(&|round| rounds[round].0.0), least(&|round| rounds[round].1.0));
    let mut ratios: Vec<_> = rounds.iter().map(|(one, other)| other.0 / one.0).collect();
    ratios.sort_by(f64::total_cmp);
    println!("| {name} | {one:.2} | {other:.2} | {:.3} |", ratios[ROUNDS / 2]);
}

fn main() {
    println!("| system | numbers | build | AVX2 | AVX-512 |\n|---|---|---|---|---|");
    measure!(CartPole, "cart-pole", f64 x 4, f64 x 8, f64 x 16, f32 x 8, f32 x 16);
    measure!(Chain2, "chain of 2", f64 x 4, f64 x 8, f64 x 16, f32 x 8, f32 x 16);
    measure!(Chain5, "chain of 5", f64 x 4, f64 x 8, f64 x 16, f32 x 8, f32 x 16);
    measure!(Chain10, "chain of 10", f64 x 4, f64 x 8, f64 x 16, f32 x 8, f32 x 16);
    measure!(Chain30, "chain of 30", f64 x 8, f32 x 16);
    println!(
        "\n| {MOTIONS} motions of {UNTIL} s | a loop of lanes, µs | ensemble, µs | ratio |\n|---|---|---|---|"
    );
    beside_builder::<CartPole>("cart-pole");
    beside_builder::<Chain2>("chain of 2");
}
