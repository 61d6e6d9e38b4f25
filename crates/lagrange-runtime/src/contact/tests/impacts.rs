//! Impacts whose outcome is known.

use super::systems::{Ball, CLOSED, Corner, Cradle, FREE, OPEN, Rod, STICKS, Slider, Stick};
use crate::contact::{Contact, ContactSystem, Mode, begin, reactions};
use crate::system::{Action, EventKind, Impact, OdeSystem, Response, StepFailure};

/// Returns the state after the event of reaction `k` at a state, and the kind of the event.
fn after<M: OdeSystem<Scalar = f64>>(
    system: &M,
    k: usize,
    t: f64,
    y: M::State,
) -> (M::State, M, EventKind<f64>) {
    match system.react(k, t, t, &y).expect("an ordinary impact") {
        Response { action: Action::Replace(y), system: Some(system), kind } => (y, system, kind),
        other => panic!("{:?} {:?}", other.action, other.kind),
    }
}

fn impact(kind: EventKind<f64>) -> Impact<f64> {
    match kind {
        EventKind::Impact(impact) | EventKind::Closed { impact, .. } => impact,
        other => panic!("no impact but {other:?}"),
    }
}

fn assert_near<const N: usize>(found: [f64; N], wanted: [f64; N]) {
    for (a, b) in found.iter().zip(&wanted) {
        assert!((a - b).abs() < 1e-14, "{found:?} for {wanted:?}");
    }
}

#[test]
fn a_ball_is_thrown_back() {
    let (y, ball, kind) = after(&Ball::new(0.8), 0, 1.0, [-1e-15, -5.0]);
    assert_near(y, [0.0, 4.0]);
    assert_eq!(ball.modes, [OPEN]);
    let Impact { impulse, energy_loss } = impact(kind);
    assert!((impulse - 2.0 * 9.0).abs() < 1e-14);
    assert!((energy_loss - (25.0 - 16.0)).abs() < 1e-13);
}

#[test]
fn a_floor_that_rises_throws_higher() {
    // At t = 2 the floor is at 2 and has the speed 2; relative to it, 7 downwards becomes 5.6
    // upwards.
    let ball = Ball { rise: 1.0, ..Ball::new(0.8) };
    let (y, _, kind) = after(&ball, 0, 2.0, [2.0, -5.0]);
    assert_near(y, [2.0, 7.6]);
    assert!((impact(kind).impulse - 2.0 * 12.6).abs() < 1e-13);
}

#[test]
fn a_plastic_impact_closes_a_contact_that_is_pressed() {
    let (y, ball, kind) = after(&Ball::new(0.0), 0, 1.0, [0.0, -5.0]);
    assert_eq!((y, ball.modes), ([0.0, 0.0], [CLOSED]));
    assert!(matches!(kind, EventKind::Closed { at: 1.0, .. }));
    let lifted = Ball { lift: 30.0, ..Ball::new(0.0) };
    let (y, ball, kind) = after(&lifted, 0, 1.0, [0.0, -5.0]);
    assert_eq!((y, ball.modes), ([0.0, 0.0], [OPEN]));
    assert!(matches!(kind, EventKind::Impact(_)));
}

#[test]
fn grazing_does_nothing() {
    let answer = Ball { lift: 30.0, ..Ball::new(0.5) }.react(0, 1.0, 1.0, &[-1e-16, 0.0]).expect("nothing");
    assert_eq!(answer.kind, EventKind::Zero);
    assert!(answer.system.is_none());
    assert_eq!(answer.action, Action::Replace([0.0, 0.0]), "put back onto the floor");
}

#[test]
fn a_coefficient_of_restitution_that_is_not_from_0_to_1_is_refused_by_name() {
    for e in [-0.5, -1e-300, 1.0 + f64::EPSILON, f64::NAN, f64::INFINITY] {
        let refused = Ball::new(e).react(0, 1.0, 1.0, &[0.0, -1.0]);
        let Err(StepFailure::Restitution { contact: "floor", value }) = refused else {
            panic!("{refused:?}")
        };
        assert_eq!(value.to_bits(), e.to_bits());
    }
    for e in [-0.0, 0.0, 1.0] {
        assert!(Ball::new(e).react(0, 1.0, 1.0, &[0.0, -1.0]).is_ok(), "{e}");
    }
}

/// A rod moves broadside and hits a peg with one end. It then turns with ω = 3 v/(2 L) and loses a
/// quarter of its energy.
#[test]
fn a_rod_turns_round_a_peg() {
    let rod = Rod { supports: [0.0, -9.0], ..Rod::new(0.0, 0.0) };
    let (y, _, kind) = after(&rod, 0, 1.0, [0.0, 0.0, -4.0, 0.0]);
    let omega = 3.0 * 4.0 / (2.0 * 2.0);
    assert_near(y, [0.0, 0.0, -3.0, -omega]);
    let kinetic = 0.5 * 3.0 * 16.0;
    assert!((impact(kind).energy_loss - kinetic / 4.0).abs() < 1e-13);
}

