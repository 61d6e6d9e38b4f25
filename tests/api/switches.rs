//! Forces with jumps and kinks: none is missed, and methods keep their order.

use lagrange::Simulate;
use lagrange::constraint::Unprojected;
use lagrange::event::{Direction, Switches};
use lagrange::integrate::{
    GaussLegendre4, ImplicitMidpoint, Method, RungeKutta4, StepFailure, StormerVerlet, Verner98, integrate,
};
use lagrange::system::Wrapper;

lagrange::system! {
    /// An oscillator pushed for a moment.
    #[derive(Clone, Debug)]
    struct Pushed;

    param t0 = 20.0, dt = 0.05, f = 100.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    force x = if t < t0 { 0 } else { if t < t0 + dt { f } else { 0 } };
}

/// Returns the state after the push of an oscillator at rest.
fn after_push(&Pushed { t0, dt, f, .. }: &Pushed, t: f64) -> [f64; 2] {
    let since = t - t0;
    [f * ((since - dt).cos() - since.cos()), f * (since.sin() - (since - dt).sin())]
}

#[test]
fn a_push_shorter_than_a_step_is_not_missed() {
    let pushed = Pushed::default();
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        let run = pushed.simulate([0.0, 0.0]).until(40.0).every(0.25).tolerance(tolerance).run().unwrap();
        for (&t, (&x, &v)) in run.times().iter().zip(run.x().iter().zip(run.x_dot())) {
            let right = if t <= 20.0 { [0.0, 0.0] } else { after_push(&pushed, t) };
            let error = (x - right[0]).abs() + (v - right[1]).abs();
            assert!(error < 100.0 * tolerance, "{tolerance}, {t}: {x} {v}, {right:?}");
        }
        let plain = integrate(&pushed, 0.0, [0.0; 2], 40.0, &Verner98::tolerance(tolerance), |_, _| {});
        assert!((plain.unwrap()[0] - after_push(&pushed, 40.0)[0]).abs() < 100.0 * tolerance);
    }
}

#[test]
fn an_event_at_the_jump_does_no_harm() {
    let pushed = Pushed::default();
    let run = pushed.simulate([0.0, 0.0]).until(40.0).event("jump", Direction::Rising, |s, t, _| t - s.t0);
    let run = run.tolerance(1e-10).run().unwrap();
    assert_eq!(run.events().len(), 1);
    assert!((run.events()[0].time - 20.0).abs() < 1e-12);
    assert!((run.last()[0] - after_push(&pushed, 40.0)[0]).abs() < 1e-8);
}

#[test]
fn a_push_is_undone_backwards() {
    let pushed = Pushed::default();
    let end = after_push(&pushed, 40.0);
    let run = pushed.simulate(end).from(40.0).until(0.0).tolerance(1e-12).run().unwrap();
    assert!(run.last().iter().all(|entry| entry.abs() < 1e-9), "{:?}", run.last());
}

lagrange::system! {
    /// A mass between two springs that touches one at a time.
    #[derive(Clone, Debug)]
    struct Bilinear;

    param soft = 1.0, hard = 4.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = if x < 0 { 1/2 * soft * x^2 } else { 1/2 * hard * x^2 };
    emit { momentum_rates, jacobian }
}

/// Starts at x = 0 with velocity 1: half a period on the hard spring, then half a period on the
/// soft one.
fn bilinear(t: f64) -> [f64; 2] {
    let (hard, soft) = (std::f64::consts::PI / 2.0, std::f64::consts::PI);
    let since = t % (hard + soft);
    match since < hard {
        true => [(2.0 * since).sin() / 2.0, (2.0 * since).cos()],
        false => [-(since - hard).sin(), -(since - hard).cos()],
    }
}

/// Returns the power of the step with which the error decreases, from h to h/8.
fn order<K: Method<Bilinear>>(method: impl Fn(f64) -> K) -> f64 {
    let error = |h: f64| {
        let end = integrate(&Bilinear::default(), 0.0, [0.0, 1.0], 31.0, &method(h), |_, _| {}).unwrap();
        let right = bilinear(31.0);
        (end[0] - right[0]).hypot(end[1] - right[1])
    };
    (error(0.05) / error(0.00625)).log2() / 3.0
}

