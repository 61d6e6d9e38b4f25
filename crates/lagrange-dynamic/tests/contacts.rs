//! Motions with rigid contacts and dry friction in both forms: compiled by the macro, and read as
//! text. Samples, outputs, events and counts of work must be identical, bit by bit.

#[path = "systems/both_ways.rs"]
#[macro_use]
mod both_ways;
mod record;

use lagrange::Simulate;
use lagrange::contact::Stepped;
use lagrange::integrate::{PlainGaussLegendre, Radau5, RungeKutta4, Verner98};
use lagrange::system::StateVector;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{DeclaredSystem, DynamicSystem, Inline, MethodChoice, RunSettings, Visitor};

use record::{Record, declared, record};

both_ways! {
    Ball = BALL {
        param m > 0 = 1.5, e = 0.6, g = 9.81;
        coord h;
        kinetic = 1/2 * m * dot(h)^2;
        potential = m * g * h;
        event floor = h, falling => impact(e);
        event low = h - 0.1, falling => record;
        output push = floor;
    }

    Block = BLOCK {
        param grip = 1.5;
        coord x;
        kinetic = 1/2 * dot(x)^2;
        force x = 2.5 * sin(2 * t);
        friction brake = dot(x), kinetic: grip, static: 1.2 * grip;
        output held = brake;
        output rate = dot(dot(x));
    }

    Puck = PUCK {
        param mu = 0.3, g = 9.81;
        coord x, y;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = 3 * x^2 + 2 * y^2;
        friction rub = dot((x, y)), mu * g;
        output grip = rub;
    }

    Smooth = SMOOTH {
        coord x, y;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = 9.81 * y;
        force x = 3 * cos(t);
        dissipation = 1/2 * 0.4 * dot(x)^2 + 1/2 * 0.1 * (dot(y) - dot(x))^2;
        event floor = y, falling => impact(if t > 0.4 { 0.3 } else { 0.5 });
        friction rub = dot(x), 0.4 * floor, smooth: 0.01;
        output rubbing = rub;
    }

    Case = CASE {
        param mu = 0.5, e = 0.2;
        gravity = (0, 0, -9.81);
        body case { mass: 2; shape: cuboid(0.2, 0.3, 0.2); }
        free case;
        contact feet = case.corners on ground { friction: mu; restitution: e; }
        output load = feet[0].normal;
    }

    Held = HELD {
        param l = 1, strength = 0.2;
        coord x, y;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = 9.81 * y;
        constraint rod = x^2 + y^2 - l^2;
        friction dry = x * dot(y) - y * dot(x), strength;
        event stop = x + 0.25, falling => impact(0.5);
        event lowest = x, crossing => record;
        output pull = rod;
    }

    Belt = BELT {
        param m = 1.5, k = 40, v = 0.3;
        coord x, y;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
        potential = 1/2 * k * x^2 + m * 9.81 * y;
        constraint belt = y;
        friction rub = dot(x) - v, kinetic: 0.2 * belt, static: 0.35 * belt;
        output grip = rub;
    }

    Hills = HILLS {
        table hill(x) = [(-2, 0), (-1, 0.3), (0, 0), (1, 0.2), (2, 0), (3, 0.1)], interpolation: natural, outside: extend;
        coord x, y;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = 9.81 * y;
        event ground = y - hill(x), falling => impact(0.4);
        friction rub = dot(x), 0.1 * ground;
        output load = ground;
    }

    Pushed = PUSHED {
        coord x;
        input u;
        kinetic = 1/2 * dot(x)^2;
        force x = u;
        friction rub = dot(x), kinetic: 0.5, static: 0.7;
        output grip = rub;
    }

    Switched = SWITCHED {
        coord x;
        kinetic = 1/2 * dot(x)^2;
        force x = if x > 0.5 { -4 } else { 2 };
        friction rub = dot(x), 0.5;
        output grip = rub;
    }

    Boxes = BOXES {
        gravity = (0, 0, -9.81);
        body low { mass: 1; shape: cuboid(1, 1, 1); }
        free low;
        contact rest = low on ground { friction: 0.3; }
        body high { mass: 1; shape: cuboid(1, 1, 1); }
        free high;
        contact touch = high on low { friction: 0.3; }
        output height = high.origin.z;
    }
}

