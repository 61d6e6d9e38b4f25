//! Declared white noise: statistics against closed forms, orders along one path, and bits.

use lagrange::ensemble::{Moments, Shard};
use lagrange::integrate::{EulerMaruyama, Method, StochasticRungeKutta4, WienerPath, integrate};
use lagrange::system::{NoiseKind, OdeSystem};
use lagrange::{Ensembles, Simulate};

lagrange::system! {
    /// A particle in a liquid, whose velocity is an Ornstein–Uhlenbeck process.
    #[derive(Clone, Debug)]
    struct Particle;

    param m: kg = 2, c: N*s/m = 1, density: N^2*s = 0.8;
    coord x: m;
    start dot(x) = 1.5 [m/s];
    noise w: N, density: density;
    kinetic = 1/2 * m * dot(x)^2;
    dissipation = 1/2 * c * dot(x)^2;
    force x = w;
}

lagrange::system! {
    /// A particle on a spring in a liquid of temperature kT.
    #[derive(Clone, Debug)]
    struct Trapped;

    param m: kg = 1, k: N/m = 4, c: N*s/m = 1, kT: J = 0.5;
    coord x: m;
    noise w: N, density: 2 * c * kT;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * c * dot(x)^2;
    force x = w;
}

lagrange::system! {
    /// A state in a double well, with noise whose magnitude depends on time.
    #[derive(Clone, Debug)]
    struct Well;

    param size = 0.4;
    state z = 0.5;
    noise w, density: size^2;
    dot(z) = z - z^3 + (1 + t / 2) * w;
}

lagrange::system! {
    /// A pendulum on a shaken cart: the effect of the noise depends on the angle.
    #[derive(Clone, Debug)]
    struct Shaken;

    param size = 1;
    coord x, theta;
    noise push, density: size^2;
    noise twist, density: size^2 / 4;
    let (px, py) = (x + sin(theta), -cos(theta));
    kinetic = 1/2 * dot(x)^2 + 1/2 * (dot(px)^2 + dot(py)^2);
    potential = 5 * py + x^2;
    dissipation = 1/4 * dot(x)^2;
    force x = push;
    force theta = twist;
}

lagrange::system! {
    /// Growth at a random rate, with the state as a factor.
    #[derive(Clone, Debug)]
    struct Growth;

    param supply = 0;
    state size = 1;
    noise w, density: 0.25;
    dot(size) = supply - size / 4 + size * w;
}

lagrange::system! {
    /// Kubo's oscillator: its frequency is noisy, and its amplitude constant.
    #[derive(Clone, Debug)]
    struct Kubo;

    state a = 1, b;
    noise w, density: 0.5;
    dot(a) = -(2 + w) * b;
    dot(b) = (2 + w) * a;
}

const DURATION: f64 = 2.0;

fn euler(step: f64, path: WienerPath) -> EulerMaruyama<f64> {
    EulerMaruyama { step, path }
}

fn runge_kutta(step: f64, path: WienerPath) -> StochasticRungeKutta4<f64> {
    StochasticRungeKutta4 { step, path }
}

/// Returns the end of a motion with steps of 1/4 that are halved several times, as is its path.
fn end<M: OdeSystem<Scalar = f64>, K: Method<M>>(
    (system, start): (&M, M::State),
    halvings: u32,
    motion: usize,
    method: fn(f64, WienerPath) -> K,
) -> M::State {
    let (step, path) = (0.25 / f64::from(1 << halvings), WienerPath::of_seed(3).of_motion(motion));
    let method = method(step, path.halved(halvings));
    integrate(system, 0.0, start, DURATION, &method, |_, _| {}).expect("moves")
}

/// Returns the root mean square of errors after two, three and four halvings, along the paths of
/// 100 motions. The reference ends have steps halved twice more.
fn errors<M: OdeSystem<Scalar = f64>, K: Method<M>>(
    system: (&M, M::State),
    method: fn(f64, WienerPath) -> K,
) -> [f64; 3] {
    let mut squares = [0.0; 3];
    for motion in 0..100 {
        let exact = end(system, 7, motion, runge_kutta);
        for (square, halvings) in squares.iter_mut().zip(2..) {
            let found = end(system, halvings, motion, method);
            let distance = |(a, b): (&f64, &f64)| (a - b).powi(2);
            *square += exact.as_ref().iter().zip(found.as_ref()).map(distance).sum::<f64>() / 100.0;
        }
    }
    squares.map(f64::sqrt)
}