#[test]
fn methods_keep_their_order_across_jumps_of_the_stiffness() {
    let orders = [
        ("RK4", order(|step| RungeKutta4 { step }), 4.0),
        ("Gauss 4", order(|step| GaussLegendre4 { step }), 4.0),
        ("midpoint", order(|step| ImplicitMidpoint { step }), 2.0),
        ("Störmer–Verlet", order(|step| StormerVerlet { step }), 2.0),
    ];
    for (name, found, expected) in orders {
        assert!((found - expected).abs() < 0.3, "{name}: {found}");
    }
}

lagrange::system! {
    /// Returns a block on a rough belt, written with the sign of its slip velocity.
    #[derive(Clone, Debug)]
    struct Rubbed;

    param k = 1.0, mu = 0.3;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    force x = -mu * sign(dot(x));
}

#[test]
fn a_state_that_slides_along_a_switch_is_told_of_friction() {
    let rubbed = Rubbed::default();
    let error = rubbed.simulate([1.0, 0.0]).until(20.0).tolerance(1e-10).run().unwrap_err();
    assert!(matches!(error.cause, StepFailure::Slides { surface: "`dot(x)` in `force x`" }), "{error}");
    let text = error.to_string();
    assert!(text.contains("`dot(x)` in `force x`") && text.contains("friction name ="), "{text}");
    // It turns at 1 and at −0.4, and then stays at −0.2, after two half periods.
    let [x, v] = error.trajectory.last();
    assert!((x + 0.2).abs() < 1e-9 && v.abs() < 1e-9, "{x} {v}");
    assert!((error.trajectory.times().last().unwrap() - 2.0 * std::f64::consts::PI).abs() < 1e-8);
    assert!(error.trajectory.work().steps < 200, "{}", error.trajectory.work().steps);
    let rk4 = rubbed.simulate([1.0, 0.0]).until(20.0).method(RungeKutta4 { step: 0.01 }).run().unwrap_err();
    assert!(matches!(rk4.cause, StepFailure::Slides { .. }), "{rk4}");
}

lagrange::system! {
    /// A bead attracted to the origin by a constant force.
    #[derive(Clone, Debug)]
    struct Valley;

    param slope = 2.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = slope * abs(x) + max(y, -y);
    output height = abs(x);
    reduce Flat { freeze y = 0; }
}

#[test]
fn kinks_of_magnitudes_and_extrema_are_passed_in_order() {
    // From x = 1 it falls for a second, from y = −2 for two: periods of 4 s and 8 s.
    let valley = Valley::default();
    let run = valley.simulate([1.0, -2.0, 0.0, 0.0]).until(400.0).tolerance(1e-11).energy().run().unwrap();
    let [x, y, vx, vy] = run.last();
    assert!((x - 1.0).abs() + vx.abs() < 1e-8, "{x} {vx}");
    assert!((y + 2.0).abs() + vy.abs() < 1e-8, "{y} {vy}");
    assert!(run.column("energy").unwrap().iter().all(|energy| (energy - 4.0).abs() < 1e-9));
    // 300 passages, after each of which steps grow again.
    assert!(run.work().steps < 2000, "{}", run.work().steps);
    let flat = Flat::from(&valley);
    let end = flat.simulate([1.0, 0.0]).until(400.0).tolerance(1e-11).run().unwrap().last();
    assert!((end[0] - 1.0).abs() < 1e-8);
}

#[test]
fn returned_systems_have_free_switches() {
    let valley = Valley::default();
    let run = valley.simulate([1.0, -2.0, 0.0, 0.0]).until(1.5).accelerations().run().unwrap();
    let system = run.system_at_end().unwrap();
    assert_eq!(system.switches, Switches::FREE);
    assert_eq!(system.acceleration(0.0, &[0.5, 0.5], &[0.0; 2]), [-2.0, -1.0]);
    assert_eq!(system.acceleration(0.0, &[-0.5, -0.5], &[0.0; 2]), [2.0, 1.0]);
    assert_eq!(system.acceleration(0.0, &[0.0, 0.0], &[0.0; 2]), [0.0, 1.0]);
    let jumps = run.column("x_ddot").unwrap();
    assert!(jumps.contains(&-2.0) && jumps.contains(&2.0));
}

lagrange::system! {
    /// A body that falls in air with quadratic drag.
    #[derive(Clone, Debug)]
    struct Falling;

    param c = 0.1, g = 9.81;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    force x = -c * abs(dot(x)) * dot(x);
    force y = -c * abs(dot(y)) * dot(y);
}

