//! The price of the contact points of two blocks that touch with faces, edges or corners, or are
//! far apart. `docs/contacts.md` has the numbers.
//!
//! `cargo bench -p lagrange-benches --bench touches`

use std::hint::black_box;
use std::time::Instant;

use lagrange::manifold::{Block, manifold};

const ROUNDS: usize = 50;
const CALLS: usize = 2_000;

const UPRIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// cos 45°
const HALF_RIGHT: f64 = std::f64::consts::FRAC_1_SQRT_2;

fn main() {
    let floor = cube([0.0; 3], UPRIGHT);
    let [c, s] = [HALF_RIGHT; 2];
    let about_x = [[1.0, 0.0, 0.0], [0.0, c, s], [0.0, -s, c]];
    let about_y = [[c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, c]];
    let along_x = [UPRIGHT[1], UPRIGHT[2], UPRIGHT[0]];
    let capsule = Block { half: [0.0, 0.0, 1.0], radius: 0.25, ..cube([0.5, 0.0, 1.2], along_x) };
    println!("| blocks | contact points | gap | ns |");
    println!("|---|---|---|---|");
    row("face on face", &cube([0.5, 0.3, 1.99], UPRIGHT), &floor);
    row("edge across edge", &cube([0.0, 0.0, 2.82], about_x), &cube([0.0; 3], about_y));
    row("corner beside corner", &cube([2.1, 2.1, 2.1], UPRIGHT), &floor);
    row("capsule on a face", &capsule, &floor);
    row("far apart", &cube([9.0, 2.0, 1.0], UPRIGHT), &floor);
}

/// Returns a cube of side 2.
fn cube(center: [f64; 3], axes: [[f64; 3]; 3]) -> Block<f64> {
    Block { center, axes, half: [1.0; 3], radius: 0.0 }
}

/// Prints the shortest time of a call. Each call moves the first block by at most a rounding error.
fn row(name: &str, first: &Block<f64>, second: &Block<f64>) {
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let mut first = black_box(*first);
        let began = Instant::now();
        for _ in 0..CALLS {
            let gap = manifold(&first, black_box(second)).gap();
            first.center[0] += 1e-200 * gap;
        }
        black_box(first);
        least = least.min(began.elapsed().as_secs_f64() * 1e9 / CALLS as f64);
    }
    let found = manifold(first, second);
    println!("| {name} | {} | {:.3} | {least:.0} |", found.touches().len(), found.gap());
}
