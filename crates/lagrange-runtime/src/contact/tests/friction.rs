//! Friction that sticks and slips.

use std::vec::Vec;

use super::systems::{BACKWARDS, Block, CLOSED, FORWARDS, FREE, OPEN, STICKS, Slider};
use crate::contact::{ContactSystem, Mode, begin, reactions, switch_values};
use crate::integrate::RungeKutta4;
use crate::simulate::Simulate;
use crate::system::EventKind;

/// A block of 2 kg on an incline with a downhill force of 6 N.
const INCLINE: Block = Block {
    m: 2.0,
    stiffness: 0.0,
    drive: 0.0,
    belt: 0.0,
    weight: -6.0,
    kinetic: 7.0,
    fixed: 8.0,
    modes: [FREE],
};

#[test]
fn a_block_thrown_up_an_incline_stops_and_stays() {
    let trajectory = INCLINE.simulate([0.0, 13.0]).until(5.0).tolerance(1e-12).run().expect("runs");
    let [event] = trajectory.events() else { panic!("{:?}", trajectory.events()) };
    // It decelerates with (6 + 7)/2.
    assert!((event.time - 2.0).abs() < 1e-12 && event.kind == EventKind::Stuck);
    let [x, v] = trajectory.last();
    assert!((x - 13.0).abs() < 1e-11 && v == 0.0, "{x} {v}");
    assert_eq!(trajectory.system_at_end().map(|block| block.modes), Some([STICKS]));
}

#[test]
fn a_block_on_a_steep_incline_slides_back() {
    let steep = Block { weight: -10.0, ..INCLINE };
    let trajectory = steep.simulate([0.0, 17.0]).until(5.0).tolerance(1e-12).run().expect("runs");
    let [event] = trajectory.events() else { panic!("{:?}", trajectory.events()) };
    assert!((event.time - 2.0).abs() < 1e-12 && event.kind == EventKind::Slipped);
    let [x, v] = trajectory.last();
    // Up with −17/2, down with −3/2.
    assert!((x - (17.0 - 0.75 * 9.0)).abs() < 1e-11 && (v + 4.5).abs() < 1e-11);
    assert_eq!(trajectory.system_at_end().map(|block| block.modes), Some([BACKWARDS]));
}

#[test]
fn a_block_at_rest_starts_when_the_drive_exceeds_the_static_limit() {
    let driven = Block { weight: 0.0, drive: 2.0, ..INCLINE };
    let trajectory = driven.simulate([0.0, 0.0]).until(6.0).tolerance(1e-12).run().expect("runs");
    let [event] = trajectory.events() else { panic!("{:?}", trajectory.events()) };
    assert!((event.time - 4.0).abs() < 1e-12 && event.kind == EventKind::Slipped);
    // a = (2 t − 7)/2 from t = 4 on.
    let v = |t: f64| 0.5 * t * t - 3.5 * t - (0.5 * 16.0 - 3.5 * 4.0);
    assert!((trajectory.last()[1] - v(6.0)).abs() < 1e-11);
    assert_eq!(trajectory.system_at_end().map(|block| block.modes), Some([FORWARDS]));
}

#[test]
fn friction_that_gives_way_without_a_jump_slips_the_way_it_is_driven() {
    for drive in [2.0, -2.0] {
        let driven = Block { weight: 0.0, drive, fixed: 7.0, ..INCLINE };
        let trajectory = driven.simulate([0.0, 0.0]).until(6.0).tolerance(1e-12).run().expect("runs");
        let [event] = trajectory.events() else { panic!("{:?}", trajectory.events()) };
        assert!((event.time - 3.5).abs() < 1e-12);
        // a = ±(t − 3.5) from t = 3.5 on.
        let wanted = drive.signum() * 0.5 * 2.5 * 2.5;
        assert!((trajectory.last()[1] - wanted).abs() < 1e-11, "{:?}", trajectory.last());
    }
}

