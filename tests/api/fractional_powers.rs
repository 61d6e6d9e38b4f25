//! Fractional powers, roots and logarithms of switching expressions: runs pass through zero by
//! every method.

use lagrange::Simulate;
use lagrange::integrate::{
    BlanesMoan4, GaussLegendre4, ImplicitMidpoint, Method, RungeKutta4, StepFailure, StormerVerlet, integrate,
};

lagrange::system! {
    /// A bead in a valley |x|ᵖ/p.
    #[derive(Clone, Debug)]
    struct Valley<S>;

    param p = 1.5;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = abs(x)^p / p;
    emit { momentum_rates, jacobian }
}

/// Exponents p with the period from x = 1, 4 √(p/2)/p B(1/p, 1/2).
const PERIODS: [(f64, f64); 7] = [
    (1.2, 5.784952839677329),
    (1.5, 5.974673601777493),
    (1.7, 6.099288659794053),
    (2.0, 6.283185307179585),
    (2.5, 6.581363388638263),
    (3.0, 6.869261369017643),
    (4.7, 7.778663707327922),
];

fn after_a_period<K: Method<Valley<f64>>>(p: f64, period: f64, method: &K) -> f64 {
    let end = integrate(&Valley { p, ..Valley::default() }, 0.0, [1.0, 0.0], period, method, |_, _| {});
    let [x, v] = end.unwrap_or_else(|error| panic!("{p}: {error}"));
    (x - 1.0).abs() + v.abs()
}

#[test]
fn valleys_of_every_power_are_crossed_in_their_period_by_every_method() {
    for (p, period) in PERIODS {
        let valley = Valley { p, ..Valley::default() };
        for tolerance in [1e-5, 1e-8, 1e-11] {
            let run = valley.simulate([1.0, 0.0]).until(period).tolerance(tolerance).run().unwrap();
            let error = (run.last()[0] - 1.0).abs() + run.last()[1].abs();
            assert!(error < 300.0 * tolerance, "{p}, {tolerance}: {error:e}");
        }
        let step = period / 1000.0;
        let errors = [
            after_a_period(p, period, &RungeKutta4 { step }),
            after_a_period(p, period, &GaussLegendre4 { step }),
            after_a_period(p, period, &GaussLegendre4 { step }.plain()),
            after_a_period(p, period, &ImplicitMidpoint { step }),
            after_a_period(p, period, &StormerVerlet { step }),
            after_a_period(p, period, &BlanesMoan4 { step }),
        ];
        // The slope of a force |x|^(1/5) is infinite at zero: a step across it has an error of at
        // least h^(6/5).
        let allowed = if p < 2.0 { 2e-3 } else { 1e-4 };
        assert!(errors.iter().all(|error| *error < allowed), "{p}: {errors:?}");
    }
}

#[test]
fn valleys_are_crossed_in_single_precision_too() {
    for (p, period) in PERIODS {
        let valley = Valley::<f32> { p: p as f32, ..Valley::default() };
        let run = valley.simulate([1.0, 0.0]).until(period as f32).tolerance(1e-5).run().unwrap();
        assert!((run.last()[0] - 1.0).abs() < 3e-4, "{p}: {:?}", run.last());
        let method = RungeKutta4 { step: 0.03125 };
        let fixed = valley.simulate([1.0, 0.0]).until(period as f32).method(method).run().unwrap();
        assert!((fixed.last()[0] - 1.0).abs() < 1e-2, "{p}: {:?}", fixed.last());
    }
}

lagrange::system! {
    /// The valley by its force x |x|ⁿ⁻¹, whose factors are 0 and infinite in the middle for n below
    /// one.
    #[derive(Clone, Debug)]
    struct Pulled<S>;

    param n = 0.5;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = -x * abs(x)^(n - 1);
}

#[test]
fn forces_with_a_power_below_one_are_crossed_in_their_period() {
    for (p, period) in PERIODS {
        let pulled = Pulled::<f64> { n: p - 1.0, ..Pulled::default() };
        for tolerance in [1e-5, 1e-8, 1e-11] {
            let run = pulled.simulate([1.0, 0.0]).until(period).tolerance(tolerance).run().unwrap();
            let error = (run.last()[0] - 1.0).abs() + run.last()[1].abs();
            assert!(error < 300.0 * tolerance, "{p}, {tolerance}: {error:e}");
        }
        let method = RungeKutta4 { step: period / 1000.0 };
        let fixed = pulled.simulate([1.0, 0.0]).until(period).method(method).run().unwrap();
        assert!((fixed.last()[0] - 1.0).abs() < 2e-3, "{p}: {:?}", fixed.last());
        let single = Pulled::<f32> { n: p as f32 - 1.0, ..Pulled::default() };
        let run = single.simulate([1.0, 0.0]).until(period as f32).tolerance(1e-5).run().unwrap();
        assert!((run.last()[0] - 1.0).abs() < 3e-4, "{p}: {:?}", run.last());
        // A start in the middle.
        let run = pulled.simulate([0.0, 1.0]).until(1.0).run().unwrap();
        assert!(run.last().iter().all(|entry| entry.is_finite()), "{p}: {:?}", run.last());
    }
}

