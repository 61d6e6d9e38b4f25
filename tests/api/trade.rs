//! Lines that a trade proposes, as they are pasted.

use std::collections::BTreeSet;

use lagrange::integrate::{PlainGaussLegendre, Radau5, RungeKutta4, Taylor, Verner98};
use lagrange::trade::Trade;
use lagrange::{Double, Number, Portable, Simulate};

lagrange::system! {
    /// A mass on a spring.
    #[derive(Clone, Debug)]
    struct Oscillator<S>;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    emit { jacobian, lanes, taylor }
}

lagrange::system! {
    /// A mass on a weak spring with a strong damper.
    #[derive(Clone, Debug)]
    struct Overdamped;

    param k = 10, c = 1e4;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * c * dot(x)^2;
    emit { jacobian }
}

const START: [f64; 2] = [1.0, 0.0];

/// Runs what a line says from the start to time one, and returns the end in doubles.
macro_rules! paste {
    ($line:expr, $setting:ident, $($system:expr => $method:expr;)*) => {{
        let line = $line.replace(' ', "");
        $(
            let text = format!(".method({})", stringify!($method)).replace(' ', "");
            if line == text.replace("setting", &format!("{:?}", $setting)) {
                let system = $system;
                let start = START.map(Number::from_f64);
                let run = system.simulate(start).until(Number::ONE).method($method).run();
                return run.expect("the line runs").last().map(f64::from);
            }
        )*
        panic!("{} is not a line of this table", $line)
    }};
}

fn pasted(line: &str, setting: f64) -> [f64; 2] {
    paste! { line, setting,
        Oscillator::<f64>::default() => Verner98::tolerance(setting);
        Oscillator::<f64>::default() => Taylor::tolerance(setting);
        Oscillator::<f64>::default() => Radau5::tolerance(setting);
        Oscillator::<f64>::default() => RungeKutta4 { step: setting };
        Oscillator::<f64>::default() => PlainGaussLegendre::<f64, 1> { step: setting };
        Oscillator::<f64>::default() => PlainGaussLegendre::<f64, 2> { step: setting };
        Oscillator::<f64>::default() => PlainGaussLegendre::<f64, 3> { step: setting };
        Oscillator::<Portable>::default() => Verner98::tolerance(Portable::from(setting));
        Oscillator::<Portable>::default() => RungeKutta4 { step: Portable::from(setting) };
        Oscillator::<Double>::default() => Taylor::tolerance(Double::from(setting));
    }
}

#[test]
fn every_line_compiles_and_reaches_its_error() {
    let (standard, portable) = (Oscillator::<f64>::default(), Oscillator::<Portable>::default());
    let wide = Oscillator::<Double>::default();
    let (sine, cosine) = Double::ONE.sin_cos();
    let report = Trade::new("oscillator", &standard, START, 1.0)
        .taylor("standard", &standard)
        .explicit("standard", &portable)
        .taylor("standard", &wide)
        .lanes("standard", &standard)
        .reference(&[cosine, -sine])
        .longest(2e-3)
        .run();
    let ends = [f64::from(cosine), -f64::from(sine)];
    let mut tried = BTreeSet::new();
    for row in report.rows() {
        let Ok(found) = &row.outcome else { continue };
        let end = if row.motions == 1 { pasted(&row.line, row.setting) } else { continue };
        let error = (end[0] - ends[0]).abs().max((end[1] - ends[1]).abs());
        // The end in doubles, and the sums of their rounding, differ by a few units.
        assert!(error <= found.error + 1e-15, "{}: {error:e} instead of {:e}", row.line, found.error);
        tried.insert((&row.method, &row.scalar));
    }
    assert_eq!(tried.len(), 10, "{tried:?}");
    assert!(report.rows().iter().any(|row| row.motions > 1 && row.outcome.is_ok()));
}

#[test]
fn errors_below_doubles_are_reached_by_series_of_wide_numbers() {
    let wide = Oscillator::<Double>::default();
    let (sine, cosine) = Double::ONE.sin_cos();
    let trade = Trade::without_methods("oscillator", START.to_vec(), 1.0).taylor("standard", &wide);
    let report = trade.reference(&[cosine, -sine]).longest(10.0).run();
    for goal in [1e-16, 1e-20, 1e-24] {
        let (row, found) = report.fastest(goal).expect("numbers of 106 bits reach it");
        assert!(row.line.starts_with(".method(Taylor::tolerance(Double::from("), "{}", row.line);
        assert!(found.error > 0.0 && found.error <= goal);
    }
    assert!(report.recommendation().contains("| 1e-24 | `.method(Taylor::"));
}

#[test]
fn a_stiff_system_gets_the_method_for_it() {
    let system = Overdamped::default();
    // The slow one of two exponentials, the other of which has decayed.
    let (k, c) = (10.0_f64, 1e4_f64);
    let fast = -(c + (c * c - 4.0 * k).sqrt()) / 2.0;
    let slow = k / fast;
    let x = fast / (fast - slow) * (2.0 * slow).exp();
    let report = Trade::without_methods("overdamped", START.to_vec(), 2.0)
        .by_tolerance("standard", &system, Verner98::tolerance)
        .by_tolerance("standard", &system, Radau5::tolerance)
        .reference(&[x, slow * x])
        .longest(10.0)
        .run();
    let (row, found) = report.fastest(1e-6).expect("Radau's method reaches it");
    assert!(row.line.starts_with(".method(Radau5::tolerance("), "{}", row.line);
    let run = system.simulate(START).until(2.0).method(Radau5::tolerance(row.setting)).run();
    let error = (run.expect("it runs").last()[0] - x).abs();
    assert!(error <= found.error && found.error <= 1e-6, "{error:e}");
}
