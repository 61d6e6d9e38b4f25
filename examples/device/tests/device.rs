//! Motions on the device against those of the scalar code.
//!
//! Without a device nothing is compared, and a message reports that; `LAGRANGE_DEVICE=required`
//! makes it an error.

use lagrange::Simulate;
use lagrange::system::StepFailure;
use lagrange_device::{Device, DeviceError, RungeKutta4};

lagrange::system! {
    /// A double pendulum with a motor.
    #[derive(Clone)]
    pub struct Pendulums;
    param m1 = 1.0, m2 = 0.7, l1 = 0.8, l2 = 0.6, g = 9.81;
    coord theta1, theta2;
    input motor = 0.3;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = kinetic_energy(m1, dot((x1, y1))) + kinetic_energy(m2, dot((x2, y2)));
    potential = g * (m1 * y1 + m2 * y2);
    torque motor on theta1;
    emit { kernel }
}

lagrange::system! {
    /// A tumbling body, with a quaternion among its positions.
    #[derive(Clone)]
    pub struct Tumbler;
    param spin = 1.0;
    gravity = (0, 0, -9.81);
    body stone { mass: 2 * spin; inertia: (0.1, 0.2, 0.25); centroid: (0, 0, 0.1); }
    free stone;
    emit { kernel }
}

lagrange::system! {
    /// A mass that falls into a centre in finite time.
    #[derive(Clone)]
    pub struct Falling;
    param mu = 1.0;
    coord r;
    kinetic = 1/2 * dot(r)^2;
    potential = -mu / r;
    // NaN beyond the centre.
    force r = 1e-30 * sqrt(r);
    emit { kernel }
}

fn device() -> Option<Device> {
    match Device::open() {
        Ok(device) => Some(device),
        Err(error) => {
            assert!(std::env::var("LAGRANGE_DEVICE").as_deref() != Ok("required"), "{error}");
            println!("nothing is compared: {error}");
            None
        }
    }
}

/// Returns more motions than a group has threads, and not a multiple of that.
fn starts() -> Vec<[f64; 4]> {
    (0..100).map(|i| [0.3 + 0.01 * f64::from(i), 0.2, -0.1, 0.004 * f64::from(i)]).collect()
}

fn longer(i: usize, pendulums: &mut Pendulums) {
    pendulums.l1 = 0.8 + 1e-3 * i as f64;
    pendulums.motor = 0.3 - 1e-3 * i as f64;
}

/// Returns the largest distance of the motions from those of the scalar code.
fn distance(found: impl Fn(usize) -> [f64; 4], expected: impl Fn(&Pendulums, [f64; 4]) -> [f64; 4]) -> f64 {
    let distances = starts().into_iter().enumerate().flat_map(|(i, start)| {
        let mut pendulums = Pendulums::default();
        longer(i, &mut pendulums);
        let (found, expected) = (found(i), expected(&pendulums, start));
        (0..4).map(move |k| (found[k] - expected[k]).abs())
    });
    // NaN is not within any distance.
    distances.fold(0.0, |most, distance| if distance <= most { most } else { distance })
}

fn in_equal_steps(pendulums: &Pendulums, start: [f64; 4]) -> [f64; 4] {
    let run = pendulums.simulate(start).until(2.0005).method(RungeKutta4 { step: 1e-3 }).run();
    run.expect("a motion").last()
}

fn accurate(pendulums: &Pendulums, start: [f64; 4]) -> [f64; 4] {
    pendulums.simulate(start).until(2.0005).tolerance(1e-13).run().expect("a motion").last()
}

#[test]
fn equal_steps_are_those_of_the_scalar_method() -> Result<(), DeviceError> {
    let Some(device) = device() else { return Ok(()) };
    let pendulums = Pendulums::default();
    let asked = device.ensemble(&pendulums, starts()).parameters(longer).until(2.0005);
    let ends = asked.method(RungeKutta4 { step: 1e-3 }).run()?;
    assert!(ends.failures().is_empty() && ends.len() == 100);
    assert_eq!(ends.state(7).map(|state| state[0]), Some(ends.theta1()[7]));
    let found = |i| ends.state(i).expect("no failure");
    let distance = distance(found, in_equal_steps);
    assert!(distance < 1e-11, "{distance:e}");
    Ok(())
}

#[test]
fn the_adaptive_pair_keeps_its_tolerance() -> Result<(), DeviceError> {
    let Some(device) = device() else { return Ok(()) };
    let pendulums = Pendulums::default();
    let mut distances = Vec::new();
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let asked = device.ensemble(&pendulums, starts()).parameters(longer).until(2.0005);
        let ends = asked.tolerance(tolerance).run()?;
        distances.push(distance(|i| ends.state(i).expect("no failure"), accurate) / tolerance);
    }
    assert!(distances.iter().all(|distance| *distance < 200.0), "{distances:?}");
    Ok(())
}

