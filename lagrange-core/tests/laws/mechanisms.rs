//! Plane mechanisms of pinned bars, declared with the place and angle of every bar, and by hand in
//! the angles alone.
//!
//! In the angles the bars of a tree need no constraints. With e(φ) = (cos φ, sin φ), the centre of
//! bar i is Σⱼ cᵢⱼ e(φⱼ) beside a fixed point. Here cᵢⱼ is the length of a bar that carries it, and
//! half of its own length. So M = Σᵢ mᵢ cᵢⱼ cᵢₖ cos(φⱼ − φₖ) beside the moments of inertia m l²/12.
//! A loop is closed by Σⱼ dⱼ e(φⱼ) = constant.

use std::fmt::Write;

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::pipeline::{NumericSystem, parse};

const GRAVITY: f64 = 9.81;

/// The place to which the beginning or the end of a bar is pinned.
#[derive(Clone, Copy, Debug)]
enum Place {
    Ground(f64),
    /// The end of the bar with this index.
    End(usize),
}

struct Bar {
    mass: f64,
    length: f64,
    begins: Place,
}

/// Bars and loop closures, which are ends of bars pinned to other places.
pub(crate) struct Mechanism {
    bars: Vec<Bar>,
    loops: Vec<(usize, Place)>,
    /// The angles around which states are drawn, and the width of their distribution.
    posture: Vec<f64>,
    spread: f64,
}

/// Numbers from 0 to 1, by a linear congruential generator (Knuth, *The Art of Computer
/// Programming*, vol. 2, §3.3.4, table 1, line 26).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 31)
    }
}

impl Mechanism {
    /// Returns bars of different masses and lengths, each of which begins at the place that
    /// `begins` gives.
    fn tree(n: usize, mut begins: impl FnMut(usize) -> Place) -> Mechanism {
        let mut numbers = Numbers(7);
        let mut number = || (64.0 * (0.5 + numbers.next())).round() / 64.0;
        let bar = |i| Bar { mass: number(), length: number(), begins: begins(i) };
        Mechanism { bars: (0..n).map(bar).collect(), loops: Vec::new(), posture: vec![0.0; n], spread: 3.0 }
    }

    /// Returns a chain, in which each bar hangs from the one before it.
    pub(crate) fn chain(n: usize) -> Mechanism {
        Mechanism::tree(n, |i| if i == 0 { Place::Ground(0.0) } else { Place::End(i - 1) })
    }

    /// Returns a tree in which each bar hangs from the ground or a random earlier bar.
    pub(crate) fn random_tree(n: usize) -> Mechanism {
        let mut numbers = Numbers(1);
        Mechanism::tree(n, |i| match (numbers.next() * (i + 1) as f64) as usize {
            0 => Place::Ground(0.0),
            parent => Place::End(parent - 1),
        })
    }

    /// Returns a row of cranks on the ground, each coupled with the next: n bars, every second one
    /// a crank, and one more crank. Cranks are upright and couplers are level, since errors grow
    /// from cell to cell where they are nearly parallel.
    pub(crate) fn four_bars(n: usize) -> Mechanism {
        let is_crank = |i: usize| i.is_multiple_of(2) || i == n;
        let begins = |i| if is_crank(i) { Place::Ground(i as f64) } else { Place::End(i - 1) };
        let couplers = (0..n).filter(|&i| !is_crank(i));
        Mechanism {
            loops: couplers.map(|i| (i, Place::End(i + 1))).collect(),
            posture: (0..=n).map(|i| if is_crank(i) { 1.5 } else { 0.0 }).collect(),
            spread: 0.3,
            ..Mechanism::tree(n + 1, begins)
        }
    }

    /// Returns a chain whose end is pinned to the ground, too.
    fn ring(n: usize) -> Mechanism {
        Mechanism { loops: vec![(n - 1, Place::Ground(1.0))], ..Mechanism::chain(n) }
    }

