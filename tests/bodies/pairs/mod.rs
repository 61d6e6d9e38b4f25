//! Pairs of systems: declared with bodies, and by hand with textbook energies and constraints. Both
//! must have the same motion, need the same forces and cost the same.

mod carried;
mod closed;
mod open;

use lagrange::system::{OdeSystem, StateVector};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};
use lagrange_core::program::{Labels, OperationCounts, lower, optimise};

/// Number of random states.
const STATES: usize = 20;
/// Largest difference of accelerations and multipliers, relative to the largest.
const TOLERANCE: f64 = 1e-13;

/// Compiles both declarations of a pair, whose texts are also derived at run time.
macro_rules! pair {
    ($name:ident, bodies { $($bodies:tt)* } by_hand { $($by_hand:tt)* }) => {
        mod $name {
            use crate::pairs;

            lagrange::system! { #[derive(Debug)] struct Bodies; $($bodies)* }
            lagrange::system! { #[derive(Debug)] struct ByHand; $($by_hand)* }
            const BODIES: &str = stringify!($($bodies)*);
            const BY_HAND: &str = stringify!($($by_hand)*);

            #[test]
            fn both_move_the_same_way() {
                pairs::assert_same_motion(&Bodies::default(), &ByHand::default());
            }

            #[test]
            fn both_need_the_same_forces_of_constraints() {
                pairs::assert_same_multipliers(BODIES, BY_HAND);
            }

            #[test]
            fn both_cost_the_same() {
                pairs::assert_same_cost(BODIES, BY_HAND);
            }

            #[test]
            fn plain_statements_mean_the_same() {
                pairs::assert_plain(BODIES);
            }
        }
    };
}
pub(crate) use pair;

/// Numbers from −1 to 1 by a linear congruential generator (Knuth, *The Art of Computer
/// Programming*, vol. 2, §3.3.4).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random(seed)
    }

    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn fill(&mut self, values: &mut [f64]) {
        values.iter_mut().for_each(|value| *value = self.next());
    }
}

fn assert_same_motion<A, B>(bodies: &A, by_hand: &B)
where
    A: OdeSystem<Scalar = f64>,
    B: OdeSystem<Scalar = f64, State = A::State>,
{
    let mut random = Random::new(1);
    for _ in 0..STATES {
        let mut state = A::State::ZERO;
        random.fill(state.as_mut());
        let time = random.next();
        let [found, expected] = [bodies.rhs(time, &state), by_hand.rhs(time, &state)];
        assert_near(found.as_ref(), expected.as_ref(), &format!("{state:?}"));
    }
}

fn assert_same_multipliers(bodies: &str, by_hand: &str) {
    let [bodies, by_hand] = [bodies, by_hand].map(|text| NumericSystem::new(&derived(text)));
    let n = bodies.degrees_of_freedom();
    assert_eq!(n, by_hand.degrees_of_freedom());
    let (mut random, mut state) = (Random::new(2), vec![0.0; 2 * n]);
    for _ in 0..STATES {
        random.fill(&mut state);
        let (q, v) = state.split_at(n);
        let [found, expected] = [&bodies, &by_hand].map(|system| system.multipliers(0.0, q, v));
        assert_near(&found, &expected, &format!("{state:?}"));
    }
}

/// Asserts that costs agree within 2 %, in total and in the slow operations, which are sines and
/// roots.
fn assert_same_cost(bodies: &str, by_hand: &str) {
    let [bodies, by_hand] = [bodies, by_hand].map(|text| counts(&derived(text)));
    let text = format!("{bodies}, by hand {by_hand}");
    let slow = |counts: OperationCounts| [counts.square_roots, counts.functions, counts.sin_cos];
    assert_eq!(slow(bodies), slow(by_hand), "{text}");
    assert!(bodies.total().abs_diff(by_hand.total()) * 50 <= by_hand.total(), "{text}");
}

/// Asserts that the expanded plain statements can be read again, and give the same operations.
fn assert_plain(bodies: &str) {
    let plain = parse(bodies).unwrap_or_else(|report| panic!("{report}")).statements();
    let words = ["body", "gravity", "line", "spring", "damper", "pin", "slide", "roll"];
    let is_plain = |line: &str| words.iter().all(|word| !line.trim_start().starts_with(&format!("{word} ")));
    assert!(plain.lines().all(is_plain), "{plain}");
    let [found, expected] = [plain.as_str(), bodies].map(|text| counts(&derived(text)));
    assert_eq!(found, expected, "{plain}");
}

fn derived(text: &str) -> Derived {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    derived.unwrap_or_else(|report| panic!("{report}"))
}

/// Counts the operations of the method `acceleration`.
fn counts(Derived { model, equations, .. }: &Derived) -> OperationCounts {
    let mut labels = Labels::default();
    equations.labels.iter().for_each(|(expression, name)| labels.insert(*expression, name.as_str()));
    let program = lower(&model.graph, &equations.accelerations, &labels);
    OperationCounts::of(&optimise(&program, model.accuracy))
}

#[track_caller]
fn assert_near(found: &[f64], expected: &[f64], at: &str) {
    assert_all_within(TOLERANCE, found, expected, at);
}

/// Asserts that all numbers have their expected values, relative to the largest.
#[track_caller]
pub(crate) fn assert_all_within(tolerance: f64, found: &[f64], expected: &[f64], at: &str) {
    let largest = expected.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance * largest, "{found:?} is not {expected:?} at {at}");
    }
}
