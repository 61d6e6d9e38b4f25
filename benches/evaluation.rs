//! Time per evaluation of the accelerations: emitted against handwritten code.
//!
//! Every evaluation waits for the previous one, as in an integrator, so latency counts. All
//! parameters are read again in each call, and nothing is carried over from call to call.

#[macro_use]
#[path = "chains/declared.rs"]
mod declared;
mod handwritten;

use std::array::from_fn;
use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use lagrange::system::MechanicalSystem;

use handwritten::{Platform, absolute_chain, absolute_chain_recursive, double_pendulum, relative_chain};

absolute!(absolute_2, 2);
absolute!(absolute_5, 5);
absolute!(absolute_10, 10);
absolute!(absolute_20, 20);
relative!(relative_4, 4);
relative!(relative_8, 8);

const GRAVITY: f64 = 9.81;

/// A chain in some configuration.
struct Chain<const N: usize> {
    m: [f64; N],
    l: [f64; N],
    q: [f64; N],
    v: [f64; N],
}

impl<const N: usize> Chain<N> {
    fn new() -> Chain<N> {
        let spread = |from: f64, step: f64| from_fn(|k| from + step * k as f64);
        Chain { m: spread(1.0, 0.1), l: spread(0.8, 0.05), q: spread(0.3, 0.17), v: spread(-0.5, 0.23) }
    }
}

type Group<'a> = BenchmarkGroup<'a, WallTime>;

/// Times `accelerations(q, v)` with a q that depends on the previous result, though not in value.
fn time<const N: usize>(
    group: &mut Group<'_>,
    name: &str,
    chain: &Chain<N>,
    mut accelerations: impl FnMut(&[f64; N], &[f64; N]) -> [f64; N],
) {
    let (start, v) = black_box((chain.q, chain.v));
    let mut q = start;
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            let a = accelerations(&q, &v);
            q = from_fn(|k| start[k] + 1e-200 * a[k]);
            q[0]
        });
    });
}

fn emitted<const N: usize, M>(group: &mut Group<'_>, build: fn(&[f64; N], &[f64; N], f64) -> M)
where
    M: MechanicalSystem<Scalar = f64, Coordinates = [f64; N], Velocities = [f64; N]>,
{
    let chain = Chain::new();
    let system = build(&chain.m, &chain.l, GRAVITY);
    time(group, "emitted", &chain, |q, v| black_box(&system).acceleration(0.0, q, v));
}

fn by_hand<const N: usize>(
    group: &mut Group<'_>,
    name: &str,
    accelerations: impl Fn(&[f64; N], &[f64; N], &[f64; N], &[f64; N], f64) -> [f64; N],
) {
    let chain = Chain::new();
    let parameters = (chain.m, chain.l, GRAVITY);
    time(group, name, &chain, |q, v| {
        let (m, l, g) = black_box(&parameters);
        accelerations(q, v, m, l, *g)
    });
}

fn absolute<const N: usize, M>(
    criterion: &mut Criterion,
    name: &str,
    build: fn(&[f64; N], &[f64; N], f64) -> M,
) where
    M: MechanicalSystem<Scalar = f64, Coordinates = [f64; N], Velocities = [f64; N]>,
{
    let mut group = criterion.benchmark_group(name);
    emitted(&mut group, build);
    by_hand(&mut group, "dense by hand", absolute_chain::<Platform, N>);
    by_hand(&mut group, "recursive by hand", absolute_chain_recursive::<Platform, N>);
}

fn relative<const N: usize, M>(
    criterion: &mut Criterion,
    name: &str,
    build: fn(&[f64; N], &[f64; N], f64) -> M,
) where
    M: MechanicalSystem<Scalar = f64, Coordinates = [f64; N], Velocities = [f64; N]>,
{
    let mut group = criterion.benchmark_group(name);
    emitted(&mut group, build);
    by_hand(&mut group, "recursive by hand", relative_chain::<Platform, N>);
}

fn chains(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("double pendulum");
    emitted(&mut group, absolute_2::chain);
    by_hand(&mut group, "by hand", double_pendulum::<Platform>);
    drop(group);
    absolute(criterion, "absolute 2", absolute_2::chain);
    absolute(criterion, "absolute 5", absolute_5::chain);
    absolute(criterion, "absolute 10", absolute_10::chain);
    absolute(criterion, "absolute 20", absolute_20::chain);
    relative(criterion, "relative 4", relative_4::chain);
    relative(criterion, "relative 8", relative_8::chain);
}

criterion_group!(benches, chains);
criterion_main!(benches);
