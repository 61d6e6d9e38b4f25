//! Algebraic unknowns: emitted code against the interpreter, in every number type, in lanes, and
//! where there is no solution.

use lagrange::Simulate;
use lagrange::scalar::Lanes;
use lagrange::system::{Equations, LanesSystem};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

/// Declares a system, and keeps its statements as text.
macro_rules! declared_twice {
    ($name:ident, $text:ident; $($statements:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;
            $($statements)*
        }
        const $text: &str = stringify!($($statements)*);
    };
}

declared_twice! { Arm, ARM;
    param m = 2, l = 0.6, soft = 20, hard = 8, stiff = 60, resistance = 3, leak = 0.01, volt = 0.05, g = 9.81;
    coord theta;
    state charge;
    input source = 2;
    // A stiffening shaft in series with a linear gear.
    solve twist: 0 = soft * twist + hard * twist^3 - stiff * (theta - twist), start: theta;
    // A diode in series with a resistor.
    solve drop: 0 = leak * (exp(drop / volt) - 1) - (source - charge - drop) / resistance, start: 0.3, iterations: 80;
    let current = (source - charge - drop) / resistance;
    kinetic = kinetic_energy(m, l * dot(theta));
    potential = -m * g * l * cos(theta) + 1/2 * soft * twist^2 + 1/4 * hard * twist^4 + spring_energy(stiff, theta - twist);
    force theta = current;
    dot(charge) = current;
    output shaft = (twist, dot(twist));
    emit { jacobian, lanes }
}

lagrange::system! {
    /// A bead on a spring whose law is an equation, in any number type.
    struct Sprung<S>;
    coord x;
    solve pull: 0 = pull + pull^3 - x;
    kinetic = 1/2 * dot(x)^2;
    force x = -pull;
}

lagrange::system! {
    /// The bead in single precision, in lanes.
    #[scalar(f32)]
    struct Single;
    coord x;
    solve pull: 0 = pull + pull^3 - x;
    kinetic = 1/2 * dot(x)^2;
    force x = -pull;
    emit { lanes }
}

declared_twice! { Coupled, COUPLED;
    param a = 1, b = 4, c = 3, d = 7/2, k = 5, leak = 1e-14, volt = 0.02585;
    coord crank;
    state charge;
    input source = 5;
    solve (coupler, rocker):
        0 = a * cos(crank) + b * cos(coupler) - d - c * cos(rocker),
        0 = a * sin(crank) + b * sin(coupler) - c * sin(rocker),
        start: (0.7, 1.5);
    // Two diodes in series, each with a resistor to ground.
    solve (first, second):
        0 = (source - charge - first) / 1000 - first / 2000 - leak * (exp((first - second) / volt) - 1),
        0 = leak * (exp((first - second) / volt) - 1) - second / 500 - leak * (exp(second / volt) - 1),
        start: (source, source / 2), iterations: 300;
    kinetic = 1/2 * dot(crank)^2 + 1/2 * dot(rocker)^2;
    potential = 1/2 * k * (rocker - 1)^2 + sin(coupler);
    force crank = first;
    dot(charge) = second - charge;
    output angles = (coupler, rocker, dot(rocker), first);
    emit { jacobian, lanes }
}

lagrange::system! {
    /// Coupled equations in any number type.
    struct Linked<S>;
    coord x;
    solve (pull, slip): 0 = pull + pull^3 - x + slip, 0 = 2 * slip + slip^3 - pull;
    kinetic = 1/2 * dot(x)^2;
    force x = -pull;
    output slips = slip;
}

lagrange::system! {
    /// Coupled equations in single precision, in lanes.
    #[scalar(f32)]
    struct SingleLinked;
    coord x;
    solve (pull, slip): 0 = pull + pull^3 - x + slip, 0 = 2 * slip + slip^3 - pull;
    kinetic = 1/2 * dot(x)^2;
    force x = -pull;
    emit { lanes }
}

lagrange::system! {
    /// Two unknowns whose curves do not meet beyond x = 1.
    #[derive(Clone, Debug)]
    struct Parting;
    coord x;
    solve (y, z): 0 = y * z + x - 1, 0 = y - z, start: (1, 1);
    kinetic = 1/2 * dot(x)^2;
    force x = 1 - y;
}

fn half(x: f64) -> f64 {
    0.5 * x
}

fn half_derivative(_: f64) -> f64 {
    0.5
}

lagrange::system! {
    /// Beads with one equation each, which contain a function of the crate, in millimetres.
    struct Beads;
    function half(x: m): m;
    const n = 3;
    param k[n]: N/m = [1, 2, 3], m: kg = 1;
    coord x[n]: m;
    for i in 0..n {
        solve rest[i]: mm: 0 = rest[i] + half(rest[i]) - x[i], start: 1000;
        kinetic = kinetic_energy(m, dot(x[i]));
        force x[i] = -k[i] * rest[i];
    }
    emit { prepared }
}

