//! Motions with known derivatives.

use lagrange::Simulate;
use lagrange::integrate::{Radau5, RungeKutta4};
use lagrange::system::Action;

lagrange::system! {
    /// A ball over a floor.
    #[derive(Clone, Debug)]
    struct Ball;
    param g = 9.81, e in 0..=1 = 0.8;
    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = g * h;
    event floor = h, falling => impact(e);
}

lagrange::system! {
    /// A ball whose event belongs to the run.
    #[derive(Clone, Debug)]
    struct Free;
    param g = 9.81, e = 0.8;
    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = g * h;
    output rebound = -e * dot(h);
    emit { jacobian }
}

lagrange::system! {
    /// A ball whose velocity is replaced by the declaration.
    #[derive(Clone, Debug)]
    struct Replaced;
    param g = 9.81, e = 0.8, floor = 0.0;
    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = g * h;
    event bounce = h - floor, falling => { dot(h) = -e * dot(h); };
    emit { jacobian }
}

/// Returns derivatives of the height at time t by g, e and the first height H, between the first
/// and the second bounce. The height is `h = e v s − g s²/2` with `v = √(2 g H)`,
/// `s = t − √(2 H/g)`.
pub(crate) fn slopes(t: f64, g: f64, e: f64, height: f64) -> [f64; 3] {
    let (v, fall) = ((2.0 * g * height).sqrt(), (2.0 * height / g).sqrt());
    let (s, rate) = (t - fall, e * v - g * (t - fall));
    [
        e * s * v / (2.0 * g) - s * s / 2.0 + rate * fall / (2.0 * g),
        v * s,
        e * s * v / (2.0 * height) - rate * fall / (2.0 * height),
    ]
}

fn last(table: &lagrange::simulate::Table<f64>, variable: &str) -> f64 {
    *table.column(&format!("d(h)/d({variable})")).unwrap().last().unwrap()
}

#[test]
fn a_bounce_has_the_slopes_of_its_parabola() {
    let names = ["g", "e", "h"];
    let ball = Ball { e: 0.7, ..Ball::default() };
    let motion = ball.simulate([2.0, 0.0]).until(1.2).tolerance(1e-13).sensitivities(names).run().unwrap();
    let wanted = slopes(1.2, 9.81, 0.7, 2.0);
    for (name, wanted) in ["g", "e", "start.h"].into_iter().zip(wanted) {
        let found = last(motion.table(), name);
        assert!((found - wanted).abs() < 1e-10, "impact, {name}: {found} {wanted}");
    }
    let free = Free { e: 0.7, ..Free::default() };
    let motion = free
        .simulate([2.0, 0.0])
        .until(1.2)
        .tolerance(1e-13)
        .event_with(
            "floor",
            lagrange::event::Direction::Falling,
            |_, _, y| y[0],
            |ball, event| Action::Replace([0.0, ball.rebound(0.0, &[0.0], &[event.state[1]])]),
        )
        .sensitivities(names)
        .run()
        .unwrap();
    for (name, wanted) in ["g", "e", "start.h"].into_iter().zip(wanted) {
        let found = last(motion.table(), name);
        assert!((found - wanted).abs() < 1e-10, "event of the run, {name}: {found} {wanted}");
    }
    let replaced = Replaced { e: 0.7, ..Replaced::default() };
    let motion =
        replaced.simulate([2.0, 0.0]).until(1.2).tolerance(1e-13).sensitivities(names).run().unwrap();
    for (name, wanted) in ["g", "e", "start.h"].into_iter().zip(wanted) {
        let found = last(motion.table(), name);
        assert!((found - wanted).abs() < 1e-10, "assignment, {name}: {found} {wanted}");
    }
}

/// At e = 1 differences are one-sided, since larger values are refused.
#[test]
fn an_elastic_bounce_is_differentiated_from_one_side() {
    let ball = Ball { e: 1.0, ..Ball::default() };
    let motion = ball.simulate([2.0, 0.0]).until(1.2).tolerance(1e-13).sensitivities(["e"]).run().unwrap();
    let [_, wanted, _] = slopes(1.2, 9.81, 1.0, 2.0);
    assert!((last(motion.table(), "e") - wanted).abs() < 1e-9);
}

