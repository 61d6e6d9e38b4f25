//! Bits depend only on the seed.

use lagrange::ensemble::{Ends, Histogram, Moments, Motion, Random, Reduce, Reduced, Shard};
use lagrange::{Ensembles, Simulate};

use crate::{DoublePendulum, start};

const NUMBER: usize = 200;

fn masses(index: usize, pendulum: &mut DoublePendulum) {
    pendulum.m2 = 0.5 + index as f64 * 1e-2;
}

fn bits(ends: &Ends<DoublePendulum>) -> Vec<u64> {
    let columns = ends.table().columns().chain([ends.times()]);
    columns.flatten().map(|value| value.to_bits()).collect()
}

fn ends(threads: usize, seed: u64) -> Ends<DoublePendulum> {
    let pendulum = DoublePendulum::default();
    let ensemble = pendulum.ensemble(NUMBER).start(start).parameters(masses).until(3.0);
    ensemble.tolerance(1e-9).seed(seed).threads(threads).run().expect("runs")
}

#[test]
fn ends_do_not_depend_on_threads() {
    let one = bits(&ends(1, 7));
    // Four for the state, five for parameters and one for the time.
    assert_eq!(one.len(), 10 * NUMBER);
    assert!([2, 3].map(|threads| bits(&ends(threads, 7))).iter().all(|other| *other == one));
    assert_ne!(bits(&ends(1, 8)), one);
    let pendulum = DoublePendulum::default();
    let everybodys = pendulum.ensemble(NUMBER).start(start).parameters(masses).until(3.0).tolerance(1e-9);
    assert_eq!(bits(&everybodys.seed(7).run().expect("runs")), one);
}

#[test]
fn ends_are_those_of_single_runs() {
    let ends = ends(2, 7);
    assert!(ends.failures().is_empty());
    for index in 0..NUMBER {
        let mut pendulum = DoublePendulum::default();
        masses(index, &mut pendulum);
        let start = start(index, &mut Random::start(7, index));
        let trajectory = pendulum.simulate(start).until(3.0).tolerance(1e-9).run().expect("runs");
        assert_eq!(ends.state(index), Some(trajectory.last()));
        assert_eq!(ends.theta2()[index].to_bits(), trajectory.last()[1].to_bits());
    }
}

#[test]
fn shards_put_together_are_everything() {
    let all = ends(1, 7);
    let mut found = Vec::new();
    for index in 0..3 {
        let pendulum = DoublePendulum::default();
        let ensemble = pendulum.ensemble(NUMBER).start(start).parameters(masses).until(3.0).tolerance(1e-9);
        let ensemble = ensemble.seed(7).motions_per_part(16).shard(Shard::of(index, 3));
        let ends = ensemble.run().expect("runs");
        assert_eq!(ends.motions().start, found.len());
        assert_eq!(ends.state(ends.motions().end), None);
        found.extend(ends.motions().map(|motion| ends.state(motion).expect("is there")));
    }
    let expected: Vec<_> = (0..NUMBER).map(|motion| all.state(motion).expect("is there")).collect();
    assert_eq!(found, expected);
}

#[test]
fn reductions_do_not_depend_on_threads() {
    let pendulum = DoublePendulum::default();
    let found = [1, 2, 3].map(|threads| {
        let ensemble = pendulum.ensemble(NUMBER).start(start).until(3.0).threads(threads);
        let identity = (Moments::new(), Histogram::new(64), Vec::new());
        let reduced = ensemble.reduce(identity, |(moments, histogram, motions), motion| {
            moments.add(motion.end().theta1_dot);
            histogram.add(motion.end().theta2);
            motions.push(motion.index());
        });
        reduced.expect("runs").into_value()
    });
    assert_eq!(found[0].0.count(), NUMBER as u64);
    assert_eq!(found[0].2, (0..NUMBER).collect::<Vec<_>>());
    assert!(found.iter().all(|other| *other == found[0]));
    let text = found.each_ref().map(|(moments, ..)| format!("{moments:?}"));
    assert!(text.iter().all(|other| *other == text[0]));
}

#[test]
fn parts_put_together_are_the_reduction() {
    let pendulum = DoublePendulum::default();
    let ensemble = || pendulum.ensemble(NUMBER).start(start).until(1.0).motions_per_part(30);
    let add = |moments: &mut Moments, motion: &Motion<'_, DoublePendulum>| moments.add(motion.end().theta1);
    let whole = ensemble().threads(2).reduce(Moments::new(), add).expect("runs");
    let (mut found, mut parts) = (Moments::new(), 0);
    for shard in 0..3 {
        let merge = |part: Reduced<DoublePendulum, Moments>| {
            found.merge(part.into_value());
            parts += 1;
        };
        ensemble().shard(Shard::of(shard, 3)).reduce_parts(&Moments::new(), add, merge).expect("runs");
    }
    assert_eq!((parts, found.count()), (7, NUMBER as u64));
    assert_eq!(found, *whole);
}
