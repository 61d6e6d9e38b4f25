use std::fs;
use std::string::{String, ToString};
use std::vec::Vec;

use super::Trade;
use crate::system::OdeSystem;

/// ẍ = −x; the motion from (1, 0) is (cos t, −sin t).
struct Oscillator;

impl OdeSystem for Oscillator {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, y: &[f64; 2]) -> [f64; 2] {
        [y[1], -y[0]]
    }
}

/// An oscillator in single precision.
struct Short;

impl OdeSystem for Short {
    type Scalar = f32;
    type State = [f32; 2];

    fn rhs(&self, _t: f32, y: &[f32; 2]) -> [f32; 2] {
        [y[1], -y[0]]
    }
}

/// ẏ = √(1 − t), which is undefined after one.
struct Ending;

impl OdeSystem for Ending {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [(1.0 - t).sqrt()]
    }
}

fn quick(trade: Trade<'_>) -> Trade<'_> {
    trade.longest(1e-4)
}

fn exact() -> [f64; 2] {
    [2.0_f64.cos(), -2.0_f64.sin()]
}

#[test]
fn errors_are_those_against_the_reference() {
    let report = quick(Trade::new("oscillator", &Oscillator, [1.0, 0.0], 2.0)).reference(&exact()).run();
    let (row, found) = report.fastest(1e-11).expect("the pair of order nine reaches that");
    assert_eq!(row.method, "Verner 9(8)");
    assert!(found.error <= 1e-11 && found.work.evaluations > 0);
    let wrong = quick(Trade::new("oscillator", &Oscillator, [1.0, 0.0], 2.0)).reference(&[0.0, 0.0]).run();
    assert!(wrong.fastest(0.1).is_none());
}

#[test]
fn without_a_reference_the_finest_run_is_one() {
    let report = quick(Trade::new("oscillator", &Oscillator, [1.0, 0.0], 2.0)).run();
    assert!(report.fastest(1e-10).is_some());
    assert!(report.recommendation().contains("the finest run"));
}

#[test]
fn settings_that_are_left_out_are_known() {
    let trade = |longest| Trade::new("oscillator", &Oscillator, [1.0, 0.0], 2.0).longest(longest);
    assert!(trade(1e-9).run().is_cut());
    let failing = Trade::new("ending", &Ending, [0.0], 2.0).longest(60.0).run();
    assert!(failing.rows().is_empty() && !failing.is_cut());
}

#[test]
fn short_numbers_reach_less() {
    let report = quick(Trade::new("oscillator", &Oscillator, [1.0, 0.0], 2.0))
        .variant("standard", &Short)
        .reference(&exact())
        .run();
    let short =
        report.rows().iter().filter(|row| row.scalar == "f32").filter_map(|row| row.outcome.as_ref().ok());
    let least = short.map(|found| found.error).fold(f64::INFINITY, f64::min);
    assert!(least < 1e-5 && least > 1e-9, "{least}");
}

#[test]
fn runs_that_fail_are_reported_with_their_reason() {
    let report = quick(Trade::new("ending", &Ending, [0.0], 2.0)).reference(&[0.0]).run();
    assert!(report.rows().iter().all(|row| row.outcome.is_err()));
    assert!(report.csv().lines().skip(1).all(|line| !line.ends_with(',')));
    assert!(report.csv().contains("NaN"));
    assert!(report.recommendation().contains("not reached"));
}

#[test]
fn every_line_of_the_table_has_every_column() {
    let csv = quick(Trade::new("oscillator", &Oscillator, [1.0, 0.0], 2.0)).run().csv();
    // Commas between quotes are not separators.
    let bare = csv.lines().map(|line| line.split('"').step_by(2).collect::<String>());
    let columns = bare.map(|line| line.split(',').count()).collect::<Vec<_>>();
    assert!(columns.len() > 5 && columns.iter().all(|count| *count == 14), "{csv}");
}

#[test]
fn files_are_named_for_the_title() {
    let directory = std::env::temp_dir().join(std::format!("lagrange-trade-{}", std::process::id()));
    let report = quick(Trade::new("An oscillator, 2 s", &Oscillator, [1.0, 0.0], 2.0)).run();
    report.save(&directory).expect("a temporary directory can be written to");
    let mut names = fs::read_dir(&directory)
        .expect("it was made")
        .map(|entry| entry.expect("it can be read").file_name().to_string_lossy().to_string())
        .collect::<Vec<_>>();
    names.sort();
    fs::remove_dir_all(&directory).expect("it was ours");
    assert_eq!(names, ["an_oscillator_2_s.csv", "an_oscillator_2_s.md", "an_oscillator_2_s.svg"]);
}