/// A block on a moving belt, held by a spring, sticks until the spring force reaches the static
/// friction. It then oscillates under kinetic friction until it has the speed of the belt again.
#[test]
fn a_block_on_a_belt_sticks_and_slips() {
    let belt = Block { weight: 0.0, belt: 0.5, stiffness: 8.0, kinetic: 4.0, fixed: 6.0, ..INCLINE };
    let trajectory = belt.simulate([0.0, 0.5]).until(20.0).tolerance(1e-12).run().expect("runs");
    let events = trajectory.events();
    assert!(events.len() > 6, "{events:?}");
    for (n, event) in events.iter().enumerate() {
        let wanted = if n % 2 == 0 { EventKind::Slipped } else { EventKind::Stuck };
        assert_eq!(event.kind, wanted, "{n}");
    }
    // It gives way at x = 6/8, and oscillates about 4/8 with ω = 2: x − 1/2 = A cos 2τ + B sin 2τ
    // with A = 1/4 = B.
    for event in events.iter().step_by(2) {
        assert!((event.state[0] - 0.75).abs() < 1e-11, "{:?}", event.state);
    }
    assert!((events[0].time - 1.5).abs() < 1e-11);
    // It has the speed of the belt again where −A sin 2τ + B cos 2τ = 1/4: at 2τ = 3π/2.
    let slip = events[1].time - events[0].time;
    assert!((slip - 0.75 * std::f64::consts::PI).abs() < 1e-10, "{slip}");
    let periods: Vec<f64> = events.windows(3).map(|of| of[2].time - of[0].time).collect();
    assert!(periods.iter().all(|period| (period - periods[1]).abs() < 1e-9), "{periods:?}");
}

#[test]
fn a_method_of_fixed_steps_sticks_and_slips_as_well() {
    let belt = Block { weight: 0.0, belt: 0.5, stiffness: 8.0, kinetic: 4.0, fixed: 6.0, ..INCLINE };
    let method = RungeKutta4 { step: 1e-3 };
    let trajectory = belt.simulate([0.0, 0.5]).until(5.0).method(method).run().expect("runs");
    assert!((trajectory.events()[0].time - 1.5).abs() < 1e-10);
    assert!((trajectory.events()[1].time - (1.5 + 0.75 * std::f64::consts::PI)).abs() < 1e-8);
}

#[test]
fn friction_slips_as_the_state_says_at_the_start() {
    let modes = |block: Block, v: f64| -> [Mode; 1] {
        begin(&block, 0.0, &[0.0, v]).expect("a motion").map_or(block.modes, |begun| begun.modes)
    };
    assert_eq!(modes(INCLINE, 1.0), [FORWARDS]);
    assert_eq!(modes(INCLINE, -1.0), [BACKWARDS]);
    assert_eq!(modes(INCLINE, 0.0), [STICKS]);
    assert_eq!(modes(Block { weight: -9.0, ..INCLINE }, 0.0), [BACKWARDS]);
    assert_eq!(modes(Block { belt: 1.0, ..INCLINE }, 1.0), [STICKS]);
    assert_eq!(modes(Block { kinetic: 0.0, fixed: 0.0, ..INCLINE }, 1.0), [FREE]);
}

const SLIDER: Slider =
    Slider { m: 2.0, g: 9.81, e: 0.0, kinetic: 0.25, fixed: 0.3, pull: 0.0, lift: 0.0, modes: [OPEN, FREE] };

#[test]
fn a_block_slides_to_rest_on_a_floor_and_keeps_lying() {
    let trajectory = SLIDER.simulate([0.0, 0.0, 3.0, 0.0]).until(3.0).tolerance(1e-12).run().expect("runs");
    let [event] = trajectory.events() else { panic!("{:?}", trajectory.events()) };
    let slowing = 0.25 * 9.81;
    assert_eq!((event.name.as_str(), event.kind), ("rubbing", EventKind::Stuck));
    assert!((event.time - 3.0 / slowing).abs() < 1e-12);
    let end = trajectory.last();
    assert!((end[0] - 4.5 / slowing).abs() < 1e-11 && end[2] == 0.0 && end[1] == 0.0, "{end:?}");
    assert_eq!(trajectory.system_at_end().map(|slider| slider.modes), Some([CLOSED, STICKS]));
}