#[test]
fn drag_at_rest_and_along_what_does_not_move_costs_nothing() {
    let falling = Falling::default();
    let run = falling.simulate([0.0; 4]).until(3.0).tolerance(1e-12).run().unwrap();
    let terminal = (falling.g / falling.c).sqrt();
    let [x, y, vx, vy] = run.last();
    let tau = terminal / falling.g;
    assert_eq!([x, vx], [0.0; 2]);
    assert!((vy + terminal * (3.0 / tau).tanh()).abs() < 1e-10);
    assert!((y + terminal * tau * (3.0 / tau).cosh().ln()).abs() < 1e-10);
    assert!(run.work().steps < 40, "{}", run.work().steps);
    // Thrown upwards, it stops at a time known in closed form.
    let up = falling.simulate([0.0, 0.0, 0.0, 20.0]).until(5.0).tolerance(1e-12);
    let up = up.event("top", Direction::Falling, |_, _, y| y[3]).run().unwrap();
    assert!((up.events()[0].time - tau * (20.0 / terminal).atan()).abs() < 1e-11);
}

lagrange::system! {
    /// A force that is undefined where it does not act.
    #[derive(Clone, Debug)]
    struct Guarded;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = if x > 0 { if ln(x) > 0 { -1 } else { -2 } } else { 0 };
}

#[test]
fn conditions_within_branches_may_be_undefined_elsewhere() {
    // From x = 1/2 with velocity 2: v² falls by 4 per length to x = 1 and then by 2: it turns at x = 2.
    let guarded = Guarded::default();
    let run = guarded.simulate([0.5, 2.0]).until(8.0).tolerance(1e-11);
    let run = run.event("turn", Direction::Falling, |_, _, y| y[1]).run().unwrap();
    assert_eq!(run.events().len(), 1);
    assert!((run.events()[0].state[0] - 2.0).abs() < 1e-9, "{:?}", run.events()[0]);
    // Back at x = 0 it has v² = 2 + 4, and keeps this speed.
    assert!((run.last()[1] + 6.0_f64.sqrt()).abs() < 1e-9);
}

lagrange::system! {
    /// An oscillator under a square wave.
    #[derive(Clone, Debug)]
    struct Switched<S>;

    param w = 5.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    force x = sign(sin(w * t));
}

#[test]
fn a_square_wave_switches_in_every_half_period() {
    // x is 1 − cos t plus the contribution of each force jump by ∓2 at t_k, ∓2 (1 − cos(t − t_k)).
    let right = |t: f64| {
        let jumps = (1..).map(|k| f64::from(k) * std::f64::consts::PI / 5.0).take_while(|&time| time < t);
        let response = |since: f64| 1.0 - since.cos();
        let changes = jumps.enumerate().map(|(k, time)| [-2.0, 2.0][k % 2] * response(t - time));
        response(t) + changes.sum::<f64>()
    };
    let run = Switched::<f64>::default()
        .simulate([0.0, 0.0])
        .until(20.0)
        .every(0.5)
        .tolerance(1e-10)
        .run()
        .unwrap();
    for (&t, &x) in run.times().iter().zip(run.x()) {
        assert!((x - right(t)).abs() < 1e-7, "{t}: {x} {}", right(t));
    }
}

lagrange::system! {
    /// A bead on a rod that leans on its own stop: a constraint, a jump in the state and one in
    /// time.
    #[derive(Clone, Debug)]
    struct Leaning;

    param k = 3.0, t1 = 1.25;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint rod = y - x;
    force x = if t > t1 { 1 } else { 0 };
    force y = if y < 0 { -k * y } else { 0 };
    output push = rod;
}

#[test]
fn constrained_systems_have_switches_too() {
    // With x = y: 2 ẍ = F(t) − k x for x < 0, which first touches x = 0 from above at t = 1.
    let run = Leaning::default().simulate([1.0, 1.0, -1.0, -1.0]).until(4.0).tolerance(1e-11).run().unwrap();
    let w = (1.5_f64).sqrt();
    let (x1, v1) = (-(w * 0.25).sin() / w, -(w * 0.25).cos());
    // From t₁ on it oscillates about the equilibrium 1/k.
    let (from_rest, rest) = (x1 - 1.0 / 3.0, 1.0 / 3.0);
    let up_to_zero = |s: f64| {
        [
            rest + from_rest * (w * s).cos() + v1 / w * (w * s).sin(),
            -from_rest * w * (w * s).sin() + v1 * (w * s).cos(),
        ]
    };
    // The instant at which it leaves the spring, by bisection.
    let (mut early, mut late) = (0.5, 2.0);
    for _ in 0..60 {
        let middle = 0.5 * (early + late);
        if up_to_zero(middle)[0] < 0.0 { early = middle } else { late = middle }
    }
    let v2 = up_to_zero(early)[1];
    let s = 4.0 - 1.25 - early;
    let expected = v2 * s + 0.25 * s * s;
    assert!((run.last()[0] - expected).abs() < 1e-8, "{:?} {expected}", run.last());
    assert!((run.last()[0] - run.last()[1]).abs() < 1e-14);
    let unprojected = Unprojected(Leaning::default());
    let run = unprojected.simulate([1.0, 1.0, -1.0, -1.0]).until(4.0).tolerance(1e-11).run().unwrap();
    assert!((run.last()[0] - expected).abs() < 1e-8);
    assert_eq!(run.system_at_end().unwrap().0.switches, Switches::FREE);
}

