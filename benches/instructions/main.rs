//! Instructions per evaluation of the accelerations, as counted by valgrind: unlike times they are
//! the same on every run. Emitted chains must not exceed the numbers committed here; handwritten
//! ones are beside them.
//!
//! `cargo bench -p lagrange-instructions` needs valgrind and `cargo install gungraun-runner`. The
//! numbers are those of rustc 1.95 on x86-64 with glibc. A change of compiler may move them; then
//! new ones are committed.
#![allow(missing_docs, unused_qualifications, reason = "in what the macros of gungraun write")]

#[macro_use]
#[path = "../chains/declared.rs"]
mod declared;
#[path = "../handwritten.rs"]
mod handwritten;

use std::array::from_fn;
use std::hint::black_box;

use gungraun::{
    Callgrind, CallgrindMetrics, EventKind, LibraryBenchmarkConfig, library_benchmark,
    library_benchmark_group, main,
};
use lagrange::system::MechanicalSystem;

use handwritten::{Inline, Platform, absolute_chain_recursive, relative_chain};

mod chains {
    absolute!(absolute_5, 5);
    absolute!(absolute_20, 20);
    relative!(relative_8, 8);
}

mod fast_chains {
    absolute!(absolute_5, 5, fast);
    absolute!(absolute_20, 20, fast);
    relative!(relative_8, 8, fast);
}

/// Masses, lengths, gravity, coordinates and velocities.
type Chain<const N: usize> = ([f64; N], [f64; N], f64, [f64; N], [f64; N]);

fn chain<const N: usize>() -> Chain<N> {
    let spread = |from: f64, step: f64| from_fn(|k| from + step * k as f64);
    (spread(1.0, 0.1), spread(0.8, 0.05), 9.81, spread(0.3, 0.17), spread(-0.5, 0.23))
}

/// Allows at most two percent more instructions than this.
fn at_most(instructions: u64) -> LibraryBenchmarkConfig {
    let mut limits = Callgrind::default();
    limits.format([CallgrindMetrics::SingleEvent(EventKind::Ir)]);
    limits.hard_limits([(EventKind::Ir, instructions + instructions / 25)]);
    let mut config = LibraryBenchmarkConfig::default();
    config.tool(limits);
    config
}

/// Defines a group of emitted chains with their allowed instructions, and the handwritten ones.
macro_rules! group {
    ($group:ident: $($name:ident, $n:literal, $chains:ident::$chain:ident, $limit:literal,
     $by_hand_name:ident = $by_hand:ident::<$waves:ident>;)*) => {
        $(
            #[library_benchmark(config = at_most($limit))]
            #[bench::emitted(setup_system(chain::<$n>(), $chains::$chain::chain))]
            fn $name<M>((system, q, v): (M, [f64; $n], [f64; $n])) -> [f64; $n]
            where
                M: MechanicalSystem<Scalar = f64, Coordinates = [f64; $n], Velocities = [f64; $n]>,
            {
                black_box(&system).acceleration(0.0, &q, &v)
            }

            #[library_benchmark]
            #[bench::by_hand(chain())]
            fn $by_hand_name((m, l, g, q, v): Chain<$n>) -> [f64; $n] {
                $by_hand::<$waves, $n>(black_box(&q), &v, &m, &l, g)
            }
        )*

        library_benchmark_group!(name = $group, benchmarks = [$($name, $by_hand_name),*]);
    };
}

fn setup_system<const N: usize, M>(
    (m, l, g, q, v): Chain<N>,
    build: fn(&[f64; N], &[f64; N], f64) -> M,
) -> (M, [f64; N], [f64; N]) {
    (build(&m, &l, g), q, v)
}

group! { standard:
    absolute_5, 5, chains::absolute_5, 835, absolute_5_by_hand = absolute_chain_recursive::<Platform>;
    absolute_20, 20, chains::absolute_20, 3_653, absolute_20_by_hand = absolute_chain_recursive::<Platform>;
    relative_8, 8, chains::relative_8, 1_446, relative_8_by_hand = relative_chain::<Platform>;
}

group! { fast:
    fast_absolute_5, 5, fast_chains::absolute_5, 594, fast_absolute_5_by_hand = absolute_chain_recursive::<Inline>;
    fast_absolute_20, 20, fast_chains::absolute_20, 2_346, fast_absolute_20_by_hand = absolute_chain_recursive::<Inline>;
    fast_relative_8, 8, fast_chains::relative_8, 886, fast_relative_8_by_hand = relative_chain::<Inline>;
}

main!(library_benchmark_groups = [standard, fast]);
