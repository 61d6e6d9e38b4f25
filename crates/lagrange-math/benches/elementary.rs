//! Nanoseconds per number for elementary functions of eight numbers at a time, compared with the
//! functions of the standard library one by one.
//!
//! Products are fused if the compilation target supports it: `RUSTFLAGS="-C target-cpu=native"`.

use std::array::from_fn;
use std::hint::black_box;
use std::time::Instant;

use lagrange_math::{Elementary, angles, lengths, values};

const FUSED: bool = cfg!(target_feature = "fma");
const N: usize = 8;
const ROUNDS: usize = 500;
const EVALUATIONS: usize = 500;

/// Returns the shortest time per number among many rounds.
#[inline(never)]
fn time(scale: f64, function: impl Fn([f64; N]) -> [f64; N]) -> f64 {
    let start: [f64; N] = black_box(from_fn(|k| scale * (0.11 + 0.1 * k as f64)));
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let mut numbers = start;
        let began = Instant::now();
        for _ in 0..EVALUATIONS {
            let values = function(numbers);
            // Each evaluation waits for the previous one, as in an integrator.
            for k in 0..N {
                numbers[k] = start[k] + 1e-200 * values[k];
            }
        }
        black_box(numbers);
        least = least.min(began.elapsed().as_nanos() as f64);
    }
    least / (EVALUATIONS * N) as f64
}

fn compare(
    name: &str,
    scale: f64,
    together: impl Fn([f64; N]) -> [f64; N],
    platform: impl Fn(f64) -> f64 + Copy,
) {
    let (together, alone) = (time(scale, together), time(scale, |x| x.map(platform)));
    println!("| {name:6} | {together:5.2} | {alone:5.2} | {:4.1} |", alone / together);
}

macro_rules! compare {
    ($($name:ident, $function:ident, $scale:literal;)*) => {
        $(compare(stringify!($name), $scale, |x| values::<FUSED, N>(Elementary::$function, x), f64::$name);)*
    };
}

fn main() {
    println!("| function | {N} at a time | one by one | ratio |\n|---|---|---|---|");
    compare! {
        tan, Tan, 3.0;
        asin, Asin, 1.0;
        acos, Acos, 1.0;
        atan, Atan, 3.0;
        sinh, Sinh, 3.0;
        cosh, Cosh, 3.0;
        tanh, Tanh, 3.0;
        exp, Exp, 3.0;
        ln, Ln, 3.0;
    }
    compare("atan2", 3.0, |y| angles::<FUSED, N>(y, black_box([1.0; N])), |y| y.atan2(black_box(1.0)));
    compare("hypot", 3.0, |y| lengths::<FUSED, N>(y, black_box([1.0; N])), |y| y.hypot(black_box(1.0)));
}
