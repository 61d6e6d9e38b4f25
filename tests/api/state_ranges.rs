//! Ranges and nominal values of the state: checks of runs, and tolerances of adaptive methods.

use std::ops::Bound;

use lagrange::Simulate;
use lagrange::integrate::{Method, Radau5, Taylor, Verner98, integrate};
use lagrange::system::{OdeSystem, OutOfRange, RangedKind, StepFailure};

lagrange::system! {
    /// A mass on a spring between two bounds, with a heated spring.
    #[derive(Clone, Debug)]
    struct Slider;

    param m: kg = 1, k: N/m = 1;
    coord x: mm in -100..=200 = 50;
    coord free: m;
    state heat: K >= 0 nominal 300 = 1;
    range dot(x) in -5..5 nominal 2;
    kinetic = kinetic_energy(m, dot(x)) + kinetic_energy(m, dot(free));
    potential = spring_energy(k, x);
    dot(heat) = -0.1 [1/s] * heat;
    emit { prepared, jacobian }
    reduce Held { freeze free = 0; }
}

fn outside(slider: &Slider, start: [f64; 5]) -> OutOfRange<f64> {
    let error = slider.simulate(start).until(10.0).run().expect_err("a state out of its range");
    let StepFailure::OutOfRange(outside) = error.cause else { panic!("{error}") };
    assert!(error.to_string().contains(&outside.to_string()), "{error}");
    let prepared = slider.prepared().simulate(start).until(10.0).run().expect_err("the same system");
    assert_eq!(format!("{:?}", prepared.cause), format!("{:?}", StepFailure::OutOfRange(outside)));
    let observed = integrate(slider, 0.0, start, 10.0, &Verner98::tolerance(1e-9), |_, y| {
        assert!(slider.domain().check(y).is_ok(), "{y:?}");
    });
    assert_eq!(format!("{:?}", observed.expect_err("the same").cause), format!("{:?}", error.cause));
    outside
}

#[test]
fn starts_outside_of_their_ranges_are_refused() {
    let slider = Slider::default();
    let (lower, upper) = (Bound::Included(-0.1), Bound::Included(0.2));
    let expected =
        OutOfRange { kind: RangedKind::Coordinate, name: "x", value: 0.3, range: (lower, upper), unit: "m" };
    assert_eq!(outside(&slider, [0.3, 0.0, 1.0, 0.0, 0.0]), expected);
    let heat = outside(&slider, [0.0, 0.0, -1e-6, 0.0, 0.0]).to_string();
    assert_eq!(heat, "the state `heat` is -1e-6 K, but it must be at least 0.0 K");
    let speed = outside(&slider, [0.0, 0.0, 1.0, 5.0, 0.0]).to_string();
    assert_eq!(speed, "the velocity `x_dot` is 5.0 m/s, but it must be at least -5.0 and less than 5.0 m/s");
    assert!(outside(&slider, [f64::NAN, 0.0, 1.0, 0.0, 0.0]).to_string().contains("`x` is NaN"));
}

#[test]
fn motions_end_before_the_step_that_leaves_a_range() {
    let slider = Slider::default();
    let leaving = [0.0, 0.0, 1.0, 0.25, 0.0];
    let found = outside(&slider, leaving);
    assert!(found.name == "x" && found.value.abs() > 0.1, "{found}");
    let error = slider.simulate(leaving).until(10.0).run().expect_err("it leaves");
    // x is sin(t)/4, which is 0.2 at this time.
    let last = *error.trajectory.times().last().expect("a start");
    assert!(last < 0.8_f64.asin() && error.trajectory.x().iter().all(|x| *x <= 0.2), "{last}");
    // At the bounds, but not beyond.
    let within = slider.simulate([0.0, 0.0, 1.0, 0.1, 0.0]).until(40.0).run().expect("stays");
    assert!(within.x().iter().any(|x| *x > 0.0999));
    let start: [f64; 5] = slider.start().into();
    assert_eq!(start, [0.05, 0.0, 1.0, 0.0, 0.0]);
}

#[test]
fn reduced_types_keep_the_ranges_of_the_other_coordinates() {
    let held = Held::from(&Slider::default());
    let error = held.simulate([0.3, 1.0, 0.0]).until(1.0).run().expect_err("outside");
    assert!(error.to_string().contains("`x` is 0.3 m"), "{error}");
    assert_eq!(held.domain().nominal, [1.0, 300.0, 2.0]);
}

lagrange::system! {
    /// A ball that comes to rest on its bound.
    struct Ball<S>;

    param g = 9.81;
    coord y in 0.. = 1;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event floor = y, falling => impact(0.5);
}

#[test]
fn bodies_rest_at_bounds() {
    let ball = Ball::<f64>::default();
    let run = ball.simulate(ball.start()).until(20.0).every(0.5).run().expect("rests");
    assert!(run.y().last().expect("an end").abs() < 1e-12);
    assert!(ball.simulate([-1e-9, 0.0]).until(1.0).run().is_err());
    // A run continues from its end.
    ball.simulate(run.last()).until(1.0).run().expect("rests");
    let single = Ball::<f32>::default();
    single.simulate([1.0, 0.0]).until(20.0).run().expect("rests");
}

