//! Units of a system appear wherever its columns do.

use std::string::String;
use std::vec::Vec;

use crate::constraint::Unprojected;
use crate::simulate::{Simulate, Trajectory};
use crate::system::{EnergyFunction, MechanicalSystem, OdeSystem, Unnamed};

/// A bead and a disk at rest.
struct Free;

impl OdeSystem for Free {
    type Scalar = f64;
    type State = [f64; 4];

    fn rhs(&self, _t: f64, [_, _, u, w]: &[f64; 4]) -> [f64; 4] {
        [*u, *w, 0.0, 0.0]
    }
}

impl MechanicalSystem for Free {
    type Coordinates = [f64; 2];
    type Velocities = [f64; 2];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x", "theta"];
    const UNITS: &'static [(&'static str, &'static str)] = &[
        ("x", "m"),
        ("theta", "rad"),
        ("x_dot", "m/s"),
        ("theta_dot", "rad/s"),
        ("slip", "1"),
        ("heat", "J"),
    ];

    fn acceleration(&self, _t: f64, _q: &[f64; 2], _v: &[f64; 2]) -> [f64; 2] {
        [0.0; 2]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
        *v
    }
}

impl EnergyFunction for Free {
    fn energy(&self, _t: f64, _q: &[f64; 2], [u, w]: &[f64; 2]) -> f64 {
        0.5 * (u * u + w * w)
    }
}

#[test]
fn a_system_without_projection_keeps_its_units() {
    let run = Unprojected(Free).simulate([0.0, 0.0, 1.0, 2.0]).until(1.0).energy().run().expect("runs");
    assert_eq!(
        (run.unit("theta_dot"), run.unit("energy"), run.unit("t")),
        (Some("rad/s"), Some("J"), Some("s"))
    );
}

fn run() -> Trajectory<Free> {
    let simulation = Free.simulate([0.0, 1.0, 2.0, 3.0]).until(1.0).every(0.5).energy();
    let slip = |_: &Free, _, y: &[f64; 4]| y[2] / y[3];
    simulation
        .observe("slip", slip)
        .observe("other", |_, t, _| t)
        .observe("heat[0]", |_, t, _| t)
        .run()
        .expect("runs")
}

#[test]
fn columns_have_the_units_that_are_declared() {
    let trajectory = run();
    let units = ["t", "x", "theta", "x_dot", "theta_dot", "energy", "slip", "other", "heat[0]"];
    let units = units.map(|name| trajectory.unit(name).unwrap_or("?"));
    assert_eq!(units, ["s", "m", "rad", "m/s", "rad/s", "J", "1", "?", "J"]);
    let trajectory = super::Oscillator.simulate(super::START).until(1.0).energy().run().expect("runs");
    assert!(["t", "x", "energy"].iter().all(|name| trajectory.unit(name).is_none()));
}

#[test]
fn csv_has_units_in_its_first_line() {
    let mut bytes = Vec::new();
    run().write_csv(&mut bytes).expect("memory takes everything");
    let text = String::from_utf8(bytes).expect("text");
    let head =
        "t in s,x in m,theta in rad,x_dot in m/s,theta_dot in rad/s,energy in J,slip,other,heat[0] in J";
    assert_eq!(text.lines().next(), Some(head));
}

#[cfg(feature = "parquet")]
#[test]
fn parquet_has_units_among_its_metadata() {
    use parquet::file::reader::{FileReader, SerializedFileReader};

    let path = std::env::temp_dir().join(std::format!("lagrange_units_{}.parquet", std::process::id()));
    run().save_parquet(&path).expect("writes");
    let file = SerializedFileReader::new(std::fs::File::open(&path).expect("is there")).expect("is Parquet");
    std::fs::remove_file(path).expect("was there");
    let pairs = file.metadata().file_metadata().key_value_metadata().expect("has some");
    let pair = |name: &str| pairs.iter().find(|pair| pair.key.strip_prefix("lagrange.unit.") == Some(name));
    let unit = |name: &str| pair(name).and_then(|pair| pair.value.as_deref());
    let units = ["t", "x", "theta_dot", "energy", "slip", "other"].map(unit);
    assert_eq!(units, [Some("s"), Some("m"), Some("rad/s"), Some("J"), Some("1"), None]);
}

#[cfg(feature = "plot")]
#[test]
fn axes_have_the_unit_that_curves_share_and_legends_those_of_several() {
    use super::plots::{labels, written};

    let has = |svg: &str, wanted: &[&str]| {
        let labels = labels(svg);
        wanted.iter().all(|wanted| labels.iter().any(|label| label == wanted))
    };
    let svg = written("unit_states", |path| run().plot_states(path));
    assert!(has(&svg, &["time t in s", "x in m", "θ in rad", "x' in m/s", "θ' in rad/s"]));
    let svg = written("unit_pair", |path| run().plot_pair("x", "energy", path));
    assert!(has(&svg, &["x in m", "energy in J"]));
    let svg = written("unit_columns", |path| run().plot_columns(&["x", "theta", "slip", "other"], path));
    assert!(has(&svg, &["x in m", "θ in rad", "slip", "other"]));
    let svg = written("unit_shared", |path| run().plot_against("theta", &["x", "x"], path));
    assert!(has(&svg, &["θ in rad", "in m", "x"]));
    let svg = written("unit_drift", |path| run().plot_energy(path));
    assert!(has(&svg, &["(E − E{0})/|E{0}|"]));
}