#[test]
fn motions_go_backwards_to_their_starts() -> Result<(), DeviceError> {
    let Some(device) = device() else { return Ok(()) };
    let pendulums = Pendulums::default();
    let there = device.ensemble(&pendulums, starts()).until(1.0).tolerance(1e-12).run()?;
    let ends = (0..100).map(|i| there.state(i).expect("no failure")).collect::<Vec<_>>();
    let back = device.ensemble(&pendulums, ends).from(1.0).until(0.0).tolerance(1e-12).run()?;
    let distance = distance(|i| back.state(i).expect("no failure"), |_, start| start);
    assert!(distance < 1e-9, "{distance:e}");
    Ok(())
}

#[test]
fn single_precision_has_its_digits() -> Result<(), DeviceError> {
    let Some(device) = device() else { return Ok(()) };
    let pendulums = Pendulums::default();
    let asked = || device.ensemble(&pendulums, starts()).parameters(longer).until(2.0005).single_precision();
    let equal = asked().method(RungeKutta4 { step: 1e-3 }).run()?;
    let adaptive = asked().run()?;
    for ends in [equal, adaptive] {
        let distance = distance(|i| ends.state(i).expect("no failure"), accurate);
        assert!(distance < 2e-3 && distance > 1e-9, "{distance:e}");
    }
    Ok(())
}

/// Steps are a few spacings of times long there, and too short from 10⁶ on.
#[test]
fn motions_do_not_depend_on_where_time_is_counted_from() -> Result<(), DeviceError> {
    let Some(device) = device() else { return Ok(()) };
    let pendulums = Pendulums::default();
    let from = |start: f64| {
        let asked =
            || device.ensemble(&pendulums, starts()).from(start).until(start + 2.0).single_precision();
        [asked().method(RungeKutta4 { step: 5e-3 }).run(), asked().tolerance(1e-5).run()]
    };
    for (near, far) in from(0.0).into_iter().zip(from(10_000.0)) {
        let (near, far) = (near?, far?);
        let state = |index| far.state(index).expect("no failure");
        let apart = (0..100).flat_map(|k| near.state(k).expect("no failure").into_iter().zip(state(k)));
        let distance = apart.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(distance < 2e-3, "{distance:e}");
    }
    for refused in from(1e7) {
        let cause = refused?.failures()[0].cause;
        assert!(matches!(cause, StepFailure::StepUnderflow { .. }), "{cause:?}");
    }
    Ok(())
}

#[test]
fn quaternions_keep_their_length() -> Result<(), DeviceError> {
    let Some(device) = device() else { return Ok(()) };
    let tumbler = Tumbler::default();
    let start = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.1, 0.2, 0.3, 4.0, 0.1, 0.2];
    let expected = tumbler.simulate(start).until(3.0).tolerance(1e-13).run().expect("a motion").last();
    for equal_steps in [true, false] {
        let asked = device.ensemble(&tumbler, [start]).until(3.0);
        let asked =
            if equal_steps { asked.method(RungeKutta4 { step: 1e-3 }) } else { asked.tolerance(1e-11) };
        let found = asked.run()?.state(0).expect("no failure");
        let distance = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let length = found[3..7].iter().map(|entry| entry * entry).sum::<f64>();
        assert!(distance < 1e-8 && (length - 1.0).abs() < 1e-15, "{distance:e}, {length}");
    }
    Ok(())
}

/// A failed motion is a row of NaN, and the others continue.
#[test]
fn failures_keep_the_last_good_state() -> Result<(), DeviceError> {
    let Some(device) = device() else { return Ok(()) };
    let falling = Falling::default();
    let starts = || [[1.0, 0.0], [f64::NAN, 0.0], [9.0, 0.0]];
    let equal = device.ensemble(&falling, starts()).until(2.0).method(RungeKutta4 { step: 1e-2 }).run()?;
    let adaptive = device.ensemble(&falling, starts()).until(2.0).run()?;
    for ends in [&equal, &adaptive] {
        let failures = ends.failures();
        assert_eq!(failures.iter().map(|failure| failure.index).collect::<Vec<_>>(), [0, 1], "{failures:?}");
        // It falls for π/√8.
        assert!(failures[0].state[0].is_finite() && (failures[0].time - 1.11).abs() < 0.02, "{failures:?}");
        assert!(failures[1].cause == StepFailure::NotFinite && failures[1].time == 0.0);
        assert!(ends.r()[0].is_nan() && ends.state(0).is_none() && (8.0..9.0).contains(&ends.r()[2]));
        assert!(failures[0].to_string().starts_with("motion 0: "));
    }
    let few = device.ensemble(&falling, [[9.0, 0.0]]).until(2.0).max_steps(3).run()?;
    assert_eq!(few.failures()[0].cause, StepFailure::TooManySteps { limit: 3 });
    Ok(())
}

#[test]
fn settings_without_sense_are_errors() {
    let Some(device) = device() else { return };
    let falling = Falling::default();
    let asked = || device.ensemble(&falling, [[1.0, 0.0]]);
    let wrong = [
        device.ensemble(&falling, [[0.0; 2]; 0]).until(1.0).run(),
        asked().until(f64::NAN).run(),
        asked().until(1.0).method(RungeKutta4 { step: 0.0 }).run(),
        asked().until(1.0).tolerance(-1.0).run(),
        asked().until(1.0).tolerance(1e-8).single_precision().run(),
    ];
    assert!(wrong.iter().all(|result| matches!(result, Err(DeviceError::Setting(_)))), "{wrong:?}");
}
