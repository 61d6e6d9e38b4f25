//! Equations of random declarations against a reference that knows only energies.
//!
//! A declaration is a tree (`tree`). The language reads its printed text (`text`), and the
//! reference evaluates the tree itself. The reference computes power series in many digits along
//! motions (`world`, `jet`), and coefficients of these give Lagrange's equations (`reference`).
//!
//! The declarations (`generate`) contain machines and lattices of points, bodies in the plane and
//! in space, arrays and first-order states. They also contain algebraic unknowns, tables, units,
//! quaternions, functions, constraints, loads, losses, kinks and jumps. They are derived at all
//! levels of accuracy and by all strategies. Each is judged at two states: a random one, and one of
//! zeros, equal numbers and quarter turns.
//!
//! Accelerations, multipliers, rates of states, mass matrix, forcing, momenta, energies, inverse
//! dynamics and outputs of the interpreter are compared, as described in `compare`.
//!
//! Case n is the same in every run. `LAGRANGE_SYSTEMS` selects cases by a count or a range:
//!
//! ```sh
//! LAGRANGE_SYSTEMS=10000 cargo test --release -p lagrange-core --test systems -- --nocapture
//! LAGRANGE_SYSTEMS=4711..4712 cargo test -p lagrange-core --test systems -- --nocapture
//! ```
//!
//! A failing case is shrunk as far as possible and printed with its number.

mod compare;
mod compiled;
#[path = "../common/digits.rs"]
mod digits;
mod elementary;
mod faults;
mod generate;
mod jet;
mod layout;
#[path = "../common/linear.rs"]
mod linear;
#[path = "../common/numbered.rs"]
mod numbered;
mod orientations;
mod parts;
#[path = "../common/project.rs"]
mod project;
#[path = "../common/random.rs"]
#[allow(dead_code, reason = "other tests draw otherwise")]
mod random;
mod reference;
mod scene;
mod shrink;
mod splines;
mod text;
mod tree;
mod unknowns;
mod world;

use std::collections::BTreeMap;

use compare::{Verdict, derived, verdict};
use generate::{Case, case};
use numbered::numbered;

/// Number of cases by default.
const USUAL: usize = if cfg!(debug_assertions) { 40 } else { 1_000 };
/// One in this many states may remain undecided.
const UNDECIDED: usize = 4;

/// The outcome of many cases.
#[derive(Default)]
struct Tally {
    counts: BTreeMap<&'static str, usize>,
    /// Number of states by their largest error, in powers of two of the expected error.
    errors: [usize; 8],
    failures: Vec<String>,
}

impl Tally {
    fn take(&mut self, number: usize) {
        let case = case(number as u64);
        let system = match derived(&case.declaration, case.choice) {
            Ok(system) => system,
            Err(report) => {
                return self.failures.push(format!("case {number}: {report}\n{}", case.declaration));
            }
        };
        for (index, state) in case.states.iter().enumerate() {
            let verdict = verdict(&system, &case.declaration, state);
            let what = match &verdict {
                Verdict::Agrees(error) => {
                    let power = error.max(1.0).log2().ceil() as usize;
                    self.errors[power.min(self.errors.len() - 1)] += 1;
                    "agree"
                }
                Verdict::Undecided(why) => why,
                Verdict::Differs(what) => {
                    let failure = failure(number, &case, index, what);
                    println!("{failure}");
                    self.failures.push(failure);
                    "differ"
                }
            };
            *self.counts.entry(what).or_default() += 1;
        }
    }

    fn print(&self) {
        println!("states: {:?}", self.counts);
        println!("largest errors in units of what is expected, up to 1, 2, 4, …: {:?}", self.errors);
    }
}

/// Returns a message about a wrong state, with the smallest declaration that fails.
fn failure(number: usize, case: &Case, index: usize, what: &str) -> String {
    let small = shrink::smallest(case, index);
    let (state, _) = &small.states[0];
    format!(
        "case {number}, state {index}, {:?}: {what}\nshrunk, at {state:?}:\n{}",
        case.choice, small.declaration
    )
}

#[test]
fn systems_agree_with_their_energies() {
    let cases = numbered("LAGRANGE_SYSTEMS", USUAL);
    let mut tally = Tally::default();
    cases.clone().for_each(|number| tally.take(number));
    tally.print();
    let failures = &tally.failures;
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n\n"));
    let agree = tally.counts.get("agree").copied().unwrap_or_default();
    let states = 2 * cases.len();
    assert!(
        cases.len() < 50 || agree * UNDECIDED >= states * (UNDECIDED - 1),
        "{agree} of {states} states agree"
    );
}

/// Statements and functions that declarations must contain, so that a sweep covers them.
const DRAWN: [&str; 57] = [
    "(standard)",
    "(fast)",
    "(strict)",
    "param ",
    "const ",
    "input ",
    "coord ",
    "state ",
    "state z",
    "]) = ",
    "gibbs = ",
    "% 2 == 0 && i >= 0",
    "\ndot(",
    "quaternion ",
    "let ",
    "(w) = ",
    "table ",
    "linear",
    "monotone",
    "natural",
    "clamp",
    "extend",
    "solve ",
    "kinetic = ",
    "lagrangian = ",
    "potential = ",
    "dissipation = ",
    "force ",
    " along ",
    " at ",
    "torque ",
    "constraint ",
    "output ",
    "for i in",
    "sum(",
    "%",
    "body ",
    "centroid",
    "angles",
    "spring ",
    "damper ",
    "pin ",
    "revolute",
    "prismatic",
    "screw",
    "universal",
    "planar",
    "ball ",
    "free ",
    "turned",
    "abs(",
    "sign(",
    "min(",
    "max(",
    "if ",
    ": kg",
    "mm",
];

#[test]
fn everything_is_drawn() {
    let texts = (0..300).map(|number| case(number).declaration.to_string()).collect::<Vec<_>>();
    let count = |word: &str| texts.iter().filter(|text| text.contains(word)).count();
    let rare = DRAWN.into_iter().filter(|word| count(word) < 3).collect::<Vec<_>>();
    println!("{:?}", DRAWN.map(|word| (word, count(word))));
    assert!(rare.is_empty(), "{rare:?} are hardly ever drawn");
}
