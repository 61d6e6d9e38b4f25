//! Plots, one per call.

use std::path::PathBuf;
use std::string::String;
use std::vec::Vec;

use super::{Oscillator, START};
use crate::integrate::RungeKutta4;
use crate::simulate::{PlotError, Simulate, Trajectory};
use crate::system::{MechanicalSystem, OdeSystem, Unnamed};

/// A bead at rest, with two decaying currents.
struct Circuit;

impl OdeSystem for Circuit {
    type Scalar = f64;
    type State = [f64; 4];

    fn rhs(&self, _t: f64, [_, a, b, v]: &[f64; 4]) -> [f64; 4] {
        [*v, -a, -b, 0.0]
    }
}

impl MechanicalSystem for Circuit {
    type Coordinates = [f64; 3];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x", "primary", "secondary"];
    const VELOCITIES: &'static [&'static str] = &["x_dot"];
    const RATES_OF: &'static [&'static str] = &["x"];
    const FIRST_ORDER_STATES: usize = 2;
    const UNITS: &'static [(&'static str, &'static str)] =
        &[("x", "m"), ("primary", "A"), ("secondary", "A")];

    fn acceleration(&self, _t: f64, _q: &[f64; 3], _v: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }

    fn position_rates(&self, _t: f64, [_, a, b]: &[f64; 3], [v]: &[f64; 1]) -> [f64; 3] {
        [*v, -a, -b]
    }

    fn position_change(&self, _t: f64, _q: &[f64; 3], [v]: &[f64; 1]) -> [f64; 3] {
        [*v, 0.0, 0.0]
    }

    fn displacement(&self, _t: f64, [from, ..]: &[f64; 3], [to, ..]: &[f64; 3]) -> [f64; 1] {
        [to - from]
    }
}

fn run() -> Trajectory<Oscillator> {
    Oscillator.simulate(START).until(10.0).tolerance(1e-10).every(0.05).energy().run().expect("runs")
}

/// Returns the content that a plot writes to a file of this name.
pub(super) fn written(name: &str, plot: impl FnOnce(PathBuf) -> Result<(), PlotError>) -> String {
    let path = std::env::temp_dir().join(std::format!("lagrange_{}_{name}.svg", std::process::id()));
    plot(path.clone()).expect("plots");
    let text = std::fs::read_to_string(&path).expect("is there");
    std::fs::remove_file(path).expect("was there");
    text
}

/// Returns the labels of a plot, with subscripts in braces.
pub(super) fn labels(svg: &str) -> Vec<String> {
    let mut labels = Vec::new();
    for line in svg.lines() {
        // Labels with dots are outlines.
        if let Some((_, named)) = line.split_once("aria-label=\"") {
            let name = named.split('"').next().expect("a name");
            labels.push(name.replace('\u{307}', "'"));
        }
        if !line.starts_with("<text ") {
            continue;
        }
        let mut label = String::new();
        for (index, piece) in line.split('<').skip(1).enumerate() {
            let (tag, text) = piece.split_once('>').expect("a tag");
            let is_subscript = index > 0 && tag.contains("font-size");
            label += &if is_subscript { std::format!("{{{text}}}") } else { text.into() };
        }
        labels.push(label);
    }
    labels
}

/// Returns the number of points of all curves of a plot that has these labels.
fn points(svg: &str, wanted: &[&str]) -> usize {
    let labels = labels(svg);
    assert!(wanted.iter().all(|wanted| labels.iter().any(|label| label == wanted)), "{labels:?}");
    let curves = svg.lines().filter(|line| line.contains("stroke-width=\"14\""));
    curves.map(|line| line.matches(',').count()).sum()
}

#[test]
fn states_have_a_panel_each() {
    let svg = written("states", |path| run().plot_states(path));
    assert_eq!(points(&svg, &["x", "x'", "time t in s", "0.5"]), 2 * 201);
}

#[test]
fn first_order_states_share_a_panel_with_their_unit() {
    let run = Circuit.simulate([0.0, 1.0, 2.0, 3.0]).until(1.0).every(0.1).run().expect("runs");
    let svg = written("circuit", |path| run.plot_states(path));
    points(&svg, &["x in m", "x'", "states in A", "primary", "secondary"]);
    let axes = labels(&svg).iter().filter(|label| *label == "time t in s").count();
    assert_eq!((axes, svg.contains("coordinates")), (3, false));
}