/// Asserts the strong order between the longest and the shortest steps.
fn assert_order<M: OdeSystem<Scalar = f64>, K: Method<M>>(
    system: (&M, M::State),
    method: fn(f64, WienerPath) -> K,
    order: f64,
) {
    let errors = errors(system, method);
    let found = (errors[0] / errors[2]).log2() / 2.0;
    assert!((found - order).abs() < 0.25, "{found} from {errors:?}");
}

#[test]
fn additive_noise_has_the_strong_orders_one_and_three_halves() {
    let well = Well::default();
    assert_eq!(well.noise().kind, NoiseKind::Additive);
    assert_order((&well, [0.5]), euler, 1.0);
    assert_order((&well, [0.5]), runge_kutta, 1.5);
    // For linear equations only the error ε h² remains.
    let particle = Particle::default();
    assert_order((&particle, [0.0, 1.5]), euler, 1.0);
    assert_order((&particle, [0.0, 1.5]), runge_kutta, 2.0);
}

#[test]
fn noise_whose_size_depends_on_positions_has_the_strong_order_one() {
    let shaken = Shaken::default();
    assert_eq!(shaken.noise().kind, NoiseKind::Unambiguous);
    assert_order((&shaken, [0.0, 0.5, 0.0, 0.0]), euler, 1.0);
    assert_order((&shaken, [0.0, 0.5, 0.0, 0.0]), runge_kutta, 1.0);
}

#[test]
fn noise_that_drives_what_its_size_depends_on_has_the_strong_order_one() {
    let growth = Growth { supply: 1.0 };
    assert_eq!(growth.noise().kind, NoiseKind::Multiplicative);
    assert_order((&growth, [1.0]), runge_kutta, 1.0);
}

/// O(h⁴ + ε h² + ε² h^{3/2}): with weak noise the fourth power dominates first, then the second.
#[test]
fn small_noise_leaves_the_order_of_the_equations() {
    let order = |size| {
        let errors = errors((&Well { size }, [0.5]), runge_kutta);
        (errors[0] / errors[1]).log2()
    };
    let [tiny, small] = [1e-7, 1e-3].map(order);
    assert!((tiny - 4.0).abs() < 0.35 && (small - 2.0).abs() < 0.3, "{tiny} {small}");
}

/// d/dt size = −size/4 + size ∘ w leads to e^(W/2 − t/4), and Kubo's oscillator to e^i(2t + W/√2),
/// both in the sense of Stratonovich.
#[test]
fn multiplicative_noise_is_that_of_stratonovich() {
    for motion in 0..20 {
        let path = WienerPath::of_seed(3).of_motion(motion).halved(6);
        let method = runge_kutta(0.25 / 64.0, path);
        let free = Particle { m: 1.0, c: 0.0, density: 1.0 };
        let [_, w] = end((&free, [0.0, 0.0]), 6, motion, euler);
        let size = integrate(&Growth::default(), 0.0, [1.0], DURATION, &method, |_, _| {}).expect("grows")[0];
        assert!((size / (w / 2.0 - DURATION / 4.0).exp() - 1.0).abs() < 1e-6, "{size}");
        let [a, b] = integrate(&Kubo, 0.0, [1.0, 0.0], DURATION, &method, |_, _| {}).expect("turns");
        let (sin, cos) = (2.0 * DURATION + 0.5_f64.sqrt() * w).sin_cos();
        assert!((a - cos).hypot(b - sin) < 1e-5 && (a.hypot(b) - 1.0).abs() < 1e-5, "{a} {b}");
    }
}

/// Means, variances and the covariance at two times are those of the process (Gardiner,
/// *Stochastic Methods*, 4th ed., §3.8.4), within three standard errors.
#[test]
fn statistics_are_those_of_ornstein_and_uhlenbeck() {
    const MOTIONS: usize = 4000;
    let particle = Particle::default();
    let ensemble = particle.ensemble(MOTIONS).start(|_, _| [0.0, 1.5]).until(3.0);
    let sums = ensemble.method(runge_kutta(0.125, WienerPath::of_seed(11))).every(1.0);
    let sums = sums.reduce([Moments::new(); 5], |[one, other, squares, more, products], motion| {
        let [a, b] = [2, 3].map(|sample| motion.trajectory().x_dot()[sample]);
        let [p, q] = [(a, 2.0_f64), (b, 3.0)].map(|(v, t)| v - 1.5 * (-t / 2.0).exp());
        one.add(p);
        other.add(q);
        squares.add(p * p);
        more.add(q * q);
        products.add(p * q);
    });
    let sums = sums.expect("runs").into_value().map(|moments| moments.mean());
    // The relaxation rate is a = c/m, and the noise of the velocity has the density S/m².
    let variance = |t: f64| 0.8 / 4.0 * (1.0 - (-t).exp());
    let (number, covariance) = (MOTIONS as f64, (-0.5_f64).exp() * variance(2.0));
    let within = |found: f64, exact: f64, spread: f64| {
        assert!((found - exact).abs() < 3.0 * (spread / number).sqrt(), "{found}, not {exact}");
    };
    within(sums[0], 0.0, variance(2.0));
    within(sums[1], 0.0, variance(3.0));
    within(sums[2], variance(2.0), 2.0 * variance(2.0).powi(2));
    within(sums[3], variance(3.0), 2.0 * variance(3.0).powi(2));
    within(sums[4], covariance, variance(2.0) * variance(3.0) + covariance.powi(2));
}