    /// Returns the declaration, with the statements for the bars in the given order.
    pub(crate) fn declaration(&self, level: &str, order: impl Fn(usize) -> usize) -> String {
        let (mut bodies, mut pins) = (String::new(), Vec::new());
        let end = |place: Place| match place {
            Place::Ground(x) => format!("({x}, 0)"),
            Place::End(i) => format!("b{i}.point(l{i}/2, 0)"),
        };
        for i in (0..self.bars.len()).map(order) {
            let Bar { mass, length, begins } = self.bars[i];
            write!(
                bodies,
                "param m{i} = {mass}, l{i} = {length}; coord x{i}, y{i}, phi{i};
                body b{i} {{ mass: m{i}; center: (x{i}, y{i}); angle: phi{i}; shape: slender_rod(l{i}); }}\n"
            )
            .expect("a string takes it");
            pins.push(format!("pin p{i} = {} to b{i}.point(-l{i}/2, 0);\n", end(begins)));
        }
        let closing = self.loops.iter().enumerate();
        pins.extend(
            closing.map(|(k, &(i, to))| format!("pin c{k} = {} to {};\n", end(Place::End(i)), end(to))),
        );
        format!("#[accuracy({level})] struct M; gravity = (0, -{GRAVITY});\n{bodies}{}", pins.concat())
    }

    /// Returns the coefficients dⱼ such that Σⱼ dⱼ e(φⱼ) is the end of a bar, beside a fixed point.
    /// With half of the last length it is the centre.
    fn slopes(&self, bar: usize, last: f64) -> Vec<f64> {
        let mut slopes = vec![0.0; self.bars.len()];
        let (mut next, mut share) = (Place::End(bar), last);
        while let Place::End(j) = next {
            slopes[j] = share * self.bars[j].length;
            (next, share) = (self.bars[j].begins, 1.0);
        }
        slopes
    }

    fn origin(&self, bar: usize) -> f64 {
        let mut next = self.bars[bar].begins;
        loop {
            match next {
                Place::Ground(x) => return x,
                Place::End(j) => next = self.bars[j].begins,
            }
        }
    }

    fn end_slopes(&self, place: Place) -> Vec<f64> {
        match place {
            Place::Ground(_) => vec![0.0; self.bars.len()],
            Place::End(i) => self.slopes(i, 1.0),
        }
    }

    /// Returns the accelerations of the angles: M α + Jᵀμ = f under J α = d.
    fn angular_accelerations(&self, angles: &[f64], rates: &[f64]) -> Vec<f64> {
        let (n, m) = (self.bars.len(), 2 * self.loops.len());
        let mut rows = vec![vec![0.0; n + m + 1]; n + m];
        for (i, bar) in self.bars.iter().enumerate() {
            rows[i][i] += bar.mass * bar.length * bar.length / 12.0;
            let slopes = self.slopes(i, 0.5);
            let moved = (0..n).filter(|&j| slopes[j] != 0.0).collect::<Vec<_>>();
            for &j in &moved {
                let weight = bar.mass * slopes[j];
                rows[j][n + m] -= weight * GRAVITY * angles[j].cos();
                for &k in &moved {
                    let (sin, cos) = (angles[j] - angles[k]).sin_cos();
                    rows[j][k] += weight * slopes[k] * cos;
                    rows[j][n + m] -= weight * slopes[k] * sin * rates[k] * rates[k];
                }
            }
        }
        for (l, &(bar, to)) in self.loops.iter().enumerate() {
            let (here, there) = (self.slopes(bar, 1.0), self.end_slopes(to));
            for j in 0..n {
                let (slope, (sin, cos)) = (here[j] - there[j], angles[j].sin_cos());
                for (row, along, across) in [(n + 2 * l, -sin, cos), (n + 2 * l + 1, cos, sin)] {
                    rows[row][j] = slope * along;
                    rows[j][row] = slope * along;
                    rows[row][n + m] += slope * across * rates[j] * rates[j];
                }
            }
        }
        let mut solution = solved(rows);
        solution.truncate(n);
        solution
    }