#[test]
fn both_ends_of_a_rod_hit_the_floor_at_once() {
    let rod = Rod::new(9.81, 0.5);
    let (y, _, kind) = after(&rod, 0, 1.0, [0.0, 0.0, -4.0, 0.0]);
    assert_near(y, [0.0, 0.0, 2.0, 0.0]);
    let Impact { impulse, energy_loss } = impact(kind);
    assert!((impulse - 0.5 * 3.0 * 6.0).abs() < 1e-13, "half of it at each end");
    assert!((energy_loss - 0.5 * 3.0 * (16.0 - 4.0)).abs() < 1e-12);
}

/// A rod on its left end is hit near its centre. This lifts the left end, which a contact that
/// cannot pull does not prevent.
#[test]
fn a_contact_that_would_pull_is_left_out() {
    let rod = Rod { places: [-1.0, 0.2], modes: [CLOSED, OPEN], ..Rod::new(9.81, 0.0) };
    let (y, rod, kind) = after(&rod, 1, 1.0, [0.0, 0.0, -1.0, -1.0]);
    // Alone, the right support stops −1.2 by Λ with G = (1 + 3/25)/m. G between the two is (1 −
    // 3/5)/m.
    assert!((impact(kind).impulse - 1.2 * 3.0 / 1.12).abs() < 1e-14);
    let rates = [y[2] - y[3], y[2] + 0.2 * y[3]];
    assert_near(rates, [1.2 * 0.4 / 1.12, 0.0]);
    assert_eq!(rod.modes, [OPEN, CLOSED]);
}

#[test]
fn an_impact_conserves_momentum_and_an_elastic_one_energy() {
    for (masses, e) in [([1.0, 2.0, 0.5], 1.0), ([1.0, 1.0, 1.0], 0.6), ([5.0, 0.1, 3.0], 0.0)] {
        let cradle = Cradle { masses, e, modes: [OPEN; 2] };
        let v = [3.0, 1.0, 0.5];
        let (y, _, kind) = after(&cradle, 0, 1.0, [1.0, 1.0, 1.0, v[0], v[1], v[2]]);
        let sum = |power: i32, v: [f64; 3]| (0..3).map(|k| masses[k] * v[k].powi(power)).sum::<f64>();
        let velocities = [y[3], y[4], y[5]];
        assert!((sum(1, velocities) - sum(1, v)).abs() < 1e-14);
        let lost = 0.5 * (sum(2, v) - sum(2, velocities));
        assert!((impact(kind).energy_loss - lost).abs() < 1e-13, "e = {e}");
        assert!(if e == 1.0 { lost.abs() < 1e-13 } else { lost > 0.1 });
        assert!(y[3] <= y[4] + 1e-14 && y[4] <= y[5] + 1e-14, "nothing approaches any more");
    }
}

/// Closed contacts take part in an impact at the same instant, so that two touching balls are hit
/// as one. If they are slightly apart, the last one takes over the motion.
#[test]
fn balls_that_touch_are_hit_together() {
    let cradle = Cradle { masses: [1.0; 3], e: 1.0, modes: [OPEN, OPEN] };
    let (y, _, _) = after(&cradle, 0, 1.0, [1.0, 1.0, 1.0, 1.0, 0.0, 0.0]);
    assert_near([y[3], y[4], y[5]], [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]);
    let (y, apart, _) = after(&cradle, 0, 1.0, [1.0, 1.0, 1.0 + 1e-6, 1.0, 0.0, 0.0]);
    assert_near([y[3], y[4], y[5]], [0.0, 1.0, 0.0]);
    let (y, _, _) = after(&apart, 1, 1.0, [1.0, 1.0, 1.0, y[3], y[4], y[5]]);
    assert_near([y[3], y[4], y[5]], [0.0, 0.0, 1.0]);
}

#[test]
fn friction_takes_its_share_of_an_impact() {
    let slider = Slider {
        m: 2.0,
        g: 9.81,
        e: 0.5,
        kinetic: 0.25,
        fixed: 0.3,
        pull: 0.0,
        lift: 0.0,
        modes: [OPEN, FREE],
    };
    let (y, _, kind) = after(&slider, 0, 1.0, [0.0, 0.0, 6.0, -4.0]);
    // Λ = m (1 + e) 4 = 12, and −3 along the floor.
    assert_near(y, [0.0, 0.0, 6.0 - 1.5, 2.0]);
    let lost = (36.0 + 16.0) - (4.5 * 4.5 + 4.0);
    assert!((impact(kind).energy_loss - lost).abs() < 1e-13);
    let (y, _, _) = after(&slider, 0, 1.0, [0.0, 0.0, -1.0, -4.0]);
    assert_near(y, [0.0, 0.0, 0.0, 2.0]);
}

#[test]
fn a_block_that_lands_softly_sticks_at_once() {
    let slider = Slider {
        m: 2.0,
        g: 9.81,
        e: 0.0,
        kinetic: 0.25,
        fixed: 0.3,
        pull: 0.0,
        lift: 0.0,
        modes: [OPEN, FREE],
    };
    let (y, slider, _) = after(&slider, 0, 1.0, [0.0, 0.0, 0.5, -4.0]);
    assert_near(y, [0.0; 4]);
    assert_eq!(slider.modes, [CLOSED, STICKS]);
}

