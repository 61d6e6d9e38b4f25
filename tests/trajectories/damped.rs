//! Stiff motions, whose fast components are damped, by Radau's method.
//!
//! `tools/stiff.py` computes the reference states.

use lagrange::integrate::{Method, Radau5, StepFailure, Stepper, Verner98, Work, integrate};
use lagrange::system::{MechanicalSystem, OdeSystem};

lagrange::system! {
    /// A point mass on a spring with a damper.
    #[derive(Clone, Debug)]
    pub(crate) struct ElasticPendulum<S>;

    param k = 1e8, c = 2e4, g = 9.81;
    coord r, theta;
    kinetic = 1/2 * (dot(r)^2 + r^2 * dot(theta)^2);
    potential = 1/2 * k * (r - 1)^2 - g * r * cos(theta);
    dissipation = 1/2 * c * dot(r)^2;
    emit { jacobian }
}

lagrange::system! {
    /// Van der Pol's oscillator with a pendulum attached.
    #[derive(Clone, Debug)]
    struct Relaxation;

    param mu = 100.0, g = 9.81;
    coord x, a;
    let (px, py) = (x + sin(a), -cos(a));
    kinetic = 1/2 * dot(x)^2 + 1/20 * (dot(px)^2 + dot(py)^2);
    potential = 1/2 * x^2 + 1/10 * g * py;
    force x = mu * (1 - x^2) * dot(x);
    emit { jacobian }
}

lagrange::system! {
    /// A ball that meets the ground with Hunt and Crossley's force.
    #[derive(Clone, Debug)]
    struct Bounce;

    param k = 1e8, c = 0.2, g = 9.81;
    coord x;
    let d = max(-x, 0);
    kinetic = 1/2 * dot(x)^2;
    potential = g * x;
    force x = k * d^(3/2) * (1 - 3/2 * c * dot(x));
    emit { jacobian }
}

lagrange::system! {
    /// A block pulled by a spring over ground with LuGre friction.
    #[derive(Clone, Debug)]
    struct StickSlip;

    param stiffness = 1e5, pull = 0.1;
    coord x;
    state z;
    let rate = dot(x) - stiffness * abs(dot(x)) / (1 + 1/2 * exp(-(dot(x) / 1e-3)^2)) * z;
    dot(z) = rate;
    kinetic = 1/2 * dot(x)^2;
    force x = 2 * (pull * t - x) - (stiffness * z + sqrt(stiffness) * rate + 2/5 * dot(x));
    emit { jacobian }
}

lagrange::system! {
    /// A mass on a rod, with another one attached by a stiff spring and a damper; without a
    /// Jacobian.
    #[derive(Clone, Debug)]
    struct Whip;

    param k = 1e7, c = 2e3, g = 9.81;
    coord px, pz, x, z;
    let length = hypot(x - px, z - pz);
    kinetic = 1/2 * (dot(px)^2 + dot(pz)^2 + dot(x)^2 + dot(z)^2);
    potential = g * (pz + z) + 1/2 * k * (length - 1)^2;
    dissipation = 1/2 * c * dot(length)^2;
    constraint rod = px^2 + pz^2 - 1;
}

/// Returns the states of a motion at the reference times.
fn references(motion: &str) -> Vec<(f64, Vec<f64>)> {
    let rows = include_str!("stiff_references.csv").lines().map(|line| line.split(',').collect::<Vec<_>>());
    let number = |text: &&str| text.parse::<f64>().expect("a number");
    let rows = rows.filter(|row| row[0] == motion);
    rows.map(|row| (number(&row[1]), row[2..].iter().map(number).collect())).collect()
}

/// Runs to all reference times, and checks that the error stays within ten tolerances relative to
/// `sizes` and the state.
#[track_caller]
pub(crate) fn assert_keeps<M, const N: usize>(
    system: &M,
    (motion, start, sizes): (&str, M::State, [f64; N]),
    compared: impl Fn(f64, &M::State) -> [f64; N],
    tolerances: &[f64],
) where
    M: MechanicalSystem<Scalar = f64>,
{
    let references = references(motion);
    assert!(!references.is_empty());
    for tolerance in tolerances {
        let smallest = sizes.iter().fold(1.0_f64, |least, size| least.min(*size));
        let method = Radau5 { absolute: smallest * tolerance, ..Radau5::tolerance(*tolerance) };
        for (time, reference) in &references {
            let end = integrate(system, 0.0, start, *time, &method, |_, _| {}).expect("goes on");
            for ((found, expected), size) in compared(*time, &end).iter().zip(reference).zip(sizes) {
                let error = (found - expected).abs() / (size + expected.abs());
                assert!(
                    error < 10.0 * tolerance,
                    "{motion} at {time}, {tolerance}: {found} {expected}, {error:e}"
                );
            }
        }
    }
}

