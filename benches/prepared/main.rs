//! Robots whose masses, centroids and inertias are parameters, with and without preparation, in
//! alternation. The output is rows of a Markdown table. Times are minima, ratios medians
//! (`timing.rs`).

mod robots;
#[path = "../timing.rs"]
mod timing;

use std::array::from_fn;
use std::hint::black_box;

use timing::{Times, in_turns};

fn report(robot: &str, what: &str, times: &Times) {
    println!("| {robot:<6} | {what:<16} | {times} |");
}

macro_rules! prepared_beside_plain {
    ($robot:ident) => {
        let plain = robots::$robot::default();
        let prepared = plain.prepared();
        let times = in_turns(
            |q, v| black_box(&prepared).acceleration(0.0, q, v),
            |q, v| black_box(&plain).acceleration(0.0, q, v),
        );
        report(stringify!($robot), "accelerations", &times);
        let a = black_box(from_fn(|k| 0.4 - 0.11 * k as f64));
        let times = in_turns(
            |q, v| black_box(&prepared).inverse_dynamics(0.0, q, v, &a),
            |q, v| black_box(&plain).inverse_dynamics(0.0, q, v, &a),
        );
        report(stringify!($robot), "inverse dynamics", &times);
        let times = in_turns(
            |q, _| black_box(&black_box(&prepared).mass_matrix(0.0, q))[0],
            |q, _| black_box(&black_box(&plain).mass_matrix(0.0, q))[0],
        );
        report(stringify!($robot), "mass matrix", &times);
    };
}

fn main() {
    println!("| robot  | what             | prepared, ns | plain, ns | ratio |");
    println!("|---|---|---|---|---|");
    prepared_beside_plain!(Ur5);
    prepared_beside_plain!(Panda);
}