/// The height after three bounces is a polynomial in e. Bounce n + 1 follows bounce n after 2 eⁿ
/// v/g.
#[test]
fn several_bounces_have_the_slopes_of_their_polynomial() {
    let height = |e: f64| {
        let (v, fall) = ((2.0 * 9.81 * 2.0_f64).sqrt(), (4.0 / 9.81_f64).sqrt());
        let last = fall + 2.0 * v / 9.81 * (e + e * e);
        let s = 2.6 - last;
        e * e * e * v * s - 9.81 / 2.0 * s * s
    };
    let slope = |h: f64| (height(0.8 + h) - height(0.8 - h)) / (2.0 * h);
    let wanted = (4.0 * slope(5e-4) - slope(1e-3)) / 3.0;
    let motion =
        Ball::default().simulate([2.0, 0.0]).until(2.6).tolerance(1e-13).sensitivities(["e"]).run().unwrap();
    assert_eq!(motion.events().len(), 3);
    assert!(
        (last(motion.table(), "e") / wanted - 1.0).abs() < 1e-9,
        "{} {wanted}",
        last(motion.table(), "e")
    );
}

lagrange::system! {
    /// x = cos(√k t)
    #[derive(Clone, Debug)]
    struct Oscillator<S>;
    param k = 4.0;
    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = 1/2 * k * h^2;
    emit { jacobian }
}

fn by_stiffness(t: f64) -> f64 {
    -0.25 * t * (2.0 * t).sin()
}

#[test]
fn methods_and_number_types_agree() {
    let exact = by_stiffness(3.0);
    let oscillator = Oscillator::<f64>::default();
    let start = || oscillator.simulate([1.0, 0.0]).until(3.0);
    let adaptive = start().tolerance(1e-12).sensitivities(["k"]).run().unwrap();
    let fixed = start().method(RungeKutta4 { step: 1e-3 }).sensitivities(["k"]).run().unwrap();
    let after = start().sensitivities(["k"]).method(RungeKutta4 { step: 1e-3 }).run().unwrap();
    let implicit = start().method(Radau5::tolerance(1e-10)).sensitivities(["k"]).run().unwrap();
    assert!((last(adaptive.table(), "k") - exact).abs() < 1e-11);
    assert!((last(fixed.table(), "k") - exact).abs() < 1e-11);
    assert_eq!(last(after.table(), "k"), last(fixed.table(), "k"));
    assert!((last(implicit.table(), "k") - exact).abs() < 1e-8);
    let single =
        Oscillator::<f32>::default().simulate([1.0, 0.0]).until(3.0).sensitivities(["k"]).run().unwrap();
    let found = *single.column("d(h)/d(k)").unwrap().last().unwrap();
    assert!((f64::from(found) - exact).abs() < 1e-5, "{found} {exact}");
}

#[test]
fn rows_of_any_sampling_hold_the_slopes_of_their_time() {
    let oscillator = Oscillator::<f64>::default();
    let run = oscillator.simulate([1.0, 0.0]).from(1.0).until(4.0).every(0.25).tolerance(1e-12);
    let motion = run.energy().sensitivities(["h", "k", "h_dot"]).run().unwrap();
    assert_eq!(motion.len(), 13);
    for (row, t) in motion.times().iter().enumerate() {
        let vectors = motion.sensitivities(row).unwrap();
        let t = t - 1.0;
        let [h, k, v] = vectors[..] else { panic!("{vectors:?}") };
        assert!((h[0] - (2.0 * t).cos()).abs() < 1e-10 && (h[1] + 2.0 * (2.0 * t).sin()).abs() < 1e-10);
        assert!((k[0] - by_stiffness(t)).abs() < 1e-10);
        assert!((v[0] - 0.5 * (2.0 * t).sin()).abs() < 1e-10);
        assert_eq!(motion.column("d(h_dot)/d(k)").unwrap()[row], k[1]);
    }
    assert_eq!(motion.names()[2..5], ["energy", "d(h)/d(start.h)", "d(h_dot)/d(start.h)"]);
    assert_eq!(motion.sensitivities(13), None);
}

#[test]
fn steps_alongside_are_those_of_the_state() {
    let oscillator = Oscillator::<f64>::default();
    let start = || oscillator.simulate([1.0, 0.0]).until(30.0);
    let plain = start().run().unwrap().work().steps;
    let alongside = start().sensitivities_alongside(["k"]).run().unwrap();
    let weighed = start().sensitivities(["k"]).run().unwrap();
    let steps = alongside.work().steps;
    // Errors are averaged over all unknowns, most of which contribute nothing.
    assert!(steps <= plain && 10 * steps > 9 * plain, "{steps} {plain}");
    assert!(weighed.work().steps > plain);
    assert!((last(alongside.table(), "k") - by_stiffness(30.0)).abs() < 1e-4);
    assert!((last(weighed.table(), "k") - by_stiffness(30.0)).abs() < 1e-7);
}

#[test]
fn time_may_run_backwards() {
    let oscillator = Oscillator::<f64>::default();
    let run = oscillator.simulate([1.0, 0.0]).until(-3.0).tolerance(1e-12);
    assert!((last(run.sensitivities(["k"]).run().unwrap().table(), "k") - by_stiffness(-3.0)).abs() < 1e-10);
}

