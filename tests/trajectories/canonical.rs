//! Methods in coordinates and momenta over millions of steps, where the mass matrix depends on the
//! coordinates.

use lagrange::integrate::{GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, Variational, integrate};
use lagrange::system::{CanonicalSystem, EnergyFunction, OdeSystem, split};

use crate::drift::{Line, assert_bounded, line};

lagrange::system! {
    /// Two unit masses on unit rods.
    #[derive(Clone, Debug)]
    pub(crate) struct DoublePendulum;

    emit { jacobian, momentum_rates }
    param g = 9.81;
    coord a, b;
    kinetic = dot(a)^2 + 1/2 * dot(b)^2 + dot(a) * dot(b) * cos(a - b);
    potential = -g * (2 * cos(a) + cos(b));
}

lagrange::system! {
    /// A symmetric top about a fixed point.
    #[derive(Clone, Debug)]
    pub(crate) struct Top;

    emit { jacobian, momentum_rates }
    param i1 = 0.12, i3 = 0.05, weight = 2.7;
    coord phi, theta, psi;
    kinetic = 1/2 * i1 * (dot(theta)^2 + dot(phi)^2 * sin(theta)^2) + 1/2 * i3 * (dot(psi) + dot(phi) * cos(theta))^2;
    potential = weight * cos(theta);
}

lagrange::system! {
    /// A point mass on a spring that rotates about its pivot, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    pub(crate) struct Swing;

    emit { momentum_rates }
    param k = 3.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 1/2 * k * (hypot(x, y) - 1)^2;
}

lagrange::system! {
    /// A point mass on a spring that is nearly a rod.
    #[derive(Clone, Debug)]
    pub(crate) struct StiffPendulum;

    param k = 1e9, g = 9.81;
    coord r, theta;
    kinetic = 1/2 * (dot(r)^2 + (r * dot(theta))^2);
    potential = 1/2 * k * (r - 1)^2 - g * r * cos(theta);
    emit { jacobian, momentum_rates }
}

/// One in this many states is recorded.
const INTERVAL: u32 = 1009;

/// Returns the error of the energy over time, and the largest error of each momentum, relative
/// unless it was zero.
fn errors<M, K>(system: &M, start: M::State, step: f64, steps: u32, method: &K) -> (Line, Vec<f64>)
where
    M: OdeSystem<Scalar = f64> + CanonicalSystem + EnergyFunction,
    K: Method<M>,
{
    let watched = |t: f64, y: &M::State| {
        let (q, v) = split::<M>(y);
        (system.energy(t, &q, &v), CanonicalSystem::momenta(system, t, &q, &v))
    };
    let (energy, momenta) = watched(0.0, &start);
    let (mut count, mut points) = (0, Vec::new());
    let mut changes = vec![0.0_f64; momenta.as_ref().len()];
    integrate(system, 0.0, start, f64::from(steps) * step, method, |t, y| {
        if count % INTERVAL == 0 {
            let now = watched(t, y);
            points.push((t, now.0 - energy));
            for ((change, now), before) in changes.iter_mut().zip(now.1.as_ref()).zip(momenta.as_ref()) {
                let scale = if *before == 0.0 { 1.0 } else { before.abs() };
                *change = change.max((now - before).abs() / scale);
            }
        }
        count += 1;
    })
    .expect("converges");
    let line = line(&points);
    println!("{}, h = {step}: {line:?}, momenta {changes:?}", method.name());
    (line, changes)
}

const MILLION: u32 = 1_000_000;

#[test]
fn the_energy_of_a_double_pendulum_does_not_drift() {
    let (pendulum, start, step) = (DoublePendulum::default(), [0.5, 0.8, 0.0, 0.0], 0.01);
    assert_bounded(&errors(&pendulum, start, step, MILLION, &ImplicitMidpoint { step }).0, 2e-3);
    assert_bounded(&errors(&pendulum, start, step, 10 * MILLION, &GaussLegendre4 { step }).0, 1e-7);
    assert_bounded(&errors(&pendulum, start, step, MILLION, &Variational { step }).0, 1e-7);
    // In shorter steps the random walk of rounding errors would be visible.
    let step = 0.05;
    assert_bounded(&errors(&pendulum, start, step, MILLION, &GaussLegendre6 { step }).0, 1e-7);
}

