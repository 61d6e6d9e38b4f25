//! Reduced types of any machine, judged by the inverse dynamics of the whole one. Frozen
//! coordinates drop out. With small coordinates the reduced machine differs by the neglected terms
//! and no more.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};
use proptest::prelude::{prop, prop_assert, prop_assume, proptest};

use crate::machines::{Machine, machines};

/// Bounds rounding in differently ordered sums.
const ROUNDED: f64 = 1e-9;
/// Step of first differences, short enough that squares such as |v| v are invisible, and the bound
/// of their error.
const SLOPE: (f64, f64) = (1e-7, 1e-5);
/// Step of second differences, and the bound of their error.
const BEND: (f64, f64) = (3e-4, 1e-4);

/// A machine beside a reduced one. Positions of reduced coordinates avoid kinks, which are at
/// hundredths.
struct Pair {
    whole: NumericSystem,
    reduced: NumericSystem,
    machine: Machine,
    is_frozen: Vec<bool>,
    is_small: Vec<bool>,
}

impl Pair {
    fn new(mut machine: Machine, frozen: u32, small: u32) -> Pair {
        machine.q.iter_mut().for_each(|q| *q += 0.003);
        // All other coordinates move, because norms of velocities are not smooth at rest.
        machine.v.iter_mut().for_each(|v| *v += 0.3_f64.copysign(*v));
        let is_in = |set: u32, i: usize| set >> i & 1 == 1;
        let is_frozen = (0..machine.q.len()).map(|i| is_in(frozen, i)).collect::<Vec<_>>();
        let is_small = (0..machine.q.len()).map(|i| is_in(small & !frozen, i)).collect::<Vec<_>>();
        let line = |(i, q): (usize, &f64)| match (is_frozen[i], is_small[i]) {
            (true, _) => format!("freeze q{} = {q:.3};", i + 1),
            (_, true) => format!("small q{} = {q:.3};", i + 1),
            _ => String::new(),
        };
        let lines = machine.q.iter().enumerate().map(line).collect::<String>();
        machine.text += &format!("reduce Reduced {{ {lines} }}");
        let derived = derived(&machine.text);
        let (whole, reduced) = (NumericSystem::new(&derived), NumericSystem::of_part(&derived.reduced[0]));
        Pair { whole, reduced, machine, is_frozen, is_small }
    }

    /// Returns the difference between the remaining generalised forces at accelerations `a`: first
    /// those on coordinates that are not small, then those on small ones. Frozen coordinates rest;
    /// deviations and their rates are multiplied by `scale`.
    fn difference(&self, a: &[f64], scale: f64) -> [Vec<f64>; 2] {
        let Machine { t, q, v, .. } = &self.machine;
        let all = 0..q.len();
        let deviation = |i: usize| if self.is_small[i] { scale * (v[i] + 0.5) } else { 0.0 };
        let moving = |list: &[f64]| {
            let entry = |i: usize| match (self.is_frozen[i], self.is_small[i]) {
                (true, _) => 0.0,
                (_, true) => scale * list[i],
                _ => list[i],
            };
            all.clone().map(entry).collect::<Vec<_>>()
        };
        let (q, v, a) = (all.clone().map(|i| q[i] + deviation(i)).collect::<Vec<_>>(), moving(v), moving(a));
        let whole = self.whole.inverse_dynamics(*t, &q, &v, &a).expect("derived by default");
        let free = |list: &[f64]| self.free(list);
        let reduced = self.reduced.inverse_dynamics(*t, &free(&q), &free(&v), &free(&a));
        let difference =
            free(&whole).into_iter().zip(reduced.expect("derived by default")).map(|(a, b)| a - b);
        let mut rows = [Vec::new(), Vec::new()];
        let is_small = all.filter(|&i| !self.is_frozen[i]).map(|i| self.is_small[i]);
        difference.zip(is_small).for_each(|(row, is_small)| rows[usize::from(is_small)].push(row));
        rows
    }

    /// Returns the entries that are not frozen.
    fn free(&self, list: &[f64]) -> Vec<f64> {
        list.iter().zip(&self.is_frozen).filter(|(_, is_frozen)| !**is_frozen).map(|(x, _)| *x).collect()
    }

    /// Returns the scale of errors: the largest force while accelerations are of order one.
    fn scale(&self) -> f64 {
        let Machine { t, q, v, .. } = &self.machine;
        let forcing = self.whole.product(Product::Forcing, *t, q, v).expect("derived by default");
        let matrix = self.whole.product(Product::MassMatrix, *t, q, v).expect("derived by default");
        forcing.iter().chain(&matrix).fold(1.0, |largest, force| largest.max(force.abs()))
    }
}

fn derived(text: &str) -> Derived {
    let system = parse(text).unwrap_or_else(|report| panic!("{report}: {text}"));
    system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}: {text}"))
}

/// Returns Σ weight · value for each row of one kind.
fn weighted(values: &[[Vec<f64>; 2]; 5], rows: usize, weights: [f64; 5]) -> Vec<f64> {
    let row = |i: usize| values.iter().zip(weights).map(|(value, weight)| weight * value[rows][i]).sum();
    (0..values[0][rows].len()).map(row).collect()
}

fn largest(list: &[f64]) -> f64 {
    list.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

proptest! {
    #![proptest_config(crate::one_in(10))]

    #[test]
    fn frozen_coordinates_drop_out(machine in machines(), frozen in 1..31_u32, a in prop::collection::vec(-2.0..2.0, 5)) {
        let n = machine.q.len();
        let frozen = frozen & ((1 << n) - 1);
        prop_assume!(frozen != 0 && (frozen.count_ones() as usize) < n);
        let pair = Pair::new(machine, frozen, 0);
        let [free, _] = pair.difference(&a, 0.0);
        prop_assert!(largest(&free) <= ROUNDED * pair.scale(), "{free:?}: {}", pair.machine.text);
    }

    /// Deviations and their rates are of order ε. Then forces have errors of order ε² on small
    /// coordinates, and ε³ on the others.
    #[test]
    fn small_coordinates_are_linear(
        machine in machines(),
        frozen in 0..31_u32,
        small in 1..32_u32,
        a in prop::collection::vec(-2.0..2.0, 5),
    ) {
        let n = machine.q.len();
        let (frozen, small) = (frozen & !small & ((1 << n) - 1), small & ((1 << n) - 1));
        prop_assume!(small != 0);
        let pair = Pair::new(machine, frozen, small);
        let [value, slope, bend] = [(0.0, 1.0), SLOPE, BEND].map(|(step, _)| {
            [-2.0, -1.0, 0.0, 1.0, 2.0].map(|steps| pair.difference(&a, steps * step))
        });
        let scale = pair.scale();
        for rows in [0, 1] {
            let value = weighted(&value, rows, [0.0, 0.0, 1.0, 0.0, 0.0]);
            prop_assert!(largest(&value) <= ROUNDED * scale, "{value:?}: {}", pair.machine.text);
            let slope = weighted(&slope, rows, [1.0, -8.0, 0.0, 8.0, -1.0].map(|w| w / (12.0 * SLOPE.0)));
            prop_assert!(largest(&slope) <= SLOPE.1 * scale, "{slope:?}: {}", pair.machine.text);
        }
        let bend = weighted(&bend, 0, [-1.0, 16.0, -30.0, 16.0, -1.0].map(|w| w / (12.0 * BEND.0 * BEND.0)));
        prop_assert!(largest(&bend) <= BEND.1 * scale, "{bend:?}: {}", pair.machine.text);
    }
}