lagrange::system! {
    /// A block that a fan blows along the floor while it passes.
    #[derive(Clone, Debug)]
    struct Blown;

    param mu = 0.2, g = 9.81, f = 5.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    event floor = y, falling => impact(0);
    event wall = x - 3, rising => { dot(x) = -dot(x); }
    friction rub = dot(x), mu * floor;
    force x = if x > 1 { f } else { 0 };
    force y = if t > 1/2 { -1 } else { 0 };
}

#[test]
fn contacts_friction_and_events_go_with_switches() {
    let run = Blown::default().simulate([0.0, 0.0, 3.0, 0.0]).until(2.5).tolerance(1e-11).run().unwrap();
    // Decelerates by µ g, then by µ (g + 1) from t = 1/2. From x = 1 on it gets the push f, and the
    // wall throws it back.
    let weight = [9.81, 10.81].map(|g| 0.2 * g);
    let meets = (3.0 - (9.0_f64 - 2.0 * weight[0]).sqrt()) / weight[0];
    let speed = 3.0 - weight[0] * meets;
    let (since, push) = (0.5 - meets, 5.0 - weight[0]);
    let (x2, v2) = (1.0 + speed * since + 0.5 * push * since * since, speed + push * since);
    let push = 5.0 - weight[1];
    let at_wall = ((v2 * v2 + 2.0 * push * (3.0 - x2)).sqrt() - v2) / push;
    let wall = run.events().iter().find(|event| event.name == "wall").unwrap();
    assert!((wall.time - 0.5 - at_wall).abs() < 1e-9, "{} {}", wall.time, 0.5 + at_wall);
    assert!(run.events().iter().all(|event| ["floor", "wall", "rub"].contains(&event.name.as_str())));
}

lagrange::system! {
    /// A body under forces that are constant in three strips and during a push.
    #[derive(Clone, Debug)]
    struct Strips;

    param a1 = 1, a2 = 1, a3 = 1, b1 = 0, b2 = 1, t1 = 1, t2 = 2, f = 1;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = if x < b1 { a1 } else if x < b2 { a2 } else { a3 };
    force x = if t < t1 { 0 } else if t < t2 { f } else { 0 };
}

impl Strips {
    /// Returns the force in a strip and an interval of time, counted from zero.
    fn force(&self, strip: usize, interval: usize) -> f64 {
        [self.a1, self.a2, self.a3][strip] + [0.0, self.f, 0.0][interval]
    }

    /// Returns the motion in parabolas, or `None` where a boundary is touched so slowly that
    /// rounding decides.
    fn parabolas(&self, [mut x, mut v]: [f64; 2], end: f64) -> Option<[f64; 2]> {
        let (borders, times) = ([self.b1, self.b2], [self.t1, self.t2, end]);
        let mut strip = borders.iter().filter(|border| x >= **border).count();
        let (mut t, mut interval) = (0.0, 0);
        loop {
            let a = self.force(strip, interval);
            let left = times[interval] - t;
            let next = (0..2).filter(|side| (strip > 0 && *side == 0) || (strip < 2 && *side == 1));
            let next = next.filter_map(|side| {
                let border = borders[if side == 0 { strip - 1 } else { strip }];
                let duration = first_time_at(border - x, v, a, side == 1)?;
                (duration < left).then_some((duration, side, border))
            });
            match next.min_by(|one, other| one.0.total_cmp(&other.0)) {
                Some((duration, side, border)) => {
                    (x, v, t) = (border, v + a * duration, t + duration);
                    if v.abs() < 0.05 || (times[interval] - t).abs() < 1e-3 {
                        return None;
                    }
                    strip = if side == 0 { strip - 1 } else { strip + 1 };
                }
                None => {
                    (x, v, t) = (x + v * left + 0.5 * a * left * left, v + a * left, times[interval]);
                    interval += 1;
                    if interval == 3 {
                        return Some([x, v]);
                    }
                }
            }
        }
    }
}