pub(crate) const TOLERANCES: [f64; 3] = [1e-4, 1e-6, 1e-9];

#[test]
fn an_elastic_pendulum_keeps_its_tolerance() {
    let case = ("elastic_pendulum", [1.0, 1.0, 0.0, 0.0], [1.0; 4]);
    assert_keeps(&ElasticPendulum::default(), case, |_, y| *y, &TOLERANCES);
}

#[test]
fn a_relaxation_with_a_pendulum_keeps_its_tolerance() {
    let case = ("relaxation", [2.0, 0.5, 0.0, 0.0], [1.0; 4]);
    assert_keeps(&Relaxation::default(), case, |_, y| *y, &TOLERANCES);
}

lagrange::system! {
    /// Van der Pol's oscillator with the stiffness of the test set for initial value problems.
    #[derive(Clone, Debug)]
    struct VanDerPol;

    param epsilon = 1e-6;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2 / epsilon;
    force x = (1 - x^2) * dot(x) / epsilon;
    emit { jacobian }
}

/// Source: Mazzia and Magherini, *Test Set for Initial Value Problem Solvers*, 2.4, problem VDPOL.
#[test]
fn van_der_pols_oscillator_jumps_as_in_the_test_set() {
    let expected = [1.706_167_732_170_483, -0.892_809_701_024_797_5];
    for tolerance in TOLERANCES {
        let method = Radau5::tolerance(tolerance);
        let end =
            integrate(&VanDerPol::default(), 0.0, [2.0, 0.0], 2.0, &method, |_, _| {}).expect("goes on");
        for (found, expected) in end.iter().zip(expected) {
            assert!((found - expected).abs() < 10.0 * tolerance, "{tolerance}: {found} {expected}");
        }
    }
}

#[test]
fn a_bounce_on_a_compliant_ground_keeps_its_tolerance() {
    assert_keeps(&Bounce::default(), ("bounce", [0.5, 0.0], [1e-3, 1.0]), |_, y| *y, &TOLERANCES);
}

#[test]
fn stick_and_slip_keep_their_tolerance() {
    let case = ("stick_slip", [0.0; 3], [1.0, 1e-5, 1e-2]);
    assert_keeps(&StickSlip::default(), case, |t, [x, z, v]| [0.1 * t - x, *z, *v], &TOLERANCES);
}

#[test]
fn a_constrained_whip_keeps_its_tolerance_without_a_jacobian() {
    let (sine, cosine) = 1.0_f64.sin_cos();
    let case = ("whip", [sine, -cosine, sine, -cosine - 1.0, 0.0, 0.0, 0.0, 0.0], [1.0; 6]);
    let minimal = |_: f64, [px, pz, x, z, u, w, v_x, v_z]: &[f64; 8]| {
        [px.atan2(-pz), *x, *z, -pz * u + px * w, *v_x, *v_z]
    };
    assert_keeps(&Whip::default(), case, minimal, &TOLERANCES);
    let end =
        integrate(&Whip::default(), 0.0, case.1, 2.0, &Radau5::tolerance(1e-6), |_, _| {}).expect("goes on");
    assert!((end[0].hypot(end[1]) - 1.0).abs() < 1e-15 && (end[0] * end[4] + end[1] * end[5]).abs() < 1e-14);
}

/// Returns the work of a run to its end.
fn work<M: OdeSystem<Scalar = f64>>(system: &M, start: M::State, end: f64, tolerance: f64) -> Work {
    let mut stepper = Radau5::tolerance(tolerance).start(system, 0.0, &start, end).expect("starts");
    while stepper.time() < end {
        stepper.step(system, end).expect("goes on");
    }
    stepper.work()
}

#[test]
fn factors_and_jacobians_serve_many_steps() {
    let work = work(&ElasticPendulum::default(), [1.0, 1.0, 0.0, 0.0], 10.0, 1e-6);
    assert!(work.steps < 250 && work.evaluations < 2000, "{work:?}");
    assert!(work.jacobians < 20 && work.factorisations < work.steps, "{work:?}");
}

/// A system without its Jacobian.
#[derive(Clone, Debug)]
struct Opaque<M>(M);

impl<M: OdeSystem> OdeSystem for Opaque<M> {
    type Scalar = M::Scalar;
    type State = M::State;

    fn rhs(&self, t: M::Scalar, y: &M::State) -> M::State {
        self.0.rhs(t, y)
    }
}