/// A run by settings of the command.
struct Run(RunSettings);

impl Visitor for Run {
    type Output = Record;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Record {
        record(self.0.run(system))
    }
}

fn settings(start: &[f64], until: f64, method: MethodChoice) -> RunSettings {
    let every = Some(until / 50.0);
    RunSettings { start: start.to_vec(), from: 0.0, until, every, method, has_energy: true }
}

/// Compares the motions of both forms from a state to a time, by a method.
macro_rules! assert_same_motion {
    ($System:ident, $text:expr, $start:expr, $until:expr, $method:expr, $choice:expr, $ending:expr) => {{
        let (system, until) = ($System::default(), f64::from($until));
        let run = system.simulate($start).until(until).every(until / 50.0).outputs().energy();
        let expected = record(run.method($method).run());
        let found = declared($text).visit(Run(settings(&$start, until, $choice)));
        assert!(expected.0[0].starts_with($ending), "{}", expected.0[0]);
        assert_eq!(found, expected);
    }};
}

/// Compares the motions of both forms by each of these methods.
macro_rules! assert_same_bits {
    ($System:ident, $text:expr, $start:expr, $until:expr, $($method:ident)*) => {
        $(assert_same_bits!(@ $method $System, $text, $start, $until);)*
    };
    (@ verner $System:ident, $text:expr, $start:expr, $until:expr) => {{
        let (method, tolerance) = (Verner98::tolerance(1e-9), 1e-9);
        assert_same_motion!(
            $System, $text, $start, $until, method, MethodChoice::Verner { tolerance }, "Reached"
        );
    }};
    (@ radau $System:ident, $text:expr, $start:expr, $until:expr) => {{
        let (method, tolerance) = (Radau5::tolerance(1e-7), 1e-7);
        assert_same_motion!(
            $System, $text, $start, $until, method, MethodChoice::Radau { tolerance }, "Reached"
        );
    }};
    (@ rk4 $System:ident, $text:expr, $start:expr, $until:expr) => {{
        let step = 0.01;
        assert_same_motion!(
            $System, $text, $start, $until, RungeKutta4 { step }, MethodChoice::RungeKutta4 { step }, "Reached"
        );
    }};
    (@ gauss $System:ident, $text:expr, $start:expr, $until:expr) => {{
        let (step, method) = (0.02, PlainGaussLegendre::<f64, 3> { step: 0.02 });
        assert_same_motion!(
            $System, $text, $start, $until, method, MethodChoice::GaussLegendre { step }, "Reached"
        );
    }};
    (@ stepped $System:ident, $text:expr, $start:expr, $until:expr) => {{
        let step = 0.005;
        assert_same_motion!(
            $System, $text, $start, $until, Stepped::every(step), MethodChoice::Stepped { step }, "Reached"
        );
    }};
}

#[test]
fn a_ball_bounces_until_it_lies_with_the_same_bits() {
    assert_same_bits!(Ball, BALL, [1.0, 0.5], 4, verner radau rk4 gauss stepped);
}

#[test]
fn a_block_sticks_and_slips_with_the_same_bits() {
    assert_same_bits!(Block, BLOCK, [0.0, 0.3], 6, verner radau rk4 gauss stepped);
}

#[test]
fn friction_in_a_plane_turns_and_stops_with_the_same_bits() {
    assert_same_bits!(Puck, PUCK, [1.0, -0.7, 0.5, 2.0], 3, verner stepped);
}

#[test]
fn dampers_and_smooth_friction_act_with_the_same_bits() {
    assert_same_bits!(Smooth, SMOOTH, [0.0, 0.5, 1.0, 0.0], 2, verner radau stepped);
}

#[test]
fn a_box_lands_on_its_corners_with_the_same_bits() {
    let start = [0.0, 0.0, 0.3, 1.0, 0.1, 0.05, 0.0, 0.4, 0.1, 0.0, 0.3, 0.0, 0.5];
    assert_same_bits!(Case, CASE, start, 0.4, verner stepped);
    let rest = [0.0, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0, 1.0, 0.5, 0.0, 0.0, 0.0, 0.0];
    assert_same_bits!(Case, CASE, rest, 0.15, verner stepped);
}

