//! Constraints over long motions of methods that project their states.

use lagrange::constraint::{ConstrainedSystem, Unprojected};
use lagrange::integrate::{
    GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, RungeKutta4, Stepper, Verner98, integrate,
};
use lagrange::system::{EnergyFunction, OdeSystem, split};

lagrange::system! {
    /// A point mass on a rod in the plane, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    pub(crate) struct Rod;

    emit { momentum_rates }
    param g = 9.81;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint rod = x^2 + y^2 - 1;
}

lagrange::system! {
    /// The rod with stabilisation.
    #[derive(Clone, Debug)]
    pub(crate) struct StabilisedRod;

    param g = 9.81, rate;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint rod = x^2 + y^2 - 1;
    stabilise = rate;
}

lagrange::system! {
    /// The pendulum of the rod in an angle.
    #[derive(Clone, Debug)]
    pub(crate) struct Angle;

    param g = 9.81;
    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -g * cos(theta);
}

lagrange::system! {
    /// A skate that turns on a slope.
    #[derive(Clone, Debug)]
    pub(crate) struct Skate;

    emit { momentum_rates }
    param fall = 2.0;
    coord x, y, theta;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2) + 1/4 * dot(theta)^2;
    potential = -fall * x;
    constraint blade = dot(y) * cos(theta) - dot(x) * sin(theta);
}

/// The outcome of a motion.
#[derive(Debug)]
struct Seen<Y> {
    /// The largest residuals of positions and of velocities.
    residuals: [f64; 2],
    /// The largest error of the energy.
    energy: f64,
    end: Y,
    /// The time of its end.
    time: f64,
    evaluations: u64,
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// Follows a motion up to `end`, or as far as possible.
fn follow<M, K>(system: &M, start: M::State, end: f64, method: &K) -> Seen<M::State>
where
    M: OdeSystem<Scalar = f64> + EnergyFunction + ConstrainedSystem,
    K: Method<M>,
{
    let energy = |y: &M::State| {
        let (q, v) = split::<M>(y);
        system.energy(0.0, &q, &v)
    };
    let mut stepper = method.start(system, 0.0, &start, end).expect("an admissible start");
    let mut seen = Seen { residuals: [0.0; 2], energy: 0.0, end: start, time: 0.0, evaluations: 0 };
    while stepper.time() < end && stepper.step(system, end).is_ok() {
        let (t, y) = (stepper.time(), stepper.state());
        let (q, v) = split::<M>(y);
        let positions = largest(system.position_residuals(t, &q).as_ref());
        let velocities = largest(system.velocity_residuals(t, &q, &v).as_ref());
        seen.residuals = [seen.residuals[0].max(positions), seen.residuals[1].max(velocities)];
        seen.energy = seen.energy.max((energy(y) - energy(&start)).abs());
    }
    Seen { end: *stepper.state(), time: stepper.time(), evaluations: stepper.work().evaluations, ..seen }
}

/// Horizontal and at rest.
const START: [f64; 4] = [1.0, 0.0, 0.0, 0.0];
const END: f64 = 1000.0;

/// Returns the end of the rod, from its angle.
fn reference() -> [f64; 2] {
    let level = [std::f64::consts::FRAC_PI_2, 0.0];
    let tight = Verner98::tolerance(1e-15);
    let [theta, _] = integrate(&Angle::default(), 0.0, level, END, &tight, |_, _| {}).expect("finite");
    [theta.sin(), -theta.cos()]
}

/// Prints the row of a table, and returns the error of the position at the end.
fn row(name: &str, seen: &Seen<[f64; 4]>, [x, y]: [f64; 2]) -> f64 {
    let error = (seen.end[0] - x).hypot(seen.end[1] - y);
    let (Seen { energy, time, evaluations, .. }, [positions, velocities]) = (seen, seen.residuals);
    println!(
        "| {name} | {positions:.0e} | {velocities:.0e} | {energy:.0e} | {error:.0e} | {evaluations} | {time} s |"
    );
    error
}

/// Prints the table in the documentation of `lagrange::constraint`.
#[test]
fn projection_needs_no_rate_and_leaves_no_residuals() {
    let (rod, reference) = (Rod::default(), reference());
    let stabilised = |rate| StabilisedRod { g: 9.81, rate };
    let classical = RungeKutta4 { step: 0.01 };
    let projected = follow(&rod, START, END, &classical);
    assert!(row("RK4: projection", &projected, reference) < 1e-2);
    assert!(largest(&projected.residuals) < 3e-15, "{projected:?}");
    for (rate, least) in [(1.0, 1e-7), (5.0, 1e-7), (20.0, 1e-6), (100.0, 1e-5)] {
        let seen = follow(&stabilised(rate), START, END, &classical);
        row(&format!("RK4: stabilised, {rate}/s"), &seen, reference);
        assert!(seen.residuals[0] > least, "{rate}: {seen:?}");
    }
    let seen = follow(&Unprojected(rod.clone()), START, END, &classical);
    row("RK4: neither", &seen, reference);
    assert!(seen.time < END, "without anything the rod grows until numbers end: {seen:?}");

    let adaptive = Verner98::tolerance(1e-10);
    let projected = follow(&rod, START, END, &adaptive);
    assert!(row("Verner: projection", &projected, reference) < 3e-6);
    assert!(largest(&projected.residuals) < 3e-15, "{projected:?}");
    for (rate, least) in [(1.0, 1e-12), (5.0, 3e-13), (20.0, 3e-14), (100.0, 1e-14)] {
        let seen = follow(&stabilised(rate), START, END, &adaptive);
        row(&format!("Verner: stabilised, {rate}/s"), &seen, reference);
        assert!(seen.residuals[0] > least, "{rate}: {seen:?}");
    }
    let seen = follow(&Unprojected(rod), START, END, &adaptive);
    let error = row("Verner: neither", &seen, reference);
    assert!(seen.residuals[0] > 1e-7 && error > 3e-5, "{seen:?}");
}

/// Checks residuals and energies of a method over a thousand seconds on a rod and on a skate.
fn assert_held<K>(method: &K, energies: [f64; 2])
where
    K: Method<Rod> + Method<Skate>,
{
    let rod = follow(&Rod::default(), START, END, method);
    let skate = follow(&Skate::default(), [0.0, 0.0, 0.2, 0.2_f64.cos(), 0.2_f64.sin(), 1.5], END, method);
    for (residuals, energy, time, bound) in [
        (rod.residuals, rod.energy, rod.time, energies[0]),
        (skate.residuals, skate.energy, skate.time, energies[1]),
    ] {
        println!("{}: {residuals:?}, {energy:e}", Method::<Rod>::name(method));
        assert_eq!(time, END);
        assert!(largest(&residuals) < 1e-14, "{residuals:?}");
        assert!(energy < bound, "{energy}");
    }
}

#[test]
fn every_method_stays_on_constraints_over_a_hundred_thousand_steps() {
    let step = 0.01;
    assert_held(&RungeKutta4 { step }, [3e-4, 3e-8]);
    assert_held(&Verner98::tolerance(1e-14), [5e-12, 5e-12]);
    assert_held(&ImplicitMidpoint { step }, [0.1, 1e-3]);
    assert_held(&GaussLegendre4 { step }, [4e-6, 1e-8]);
    assert_held(&GaussLegendre6 { step }, [3e-10, 1e-10]);
    assert_held(&ImplicitMidpoint { step }.plain(), [0.1, 1e-3]);
    assert_held(&GaussLegendre4 { step }.plain(), [4e-6, 1e-8]);
    assert_held(&GaussLegendre6 { step }.plain(), [3e-10, 1e-10]);
}
