//! Standard errors, undetermined parameters, and local minima.

use std::cell::Cell;
use std::ops::ControlFlow;

use crate::noise::Noise;
use lagrange::fit::{Data, FitError, Fits};
use lagrange::system::NamedSystem;

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Oscillator;
    param m: kg = 1.0, k: N/m = 3.0, c: N*s/m = 0.1;
    coord x: m;
    input push: N;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * c * dot(x)^2;
    force x = push;
    emit { jacobian }
}

/// Returns x = e^(−a t) (cos w t + a/w sin w t) with a = c/2, w² = k − a².
fn exact(t: f64, k: f64, c: f64) -> f64 {
    let a = c / 2.0;
    let w = (k - a * a).sqrt();
    (-a * t).exp() * ((w * t).cos() + a / w * (w * t).sin())
}

fn measured(seed: u64, level: f64) -> Data {
    let mut noise = Noise(seed);
    let times: Vec<f64> = (0..120).map(|row| 0.05 * f64::from(row)).collect();
    let x: Vec<f64> = times.iter().map(|t| exact(*t, 4.0, 0.3) + level * noise.normal()).collect();
    Data::new(times).with("x", x)
}

/// Deviations over standard errors have a mean square of one. For 60 of them, a correct fit is
/// outside 0.5 to 1.7 once in ten thousand times.
#[test]
fn deviations_are_as_large_as_standard_errors() {
    let mut squares = Vec::new();
    for seed in 1..=30 {
        let fitted = Oscillator::default()
            .fit([1.0, 0.0], measured(seed, 0.02))
            .vary("k", 0.1..=100.0)
            .vary("c", 0.0..=5.0)
            .run()
            .unwrap();
        for (name, value) in [("k", 4.0), ("c", 0.3)] {
            let part = (fitted.value(name).unwrap() - value) / fitted.standard_error(name).unwrap();
            assert!(part.abs() < 4.0, "seed {seed}, {name}: {part}");
            squares.push(part * part);
        }
    }
    let mean = squares.iter().sum::<f64>() / squares.len() as f64;
    assert!((0.5..1.7).contains(&mean), "{mean}");
}

/// Residuals determine the level of the noise, or it is given; standard errors agree.
#[test]
fn levels_of_noise_may_be_given_or_found() {
    let fit = |level: Option<f64>| {
        let oscillator = Oscillator::default();
        let fit = oscillator.fit([1.0, 0.0], measured(7, 0.02)).vary("k", 0.1..).vary("c", ..);
        level.map_or_else(|| fit_again(&oscillator), |level| fit.noise("x", level).run().unwrap())
    };
    let (found, given) = (fit(None), fit(Some(0.02)));
    assert!((found.value("k").unwrap() - given.value("k").unwrap()).abs() < 1e-9);
    let ratio = found.standard_error("k").unwrap() / given.standard_error("k").unwrap();
    let expected = (given.chi_square() / given.degrees_of_freedom() as f64).sqrt();
    assert!((ratio / expected - 1.0).abs() < 1e-6 && (ratio - 1.0).abs() < 0.3, "{ratio} {expected}");
}

fn fit_again(oscillator: &Oscillator) -> lagrange::fit::Fitted<Oscillator> {
    oscillator.fit([1.0, 0.0], measured(7, 0.02)).vary("k", 0.1..).vary("c", ..).run().unwrap()
}

/// A common factor of m, k and c leaves the motion unchanged: relative changes of (1, 1, 1)/√3.
#[test]
fn a_combination_that_data_do_not_tell_is_named() {
    let oscillator = Oscillator::default();
    let fit =
        oscillator.fit([1.0, 0.0], measured(3, 0.02)).vary("m", 0.1..).vary("k", 0.1..).vary("c", 0.0..);
    let Err(error @ FitError::Undetermined(_)) = fit.run() else { panic!("all is told") };
    let fitted = error.fitted().unwrap();
    for (_, part) in fitted.weakest() {
        assert!((part.abs() - 1.0 / 3.0_f64.sqrt()).abs() < 1e-4, "{:?}", fitted.weakest());
    }
    let ratio = fitted.value("k").unwrap() / fitted.value("m").unwrap();
    assert!((ratio - 4.0).abs() < 0.1, "{ratio}");
    assert_eq!((fitted.standard_error("k"), fitted.covariance()), (None, None));
    let text = error.to_string();
    assert!(text.contains("0.58 `m`") && text.contains("0.58 `k`") && text.contains("0.58 `c`"), "{text}");
}

