//! Motions of declarations in both forms: compiled by the macro, and read as text. All samples,
//! events and counts of work must be identical, bit by bit.

mod record;
mod systems;

use lagrange::Simulate;
use lagrange::integrate::{
    EulerMaruyama, PlainGaussLegendre, Radau5, RungeKutta4, StochasticRungeKutta4, WienerPath,
};
use lagrange::system::{DelayedSystem, Description, Domain, MechanicalSystem, OdeSystem, OutputSystem};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{DeclaredSystem, DynamicSystem, MethodChoice, RunSettings, Visitor};

use record::{Record, declared, record};
use systems::*;

/// The motion of a declared system from a state to a time, by a method.
struct Motion<'a, K> {
    start: &'a [f64],
    end: f64,
    method: K,
}

macro_rules! visit_by {
    ($($method:ty),*) => {$(
        impl Visitor for Motion<'_, $method> {
            type Output = (Record, &'static Description);

            fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
                let start = system.state(self.start);
                let motion = system.simulate(start).until(self.end).method(self.method).every(0.05);
                (record(motion.energy().run()), system.description())
            }
        }
    )*};
}

visit_by!(
    lagrange::integrate::Verner98<f64>,
    RungeKutta4<f64>,
    Radau5<f64>,
    PlainGaussLegendre<f64, 2>,
    EulerMaruyama<f64>,
    StochasticRungeKutta4<f64>
);

/// Compares both forms from a state to a time, by a method, including the kind of their end.
macro_rules! assert_same_bits {
    ($System:ident, $text:expr, $start:expr, $end:expr, $method:expr) => {
        assert_same_bits!($System, $text, $start, $end, $method, "Reached")
    };
    ($System:ident, $text:expr, $start:expr, $end:expr, $method:expr, $ending:expr) => {{
        let (start, end, method) = ($start, $end, $method);
        let compiled = $System::default();
        let motion = compiled.simulate(start).until(end).method(method).every(0.05).energy().run();
        let read = declared($text);
        let (found, description) = read.visit(Motion { start: &start, end, method });
        assert!(found.0[0].starts_with($ending), "{}", found.0[0]);
        assert_eq!(found, record(motion));
        let expected = Description { quaternions: description.quaternions, ..*compiled.description() };
        assert_eq!(*description, expected);
    }};
}

fn adaptive() -> lagrange::integrate::Verner98<f64> {
    lagrange::integrate::Verner98::tolerance(1e-9)
}

#[test]
fn a_double_pendulum_moves_with_the_same_bits_by_every_method() {
    let start = [1.5, 1.5, 0.0, 0.0];
    assert_same_bits!(DoublePendulum, DOUBLE_PENDULUM, start, 3.0, adaptive());
    assert_same_bits!(DoublePendulum, DOUBLE_PENDULUM, start, 1.0, RungeKutta4 { step: 0.01 });
    assert_same_bits!(DoublePendulum, DOUBLE_PENDULUM, start, 1.0, Radau5::tolerance(1e-8));
    assert_same_bits!(
        DoublePendulum,
        DOUBLE_PENDULUM,
        start,
        1.0,
        PlainGaussLegendre::<f64, 2> { step: 0.01 }
    );
}

#[test]
fn discrete_states_and_clocks_move_with_the_same_bits() {
    let start = [0.0, 20.0, 0.0, 0.0, 1.0, 0.0, 0.0];
    assert_same_bits!(Room, ROOM, start, 3.0, adaptive());
    assert_same_bits!(Room, ROOM, start, 3.0, RungeKutta4 { step: 0.03 });
    assert_same_bits!(Room, ROOM, [0.0; 7], -1.0, adaptive(), "");
}

#[test]
fn noise_events_and_clocks_go_together_with_the_same_bits() {
    let (start, path) = ([0.0, 0.5, 0.0, 0.0, 0.0, 0.0], WienerPath::of_seed(3));
    assert_same_bits!(Shaken, SHAKEN, start, 3.0, EulerMaruyama { step: 0.01, path });
    assert_same_bits!(Shaken, SHAKEN, start, 3.0, StochasticRungeKutta4 { step: 0.02, path });
    assert_same_bits!(Shaken, SHAKEN, start, 3.0, adaptive(), "Failed");
    assert_same_bits!(Shaken, SHAKEN, start, -1.0, EulerMaruyama { step: 0.01, path }, "Failed");
}