#[test]
fn contacts_and_constraints_go_together_with_the_same_bits() {
    assert_same_bits!(Held, HELD, [0.6, -0.8, 0.0, 0.0], 3, verner rk4 stepped);
    assert_same_bits!(Belt, BELT, [0.0, 0.0, 0.3, 0.0], 6, verner radau stepped);
}

#[test]
fn terrain_of_a_table_is_touched_with_the_same_bits() {
    assert_same_bits!(Hills, HILLS, [-0.3, 1.0, 0.4, 0.0], 3, verner rk4 stepped);
}

#[test]
fn switches_and_friction_go_together_with_the_same_bits() {
    assert_same_bits!(Switched, SWITCHED, [0.0, 0.4], 3, verner rk4 stepped);
}

#[test]
fn faces_and_edges_are_stepped_and_otherwise_refused_with_the_same_words() {
    let mut start = [0.0; 26];
    (start[2], start[3]) = (0.5, 1.0);
    (start[9], start[7], start[10]) = (1.5, 0.1, 1.0);
    (start[14], start[20]) = (0.5, 1.0);
    assert_same_bits!(Boxes, BOXES, start, 0.5, stepped);
    let (method, tolerance) = (Verner98::tolerance(1e-9), 1e-9);
    assert_same_motion!(Boxes, BOXES, start, 0.5, method, MethodChoice::Verner { tolerance }, "Failed");
}

#[test]
fn states_and_settings_are_refused_with_the_same_words() {
    let (method, tolerance) = (Verner98::tolerance(1e-9), 1e-9);
    let choice = MethodChoice::Verner { tolerance };
    assert_same_motion!(Ball, BALL, [-0.1, 0.0], 1, method, choice, "Failed");
    let (step, choice) = (-1.0, MethodChoice::Stepped { step: -1.0 });
    assert_same_motion!(Ball, BALL, [1.0, 0.0], 1, Stepped::every(step), choice, "Failed");
    let mut ball = declared(BALL);
    ball.set("e", 1.5).expect("a parameter");
    let compiled = Ball { e: 1.5, ..Ball::default() };
    let run = compiled.simulate([1.0, 0.0]).until(1.0).every(0.02).outputs().energy();
    let expected = record(run.method(method).run());
    assert!(expected.0[0].contains("restitution"), "{}", expected.0[0]);
    assert_eq!(ball.visit(Run(settings(&[1.0, 0.0], 1.0, MethodChoice::Verner { tolerance }))), expected);
}

/// A run whose inputs follow [`law`].
struct DrivenRun(RunSettings);

fn law(t: f64, state: &[f64]) -> f64 {
    3.0 * (2.0 * t).sin() - state[0]
}

impl Visitor for DrivenRun {
    type Output = Record;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Record {
        let simulation = self.0.simulation(system);
        let driven = simulation.drive(|_: &_, t, y: Inline<CAPACITY>| Inline::of(&[law(t, y.as_ref())]));
        record(self.0.method.run_driven(driven, system))
    }
}

#[test]
fn inputs_follow_a_law_with_the_same_bits() {
    let start = [0.0, 0.2];
    let expected = {
        let pushed = Pushed::default();
        let run = pushed.simulate(start).until(3.0).every(0.06).outputs().energy();
        let run = run.drive(|_: &Pushed, t, y: PushedState| PushedInputs { u: law(t, &[y.x, y.x_dot]) });
        record(run.method(Stepped::every(0.005)).run())
    };
    let run = DrivenRun(settings(&start, 3.0, MethodChoice::Stepped { step: 0.005 }));
    assert!(expected.0[0].starts_with("Reached"), "{}", expected.0[0]);
    assert_eq!(declared(PUSHED).visit(run), expected);
}

#[test]
fn steps_refuse_delayed_signals() {
    let delayed = declared(
        "struct Late; coord x; kinetic = 1/2 * dot(x)^2; friction rub = dot(x), 0.1; force x = -delay(x, 0.1);",
    );
    let found = delayed.visit(Run(settings(&[0.0, 1.0], 1.0, MethodChoice::Stepped { step: 0.1 })));
    assert!(found.0[0].contains("the method `stepped` has no delayed signals"), "{}", found.0[0]);
}