/// Equipartition: both energies average to kT/2 within three standard errors, along one long motion
/// and over many.
#[test]
fn energies_are_distributed_equally() {
    let trapped = Trapped::default();
    let ensemble = trapped.ensemble(2000).start(|_, _| [0.0, 0.0]).until(12.0);
    let squares = ensemble.method(runge_kutta(0.125, WienerPath::of_seed(7))).reduce(
        [Moments::new(); 2],
        |[x, v], motion| {
            x.add(motion.end().x.powi(2));
            v.add(motion.end().x_dot.powi(2));
        },
    );
    let [x, v] = squares.expect("runs").into_value();
    let error = 3.0 * 0.5 * (2.0_f64 / 2000.0).sqrt();
    assert!((4.0 * x.mean() - 0.5).abs() < error && (v.mean() - 0.5).abs() < error, "{x:?} {v:?}");
}

#[test]
fn bits_depend_on_seed_and_index_alone() {
    let shaken = Shaken::default();
    let ensemble = || {
        let motions = shaken.ensemble(200).start(|i, _| [0.0, 0.01 * i as f64, 0.0, 0.0]).until(1.0);
        motions.method(euler(0.05, WienerPath::of_seed(5))).motions_per_part(16)
    };
    let [one, three] = [1, 3].map(|threads| ensemble().threads(threads).run().expect("runs"));
    assert_eq!(one.theta_dot(), three.theta_dot());
    let mut sharded = Vec::new();
    for index in 0..3 {
        let part = ensemble().shard(Shard::of(index, 3)).reduce(Vec::new(), |list: &mut Vec<_>, motion| {
            list.push((motion.index(), motion.end().theta_dot.to_bits()));
        });
        sharded.extend(part.expect("runs").into_value());
    }
    sharded.sort_unstable();
    assert!(sharded.iter().all(|&(index, bits)| one.theta_dot()[index].to_bits() == bits));
    assert_eq!(sharded.len(), 200);
    let alone = shaken.simulate([0.0, 0.01 * 150.0, 0.0, 0.0]).until(1.0);
    let alone = alone.method(euler(0.05, WienerPath::of_seed(5).of_motion(150))).run().expect("runs");
    assert_eq!(Some(alone.last()), one.state(150));
    assert_ne!(one.theta_dot()[1], one.theta_dot()[2]);
}

/// Returns the message of a run that fails.
fn failure<K: Method<Particle>>(particle: &Particle, method: &K) -> String {
    let run = integrate(particle, 0.0, [0.0, 1.5], 1.0, method, |_, _| {});
    run.expect_err("does not run").to_string()
}

#[test]
fn unsuitable_systems_are_refused() {
    let particle = Particle::default();
    let by_default = particle.simulate([0.0, 1.5]).until(1.0).run().map(drop).expect_err("has noise");
    assert!(by_default.to_string().contains("`EulerMaruyama` and `StochasticRungeKutta4`"), "{by_default}");
    let verner = failure(&particle, &lagrange::integrate::Verner98::tolerance(1e-6));
    assert!(verner.contains("`EulerMaruyama` and `StochasticRungeKutta4`"), "{verner}");
    let negative = Particle { density: -0.1, ..particle.clone() };
    let said = failure(&negative, &euler(0.1, WienerPath::of_seed(1)));
    assert!(said.contains("is the density of a noise negative here?"), "{said}");
    // Without a density there is no noise.
    let silent = Particle { density: 0.0, ..particle };
    let method = runge_kutta(0.01, WienerPath::of_seed(1));
    let [_, v] = integrate(&silent, 0.0, [0.0, 1.5], 1.0, &method, |_, _| {}).expect("runs");
    assert!((v - 1.5 * (-0.5_f64).exp()).abs() < 1e-11);
}
