//! Bounds of the differences that count as rounding: each test fails if a tolerance is 64 times
//! smaller or larger.

use super::systems::{Ball, TestTerms, nothing};
use crate::contact::choice::{Choice, Rule};
use crate::contact::initial_modes::Position;
use crate::contact::project::{close, part};
use crate::contact::reaction_forces::Balance;
use crate::contact::resume::Instant;
use crate::contact::{ContactSystem, Terms};

const EPSILON: f64 = f64::EPSILON;

/// A ball above a floor that is at height one at time one, so that the terms of its gap are one.
const ABOVE_ONE: Ball = Ball { rise: 2.0, ..Ball::new(0.5) };

#[test]
fn a_gap_is_closed_up_to_the_rounding_of_its_terms() {
    let closed = |gap: f64| {
        let mut q = [1.0 + gap];
        close(&ABOVE_ONE, 1.0, &mut q, &[2.0], [true]).expect("can be closed");
        q[0] - 1.0
    };
    assert_eq!(closed(8.0 * EPSILON), 8.0 * EPSILON);
    assert!(closed(512.0 * EPSILON).abs() <= 64.0 * EPSILON);
}

#[test]
fn bodies_that_part_are_apart_by_more_than_rounding() {
    let mut q = [1.0];
    part(&ABOVE_ONE, 1.0, &ABOVE_ONE.terms(1.0, &q, &[2.0]), &mut q, ([true], [false]));
    let slit = (q[0] - 1.0) / EPSILON;
    assert!((4.0..=60.0).contains(&slit), "{slit}");
}

#[test]
fn gaps_are_known_as_well_as_the_time_of_an_event() {
    let (ball, t, v) = (Ball::new(0.5), 1024.0, [1.0]);
    let touches = |roundings: f64| {
        let q = [roundings * EPSILON * t];
        Position::of(&ball, &ball.terms(t, &q, &v), [t, 0.0], (&q, &v)).is_touching
    };
    assert_eq!([1.0, 64.0].map(touches), [[true], [false]]);
}

/// Returns the velocity of a contact relative to the floor after an impact at this place and time
/// with this rebound speed.
fn after_hop(ball: &Ball, t: f64, q: [f64; 1], speed: f64) -> f64 {
    let floor = ball.rise * t;
    let before = ball.terms(t, &q, &[floor - 2.0 * speed]);
    let instant = Instant { system: ball, t, elapsed: 0.0, q, v: [floor + speed] };
    let resumed = instant.resume(&before, instant.v, [true], [false]).expect("can be resumed");
    resumed.velocities[0] - floor
}

#[test]
fn hops_no_higher_than_rounding_are_not_resolved() {
    let speed_for = |roundings: f64| (2.0 * (ABOVE_ONE.g + ABOVE_ONE.rise) * roundings * EPSILON).sqrt();
    let after = |roundings: f64| after_hop(&ABOVE_ONE, 1.0, [1.0], speed_for(roundings));
    assert!(after(32.0).abs() < 0.1 * speed_for(32.0));
    assert!(after(2048.0) > 0.9 * speed_for(2048.0));
}

#[test]
fn hops_no_longer_than_rounding_of_time_are_not_resolved() {
    let (ball, t) = (Ball::new(0.5), 1_048_576.0);
    let speed_for = |roundings: f64| 0.5 * ball.g * roundings * EPSILON * t;
    let after = |roundings: f64| after_hop(&ball, t, [0.0], speed_for(roundings));
    assert!(after(28.0).abs() < 0.1 * speed_for(28.0));
    assert_eq!(after(512.0), speed_for(512.0));
}

/// Returns a contact with this normal force, the difference of two forces of about one.
fn pressing(force: f64) -> TestTerms<1, 1> {
    let (rows, responses) = ([[1.0]], [[1.0]]);
    Terms { free: [-1.0], drifts: [1.0 - force], rows, responses, ..nothing() }
}

#[test]
fn forces_that_are_rounding_do_not_press() {
    let rule = |roundings: f64| {
        let terms = pressing(roundings * EPSILON);
        Balance::of_forces(&terms).settle(&[Choice::Touch]).map(|settled| settled.rules)
    };
    assert_eq!([12.0, 256.0].map(rule), [Some([Rule::Absent]), Some([Rule::Holds])]);
}

#[test]
fn rules_found_by_search_hold_to_more_than_rounding() {
    let is_confirmed = |roundings: f64| {
        let terms = pressing(roundings * EPSILON);
        Balance::of_forces(&terms).confirmed(&[Choice::Touch], [Rule::Holds]).is_some()
    };
    assert_eq!([14, 20].map(|power| is_confirmed(2_f64.powi(power))), [false, true]);
}

#[test]
fn contacts_at_one_place_are_held_together_up_to_what_undetermined_impulses_leave() {
    let are_held = |power: i32| {
        let difference = 2_f64.powi(power) * EPSILON;
        let rates = [-1.0, -1.0 - difference];
        let terms: TestTerms<1, 2> = Terms { rates, rows: [[1.0]; 2], responses: [[1.0]; 2], ..nothing() };
        let choices = [Choice::Only(Rule::Holds); 2];
        Balance::of_impulses(&terms, &terms.rates, &[0.0; 2]).confirmed(&choices, [Rule::Holds; 2]).is_some()
    };
    assert_eq!([17, 25].map(are_held), [true, false]);
}
