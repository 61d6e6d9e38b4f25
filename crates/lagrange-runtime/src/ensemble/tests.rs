//! Tests of internals: chunks, and reductions of parts.

use std::vec::Vec;

use super::engine::Engine;
use super::{Ends, Ensembles, Histogram, Moments, Pack, Random, Reduce};
use crate::system::{MechanicalSystem, OdeSystem, Unnamed};

/// ẍ = −g sin x, and NaN beyond x = 100
#[derive(Clone)]
pub(super) struct Pendulum {
    pub(super) g: f64,
}

impl OdeSystem for Pendulum {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        let [a] = self.acceleration(t, &[*x], &[*v]);
        [*v, a]
    }
}

impl MechanicalSystem for Pendulum {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x"];
    const UNITS: &'static [(&'static str, &'static str)] = &[("x", "rad"), ("g", "1/s^2")];

    fn acceleration(&self, _t: f64, [x]: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        if *x > 100.0 { [f64::NAN] } else { [-self.g * libm::sin(*x)] }
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }

    fn parameter(&self, index: usize) -> Option<(&'static str, f64)> {
        (index == 0).then_some(("g", self.g))
    }
}

fn bits(ends: &Ends<Pendulum>) -> Vec<Vec<u64>> {
    let columns = ends.table().columns().chain([ends.times()]);
    columns.map(|column| column.iter().map(|value| value.to_bits()).collect()).collect()
}

#[test]
fn rows_do_not_depend_on_chunks() {
    let found = [(1, 64), (1, 1), (2, 7), (3, 1000), (3, 64)].map(|(threads, chunk)| {
        let pendulum = Pendulum { g: 1.0 };
        let ensemble = pendulum.ensemble(301).start(|_, random| [random.uniform(-3.0..3.0), 0.0]).until(5.0);
        let mut engine = Engine::new(Some(threads), None).expect("threads");
        engine.chunk = chunk;
        bits(&ensemble.run_in(&engine).expect("runs"))
    });
    assert_eq!(found[0][0].len(), 301);
    assert!(found.iter().all(|other| *other == found[0]));
}

/// Returns numbers of very different magnitudes, both signs and zeros.
fn numbers() -> Vec<f64> {
    let mut random = Random::start(1, 2);
    let number = |_| random.normal() * 10_f64.powi(random.uniform(-3.0..3.0) as i32);
    (0..999).map(number).chain([0.0, -0.0, 1e-300]).collect()
}

#[test]
fn a_histogram_depends_neither_on_order_nor_on_parts() {
    let counted = |numbers: &[f64]| {
        let mut histogram = Histogram::new(16);
        numbers.iter().for_each(|value| histogram.add(*value));
        histogram
    };
    let mut numbers = numbers();
    let whole = counted(&numbers);
    for split in [0, 1, 500, 998, 1002] {
        let (mut start, end) = (counted(&numbers[..split]), counted(&numbers[split..]));
        start.merge(end);
        assert_eq!(start, whole);
    }
    numbers.sort_by(f64::total_cmp);
    assert_eq!(counted(&numbers), whole);
    let bins: Vec<_> = whole.bins().collect();
    assert!((8..=16).contains(&bins.len()), "{bins:?}");
    for (range, count) in bins {
        assert_eq!(numbers.iter().filter(|value| range.contains(value)).count() as u64, count);
    }
}

#[test]
fn a_histogram_counts_apart_what_is_not_finite() {
    let mut histogram = Histogram::new(4);
    [f64::NAN, f64::INFINITY, 2.0].into_iter().for_each(|value| histogram.add(value));
    assert_eq!((histogram.count(), histogram.not_finite()), (1, 2));
    assert_eq!(Histogram::new(4).quantile(0.5), None);
    assert_eq!(histogram.quantile(1.5), None);
}

#[test]
fn quantiles_are_off_by_less_than_a_bin() {
    let mut histogram = Histogram::new(128);
    (0..1000).for_each(|i| histogram.add(f64::from(i) / 1000.0));
    for part in [0.0, 0.1, 0.5, 0.9, 1.0] {
        let found = histogram.quantile(part).expect("has numbers");
        assert!((found - part).abs() < 1.0 / 64.0, "{part}: {found}");
    }
}

#[test]
fn reductions_are_unpacked_as_they_were_packed() {
    let mut reduction = ((Moments::new(), Histogram::new(16)), [3_u64, 4], Vec::from([5.0]));
    let ((moments, histogram), ..) = &mut reduction;
    numbers().iter().chain([&f64::NAN]).for_each(|value| histogram.add(*value));
    numbers().iter().for_each(|value| moments.add(*value));
    let mut words = Vec::new();
    reduction.pack(&mut words);
    words.push(7);
    let mut iterator = words.iter().copied();
    assert_eq!(Pack::unpack(&mut iterator), Some(reduction.clone()));
    assert_eq!((iterator.next(), iterator.next()), (Some(7), None));
    for length in 0..words.len() - 1 {
        let mut short = words.iter().copied().take(length);
        assert!(<((Moments, Histogram), [u64; 2], Vec<f64>)>::unpack(&mut short).is_none());
    }
}

#[test]
fn moments_of_parts_are_those_of_all() {
    let numbers = numbers();
    let counted = |numbers: &[f64]| {
        let mut moments = Moments::new();
        numbers.iter().for_each(|value| moments.add(*value));
        moments
    };
    let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
    let squares = numbers.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
    let variance = squares / (numbers.len() - 1) as f64;
    for split in [0, 1, 500, 1002] {
        let mut found = counted(&numbers[..split]);
        found.merge(counted(&numbers[split..]));
        assert!((found.mean() - mean).abs() < 1e-12 * variance.sqrt(), "{found:?}");
        assert!((found.variance() / variance - 1.0).abs() < 1e-12, "{found:?}");
        assert_eq!(found.count(), 1002);
        assert_eq!(found.max(), numbers.iter().copied().fold(f64::MIN, f64::max));
        assert_eq!(found.min(), numbers.iter().copied().fold(f64::MAX, f64::min));
    }
    assert!(counted(&[1.0, f64::NAN, 2.0]).min().is_nan() && counted(&[f64::NAN, 1.0]).max().is_nan());
    assert!(counted(&[1.0]).variance().is_nan() && counted(&[]).mean().is_nan());
}
