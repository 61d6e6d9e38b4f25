//! Modes as motions, against closed forms and motions of the nonlinear system.

use lagrange::Simulate;
use lagrange::constraint::ConstrainedSystem;
use lagrange::linear::{Linearise, ModeMotionError};

use super::constrained::{Garland, Rod, Skate};
use super::equilibria::{DoublePendulum, Magnet};
use super::modes::Oscillator;

lagrange::system! {
    /// A freely rotating body with three moments of inertia.
    #[derive(Debug)]
    struct Satellite;

    gravity = (0, 0, 0);
    body satellite { mass: 1; inertia: (1, 2, 3); }
    ball turn = ground to satellite;
    emit { system_matrix }
}

/// Compares small deviations in all modes with motions of the nonlinear system from the first
/// moment. They differ by squares of the amplitude.
macro_rules! follows {
    ($system:expr, $state:expr) => {{
        let (system, state) = ($system, $state);
        let modes = system.linearise(0.0, state).expect("smooth").modes().expect("eigenvalues");
        for mode in modes.modes() {
            let moments =
                system.mode_motion(0.0, state, mode, 1e-6).periods(1.0).moments(20.0).expect("is shown");
            let (_, (_, start)) = moments[0];
            let (passed, (_, end)) = *moments.last().expect("moments");
            let run = system
                .simulate(start)
                .until(passed)
                .tolerance(1e-13)
                .ends_only()
                .run()
                .expect("moves")
                .last();
            for (shown, moved) in end.iter().zip(&run) {
                assert!((shown - moved).abs() < 3e-10, "{mode:?}: {end:?}, {run:?}");
            }
            let moved = end.iter().zip(&start).any(|(end, start)| (end - start).abs() > 1e-7);
            assert!(moved || mode.imaginary > 0.0, "{mode:?}");
        }
    }};
}

#[test]
fn small_modes_are_motions_of_the_nonlinear_system() {
    let pendulum = DoublePendulum::<f64>::default();
    follows!(&pendulum, pendulum.equilibrium([0.1, 0.1, 0.0, 0.0]).solve().expect("hangs").state);
    // Including unstable modes, which grow.
    follows!(&pendulum, pendulum.equilibrium([3.1, 3.1, 0.0, 0.0]).solve().expect("stands").state);
    let magnet = Magnet::default();
    follows!(&magnet, magnet.equilibrium([0.0; 3]).solve().expect("hangs").state);
}

#[test]
fn dependent_coordinates_follow_from_constraints() {
    let (rod, garland) = (Rod::<f64>::default(), Garland::default());
    follows!(&rod, rod.equilibrium([0.3, -0.5, 0.0, 0.0]).solve().expect("hangs").state);
    let near = [0.5, 1.5, -0.8, -0.8, 0.0, 0.0, 0.0, 0.0];
    let hanging = garland.equilibrium(near).solve().expect("hangs").state;
    follows!(&garland, hanging);

    // Including states far from the equilibrium.
    let modes = garland.linearise(0.0, hanging).expect("smooth").modes().expect("eigenvalues");
    for (_, y) in garland.mode_motion(0.0, hanging, &modes.modes()[0], 0.3).extremes().expect("is shown") {
        let q = [y[0], y[1], y[2], y[3]];
        assert!(garland.position_residuals(0.0, &q).iter().all(|residual| residual.abs() < 1e-12), "{y:?}");
        assert!((y[0] - hanging[0]).abs() > 0.1, "{y:?}");
    }
}

#[test]
fn decay_begins_with_the_amplitude_and_growth_ends_with_it() {
    let damped = Oscillator { k: 4.0, c: 0.4 };
    let modes = damped.linearise(0.0, [0.0; 2]).expect("smooth").modes().expect("eigenvalues");
    let (decay, frequency) = (0.2, (4.0_f64 - 0.04).sqrt());
    for (t, (_, [x, v])) in
        damped.mode_motion(0.0, [0.0; 2], &modes.modes()[0], 2.0).moments(10.0).expect("is shown")
    {
        let (sine, cosine) = (frequency * t).sin_cos();
        let part = 2.0 * (-decay * t).exp();
        assert!((x - part * cosine).abs() < 1e-13, "{t}");
        assert!((v + part * (decay * cosine + frequency * sine)).abs() < 1e-13, "{t}");
    }

    let falling = Oscillator { k: -4.0, c: 0.0 };
    let modes = falling.linearise(0.0, [0.0; 2]).expect("smooth").modes().expect("eigenvalues");
    let growing = modes.modes().iter().find(|mode| mode.real > 0.0).expect("it falls");
    let moments =
        falling.mode_motion(0.0, [0.0; 2], growing, 0.5).slowed(3.0).moments(8.0).expect("is shown");
    // Three times 1/λ, and three times as slow.
    let (second, (time, [x, v])) = *moments.last().expect("moments");
    assert!((second - 4.5).abs() < 1e-14 && time == 0.0 && moments.len() == 37, "{moments:?}");
    assert!((x - 0.5).abs() < 1e-14 && (v - 1.0).abs() < 1e-13, "{x} {v}");
    assert!((moments[0].1.1[0] - 0.5 * (-3.0_f64).exp()).abs() < 1e-14);
}