    /// Returns the state and the accelerations of the declared coordinates, bar by bar.
    fn motion(&self, angles: &[f64], rates: &[f64]) -> [Vec<f64>; 3] {
        let accelerations = self.angular_accelerations(angles, rates);
        let mut motion = [Vec::new(), Vec::new(), Vec::new()];
        for i in 0..self.bars.len() {
            let (mut place, mut velocity, mut acceleration) = ([self.origin(i), 0.0], [0.0; 2], [0.0; 2]);
            for (j, slope) in self.slopes(i, 0.5).into_iter().enumerate() {
                let (sin, cos) = angles[j].sin_cos();
                for (k, (along, across)) in [(cos, -sin), (sin, cos)].into_iter().enumerate() {
                    place[k] += slope * along;
                    velocity[k] += slope * across * rates[j];
                    acceleration[k] += slope * (across * accelerations[j] - along * rates[j] * rates[j]);
                }
            }
            motion[0].extend([place[0], place[1], angles[i]]);
            motion[1].extend([velocity[0], velocity[1], rates[i]]);
            motion[2].extend([acceleration[0], acceleration[1], accelerations[i]]);
        }
        motion
    }

    /// Asserts that interpreted accelerations agree with those by hand in some states.
    fn assert_moves_as_by_hand(
        &self,
        what: &str,
        states: u64,
        levels: &[&str],
        strategies: &[StrategyChoice],
    ) {
        for (level, &strategy) in
            levels.iter().flat_map(|level| strategies.iter().map(move |strategy| (level, strategy)))
        {
            let derived = parse(&self.declaration(level, |i| i)).and_then(|system| system.derive(strategy));
            let system = NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{what}: {report}")));
            for seed in 0..states {
                let mut numbers = Numbers(seed + 11);
                let mut near = |&middle: &f64, spread: f64| middle + spread * (2.0 * numbers.next() - 1.0);
                let angles = self.posture.iter().map(|angle| near(angle, self.spread)).collect::<Vec<_>>();
                let rates = angles.iter().map(|_| near(&0.0, 1.0)).collect::<Vec<_>>();
                let [q, v, expected] = self.motion(&angles, &rates);
                let found = system.acceleration(0.0, &q, &v);
                let largest = expected.iter().fold(1.0_f64, |largest, value| largest.max(value.abs()));
                let error = found.iter().zip(&expected).fold(0.0_f64, |e, (a, b)| e.max((a - b).abs()));
                assert!(
                    error <= 1e-11 * largest,
                    "{what}, {level}, {strategy:?}, seed {seed}: {error} beside {largest}"
                );
            }
        }
    }
}

/// Solves linear equations, with the right-hand side in the last column, by elimination with
/// partial pivoting.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs())).unwrap_or(i);
        rows.swap(i, pivot);
        let (above, below) = rows.split_at_mut(i + 1);
        let top = &above[i];
        for row in below.iter_mut().filter(|row| row[i] != 0.0) {
            let factor = row[i] / top[i];
            row[i..].iter_mut().zip(&top[i..]).for_each(|(entry, over)| *entry -= factor * over);
        }
    }
    for i in (0..n).rev() {
        let known = (i + 1..n).map(|j| rows[i][j] * rows[j][n]).sum::<f64>();
        rows[i][n] = (rows[i][n] - known) / rows[i][i];
    }
    rows.into_iter().map(|row| row[n]).collect()
}

const LEVELS: [&str; 3] = ["standard", "fast", "strict"];
const STRATEGIES: [StrategyChoice; 3] = [
    StrategyChoice::Cheapest,
    StrategyChoice::Always(Strategy::MassMatrix),
    StrategyChoice::Always(Strategy::ArticulatedBody),
];

#[test]
fn pinned_bars_move_as_angles_do() {
    for n in [1, 2, 3, 8] {
        for (what, mechanism) in [
            ("chain", Mechanism::chain(n)),
            ("tree", Mechanism::random_tree(n)),
            ("four bars", Mechanism::four_bars(2 * n)),
            ("ring", Mechanism::ring(n + 2)),
        ] {
            mechanism.assert_moves_as_by_hand(&format!("{what} {n}"), 4, &LEVELS, &STRATEGIES);
        }
    }
}

#[test]
fn a_hundred_pinned_bars_move_as_angles_do() {
    for (what, mechanism) in [
        ("chain", Mechanism::chain(100)),
        ("tree", Mechanism::random_tree(100)),
        ("four bars", Mechanism::four_bars(100)),
    ] {
        mechanism.assert_moves_as_by_hand(what, 1, &LEVELS[..1], &[StrategyChoice::Cheapest]);
        mechanism.assert_moves_as_by_hand(what, 1, &LEVELS[2..], &[StrategyChoice::Cheapest]);
    }
}