/// Returns the time at which a parabola reaches a distance on its way up or down.
fn first_time_at(distance: f64, v: f64, a: f64, upwards: bool) -> Option<f64> {
    let discriminant = v * v + 2.0 * a * distance;
    let speed = if upwards { discriminant.sqrt() } else { -discriminant.sqrt() };
    // The speed there is v + a s.
    let duration = if (v + speed).abs() > 1e-9 { 2.0 * distance / (v + speed) } else { (speed - v) / a };
    (duration > 0.0).then_some(duration)
}

#[test]
fn random_strips_and_pushes_are_passed_exactly() {
    let mut seed = 20_u64;
    let mut random = |from: f64, to: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * ((seed >> 11) as f64 / (1_u64 << 53) as f64)
    };
    let mut compared = 0;
    for _ in 0..400 {
        let [a1, a2, a3] = [0; 3].map(|_| random(-2.0, 2.0));
        let (t1, b1) = (random(0.5, 3.0), random(-1.0, 1.0));
        let (t2, b2, f) = (t1 + random(0.002, 2.0), b1 + random(0.3, 2.0), random(-9.0, 9.0));
        let strips = Strips { a1, a2, a3, b1, b2, t1, t2, f, ..Strips::default() };
        let start = [random(-2.0, 3.0), random(-2.0, 2.0)];
        let Some(right) = strips.parabolas(start, 8.0) else { continue };
        compared += 1;
        let close =
            |found: [f64; 2]| found.iter().zip(right).all(|(found, right)| (found - right).abs() < 1e-8);
        let found = strips.simulate(start).until(8.0).tolerance(1e-9).run().unwrap().last();
        assert!(close(found), "{strips:?} from {start:?}: {found:?} {right:?}");
        // The method is exact for parabolas in steps of any length.
        let found = integrate(&strips, 0.0, start, 8.0, &RungeKutta4 { step: 0.2 }, |_, _| {}).unwrap();
        assert!(close(found), "{strips:?} from {start:?}: {found:?} {right:?}");
    }
    assert!(compared > 200, "{compared}");
}

/// The oscillator with losses that its declaration lacks.
struct Damped(Pushed);

impl Wrapper for Damped {
    type Inner = Pushed;
    type State = [f64; 2];

    fn inner(&self) -> &Pushed {
        &self.0
    }

    fn around(&self, inner: Pushed) -> Damped {
        Damped(inner)
    }

    fn outer_rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
        let [x_dot, x_ddot] = self.0.rhs(t, y);
        [x_dot, x_ddot - 2.0 * x_dot]
    }
}

#[test]
fn a_system_around_another_keeps_its_switches() {
    // Critical damping: a step of the force at s = 0 leads to x = f (1 − (1 + s) e⁻ˢ).
    let response = |since: f64| 100.0 * (1.0 - (1.0 + since) * (-since).exp());
    let run = Damped(Pushed::default()).simulate([0.0, 0.0]).until(25.0).tolerance(1e-10).run().unwrap();
    assert!((run.last()[0] - (response(5.0) - response(4.95))).abs() < 1e-8);
}

lagrange::system! {
    /// Two independent blocks on rough ground, each on a spring.
    #[derive(Clone, Debug)]
    struct TwoRubbed;

    param k = 1.0, mu = 0.3;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 1/2 * k * (x^2 + y^2);
    force x = -mu * sign(dot(x));
    force y = -mu * sign(dot(y));
}

#[test]
fn states_that_slide_along_two_switches_stand_still_in_no_run() {
    let rubbed = TwoRubbed::default();
    for start in [[1.0, 1.0, 0.0, 0.0], [0.1, -0.2, 0.0, 0.0], [0.2, 0.1, 1e-3, 1e-3]] {
        let error = rubbed.simulate(start).until(20.0).tolerance(1e-9).max_steps(5_000).run().unwrap_err();
        assert!(matches!(error.cause, StepFailure::Slides { .. }), "{error} from {start:?}");
    }
}

lagrange::system! {
    /// A small body in a valley, beside large coordinates.
    #[derive(Clone, Debug)]
    struct FarValley;

    param y0 = 1, place = 0;
    coord far, y;
    kinetic = 1/2 * (dot(far)^2 + dot(y)^2);
    potential = y0 * abs(y - place);
}