#[test]
fn level_modes_repeat_without_a_jump() {
    let damped = Oscillator { k: 4.0, c: 0.4 };
    let modes = damped.linearise(0.0, [0.0; 2]).expect("smooth").modes().expect("eigenvalues");
    let shown = damped.mode_motion(0.0, [1.0, 0.0], &modes.modes()[0], 0.5).level().periods(1.0);
    let moments = shown.moments(20.0).expect("is shown");
    let step = moments[1].0;
    let period = moments.len() as f64 * step;
    assert!((period - std::f64::consts::TAU / modes.modes()[0].imaginary).abs() < 1e-13);
    assert!(
        moments.iter().all(|(t, (_, [x, _]))| (x - 1.0 - 0.5 * (std::f64::consts::TAU * t / period).cos())
            .abs()
            < 1e-13)
    );
    let [(_, [more, _]), (_, [less, _])] = shown.extremes().expect("is shown");
    assert!((more - 1.5).abs() < 1e-15 && (less - 0.5).abs() < 1e-15);
}

#[test]
fn steady_motions_go_along_on_demand() {
    // It rotates about the axis of the largest moment of inertia.
    let state = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0];
    let modes = Satellite.linearise(0.0, state).expect("smooth").modes().expect("eigenvalues");
    let wobble = modes.modes().iter().find(|mode| mode.imaginary > 0.5).expect("it wobbles");
    let along = Satellite.mode_motion(0.0, state, wobble, 1e-4).along().moments(50.0).expect("is shown");
    let (_, (_, start)) = along[0];
    let (passed, (time, end)) = *along.last().expect("moments");
    assert_eq!(time, passed);
    let run =
        Satellite.simulate(start).until(passed).tolerance(1e-13).ends_only().run().expect("turns").last();
    for (shown, moved) in end.iter().zip(&run) {
        assert!((shown - moved).abs() < 3e-6, "{end:?} {run:?}");
    }
    // Otherwise the mean orientation is constant.
    let still = Satellite.mode_motion(0.0, state, wobble, 1e-4).moments(50.0).expect("is shown");
    assert!(still.iter().all(|(_, (time, y))| *time == 0.0 && (y[0] - 1.0).abs() < 1e-8));
}

#[test]
fn single_precision_is_shown_too() {
    let rod = Rod::<f32>::default();
    let hanging = [0.0, -0.7, 0.0, 0.0];
    let modes = rod.linearise(0.0, hanging).expect("smooth").modes().expect("eigenvalues");
    let [(_, right), (_, left)] =
        rod.mode_motion(0.0, hanging, &modes.modes()[0], 0.2).extremes().expect("is shown");
    assert!((right[0] + left[0]).abs() < 1e-6 && right[0] > 0.19, "{right:?} {left:?}");
    assert!((right[0].hypot(right[1]) - 0.7).abs() < 1e-6);
}

#[test]
fn modes_that_cannot_be_shown_are_refused() {
    let skate = Skate::default();
    let modes = skate.linearise(0.0, [0.0; 6]).expect("smooth").modes().expect("eigenvalues");
    let slide = skate.mode_motion(0.0, [0.0; 6], &modes.modes()[0], 1.0);
    let error = slide.moments(25.0).expect_err("nothing moves");
    assert_eq!(
        error.to_string(),
        "the eigenvalue of the mode is zero up to rounding: nothing moves; its `extremes` can be shown"
    );
    assert!(slide.extremes().is_ok());

    let oscillator = Oscillator::default();
    let shown = |amplitude| oscillator.mode_motion(0.0, [0.0; 2], &modes.modes()[0], amplitude);
    let error = shown(1.0).moments(25.0).expect_err("another system");
    assert_eq!(error, ModeMotionError::OtherSystem { of_mode: 6, of_system: 2 });
    assert_eq!(
        error.to_string(),
        "the mode has 6 components and the system 2: it is the mode of another system"
    );

    let modes = oscillator.linearise(0.0, [0.0; 2]).expect("smooth").modes().expect("eigenvalues");
    let shown = |amplitude| oscillator.mode_motion(0.0, [0.0; 2], &modes.modes()[0], amplitude);
    for (what, result) in [
        ("amplitude NaN", shown(f64::NAN).moments(25.0)),
        ("amplitude inf", shown(f64::INFINITY).moments(25.0)),
        ("moments a second 0.0", shown(1.0).moments(0.0)),
        ("periods -1.0", shown(1.0).periods(-1.0).moments(25.0)),
        ("factor inf", shown(1.0).slowed(f64::INFINITY).moments(25.0)),
    ] {
        let message = result.expect_err("is refused").to_string();
        assert_eq!(message, format!("a mode cannot be shown with the {what}"));
    }
    let error = shown(1.0).periods(1e6).moments(25.0).expect_err("is too long");
    assert!(error.to_string().starts_with("the film would have 7"), "{error}");
    assert!(shown(0.0).moments(25.0).expect("is shown").iter().all(|(_, (_, y))| *y == [0.0; 2]));
}