#[test]
fn a_phase_portrait_is_velocity_against_coordinate() {
    let svg = written("phase", |path| run().plot_phase("x", path));
    assert!(points(&svg, &["x", "x'"]) > 100);
    let error = run().plot_phase("y", "y.svg").expect_err("unknown");
    assert!(matches!(error, PlotError::UnknownColumn { name, .. } if name == "y"));
}

#[test]
fn columns_share_a_panel_and_a_legend() {
    let svg = written("columns", |path| run().plot_columns(&["x", "energy"], path));
    assert_eq!(points(&svg, &["x", "energy"]), 2 * 201);
    assert!(matches!(run().plot_columns(&["x", "z"], "z.svg"), Err(PlotError::UnknownColumn { .. })));
}

#[test]
fn columns_are_drawn_against_another_one() {
    let svg = written("against", |path| run().plot_against("x", &["x_dot", "energy"], path));
    let one = written("against_one", |path| run().plot_against("x", &["x_dot"], path));
    let drawn = points(&svg, &["x", "x'", "energy"]);
    assert!(drawn > points(&one, &["x", "x'"]) && !one.contains("energy"));
    for (x, y) in [("z", "energy"), ("x", "z")] {
        let error = run().plot_against(x, &[y], "z.svg").expect_err("unknown");
        assert!(matches!(error, PlotError::UnknownColumn { name, .. } if name == "z"));
    }
}

#[test]
fn the_drift_of_the_energy_is_relative_and_readable() {
    let svg = written("energy", |path| run().plot_energy(path));
    assert_eq!(points(&svg, &["(E − E{0})/|E{0}|"]), 201);
    assert!(svg.contains("×10⁻"), "a drift of 1e-10 has a factor beside the axis");
}

#[test]
fn a_drift_that_grows_by_orders_of_magnitude_is_logarithmic() {
    let simulation = Oscillator.simulate(START).until(1000.0).method(RungeKutta4 { step: 1e-2 });
    let trajectory = simulation
        .every(0.01)
        .observe("energy", |_, t, _| 1.0 + 1e-15 * (0.02 * t).exp())
        .run()
        .expect("runs");
    let svg = written("growth", |path| trajectory.plot_energy(path));
    assert!(points(&svg, &["|E − E{0}|/|E{0}|", "10⁻¹⁰"]) > 1000);
}

#[test]
fn an_energy_of_zero_drifts_absolutely() {
    let simulation = Oscillator.simulate(START).until(10.0).every(0.1);
    let trajectory = simulation.observe("energy", |_, t, _| 1e-14 * t.sin()).run().expect("runs");
    let svg = written("zero", |path| trajectory.plot_energy(path));
    assert_eq!(points(&svg, &["E − E{0}"]), 101);
}

#[test]
fn plots_of_unobserved_energies_suggest_observing_them() {
    let trajectory = Oscillator.simulate(START).until(1.0).run().expect("runs");
    assert!(matches!(trajectory.plot_energy("energy.svg"), Err(PlotError::NoEnergy)));
}

#[test]
fn a_plot_of_no_columns_is_refused() {
    let trajectory = Oscillator.simulate(START).until(1.0).run().expect("runs");
    for refused in [trajectory.plot_columns(&[], "none.svg"), trajectory.plot_against("x", &[], "none.svg")] {
        assert!(matches!(refused, Err(PlotError::NoColumns)));
    }
    assert!(!std::path::Path::new("none.svg").exists());
    let unknown = trajectory.plot_columns(&["x", "velocity"], "none.svg").expect_err("no such column");
    assert_eq!(std::format!("{unknown}"), "there is no column `velocity`; the columns are `x`, `x_dot`");
    let lost = trajectory.plot_columns(&["x"], "/no/such/folder/x.svg").expect_err("no folder");
    assert!(std::format!("{lost}").starts_with("cannot write `/no/such/folder/x.svg`: "), "{lost}");
}