#[test]
fn a_block_in_a_corner_presses_both_walls_and_shares_what_is_double() {
    let corner = Corner { m: 1.0, force: [-2.0, -6.0], modes: [OPEN; 3] };
    let closed = begin(&corner, 0.0, &[0.0; 4]).expect("a motion").expect("another mode");
    assert_eq!(closed.modes[0], CLOSED);
    let terms = closed.terms(0.0, &[0.0; 2], &[0.0; 2]);
    let forces = reactions(&terms, &closed.modes);
    assert!((forces[0] - 2.0).abs() < 1e-14 && (forces[1] + forces[2] - 6.0).abs() < 1e-14);
    let all = [CLOSED; 3];
    assert_near(reactions(&terms, &all), [2.0, 3.0, 3.0]);
    assert_near(terms.acceleration(&forces), [0.0; 2]);
    let pulled = Corner { force: [2.0, -6.0], ..corner };
    let open = begin(&pulled, 0.0, &[0.0; 4]).expect("a motion").expect("another mode");
    assert_eq!(open.modes[0], OPEN);
}

#[test]
fn a_body_below_the_floor_is_refused_by_name() {
    let error = begin(&Ball::new(0.5), 0.0, &[-0.1, 0.0]).err();
    let Some(StepFailure::Violated(violation)) = error else { panic!("{error:?}") };
    assert_eq!((violation.constraint, violation.residual), ("floor", -0.1));
    assert_eq!(begin(&Ball::new(0.5), 0.0, &[f64::NAN, 0.0]).err(), Some(StepFailure::NotFinite));
}

#[test]
fn modes_at_the_start_fit_the_state() {
    let modes = |ball: Ball, y: [f64; 2]| {
        begin(&ball, 0.0, &y).expect("a motion").map_or(ball.modes, |begun| begun.modes())
    };
    let closed = Ball { modes: [Mode::Contact(Contact::Closed)], ..Ball::new(0.5) };
    assert_eq!(modes(Ball::new(0.5), [0.0, 0.0]), [CLOSED]);
    assert_eq!(modes(closed, [0.0, 0.0]), [CLOSED]);
    assert_eq!(modes(closed, [1.0, 0.0]), [OPEN]);
    assert_eq!(modes(closed, [0.0, 1.0]), [OPEN]);
    assert_eq!(modes(closed, [0.0, -1.0]), [OPEN], "the impact comes first");
    assert_eq!(modes(Ball { g: -1.0, ..closed }, [0.0, 0.0]), [OPEN]);
}

/// Newton's law of restitution would create energy in some impacts with friction. No impact here
/// does, and the reported loss is the loss of the motion.
#[test]
fn no_impact_creates_energy() {
    let mut reduced = 0;
    for (angle, mu) in [(0.4, 0.1), (0.8, 0.5), (1.1, 0.6), (1.2, 1.0), (1.4, 0.3)] {
        for slip in [-3.0, -0.5, 0.0, 0.5, 3.0] {
            let stick = Stick { m: 1.0, length: 2.0, g: 0.0, e: 1.0, mu, modes: [OPEN, FREE] };
            let (sin, before) = (f64::sin(angle), [slip, -1.0, 0.0]);
            let (y, _, kind) = after(&stick, 0, 1.0, [0.0, sin, angle, slip, -1.0, 0.0]);
            let (v, told) = ([y[3], y[4], y[5]], impact(kind).energy_loss);
            let lost = stick.kinetic_energy(before) - stick.kinetic_energy(v);
            assert!((told - lost).abs() < 1e-12, "{told} for {lost}");
            assert!(lost > -1e-12, "{lost} at {angle}, μ = {mu}, {slip}");
            let rate = v[1] - f64::cos(angle) * v[2];
            assert!((0.0..1.0 + 1e-12).contains(&rate));
            reduced += i32::from(rate < 1.0 - 1e-9);
        }
    }
    assert!(reduced > 0, "some of them are the paradox");
}

/// Painlevé's paradox: a rough rod that is dragged may have no forces under which its end neither
/// leaves nor enters the floor.
#[test]
fn motions_without_matching_forces_are_refused() {
    let stick = Stick { m: 1.0, length: 2.0, g: 9.81, e: 0.0, mu: 3.0, modes: [OPEN, FREE] };
    let angle: f64 = 1.0;
    let refused = begin(&stick, 0.0, &[0.0, angle.sin(), angle, 2.0, 0.0, 0.0]);
    let other = begin(&stick, 0.0, &[0.0, angle.sin(), angle, -2.0, 0.0, 0.0]);
    let causes = [refused.err(), other.err()];
    assert!(
        causes.iter().any(|cause| matches!(cause, Some(StepFailure::Painleve { contact: "floor", .. }))),
        "{causes:?}"
    );
    assert!(causes.iter().any(Option::is_none), "{causes:?}");
}
