//! Emitted code for bodies in space against handwritten recursive algorithms, in alternation: rows
//! of a Markdown table.
//!
//! Robots are declarations without parameters, so emitted code knows every number. The handwritten
//! side has the algorithms of dynamics libraries for any chain of revolute joints (`rigid_bodies`),
//! with these numbers at run time. Accelerations are without torques, and compared at two levels of
//! accuracy. At `standard`, both sides call the platform for sines and cosines; at `fast`, both
//! have the same inline function. `tests/handwritten` shows that both sides compute the same.
//!
//! Times are minima, ratios medians (`timing.rs`). `cargo xtask performance spatial` runs this for
//! two targets and writes docs/performance.md.

#[path = "../handwritten.rs"]
mod handwritten;
mod rigid_bodies;
mod robots;
#[path = "../timing.rs"]
mod timing;

use std::array::from_fn;
use std::hint::black_box;

use handwritten::{Inline, Platform};
use rigid_bodies::Chain;
use timing::{Times, in_turns};

const GRAVITY: f64 = 9.81;

fn report(level: &str, robot: &str, what: &str, times: &Times) {
    println!("| {level:<8} | {robot:<19} | {what:<16} | {times} |");
}

/// Returns the first row of a matrix all of whose entries have been computed.
#[inline(always)]
fn first_row<const N: usize>(matrix: &[[f64; N]; N]) -> [f64; N] {
    black_box(matrix)[0]
}

/// Returns the wanted accelerations.
fn wanted<const N: usize>() -> [f64; N] {
    black_box(from_fn(|k| 0.4 - 0.11 * k as f64))
}

macro_rules! beside_by_hand {
    ($robot:literal, $module:ident, $standard:ident, $fast:ident) => {
        let chain = Chain::new(&robots::$module::JOINTS, GRAVITY);
        let (emitted, fast) = (robots::$module::$standard::default(), robots::$module::$fast::default());
        let times = in_turns(
            |q, v| black_box(&emitted).acceleration(0.0, q, v),
            |q, v| black_box(&chain).accelerations::<Platform>(q, v),
        );
        report("standard", $robot, "accelerations", &times);
        let times = in_turns(
            |q, v| black_box(&fast).acceleration(0.0, q, v),
            |q, v| black_box(&chain).accelerations::<Inline>(q, v),
        );
        report("fast", $robot, "accelerations", &times);
        let a = wanted();
        let times = in_turns(
            |q, v| black_box(&emitted).inverse_dynamics(0.0, q, v, &a),
            |q, v| black_box(&chain).inverse_dynamics::<Platform>(q, v, &a),
        );
        report("standard", $robot, "inverse dynamics", &times);
        let times = in_turns(
            |q, _| first_row(&black_box(&emitted).mass_matrix(0.0, q)),
            |q, _| first_row(&black_box(&chain).mass_matrix::<Platform>(q)),
        );
        report("standard", $robot, "mass matrix", &times);
    };
}

fn main() {
    println!("| {:<8} | {:<19} | {:<16} | ns     | ns     | ratio |", "level", "robot", "emitted");
    println!("|---|---|---|---|---|---|");
    beside_by_hand!("UR5", ur5, Ur5, FastUr5);
    beside_by_hand!("Panda", panda, Panda, FastPanda);
    beside_by_hand!("5 universal joints", universal_5, Universal5, FastUniversal5);
    beside_by_hand!("10 universal joints", universal_10, Universal10, FastUniversal10);
}