#[test]
fn a_contact_that_opens_frees_its_friction() {
    // The lifting force grows by 4 N/s: the block leaves the floor at t = m g/4 = 4.905. The
    // pulling force grows by 1 N/s: the block gives way where t = 0.3 (m g − 4 t).
    let lifted = Slider { lift: 4.0, pull: 1.0, ..SLIDER };
    let trajectory = lifted.simulate([0.0; 4]).until(6.0).tolerance(1e-12).run().expect("runs");
    let found: Vec<_> = trajectory.events().iter().map(|event| (event.name.as_str(), event.kind)).collect();
    assert_eq!(found, [("rubbing", EventKind::Slipped), ("floor", EventKind::Opened)]);
    let gives_way = 0.3 * 19.62 / 2.2;
    assert!((trajectory.events()[0].time - gives_way).abs() < 1e-12);
    assert!((trajectory.events()[1].time - 4.905).abs() < 1e-12);
    let end = trajectory.system_at_end().expect("switched");
    assert_eq!(end.modes, [OPEN, FREE]);
    // m v = ∫ t dt − 0.25 ∫ (19.62 − 4 t) dt up to the opening.
    let impulse = |t: f64| 0.5 * t * t - 0.25 * (19.62 * t - 2.0 * t * t);
    let push = impulse(4.905) - impulse(gives_way) + 0.5 * (36.0 - 4.905 * 4.905);
    assert!(
        (trajectory.last()[2] - 0.5 * push).abs() < 1e-11,
        "{:?} {}",
        trajectory.events(),
        trajectory.last()[2] - 0.5 * push
    );
}

/// Bounces cause as much friction as continuous contact: over any number of them friction takes μ
/// times the momentum from the floor.
#[test]
fn a_bouncing_block_is_slowed_like_a_sliding_one() {
    let bouncing = Slider { e: 0.5, ..SLIDER };
    let start = [0.0, 0.2, 5.0, 0.0];
    let trajectory = bouncing.simulate(start).until(1.5).tolerance(1e-12).run().expect("runs");
    assert_eq!(trajectory.system_at_end().map(|slider| slider.modes), Some([CLOSED, FORWARDS]));
    assert!((trajectory.last()[2] - (5.0 - 0.25 * 9.81 * 1.5)).abs() < 1e-8, "{:?}", trajectory.last());
}

/// A load that equals the static friction up to rounding causes no motion and no oscillation.
#[test]
fn a_block_exactly_at_its_limit_stays() {
    for weight in [-8.0, -8.0 * (1.0 + 1e-15), -8.0 * (1.0 - 1e-15)] {
        let block = Block { weight, kinetic: 8.0, ..INCLINE };
        let trajectory = block.simulate([0.3, 0.0]).until(5.0).tolerance(1e-12).run().expect("stays");
        assert_eq!(trajectory.events().len(), 0, "{weight}");
        let [x, v] = trajectory.last();
        assert!((x - 0.3).abs() < 1e-13 && v.abs() < 1e-13, "{x} {v}");
    }
}

/// A limit that grows from zero, as at the beginning of a rough surface, acts on moving and on
/// resting bodies.
#[test]
fn friction_whose_limit_begins_later_is_met() {
    let slider = Slider { lift: -4.0, g: 0.0, ..SLIDER };
    // The normal force is 4 t from the start: m v decreases at the rate μ 4 t.
    let simulation = slider.simulate([0.0, 0.0, 1.0, 0.0]).until(3.0).tolerance(1e-12).max_steps(2_000);
    let trajectory = simulation.run().expect("runs");
    let stop = trajectory.events().last().expect("it stops");
    assert_eq!((stop.name.as_str(), stop.kind), ("rubbing", EventKind::Stuck));
    assert!((stop.time - 2.0).abs() < 1e-9, "{}", stop.time);
    assert_eq!(trajectory.system_at_end().map(|slider| slider.modes), Some([CLOSED, STICKS]));
}

/// Smooth friction causes no event; its force is opposite to the slip for either sign of the limit.
#[test]
fn smooth_friction_acts_by_its_size() {
    for (slip, kinetic) in [(0.3, 0.2), (0.3, -0.2), (-0.3, -0.2), (-0.3, 0.2)] {
        let smooth = Block { kinetic, modes: [Mode::Smooth], ..INCLINE };
        let terms = smooth.terms(0.0, &[0.0], &[slip]);
        let [force] = reactions(&terms, &smooth.modes);
        assert!((force + 0.2 * f64::signum(slip)).abs() < 1e-16, "{force} at {slip}, {kinetic}");
        assert_eq!(switch_values(&terms, &smooth.modes), [1.0]);
    }
}