lagrange::system! {
    /// A body pulled until its equation has no solution.
    #[derive(Clone, Debug)]
    struct Snapping;
    coord x;
    solve y: 0 = y^2 + x - 1, start: 1;
    kinetic = 1/2 * dot(x)^2;
    force x = 1 - y;
}

/// Returns states of the arm: angle, charge, rate.
fn states() -> impl Iterator<Item = [f64; 3]> {
    let spread = |i: u32, factor: f64| 3.0 * (f64::from(i) * factor).fract() - 1.5;
    (1..60).map(move |i| [spread(i, 0.618), spread(i, 0.755), 2.0 * spread(i, 0.57)])
}

#[test]
fn the_interpreter_computes_the_same_bits() {
    let derived = parse(ARM).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let (arm, interpreted) = (Arm::default(), NumericSystem::new(&derived.expect("a correct declaration")));
    for [theta, charge, rate] in states() {
        let (q, v) = ([theta, charge], [rate]);
        let found = arm.rhs(0.0, &[theta, charge, rate]);
        assert!(found.iter().all(|found| found.is_finite()), "{theta} {charge} {rate}");
        assert_eq!(found[..], interpreted.rhs(0.0, &[theta, charge, rate])[..]);
        assert_eq!(
            arm.shaft(0.0, &q, &v)[..],
            interpreted.output("shaft", 0.0, &q, &v).expect("it is declared")
        );
        // The interpreter only has the rows of accelerations, which share fewer expressions than
        // all rows.
        let jacobian = interpreted.product(Product::Jacobian, 0.0, &q, &v).expect("it was asked for");
        for (found, expected) in arm.jacobian(0.0, &[theta, charge, rate])[2].into_iter().zip(jacobian) {
            assert!((found - expected).abs() <= 1e-13 * (1.0 + expected.abs()), "{found} {expected}");
        }
    }
}

#[test]
fn lanes_have_the_bits_of_one_motion() {
    let arm = Arm::default();
    let (one, four) =
        (arm.lanes(|parameter| parameter), arm.lanes(|parameter| Lanes::<f64, 4>([parameter; 4])));
    let all = states().collect::<Vec<_>>();
    for group in all.chunks_exact(4) {
        let mut side_by_side = [0, 1, 2].map(|entry| Lanes([0, 1, 2, 3].map(|lane| group[lane][entry])));
        let found = four.rhs(Lanes([0.0; 4]), &side_by_side);
        // A NaN in one lane does not affect the others.
        side_by_side[0].0[3] = f64::NAN;
        let beside_nan = four.rhs(Lanes([0.0; 4]), &side_by_side);
        for (lane, state) in group.iter().enumerate().take(3) {
            let [found, beside_nan] =
                [found, beside_nan].map(|rates| rates.map(|rate| rate.0[lane].to_bits()));
            assert_eq!(found, beside_nan);
            let alone = arm.lanes(|parameter| Lanes::<f64, 1>([parameter]));
            let alone = alone.rhs(Lanes([0.0]), &state.map(|entry| Lanes([entry])));
            assert_eq!(found, alone.map(|rate| rate.0[0].to_bits()));
            assert_eq!(one.rhs(0.0, state), arm.rhs(0.0, state));
        }
        assert!(beside_nan[2].0[3].is_nan());
    }
}

#[test]
fn coupled_unknowns_have_the_bits_of_the_interpreter_and_of_lanes() {
    let derived = parse(COUPLED).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let (coupled, interpreted) =
        (Coupled::default(), NumericSystem::new(&derived.expect("a correct declaration")));
    let all = states().collect::<Vec<_>>();
    for state in &all {
        let ([crank, charge, rate], found) = (*state, coupled.rhs(0.0, state));
        assert!(found.iter().all(|found| found.is_finite()), "{state:?} {found:?}");
        assert_eq!(found[..], interpreted.rhs(0.0, state)[..]);
        let (q, v) = ([crank, charge], [rate]);
        let angles = interpreted.output("angles", 0.0, &q, &v).expect("it is declared");
        assert_eq!(coupled.angles(0.0, &q, &v)[..], angles);
        let jacobian = interpreted.product(Product::Jacobian, 0.0, &q, &v).expect("it was asked for");
        for (found, expected) in coupled.jacobian(0.0, state)[2].into_iter().zip(jacobian) {
            assert!((found - expected).abs() <= 1e-12 * (1.0 + expected.abs()), "{found} {expected}");
        }
    }
    let one = coupled.lanes(|parameter| Lanes::<f64, 1>([parameter]));
    let four = coupled.lanes(|parameter| Lanes::<f64, 4>([parameter; 4]));
    for group in all.chunks_exact(4) {
        let mut side_by_side = [0, 1, 2].map(|entry| Lanes([0, 1, 2, 3].map(|lane| group[lane][entry])));
        side_by_side[0].0[3] = f64::NAN;
        let found = four.rhs(Lanes([0.0; 4]), &side_by_side);
        for (lane, state) in group.iter().enumerate().take(3) {
            let alone = one.rhs(Lanes([0.0]), &state.map(|entry| Lanes([entry])));
            assert_eq!(found.map(|rate| rate.0[lane].to_bits()), alone.map(|rate| rate.0[0].to_bits()));
        }
        assert!(found[2].0[3].is_nan());
    }
}

