//! Plates that slide on two, three and four rough points: static redundant friction means rest.

use lagrange::Simulate;
use lagrange::contact::Friction;

/// Declares a plate with friction in x and y, with separate limits, at points (a, b).
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

/// Checks rest from `when` on at the latest, after few steps, and permanently.
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
            // Sliding along an axis without rotation: all points decelerate by 1 each.
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
