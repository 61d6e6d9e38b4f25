//! Plates that slide on two, three and four rough points: redundant friction that holds is rest.

use lagrange::Simulate;
use lagrange::contact::Friction;
use lagrange::integrate::StepFailure;

/// A plate with friction in x and y, limited by one each, at points (a, b) of it.
macro_rules! plates {
    ($($name:ident($($fx:ident $fy:ident: $a:literal, $b:literal;)*))*) => {
        $(lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name<S>;
            param mu = 1;
            coord x, y, phi;
            kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(phi)^2 / 50);
            $(
                friction $fx = dot(x + $a * cos(phi) - $b * sin(phi)), mu;
                friction $fy = dot(y + $a * sin(phi) + $b * cos(phi)), mu;
            )*
        })*
    };
}

plates! {
    OnTwo(fx0 fy0: 0.2, 0; fx1 fy1: -0.2, 0;)
    OnThree(fx0 fy0: 0.2, 0; fx1 fy1: -0.2, 0.1; fx2 fy2: -0.2, -0.1;)
    OnFour(fx0 fy0: 0.2, 0.15; fx1 fy1: -0.2, 0.15; fx2 fy2: 0.2, -0.15; fx3 fy3: -0.2, -0.15;)
}

const STARTS: [[f64; 6]; 5] = [
    [0.0, 0.0, 0.0, 0.0, 0.0, 5.0],
    [0.0, 0.0, 0.0, 1.0, 0.3, 5.0],
    [0.0, 0.0, 0.3, 1.0, 1.0, 0.0],
    [0.0, 0.0, 0.3, 1.0, 0.0, 0.0],
    [0.0, 0.0, -1.0, -0.7, 0.4, -0.3],
];

/// At rest from `when` on at the latest, in few steps, and for good.
macro_rules! comes_to_rest {
    ($name:ident, $points:literal, $scalar:ty, $tolerances:expr) => {
        for (start, tolerance) in
            STARTS.into_iter().flat_map(|start| $tolerances.map(|tolerance| (start, tolerance)))
        {
            let plate = $name::<$scalar>::default();
            let run =
                plate.simulate(start.map(|entry| entry as $scalar)).until(4.0).every(0.5).max_steps(5_000);
            let run = run.tolerance(tolerance as $scalar).run();
            let run =
                run.unwrap_or_else(|error| panic!("{} {start:?} {tolerance}: {error}", stringify!($name)));
            let states = run.states().collect::<Vec<_>>();
            let [last, before] = [1, 2].map(|back| states[states.len() - back]);
            let speed = last[3..].iter().fold(0.0, |most: $scalar, v| most.max(v.abs()));
            assert!(speed < 1e-6, "{} {start:?}: {last:?}", stringify!($name));
            assert!((0..3).all(|k| (last[k] - before[k]).abs() < 1e-5), "{last:?} {before:?}");
            assert!(run.events().len() < 60, "{} {start:?}: {}", stringify!($name), run.events().len());
            // A slide without turning along an axis: all points decelerate by 1 each.
            if start[4] == 0.0 && start[5] == 0.0 {
                assert!((last[0] - 0.5 / $points).abs() < 1e-4, "{last:?}");
            }
        }
    };
}

#[test]
fn plates_come_to_rest_on_any_number_of_points() {
    comes_to_rest!(OnTwo, 2.0, f64, [1e-4, 1e-8, 1e-11]);
    comes_to_rest!(OnThree, 3.0, f64, [1e-4, 1e-8, 1e-11]);
    comes_to_rest!(OnFour, 4.0, f64, [1e-4, 1e-8, 1e-11]);
}

#[test]
fn plates_come_to_rest_in_single_precision() {
    comes_to_rest!(OnTwo, 2.0, f32, [1e-4, 1e-5]);
    comes_to_rest!(OnThree, 3.0, f32, [1e-4, 1e-5]);
    comes_to_rest!(OnFour, 4.0, f32, [1e-4, 1e-5]);
}

#[test]
fn plates_at_rest_stay() {
    let plate = OnFour::<f64>::default();
    let run = plate.simulate([0.1, 0.2, 0.3, 0.0, 0.0, 0.0]).until(1e3).run().unwrap();
    assert_eq!(run.last()[..3], [0.1, 0.2, 0.3]);
    assert!(run.work().evaluations < 10_000 && run.events().is_empty());
    assert_eq!(run.system_at_end().unwrap().fx0, Friction::Sticks);
}

lagrange::system! {
    /// A crate on a floor, with a limit that may be anything, and a guide that is pressed from
    /// either side.
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
    let start = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0];
    for (mu, own, name) in [(-0.3, 0.0, "rub"), (-0.3, -1.0, "rub"), (0.0, -1.0, "rub"), (0.3, -1.0, "brush")]
    {
        let system = Limited { mu, own, ..Limited::default() };
        let refused = system.simulate(start).until(1.0).run().unwrap_err();
        let StepFailure::FrictionLimit { friction, value } = refused.cause else { panic!("{refused}") };
        assert!(friction == name && value < 0.0, "{refused}");
        assert!(refused.to_string().contains("is the magnitude of a force"), "{refused}");
        assert_eq!(refused.time(), 0.0);
    }
    for (mu, own, guide) in [(0.3, 0.0, 0.1), (0.3, 0.0, -0.1), (0.0, 0.0, 0.0), (0.2, 1.0, 0.1)] {
        let system = Limited { mu, own, guide, ..Limited::default() };
        assert!(system.simulate(start).until(1.0).run().is_ok(), "{mu} {own} {guide}");
    }
}

lagrange::system! {
    /// A block whose friction has a limit that changes its sign at t = 1.
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
    // A limit that is negative from the start is refused there.
    let error =
        Fading::default().simulate([0.0, 2.0]).from(1.5).until(3.0).run().expect_err("a negative limit");
    assert!(matches!(error.cause, StepFailure::FrictionLimit { .. }) && error.time() == 1.5, "{error}");
}
