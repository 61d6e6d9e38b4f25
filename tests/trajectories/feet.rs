//! Plates on several feet, seen from above, beside references with regularised friction.
//!
//! `LAGRANGE_PLATES=1000 cargo motions --test cone` takes this many starts instead of a few.

use lagrange::Simulate;

use crate::{Random, assert_near};

/// Declares a plate on feet at these positions, seen from above.
macro_rules! plate {
    ($name:ident, $count:literal, $x:tt, $y:tt) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;

            const feet_x[$count] = $x, feet_y[$count] = $y;
            coord x, y, phi;
            kinetic = 1/2 * (dot(x)^2 + dot(y)^2) + 0.01 * dot(phi)^2;
            for i in 0..$count {
                let foot[i] = (x + feet_x[i] * cos(phi) - feet_y[i] * sin(phi),
                    y + feet_x[i] * sin(phi) + feet_y[i] * cos(phi));
                friction rub[i] = dot(foot[i]), 1;
            }
        }
    };
}

plate!(Plate3, 3, [0.2, -0.2, -0.2], [0, 0.1, -0.1]);
plate!(Plate4, 4, [0.2, -0.2, 0.2, -0.2], [0.15, 0.15, -0.15, -0.15]);
plate!(Plate5, 5, [0.2, -0.2, 0.2, -0.2, 0], [0.15, 0.15, -0.15, -0.15, 0]);

/// Number of starts by default.
const USUAL: u64 = 12;
/// Speeds over which the friction of the reference is regularised, and its step.
const ROUNDED: [f64; 2] = [1e-4, 5e-5];
const STEP: f64 = 4e-6;

/// `tools/plates.py` integrates the same motions with regularised friction.
#[test]
fn plates_come_to_rest_where_a_regularised_reference_does() {
    const STARTS: [[f64; 6]; 3] =
        [[0.0, 0.0, 0.0, 0.0, 0.0, 5.0], [0.0, 0.0, 0.0, 1.0, 0.3, 5.0], [0.0, 0.0, 0.3, 1.0, 1.0, 0.0]];
    macro_rules! end {
        ($plate:expr, $start:expr) => {
            $plate.simulate($start).until(1.0).tolerance(1e-11).run().expect("comes to rest").last()
        };
    }
    let mut rows = 0;
    for line in include_str!("plates.csv").lines().skip(1) {
        let values: Vec<f64> = line.split(',').map(|value| value.parse().expect("a number")).collect();
        let start = STARTS[values[1] as usize];
        let end = match values[0] as usize {
            3 => end!(Plate3::default(), start),
            4 => end!(Plate4::default(), start),
            _ => end!(Plate5::default(), start),
        };
        assert_near([end[0], end[1], end[2]], [values[2], values[3], values[4]], 1e-8);
        assert!(end[3..].iter().all(|v| v.abs() < 1e-12), "{end:?}");
        rows += 1;
    }
    assert_eq!(rows, 9);
}

/// Returns the rates of a plate of mass 1 and moment of inertia 0.02 whose feet have the friction
/// −s/√(|s|² + w²).
fn rates(feet: &[[f64; 2]], [_, _, phi, vx, vy, omega]: [f64; 6], w: f64) -> [f64; 6] {
    let (sin, cos) = phi.sin_cos();
    let mut force = [0.0; 3];
    for [a, b] in feet {
        let [x, y] = [a * cos - b * sin, a * sin + b * cos];
        let [sx, sy] = [vx - omega * y, vy + omega * x];
        let size = (sx * sx + sy * sy + w * w).sqrt();
        let [fx, fy] = [-sx / size, -sy / size];
        force = [force[0] + fx, force[1] + fy, force[2] + x * fy - y * fx];
    }
    [vx, vy, omega, force[0], force[1], force[2] / 0.02]
}

/// Returns where a plate comes to rest with regularised friction, by the classical method of Runge
/// and Kutta. Its steps are shorter than the time in which slow feet creep to a stop.
fn regularised(feet: &[[f64; 2]], mut y: [f64; 6], w: f64) -> [f64; 3] {
    let step = STEP * w / ROUNDED[1];
    let moved = |y: &[f64; 6], h: f64, rates: &[f64; 6]| std::array::from_fn(|i| y[i] + h * rates[i]);
    while y[3..].iter().any(|speed| speed.abs() > 1e-3 * w) {
        let first = rates(feet, y, w);
        let second = rates(feet, moved(&y, 0.5 * step, &first), w);
        let third = rates(feet, moved(&y, 0.5 * step, &second), w);
        let fourth = rates(feet, moved(&y, step, &third), w);
        let mean = std::array::from_fn(|i| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0);
        y = moved(&y, step, &mean);
    }
    [y[0], y[1], y[2]]
}

/// The error of the reference is proportional to the speed of regularisation, and removed by
/// extrapolation.
#[test]
fn plates_from_random_starts_come_to_rest_where_a_regularised_reference_does() {
    let count = std::env::var("LAGRANGE_PLATES").ok();
    let count = count.map_or(USUAL, |count| count.parse().expect("LAGRANGE_PLATES is a whole number"));
    let mut random = Random(3);
    let mut worst = [0.0_f64; 3];
    for case in 0..count {
        let mut within = |size: f64| random.within(-size, size);
        let start = [within(1.0), within(1.0), within(3.0), within(1.5), within(1.5), within(8.0)];
        macro_rules! error {
            ($plate:expr, $x:expr, $y:expr) => {{
                let run = $plate.simulate(start).until(3.0).tolerance(1e-10).run();
                let run = run.unwrap_or_else(|error| panic!("{case}: {error}"));
                let (end, feet) =
                    (run.last(), $x.into_iter().zip($y).map(|(x, y)| [x, y]).collect::<Vec<_>>());
                assert!(end[3..].iter().all(|v| v.abs() < 1e-12), "{case}: {end:?}");
                let [coarse, fine] = ROUNDED.map(|w| regularised(&feet, start, w));
                let error = |i: usize| (end[i] - (2.0 * fine[i] - coarse[i])).abs();
                error(0).max(error(1)).max(0.25 * error(2))
            }};
        }
        let errors = [
            error!(Plate3::default(), [0.2, -0.2, -0.2], [0.0, 0.1, -0.1]),
            error!(Plate4::default(), [0.2, -0.2, 0.2, -0.2], [0.15, 0.15, -0.15, -0.15]),
            error!(Plate5::default(), [0.2, -0.2, 0.2, -0.2, 0.0], [0.15, 0.15, -0.15, -0.15, 0.0]),
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error);
        }
        assert!(errors.iter().all(|error| *error < 1e-5), "{case}: {start:?} {errors:?}");
    }
    println!("{count} plates on 3, 4 and 5 feet: the errors are at most {worst:?} m");
}