lagrange::system! {
    /// Two oscillators of sizes that are twelve orders of magnitude apart.
    #[derive(Clone, Debug)]
    struct Plain;
    coord small, large;
    kinetic = 1/2 * (dot(small)^2 + dot(large)^2);
    potential = 1/2 * (small^2 + 4 * large^2);
    emit { taylor }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Scaled;
    coord small nominal 1e-6, large nominal 1e6;
    kinetic = 1/2 * (dot(small)^2 + dot(large)^2);
    potential = 1/2 * (small^2 + 4 * large^2);
    emit { taylor }
}

const START: [f64; 4] = [1e-6, 1e6, 0.0, 0.0];

/// Returns the error of the small oscillator relative to its amplitude, after some turns.
fn error<M: OdeSystem<Scalar = f64, State = [f64; 4]>>(system: &M, method: &impl Method<M>) -> f64 {
    let end = integrate(system, 0.0, START, 20.0, method, |_, _| ()).expect("swings");
    (end[0] * 1e6 - 20.0_f64.cos()).hypot(end[2] * 1e6 + 20.0_f64.sin())
}

#[test]
fn small_components_are_as_accurate_as_large_ones_if_their_sizes_are_known() {
    let fine = error(&Scaled, &Verner98::tolerance(1e-9));
    assert!(fine < 1e-7, "{fine}");
    let fine = error(&Scaled, &Taylor::tolerance(1e-9));
    assert!(fine < 1e-7, "{fine}");
    let fine = error(&Scaled, &Radau5::tolerance(1e-7));
    assert!(fine < 1e-4, "{fine}");
    // Without the large one, which would choose the steps.
    let slow = [1e-6, 0.0, 0.0, 0.0];
    let ends = [
        integrate(&Plain, 0.0, slow, 200.0, &Verner98::tolerance(1e-6), |_, _| ()).expect("swings"),
        integrate(&Scaled, 0.0, slow, 200.0, &Verner98::tolerance(1e-6), |_, _| ()).expect("swings"),
    ];
    let [plain, scaled] = ends.map(|end| (end[0] * 1e6 - 200.0_f64.cos()).abs());
    assert!(scaled < 1e-3 && plain > 100.0 * scaled, "{plain} {scaled}");
}

#[test]
fn units_of_the_state_do_not_change_the_steps_if_sizes_are_nominal() {
    let scaled = Scaled.simulate(START).until(20.0).tolerance(1e-8).run().expect("swings");
    let plain = Plain.simulate([1.0, 1.0, 0.0, 0.0]).until(20.0).tolerance(1e-8).run().expect("swings");
    assert_eq!(scaled.work().steps, plain.work().steps);
}

/// Returns the rows and the columns of dashes in a plot: points that dashes share.
#[cfg(feature = "plot")]
fn dashes(plot: impl FnOnce(std::path::PathBuf)) -> [std::collections::BTreeMap<String, usize>; 2] {
    let path = std::env::temp_dir().join(format!("lagrange_ranges_{}.svg", std::process::id()));
    plot(path.clone());
    let svg = std::fs::read_to_string(&path).expect("is there");
    std::fs::remove_file(path).expect("was there");
    let mut found = [const { std::collections::BTreeMap::new() }; 2];
    for line in svg.lines().filter(|line| line.contains("stroke-width=\"10\"")) {
        let points = line.split("points=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("points");
        let [from, to] = points.split(' ').filter_map(|point| point.split_once(',')).collect::<Vec<_>>()[..]
        else {
            continue;
        };
        let length = |from: &str, to: &str| {
            to.parse::<i32>().expect("a number") - from.parse::<i32>().expect("a number")
        };
        if length(from.0, to.0) == 60 {
            *found[0].entry(from.1.to_owned()).or_default() += 1;
        } else if length(from.1, to.1) == 60 {
            *found[1].entry(from.0.to_owned()).or_default() += 1;
        }
    }
    found
}

/// x swings by 5 cm in −10 cm … 20 cm. The lower bound is near, the upper one is farther from the
/// motion than its extent, and so are those of the velocity. The heat falls from 1 K to 0.37 K.
#[cfg(feature = "plot")]
#[test]
fn plots_show_bounds_near_the_motion() {
    let run = Slider::default().simulate([0.05, 0.0, 1.0, 0.0, 0.0]).until(10.0).run().expect("stays");
    let [rows, columns] = dashes(|path| run.plot_states(path).expect("plots"));
    assert_eq!((rows.len(), columns.len()), (2, 0), "the lower bounds of x and of the heat: {rows:?}");
    assert!(rows.values().all(|dashes| *dashes > 30), "{rows:?}");
    let [rows, columns] = dashes(|path| run.plot_phase("x", path).expect("plots"));
    assert_eq!((rows.len(), columns.len()), (0, 1), "the lower bound of x: {columns:?}");
    let [rows, columns] = dashes(|path| run.plot_columns(&["free"], path).expect("plots"));
    assert_eq!((rows.len(), columns.len()), (0, 0));
}
