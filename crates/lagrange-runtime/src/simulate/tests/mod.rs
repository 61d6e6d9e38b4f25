//! Tests of the public interface on handwritten systems with known solutions.

mod dense;
mod events;
mod files;
mod limits;
mod observers;
#[cfg(feature = "plot")]
mod plots;
mod quaternions;
mod restarts;
mod sampling;
mod units;

use crate::integrate::RungeKutta4;
use crate::simulate::{Simulate, Trajectory};
use crate::system::{EnergyFunction, MechanicalSystem, OdeSystem, Unnamed};

/// ẍ = −x with solution (cos t, −sin t) from (1, 0).
struct Oscillator;

impl OdeSystem for Oscillator {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, -x]
    }
}

impl MechanicalSystem for Oscillator {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x"];

    fn acceleration(&self, _t: f64, [x]: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [-x]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }
}

impl EnergyFunction for Oscillator {
    fn energy(&self, _t: f64, [x]: &[f64; 1], [v]: &[f64; 1]) -> f64 {
        0.5 * (x * x + v * v)
    }
}

/// ẍ = −x until x falls below a bound, NaN afterwards.
struct Broken(f64);

impl OdeSystem for Broken {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, if *x < self.0 { f64::NAN } else { -x }]
    }
}

impl MechanicalSystem for Broken {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x"];

    fn acceleration(&self, t: f64, [x]: &[f64; 1], [v]: &[f64; 1]) -> [f64; 1] {
        [self.rhs(t, &[*x, *v])[1]]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }
}

const START: [f64; 2] = [1.0, 0.0];

/// Returns the state of the oscillator this long after its start.
fn exact(t: f64) -> [f64; 2] {
    [t.cos(), -t.sin()]
}

fn assert_exact(trajectory: &Trajectory<Oscillator>, bound: f64) {
    for (t, y) in trajectory.iter() {
        let expected = exact(t - trajectory.start_time());
        let error = (y[0] - expected[0]).hypot(y[1] - expected[1]);
        assert!(error < bound, "{error:e} at {t}");
    }
}

#[test]
fn the_default_method_meets_the_tolerance() {
    for tolerance in [1e-4, 1e-7, 1e-10, 1e-13] {
        let trajectory = Oscillator.simulate(START).until(10.0).tolerance(tolerance).run().expect("runs");
        assert_exact(&trajectory, 20.0 * tolerance);
    }
    assert_exact(&Oscillator.simulate(START).until(10.0).run().expect("runs"), 1e-8);
}

#[test]
fn a_tighter_tolerance_takes_more_steps() {
    let steps = |tolerance| {
        Oscillator.simulate(START).until(10.0).tolerance(tolerance).run().expect("runs").work().steps
    };
    assert!(steps(1e-13) > steps(1e-4));
}

#[test]
fn a_relative_tolerance_asks_for_less_of_large_states() {
    let run = |absolute| {
        let simulation = Oscillator.simulate([1e6, 0.0]).until(10.0).tolerance(1e-8);
        simulation.absolute_tolerance(absolute).run().expect("runs").work().steps
    };
    assert!(run(1e-8) < 2 * run(1e-2));
    let run = |relative| {
        let simulation = Oscillator.simulate([1e6, 0.0]).until(10.0).tolerance(relative);
        simulation.absolute_tolerance(1e-8).run().expect("runs").work().steps
    };
    assert!(run(1e-12) > run(1e-4));
}

#[test]
fn another_method_takes_its_own_steps() {
    let method = RungeKutta4 { step: 1e-2 };
    let trajectory = Oscillator.simulate(START).until(2.0).method(method).run().expect("runs");
    assert_eq!(trajectory.work().steps, 200);
    assert_eq!(trajectory.work().evaluations, 800);
    assert_eq!(trajectory.len(), 201);
    assert_eq!(trajectory.method(), "Runge–Kutta 4");
    assert_exact(&trajectory, 1e-8);
}

#[test]
fn statistics_add_up() {
    let trajectory = Oscillator.simulate(START).until(10.0).tolerance(1e-10).run().expect("runs");
    let work = trajectory.work();
    assert_eq!(trajectory.len() as u64, work.steps + 1);
    assert!(work.evaluations >= 15 * (work.steps + work.rejections));
    let sampled = Oscillator.simulate(START).until(10.0).tolerance(1e-10).every(1e-3).run().expect("runs");
    assert_eq!((sampled.work().steps, sampled.work().rejections), (work.steps, work.rejections));
    assert!(sampled.work().evaluations > work.evaluations);
}

#[test]
fn samples_are_read_by_index_and_by_name() {
    let trajectory = Oscillator.simulate(START).until(1.0).every(0.25).run().expect("runs");
    assert_eq!(trajectory.names(), ["x", "x_dot"]);
    assert_eq!(trajectory.column("y"), None);
    assert_eq!(trajectory.state(5), None);
    assert_eq!(trajectory.state(0), Some(START));
    assert_eq!(trajectory.state(4), Some(trajectory.last()));
    let (x, v) = (trajectory.column("x").expect("known"), trajectory.column("x_dot").expect("known"));
    for (index, (t, y)) in trajectory.iter().enumerate() {
        assert_eq!((t, y), (trajectory.times()[index], [x[index], v[index]]));
    }
    assert_eq!(trajectory.states().count(), 5);
}