#[test]
fn a_top_keeps_its_energy_and_its_cyclic_momenta() {
    let (top, start, step) = (Top::default(), [0.1, 0.6, 0.0, 1.0, 0.2, 30.0], 0.005);
    let check = |(line, momenta): (Line, Vec<f64>), bound: f64| {
        assert_bounded(&line, bound);
        assert!(momenta[0] < 1e-15 && momenta[2] < 1e-15, "{momenta:?}");
    };
    check(errors(&top, start, step, MILLION, &GaussLegendre4 { step }), 1e-8);
    check(errors(&top, start, step, 10 * MILLION, &Variational { step }), 1e-8);
    let step = 0.03;
    check(errors(&top, start, step, MILLION, &GaussLegendre6 { step }), 1e-8);
}

/// A fast top stands upright although its weight would make it fall: it sleeps.
#[test]
fn a_fast_top_sleeps() {
    let (top, step) = (Top::default(), 0.002);
    // Stable above spin² i3² = 4 weight i1.
    let limit = (4.0 * top.weight * top.i1).sqrt() / top.i3;
    let start = [0.0, 1e-3, 0.0, 0.0, 0.0, 1.2 * limit];
    let mut highest = 0.0_f64;
    integrate(&top, 0.0, start, 200.0, &GaussLegendre6 { step }, |_, y| highest = highest.max(y[1].abs()))
        .expect("converges");
    println!("largest inclination {highest:e}");
    assert!(highest < 5e-3, "{highest:e}");
}

/// It is quadratic in coordinates and momenta.
#[test]
fn angular_momentum_in_cartesian_coordinates_is_kept() {
    const STEP: f64 = 0.02;
    fn change(method: &impl Method<Swing>) -> f64 {
        let (start, end) = ([1.2, 0.0, 0.2, 0.7], f64::from(2 * MILLION) * STEP);
        let momentum = |y: &[f64; 4]| y[0] * y[3] - y[1] * y[2];
        let mut largest = 0.0_f64;
        integrate(&Swing::default(), 0.0, start, end, method, |_, y| {
            largest = largest.max((momentum(y) / momentum(&start) - 1.0).abs());
        })
        .expect("converges");
        println!("{}: angular momentum {largest:e}", method.name());
        largest
    }
    let (gauss, variational) = (change(&GaussLegendre4 { step: STEP }), change(&Variational { step: STEP }));
    assert!(gauss < 1e-13 && variational < 1e-13, "{gauss:e} {variational:e}");
}

/// A step is fifty periods of the spring. The derived Jacobian makes the methods stable; they
/// conserve the energy and leave the spring at its length.
#[test]
fn a_stiff_spring_does_not_limit_steps() {
    fn check(method: &impl Method<StiffPendulum>) {
        let pendulum = StiffPendulum::default();
        let start = [1.0 + pendulum.g * 0.5_f64.cos() / pendulum.k, 0.5, 0.0, 0.0];
        let energy = |[r, theta, u, w]: [f64; 4]| pendulum.energy(0.0, &[r, theta], &[u, w]);
        let (mut stretch, mut error) = (0.0_f64, 0.0_f64);
        integrate(&pendulum, 0.0, start, 1000.0, method, |_, y| {
            stretch = stretch.max((y[0] - 1.0).abs());
            error = error.max((energy(*y) - energy(start)).abs());
        })
        .expect("converges");
        println!("{}: stretch {stretch:e}, energy error {error:e}", method.name());
        assert!(stretch < 1e-7 && error < 1e-4, "{stretch:e} {error:e}");
    }
    let step = 0.01;
    check(&ImplicitMidpoint { step });
    check(&GaussLegendre4 { step });
    check(&GaussLegendre6 { step });
}