/// Each fall from y₀ with y₀ takes √2, whatever else moves and wherever the valley is.
#[test]
fn surfaces_are_located_by_the_size_of_their_functions() {
    let phase = |time: f64| {
        let (quarter, rest) = ((time / 2_f64.sqrt()) as u32 % 4, time % 2_f64.sqrt());
        let left = 2_f64.sqrt() - rest;
        match quarter {
            0 => 1.0 - rest * rest / 2.0,
            1 => left * left / 2.0 - 1.0,
            2 => rest * rest / 2.0 - 1.0,
            _ => 1.0 - left * left / 2.0,
        }
    };
    for (far, y0, place) in
        [(0.0, 1.0, 0.0), (1e9, 1e-8, 0.0), (-1e15, 1e-3, 0.0), (1e3, 1e-3, 1e9), (1e-3, 1e6, 0.0)]
    {
        let system = FarValley { y0, place, ..FarValley::default() };
        let run =
            system.simulate([far, place + y0, 0.1, 0.0]).until(13.0).every(0.5).absolute_tolerance(1e-9 * y0);
        let run = run.run().unwrap_or_else(|error| panic!("{far} {y0} {place}: {error}"));
        for (time, state) in run.iter() {
            let (found, wanted) = ((state[1] - place) / y0, phase(time));
            let rounding = 1e-7 + 1e3 * f64::EPSILON * place / y0;
            assert!((found - wanted).abs() < rounding, "{far} {y0} {place} at {time}: {found}, not {wanted}");
        }
    }
}

lagrange::system! {
    /// Forces by the signs of quantities that stay at zero, start there, or pass it.
    #[derive(Clone, Debug)]
    struct AtZero;

    coord x, y, z;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    force x = sign(x);
    force y = 1 + sign(y);
    force z = sign(z - t);
}

#[test]
fn a_sign_is_zero_for_free_switches_and_one_in_runs_that_start_at_zero() {
    let system = AtZero::default();
    assert_eq!(system.acceleration(0.0, &[0.0; 3], &[0.0; 3]), [0.0, 1.0, 0.0]);
    assert_eq!(system.acceleration(0.0, &[-0.0, 1e-300, 0.0], &[0.0; 3])[..2], [0.0, 2.0]);
    // Each counts as positive: x = t²/2, y = t²; z − t falls at once.
    let run = system.simulate([0.0; 6]).until(1.0).tolerance(1e-10).run().expect("signs are known");
    let [x, y, z, ..] = run.last();
    assert!((x - 0.5).abs() < 1e-9 && (y - 1.0).abs() < 1e-9, "{x}, {y}");
    assert!((z + 0.5).abs() < 1e-6, "{z}");
}

lagrange::system! {
    /// A bead pulled by 300 cords, each with a constant force towards its own end.
    struct Cords;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = sum(i in 0..300, abs(x - i / 100)) / 100;
}

/// Returns the state after a time: between two ends the force is constant.
fn pulled([mut x, mut v]: [f64; 2], mut left: f64) -> [f64; 2] {
    let mut passed = 0;
    loop {
        let a = (300.0 - 2.0 * f64::from(passed)) / 100.0;
        let end = f64::from(if v > 0.0 || passed == 0 { passed } else { passed - 1 }) / 100.0;
        let duration = match passed < 300 || v < 0.0 {
            true => first_time_at(end - x, v, a, v > 0.0).filter(|duration| *duration < left),
            false => None,
        };
        let Some(duration) = duration else { return [x + left * (v + 0.5 * a * left), v + a * left] };
        (x, v, left) = (end, v + a * duration, left - duration);
        passed = if v > 0.0 { passed + 1 } else { passed - 1 };
    }
}

#[test]
fn hundreds_of_kinks_are_passed_exactly() {
    let start = [-0.005, 0.3];
    let right = pulled(start, 1.3);
    assert!(right[0] > 1.5, "{right:?}");
    let cords = Cords::default();
    let run = || cords.simulate(start).until(1.3);
    let adaptive = run().tolerance(1e-12).run();
    let fixed = run().method(RungeKutta4 { step: 0.1 }).run();
    for run in [adaptive, fixed] {
        let run = run.expect("a motion");
        let errors = [0, 1].map(|k| (run.last()[k] - right[k]).abs());
        assert!(errors.iter().all(|error| *error < 1e-12), "{errors:?}");
        assert!(run.work().steps > 150);
    }
}
