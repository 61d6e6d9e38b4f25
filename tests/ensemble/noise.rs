//! White noise held for a period: statistics, order of convergence, and bits.

use lagrange::Ensembles;
use lagrange::Simulate;
use lagrange::ensemble::Random;
use lagrange::integrate::RungeKutta4;

lagrange::system! {
    /// A particle in a liquid, whose velocity is an Ornstein–Uhlenbeck process.
    #[derive(Clone, Debug)]
    struct Particle;

    param m = 1, c = 1;
    coord x;
    start dot(x) = 1.5;
    input w;
    kinetic = 1/2 * m * dot(x)^2;
    dissipation = 1/2 * c * dot(x)^2;
    force x = w;
}

lagrange::system! {
    /// Growth at a random rate, with the state as a factor.
    #[derive(Clone, Debug)]
    struct Growth;

    coord x;
    state size = 1;
    input w;
    kinetic = 1/2 * dot(x)^2;
    dot(size) = size * w;
}

/// The spectral density of the force.
const DENSITY: f64 = 0.8;

/// Returns the white noise of the motion `index`.
fn noise(index: usize, period: f64) -> impl FnMut(&Particle, f64, ParticleState) -> ParticleInputs {
    let mut random = Random::noise(11, index);
    move |_, _, _| ParticleInputs { w: random.white(DENSITY, period) }
}

/// Returns the variance of the velocity at a time after a known start: σ² (1 − e^(−2at)) / 2a.
fn variance(t: f64) -> f64 {
    0.5 * DENSITY * (1.0 - (-2.0 * t).exp())
}

/// Means, variances and the covariance at two times are those of the process (Gardiner,
/// *Stochastic Methods*, 4th ed., §3.8.4), within three standard errors.
#[test]
fn statistics_are_those_of_ornstein_and_uhlenbeck() {
    const MOTIONS: usize = 4000;
    let (period, particle) = (0.125, Particle::default());
    let ensemble =
        particle.ensemble(MOTIONS).start(|_, _| [0.0, 1.5]).until(3.0).method(RungeKutta4 { step: period });
    let samples = ensemble.sampled(period, |i| noise(i, period)).every(1.0).run().expect("runs");
    let at = |sample: usize| {
        (0..MOTIONS)
            .map(|i| samples.motion(i).expect("is kept").expect("moves").x_dot()[sample])
            .collect::<Vec<_>>()
    };
    let (one, other) = (at(2), at(3));
    let number = MOTIONS as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / number;
    let about = |values: &[f64]| values.iter().map(|value| value - mean(values)).collect::<Vec<_>>();
    let covariance = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / (number - 1.0);
    for (values, t) in [(&one, 2.0_f64), (&other, 3.0)] {
        let deviations = about(values);
        let (error, exact) = (mean(values) - 1.5 * (-t).exp(), variance(t));
        assert!(error.abs() < 3.0 * (exact / number).sqrt(), "mean at {t}: {error}");
        let error = covariance(&deviations, &deviations) - exact;
        assert!(error.abs() < 3.0 * exact * (2.0 / number).sqrt(), "variance at {t}: {error}");
    }
    let exact = (-1.0_f64).exp() * variance(2.0);
    let spread = (variance(2.0) * variance(3.0) + exact * exact) / number;
    let error = covariance(&about(&one), &about(&other)) - exact;
    assert!(error.abs() < 3.0 * spread.sqrt(), "covariance: {error}");
}

#[test]
fn noise_has_the_same_bits_on_any_number_of_threads() {
    let particle = Particle::default();
    let ends = |threads| {
        let ensemble = particle.ensemble(200).start(|_, _| [0.0, 1.5]).until(1.0).threads(threads);
        ensemble.sampled(0.125, |i| noise(i, 0.125)).run().expect("runs")
    };
    let (one, three) = (ends(1), ends(3));
    assert_eq!(one.x_dot(), three.x_dot());
    let alone =
        particle.simulate(particle.start()).until(1.0).sampled(0.125, noise(150, 0.125)).run().expect("runs");
    assert_eq!(alone.last()[1], one.x_dot()[150]);
}

/// Returns the velocity at the end of a run with these values of noise, each held for an equal
/// part.
fn end(values: Vec<f64>, duration: f64) -> f64 {
    let period = duration / values.len() as f64;
    let mut values = values.into_iter();
    let particle = Particle::default();
    let held =
        move |_: &Particle, _: f64, _: ParticleState| ParticleInputs { w: values.next().unwrap_or(f64::NAN) };
    let run = particle
        .simulate([0.0, 0.0])
        .until(duration)
        .method(RungeKutta4 { step: period })
        .sampled(period, held);
    run.ends_only().run().expect("runs").last()[1]
}

/// Means of motions converge with the second power of the period. The variance of a linear system
/// is the sum of the squares of its responses to single values, so no random numbers are needed.
#[test]
fn variances_converge_with_order_two() {
    let error = |periods: usize| {
        let response = |k: usize| end((0..periods).map(|i| f64::from(u8::from(i == k))).collect(), 2.0);
        let squares = (0..periods).map(|k| response(k).powi(2)).sum::<f64>();
        squares * DENSITY * periods as f64 / 2.0 - variance(2.0)
    };
    let errors = [4, 8, 16].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{errors:?}");
    }
}

/// Single motions converge with the first power. A motion with the means of finer noise is compared
/// with that of the finer noise itself.
#[test]
fn motions_converge_with_order_one() {
    const FINE: usize = 512;
    let error = |periods: usize| {
        let squares = (0..60).map(|index| {
            let mut random = Random::noise(5, index);
            let fine = (0..FINE).map(|_| random.white(DENSITY, 2.0 / FINE as f64)).collect::<Vec<_>>();
            let means = fine.chunks(FINE / periods).map(|part| part.iter().sum::<f64>() / part.len() as f64);
            (end(means.collect(), 2.0) - end(fine.clone(), 2.0)).powi(2)
        });
        (squares.sum::<f64>() / 60.0).sqrt()
    };
    let errors = [8, 16, 32].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 1.0).abs() < 0.2, "{errors:?}");
    }
}

/// With a factor that depends on the state, the limit is in the sense of Stratonovich: x = e^W, and
/// not e^(W − t/2).
#[test]
fn the_limit_is_that_of_stratonovich() {
    let growth = Growth::default();
    let (mut random, mut integral) = (Random::noise(3, 0), 0.0);
    let held = |_: &Growth, _: f64, _: GrowthState| {
        let w = random.white(1.0, 0.01);
        integral += 0.01 * w;
        GrowthInputs { w }
    };
    let run =
        growth.simulate(growth.start()).until(1.0).tolerance(1e-12).sampled(0.01, held).ends_only().run();
    let size = GrowthState::from(run.expect("runs").last()).size;
    assert!((size / integral.exp() - 1.0).abs() < 1e-9, "{size} {integral}");
}
