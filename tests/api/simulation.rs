//! Simulations of emitted types through the main interface.

use lagrange::Simulate;
use lagrange::integrate::{
    BlanesMoan4, GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, RungeKutta4, StormerVerlet,
    SymplecticEuler, Variational, Verner98,
};
use lagrange::simulate::{SimulationError, Trajectory};

lagrange::system! {
    pub struct Spring;
    param m = 1.0, k = 4.0;
    coord x, len;
    kinetic = 1/2 * m * (dot(x)^2 + dot(len)^2);
    potential = 1/2 * k * (x^2 + len^2);
}

lagrange::system! {
    pub struct Generic<S>;
    param k = 4.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
}

lagrange::system! {
    #[scalar(f32)]
    pub struct Short;
    param k = 4.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
}

/// Returns a trajectory, which outlives its system, or a boxed error.
fn run() -> Result<Trajectory<Spring>, Box<dyn std::error::Error + Send + Sync>> {
    let start = SpringState { x: 1.0, len: 0.0, x_dot: 0.0, len_dot: 2.0 };
    Ok(Spring::default().simulate(start).until(3.0).every(0.5).tolerance(1e-11).energy().run()?)
}

#[test]
fn columns_have_the_names_of_the_declaration() {
    let trajectory = run().expect("runs");
    assert_eq!(trajectory.names(), ["x", "len", "x_dot", "len_dot", "energy"]);
    for (index, t) in trajectory.times().iter().enumerate() {
        assert!((trajectory.x()[index] - (2.0 * t).cos()).abs() < 1e-9);
        assert!((trajectory.len_dot()[index] - 2.0 * (2.0 * t).cos()).abs() < 1e-9);
    }
    // A coordinate named `len` does not hide the number of samples.
    assert_eq!(trajectory.len(), 7);
    let column = trajectory.column("len").expect("a coordinate");
    assert!((column[1] - 1.0_f64.sin()).abs() < 1e-9);
}

#[test]
fn states_convert_to_the_emitted_type() {
    let end = SpringState::from(run().expect("runs").last());
    assert!((end.x - 6.0_f64.cos()).abs() < 1e-9 && (end.len - 6.0_f64.sin()).abs() < 1e-9);
}

#[test]
fn every_scalar_has_a_tolerance_that_it_can_meet() {
    let short = Short::default().simulate([1.0, 0.0]).until(3.0).run().expect("f32 runs by default");
    assert!((short.last()[0] - 6.0_f32.cos()).abs() < 1e-4);
    let system = Generic { k: 4.0_f32 };
    let generic = system.simulate([1.0, 0.0]).until(3.0).every(0.1).run().expect("runs");
    assert_eq!(generic.len(), 31);
    assert!((generic.last()[0] - 6.0_f32.cos()).abs() < 1e-4);
}

#[test]
fn errors_keep_what_was_found() {
    let method = RungeKutta4 { step: 0.25 };
    let result = Short { k: f32::NAN }.simulate([1.0, 0.0]).until(1.0).method(method).run();
    let SimulationError { trajectory, .. } = result.expect_err("nothing can be computed");
    assert_eq!((trajectory.len(), trajectory.x()), (1, [1.0_f32].as_slice()));
}

lagrange::system! {
    pub struct Pendulum;
    param l = 1.0, g = 9.81;
    coord theta;
    emit { momentum_rates }
    kinetic = 1/2 * (l * dot(theta))^2;
    potential = -g * l * cos(theta);
}

/// Returns the motion up to 2 s from rest at 1 rad at −1 s, by a method with dense output.
fn swing(method: impl Method<Pendulum>) -> Trajectory<Pendulum> {
    let pendulum = Pendulum::default();
    let simulation = pendulum.simulate([1.0, 0.0]).from(-1.0).until(2.0).method(method);
    simulation.every(0.07).dense().energy().momenta().run().expect("runs")
}

#[test]
fn every_method_goes_through_the_front_door() {
    let best = swing(Verner98::tolerance(1e-13));
    let step = 0.01;
    let runs = [
        (swing(RungeKutta4 { step }), 1e-6),
        (swing(SymplecticEuler { step }), 0.2),
        (swing(StormerVerlet { step }), 1e-2),
        (swing(BlanesMoan4 { step }), 1e-6),
        (swing(ImplicitMidpoint { step }), 1e-2),
        (swing(GaussLegendre4 { step }), 1e-6),
        (swing(GaussLegendre6 { step }), 1e-7),
        (swing(Variational { step }), 1e-6),
    ];
    for (run, bound) in runs {
        let name = run.method();
        assert_eq!((run.times(), run.len()), (best.times(), 44), "{name}");
        for (t, [theta, theta_dot]) in best.iter() {
            let [found, found_dot] = run.at(t).expect("within");
            let error = (theta - found).hypot(theta_dot - found_dot);
            assert!(error < bound, "{name}: {error:e} at {t}");
        }
        for ((t, y), momentum) in run.iter().zip(run.column("p_theta").expect("observed")) {
            let at = run.at(t).expect("within");
            assert!(
                (y[0] - at[0]).hypot(y[1] - at[1]) < 1e-8,
                "{name}: samples are not the dense output at {t}"
            );
            assert_eq!(*momentum, y[1], "{name}");
        }
    }
}
