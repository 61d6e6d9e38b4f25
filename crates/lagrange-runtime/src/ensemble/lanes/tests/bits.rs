//! Bits depend neither on lanes nor on threads, chunks, shards and restarts.

use std::vec::Vec;

use super::{DoublePendulum, Spring, arrivals};
use crate::ensemble::engine::Engine;
use crate::ensemble::lanes::refill::{EndsOf, MotionStart};
use crate::ensemble::lanes::{ArrivalOf, is_fused};
use crate::ensemble::{Ends, Ensemble, Ensembles, KeepSamples, Samples, Shard, SharedSystem};
use crate::integrate::{
    BlanesMoan4, LanesMethod, Method, RungeKutta4, StormerVerlet, SymplecticEuler, Taylor, Verner98,
};
use crate::scalar::Lanes;
use crate::simulate::{Grid, Table, Undriven};
use crate::system::{LanesSystem, SideBySide};

/// More than twice the number of lanes.
const MOTIONS: usize = 37;
const UNTIL: f64 = 0.4;
const INTERVAL: f64 = 0.03;

/// A method that runs in lanes with a system.
trait Goes<M: Subject>: Method<M> + LanesMethod<f64> + core::fmt::Debug + Sync {}

impl<M: Subject, K: Method<M> + LanesMethod<f64> + core::fmt::Debug + Sync> Goes<M> for K {}

/// A system of doubles that runs in lanes.
trait Subject: SharedSystem<Scalar = f64, Columns<Table<f64>>: Send> + LanesSystem + Default {}

impl<M: SharedSystem<Scalar = f64, Columns<Table<f64>>: Send> + LanesSystem + Default> Subject for M {}

/// The bits of times and states of a motion.
type Bits = Vec<u64>;

fn bits<Y: AsRef<[f64]>>(rows: impl IntoIterator<Item = (f64, Y)>) -> Bits {
    let row = |(time, state): (f64, Y)| {
        let numbers: Vec<_> = [time].iter().chain(state.as_ref()).map(|number| number.to_bits()).collect();
        numbers
    };
    rows.into_iter().flat_map(row).collect()
}

fn bits_of_ends<M: Subject>(ends: &Ends<M>) -> Vec<Bits> {
    let end = |(index, time): (usize, &f64)| bits([(*time, ends.state(index).expect("ended"))]);
    ends.motions().zip(ends.times()).map(end).collect()
}

fn bits_of_samples<M: Subject>(samples: &Samples<M>) -> Vec<Bits> {
    samples.iter().map(|(_, trajectory)| bits(trajectory.iter())).collect()
}

/// Computes the motions of an ensemble in lanes of the type S.
fn in_lanes<M: Subject, K: Goes<M>, S: SideBySide<Element = f64>, const SAMPLED: bool>(
    ensemble: &Ensemble<'_, M, K>,
) -> Vec<Bits> {
    let starts: Vec<_> = (0..MOTIONS).map(|index| ensemble.start_of(index, ensemble.batch.system)).collect();
    let grid = SAMPLED.then(|| Grid::new([0.0, UNTIL], INTERVAL).expect("has sense"));
    let ends: EndsOf<M> = arrivals::<M, S, SAMPLED>(&starts, ensemble.method, UNTIL, grid);
    let rows = |(start, end): (&MotionStart<M>, Option<ArrivalOf<M>>)| {
        let end = end.expect("ended");
        let start = SAMPLED.then_some((0.0, start.state));
        bits(start.into_iter().chain(end.samples).chain([(UNTIL, end.state)]))
    };
    starts.iter().zip(ends).map(rows).collect()
}

/// Computes ends or samples in four, eight and sixteen lanes.
fn in_all_lanes<M: Subject, K: Goes<M>, const FUSED: bool, const SAMPLED: bool>(
    ensemble: &Ensemble<'_, M, K>,
) -> [Vec<Bits>; 3] {
    [
        in_lanes::<M, K, Lanes<f64, 4, FUSED>, SAMPLED>(ensemble),
        in_lanes::<M, K, Lanes<f64, 8, FUSED>, SAMPLED>(ensemble),
        in_lanes::<M, K, Lanes<f64, 16, FUSED>, SAMPLED>(ensemble),
    ]
}

/// Returns engines with different numbers of threads and chunk sizes.
fn engines() -> impl Iterator<Item = Engine> {
    [(1, 64), (1, 7), (2, 64), (2, 5), (2, 1)].into_iter().map(|(threads, chunk)| {
        let mut engine = Engine::new(Some(threads), None).expect("threads");
        engine.chunk = chunk;
        engine
    })
}

/// Returns the shards of three processes.
fn shards() -> impl Iterator<Item = Shard> {
    (0..3).map(|process| Shard::of(process, 3))
}

