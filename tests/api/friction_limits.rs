//! Limits of friction that are, or become, negative.

use lagrange::Simulate;
use lagrange::contact::Stepped;
use lagrange::integrate::StepFailure;

lagrange::system! {
    /// A crate on a floor, with a limit of any sign, and a guide pressed from either side.
    #[derive(Clone, Debug)]
    struct Limited;

    param mu = 0.3, own = 0, guide = 0.1, w = 0.1;
    coord x, y, z;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    force y = -10;
    force z = -1;
    event floor = y, falling => impact(0);
    constraint rail = z;
    friction rub = dot(x), own + mu * floor;
    friction held = dot(x), guide * rail;
    friction brush = dot(x), own, smooth: w;
}

#[test]
fn negative_limits_of_friction_are_errors_by_name() {
    let starts = [1.0, -1.0].map(|speed| [0.0, 0.0, 0.0, speed, 0.0, 0.0]);
    for (mu, own, name) in [(-0.3, 0.0, "rub"), (-0.3, -1.0, "rub"), (0.0, -1.0, "rub"), (0.3, -1.0, "brush")]
    {
        let system = Limited { mu, own, ..Limited::default() };
        for start in starts {
            let located = system.simulate(start).until(1.0).run().map(drop).unwrap_err();
            let stepped = system.simulate(start).until(1.0).method(Stepped::every(0.01)).run();
            for refused in [located.cause, stepped.map(drop).unwrap_err().cause] {
                let StepFailure::FrictionLimit { friction, value } = refused else { panic!("{refused}") };
                assert!(friction == name && value < 0.0, "{refused}");
                assert!(refused.to_string().contains("is the magnitude of a force"), "{refused}");
            }
            assert_eq!(located.time(), 0.0);
        }
    }
    for (mu, own, guide) in [(0.3, 0.0, 0.1), (0.3, 0.0, -0.1), (0.0, 0.0, 0.0), (0.2, 1.0, 0.1)] {
        let system = Limited { mu, own, guide, ..Limited::default() };
        for start in starts {
            assert!(system.simulate(start).until(1.0).run().is_ok(), "{mu} {own} {guide}");
            let stepped = system.simulate(start).until(1.0).method(Stepped::every(0.01)).run();
            assert!(stepped.is_ok(), "{mu} {own} {guide}");
        }
    }
}

lagrange::system! {
    /// A block with a friction limit that changes its sign at t = 1.
    #[derive(Clone, Debug)]
    struct Fading;

    param push = 0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = push;
    friction rub = dot(x), 1 - t;
}

#[test]
fn limits_that_turn_negative_between_events_count_by_their_magnitude() {
    // v = v₀ − t + t²/2 until t = 1, and v(1) − (t − 1)²/2 from there on.
    let run = Fading::default().simulate([0.0, 2.0]).until(2.0).tolerance(1e-11).run().expect("no event");
    assert!(run.events().is_empty() && (run.last()[1] - 1.0).abs() < 1e-9, "{:?}", run.last());
    assert!((run.last()[0] - (2.0 - 0.5 + 1.0 / 6.0 + 1.5 - 1.0 / 6.0)).abs() < 1e-9, "{:?}", run.last());
    // It comes to rest where the limit is negative, and the change of mode refuses it by name.
    let error = Fading::default().simulate([0.0, 0.6]).until(3.0).run().expect_err("a negative limit");
    let StepFailure::FrictionLimit { friction, value } = error.cause else { panic!("{error}") };
    let stop = 1.0 + f64::sqrt(0.2);
    assert!(friction == "rub" && (value + f64::sqrt(0.2)).abs() < 1e-6, "{error}");
    assert!((error.time() - stop).abs() < 1e-6, "{error}");
    // A limit that is negative at the start is refused there.
    let error =
        Fading::default().simulate([0.0, 2.0]).from(1.5).until(3.0).run().expect_err("a negative limit");
    assert!(matches!(error.cause, StepFailure::FrictionLimit { .. }) && error.time() == 1.5, "{error}");
}
