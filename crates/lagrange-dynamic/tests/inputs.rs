//! Inputs of declarations read as text: laws and sampled controllers, against closed forms and
//! compiled types.

use std::fmt::Debug;

use lagrange::Simulate;
use lagrange::integrate::Radau5;
use lagrange::simulate::{SimulationError, Trajectory};
use lagrange::system::{ControlledSystem, MechanicalSystem, StateVector};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{DeclaredSystem, DynamicSystem, Inline, Visitor};

macro_rules! both_ways {
    ($System:ident, $TEXT:ident, $($statements:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            pub(crate) struct $System;
            $($statements)*
        }
        const $TEXT: &str = concat!("struct ", stringify!($System), ";", stringify!($($statements)*));
    };
}

both_ways! { Cart, CART,
    emit { jacobian }
    coord x;
    input brake = 0.5, u;
    kinetic = 1/2 * dot(x)^2;
    force x = u - brake * dot(x);
}

both_ways! { Rod, ROD,
    coord x, y;
    input u;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 9.81 * y;
    force x = max(u, -1.5);
    constraint length = hypot(x, y) - 1;
    event level = y, rising => stop;
    output tension = length;
}

fn declared(text: &str) -> DeclaredSystem {
    let derived = parse(text).unwrap_or_else(|report| panic!("{report}")).derive(StrategyChoice::Cheapest);
    let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    DeclaredSystem::new(programs).unwrap_or_else(|refusal| panic!("{refusal}"))
}

/// Returns columns with their names, events, work and failure, with all digits.
fn record<M: MechanicalSystem<Scalar = f64>>(
    motion: Result<Trajectory<M>, SimulationError<M>>,
) -> (String, Vec<String>)
where
    M::State: Debug,
{
    let (motion, failure) = match motion {
        Ok(motion) => (motion, String::new()),
        Err(failure) => (*failure.trajectory.clone(), failure.to_string()),
    };
    let mut csv = Vec::new();
    motion.write_csv(&mut csv).expect("memory");
    let events = motion.events().iter().map(|event| format!("{} {:?}", event.name, event.time));
    (
        String::from_utf8(csv).expect("text"),
        events.chain([format!("{:?} {failure}", motion.work())]).collect(),
    )
}

type Law = fn(f64, &[f64]) -> Vec<f64>;

/// A way to set inputs.
#[derive(Clone, Copy)]
enum Feed {
    Law,
    LawByRadau,
    EveryTenth,
}

/// A motion with inputs.
struct Fed<'a> {
    start: &'a [f64],
    end: f64,
    law: Law,
    feed: Feed,
}

impl Visitor for Fed<'_> {
    type Output = (String, Vec<String>);

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        let motion = system.simulate(system.state(self.start)).until(self.end).every(0.05);
        let law =
            |_: &DynamicSystem<CAPACITY>, t: f64, y: Inline<CAPACITY>| Inline::of(&(self.law)(t, y.as_ref()));
        match self.feed {
            Feed::Law => record(motion.drive(law).run()),
            Feed::LawByRadau => record(motion.drive(law).method(Radau5::tolerance(1e-8)).run()),
            Feed::EveryTenth => record(motion.sampled(0.1, law).run()),
        }
    }
}

/// Returns the last value of a column.
fn last(csv: &str, name: &str) -> f64 {
    let mut lines = csv.lines();
    let column = lines.next().expect("names").split(',').position(|column| column == name).expect("a column");
    lines.last().expect("a sample").split(',').nth(column).expect("a value").parse().expect("a number")
}

#[test]
fn a_spring_as_a_law_swings_as_its_closed_form() {
    let law: Law = |t, y| vec![0.0, -4.0 * y[0] + t.cos()];
    let cart = declared(CART);
    for feed in [Feed::Law, Feed::LawByRadau] {
        let (csv, _) = cart.visit(Fed { start: &[1.0, 0.0], end: 3.0, law, feed });
        // ẍ = −4 x + cos t, with the particular solution cos(t)/3.
        let x = 2.0 / 3.0 * 6.0_f64.cos() + 3.0_f64.cos() / 3.0;
        assert!((last(&csv, "x") - x).abs() < 1e-7, "{csv}");
        assert_eq!(last(&csv, "brake"), 0.0);
        assert!((last(&csv, "u") + 4.0 * x - 3.0_f64.cos()).abs() < 1e-6, "{csv}");
    }
}