#[test]
fn difference_quotients_take_the_place_of_a_jacobian() {
    let (start, pendulum) = ([1.0, 1.0, 0.0, 0.0], ElasticPendulum::default());
    let [known, unknown] = [work(&pendulum, start, 10.0, 1e-6), work(&Opaque(pendulum), start, 10.0, 1e-6)];
    assert!(unknown.evaluations < known.evaluations + 300, "{known:?} {unknown:?}");
}

/// ẏ = Q Λ Q⁻¹ (y − p(t)) + ṗ(t) with fast and slow eigenvalues, whose solution is y = p + Q e^(Λt)
/// Q⁻¹ (y₀ − p₀).
struct Linear {
    basis: [[f64; 4]; 4],
    values: [f64; 4],
}

impl Linear {
    fn random(seed: u64) -> Self {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        // A product of rotations, and eigenvalues from −0.1 to −1e7.
        let mut basis: [[f64; 4]; 4] =
            core::array::from_fn(|i| core::array::from_fn(|j| f64::from(u8::from(i == j))));
        for (i, j) in [(0, 1), (2, 3), (0, 2), (1, 3), (0, 3), (1, 2)] {
            let (sine, cosine) = (core::f64::consts::TAU * next()).sin_cos();
            for row in &mut basis {
                (row[i], row[j]) = (cosine * row[i] - sine * row[j], sine * row[i] + cosine * row[j]);
            }
        }
        Linear { basis, values: core::array::from_fn(|_| -10.0_f64.powf(8.0 * next() - 1.0)) }
    }

    fn path(t: f64) -> [[f64; 4]; 2] {
        let (sine, cosine) = t.sin_cos();
        [[sine, cosine, sine * cosine, 1.0], [cosine, -sine, cosine * cosine - sine * sine, 0.0]]
    }

    /// Returns Q f(Λ) Qᵀ x.
    fn apply(&self, function: impl Fn(f64) -> f64, x: &[f64; 4]) -> [f64; 4] {
        let inner: [f64; 4] = core::array::from_fn(|k| {
            function(self.values[k]) * (0..4).map(|i| self.basis[i][k] * x[i]).sum::<f64>()
        });
        core::array::from_fn(|i| (0..4).map(|k| self.basis[i][k] * inner[k]).sum())
    }
}

impl OdeSystem for Linear {
    type Scalar = f64;
    type State = [f64; 4];

    fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
        let [path, rate] = Linear::path(t);
        let change = self.apply(|value| value, &core::array::from_fn(|i| y[i] - path[i]));
        core::array::from_fn(|i| change[i] + rate[i])
    }
}

#[test]
fn random_stiff_systems_follow_their_closed_forms() {
    for seed in 0..300 {
        let (system, start, end) = (Linear::random(seed), [1.0, 2.0, 0.5, -0.5], 3.0);
        let away: [f64; 4] = core::array::from_fn(|i| start[i] - Linear::path(0.0)[0][i]);
        let left = system.apply(|value| (value * end).exp(), &away);
        for tolerance in TOLERANCES {
            let found = integrate(&system, 0.0, start, end, &Radau5::tolerance(tolerance), |_, _| {});
            let found = found.expect("goes on");
            for i in 0..4 {
                let expected = Linear::path(end)[0][i] + left[i];
                let error = (found[i] - expected).abs();
                assert!(error < 10.0 * tolerance, "{seed}, {tolerance}: {found:?} {expected}");
            }
        }
    }
}

lagrange::system! {
    /// Two point masses on massless rods.
    #[derive(Clone, Debug)]
    struct DoublePendulum<S>;

    param g = 9.81;
    coord a, b;
    let (xa, ya) = (sin(a), -cos(a));
    let (xb, yb) = (xa + sin(b), ya - cos(b));
    kinetic = 1/2 * (dot(xa)^2 + dot(ya)^2 + dot(xb)^2 + dot(yb)^2);
    potential = g * (ya + yb);
    emit { jacobian }
}

#[test]
fn errors_fall_with_the_fifth_power_of_steps() {
    let (system, start) = (DoublePendulum::<f64>::default(), [0.6, 0.4, 0.0, 0.0]);
    let exact = integrate(&system, 0.0, start, 2.0, &Verner98::tolerance(1e-14), |_, _| {}).expect("goes on");
    let run = |tolerance: f64| {
        let end =
            integrate(&system, 0.0, start, 2.0, &Radau5::tolerance(tolerance), |_, _| {}).expect("goes on");
        let error =
            end.iter().zip(exact).fold(0.0_f64, |most, (found, exact)| most.max((found - exact).abs()));
        (error, work(&system, start, 2.0, tolerance).steps as f64)
    };
    let ((coarse, few), (fine, many)) = (run(1e-6), run(1e-11));
    let order = (coarse / fine).ln() / (many / few).ln();
    assert!((4.5..5.5).contains(&order), "{order}: {coarse:e} in {few} steps, {fine:e} in {many}");
}