#[test]
fn steps_need_contacts() {
    let free = declared("struct Free; coord x; kinetic = 1/2 * dot(x)^2;");
    let found = free.visit(Run(settings(&[0.0, 1.0], 1.0, MethodChoice::Stepped { step: 0.1 })));
    assert!(
        found.0[0].contains("the method `stepped` needs contacts without a stiffness, or dry friction"),
        "{}",
        found.0[0]
    );
}

fn refusal(text: &str) -> Option<String> {
    let derived = parse(text).expect("a declaration").derive(StrategyChoice::Cheapest).expect("regular");
    DeclaredSystem::new(Programs::new(&derived)).err().map(|refusal| refusal.to_string())
}

/// Returns blocks that slide side by side.
fn row(count: usize) -> String {
    format!(
        "struct Row; coord x[{count}]; kinetic = 1/2 * sum(i in 0..{count}, dot(x[i])^2);
         for i in 0..{count} {{ friction rub[i] = dot(x[i]), 0.5; }}"
    )
}

/// The last states of runs by several methods.
struct Ends<'a>(&'a [f64]);

impl Visitor for Ends<'_> {
    type Output = Vec<Vec<f64>>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        let methods = [MethodChoice::Verner { tolerance: 1e-9 }, MethodChoice::Stepped { step: 0.05 }];
        let ends = methods.map(|method| {
            let run = settings(self.0, 2.5, method).run(system).expect("a motion");
            run.last().as_ref().to_vec()
        });
        ends.into()
    }
}

/// A block with the speed v and the friction μ comes to rest after v²/(2 μ).
#[test]
fn many_blocks_stop_on_a_small_stack() {
    let speeds = (0..32).map(|k| 0.25 * f64::from(1 + k % 4)).collect::<Vec<_>>();
    let start = [vec![0.0; 32], speeds.clone()].concat();
    for (end, error) in declared(&row(32)).visit(Ends(&start)).into_iter().zip([1e-8, 0.1]) {
        for (k, v) in speeds.iter().enumerate() {
            assert!((end[k] - v * v).abs() < error && end[32 + k].abs() < 1e-9, "{k}: {end:?}");
        }
    }
}

#[test]
fn large_systems_are_refused_with_their_size() {
    assert_eq!(refusal(&row(32)), None);
    let message = "there are 33 velocities and 33 forces of contacts and friction, more than the 32 and 48 \
                   that run without compilation";
    assert_eq!(refusal(&row(33)).as_deref(), Some(message));
    let wide = "struct Wide; coord x; kinetic = 1/2 * dot(x)^2;
        for i in 0..49 { friction rub[i] = dot(x), 0.3; }";
    assert!(refusal(wide).is_some_and(|message| message.contains("49 forces")));
}

/// The coefficient of restitution follows from the heights before and after the first impact.
#[cfg(feature = "fit")]
#[test]
fn restitution_is_fitted_across_impacts() {
    use lagrange_dynamic::FitSettings;
    use lagrange_runtime::fit::Data;

    let (g, e) = (9.81_f64, 0.7);
    let fall = (2.0 / g).sqrt();
    let height = |t: f64| match t - fall {
        before if before < 0.0 => 1.0 - g * t * t / 2.0,
        after => e * g * fall * after - g * after * after / 2.0,
    };
    let times = (1..=9).map(|k| 0.1 * f64::from(k)).collect::<Vec<_>>();
    let data = Data::new(times.clone()).with("h", times.iter().map(|t| height(*t)).collect::<Vec<_>>());
    let settings = FitSettings {
        start: vec![1.0, 0.0],
        data,
        varied: vec![("e".to_owned(), [0.3, 0.9])],
        noise: Vec::new(),
        from: Some(0.0),
        tolerance: 1e-10,
        starts: 1,
        max_iterations: 50,
    };
    let found = declared(BALL).fit(&settings).unwrap_or_else(|failure| panic!("{failure}"));
    assert!((found.values[0].value - e).abs() < 1e-7, "{}", found.report);
}