/// From a distant stiffness, a search ends at a minimum with fewer or more periods.
#[test]
fn the_best_of_several_minima_is_taken() {
    let far = Oscillator { k: 60.0, ..Oscillator::default() };
    let fit = || far.fit([1.0, 0.0], measured(5, 0.02)).vary("k", 0.5..=80.0);
    let alone = fit().run().map(|fitted| fitted.chi_square()).unwrap_or(f64::INFINITY);
    let best = fit().starts(12).run().unwrap();
    assert!((best.value("k").unwrap() - 4.0).abs() < 0.1, "{best}");
    assert!(best.chi_square() < 0.5 * alone);
    assert_eq!(best.costs().len(), 12);
}

/// A step response: a law gives the force, and some values are missing.
#[test]
fn inputs_follow_a_law() {
    let times: Vec<f64> = (1..60).map(|row| 0.1 * f64::from(row)).collect();
    // From rest, a force of 2 t/(1 + t) has no closed form, so a run makes the data.
    let law = |_: &Oscillator, t: f64, _: <Oscillator as NamedSystem>::NamedState| OscillatorInputs {
        push: 2.0 * t / (1.0 + t),
    };
    let wanted = Oscillator { k: 5.0, c: 0.6, ..Oscillator::default() };
    use lagrange::Simulate;
    let motion = wanted
        .simulate([0.0, 0.0])
        .until(5.9)
        .at_times(times.clone())
        .tolerance(1e-12)
        .drive(law)
        .run()
        .unwrap();
    assert_eq!(motion.times()[1..], times);
    let x = motion.x()[1..].iter().enumerate().map(|(row, x)| (row % 7 != 3).then_some(*x));
    let fit = Oscillator::default();
    let fit = fit.fit([0.0, 0.0], Data::new(times).with("x", x)).from(0.0).drive(law);
    let fitted = fit.tolerance(1e-11).vary("k", 0.1..).vary("c", 0.0..).run().unwrap();
    assert!(
        (fitted.value("k").unwrap() - 5.0).abs() < 1e-6 && (fitted.value("c").unwrap() - 0.6).abs() < 1e-6
    );
    assert!(fitted.table().column("x (fit)").unwrap()[3].is_nan());
}

/// Costs that are reported decrease, and the last one is that of the result. A cancelled fit keeps
/// the best values so far.
#[test]
fn fits_report_their_progress_and_may_be_cancelled() {
    let oscillator = Oscillator::default();
    let fit = || oscillator.fit([1.0, 0.0], measured(1, 0.02)).vary("k", 0.1..=100.0).vary("c", 0.0..=5.0);
    let mut reports = Vec::new();
    let fitted = fit().starts(3).progress(|report| reports.push(report)).run().expect("a minimum");
    assert!(reports.windows(2).all(|pair| {
        pair[1].cost <= pair[0].cost
            && pair[1].evaluations == pair[0].evaluations + 1
            && pair[1].start >= pair[0].start
    }));
    let last = reports.last().expect("reports");
    let least = fitted.costs().iter().fold(f64::INFINITY, |least: f64, cost| least.min(*cost));
    assert_eq!((last.start, last.starts, last.cost), (2, 3, least));

    let mut left = 4;
    let cancelled = fit().starts(3).progress(|_| {
        left -= 1;
        if left > 0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    let error = cancelled.run().expect_err("cancelled");
    assert_eq!(error.to_string(), "the fit was cancelled");
    let best = error.fitted().expect("values so far");
    assert!((best.costs()[0] - reports[3].cost).abs() <= 1e-12 * best.costs()[0] && left == 0);
    let at_once = fit().progress(|_| ControlFlow::Break(()));
    assert!(at_once.run().expect_err("cancelled").fitted().is_some());

    // Within a motion: the first, which has no values, and one of those that follow.
    for (most, has_values) in [(3, false), (12, true)] {
        let asked = Cell::new(0);
        let cancelled = fit().cancel_when(|| asked.replace(asked.get() + 1) == most);
        let error = cancelled.run().expect_err("cancelled");
        assert_eq!(error.to_string(), "the fit was cancelled");
        assert_eq!((error.fitted().is_some(), asked.get()), (has_values, most + 1));
    }
}