#[test]
fn a_resumed_motion_is_the_uninterrupted_one() {
    let (pendulum, start) = (ElasticPendulum::<f64>::default(), [1.0, 1.0, 0.0, 0.0]);
    for tolerance in TOLERANCES {
        let method = Radau5::tolerance(tolerance);
        let run = |from: f64, y: [f64; 4], to: f64| {
            integrate(&pendulum, from, y, to, &method, |_, _| {}).expect("goes on")
        };
        let (whole, parts) = (run(0.0, start, 6.0), run(2.5, run(0.0, start, 2.5), 6.0));
        for (whole, parts) in whole.iter().zip(parts) {
            assert!((whole - parts).abs() < 10.0 * tolerance, "{tolerance}: {whole} {parts}");
        }
    }
}

#[test]
fn resting_states_stay_and_zeros_stay_zeros() {
    let pendulum = ElasticPendulum { g: 0.0, ..ElasticPendulum::<f64>::default() };
    let rest = [1.0, 0.0, 0.0, 0.0];
    assert_eq!(integrate(&pendulum, 0.0, rest, 1e6, &Radau5::tolerance(1e-9), |_, _| {}), Ok(rest));
    // Only the radius moves.
    let end =
        integrate(&ElasticPendulum::<f64>::default(), 0.0, rest, 1.0, &Radau5::tolerance(1e-9), |_, _| {});
    let [r, theta, _, rate] = end.expect("goes on");
    assert_eq!((theta, rate), (0.0, 0.0));
    assert!((r - 1.0 - 9.81e-8).abs() < 1e-10, "{r}");
}

#[test]
fn motions_run_backwards() {
    let (system, start) = (DoublePendulum::<f64>::default(), [0.6, 0.4, 0.0, 0.0]);
    let method = Radau5::tolerance(1e-9);
    let there = integrate(&system, 0.0, start, 2.0, &method, |_, _| {}).expect("goes on");
    let back = integrate(&system, 2.0, there, 0.0, &method, |_, _| {}).expect("goes on");
    for (back, start) in back.iter().zip(start) {
        assert!((back - start).abs() < 1e-8, "{back} {start}");
    }
}

#[test]
fn single_precision_keeps_its_tolerance() {
    let (reference, start) = (&references("elastic_pendulum")[0], [1.0_f32, 1.0, 0.0, 0.0]);
    let pendulum = ElasticPendulum::<f32>::default();
    for tolerance in [1e-3_f32, 1e-4] {
        let end =
            integrate(&pendulum, 0.0, start, 1.0, &Radau5::tolerance(tolerance), |_, _| {}).expect("goes on");
        for (found, expected) in end.iter().zip(&reference.1) {
            let error = (f64::from(*found) - expected).abs() / (1.0 + expected.abs());
            assert!(error < 10.0 * f64::from(tolerance), "{tolerance}: {found} {expected}");
        }
    }
}

#[test]
fn limits_and_faults_end_a_run_with_the_last_good_state() {
    let (pendulum, start) = (ElasticPendulum::<f64>::default(), [1.0, 1.0, 0.0, 0.0]);
    let few = Radau5 { max_steps: 20, ..Radau5::tolerance(1e-9) };
    let error = integrate(&pendulum, 0.0, start, 10.0, &few, |_, _| {}).expect_err("too many");
    assert_eq!(error.cause, StepFailure::TooManySteps { limit: 20 });
    assert!(error.time > 0.0 && error.state.iter().all(|entry| entry.is_finite()), "{error:?}");

    /// ẏ = y², infinite at t = 1
    struct Singular;
    impl OdeSystem for Singular {
        type Scalar = f64;
        type State = [f64; 1];

        fn rhs(&self, _t: f64, [y]: &[f64; 1]) -> [f64; 1] {
            [y * y]
        }
    }
    let error =
        integrate(&Singular, 0.0, [1.0], 2.0, &Radau5::tolerance(1e-6), |_, _| {}).expect_err("singular");
    assert!((error.time - 1.0).abs() < 1e-5 && error.state[0].is_finite(), "{error:?}");

    let undefined = Radau5 { relative: f64::NAN, ..Radau5::tolerance(1e-6) };
    assert!(integrate(&pendulum, 0.0, start, 1.0, &undefined, |_, _| {}).is_err());
    let start = [f64::NAN, 1.0, 0.0, 0.0];
    assert!(integrate(&pendulum, 0.0, start, 1.0, &Radau5::tolerance(1e-6), |_, _| {}).is_err());
}