#[test]
fn coupled_unknowns_are_the_same_in_other_numbers() {
    let (double, single, plain) = (Linked::<f64>::default(), Linked::<f32>::default(), SingleLinked);
    let lanes = plain.lanes(|parameter| parameter);
    for x in [-30.0_f32, -1.0, 0.0, 0.1, 2.0] {
        let [pull] = double.acceleration(0.0, &[f64::from(x)], &[0.0]);
        let slip = double.slips(0.0, &[f64::from(x)], &[0.0]);
        assert!((pull.powi(3) + pull + f64::from(x) - slip).abs() < 1e-14 * (1.0 + f64::from(x.abs())));
        assert!((slip.powi(3) + 2.0 * slip + pull).abs() < 1e-14 * (1.0 + pull.abs()));
        let ([b], [c]) = (single.acceleration(0.0, &[x], &[0.0]), plain.acceleration(0.0, &[x], &[0.0]));
        let a = pull as f32;
        assert!((a - b).abs() <= 4e-7 * a.abs() && (a - c).abs() <= 4e-7 * a.abs(), "{a} {b} {c}");
        assert_eq!(lanes.rhs(0.0, &[x, 0.0]), plain.rhs(0.0, &[x, 0.0]));
    }
}

#[test]
fn energy_is_kept_with_an_unknown_in_the_potential() {
    let arm = Arm { leak: 0.0, source: 0.0, ..Arm::default() };
    let start = ArmState { theta: 1.2, charge: 0.0, theta_dot: 0.0 };
    let run = arm.simulate(start).until(5.0).tolerance(1e-12).energy().run().expect("it swings");
    let energy = run.column("energy").expect("it was asked for");
    let drift = energy.iter().map(|one| (one - energy[0]).abs()).fold(0.0, f64::max);
    assert!(drift < 1e-9, "{drift}");
}

#[test]
fn other_numbers_have_the_same_solutions() {
    let (double, single, plain) = (Sprung::<f64>::default(), Sprung::<f32>::default(), Single);
    let lanes = plain.lanes(|parameter| parameter);
    for x in [-30.0_f32, -1.0, 0.0, 0.1, 2.0] {
        let a = double.acceleration(0.0, &[f64::from(x)], &[0.0])[0] as f32;
        let [b] = single.acceleration(0.0, &[x], &[0.0]);
        let [c] = plain.acceleration(0.0, &[x], &[0.0]);
        assert!((a - b).abs() <= 4e-7 * a.abs() && (a - c).abs() <= 4e-7 * a.abs(), "{a} {b} {c}");
        assert_eq!(lanes.rhs(0.0, &[x, 0.0]), plain.rhs(0.0, &[x, 0.0]));
    }
}

#[test]
fn elements_of_arrays_have_equations_and_units_scale_the_start() {
    let accelerations = Beads::default().acceleration(0.0, &[0.3, 0.6, -0.9], &[0.0; 3]);
    for (found, expected) in accelerations.into_iter().zip([-0.2, -0.8, 1.8]) {
        assert!((found - expected).abs() < 1e-15, "{found} {expected}");
    }
    let prepared = Beads::default().prepared().acceleration(0.0, &[0.3, 0.6, -0.9], &[0.0; 3]);
    assert_eq!(prepared, accelerations);
}

#[test]
fn a_run_without_a_solution_ends_with_an_error() {
    let failure = Snapping.simulate([0.5, 1.0]).until(5.0).tolerance(1e-9).run();
    let error = failure.expect_err("there is no root beyond x = 1").to_string();
    assert!(error.contains("no solution for `y` at time"), "{error}");
    let failure = Parting.simulate([0.5, 1.0]).until(5.0).tolerance(1e-9).run();
    let error = failure.expect_err("there is no root beyond x = 1").to_string();
    assert!(error.contains("no solution for `y` at time"), "{error}");
    let event = Snapping.simulate([0.5, 1.0]).until(0.2).tolerance(1e-9).run();
    assert!(event.expect("it is not there yet").last()[0] < 1.0);
}