#[test]
fn a_held_feedback_moves_as_its_recursion() {
    let cart = declared(CART);
    let law: Law = |_, y| vec![0.0, -3.0 * y[0] - 2.0 * y[1]];
    let (csv, _) = cart.visit(Fed { start: &[1.0, 0.5], end: 2.0, law, feed: Feed::EveryTenth });
    let (mut x, mut v): (f64, f64) = (1.0, 0.5);
    for _ in 0..20 {
        let u = -3.0 * x - 2.0 * v;
        (x, v) = (x + 0.1 * v + 0.005 * u, v + 0.1 * u);
    }
    assert!((last(&csv, "x") - x).abs() < 1e-12 && (last(&csv, "x_dot") - v).abs() < 1e-12, "{csv}");
}

/// Compares a compiled type with the same declaration as text, under the same inputs.
macro_rules! assert_same_bits {
    ($System:ident, $TEXT:ident, $entries:expr, $start:expr, $law:expr) => {
        for feed in [Feed::Law, Feed::LawByRadau, Feed::EveryTenth] {
            let (start, law): (_, Law) = ($start, $law);
            let compiled = $System::default();
            let motion = compiled.simulate(start).until(3.0).every(0.05);
            let inputs = |system: &$System, t: f64, y| {
                let mut inputs: <$System as ControlledSystem>::InputVector = system.inputs().into();
                inputs.as_mut().copy_from_slice(&law(t, &$entries(y)));
                inputs.into()
            };
            let expected = match feed {
                Feed::Law => record(motion.drive(inputs).run()),
                Feed::LawByRadau => record(motion.drive(inputs).method(Radau5::tolerance(1e-8)).run()),
                Feed::EveryTenth => record(motion.sampled(0.1, inputs).run()),
            };
            assert_eq!(declared($TEXT).visit(Fed { start: &start, end: 3.0, law, feed }), expected);
        }
    };
}

#[test]
fn laws_and_controllers_move_with_the_bits_of_compiled_types() {
    let entries = |y: CartState| [y.x, y.x_dot];
    assert_same_bits!(Cart, CART, entries, [1.0, 0.0], |t, y| vec![0.1 * t, -2.0 * y[0] + t.sin()]);
}

#[test]
fn constraints_switches_and_events_know_the_inputs_of_a_law() {
    let entries = |y: RodState| [y.x, y.y, y.x_dot, y.y_dot];
    assert_same_bits!(Rod, ROD, entries, [0.0, -1.0, 0.5, 0.0], |_, y| vec![3.0 * y[2]]);
}

#[test]
fn inputs_that_are_not_finite_or_missing_end_the_motion_by_name() {
    let cart = declared(CART);
    let laws: [Law; 3] = [|_, _| vec![0.0, f64::NAN], |_, _| vec![0.0], |_, _| vec![0.0; 3]];
    for law in laws {
        for feed in [Feed::Law, Feed::EveryTenth] {
            let (_, ends) = cart.visit(Fed { start: &[1.0, 0.0], end: 3.0, law, feed });
            let end = ends.last().expect("an end");
            assert!(end.contains("`u`") || end.contains("`brake`"), "{end}");
        }
    }
}

#[test]
fn a_law_of_no_inputs_is_refused() {
    let mass = declared("coord x; kinetic = 1/2 * dot(x)^2;");
    let (_, ends) = mass.visit(Fed { start: &[1.0, 2.0], end: 1.0, law: |_, _| vec![], feed: Feed::Law });
    assert!(ends[0].contains("empty"), "{ends:?}");
}