lagrange::system! {
    /// A ball in any number type.
    #[derive(Clone, Debug)]
    pub(crate) struct AnyBall<S>;
    param g = 9.81, e = 0.7;
    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = g * h;
    event floor = h, falling => impact(e);
}

/// The step of differences, ε^(1/5), is 0.04 in single precision, which makes derivatives worse.
#[test]
fn a_bounce_in_single_precision() {
    let ball = AnyBall::<f32>::default();
    let motion = ball.simulate([2.0, 0.0]).until(1.2).sensitivities(["g", "e", "h"]).run().unwrap();
    for (name, wanted) in ["g", "e", "start.h"].into_iter().zip(slopes(1.2, 9.81, 0.7, 2.0)) {
        let found = *motion.column(&format!("d(h)/d({name})")).unwrap().last().unwrap();
        assert!((f64::from(found) - wanted).abs() < 1e-3 * wanted.abs(), "{name}: {found} {wanted}");
    }
}

lagrange::system! {
    /// Returns a strongly damped mass.
    #[derive(Clone, Debug)]
    struct Damped;
    param k = 1e4, c = 1e4;
    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = 1/2 * k * h^2;
    dissipation = 1/2 * c * dot(h)^2;
    emit { jacobian }
}

/// h = (a e^(b t) − b e^(a t))/(a − b) with the roots a, b of x² + c x + k.
#[test]
fn an_implicit_method_differentiates_a_stiff_motion() {
    let height = |k: f64, c: f64| {
        let fast = -0.5 * (c + (c * c - 4.0 * k).sqrt());
        let slow = k / fast;
        (fast * (2.0 * slow).exp() - slow * (2.0 * fast).exp()) / (fast - slow)
    };
    let by = |slope: &dyn Fn(f64) -> f64| {
        (8.0 * (slope(10.0) - slope(-10.0)) - slope(20.0) + slope(-20.0)) / 120.0
    };
    let wanted = [by(&|by| height(1e4 + by, 1e4)), by(&|by| height(1e4, 1e4 + by))];
    let damped = Damped::default();
    let run = damped.simulate([1.0, 0.0]).until(2.0).method(Radau5::tolerance(1e-10));
    let motion = run.sensitivities(["k", "c"]).run().unwrap();
    assert!(motion.work().steps < 1000);
    for (name, wanted) in ["k", "c"].into_iter().zip(wanted) {
        let found = last(motion.table(), name);
        assert!((found / wanted - 1.0).abs() < 1e-6, "{name}: {found} {wanted}");
    }
}

/// Infinitely many bounces end at √(2 H/g) (1 + e)/(1 − e). From then on the ball lies on the
/// floor, whatever its restitution was.
#[test]
fn a_ball_that_came_to_rest_has_no_slopes() {
    let ball = Ball { e: 0.5, ..Ball::default() };
    let motion = ball.simulate([2.0, 0.0]).until(4.0).sensitivities(["g", "e", "h"]).run().unwrap();
    for slopes in motion.sensitivities(motion.len() - 1).unwrap() {
        assert!(slopes.iter().all(|slope| slope.abs() < 1e-6), "{slopes:?}");
    }
}

lagrange::system! {
    /// A block that lies on the ground with dry friction, pulled by a growing force.
    #[derive(Clone, Debug)]
    struct Lying;
    param m = 1.0, mu = 0.3, pull = 2.0, g = 9.81;
    coord x, h;
    kinetic = 1/2 * m * (dot(x)^2 + dot(h)^2);
    potential = m * g * h;
    force x = pull * t;
    event ground = h, falling => impact(0);
    friction rub = dot(x), mu * ground;
}

/// From T = μ m g/p on, the block moves as p (t − T)³/6 m. At T all entries of the state vanish, up
/// to rounding, and set no scale for changes of parameters.
#[test]
fn a_block_begins_to_slide_from_a_state_of_zeros() {
    let Lying { m, mu, pull, g, .. } = Lying::default();
    let since = 3.0 - mu * m * g / pull;
    let lying = Lying::default();
    let run = lying.simulate([0.0; 4]).until(3.0).method(RungeKutta4 { step: 1e-2 });
    let motion = run.sensitivities(["m", "g"]).run().unwrap();
    let (rise, rate) = (pull * since.powi(3) / (6.0 * m), pull * since * since / (2.0 * m));
    let wanted = [-rise / m - rate * mu * g / pull, -rate * mu * m / pull];
    for (found, wanted) in motion.sensitivities(motion.len() - 1).unwrap().iter().zip(wanted) {
        assert!((found[0] - wanted).abs() < 1e-9, "{} {wanted}", found[0]);
    }
}