/// Asserts that ends and samples of an ensemble have the same bits however they are computed.
fn assert_same<M: Subject, K: Goes<M>>(name: &str, ensemble: &dyn Fn() -> Ensemble<'static, M, K>) {
    let sampled = || -> Ensemble<'static, M, K, Undriven, KeepSamples> { ensemble().every(INTERVAL) };
    let (ends, samples) = (ensemble().run().expect("runs"), sampled().run().expect("runs"));
    let (ends, samples) = (bits_of_ends(&ends), bits_of_samples(&samples));
    assert_eq!((ends.len(), samples.len()), (MOTIONS, MOTIONS));
    assert!(sampled().is_in_lanes() && samples.iter().all(|rows| rows.len() == 15 * ends[0].len()));
    for engine in engines() {
        assert!(bits_of_ends(&ensemble().run_in(&engine).expect("runs")) == ends, "{name}: ends");
        assert!(bits_of_samples(&sampled().run_in(&engine).expect("runs")) == samples, "{name}: samples");
    }
    let parts = shards()
        .flat_map(|shard| bits_of_ends(&ensemble().motions_per_part(10).shard(shard).run().expect("runs")));
    assert!(parts.eq(ends.iter().cloned()), "{name}: ends of shards");
    let parts = shards()
        .flat_map(|shard| bits_of_samples(&sampled().motions_per_part(10).shard(shard).run().expect("runs")));
    assert!(parts.eq(samples.iter().cloned()), "{name}: samples of shards");
    let (lanes, lanes_of_samples) = if is_fused() {
        (in_all_lanes::<M, K, true, false>(&ensemble()), in_all_lanes::<M, K, true, true>(&ensemble()))
    } else {
        (in_all_lanes::<M, K, false, false>(&ensemble()), in_all_lanes::<M, K, false, true>(&ensemble()))
    };
    assert!(lanes.iter().all(|found| *found == ends), "{name}: ends in lanes");
    assert!(lanes_of_samples.iter().all(|found| *found == samples), "{name}: samples in lanes");
    #[cfg(feature = "parquet")]
    {
        saved::assert_same(name, "ends", ensemble, |ensemble, folder| {
            ensemble.save_parquet(folder).map(|saved| saved.written)
        });
        saved::assert_same(name, "samples", &sampled, |ensemble, folder| {
            ensemble.save_parquet(folder).map(|saved| saved.written)
        });
    }
}

/// Results saved to files instead of memory.
#[cfg(feature = "parquet")]
mod saved {
    use std::fs;
    use std::path::Path;
    use std::vec::Vec;

    use super::shards;
    use crate::ensemble::{Ensemble, EnsembleError, Keep, SharedSystem};
    use crate::simulate::Undriven;

    /// Asserts that an interrupted ensemble resumes to the same files, and that shards write them.
    pub(super) fn assert_same<M: SharedSystem, K, P: Keep>(
        name: &str,
        kept: &str,
        ensemble: &dyn Fn() -> Ensemble<'static, M, K, Undriven, P>,
        save: impl Fn(Ensemble<'static, M, K, Undriven, P>, &Path) -> Result<usize, EnsembleError>,
    ) {
        let folder = std::format!("lagrange_bits_{name}_{kept}_{}", std::process::id());
        let folder = std::env::temp_dir().join(folder);
        let ensemble = || ensemble().motions_per_part(10);
        let path = |part: usize| folder.join(std::format!("part-{part:06}.parquet"));
        let files = || (0..4).map(|part| fs::read(path(part)).expect("is there")).collect::<Vec<_>>();
        assert_eq!(save(ensemble(), &folder).expect("saves"), 4);
        let whole = files();
        fs::remove_file(path(2)).expect("was there");
        assert_eq!(save(ensemble().threads(2), &folder).expect("goes on"), 1);
        assert!(files() == whole, "{name}: {kept} after a restart");
        fs::remove_dir_all(&folder).expect("was there");
        for shard in shards() {
            save(ensemble().shard(shard), &folder).expect("saves");
        }
        assert!(files() == whole, "{name}: {kept} of shards in files");
        fs::remove_dir_all(&folder).expect("was there");
    }
}

static PENDULUM: DoublePendulum<f64> = DoublePendulum { ratio: 0.5, gravity: 9.81 };
static SPRING: Spring<f64> = Spring { stiffness: 1.0 };

/// Returns double pendulums that differ in start and parameter.
fn pendulums<K: Method<DoublePendulum<f64>>>(method: K) -> Ensemble<'static, DoublePendulum<f64>, K> {
    let motions =
        PENDULUM.ensemble(MOTIONS).start(|_, random| [random.uniform(-2.0..2.0), 1.0, 0.0, random.normal()]);
    motions.parameters(|index, system| system.ratio = 0.2 + 0.01 * index as f64).until(UNTIL).method(method)
}

/// Returns springs that differ in start and parameter.
fn springs<K: Method<Spring<f64>>>(method: K) -> Ensemble<'static, Spring<f64>, K> {
    let motions = SPRING.ensemble(MOTIONS).start(|_, random| [random.normal(), 1.0]);
    motions.parameters(|index, system| system.stiffness = 1.0 + index as f64).until(UNTIL).method(method)
}

#[test]
fn all_ways_lead_to_the_same_bits() {
    assert_same("verner", &|| pendulums(Verner98::tolerance(1e-6)));
    assert_same("runge_kutta", &|| pendulums(RungeKutta4 { step: 0.02 }));
    assert_same("euler", &|| springs(SymplecticEuler { step: 0.02 }));
    assert_same("verlet", &|| springs(StormerVerlet { step: 0.02 }));
    assert_same("taylor", &|| springs(Taylor::tolerance(1e-9)));
    assert_same("blanes_moan", &|| springs(BlanesMoan4 { step: 0.05 }));
}

#[test]
fn products_that_are_fused_have_other_bits() {
    let ensemble = pendulums(Verner98::tolerance(1e-6));
    let fused = in_lanes::<_, _, Lanes<f64, 8, true>, false>(&ensemble);
    assert!(fused != in_lanes::<_, _, Lanes<f64, 8, false>, false>(&ensemble));
}
