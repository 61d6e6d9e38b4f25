//! Gradients of a cost beside forward derivatives, as rows of a Markdown table. Times are minima
//! over rounds in alternation.

use std::hint::black_box;
use std::time::Instant;

use lagrange::Simulate;

lagrange::system! {
    /// Eight masses between hardening springs, with friction.
    #[derive(Clone, Debug)]
    struct Chain;
    param m[8] = 1.5, k[8] = 20, c[8] = 0.1;
    coord x[8];
    kinetic = sum(i in 0..8, 1/2 * m[i] * dot(x[i])^2);
    potential = 1/2 * k[0] * (x[0] - 0.1 * sin(2 * t))^2 + sum(i in 1..8, 1/2 * k[i] * (x[i] - x[i - 1])^2 + (x[i] - x[i - 1])^4);
    dissipation = sum(i in 0..8, 1/2 * c[i] * dot(x[i])^2);
    emit { jacobian }
}

lagrange::system! {
    /// Four masses on rods in Cartesian coordinates.
    #[derive(Clone, Debug)]
    struct Rods;
    param m[4] = 1, l[4] = 1, c[4] = 0.1, g = 9.81;
    coord x[4], y[4];
    kinetic = sum(i in 0..4, 1/2 * m[i] * (dot(x[i])^2 + dot(y[i])^2));
    potential = sum(i in 0..4, m[i] * g * y[i]);
    dissipation = sum(i in 0..4, 1/2 * c[i] * (dot(x[i])^2 + dot(y[i])^2));
    constraint first = x[0]^2 + y[0]^2 - l[0]^2;
    constraint second = (x[1] - x[0])^2 + (y[1] - y[0])^2 - l[1]^2;
    constraint third = (x[2] - x[1])^2 + (y[2] - y[1])^2 - l[2]^2;
    constraint fourth = (x[3] - x[2])^2 + (y[3] - y[2])^2 - l[3]^2;
    emit { jacobian }
}

const ROUNDS: usize = 15;

/// Prints the rows of one system, for the derivatives with respect to all of these names, by one,
/// and by the start alone.
macro_rules! rows {
    ($what:literal, $system:expr, $start:expr, $end:expr, $names:expr) => {{
        let (system, start, names) = ($system, $start, $names);
        let simulation = || system.simulate(black_box(start)).until($end);
        let gradient = |count: usize| {
            let names = names.into_iter().take(count);
            simulation().gradient(names, |_, y, slope| {
                *slope = *y;
                y.iter().map(|entry| 0.5 * entry * entry).sum()
            })
        };
        let all = names.len();
        let [motion, by_start, by_one, by_all, one_forwards, all_forwards] = in_turns([
            &mut || drop(black_box(simulation().run().expect("a motion"))),
            &mut || drop(black_box(gradient(0).expect("a gradient"))),
            &mut || drop(black_box(gradient(1).expect("a gradient"))),
            &mut || drop(black_box(gradient(all).expect("a gradient"))),
            &mut || drop(black_box(simulation().sensitivities_alongside([names[0]]).run().expect("slopes"))),
            &mut || drop(black_box(simulation().sensitivities_alongside(names).run().expect("slopes"))),
        ]);
        let steps = gradient(0).expect("a gradient").steps;
        println!("{}, {steps} steps, the motion alone in {motion:.2} ms\n", $what);
        println!("| derivatives with respect to | gradient, ms | `.sensitivities_alongside`, ms |");
        println!("|---|---|---|");
        println!("| the start alone | {by_start:.1} | |");
        println!("| 1 parameter | {by_one:.1} | {one_forwards:.1} |");
        println!("| {all} parameters | {by_all:.1} | {all_forwards:.1} |\n");
    }};
}

/// Returns the shortest time of each function, in milliseconds.
fn in_turns<const N: usize>(mut functions: [&mut dyn FnMut(); N]) -> [f64; N] {
    let mut least = [f64::INFINITY; N];
    for _ in 0..ROUNDS {
        for (function, least) in functions.iter_mut().zip(&mut least) {
            let began = Instant::now();
            function();
            *least = least.min(began.elapsed().as_secs_f64() * 1e3);
        }
    }
    least
}

fn main() {
    let at_rest = |positions: [f64; 8]| -> [f64; 16] {
        std::array::from_fn(|i| if i < 8 { positions[i] } else { 0.0 })
    };
    let bent = at_rest(std::array::from_fn(|i| 0.2 * (i as f64).cos()));
    let names = [
        "m[0]", "m[1]", "m[2]", "m[3]", "m[4]", "m[5]", "m[6]", "m[7]", "k[0]", "k[1]", "k[2]", "k[3]",
        "k[4]", "k[5]", "k[6]", "k[7]", "c[0]", "c[1]", "c[2]", "c[3]", "c[4]", "c[5]", "c[6]", "c[7]",
    ];
    rows!("Eight masses between springs over 100 s", Chain::default(), bent, 100.0, names);
    let stretched = at_rest([1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0, 0.0]);
    let names =
        ["m[0]", "m[1]", "m[2]", "m[3]", "l[0]", "l[1]", "l[2]", "l[3]", "c[0]", "c[1]", "c[2]", "c[3]"];
    rows!("Four masses on rods over 10 s", Rods::default(), stretched, 10.0, names);
}