/// Systems under conservative forces of one coordinate.
macro_rules! conservative {
    ($($name:ident: $potential:expr;)*) => {
        $(lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;
            param k = 1.5, n = 5/2;
            coord x;
            kinetic = 1/2 * dot(x)^2;
            potential = $potential;
            output parameters = k + n;
        })*

        /// Returns the energy that a run gains in each system with a given method.
        fn gains() -> Vec<(&'static str, f64, f64)> {
            vec![$({
                let system = $name::default();
                let start = [1.0, 0.3];
                let gain = |run: &[f64]| (run[run.len() - 1] - run[0]).abs();
                let adaptive = system.simulate(start).until(20.0).tolerance(1e-10).energy().run();
                let adaptive = adaptive.unwrap_or_else(|error| panic!("{}: {error}", stringify!($name)));
                let fixed = system.simulate(start).until(20.0).method(RungeKutta4 { step: 0.01 }).energy().run();
                let fixed = fixed.unwrap_or_else(|error| panic!("{}: {error}", stringify!($name)));
                let gains = [&adaptive, &fixed].map(|run| gain(run.column("energy").unwrap()));
                (stringify!($name), gains[0], gains[1])
            }),*]
        }
    };
}

conservative! {
    Hertz: k * x + 2/5 * max(0, -x)^(5/2);
    HertzByParameter: k * x + max(0, -x)^n;
    Sided: 1/2 * x^2 + if x > 0 { x^(5/2) } else { 0 };
    BothBranches: if x >= 0 { x^(3/2) } else { k * (-x)^(3/2) };
    Nested: 1/2 * x^2 + abs(abs(x) - 1/2)^2.5;
    Least: 1/2 * x^2 + min(abs(x), 1/2)^(3/2);
    Logarithm: 1/2 * x^2 + 1/2 * x^2 * ln(abs(x));
    Quotient: 1/2 * x^2 + x^2 / sqrt(k * abs(x));
    RootOfSum: sqrt(1 + k * abs(x)) + abs(x)^3;
}

#[test]
fn conservative_forces_with_roots_keep_the_energy() {
    for (name, adaptive, fixed) in gains() {
        assert!(adaptive < 1e-6, "{name}: {adaptive:e}");
        assert!(fixed < 2e-3, "{name}: {fixed:e}");
    }
}

lagrange::system! {
    /// A mass with an orifice damper and Bouc–Wen hysteresis.
    #[derive(Clone, Debug)]
    struct Damped;

    param n = 1.5, p = 1.7;
    coord x;
    state z, d;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    force x = -z / 2 - abs(dot(x))^p * sign(dot(x)) / 4;
    dot(z) = dot(x) - 0.5 * abs(dot(x)) * abs(z)^(n - 1) * z - 0.3 * dot(x) * abs(z)^n;
    dot(d) = sign(x - d) * sqrt(abs(x - d));
}

#[test]
fn losses_with_fractional_powers_do_not_depend_on_the_method() {
    let (system, start) = (Damped::default(), [1.0, 0.1, 0.0, 0.0]);
    let right = system.simulate(start).until(10.0).tolerance(1e-12).run().unwrap();
    let rough = system.simulate(start).until(10.0).tolerance(1e-6).run().unwrap();
    let method = GaussLegendre4 { step: 0.01 }.plain();
    let implicit = integrate(&system, 0.0, start, 10.0, &method, |_, _| {}).unwrap();
    let explicit = integrate(&system, 0.0, start, 10.0, &RungeKutta4 { step: 0.01 }, |_, _| {}).unwrap();
    for k in 0..4 {
        let expected = right.last()[k];
        assert!((rough.last()[k] - expected).abs() < 1e-4, "{k}: {} {expected}", rough.last()[k]);
        assert!((implicit[k] - expected).abs() < 1e-3, "{k}: {} {expected}", implicit[k]);
        assert!((explicit[k] - expected).abs() < 1e-3, "{k}: {} {expected}", explicit[k]);
    }
}

lagrange::system! {
    /// A bead attracted by a pole.
    #[derive(Clone, Debug)]
    struct Pole;

    param p = -0.5;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = -sign(x) * abs(x)^p;
}

#[test]
fn poles_end_runs_by_name() {
    for p in [-0.5, -1.5] {
        let pole = Pole { p, ..Pole::default() };
        let adaptive = pole.simulate([1.0, 0.0]).until(10.0).run().unwrap_err();
        let fixed =
            pole.simulate([1.0, 0.0]).until(10.0).method(RungeKutta4 { step: 0.01 }).run().unwrap_err();
        for error in [adaptive, fixed] {
            assert!(matches!(error.cause, StepFailure::Undefined(_)), "{p}: {error}");
            assert!(error.to_string().contains("x_ddot"), "{p}: {error}");
            assert!(error.to_string().contains("negative powers of zero"), "{p}: {error}");
            assert!(error.state().iter().all(|entry| entry.is_finite()), "{p}: {error}");
        }
    }
}
