//! Constants of declarations and times of events to thirty digits.

use lagrange::Simulate;
use lagrange::integrate::Taylor;
use lagrange_double::Double;
use lagrange_runtime::Number;

lagrange::system! {
    struct Constants<S>;

    param third = 1/3, weight = 9.81, tau = 2 * pi;
    coord x;
    start x = 1/10;
    kinetic = 1/2 * dot(x)^2;
    potential = 0.1 * x^2;
    output tenth = 1/10;
    output circle = 2 * pi / 3;
    output root = -sqrt(2) / 7;
    output far = third * 1e300;
    output part = 3 * x / 7 + 0 * (weight + tau);
}

fn read(text: &str) -> Double {
    text.parse().expect("a number")
}

#[track_caller]
fn assert_wide(found: Double, wanted: &str) {
    let error = ((found - read(wanted)) / found).abs();
    assert!(error < read("1e-31"), "{found} instead of {wanted}");
}

/// Digits from tables; they are not computed here.
#[test]
fn constants_have_all_digits() {
    let system = Constants::<Double>::default();
    assert_wide(system.third, "0.33333333333333333333333333333333333");
    assert_wide(system.weight, "9.81");
    assert_wide(system.tau, "6.2831853071795864769252867665590058");
    let (q, v) = ([Double::ONE], [Double::ZERO]);
    assert_wide(system.tenth(Double::ZERO, &q, &v), "0.1");
    assert_wide(system.circle(Double::ZERO, &q, &v), "2.0943951023931954923084289221863353");
    assert_wide(system.root(Double::ZERO, &q, &v), "-0.20203050891044214982881267488709972");
    assert_wide(system.far(Double::ZERO, &q, &v), "3.3333333333333333333333333333333333e299");
    assert_wide(system.part(Double::ZERO, &q, &v), "0.42857142857142857142857142857142857");
    assert_wide(system.acceleration(Double::ZERO, &q, &v)[0], "-0.2");
}

/// Other numbers have the constants that they had without remainders.
#[test]
fn narrower_numbers_have_the_nearest_constants() {
    let (double, single) = (Constants::<f64>::default(), Constants::<f32>::default());
    assert_eq!([double.third, double.weight, double.tau], [1.0 / 3.0, 9.81, core::f64::consts::TAU]);
    assert_eq!([single.third, single.weight, single.tau], [1.0 / 3.0, 9.81, core::f32::consts::TAU]);
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Oscillator<S>;

    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = 1/2 * y^2;
    event half = y - 1/2, falling => record;
    emit { taylor }
}

#[test]
fn events_are_located_to_thirty_digits() {
    let start = [Double::ONE, Double::ZERO];
    let method = Taylor::tolerance(read("1e-29"));
    let run = Oscillator::default().simulate(start).until(Double::from(8.0)).method(method).run();
    let times = run.expect("runs").events().iter().map(|event| event.time).collect::<Vec<_>>();
    let [first, second] = times[..] else { panic!("{times:?}") };
    // π/3, and a period later.
    assert!((first - read("1.0471975511965977461542144610931676")).abs() < read("1e-27"), "{first}");
    assert!((second - read("7.3303828583761842230795012276521734")).abs() < read("1e-27"), "{second}");
}