#[test]
fn nominal_values_and_ranges_act_with_the_same_bits() {
    let start = [1e-6, 250.0, 0.0];
    assert_same_bits!(Mirror, MIRROR, start, 2.0, adaptive());
    assert_same_bits!(Mirror, MIRROR, start, 2.0, Radau5::tolerance(1e-8));
    assert_same_bits!(Mirror, MIRROR, [3e-6, 250.0, 0.0], 2.0, adaptive(), "Failed");
    assert_same_bits!(Mirror, MIRROR, [1e-6, 250.0, 4e-6], 2.0, adaptive(), "Failed");
    let domain = declared(MIRROR).visit(DomainOf);
    assert_eq!(domain, *Mirror.domain());
    assert_eq!((domain.ranges.len(), domain.nominal), (2, &[1e-6, 300.0, 1e-6][..]));
}

#[test]
fn starts_out_of_a_range_are_refused() {
    let mirror = declared(MIRROR);
    let values = |tilt: f64, heat: f64| [("tilt".to_owned(), tilt), ("heat".to_owned(), heat)];
    assert_eq!(mirror.start_with(&values(2e-6, 1.0)), Ok(vec![2e-6, 1.0, 0.0]));
    let refused = |tilt: f64, heat: f64| {
        mirror.start_with(&values(tilt, heat)).expect_err("out of its range").to_string()
    };
    assert_eq!(refused(3e-6, 1.0), "the coordinate `tilt` is 3e-6, but it must be from -2e-6 to 2e-6");
    assert_eq!(refused(0.0, 0.0), "the state `heat` is 0.0, but it must be greater than 0.0");
    assert_eq!(mirror.unchecked_start(&values(0.0, 0.0)), Ok(vec![0.0; 3]));
    assert!(
        mirror.check_state(&[0.0, 1.0, 1e9]).is_ok() && mirror.check_state(&[0.0, f64::NAN, 0.0]).is_err()
    );
}

#[test]
fn ranges_and_nominal_values_may_stand_apart() {
    let common = "kinetic = 1/2 * (dot(x)^2 + dot(y)^2); dot(heat) = -heat;";
    let domain = |limits: &str| declared(&format!("struct Pair; {limits} {common}")).visit(DomainOf);
    let together = domain(
        "coord x in 0..=1 nominal 0.5, y < 2 nominal 0.1; state heat >= 0 nominal 300;
        range dot(y) in -3..3 nominal 4;",
    );
    let apart = domain(
        "coord x in 0..=1, y nominal 0.1; state heat nominal 300; range y < 2, dot(y) in -3..3;
        range dot(y) nominal 4, x nominal 0.5, heat >= 0;",
    );
    assert_eq!(apart, together);
    assert_eq!((apart.nominal, apart.ranges.len()), (&[0.5, 0.1, 300.0, 0.5, 4.0][..], 4));
}

/// The ranges and nominal values of a system.
struct DomainOf;

impl Visitor for DomainOf {
    type Output = Domain;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Domain {
        *system.domain()
    }
}

/// The motion of a system with delays, as settings of the command describe it.
struct Remembered(RunSettings);

impl Visitor for Remembered {
    type Output = Record;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Record {
        record(self.0.run(system))
    }
}

#[test]
fn delayed_signals_take_their_past_with_the_same_bits() {
    assert_same_past(&Late::default(), Late::default().start().into(), LATE);
    assert_same_past(&Rising::default(), Rising::default().start().into(), RISING);
}

/// Compares both forms of a system with delays from a state, by an adaptive and by a fixed method.
fn assert_same_past<M>(late: &M, start: [f64; 3], text: &str)
where
    M: DelayedSystem + OutputSystem + MechanicalSystem<Scalar = f64, State = [f64; 3]>,
{
    let method = MethodChoice::Verner { tolerance: 1e-9 };
    let methods = [method, MethodChoice::RungeKutta4 { step: 0.014 }];
    for (method, is_adaptive) in methods.into_iter().zip([true, false]) {
        let compiled = late.simulate(start).until(2.0).every(0.05).outputs().with_history();
        let expected = match is_adaptive {
            true => record(compiled.method(adaptive()).run()),
            false => record(compiled.method(RungeKutta4 { step: 0.014 }).run()),
        };
        let every = Some(0.05);
        let settings =
            RunSettings { start: start.to_vec(), from: 0.0, until: 2.0, every, method, has_energy: false };
        let found = declared(text).visit(Remembered(settings));
        assert!(found.0[0].starts_with("Reached"), "{}", found.0[0]);
        assert_eq!(found, expected);
    }
}

