//! The past keeps the jumps of events, inputs and clocks.

use lagrange::Simulate;
use lagrange::integrate::RungeKutta4;

lagrange::system! {
    /// The state jumps by one at t = 1/2.
    struct Pushed;
    state x = 1;
    event push = t - 1/2, rising => { x = x + 1; }
    dot(x) = -delay(x, 1);
}

#[test]
fn an_event_jumps_again_one_delay_later() {
    // x = 1 − t, and 2 − t after the event; x(1.5) = 0.625 and x(2) = 0.625 − ∫ (2 − s) ds = 0.
    let pushed = Pushed::default();
    let motion = pushed.simulate([1.0]).until(2.0).with_history().run().unwrap();
    assert!(motion.last()[0].abs() < 1e-12, "{}", motion.last()[0]);
    assert!(motion.times().iter().any(|t| (t - 1.5).abs() < 1e-12));
    let fixed = pushed.simulate([1.0]).until(2.0).with_history();
    let fixed = fixed.method(RungeKutta4 { step: 0.07 }).run().unwrap();
    assert!(fixed.last()[0].abs() < 1e-12, "{}", fixed.last()[0]);
}

lagrange::system! {
    /// The event depends on a signal half a second ago.
    struct Alarm;
    state x = 0;
    dot(x) = 1 + 0 * delay(x, 1/2);
    event alarm = delay(x, 1/2) - 1, rising => stop;
    output late = delay(x, 1/2);
}

#[test]
fn a_delayed_event_is_late_by_the_delay() {
    let motion = Alarm::default().simulate([0.0]).until(5.0).with_history().outputs().run().unwrap();
    assert!((motion.times().last().unwrap() - 1.5).abs() < 1e-12);
    assert!((motion.column("late").unwrap().last().unwrap() - 1.0).abs() < 1e-12);
}

lagrange::system! {
    /// Follows an input with a delay of three tenths of a second.
    struct Follower;
    input u;
    state x;
    let late = delay(u, 0.3);
    dot(x) = late;
}

#[test]
fn sampled_inputs_arrive_late_and_whole() {
    // The input counts tenths, so that it jumps wherever the delayed one does. ∫ u(t − 0.3) up to 1
    // is (0 + 0 + 0 + 0 + 1 + … + 6)/10 with u = 0 before the start.
    let mut count = -1.0;
    let control = |follower: &Follower, _, _: FollowerState| {
        count += 1.0;
        FollowerInputs { u: count, ..lagrange::system::ControlledSystem::inputs(follower) }
    };
    let follower = Follower::default();
    let motion = follower.simulate([0.0]).until(1.0).sampled(0.1, control).with_history();
    let motion = motion.every(0.05).run().unwrap();
    assert!((motion.last()[0] - 2.1).abs() < 1e-12, "{}", motion.last()[0]);
    let late = motion.column("late").unwrap();
    assert_eq!((late[0], late[5], late[9]), (0.0, 0.0, 1.0));
}

/// The input counts up from what it was three ticks ago.
#[test]
fn controllers_see_delayed_signals() {
    let mut seen = Vec::new();
    let control = |follower: &Follower, _, _: FollowerState| {
        let inputs = lagrange::system::ControlledSystem::inputs(follower);
        seen.push(inputs.late);
        FollowerInputs { u: inputs.u + 1.0, ..inputs }
    };
    let follower = Follower::default();
    follower.simulate([0.0]).until(0.65).sampled(0.1, control).with_history().run().unwrap();
    assert_eq!(seen[0], 0.0);
    // Just after a jump of the delayed input, or just before it.
    for (tick, late) in seen.iter().enumerate() {
        let expected = tick as f64 - 2.0;
        assert!(*late == expected.max(0.0) || *late == (expected - 1.0).max(0.0), "{seen:?}");
    }
}

lagrange::system! {
    /// A clock counts; the count acts a quarter of a second later.
    struct Clocked;
    discrete count = 0;
    state x;
    every 0.25 => { count = count + 1; }
    dot(x) = delay(count, 0.25);
}

#[test]
fn clocks_one_delay_apart_are_distinguished() {
    // The clock ticks at the start, too: count is k + 1 from k/4 on, and 0 before the start.
    let clocked = Clocked::default();
    let motion = clocked.simulate(clocked.start()).until(1.0).with_history().run().unwrap();
    let x = motion.column("x").unwrap();
    assert!((x.last().unwrap() - 0.25 * (0.0 + 1.0 + 2.0 + 3.0)).abs() < 1e-12, "{x:?}");
}

lagrange::system! {
    /// A delayed signal switches the rate.
    struct Relay;
    state x = 1;
    dot(x) = if delay(x, 1/2) > 0 { -1 } else { 1 };
}

#[test]
fn a_delayed_relay_switches_one_delay_after_zero() {
    // It falls to −1/2 at 3/2, rises to 1/2 at 5/2, and so on with the period 2.
    let motion = Relay::default().simulate([1.0]).until(6.5).every(0.25).with_history().run().unwrap();
    for (t, x) in motion.times().iter().zip(motion.x()) {
        let phase = (t + 0.5) % 2.0;
        let expected = if *t < 1.0 {
            1.0 - t
        } else if phase < 1.0 {
            phase - 0.5
        } else {
            1.5 - phase
        };
        assert!((x - expected).abs() < 1e-9, "{x} and {expected} at {t}");
    }
}
