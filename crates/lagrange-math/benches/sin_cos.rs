//! Nanoseconds for the sines and cosines of a number of angles, compared with the function of the
//! standard library.
//!
//! Each evaluation waits for the previous one, as in an integrator, so latency counts. The results
//! enter a recursion like those of mechanics, which does not invite vector instructions.

use std::array::from_fn;
use std::hint::black_box;
use std::time::Instant;

use lagrange_math::sin_cos_each;

const ROUNDS: usize = 300;
const EVALUATIONS: usize = 500;

fn platform<const N: usize>(angles: [f64; N]) -> [(f64, f64); N] {
    angles.map(f64::sin_cos)
}

/// Returns the shortest time per evaluation among many rounds.
#[inline(never)]
fn time<const N: usize>(function: impl Fn([f64; N]) -> [(f64, f64); N]) -> f64 {
    let start: [f64; N] = black_box(from_fn(|k| 1.3 + 0.37 * k as f64));
    let lengths: [f64; N] = black_box(from_fn(|k| 0.3 + 0.17 * k as f64));
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let mut angles = start;
        let began = Instant::now();
        for _ in 0..EVALUATIONS {
            let (waves, mut along, mut across) = (function(angles), 1.0, 0.0);
            angles = from_fn(|k| {
                let (sine, cosine) = waves[k];
                (along, across) = (along * cosine - lengths[k] * sine, across + lengths[k] * cosine);
                start[k] + 1e-200 * (along + across)
            });
        }
        black_box(angles);
        least = least.min(began.elapsed().as_nanos() as f64 / EVALUATIONS as f64);
    }
    least
}

fn compare<const N: usize>() {
    let (platform, each) = (time(platform::<N>), time(sin_cos_each::<N>));
    println!("{N:>6} {platform:>12.1} {each:>12.1} {:>8.2}", each / platform);
}

fn main() {
    println!("{:>6} {:>12} {:>12} {:>8}", "angles", "platform", "together", "ratio");
    compare::<1>();
    compare::<2>();
    compare::<3>();
    compare::<4>();
    compare::<5>();
    compare::<6>();
    compare::<7>();
    compare::<8>();
    compare::<10>();
    compare::<16>();
    compare::<20>();
    compare::<32>();
    compare::<100>();
}