#[test]
fn compliant_contacts_move_with_the_same_bits() {
    let start = [0.0, 0.3, 0.4, 1.0, 0.0, -2.0];
    assert_same_bits!(Landing, LANDING, start, 1.5, adaptive());
    assert_same_bits!(Landing, LANDING, start, 0.5, RungeKutta4 { step: 0.0002 });
    assert_same_bits!(Landing, LANDING, start, 1.0, Radau5::tolerance(1e-7));
}

#[test]
fn states_as_large_as_their_room_and_a_little_larger_move_with_the_same_bits() {
    let start = [0.1, 0.2, 0.3, 0.4, 0.0, 0.0, 0.0, 0.0];
    assert_same_bits!(FourMasses, FOUR_MASSES, start, 2.0, adaptive());
    let start = [0.1, 0.2, 0.3, 0.4, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_same_bits!(FiveMasses, FIVE_MASSES, start, 2.0, adaptive());
    assert_same_bits!(FiveMasses, FIVE_MASSES, start, 1.0, Radau5::tolerance(1e-8));
}

#[test]
fn constraints_hold_with_the_same_bits() {
    let start = [0.6, -0.8, 0.0, 0.0];
    assert_same_bits!(Rod, ROD, start, 3.0, adaptive());
    assert_same_bits!(Rod, ROD, start, 1.0, RungeKutta4 { step: 0.01 });
    assert_same_bits!(Rod, ROD, start, 1.0, Radau5::tolerance(1e-8));
    assert_same_bits!(StabilisedRod, STABILISED_ROD, start, 1.0, adaptive());
    assert_same_bits!(Skate, SKATE, [0.0, 0.0, 0.0, 1.0, 0.0, 2.0], 1.0, adaptive());
}

#[test]
fn states_off_their_constraints_are_refused_with_the_same_words() {
    assert_same_bits!(Rod, ROD, [0.6, -0.7, 0.0, 0.0], 3.0, adaptive(), "Failed");
}

#[test]
fn events_record_replace_and_stop_at_the_same_times() {
    assert_same_bits!(Bounce, BOUNCE, [1.0, 0.0], 5.0, adaptive(), "Stopped");
    assert_same_bits!(Bounce, BOUNCE, [1.0, 0.0], 2.0, RungeKutta4 { step: 0.01 });
}

#[test]
fn switches_change_sides_at_the_same_times() {
    assert_same_bits!(Kinks, KINKS, [1.0, 0.0], 4.0, adaptive());
    assert_same_bits!(Cords, CORDS, [-0.005, 0.3], 0.3, adaptive());
}

#[test]
fn sliding_on_a_surface_is_refused_with_the_same_words() {
    assert_same_bits!(Slide, SLIDE, [0.0, 0.5], 4.0, adaptive(), "Failed");
}

#[test]
fn quaternions_stay_of_length_one_with_the_same_bits() {
    let start = [1.0, 0.0, 0.0, 0.0, 0.1, 3.0, 0.2];
    assert_same_bits!(Top, TOP, start, 2.0, adaptive());
    assert_same_bits!(Top, TOP, start, 1.0, RungeKutta4 { step: 0.01 });
}

#[test]
fn first_order_states_tables_and_unknowns_move_with_the_same_bits() {
    assert_same_bits!(Motor, MOTOR, [0.0, 0.2, 0.0], 2.0, adaptive());
    assert_same_bits!(Wind, WIND, [0.0, 0.5], 4.0, adaptive());
    assert_same_bits!(Implicit, IMPLICIT, [0.4, 0.0], 1.0, adaptive());
}

#[test]
fn squares_of_both_signs_go_the_second_way_with_the_same_bits() {
    assert_same_bits!(Indefinite, INDEFINITE, [0.3, 0.2, 0.1, -0.2], 0.5, adaptive());
}

#[test]
fn failures_have_the_same_words() {
    assert_same_bits!(Root, ROOT, [0.1, -1.0], 2.0, adaptive(), "Failed");
}

/// Runs with a parameter outside its range, or NaN.
struct RangedMotion;

impl Visitor for RangedMotion {
    type Output = Record;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Record {
        record(system.simulate(system.state(&[0.0, 1.0])).until(1.0).run())
    }
}

#[test]
fn parameters_outside_of_their_ranges_are_refused_with_the_same_words() {
    let mut read = declared(RANGED);
    assert_eq!(read.missing(), Some("m"));
    for m in [5.0, f64::NAN, 1.0] {
        read.set("m", m).expect("a parameter");
        let compiled = record(Ranged { m }.simulate([0.0, 1.0]).until(1.0).run());
        let found = read.visit(RangedMotion);
        assert_eq!(found.0[0].contains("must be from 0.5 to 4.0 kg"), m != 1.0, "{}", found.0[0]);
        assert_eq!(found, compiled);
    }
}

#[test]
fn everything_that_only_compiled_code_runs_is_refused_by_name() {
    let refused = |text: &str| {
        let derived = parse(text).expect("a declaration").derive(StrategyChoice::Cheapest).expect("regular");
        DeclaredSystem::new(Programs::new(&derived)).expect_err("refused").to_string()
    };
    let road = "function road(x); coord x; kinetic = 1/2 * dot(x)^2; potential = road(x);";
    assert!(refused(road).contains("`road_derivative`"), "{}", refused(road));
    let long = "coord x[65]; kinetic = 1/2 * sum(i in 0..65, dot(x[i])^2);";
    assert!(refused(long).contains("130 entries of the state"), "{}", refused(long));
}

#[test]
fn names_that_a_system_lacks_are_reported_with_those_it_has() {
    let mut masses = declared(FOUR_MASSES);
    assert!(masses.set("k[3]", 1.0).is_ok() && masses.set("push", 1.0).is_ok());
    let error = masses.set("k", 1.0).expect_err("an array").to_string();
    assert_eq!(error, "there is no `k`; known are `k[0]`, `k[1]`, `k[2]`, `k[3]`, `u`, `push`");
    let names = ["x[0]", "x[1]", "x[2]", "x[3]", "x_dot[0]", "x_dot[1]", "x_dot[2]", "x_dot[3]"];
    assert_eq!(masses.state_names(), names);
}

#[test]
fn programs_are_shared_between_threads() {
    fn assert_shared<T: Send + Sync>() {}
    assert_shared::<Programs>();
    assert_shared::<DeclaredSystem>();
    assert_shared::<DynamicSystem<8>>();
}

/// Runs by implicit methods on a stack of 1 MiB, as the main threads of some platforms have.
#[test]
fn implicit_methods_run_large_systems_on_a_small_stack() {
    struct Ends;

    impl Visitor for Ends {
        type Output = [Vec<f64>; 2];

        fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
            let start = system.state(&[[1.0; 60], [0.0; 60]].concat());
            let run = || system.simulate(start).until(0.2).every(0.2);
            let stiff = run().method(Radau5::tolerance(1e-9)).run().expect("a motion");
            let equal = run().method(PlainGaussLegendre::<f64, 3> { step: 0.01 }).run().expect("a motion");
            [stiff, equal].map(|motion| motion.last().as_ref().to_vec())
        }
    }

    let oscillators = "coord x[60];
        kinetic = 1/2 * sum(i in 0..60, dot(x[i])^2);
        potential = 1/2 * sum(i in 0..60, (i + 1) * x[i]^2);";
    let ends = || declared(oscillators).visit(Ends);
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(ends).expect("a thread");
    for (end, error) in thread.join().expect("a stack that suffices").iter().zip([1e-7, 1e-10]) {
        for (i, x) in end[..60].iter().enumerate() {
            let wanted = (0.2 * ((i + 1) as f64).sqrt()).cos();
            assert!((x - wanted).abs() < error, "{i}: {x} {wanted}");
        }
    }
}
